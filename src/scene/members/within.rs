//! The admissible range of a parameter.

use super::super::evaluate::{Evaluator, Leaves, Required, Scope};
use super::super::file::{File, Reported};
use super::ParameterDef;
use crate::syntax::{Code, Diagnostic, ExprId, Span};
use crate::unit::Quantity;
use std::rc::Rc;

/// One end of a range; a bare 0 is 0 of every dimension.
pub(in crate::scene) fn bound<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    scope: &dyn Scope<L>,
    id: ExprId,
    parameter: &ParameterDef,
) -> Result<f64, Reported> {
    let scalar = evaluator.scalar(scope, id)?;
    if evaluator.graph.number(scalar.node) == Some(0.0) && scalar.dimension.is_number() {
        return Ok(0.0);
    }
    evaluator.constant(scope, id, Required { name: &parameter.name.text, dimension: parameter.dimension })
}

/// Refuses a value outside the range; `scope` is the one the parameter is declared in, `file` and `span`
/// where the value is written.
pub(in crate::scene) fn check<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    scope: &dyn Scope<L>,
    parameter: &ParameterDef,
    value: f64,
    file: &Rc<File>,
    span: Span,
) -> Result<(), Reported> {
    let Some(bounds) = &parameter.bounds else { return Ok(()) };
    let mut inside = value.is_finite();
    if let Some((lower, excluded)) = &bounds.lower {
        let lower = bound(evaluator, scope, *lower, parameter)?;
        inside &= value > lower || (value == lower && !excluded);
    }
    if let Some((upper, excluded)) = &bounds.upper {
        let upper = bound(evaluator, scope, *upper, parameter)?;
        inside &= value < upper || (value == upper && !excluded);
    }
    if inside {
        return Ok(());
    }
    let range = scope.file().text(&bounds.span).trim().to_string();
    let name = &parameter.name.text;
    let found = Quantity::new(value, parameter.dimension).to_string();
    let message = format!("`{name}` must be {range}, but the value is {found}");
    let mut diagnostic = Diagnostic::new(Code::ParameterOutOfRange, message, span, "outside");
    if !parameter.doc.is_empty() {
        diagnostic = diagnostic.with_help(format!("`{name}`: {}", parameter.doc.join(" ")));
    }
    Err(evaluator.mistakes.push(file, diagnostic))
}
