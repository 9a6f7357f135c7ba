//! Flat lists of operands and operators to expressions in the arena.
//!
//! Owns precedence and associativity. Operators loosest first:
//!
//! ```text
//! over   ->   == != < <= > >=   ..   + -   * /   unary + -   ^
//! ```
//!
//! `^` joins to the right, all others to the left; a sign may follow `^`. The list is climbed with a stack
//! of its own, so only brackets recurse, and those are counted before.

use super::build::Builder;
use super::grammar::Rule;
use super::{MAX_EXPRESSION_DEPTH, build};
use crate::syntax::code::Code;
use crate::syntax::diagnostic::Diagnostic;
use crate::syntax::tree::{Argument, BinaryOperator, Expr, ExprId, ExprKind, Span, UnaryOperator, UnitText};
use pest::iterators::Pair;

enum Waiting {
    Unary(UnaryOperator, usize),
    Binary(BinaryOperator, Span),
}

const UNARY: u8 = 7;
const POWER: u8 = 8;

fn strength(operator: BinaryOperator) -> u8 {
    use BinaryOperator::*;
    match operator {
        Over => 1,
        Arrow => 2,
        Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual => 3,
        Range => 4,
        Add | Subtract => 5,
        Multiply | Divide => 6,
        Power => POWER,
    }
}

fn binary(text: &str) -> Option<BinaryOperator> {
    use BinaryOperator::*;
    Some(match text {
        "over" => Over,
        "->" => Arrow,
        "==" => Equal,
        "!=" => NotEqual,
        "<" => Less,
        "<=" => LessEqual,
        ">" => Greater,
        ">=" => GreaterEqual,
        ".." => Range,
        "+" => Add,
        "-" => Subtract,
        "*" => Multiply,
        "/" => Divide,
        "^" => Power,
        _ => return None,
    })
}

impl Builder<'_> {
    /// An expression, `None` if a mistake in it was reported.
    pub(super) fn expression(&mut self, pair: Pair<'_, Rule>) -> Option<ExprId> {
        let mut values: Vec<ExprId> = Vec::new();
        let mut waiting: Vec<Waiting> = Vec::new();
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::sign => {
                    let sign = if part.as_str() == "-" { UnaryOperator::Minus } else { UnaryOperator::Plus };
                    waiting.push(Waiting::Unary(sign, part.as_span().start()));
                }
                Rule::operator | Rule::sum_operator | Rule::product_operator => {
                    let operator = binary(part.as_str())?;
                    let own = strength(operator);
                    // Equal strength joins to the left, except powers.
                    let least = if own == POWER { own + 1 } else { own };
                    self.reduce(&mut values, &mut waiting, least)?;
                    waiting.push(Waiting::Binary(operator, build::span(&part)));
                }
                Rule::member => {
                    let base = values.pop()?;
                    let name = build::names(part).next()?;
                    let span = self.start(base)..name.span.end;
                    values.push(self.push(ExprKind::Member { base, name }, span)?);
                }
                Rule::index => {
                    let base = values.pop()?;
                    let span = self.start(base)..part.as_span().end();
                    let index = self.expression(build::first(part)?)?;
                    values.push(self.push(ExprKind::Index { base, index }, span)?);
                }
                _ => values.push(self.primary(part)?),
            }
        }
        self.reduce(&mut values, &mut waiting, 0)?;
        values.pop()
    }

    /// Builds what waits and binds at least as strongly as `least`.
    fn reduce(&mut self, values: &mut Vec<ExprId>, waiting: &mut Vec<Waiting>, least: u8) -> Option<()> {
        while let Some(top) = waiting.pop_if(|w| match w {
            Waiting::Unary(..) => UNARY >= least,
            Waiting::Binary(operator, _) => strength(*operator) >= least,
        }) {
            let right = values.pop()?;
            let end = self.end(right);
            let id = match top {
                Waiting::Unary(operator, start) => {
                    self.push(ExprKind::Unary { operator, operand: right }, start..end)?
                }
                Waiting::Binary(operator, at) => {
                    let left = values.pop()?;
                    let span = self.start(left)..end;
                    self.push(ExprKind::Binary { operator, at, left, right }, span)?
                }
            };
            values.push(id);
        }
        Some(())
    }

    fn primary(&mut self, pair: Pair<'_, Rule>) -> Option<ExprId> {
        let span = build::span(&pair);
        match pair.as_rule() {
            Rule::number => self.number(pair),
            Rule::text => {
                let text = self.text_of(&pair)?;
                self.push(ExprKind::Text(text), span)
            }
            Rule::reference => {
                let name = build::names(pair).next()?;
                self.push(ExprKind::Name(name.text), name.span)
            }
            Rule::group => {
                let inner = self.expression(build::first(pair)?)?;
                // The brackets belong to the span: a mark under `(a + b)*c` starts at the bracket.
                self.expressions[inner.0 as usize].span = span;
                Some(inner)
            }
            Rule::list => {
                let parts: Vec<_> = build::parts(pair).collect();
                let items = parts.into_iter().map(|p| self.expression(p)).collect::<Option<Vec<_>>>()?;
                self.push(ExprKind::List(items), span)
            }
            Rule::call => {
                let mut parts = build::parts(pair);
                let function = build::name(&parts.next()?);
                let arguments = parts.map(|p| self.argument(p)).collect::<Option<Vec<_>>>()?;
                self.push(ExprKind::Call { function, arguments }, span)
            }
            _ => None,
        }
    }

    fn argument(&mut self, pair: Pair<'_, Rule>) -> Option<Argument> {
        let start = pair.as_span().start();
        match pair.as_rule() {
            Rule::named => {
                let mut parts = build::parts(pair);
                let name = build::path(parts.next()?);
                Some(Argument { name: Some(name), value: self.expression(parts.next()?)? })
            }
            Rule::binder => {
                let mut parts = build::parts(pair);
                let name = build::name(&parts.next()?);
                let over = self.expression(parts.next()?)?;
                let span = start..self.end(over);
                Some(Argument { name: None, value: self.push(ExprKind::Binder { name, over }, span)? })
            }
            _ => Some(Argument { name: None, value: self.expression(pair)? }),
        }
    }

    fn number(&mut self, pair: Pair<'_, Rule>) -> Option<ExprId> {
        let span = build::span(&pair);
        let (mut value, mut unit) = (f64::NAN, None);
        for part in pair.into_inner() {
            if part.as_rule() == Rule::decimal {
                value = part.as_str().parse().ok()?;
            } else {
                unit = Some(UnitText { text: part.as_str().into(), span: build::span(&part) });
            }
        }
        if !value.is_finite() {
            self.mistakes.push(
                Diagnostic::new(
                    Code::NumberOutOfRange,
                    "the number is larger than 1.8e308",
                    span,
                    "too large",
                )
                .with_help("use a larger unit"),
            );
            return None;
        }
        self.push(ExprKind::Number { value, unit }, span)
    }

    /// Puts an expression into the arena.
    pub(super) fn push(&mut self, kind: ExprKind, span: Span) -> Option<ExprId> {
        let depth = 1 + children(&kind).map(|id| self.expressions[id.0 as usize].depth).max().unwrap_or(0);
        if depth > MAX_EXPRESSION_DEPTH {
            let at = if let ExprKind::Binary { at, .. } = &kind { at.clone() } else { span };
            self.mistakes.push(
                Diagnostic::new(
                    Code::ExpressionTooDeep,
                    format!("an expression has at most {MAX_EXPRESSION_DEPTH} levels of operators"),
                    at,
                    "one level too many",
                )
                .with_help("name parts of it with `let`"),
            );
            return None;
        }
        let id = ExprId(u32::try_from(self.expressions.len()).ok()?);
        self.expressions.push(Expr { kind, span, depth });
        Some(id)
    }

    fn start(&self, id: ExprId) -> usize {
        self.expressions[id.0 as usize].span.start
    }

    fn end(&self, id: ExprId) -> usize {
        self.expressions[id.0 as usize].span.end
    }
}

/// The expressions directly below another.
pub(super) fn children(kind: &ExprKind) -> Box<dyn Iterator<Item = ExprId> + '_> {
    match kind {
        ExprKind::Number { .. } | ExprKind::Text(_) | ExprKind::Name(_) => Box::new(std::iter::empty()),
        ExprKind::Member { base, .. } => Box::new(std::iter::once(*base)),
        ExprKind::Index { base, index } => Box::new([*base, *index].into_iter()),
        ExprKind::Call { arguments, .. } => Box::new(arguments.iter().map(|a| a.value)),
        ExprKind::List(items) => Box::new(items.iter().copied()),
        ExprKind::Unary { operand, .. } => Box::new(std::iter::once(*operand)),
        ExprKind::Binary { left, right, .. } => Box::new([*left, *right].into_iter()),
        ExprKind::Binder { over, .. } => Box::new(std::iter::once(*over)),
    }
}

/// Moves every span of an expression.
pub(super) fn shift_spans(expr: &mut Expr, moved: &impl Fn(&Span) -> Span) {
    expr.span = moved(&expr.span);
    match &mut expr.kind {
        ExprKind::Number { unit: Some(unit), .. } => unit.span = moved(&unit.span),
        ExprKind::Member { name, .. } | ExprKind::Binder { name, .. } => name.span = moved(&name.span),
        ExprKind::Binary { at, .. } => *at = moved(at),
        ExprKind::Call { function, arguments } => {
            function.span = moved(&function.span);
            let paths = arguments.iter_mut().filter_map(|a| a.name.as_mut());
            paths.flat_map(|p| &mut p.parts).for_each(|n| n.span = moved(&n.span));
        }
        _ => {}
    }
}
