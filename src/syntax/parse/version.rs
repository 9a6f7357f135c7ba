//! The version line `tissue 1`.

use crate::syntax::code::Code;
use crate::syntax::diagnostic::Diagnostic;
use crate::syntax::scan::{Token, TokenKind};
use crate::syntax::tree::Span;

/// The version this program reads.
const VERSION: u32 = 1;

/// Reads the version line, which must come first.
pub(super) fn read(text: &str, tokens: &[Token]) -> Result<(u32, Span), Diagnostic> {
    let missing = |span: Span| {
        Diagnostic::new(
            Code::MissingVersion,
            "a file starts with its language version",
            span,
            "expected `tissue 1`",
        )
        .with_help("write `tissue 1` on the first line")
    };
    let Some(first) = tokens.first() else {
        return Err(missing(0..0));
    };
    if first.text(text) != "tissue" {
        return Err(missing(first.span.clone()));
    }
    let number = tokens
        .get(1)
        .filter(|t| t.kind == TokenKind::Number && !text[first.span.end..t.span.start].contains('\n'));
    let Some(number) = number else {
        return Err(Diagnostic::new(
            Code::WrongVersion,
            "`tissue` is followed by the language version",
            first.span.clone(),
            "no version",
        )
        .with_help("write `tissue 1`"));
    };
    match number.text(text).parse::<u32>() {
        Ok(VERSION) => Ok((VERSION, first.span.start..number.span.end)),
        _ => Err(Diagnostic::new(
            Code::WrongVersion,
            format!(
                "language version {} is not known, this program reads version {VERSION}",
                number.text(text)
            ),
            number.span.clone(),
            format!("expected {VERSION}"),
        )
        .with_help(format!("write `tissue {VERSION}`, or use a newer program"))),
    }
}
