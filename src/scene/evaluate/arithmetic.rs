//! Operators and the dimensions they join.

use super::super::file::Reported;
use super::read::read_as_unit;
use super::{Evaluator, Leaves, Outcome, Scalar, Scope, Value};
use crate::syntax::{BinaryOperator, Code, Diagnostic, ExprId, ExprKind, Span, UnaryOperator};
use crate::unit::Dimension;
use std::rc::Rc;

/// Where the parts of an operation stand.
pub(super) struct Parts<'a> {
    pub(super) operator: BinaryOperator,
    pub(super) at: &'a Span,
    pub(super) left: ExprId,
    pub(super) right: ExprId,
}

impl<L: Leaves> Evaluator<'_, L> {
    pub(super) fn unary(
        &mut self,
        scope: &dyn Scope<L>,
        operator: UnaryOperator,
        operand: ExprId,
    ) -> Outcome {
        let value = self.evaluate(scope, operand)?;
        if operator == UnaryOperator::Plus {
            return Ok(value);
        }
        self.negated(scope, operand, &value)
    }

    fn negated(&mut self, scope: &dyn Scope<L>, operand: ExprId, value: &Value) -> Outcome {
        match value {
            Value::Scalar(scalar) => Ok(Value::scalar(self.graph.negate(scalar.node), scalar.dimension)),
            Value::List(values) => {
                let values = values.iter().map(|value| self.negated(scope, operand, value));
                Ok(Value::List(values.collect::<Result<_, _>>()?))
            }
            Value::Direction(_) => {
                let file = Rc::clone(scope.file());
                Err(self.wrong_form(
                    &file,
                    &file.span(operand),
                    "a direction",
                    "an invariant of it is required",
                ))
            }
        }
    }

    pub(super) fn binary(
        &mut self,
        scope: &dyn Scope<L>,
        operator: BinaryOperator,
        at: &Span,
        left: ExprId,
        right: ExprId,
    ) -> Outcome {
        use BinaryOperator as B;
        let file = Rc::clone(scope.file());
        match operator {
            B::Add | B::Subtract | B::Multiply | B::Divide | B::Power => {
                let (a, b) = (self.evaluate(scope, left), self.evaluate(scope, right));
                let parts = Parts { operator, at, left, right };
                self.operate(scope, &parts, &a?, &b?)
            }
            B::Range => {
                let (a, b) = (self.scalar(scope, left), self.scalar(scope, right));
                self.range(scope, at, a?, b?)
            }
            B::Equal | B::NotEqual | B::Less | B::LessEqual | B::Greater | B::GreaterEqual => Err(self
                .wrong_form(
                    &file,
                    at,
                    "a comparison",
                    "it can stand in `if(a < b, x, y)` and after `expect`",
                )),
            B::Arrow => Err(self.wrong_form(&file, at, "`->`", "it can stand in `ramp(a -> b, over = T)`")),
            B::Over => Err(self.wrong_form(&file, at, "`over`", "it can stand in `curve = a over b`")),
        }
    }

    fn operate(&mut self, scope: &dyn Scope<L>, parts: &Parts, a: &Value, b: &Value) -> Outcome {
        use BinaryOperator as B;
        match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => self.scalars(scope, parts, *a, *b),
            (Value::List(a), Value::List(b))
                if matches!(parts.operator, B::Add | B::Subtract) && a.len() == b.len() =>
            {
                let values = a.iter().zip(b).map(|(a, b)| self.operate(scope, parts, a, b));
                Ok(Value::List(values.collect::<Result<_, _>>()?))
            }
            (Value::List(a), Value::Scalar(_)) if matches!(parts.operator, B::Multiply | B::Divide) => {
                Ok(Value::List(a.iter().map(|a| self.operate(scope, parts, a, b)).collect::<Result<_, _>>()?))
            }
            (Value::Scalar(_), Value::List(b)) if parts.operator == B::Multiply => {
                Ok(Value::List(b.iter().map(|b| self.operate(scope, parts, a, b)).collect::<Result<_, _>>()?))
            }
            _ => {
                let message =
                    format!("`{}` cannot join {} and {}", symbol(parts.operator), a.describe(), b.describe());
                Err(self.unlike(scope, parts, Code::WrongForm, message, a.describe(), b.describe()))
            }
        }
    }

    fn scalars(&mut self, scope: &dyn Scope<L>, parts: &Parts, a: Scalar, b: Scalar) -> Outcome {
        let (da, db) = (a.dimension, b.dimension);
        let value = match parts.operator {
            BinaryOperator::Add => {
                self.same(scope, parts, da, db)?;
                Value::scalar(self.graph.add(a.node, b.node), da)
            }
            BinaryOperator::Subtract => {
                self.same(scope, parts, da, db)?;
                Value::scalar(self.graph.subtract(a.node, b.node), da)
            }
            BinaryOperator::Multiply => Value::scalar(self.graph.multiply(a.node, b.node), da * db),
            BinaryOperator::Divide => Value::scalar(self.graph.divide(a.node, b.node), da / db),
            _ => {
                let dimension = self.power_dimension(scope, parts, a, b)?;
                Value::scalar(self.graph.power(a.node, b.node), dimension)
            }
        };
        match &value {
            Value::Scalar(scalar) if !scalar.dimension.is_representable() => {
                let file = Rc::clone(scope.file());
                let message = "the powers of the units grow too large";
                Err(self.mistakes.report(
                    &file,
                    Code::WrongDimension,
                    parts.at.clone(),
                    message,
                    "here",
                    None,
                ))
            }
            _ => Ok(value),
        }
    }

    /// Refuses two dimensions that cannot be added or compared.
    pub(super) fn same(
        &mut self,
        scope: &dyn Scope<L>,
        parts: &Parts,
        a: Dimension,
        b: Dimension,
    ) -> Result<(), Reported> {
        if a == b {
            return Ok(());
        }
        let (left, right) = (a.describe(), b.describe());
        let message = match parts.operator {
            BinaryOperator::Add => format!("`+` adds {left} and {right}"),
            BinaryOperator::Subtract => format!("`-` subtracts {right} from {left}"),
            other => format!("`{}` compares {left} with {right}", symbol(other)),
        };
        Err(self.unlike(scope, parts, Code::MixedDimensions, message, left, right))
    }

    fn unlike(
        &mut self,
        scope: &dyn Scope<L>,
        parts: &Parts,
        code: Code,
        message: String,
        left: String,
        right: String,
    ) -> Reported {
        let file = Rc::clone(scope.file());
        let diagnostic = Diagnostic::new(code, message, parts.at.clone(), "")
            .with_label(file.span(parts.left), left)
            .with_label(file.span(parts.right), right);
        let diagnostic = match read_as_unit(&file, parts.left).or_else(|| read_as_unit(&file, parts.right)) {
            Some(help) => diagnostic.with_help(help),
            None => diagnostic,
        };
        self.mistakes.push(&file, diagnostic)
    }

    fn power_dimension(
        &mut self,
        scope: &dyn Scope<L>,
        parts: &Parts,
        a: Scalar,
        b: Scalar,
    ) -> Result<Dimension, Reported> {
        let file = Rc::clone(scope.file());
        let span = file.span(parts.right);
        if !b.dimension.is_number() {
            let message = format!("an exponent must be a number, but this is {}", b.dimension.describe());
            let label = b.dimension.describe();
            return Err(self.mistakes.report(&file, Code::NotANumber, span, message, label, None));
        }
        if a.dimension.is_number() {
            return Ok(a.dimension);
        }
        match self.graph.number(b.node).and_then(fraction) {
            Some((numerator, denominator)) => Ok(a.dimension.powr(numerator, denominator)),
            None => {
                let message =
                    format!("{} can only be raised to a power written as a number", a.dimension.describe());
                let help = Some("divide by a quantity of the same dimension first".into());
                Err(self.mistakes.report(
                    &file,
                    Code::WrongDimension,
                    span,
                    message,
                    "its dimension would depend on this",
                    help,
                ))
            }
        }
    }

    fn range(&mut self, scope: &dyn Scope<L>, at: &Span, a: Scalar, b: Scalar) -> Outcome {
        const MOST: f64 = 10_000.0;
        let whole = |e: &Self, s: Scalar| {
            let number =
                e.known(s).filter(|n| s.dimension.is_number() && n.fract() == 0.0 && n.abs() <= MOST);
            number.map(|n| n as i64)
        };
        match (whole(self, a), whole(self, b)) {
            (Some(from), Some(to)) => {
                let values = (from..=to).map(|i| {
                    let node = self.graph.constant(i as f64);
                    Value::scalar(node, Dimension::NUMBER)
                });
                Ok(Value::List(values.collect()))
            }
            _ => {
                let file = Rc::clone(scope.file());
                let required = "its ends must be whole numbers of at most four digits";
                Err(self.wrong_form(&file, at, "this range", required))
            }
        }
    }

    /// A comparison as the condition of `if`.
    pub(super) fn comparison(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
    ) -> Result<(Scalar, crate::expression::Comparison, Scalar), Reported> {
        use crate::expression::Comparison as C;
        let file = Rc::clone(scope.file());
        let expr = file.tree.expr(id);
        if let ExprKind::Binary { operator, at, left, right } = &expr.kind {
            let comparison = match operator {
                BinaryOperator::Less => Some(C::Less),
                BinaryOperator::LessEqual => Some(C::LessEqual),
                BinaryOperator::Greater => Some(C::Greater),
                BinaryOperator::GreaterEqual => Some(C::GreaterEqual),
                _ => None,
            };
            if let Some(comparison) = comparison {
                let (a, b) = (self.scalar(scope, *left), self.scalar(scope, *right));
                let (a, b) = (a?, b?);
                let parts = Parts { operator: *operator, at, left: *left, right: *right };
                self.same(scope, &parts, a.dimension, b.dimension)?;
                return Ok((a, comparison, b));
            }
        }
        Err(self.wrong_form(
            &file,
            &expr.span,
            "this condition",
            "`a < b`, `a <= b`, `a > b` or `a >= b` is required",
        ))
    }
}

/// An operator as written.
pub(in crate::scene) fn symbol(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Over => "over",
        BinaryOperator::Arrow => "->",
        BinaryOperator::Equal => "==",
        BinaryOperator::NotEqual => "!=",
        BinaryOperator::Less => "<",
        BinaryOperator::LessEqual => "<=",
        BinaryOperator::Greater => ">",
        BinaryOperator::GreaterEqual => ">=",
        BinaryOperator::Range => "..",
        BinaryOperator::Add => "+",
        BinaryOperator::Subtract => "-",
        BinaryOperator::Multiply => "*",
        BinaryOperator::Divide => "/",
        BinaryOperator::Power => "^",
    }
}

/// A number as a fraction with a denominator of at most 12, if it is one to round-off.
fn fraction(value: f64) -> Option<(i64, i64)> {
    (1..=12).find_map(|denominator| {
        let numerator = value * denominator as f64;
        let whole = numerator.round();
        ((numerator - whole).abs() <= 4.0 * f64::EPSILON * numerator.abs().max(1.0) && whole.abs() < 1e6)
            .then_some((whole as i64, denominator))
    })
}

#[cfg(test)]
mod tests {
    use super::fraction;

    #[test]
    fn an_exponent_is_recognised_as_a_fraction() {
        assert_eq!(fraction(2.0), Some((2, 1)));
        assert_eq!(fraction(-2.0 / 3.0), Some((-2, 3)));
        assert_eq!(fraction(0.5), Some((1, 2)));
        assert_eq!(fraction(std::f64::consts::PI), None);
    }
}
