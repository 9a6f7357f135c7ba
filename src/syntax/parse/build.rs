//! What the grammar recognised to the syntax tree.

use super::grammar::Rule;
use crate::syntax::diagnostic::Diagnostic;
use crate::syntax::scan::Token;
use crate::syntax::tree::{
    At, Block, Bounds, Entry, Expr, ExprId, ExprKind, Import, ImportFrom, Item, Name, Path, Span, SyntaxTree,
};
use pest::iterators::{Pair, Pairs};

/// Builds one tree.
pub(super) struct Builder<'a> {
    comments: Comments<'a>,
    /// Where characters were left out, in order.
    unread: Vec<usize>,
    pub(super) expressions: Vec<Expr>,
    pub(super) mistakes: Vec<Diagnostic>,
}

/// The bytes of a pair.
pub(super) fn span(pair: &Pair<'_, Rule>) -> Span {
    pair.as_span().start()..pair.as_span().end()
}

/// What a pair consists of, without punctuation.
pub(super) fn parts(pair: Pair<'_, Rule>) -> impl Iterator<Item = Pair<'_, Rule>> {
    let punctuation = [
        Rule::open_brace,
        Rule::close_brace,
        Rule::open_paren,
        Rule::close_paren,
        Rule::open_list,
        Rule::close_list,
        Rule::comma,
        Rule::colon,
        Rule::equals,
        Rule::in_word,
        Rule::at_word,
        Rule::within_word,
        Rule::expect_word,
        Rule::param_word,
        Rule::import_word,
    ];
    pair.into_inner().filter(move |p| !punctuation.contains(&p.as_rule()))
}

/// The first part.
pub(super) fn first(pair: Pair<'_, Rule>) -> Option<Pair<'_, Rule>> {
    parts(pair).next()
}

/// A pair as a name.
pub(super) fn name(pair: &Pair<'_, Rule>) -> Name {
    Name { text: pair.as_str().into(), span: span(pair) }
}

/// The names directly in a pair.
pub(super) fn names(pair: Pair<'_, Rule>) -> impl Iterator<Item = Name> {
    pair.into_inner().filter(|p| p.as_rule() == Rule::name).map(|p| name(&p))
}

/// A pair as a path.
pub(super) fn path(pair: Pair<'_, Rule>) -> Path {
    Path { parts: names(pair).collect() }
}

/// The value of a tree that holds one block with one assignment and nothing else.
pub(super) fn only_value(tree: &SyntaxTree) -> Option<ExprId> {
    match tree.items.as_slice() {
        [Item::Block(block)] => match block.entries.as_slice() {
            [Entry::Assign { value, .. }] => Some(*value),
            _ => None,
        },
        _ => None,
    }
}

impl<'a> Builder<'a> {
    pub(super) fn new(work: &'a str, original: &'a str, comments: &'a [Token], unread: Vec<usize>) -> Self {
        let comments = Comments { work, original, tokens: comments };
        Self { comments, unread, expressions: Vec::new(), mistakes: Vec::new() }
    }

    pub(super) fn file(&mut self, pairs: Pairs<'_, Rule>) -> SyntaxTree {
        let mut items = Vec::new();
        for pair in pairs.flat_map(Pair::into_inner) {
            match pair.as_rule() {
                Rule::import => items.extend(self.import(pair).map(Item::Import)),
                Rule::block => items.extend(self.block(pair).map(Item::Block)),
                _ => {}
            }
        }
        SyntaxTree { version: None, items, expressions: std::mem::take(&mut self.expressions) }
    }

    /// The content of a text in quotes, `None` if its quote was missing and is reported.
    pub(super) fn text_of(&self, pair: &Pair<'_, Rule>) -> Option<String> {
        let written = self.comments.original.get(span(pair))?;
        let content = written.strip_prefix('"')?.strip_suffix('"')?;
        (written == pair.as_str()).then(|| content.into())
    }

    fn import(&mut self, pair: Pair<'_, Rule>) -> Option<Import> {
        let whole = span(&pair);
        let mut parts = parts(pair);
        let source = parts.next()?;
        let from = match source.as_rule() {
            Rule::text => ImportFrom::File(self.text_of(&source)?, span(&source)),
            _ => ImportFrom::Library(path(source)),
        };
        Some(Import { from, names: parts.map(|p| name(&p)).collect(), span: whole })
    }

    fn block(&mut self, pair: Pair<'_, Rule>) -> Option<Block> {
        let whole = span(&pair);
        let mut parts = parts(pair);
        let mut head = parts.next()?.into_inner();
        let kind = name(&head.next()?);
        let target = head.next().map(path);
        let doc = self.comments.above(whole.start);
        let whole_entry = |p: &Pair<'_, Rule>| p.as_rule() == Rule::block || !self.is_unread(&span(p));
        let whole_entries: Vec<_> = parts.filter(whole_entry).collect();
        let entries = whole_entries.into_iter().filter_map(|p| self.entry(p)).collect();
        Some(Block { kind, target, entries, doc, span: whole })
    }

    /// Whether characters were left out in an entry or right behind it: its value is then not what was meant.
    fn is_unread(&self, entry: &Span) -> bool {
        self.unread.get(self.unread.partition_point(|at| *at < entry.start)).is_some_and(|at| {
            // What the grammar took may end in blanks, and in what was blanked.
            let taken = self.comments.work.get(entry.clone()).unwrap_or_default();
            let end = entry.start + taken.trim_end().len();
            let gap = self.comments.original.get(end..*at).unwrap_or_default();
            gap.trim_matches([' ', '\t', ';']).is_empty()
        })
    }

    /// An entry, `None` if a mistake in it was reported.
    fn entry(&mut self, pair: Pair<'_, Rule>) -> Option<Entry> {
        let start = pair.as_span().start();
        match pair.as_rule() {
            Rule::block => Some(Entry::Block(self.block(pair)?)),
            Rule::statement => {
                let whole = span(&pair);
                let mut parts = parts(pair);
                let kind = name(&parts.next()?);
                let target = parts.next().map(path);
                let doc = self.comments.above(start);
                Some(Entry::Block(Block { kind, target, entries: Vec::new(), doc, span: whole }))
            }
            Rule::declaration => {
                let mut parts = parts(pair);
                Some(Entry::Declare { keyword: name(&parts.next()?), name: name(&parts.next()?) })
            }
            Rule::parameter => self.parameter(pair),
            Rule::expectation => self.expectation(pair),
            _ => {
                let (mut keyword, mut key, mut arguments, mut value) = (None, None, Vec::new(), None);
                for part in parts(pair) {
                    match part.as_rule() {
                        Rule::binding_word => keyword = Some(name(&part)),
                        Rule::path => key = Some(path(part)),
                        Rule::formals => arguments = names(part).collect(),
                        _ => value = Some(self.expression(part)?),
                    }
                }
                let value = value?;
                let span = start..self.end_of(value);
                Some(Entry::Assign { keyword, key: key?, arguments, value, span })
            }
        }
    }

    fn end_of(&self, id: ExprId) -> usize {
        self.expressions[id.0 as usize].span.end
    }

    fn parameter(&mut self, pair: Pair<'_, Rule>) -> Option<Entry> {
        let start = pair.as_span().start();
        let mut parts = parts(pair);
        let own = name(&parts.next()?);
        let (mut count, mut dimension, mut bounds, mut default) = (None, None, None, None);
        let mut end = own.span.end;
        for part in parts {
            match part.as_rule() {
                Rule::count => count = names(part).next(),
                Rule::dimension => {
                    let id = self.expression(part)?;
                    end = self.end_of(id);
                    dimension = Some(id);
                }
                Rule::bounds => {
                    let found = self.bounds(part)?;
                    end = found.span.end;
                    bounds = Some(found);
                }
                _ => {
                    let id = self.expression(first(part)?)?;
                    end = self.end_of(id);
                    default = Some(id);
                }
            }
        }
        let mut doc = self.comments.above(start);
        doc.extend(self.comments.behind(end));
        let dimension = dimension?;
        Some(Entry::Parameter { name: own, count, dimension, bounds, default, doc, span: start..end })
    }

    fn bounds(&mut self, pair: Pair<'_, Rule>) -> Option<Bounds> {
        let start = pair.as_span().start();
        let mut parts = parts(pair);
        let head = parts.next()?;
        if head.as_rule() == Rule::bound_operator {
            let id = self.expression(parts.next()?)?;
            let end = Some((id, !head.as_str().ends_with('=')));
            let span = start..self.end_of(id);
            return Some(match head.as_str().starts_with('<') {
                true => Bounds { lower: None, upper: end, span },
                false => Bounds { lower: end, upper: None, span },
            });
        }
        let span = start..head.as_span().end();
        let (mut lower, mut upper, mut ends) = (None, None, (false, false));
        let mut behind_comma = false;
        for part in head.into_inner() {
            match part.as_rule() {
                Rule::lower_end => ends.0 = part.as_str() == "(",
                Rule::upper_end => ends.1 = part.as_str() == ")",
                Rule::comma => behind_comma = true,
                _ if behind_comma => upper = Some(self.expression(part)?),
                _ => lower = Some(self.expression(part)?),
            }
        }
        Some(Bounds { lower: lower.map(|id| (id, ends.0)), upper: upper.map(|id| (id, ends.1)), span })
    }

    fn expectation(&mut self, pair: Pair<'_, Rule>) -> Option<Entry> {
        let start = pair.as_span().start();
        let (mut claim, mut within, mut at) = (None, None, None);
        let mut end = start;
        for part in parts(pair) {
            let id = match part.as_rule() {
                Rule::within => {
                    let id = self.expression(first(part)?)?;
                    within = Some(id);
                    id
                }
                Rule::at => {
                    let mut inner = parts(part);
                    let key = self.key(path(inner.next()?))?;
                    let value = self.expression(inner.next()?)?;
                    at = Some(At { key, value });
                    value
                }
                _ => {
                    let id = self.expression(part)?;
                    claim = Some(id);
                    id
                }
            };
            end = self.end_of(id);
        }
        Some(Entry::Expect { claim: claim?, within, at, span: start..end })
    }

    /// A path as an expression: `pull.d` as the member `d` of `pull`.
    fn key(&mut self, path: Path) -> Option<ExprId> {
        let mut id = None;
        for name in path.parts {
            let start =
                id.map_or(name.span.start, |base: ExprId| self.expressions[base.0 as usize].span.start);
            let span = start..name.span.end;
            id = Some(match id {
                None => self.push(ExprKind::Name(name.text), span)?,
                Some(base) => self.push(ExprKind::Member { base, name }, span)?,
            });
        }
        id
    }
}

/// The comments of a file.
struct Comments<'a> {
    work: &'a str,
    original: &'a str,
    tokens: &'a [Token],
}

impl Comments<'_> {
    /// The comment lines directly above a place, first line first.
    fn above(&self, at: usize) -> Vec<String> {
        let mut lines = Vec::new();
        let mut below = at;
        for token in self.tokens[..self.tokens.partition_point(|t| t.span.end <= at)].iter().rev() {
            let gap = &self.work[token.span.end..below];
            let adjacent = gap.trim().is_empty() && gap.matches('\n').count() == 1;
            let line = self.work[..token.span.start].rfind('\n').map_or(0, |n| n + 1);
            let alone = self.work[line..token.span.start].trim().is_empty();
            if !adjacent || !alone {
                break;
            }
            lines.push(self.content(token));
            below = token.span.start;
        }
        lines.reverse();
        lines
    }

    /// The comment behind a place on the same line, if nothing stands between.
    fn behind(&self, at: usize) -> Option<String> {
        let token = self.tokens.get(self.tokens.partition_point(|t| t.span.start < at))?;
        let gap = &self.work[at..token.span.start];
        (gap.trim().is_empty() && !gap.contains('\n')).then(|| self.content(token))
    }

    fn content(&self, token: &Token) -> String {
        let text = token.text(self.original).trim_start_matches('#').trim_end();
        text.strip_prefix(' ').unwrap_or(text).into()
    }
}
