//! What a mistake looks like: message, marked spans, help.
//!
//! Owns the drawing as text and as JSON. Knows no terminal, no colour and no file.

use super::code::Code;
use super::encoding::line_ends;
use super::position::Lines;
use super::tree::{Source, Span};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use serde_json::{Value, json};

/// A marked place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The bytes marked.
    pub span: Span,
    /// What stands beside the mark; may be empty.
    pub text: String,
}

impl Label {
    /// A label.
    pub fn new(span: Span, text: impl Into<String>) -> Self {
        Self { span, text: text.into() }
    }
}

/// A mistake: what was found, what is required, and what to write instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its stable code.
    pub code: Code,
    /// Lower case, no final stop, found and required.
    pub message: String,
    /// Marked places; the first is where the mistake is, further ones are what it relates to.
    pub labels: Vec<Label>,
    /// Text to paste, or what to do; without it the code's own help is told.
    pub help: Option<String>,
}

impl Diagnostic {
    /// A mistake at one place.
    pub fn new(code: Code, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Self { code, message: message.into(), labels: vec![Label::new(span, label)], help: None }
    }

    /// The same with a help.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with a further marked place.
    #[must_use]
    pub fn with_label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label::new(span, text));
        self
    }

    /// What to write instead: its own help, or its code's.
    pub fn advice(&self) -> &str {
        self.help.as_deref().unwrap_or_else(|| self.code.help())
    }

    /// Draws the mistake without colour, with the lines it marks; columns count characters from 1.
    ///
    /// A span that leaves the text or splits a character is clipped; one over several lines is marked
    /// on its first. A diagnostic without labels is its message and help.
    pub fn render(&self, source: &Source) -> String {
        let mut title = Group::with_title(Level::ERROR.primary_title(&*self.message).id(self.code.number()));
        let lines = Lines::new(&source.text);
        let spans: Vec<Span> = self.labels.iter().map(|l| lines.clip_to_line(&l.span)).collect();
        if let (Some(first), Some(last)) =
            (spans.iter().map(|s| s.start).min(), spans.iter().map(|s| s.start).max())
        {
            // Only the lines from the first mark to the last are handed over: drawing costs what they cost.
            let (top, bottom) = (lines.line_of(first), lines.line_of(last));
            let (start, end) = (lines.line_span(top).start, lines.line_span(bottom).end);
            let annotations = spans.iter().zip(&self.labels).enumerate().map(|(i, (span, label))| {
                let kind = if i == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
                let text = (!label.text.is_empty()).then_some(&*label.text);
                kind.span(span.start - start..span.end - start).label(text)
            });
            title = title.element(
                Snippet::source(line_ends(&source.text[start..end]))
                    .line_start(top + 1)
                    .path(&*source.name)
                    .annotations(annotations),
            );
        }
        let drawn = Renderer::plain().render(&[title]);
        let mut drawn: String = drawn.lines().flat_map(|line| [line.trim_end(), "\n"]).collect();
        drawn.push_str("help: ");
        drawn.push_str(self.advice());
        drawn.push('\n');
        drawn
    }

    /// The mistake for an editor: code, message, help, and labels with byte spans and positions.
    ///
    /// Lines and columns count from 1, columns in characters.
    pub fn to_json(&self, source: &Source) -> Value {
        let lines = Lines::new(&source.text);
        let labels: Vec<Value> = self
            .labels
            .iter()
            .map(|label| {
                let span = lines.clip(&label.span);
                let position = |at| {
                    let (line, column) = lines.position(at);
                    json!({ "line": line, "column": column })
                };
                json!({
                    "text": label.text,
                    "bytes": [span.start, span.end],
                    "start": position(span.start),
                    "end": position(span.end),
                })
            })
            .collect();
        json!({
            "severity": "error",
            "code": self.code.number(),
            "title": self.code.title(),
            "message": self.message,
            "file": source.name,
            "labels": labels,
            "help": self.advice(),
        })
    }
}

#[cfg(test)]
mod tests;
