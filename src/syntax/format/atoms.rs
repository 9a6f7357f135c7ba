//! What is never broken by the formatter, and the blanks between two of them on a line.

use crate::syntax::scan::{Token, TokenKind, scan};
use crate::syntax::tree::{Block, Entry, ExprKind, Item, SyntaxTree};
use std::collections::{BTreeMap, BTreeSet};

/// What an atom is to the layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Token(TokenKind),
    /// The unit of the number before.
    Unit,
}

/// A token, or a unit of several tokens.
#[derive(Debug, Clone)]
pub(super) struct Atom<'a> {
    pub text: &'a str,
    pub kind: Kind,
    pub start: usize,
    /// Line ends before it.
    pub newlines: usize,
    /// Whether anything at all stands between it and the atom before.
    pub apart: bool,
    /// Column in characters from 0 as written.
    pub column: usize,
}

/// Where the parts of an aligned entry start: `=` of an assignment; `:`, range and `=` of a parameter.
pub(super) type Stops = Vec<Option<usize>>;

/// The atoms of a file and what the tree says of them.
pub(super) struct Atoms<'a> {
    pub list: Vec<Atom<'a>>,
    /// Starts of entries and items.
    pub starts: BTreeSet<usize>,
    /// Alignment of the entry that starts at a place: a name for what aligns with it, and its stops.
    pub aligned: BTreeMap<usize, (String, Stops)>,
    /// `=` of any entry.
    pub equals: BTreeSet<usize>,
    /// Functions of calls, and names with formal arguments.
    functions: BTreeSet<usize>,
    /// Braces of imports.
    pub import_braces: BTreeSet<usize>,
}

impl<'a> Atoms<'a> {
    pub fn new(text: &'a str, tree: &SyntaxTree) -> Self {
        let tokens = scan(text).tokens;
        let mut units = BTreeMap::new();
        let mut functions = BTreeSet::new();
        for expression in &tree.expressions {
            match &expression.kind {
                ExprKind::Number { unit: Some(unit), .. } => {
                    units.insert(unit.span.start, unit.span.end);
                }
                ExprKind::Call { function, .. } => {
                    functions.insert(function.span.start);
                }
                _ => {}
            }
        }
        let list = atoms(text, &tokens, &units);
        let mut all = Self {
            list,
            starts: BTreeSet::new(),
            aligned: BTreeMap::new(),
            equals: BTreeSet::new(),
            functions,
            import_braces: BTreeSet::new(),
        };
        all.starts.extend(tree.version.iter().map(|(_, span)| span.start));
        for item in &tree.items {
            match item {
                Item::Import(import) => {
                    all.starts.insert(import.span.start);
                    let inside =
                        all.after(import.span.start).iter().take_while(|a| a.start < import.span.end);
                    let braces: Vec<usize> = inside.filter(|a| a.text == "{").map(|a| a.start).collect();
                    all.import_braces.extend(braces);
                }
                Item::Block(block) => all.block(tree, block),
            }
        }
        all
    }

    fn block(&mut self, tree: &SyntaxTree, block: &Block) {
        self.starts.insert(block.span.start);
        for entry in &block.entries {
            match entry {
                Entry::Block(inner) => self.block(tree, inner),
                Entry::Declare { keyword, .. } => {
                    self.starts.insert(keyword.span.start);
                }
                Entry::Expect { span, .. } => drop(self.starts.insert(span.start)),
                Entry::Assign { keyword, key, arguments, value, span } => {
                    self.starts.insert(span.start);
                    if let (false, Some(last)) = (arguments.is_empty(), key.parts.last()) {
                        self.functions.insert(last.span.start);
                    }
                    let equals = self.before(tree.expr(*value).span.start);
                    self.equals.insert(equals);
                    let group = keyword.as_ref().map_or("", |k| &k.text);
                    self.aligned.insert(span.start, (group.into(), vec![Some(equals)]));
                }
                Entry::Parameter { name, bounds, default, span, .. } => {
                    self.starts.insert(span.start);
                    let colon = self.after(name.span.end).iter().find(|a| a.text == ":").map(|a| a.start);
                    let equals = default.map(|id| self.before(tree.expr(id).span.start));
                    self.equals.extend(equals);
                    let stops = vec![colon, bounds.as_ref().map(|b| b.span.start), equals];
                    self.aligned.insert(span.start, ("param".into(), stops));
                }
            }
        }
    }

    /// The atoms from a place on.
    fn after(&self, at: usize) -> &[Atom<'a>] {
        &self.list[self.list.partition_point(|a| a.start < at)..]
    }

    /// Start of the last atom before a place that is no comment.
    fn before(&self, at: usize) -> usize {
        let end = self.list.partition_point(|a| a.start < at);
        let comment = Kind::Token(TokenKind::Comment);
        self.list[..end].iter().rfind(|a| a.kind != comment).map_or(0, |a| a.start)
    }

    /// Blanks between atom `i - 1` and atom `i` on one line.
    pub fn blanks(&self, i: usize) -> usize {
        let (left, right) = (&self.list[i - 1], &self.list[i]);
        let close = |a: &Atom<'_>| matches!(a.text, ")" | "]") && a.kind == Kind::Token(TokenKind::Close);
        if self.starts.contains(&right.start) {
            return if left.text == "{" { 1 } else { 2 };
        }
        match (left.text, right.text) {
            ("{", "}") => 0,
            ("{", _) | (_, "{" | "}") => 1,
            (_, ",") => 0,
            (",", _) => 1,
            ("(" | "[", _) | (_, ")" | "]") => 0,
            (".", _) | (_, ".") => 0,
            // `2 m ^ 2` is a square of two metres, `2 m^2` two square metres.
            ("^", _) => usize::from(i > 1 && self.list[i - 2].kind == Kind::Unit),
            (_, "^") => usize::from(left.kind == Kind::Unit),
            (_, "(") => usize::from(!self.functions.contains(&left.start) && !close(left)) * self.spaced(i),
            (_, "[") if close(left) => 0,
            (_, "[") if left.kind == Kind::Token(TokenKind::Name) => usize::from(is_word(left.text)),
            _ => self.spaced(i),
        }
    }

    /// Blanks where an operator may stand on either side.
    fn spaced(&self, i: usize) -> usize {
        let (left, right) = (&self.list[i - 1], &self.list[i]);
        if matches!(left.text, "-" | "+") && self.is_sign(i - 1) {
            return 0;
        }
        let loose = |at: usize| self.list[at].apart || self.list.get(at + 1).is_some_and(|a| a.apart);
        match (left.text, right.text) {
            ("*" | "/", _) => usize::from(loose(i - 1)),
            (_, "*" | "/") => usize::from(loose(i)),
            _ => 1,
        }
    }

    /// Whether `+` or `-` has nothing to its left to add to.
    fn is_sign(&self, i: usize) -> bool {
        let comment = Kind::Token(TokenKind::Comment);
        self.list[..i].iter().rfind(|a| a.kind != comment).is_none_or(|a| match a.kind {
            Kind::Unit => false,
            Kind::Token(TokenKind::Name) => is_word(a.text),
            Kind::Token(TokenKind::Number | TokenKind::Text | TokenKind::Close) => false,
            Kind::Token(_) => true,
        })
    }
}

/// Words behind which a value starts.
fn is_word(text: &str) -> bool {
    matches!(text, "in" | "within" | "at" | "over" | "expect")
}

fn atoms<'a>(text: &'a str, tokens: &[Token], units: &BTreeMap<usize, usize>) -> Vec<Atom<'a>> {
    let mut list: Vec<Atom<'a>> = Vec::with_capacity(tokens.len());
    let (mut end, mut line) = (0, 0);
    for token in tokens {
        if token.span.start < end {
            continue; // within a unit
        }
        let gap = &text[end..token.span.start];
        let (kind, stop) = match units.get(&token.span.start) {
            Some(stop) => (Kind::Unit, *stop),
            None => (Kind::Token(token.kind), token.span.end),
        };
        if let Some(at) = gap.rfind('\n') {
            line = end + at + 1;
        }
        let column = text[line..token.span.start].chars().count();
        list.push(Atom {
            text: text[token.span.start..stop].trim_end(),
            kind,
            start: token.span.start,
            newlines: gap.matches('\n').count(),
            apart: !gap.is_empty(),
            column,
        });
        end = stop;
    }
    list
}
