//! Atoms to lines: indentation, alignment, comments.

use super::atoms::{Atom, Atoms, Kind};
use crate::syntax::scan::TokenKind;
use std::ops::Range;

const INDENT: usize = 2;
/// How far a line goes on that has no `=` to stand under.
const CONTINUE: usize = 4;

/// A line of the result.
struct Line {
    atoms: Range<usize>,
    /// Blanks before each atom but the first.
    blanks: Vec<usize>,
    /// A blank line stands before it.
    spaced: bool,
}

/// An open bracket.
struct Open {
    brace: bool,
    import: bool,
    /// Where what it holds goes on: behind it, or one step in if it ends its line.
    inside: usize,
    /// Where it is closed if it ends its line, else its own column.
    outside: usize,
}

/// The text.
pub(super) fn layout(all: &Atoms<'_>) -> String {
    let mut lines = lines(all);
    align(all, &mut lines);
    let mut writer = Writer { all, open: Vec::new(), entry: 0, equals: None, text: String::new() };
    for line in &lines {
        writer.line(line);
    }
    writer.text
}

fn comment(atom: &Atom<'_>) -> bool {
    atom.kind == Kind::Token(TokenKind::Comment)
}

/// Splits into lines: where the author did, but for `{`, which joins its head.
fn lines(all: &Atoms<'_>) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for (i, atom) in all.list.iter().enumerate() {
        let last = i.checked_sub(1).map(|i| &all.list[i]);
        let joins = atom.text == "{" && last.is_some_and(|l| !comment(l));
        match lines.last_mut() {
            Some(line) if atom.newlines == 0 || joins => {
                line.atoms.end = i + 1;
                line.blanks.push(if comment(atom) { INDENT } else { all.blanks(i) });
            }
            _ => {
                let spaced = atom.newlines > 1 && atom.text != "}" && last.is_some_and(|l| l.text != "{");
                lines.push(Line { atoms: i..i + 1, blanks: Vec::new(), spaced });
            }
        }
    }
    lines
}

impl Line {
    /// Characters before an atom of the line, from the first.
    fn offset(&self, all: &Atoms<'_>, at: usize) -> usize {
        let before = self.atoms.start..at;
        let width: usize = all.list[before.clone()].iter().map(|a| a.text.chars().count()).sum();
        width + self.blanks[..before.len()].iter().sum::<usize>()
    }

    /// What the line aligns with, and the indices of its stops; `None` unless it is one entry.
    fn stops<'s>(&self, all: &'s Atoms<'_>) -> Option<(&'s str, Vec<Option<usize>>)> {
        let first = &all.list[self.atoms.start];
        let (group, stops) = all.aligned.get(&first.start)?;
        let within = &all.list[self.atoms.clone()];
        if within.iter().skip(1).any(|a| all.starts.contains(&a.start)) {
            return None;
        }
        let index =
            |start: &usize| within.iter().position(|a| a.start == *start).map(|i| i + self.atoms.start);
        Some((group, stops.iter().map(|stop| stop.as_ref().and_then(index)).collect()))
    }
}

/// Widens the blanks before the stops of entries that follow each other line by line.
fn align(all: &Atoms<'_>, lines: &mut [Line]) {
    let mut from = 0;
    while from < lines.len() {
        let Some((group, stops)) = lines[from].stops(all) else {
            from += 1;
            continue;
        };
        let mut members = vec![from];
        let mut next = from + 1;
        while next < lines.len() && !lines[next].spaced {
            let starts_entry = all.starts.contains(&all.list[lines[next].atoms.start].start);
            match lines[next].stops(all) {
                Some((other, _)) if other == group => members.push(next),
                // A line that goes on with an entry does not end the group.
                _ if !starts_entry && !ends_group(&all.list[lines[next].atoms.start]) => {}
                _ => break,
            }
            next += 1;
        }
        for stop in 0..stops.len() {
            align_stop(all, lines, &members, stop);
        }
        from = next;
    }
}

fn ends_group(first: &Atom<'_>) -> bool {
    comment(first) || first.text == "}"
}

fn align_stop(all: &Atoms<'_>, lines: &mut [Line], members: &[usize], stop: usize) {
    let place = |line: &Line| line.stops(all).and_then(|(_, stops)| stops[stop]);
    let offsets: Vec<Option<usize>> =
        members.iter().map(|m| place(&lines[*m]).map(|at| lines[*m].offset(all, at))).collect();
    let Some(widest) = offsets.iter().copied().flatten().max() else {
        return;
    };
    for (member, offset) in members.iter().zip(offsets) {
        if let (Some(at), Some(offset)) = (place(&lines[*member]), offset) {
            let line = &mut lines[*member];
            let gap = at - line.atoms.start;
            if gap > 0 {
                line.blanks[gap - 1] += widest - offset;
            }
        }
    }
}

struct Writer<'a> {
    all: &'a Atoms<'a>,
    open: Vec<Open>,
    /// Indentation of the entry being written.
    entry: usize,
    /// Column of its `=`, if written.
    equals: Option<usize>,
    text: String,
}

impl Writer<'_> {
    fn line(&mut self, line: &Line) {
        let list = &self.all.list;
        let indent = self.indent(&list[line.atoms.start]);
        if line.spaced {
            self.text.push('\n');
        }
        let mut column = indent;
        self.text.push_str(&" ".repeat(indent));
        for (k, i) in line.atoms.clone().enumerate() {
            let atom = &list[i];
            let mut blanks = if k == 0 { 0 } else { line.blanks[k - 1] };
            if comment(atom) && k > 0 {
                // Comments keep their column where the line is short enough.
                blanks = blanks.max(atom.column.saturating_sub(column));
            }
            self.text.push_str(&" ".repeat(blanks));
            column += blanks;
            let last = list[i + 1..line.atoms.end].iter().all(comment);
            self.note(atom, column, indent, last);
            self.text.push_str(atom.text);
            column += atom.text.chars().count();
        }
        self.text.push('\n');
    }

    /// Keeps track of brackets and of the entry being written.
    fn note(&mut self, atom: &Atom<'_>, column: usize, indent: usize, last: bool) {
        if self.all.starts.contains(&atom.start) {
            (self.entry, self.equals) = (column, None);
        }
        if self.all.equals.contains(&atom.start) {
            self.equals = Some(column);
        }
        match atom.kind {
            Kind::Token(TokenKind::Open) => {
                let brace = atom.text == "{";
                let import = self.all.import_braces.contains(&atom.start);
                let (inside, outside) = if last { (indent + INDENT, indent) } else { (column + 1, column) };
                self.open.push(Open { brace, import, inside, outside });
            }
            Kind::Token(TokenKind::Close) => drop(self.open.pop()),
            Kind::Token(_) | Kind::Unit => {}
        }
    }

    /// Indentation of a line by its first atom.
    fn indent(&self, first: &Atom<'_>) -> usize {
        let depth = self.open.iter().filter(|o| o.brace).count();
        match self.open.last() {
            Some(open) if !open.brace => {
                if first.kind == Kind::Token(TokenKind::Close) {
                    open.outside
                } else {
                    open.inside
                }
            }
            Some(_) if first.text == "}" => (depth - 1) * INDENT,
            open => {
                let starts = self.all.starts.contains(&first.start) || open.is_some_and(|o| o.import);
                if starts || comment(first) || first.text == "{" {
                    return depth * INDENT;
                }
                match self.equals {
                    // An operator stands under `=`, an operand behind it.
                    Some(at) if first.kind == Kind::Token(TokenKind::Symbol) => at,
                    Some(at) => at + INDENT,
                    None => self.entry + CONTINUE,
                }
            }
        }
    }
}
