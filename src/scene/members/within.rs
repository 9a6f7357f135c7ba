//! The admissible range of a parameter.

use super::super::evaluate::{Evaluator, Leaves, Required, Scope};
use super::super::file::{File, Reported};
use super::ParameterDef;
use crate::fit::{Bound, Range};
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

/// The range a parameter is declared with; `scope` is the one it is declared in.
pub(in crate::scene) fn range<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    scope: &dyn Scope<L>,
    parameter: &ParameterDef,
) -> Result<Range, Reported> {
    let Some(bounds) = &parameter.bounds else { return Ok(Range::default()) };
    let mut end = |written: &Option<(ExprId, bool)>| match written {
        Some((id, is_excluded)) => bound(evaluator, scope, *id, parameter)
            .map(|value| Some(Bound { value, is_excluded: *is_excluded })),
        None => Ok(None),
    };
    Ok(Range { lower: end(&bounds.lower)?, upper: end(&bounds.upper)? })
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
    if range(evaluator, scope, parameter)?.contains(value) {
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
