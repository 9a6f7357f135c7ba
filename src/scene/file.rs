//! A parsed file and the list of mistakes.
//!
//! Owns the place of a span and the collecting of mistakes from several files.

use super::model::Place;
use crate::syntax::{Code, Diagnostic, ExprId, Lines, Source, Span, SyntaxTree};
use std::rc::Rc;
use std::sync::Arc;

/// A parsed file.
#[derive(Debug)]
pub(super) struct File {
    pub(super) source: Arc<Source>,
    pub(super) tree: SyntaxTree,
    /// Whether the text itself had mistakes; names may then be missing through no fault of their user.
    pub(super) damaged: bool,
}

impl File {
    /// The text of a span.
    pub(super) fn text(&self, span: &Span) -> &str {
        self.source.text.get(span.clone()).unwrap_or("")
    }

    /// The text of an expression.
    pub(super) fn expression(&self, id: ExprId) -> &str {
        self.text(&self.tree.expr(id).span)
    }

    /// Where an expression stands.
    pub(super) fn span(&self, id: ExprId) -> Span {
        self.tree.expr(id).span.clone()
    }

    /// Line and column of a span.
    pub(super) fn place(&self, span: &Span) -> Place {
        let (line, column) = Lines::new(&self.source.text).position(span.start);
        Place { file: self.source.name.clone(), line: line as u32, column: column as u32 }
    }
}

/// A mistake and the file it lies in.
#[derive(Debug, Clone, PartialEq)]
pub struct Mistake {
    /// The file.
    pub source: Arc<Source>,
    /// The mistake.
    pub diagnostic: Diagnostic,
}

impl Mistake {
    /// Draws the mistake with the lines it marks.
    pub fn render(&self) -> String {
        self.diagnostic.render(&self.source)
    }
}

/// A mistake has been reported; there is no value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Reported;

/// The mistakes found so far.
#[derive(Debug, Default)]
pub(super) struct Mistakes {
    list: Vec<Mistake>,
}

impl Mistakes {
    /// Adds a mistake; one that has been reported before (a `let` used twice) is not repeated.
    pub(super) fn push(&mut self, file: &File, diagnostic: Diagnostic) -> Reported {
        // What a damaged part of the file would have declared is unknown, so its absence proves nothing.
        let absence = matches!(
            diagnostic.code,
            Code::UnknownName
                | Code::UnknownImport
                | Code::MissingKey
                | Code::UnknownArgument
                | Code::MissingArgument
        );
        let mistake = Mistake { source: Arc::clone(&file.source), diagnostic };
        let unproved = absence && file.damaged;
        let repeated = self.list.contains(&mistake);
        if !unproved && !repeated {
            self.list.push(mistake);
        }
        Reported
    }

    /// Adds a mistake at one place.
    pub(super) fn report(
        &mut self,
        file: &File,
        code: Code,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
        help: Option<String>,
    ) -> Reported {
        let mut diagnostic = Diagnostic::new(code, message, span, label);
        diagnostic.help = help;
        self.push(file, diagnostic)
    }

    /// Gives the last mistake a help, if it is this one and has none.
    pub(super) fn advise(&mut self, code: Code, span: &Span, help: impl FnOnce() -> String) {
        if let Some(Mistake { diagnostic, .. }) = self.list.last_mut()
            && diagnostic.code == code
            && diagnostic.help.is_none()
            && diagnostic.labels.first().is_some_and(|label| label.span == *span)
        {
            diagnostic.help = Some(help());
            if let Some((last, before)) = self.list.split_last()
                && before.contains(last)
            {
                self.list.pop();
            }
        }
    }

    /// Adds mistakes found elsewhere; whether there are any.
    pub(super) fn extend(&mut self, found: impl IntoIterator<Item = Mistake>) -> bool {
        let mut any = false;
        for mistake in found {
            any = true;
            if !self.list.contains(&mistake) {
                self.list.push(mistake);
            }
        }
        any
    }

    /// Whether a mistake has been reported.
    pub(super) fn has(&self, mistake: &Mistake) -> bool {
        self.list.contains(mistake)
    }

    /// The number of mistakes so far.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// All mistakes: those of the first file before those of its imports, each file's in the order of its text.
    pub(super) fn finish(mut self, first: &Rc<File>) -> Vec<Mistake> {
        let start = |mistake: &Mistake| mistake.diagnostic.labels.first().map_or(0, |label| label.span.start);
        self.list.sort_by(|a, b| {
            let rank =
                |mistake: &Mistake| (mistake.source.name != first.source.name, mistake.source.name.clone());
            rank(a).cmp(&rank(b)).then(start(a).cmp(&start(b)))
        });
        self.list
    }
}
