//! Where reading resumes after a mistake.

use crate::syntax::scan::{Token, TokenKind};
use crate::syntax::tree::Span;

const WORDS: [&str; 8] = ["let", "fibre", "fibres", "direction", "vary", "param", "expect", "import"];

/// The range of the entry (or top-level item) that holds the mistake at `at`; never empty unless no token
/// is left.
pub(super) fn entry_around(text: &str, tokens: &[Token], at: usize) -> Span {
    let found = tokens.partition_point(|t| t.span.end <= at);
    let (from, to) = level(text, tokens, found);
    let starts = starts(text, tokens, from, to);
    // Any name can start an entry, so a mistake at a name is of the entry before it.
    let start = starts.iter().copied().rfind(|s| *s < found).unwrap_or(from.min(found));
    let at_name = tokens.get(found).is_some_and(|t| t.kind == TokenKind::Name);
    let after = if at_name && start < found { found } else { found + 1 };
    let end = starts.iter().copied().find(|s| *s >= after).unwrap_or(to);
    match (tokens.get(start), tokens.get(end.max(start + 1) - 1)) {
        (Some(first), Some(last)) => first.span.start..last.span.end,
        // Nothing but the end of the file: what stands last goes.
        _ => tokens.last().map_or(0..text.len(), |last| last.span.clone()),
    }
}

/// The tokens between the innermost braces around a token; all of them at the top level.
fn level(text: &str, tokens: &[Token], found: usize) -> (usize, usize) {
    let mut open = Vec::new();
    for (i, token) in tokens.iter().enumerate().take(found) {
        match token.text(text) {
            "{" => open.push(i),
            "}" => drop(open.pop()),
            _ => {}
        }
    }
    let Some(from) = open.last().map(|i| i + 1) else {
        return (0, tokens.len());
    };
    let mut depth = 0usize;
    for (i, token) in tokens.iter().enumerate().skip(from) {
        match token.text(text) {
            "{" => depth += 1,
            "}" if depth == 0 => return (from, i),
            "}" => depth -= 1,
            _ => {}
        }
    }
    (from, tokens.len())
}

/// Where entries of one level seem to start.
fn starts(text: &str, tokens: &[Token], from: usize, to: usize) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    let mut depth = 0usize;
    for i in from..to {
        match tokens[i].kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth = depth.saturating_sub(1),
            TokenKind::Name if depth == 0 => {
                let before = (i > from).then(|| &tokens[i - 1]);
                let joined = before.is_some_and(|t| t.kind == TokenKind::Symbol && t.text(text) != "%");
                let new_line = before.is_none_or(|t| text[t.span.end..tokens[i].span.start].contains('\n'));
                let assigned = tokens.get(i + 1).is_some_and(|t| t.text(text) == "=");
                let word = WORDS.contains(&tokens[i].text(text));
                let at = before.is_some_and(|t| t.text(text) == "at");
                // In `let x = …`, and in `lett x = …`, the entry starts with the word.
                let behind_start = found.last().is_some_and(|s| s + 1 == i);
                let behind_word =
                    before.is_some_and(|t| behind_start || WORDS.contains(&t.text(text))) && !new_line;
                let member =
                    before.is_some_and(|t| t.text(text) == "." && t.span.end == tokens[i].span.start);
                // Before `=` a name starts an entry, as does a word, even where the entry before lacks its value.
                if !member && !at && !behind_word && (assigned || word || !joined && new_line) {
                    found.push(i);
                }
            }
            _ => {}
        }
    }
    found
}
