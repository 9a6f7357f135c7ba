//! The walk over an expression.

use super::super::file::{File, Mistakes, Reported};
use super::super::graph::Graph;
use super::super::words::{FUNCTIONS, vocabulary};
use super::scope::Let;
use super::{Leaves, Outcome, Scalar, Scope, Value};
use crate::expression::Tape;
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind, Name, Span, UnitText};
use crate::unit::{Dimension, UnitError, parse_unit};
use std::rc::Rc;

/// Deepest nesting of expressions through `let`s and sums.
const DEEPEST: u32 = 256;

/// Most expressions one formula may expand to.
const LONGEST: u32 = 1_000_000;

/// Turns expressions into formulas over leaves of type `L`.
pub(in crate::scene) struct Evaluator<'m, L> {
    pub(in crate::scene) graph: Graph<L>,
    pub(in crate::scene) mistakes: &'m mut Mistakes,
    /// Values of the material parameters so far.
    pub(in crate::scene) parameters: Vec<f64>,
    /// Where ramps stand and when they end, s.
    pub(in crate::scene) ramps: Vec<(Rc<File>, Span, f64)>,
    /// Whether an integral is being read.
    pub(in crate::scene) integrating: bool,
    depth: u32,
    evaluated: u32,
}

impl<'m, L: Leaves> Evaluator<'m, L> {
    pub(in crate::scene) fn new(mistakes: &'m mut Mistakes) -> Self {
        Self {
            graph: Graph::new(),
            mistakes,
            parameters: Vec::new(),
            ramps: Vec::new(),
            integrating: false,
            depth: 0,
            evaluated: 0,
        }
    }

    /// The value of an expression.
    pub(in crate::scene) fn evaluate(&mut self, scope: &dyn Scope<L>, id: ExprId) -> Outcome {
        self.evaluated += 1;
        if self.depth >= DEEPEST || self.evaluated > LONGEST {
            let file = Rc::clone(scope.file());
            let (what, label) = if self.depth >= DEEPEST {
                ("the definitions this expression uses are nested too deeply", format!("level {DEEPEST}"))
            } else {
                ("this formula is too long", format!("more than {LONGEST} operations"))
            };
            return Err(self.mistakes.report(
                &file,
                Code::ExpressionTooDeep,
                file.span(id),
                what,
                label,
                None,
            ));
        }
        self.depth += 1;
        let outcome = self.walk(scope, id);
        self.depth -= 1;
        outcome
    }

    fn walk(&mut self, scope: &dyn Scope<L>, id: ExprId) -> Outcome {
        let file = Rc::clone(scope.file());
        let expr = file.tree.expr(id);
        match &expr.kind {
            ExprKind::Number { value, unit } => self.number(scope, &expr.span, *value, unit.as_ref()),
            ExprKind::Name(text) => self.named(scope, &Name { text: text.clone(), span: expr.span.clone() }),
            ExprKind::Member { base, name } => self.member(scope, *base, name, &expr.span),
            ExprKind::Index { base, index } => self.indexed(scope, *base, *index),
            ExprKind::Call { function, arguments } => match scope.call(self, scope, function, arguments) {
                Some(outcome) => outcome,
                None => self.function(scope, id, function, arguments),
            },
            ExprKind::List(ids) => {
                let values: Vec<Outcome> = ids.iter().map(|id| self.evaluate(scope, *id)).collect();
                Ok(Value::List(values.into_iter().collect::<Result<_, _>>()?))
            }
            ExprKind::Unary { operator, operand } => self.unary(scope, *operator, *operand),
            ExprKind::Binary { operator, at, left, right } => {
                self.binary(scope, *operator, at, *left, *right)
            }
            ExprKind::Text(_) => {
                Err(self.wrong_form(&file, &expr.span, "a text", "a value is required here"))
            }
            ExprKind::Binder { .. } => Err(self.wrong_form(
                &file,
                &expr.span,
                "`in`",
                "it binds a name, as in `sum(i in 1 .. n, …)`",
            )),
        }
    }

    fn number(&mut self, scope: &dyn Scope<L>, span: &Span, value: f64, unit: Option<&UnitText>) -> Outcome {
        let Some(unit) = unit else {
            let node = self.graph.constant(value);
            return Ok(Value::scalar(node, Dimension::NUMBER));
        };
        match parse_unit(&unit.text) {
            Ok(known) => {
                let node = self.graph.constant(known.to_si(value));
                Ok(Value::scalar(node, known.dimension))
            }
            Err(error) => {
                let file = Rc::clone(scope.file());
                let (place, label, help) = match &error {
                    UnitError::Unknown { symbol, offset, suggestion } => (
                        unit.span.start + offset..unit.span.start + offset + symbol.len(),
                        "not a unit",
                        starts_a_block(&unit.text)
                            .or_else(|| swallowed(scope, &file, span, unit, *offset, suggestion.is_some()))
                            .or_else(|| {
                                suggestion.map(|meant| {
                                    format!("write `{}`", unit.text.replacen(symbol.as_str(), meant, 1))
                                })
                            }),
                    ),
                    _ => (unit.span.clone(), "this unit", None),
                };
                Err(self.mistakes.report(&file, Code::UnknownUnit, place, error.to_string(), label, help))
            }
        }
    }

    fn named(&mut self, scope: &dyn Scope<L>, name: &Name) -> Outcome {
        if let Some(outcome) = scope.name(self, name) {
            return outcome;
        }
        if name.text == "pi" {
            let node = self.graph.constant(std::f64::consts::PI);
            return Ok(Value::scalar(node, Dimension::NUMBER));
        }
        let file = Rc::clone(scope.file());
        let names = scope.names();
        let function =
            FUNCTIONS.iter().any(|word| word.word == name.text) || scope.functions().contains(&name.text);
        let help = if function {
            Some(format!("`{}` is a function: write its arguments in parentheses", name.text))
        } else {
            scope.hint(&name.text).or_else(|| {
                nearest(&name.text, names.iter().map(String::as_str)).map(|meant| format!("write `{meant}`"))
            })
        };
        let message = format!("there is no `{}` here", name.text);
        Err(self.mistakes.report(&file, Code::UnknownName, name.span.clone(), message, "not declared", help))
    }

    fn member(&mut self, scope: &dyn Scope<L>, base: ExprId, name: &Name, span: &Span) -> Outcome {
        if let Some(outcome) = scope.member(self, base, name, span) {
            return outcome;
        }
        let value = self.evaluate(scope, base)?;
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name.text);
        match (&value, axis) {
            (Value::List(values), Some(axis)) if values.len() == 3 => Ok(values[axis].clone()),
            _ => {
                let file = Rc::clone(scope.file());
                let message = match &value {
                    Value::List(values) if values.len() == 3 => {
                        format!("a vector has no `{}`, its components are x, y, z", name.text)
                    }
                    other => format!("{} has no `{}`", other.describe(), name.text),
                };
                let label = value.describe();
                Err(self.mistakes.report(&file, Code::WrongForm, file.span(base), message, label, None))
            }
        }
    }

    fn indexed(&mut self, scope: &dyn Scope<L>, base: ExprId, index: ExprId) -> Outcome {
        let file = Rc::clone(scope.file());
        let array = self.evaluate(scope, base);
        let position = self.scalar(scope, index);
        let (array, position) = (array?, position?);
        let Value::List(values) = array else {
            let message = format!("{} has no elements", array.describe());
            return Err(self.mistakes.report(
                &file,
                Code::WrongForm,
                file.span(base),
                message,
                "not a list",
                None,
            ));
        };
        let number = self.graph.number(position.node).filter(|_| position.dimension.is_number());
        match number {
            Some(number) if number.fract() == 0.0 && number >= 1.0 && number <= values.len() as f64 => {
                Ok(values[number as usize - 1].clone())
            }
            _ => {
                let found = number.map_or("not a known number".into(), |number| format!("{number}"));
                let message = format!("an index must be a whole number from 1 to {}", values.len());
                Err(self.mistakes.report(&file, Code::WrongForm, file.span(index), message, found, None))
            }
        }
    }

    /// The value of an expression that must not be a list or a direction.
    pub(in crate::scene) fn scalar(&mut self, scope: &dyn Scope<L>, id: ExprId) -> Result<Scalar, Reported> {
        match self.evaluate(scope, id)? {
            Value::Scalar(scalar) => Ok(scalar),
            other => {
                let file = Rc::clone(scope.file());
                Err(self.wrong_form(&file, &file.span(id), &other.describe(), "a single value is required"))
            }
        }
    }

    /// The formula of a value as a tape.
    pub(in crate::scene) fn tape(&self, scalar: Scalar) -> Tape<L> {
        self.graph.tape(scalar.node)
    }

    /// The number a value is, the parameters having their values.
    pub(in crate::scene) fn known(&self, scalar: Scalar) -> Option<f64> {
        self.graph.value(scalar.node, |leaf| leaf.value(&self.parameters))
    }

    pub(in crate::scene) fn wrong_form(
        &mut self,
        file: &File,
        span: &Span,
        found: &str,
        required: &str,
    ) -> Reported {
        let message = format!("{found} cannot stand here: {required}");
        self.mistakes.report(file, Code::WrongForm, span.clone(), message, "", None)
    }

    pub(super) fn circular(&mut self, scope: &dyn Scope<L>, definition: &Let) -> Reported {
        let file = Rc::clone(scope.file());
        let message = format!("`{}` is defined by itself", definition.name.text);
        let span = definition.name.span.clone();
        self.mistakes.report(&file, Code::WrongForm, span, message, "its value needs its value", None)
    }

    pub(in crate::scene) fn wrong_count(
        &mut self,
        scope: &dyn Scope<L>,
        function: &Name,
        required: usize,
        found: usize,
    ) -> Reported {
        let file = Rc::clone(scope.file());
        let plural = if required == 1 { "" } else { "s" };
        let message = format!("`{}` takes {required} argument{plural}, but {found} are given", function.text);
        self.mistakes.report(&file, Code::WrongForm, function.span.clone(), message, "", None)
    }
}

/// What to do about a block on the line of a number: its word was read as the unit.
fn starts_a_block(unit: &str) -> Option<String> {
    let is_block = vocabulary().blocks.iter().any(|known| known.word == unit);
    is_block
        .then(|| format!("a word behind a number is its unit: start the block `{unit}` on a line of its own"))
}

/// How to write a product of a quantity and a name that was read as one unit: `100 s^-1*X`.
fn swallowed<L: Leaves>(
    scope: &dyn Scope<L>,
    file: &File,
    number: &Span,
    unit: &UnitText,
    offset: usize,
    misspelt: bool,
) -> Option<String> {
    let (before, name) = (unit.text.get(..offset)?, unit.text.get(offset..)?);
    let operator = before.chars().next_back().filter(|sign| "*·/".contains(*sign))?;
    let end = name.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(name.len());
    let declared = scope.names().iter().any(|known| known == &name[..end]);
    if misspelt && !declared {
        return None;
    }
    let quantity = file.text(&(number.start..unit.span.start + offset - operator.len_utf8()));
    let sign = if operator == '/' { '/' } else { '*' };
    Some(format!("a unit runs on to the next blank: write `{quantity} {sign} {name}`"))
}
