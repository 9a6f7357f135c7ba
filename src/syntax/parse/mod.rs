//! Text to a tree, every mistake on the way reported once.
//!
//! Owns the order of the steps: caps and lexical mistakes first, brackets, then the grammar. The grammar
//! stops at its first mistake, so the entry that holds it is blanked (bytes keep their places) and the
//! text is read again.

mod brackets;
mod build;
mod explain;
mod expression;
mod recover;
mod version;

use super::code::Code;
use super::diagnostic::Diagnostic;
use super::encoding::{line_ends, text_of};
use super::scan::{Token, TokenKind, scan};
use super::tree::{ExprId, Source, Span, SyntaxTree};
use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};
use pest::iterators::Pairs;

/// Largest file, bytes.
pub const MAX_FILE_BYTES: usize = 1_000_000;
/// Deepest nesting of brackets.
pub const MAX_NESTING: usize = 128;
/// Greatest height of an expression.
pub const MAX_EXPRESSION_DEPTH: u32 = 500;
/// How many mistakes of a file are reported.
const MAX_MISTAKES: usize = 50;
/// How many bytes are read again in all to find further mistakes.
const MAX_BYTES_READ_AGAIN: usize = 16 * MAX_FILE_BYTES;

/// The generated recogniser. In a module of its own: the derived `Rule` has no documentation.
#[allow(missing_docs)]
mod grammar {
    #[derive(pest_derive::Parser)]
    #[grammar = "grammar/tissue.pest"]
    pub(super) struct Grammar;
}

use grammar::{Grammar, Rule};

/// Reads a file.
///
/// Returns the tree of all that could be read, and every mistake found, in the order of the text. An entry
/// with a mistake is left out of the tree. Never panics, whatever the text.
pub fn parse(source: &Source) -> (SyntaxTree, Vec<Diagnostic>) {
    let text = &*line_ends(&source.text);
    let end = text.len();
    if end > MAX_FILE_BYTES {
        let message = format!("a file holds at most {MAX_FILE_BYTES} bytes, this one has {end}");
        let mistake = Diagnostic { code: Code::FileTooLarge, message, labels: vec![], help: None };
        return (SyntaxTree::default(), vec![mistake]);
    }
    let mut reading = Reading::new(text);
    if let Some(mistake) = brackets::too_deep(text, &reading.tokens) {
        reading.mistakes.push(mistake);
        return (SyntaxTree::default(), reading.finish());
    }
    let version = match version::read(text, &reading.tokens) {
        Ok(version) => Some(version),
        Err(mistake) => {
            let stop = mistake.code == Code::WrongVersion;
            reading.mistakes.push(mistake);
            if stop {
                return (SyntaxTree::default(), reading.finish());
            }
            None
        }
    };
    for (mistake, span) in brackets::unbalanced(text, &reading.tokens) {
        reading.mistakes.push(mistake);
        reading.blank(&span);
    }
    let mut tree = reading.read_all();
    tree.version = version;
    (tree, reading.finish())
}

/// Reads a single expression: the value of an option such as `--set strip.spacing=0.25mm`.
///
/// # Errors
/// Every mistake found in the text.
pub fn parse_expression(source: &Source) -> Result<(SyntaxTree, ExprId), Vec<Diagnostic>> {
    // As the only entry of a block, so that mistakes are told as in a file.
    const BEFORE: &str = "tissue 1\nb{v=";
    let wrapped = Source { name: source.name.clone(), text: format!("{BEFORE}{}\n}}", source.text) };
    let (mut tree, mut mistakes) = parse(&wrapped);
    let inside = |span: &Span| {
        let shift = |at: usize| at.saturating_sub(BEFORE.len()).min(source.text.len());
        shift(span.start)..shift(span.end)
    };
    for mistake in &mut mistakes {
        if mistake.labels.first().is_some_and(|label| label.span.start >= wrapped.text.len() - 1) {
            // The brace that closes the block is not the user's.
            mistake.message = mistake.message.replace("found `}`", "found its end");
        }
        let of_block = mistake.code == Code::UnclosedBracket
            && mistake.labels.first().is_some_and(|label| label.span.start < BEFORE.len());
        if of_block || mistake.code == Code::ExpectedEntry {
            // Nor is the block: what would close it or be its next entry is too much.
            let found = mistake.labels.last().map_or(0..0, |label| label.span.clone());
            *mistake =
                Diagnostic::new(Code::UnexpectedToken, "one value is required", found, "more than a value");
        }
        mistake.labels.iter_mut().for_each(|label| label.span = inside(&label.span));
    }
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    let value = build::only_value(&tree).ok_or_else(|| {
        let whole = 0..source.text.len();
        vec![Diagnostic::new(Code::UnexpectedToken, "one value is required", whole, "more than a value")]
    })?;
    tree.expressions.iter_mut().for_each(|e| expression::shift_spans(e, &inside));
    tree.items.clear();
    Ok((tree, value))
}

/// Turns bytes into a source: UTF-8, or UTF-16 with its byte order mark.
///
/// # Errors
/// A diagnostic if the bytes are neither.
pub fn decode(name: &str, bytes: Vec<u8>) -> Result<Source, Diagnostic> {
    match text_of(bytes) {
        Ok(text) => Ok(Source { name: name.into(), text }),
        Err(cause) => Err(Diagnostic {
            code: Code::NotUtf8,
            message: format!("`{name}` {cause}"),
            labels: vec![],
            help: None,
        }),
    }
}

/// A text being read.
struct Reading<'a> {
    /// The text as given.
    text: &'a str,
    /// The same with what cannot be read blanked.
    work: Vec<u8>,
    /// Its tokens without comments, blanked ones left out.
    tokens: Vec<Token>,
    /// Comments, for documentation.
    comments: Vec<Token>,
    mistakes: Vec<Diagnostic>,
}

impl<'a> Reading<'a> {
    fn new(text: &'a str) -> Self {
        let scanned = scan(text);
        let (comments, tokens) = scanned.tokens.into_iter().partition(|t| t.kind == TokenKind::Comment);
        let mut reading =
            Self { text, work: text.as_bytes().to_vec(), tokens, comments, mistakes: scanned.mistakes };
        for span in scanned.blanked {
            reading.blank_bytes(&span);
        }
        // So that the rest of the entry is read: a text in quotes as long as what was written, or a number.
        for span in scanned.unclosed {
            reading.blank_bytes(&span);
            let quote = if span.len() > 1 { b'"' } else { b'0' };
            reading.work[span.start] = quote;
            reading.work[span.end - 1] = quote;
        }
        reading
    }

    fn blank_bytes(&mut self, span: &Span) {
        for byte in &mut self.work[span.clone()] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
    }

    /// Makes a range unread: whole characters become blanks of the same number of bytes.
    fn blank(&mut self, span: &Span) {
        self.blank_bytes(span);
        self.tokens.retain(|t| t.span.end <= span.start || t.span.start >= span.end);
    }

    fn read_all(&mut self) -> SyntaxTree {
        let mut budget = MAX_BYTES_READ_AGAIN;
        loop {
            // Only whole characters were replaced, and by ASCII.
            let work = String::from_utf8_lossy(&self.work).into_owned();
            match recognise(&work) {
                Ok(pairs) => {
                    let mut builder = build::Builder::new(&work, self.text, &self.comments, self.unread());
                    let tree = builder.file(pairs);
                    self.mistakes.append(&mut builder.mistakes);
                    return tree;
                }
                Err(failure) => {
                    let span = recover::entry_around(self.text, &self.tokens, failure.at);
                    // Where characters were left out, the rest need not make sense.
                    if !self.has_lexical_mistake(&span, failure.at) {
                        self.mistakes.push(explain::explain(self.text, &self.tokens, &failure));
                    }
                    self.blank(&span);
                    budget = budget.saturating_sub(work.len());
                    if self.mistakes.len() >= MAX_MISTAKES || budget == 0 {
                        return SyntaxTree::default();
                    }
                }
            }
        }
    }

    /// Where characters that mean nothing were left out, in order; a needless `;` changes no value.
    fn unread(&self) -> Vec<usize> {
        let unknown = self.mistakes.iter().filter(|m| m.code == Code::UnknownCharacter);
        let starts = unknown.flat_map(|m| &m.labels).map(|l| l.span.start);
        let mut starts: Vec<usize> = starts.filter(|at| !self.text[*at..].starts_with(';')).collect();
        starts.sort_unstable();
        starts
    }

    fn has_lexical_mistake(&self, entry: &Span, failure: usize) -> bool {
        let lexical = |m: &&Diagnostic| matches!(m.code, Code::UnknownCharacter | Code::UnclosedText);
        let labels = self.mistakes.iter().filter(lexical).flat_map(|m| &m.labels);
        let end = entry.end.max(failure);
        labels.into_iter().any(|l| (entry.start..end).contains(&l.span.start))
    }

    fn finish(mut self) -> Vec<Diagnostic> {
        self.mistakes.sort_by_key(|m| m.labels.first().map_or(0, |l| l.span.start));
        if self.mistakes.len() >= MAX_MISTAKES {
            self.mistakes.truncate(MAX_MISTAKES);
            let after = self.mistakes.last().and_then(|m| m.labels.first()).map_or(0..0, |l| l.span.clone());
            let message = format!("{MAX_MISTAKES} mistakes are reported, what follows is left unread");
            self.mistakes.push(Diagnostic::new(
                Code::TooManyMistakes,
                message,
                after,
                "the last one reported",
            ));
        }
        self.mistakes
    }
}

/// Where the grammar could not go on, and what it would have taken there.
struct Failure {
    at: usize,
    expected: Vec<Rule>,
}

fn recognise(work: &str) -> Result<Pairs<'_, Rule>, Failure> {
    Grammar::parse(Rule::file, work).map_err(|error| {
        let at = match error.location {
            InputLocation::Pos(at) => at,
            InputLocation::Span((at, _)) => at,
        };
        let expected = match error.variant {
            ErrorVariant::ParsingError { positives, .. } => positives,
            ErrorVariant::CustomError { .. } => Vec::new(),
        };
        Failure { at, expected }
    })
}

#[cfg(test)]
mod grammar_examples;
#[cfg(test)]
mod mistakes;
#[cfg(test)]
mod tests;
