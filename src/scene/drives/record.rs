//! `record` of a drive: columns over the parameter of the path.

use super::super::evaluate::{Evaluator, Leaves, Lets, Outcome, Scope, Value};
use super::super::file::{File, Reported};
use super::super::members::Members;
use super::super::model::{PointProbe, PointRecord};
use super::super::scenes::{Stage, column};
use super::super::words::{POINT_RECORD, POINT_WORDS};
use super::path::Way;
use crate::syntax::{Argument, Block, Code, ExprId, ExprKind, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

impl Leaves for PointProbe {}

/// Reads a record and declares its columns.
pub(super) fn read(stage: &mut Stage, block: &Block, way: &Way) -> Result<PointRecord, Reported> {
    let name = stage.output_name(block)?;
    let file = Rc::clone(&stage.file);
    let members = Members::read(stage.mistakes, &file, &POINT_RECORD, block);
    stage.abscissa.clone_from(&way.parameter);
    let own = BTreeMap::from([(way.parameter.clone(), Some(way.dimension))]);
    let refused = |column: &Name| match column.text.as_str() {
        word if word == way.parameter => {
            let message = format!("every record has the column `{word}` already: it runs along the path");
            Some((Code::DuplicateName, message, None))
        }
        "every" => {
            let message = "a record of a drive has no interval: it has one row a point of the path";
            let help = "say with `steps` of the path how many there are";
            Some((Code::UnknownKey, message.into(), Some(help.into())))
        }
        _ => None,
    };
    let example = "is to be recorded, for example `P = P.xx`";
    let columns = stage.read_columns(&name, &members, own, example, refused, |stage, name, id| {
        let scope = PointScope { file: &file, lets: stage.lets.fresh(), way };
        column(stage.mistakes, &scope, name, id)
    })?;
    Ok(PointRecord { name: name.text, place: file.place(&block.kind.span), columns })
}

/// The names in a record of a drive.
struct PointScope<'a> {
    file: &'a Rc<File>,
    lets: Lets,
    way: &'a Way,
}

type Tensor = fn(u8, u8) -> PointProbe;

/// A tensor by name, and the dimension of its components.
fn tensor(word: &str) -> Option<(Tensor, Dimension)> {
    match word {
        "F" => Some((PointProbe::F, Dimension::NUMBER)),
        "P" => Some((PointProbe::P, Dimension::PRESSURE)),
        "sigma" => Some((PointProbe::Sigma, Dimension::PRESSURE)),
        _ => None,
    }
}

/// A scalar by name, and its dimension.
fn scalar(word: &str) -> Option<(PointProbe, Dimension)> {
    match word {
        "psi" => Some((PointProbe::Psi, Dimension::PRESSURE)),
        "J" => Some((PointProbe::J, Dimension::NUMBER)),
        "von_mises" => Some((PointProbe::VonMises, Dimension::PRESSURE)),
        "pressure" => Some((PointProbe::Pressure, Dimension::PRESSURE)),
        "constraint_stress" => Some((PointProbe::ConstraintStress, Dimension::PRESSURE)),
        "residual" => Some((PointProbe::Residual, Dimension::PRESSURE)),
        _ => None,
    }
}

/// What a material point can be asked under a name such as `P.xx` or `J`, and its dimension.
pub(in crate::scene) fn probe_of(written: &str) -> Option<(PointProbe, Dimension)> {
    match written.split_once('.') {
        None => scalar(written).filter(|(probe, _)| *probe != PointProbe::Residual),
        Some((word, component)) => {
            let ((probe, dimension), (i, j)) = (tensor(word)?, indices(component)?);
            Some((probe(i, j), dimension))
        }
    }
}

/// Row and column of `xy`.
fn indices(component: &str) -> Option<(u8, u8)> {
    let axes: Vec<u8> = component.chars().filter_map(|c| "xyz".find(c)).map(|axis| axis as u8).collect();
    (component.len() == 2 && axes.len() == 2).then(|| (axes[0], axes[1]))
}

impl Scope<PointProbe> for PointScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<PointProbe>, name: &Name) -> Option<Outcome> {
        if name.text == self.way.parameter {
            return Some(Ok(Value::scalar(evaluator.graph.leaf(PointProbe::Parameter), self.way.dimension)));
        }
        if let Some(outcome) = self.lets.name(evaluator, self, name) {
            return Some(outcome);
        }
        let (probe, dimension) = scalar(&name.text)?;
        Some(Ok(Value::scalar(evaluator.graph.leaf(probe), dimension)))
    }

    fn member(
        &self,
        evaluator: &mut Evaluator<PointProbe>,
        base: ExprId,
        name: &Name,
        span: &Span,
    ) -> Option<Outcome> {
        let ExprKind::Name(word) = &self.file.tree.expr(base).kind else { return None };
        let (probe, dimension) = tensor(word)?;
        Some(match indices(&name.text) {
            Some((i, j)) => Ok(Value::scalar(evaluator.graph.leaf(probe(i, j)), dimension)),
            None => {
                let message = format!("`{word}` has no component `{}`", name.text);
                let help = Some(format!("write `{word}.xx`; x, y, z are the axes of the path"));
                let file = self.file;
                Err(evaluator.mistakes.report(file, Code::UnknownName, span.clone(), message, "", help))
            }
        })
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<PointProbe>,
        outer: &dyn Scope<PointProbe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        self.lets.call(evaluator, self, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        let lets = self.lets.names().map(|definition| definition.name.text.clone());
        let words = POINT_WORDS.iter().map(|word| word.form.to_string());
        lets.chain(words).chain([self.way.parameter.clone()]).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        match name {
            "t" => Some(format!("a drive has no time: its tables run over `{}`", self.way.parameter)),
            word => tensor(word).map(|_| format!("write a component of it: `{word}.xx`")),
        }
    }
}
