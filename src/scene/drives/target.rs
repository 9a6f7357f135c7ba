//! `F = [[1, s, 0], [0, free, 0], [0, 0, sigma(p)]]`: what is prescribed of each component.

use super::super::evaluate::{Evaluator, Required, Scope};
use super::super::file::{Mistakes, Reported};
use super::super::model::{PathControl, PathParameter};
use crate::expression::Tape;
use crate::syntax::{Code, Diagnostic, ExprId, ExprKind};
use crate::unit::Dimension;
use std::rc::Rc;

const COMPONENTS: [[&str; 3]; 3] = [["xx", "xy", "xz"], ["yx", "yy", "yz"], ["zx", "zy", "zz"]];

/// Nine controls, row by row.
pub(super) fn deformation(
    mistakes: &mut Mistakes,
    scope: &dyn Scope<PathParameter>,
    id: ExprId,
) -> Result<Box<[[PathControl; 3]; 3]>, Reported> {
    let file = Rc::clone(scope.file());
    let rows = triple(&file.tree.expr(id).kind)
        .and_then(|rows| Some([row(scope, rows[0])?, row(scope, rows[1])?, row(scope, rows[2])?]));
    let Some(rows) = rows else {
        let message = "`F` has three rows of three components";
        let help = Some("write `F = [[1, s, 0], [0, 1, 0], [0, 0, 1]]`".into());
        return Err(mistakes.report(&file, Code::WrongForm, file.span(id), message, "", help));
    };
    let mut evaluator = Evaluator::<PathParameter>::new(mistakes);
    let controls: [[Result<PathControl, Reported>; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| control(&mut evaluator, scope, rows[i][j], COMPONENTS[i][j]))
    });
    let [[a, b, c], [d, e, f], [g, h, k]] = controls;
    let controls = [[a?, b?, c?], [d?, e?, f?], [g?, h?, k?]];
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        if let (PathControl::Cauchy(_), PathControl::Cauchy(_)) = (&controls[i][j], &controls[j][i]) {
            let message = format!(
                "the Cauchy stress is symmetric, so {} and {} together leave a rotation undetermined",
                COMPONENTS[i][j], COMPONENTS[j][i]
            );
            let diagnostic = Diagnostic::new(Code::Conflict, message, file.span(rows[j][i]), "and here")
                .with_label(file.span(rows[i][j]), "free here")
                .with_help("prescribe one of the two components of F, for example 0");
            return Err(evaluator.mistakes.push(&file, diagnostic));
        }
    }
    Ok(Box::new(controls))
}

fn triple(kind: &ExprKind) -> Option<[ExprId; 3]> {
    match kind {
        ExprKind::List(ids) => ids.as_slice().try_into().ok(),
        _ => None,
    }
}

fn row(scope: &dyn Scope<PathParameter>, id: ExprId) -> Option<[ExprId; 3]> {
    triple(&scope.file().tree.expr(id).kind)
}

/// One component: a formula, `free`, `sigma(value)` or `P(value)`.
fn control(
    evaluator: &mut Evaluator<PathParameter>,
    scope: &dyn Scope<PathParameter>,
    id: ExprId,
    component: &str,
) -> Result<PathControl, Reported> {
    let expr = scope.file().tree.expr(id);
    let mut stress = |argument: ExprId, word: &str| {
        let name = format!("{word}.{component}");
        let required = Required { name: &name, dimension: Dimension::PRESSURE };
        evaluator.quantity(scope, argument, required).map(|value| evaluator.tape(value))
    };
    match &expr.kind {
        ExprKind::Name(name) if name == "free" => Ok(PathControl::Cauchy(Tape::constant(0.0))),
        ExprKind::Call { function, arguments } if arguments.len() == 1 && function.text == "sigma" => {
            stress(arguments[0].value, "sigma").map(PathControl::Cauchy)
        }
        ExprKind::Call { function, arguments } if arguments.len() == 1 && function.text == "P" => {
            stress(arguments[0].value, "P").map(PathControl::FirstPiola)
        }
        _ => {
            let name = format!("F.{component}");
            let required = Required { name: &name, dimension: Dimension::NUMBER };
            let value = evaluator.quantity(scope, id, required)?;
            Ok(PathControl::Deformation(evaluator.tape(value)))
        }
    }
}
