//! Brackets: how deep they nest and whether they match, before any recursion.

use super::MAX_NESTING;
use crate::syntax::code::Code;
use crate::syntax::diagnostic::Diagnostic;
use crate::syntax::scan::{Token, TokenKind};
use crate::syntax::tree::Span;

/// The first bracket that opens too deep a level.
pub(super) fn too_deep(text: &str, tokens: &[Token]) -> Option<Diagnostic> {
    let mut depth = 0usize;
    for token in tokens {
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_NESTING {
            let message = format!(
                "brackets nest at most {MAX_NESTING} deep, `{}` opens one level more",
                token.text(text)
            );
            let mistake = Diagnostic::new(Code::NestingTooDeep, message, token.span.clone(), "too deep");
            return Some(mistake.with_help("name inner parts with `let`"));
        }
    }
    None
}

/// A mistake in the matching of brackets and the range to leave unread for it.
pub(super) fn unbalanced(text: &str, tokens: &[Token]) -> Vec<(Diagnostic, Span)> {
    if check(text, tokens, 0, tokens.len()).is_none() {
        return Vec::new();
    }
    // Something does not match. Names in the first column are taken for the starts of top-level items, so
    // that one bad item does not hide the others.
    let first_column = |t: &Token| t.span.start == 0 || text.as_bytes()[t.span.start - 1] == b'\n';
    let starts_item = |t: &Token| t.kind == TokenKind::Name && first_column(t);
    let mut starts: Vec<usize> =
        tokens.iter().enumerate().filter(|(_, t)| starts_item(t)).map(|(i, _)| i).collect();
    if starts.first() != Some(&0) {
        starts.insert(0, 0);
    }
    starts.push(tokens.len());
    let mut found = Vec::new();
    for ends in starts.windows(2) {
        let chunk = &tokens[ends[0]..ends[1]];
        if let Some(mistake) = check(text, tokens, ends[0], ends[1]) {
            let span = chunk[0].span.start..chunk[chunk.len() - 1].span.end;
            found.push((mistake, span));
        }
    }
    found
}

/// The first mistake among `tokens[from..to]`.
fn check(text: &str, tokens: &[Token], from: usize, to: usize) -> Option<Diagnostic> {
    let mut open: Vec<usize> = Vec::new();
    for i in from..to {
        let (token, bracket) = (&tokens[i], tokens[i].text(text));
        match token.kind {
            TokenKind::Open => open.push(i),
            TokenKind::Close => match open.pop() {
                None => {
                    let message = format!("`{bracket}` closes nothing");
                    let mistake = Diagnostic::new(
                        Code::UnmatchedBracket,
                        message,
                        token.span.clone(),
                        "nothing is open here",
                    );
                    return Some(mistake.with_help("leave it out, or open the block before it"));
                }
                Some(opener) if matches(text, tokens, opener, bracket) => {}
                Some(opener) => return Some(unclosed(text, &tokens[opener], Some(token))),
            },
            _ => {}
        }
    }
    open.pop().map(|opener| unclosed(text, &tokens[opener], None))
}

/// Whether a bracket closes another; a range behind `in` may be half open: `in [0, 0.5)`.
fn matches(text: &str, tokens: &[Token], opener: usize, close: &str) -> bool {
    let open = tokens[opener].text(text);
    let range = opener > 0 && tokens[opener - 1].text(text) == "in";
    closing(open) == close || range && open != "{" && close != "}"
}

fn closing(open: &str) -> &'static str {
    match open {
        "(" => ")",
        "[" => "]",
        _ => "}",
    }
}

fn unclosed(text: &str, opener: &Token, found: Option<&Token>) -> Diagnostic {
    let open = opener.text(text);
    let close = closing(open);
    let message = format!("`{open}` is never closed");
    let mistake = Diagnostic::new(Code::UnclosedBracket, message, opener.span.clone(), "opened here");
    match found {
        Some(token) => mistake
            .with_label(token.span.clone(), format!("expected `{close}` before this"))
            .with_help(format!("write `{close}`")),
        None => mistake.with_help(format!("write `{close}` where it ends")),
    }
}
