//! `record` of a sweep: numbers read from the tables of each point.

use super::super::evaluate::{Evaluator, Leaves, Lets, Outcome, Scope, Value};
use super::super::file::{File, Reported};
use super::super::members::Members;
use super::super::model::{Column, Reduced, Reduction, SweepRecord, Swept, Varied};
use super::super::scenes::{Records, Stage, column, column_dimension, column_name, place_of_value};
use super::super::words::{SWEEP_RECORD, SWEEP_WORDS};
use crate::syntax::{Argument, Block, Code, ExprId, ExprKind, Name, Span};
use crate::unit::{Dimension, parse_unit};
use std::rc::Rc;

impl Leaves for Reduced {}

/// The dimension an SI unit symbol stands for.
pub(super) fn dimension(unit: &str) -> Option<Dimension> {
    if unit.is_empty() { Some(Dimension::NUMBER) } else { parse_unit(unit).ok().map(|unit| unit.dimension) }
}

/// The columns of the tables of a point.
pub(super) fn columns(swept: &Swept) -> Records {
    let tables = swept.tables().into_iter();
    tables
        .map(|(name, columns)| {
            let of = |(column, unit): (&str, &str)| (column.to_string(), dimension(unit));
            (name.to_string(), columns.into_iter().map(of).collect())
        })
        .collect()
}

/// Reads every record of a sweep and declares its columns.
pub(super) fn read(
    stage: &mut Stage,
    members: &Members,
    varied: &[Varied],
    swept: &Swept,
) -> Vec<SweepRecord> {
    let points = columns(swept);
    let mut records = Vec::new();
    for block in members.blocks.iter().filter(|block| block.kind.text == "record") {
        records.extend(one(stage, block, varied, &points, swept));
    }
    records
}

fn one(
    stage: &mut Stage,
    block: &Block,
    varied: &[Varied],
    points: &Records,
    swept: &Swept,
) -> Result<SweepRecord, Reported> {
    let name = stage.output_name(block)?;
    let file = Rc::clone(&stage.file);
    if points.contains_key(&name.text) {
        let message = format!("`{}` is a record of the scene or drive that is swept", name.text);
        let help = Some("give the record of the sweep a name of its own".into());
        return Err(stage.mistakes.report(&file, Code::DuplicateName, name.span, message, "", help));
    }
    let members = Members::read(stage.mistakes, &file, &SWEEP_RECORD, block);
    let own = varied.iter().map(|varied| (varied.column.clone(), dimension(&varied.unit))).collect();
    let refused = |column: &Name| {
        let message = format!("every record of the sweep has the column `{}` already", column.text);
        let taken = varied.iter().any(|varied| varied.column == column.text);
        taken.then_some((Code::DuplicateName, message, None))
    };
    let example = "is to be read, for example `P = final(test.P)`";
    let columns = stage.read_columns(&name, &members, own, example, refused, |stage, name, id| {
        value(stage, name, id, varied, points, swept)
    })?;
    Ok(SweepRecord { name: name.text, place: file.place(&block.kind.span), columns })
}

/// One column: its formula over numbers read from a point.
pub(super) fn value(
    stage: &mut Stage,
    name: &Name,
    id: ExprId,
    varied: &[Varied],
    points: &Records,
    swept: &Swept,
) -> Result<(Column<Reduced>, Dimension), Reported> {
    let file = Rc::clone(&stage.file);
    let is_scene = matches!(swept, Swept::Scene(_));
    let scope = SweepScope { file: &file, lets: stage.lets.fresh(), varied, points, is_scene };
    column(stage.mistakes, &scope, name, id)
}

/// The names in a record of a sweep.
struct SweepScope<'a> {
    file: &'a Rc<File>,
    lets: Lets,
    varied: &'a [Varied],
    points: &'a Records,
    is_scene: bool,
}

impl Scope<Reduced> for SweepScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<Reduced>, name: &Name) -> Option<Outcome> {
        let varied = self.varied.iter().position(|varied| varied.column == name.text && varied.is_quantity);
        if let Some(index) = varied {
            let dimension = dimension(&self.varied[index].unit)?;
            return Some(Ok(Value::scalar(evaluator.graph.leaf(Reduced::Varied(index)), dimension)));
        }
        if let Some(outcome) = self.lets.name(evaluator, self, name) {
            return Some(outcome);
        }
        let leaf = match name.text.as_str() {
            "particles" => Reduced::Particles,
            "steps" => Reduced::Steps,
            "particle_updates" => Reduced::ParticleUpdates,
            _ => return None,
        };
        if !self.is_scene {
            let (file, span) = (self.file, name.span.clone());
            let message = format!("a drive has no `{}`: it is one material point", name.text);
            return Some(Err(evaluator.mistakes.report(file, Code::UnknownName, span, message, "", None)));
        }
        Some(Ok(Value::scalar(evaluator.graph.leaf(leaf), Dimension::NUMBER)))
    }

    fn member(
        &self,
        evaluator: &mut Evaluator<Reduced>,
        base: ExprId,
        name: &Name,
        span: &Span,
    ) -> Option<Outcome> {
        let ExprKind::Name(table) = &self.file.tree.expr(base).kind else { return None };
        self.points.get(table)?;
        let column = format!("{table}.{}", name.text);
        let message = format!("`{column}` holds many values at each point of the sweep");
        let help = Some(format!("write `final({column})`, or max, min, initial or value of it"));
        let file = self.file;
        Some(Err(evaluator.mistakes.report(file, Code::WrongForm, span.clone(), message, "", help)))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Reduced>,
        outer: &dyn Scope<Reduced>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        if function.text == "value" {
            return Some(self.value(evaluator, outer, function, arguments));
        }
        let [Argument { name: None, value }] = arguments else { return None };
        let by = Reduction::named(&function.text)?;
        Some(column_name(evaluator.mistakes, self.file, *value).and_then(|name| {
            let dimension = column_dimension(evaluator.mistakes, self.points, self.file, &name)?;
            let leaf = Reduced::Column { by, record: name.table.text, column: name.column.text };
            Ok(Value::scalar(evaluator.graph.leaf(leaf), dimension))
        }))
    }

    fn names(&self) -> Vec<String> {
        let lets = self.lets.names().map(|definition| definition.name.text.clone());
        lets.chain(self.varied.iter().map(|varied| varied.column.clone())).collect()
    }

    fn functions(&self) -> Vec<String> {
        let reductions = SWEEP_WORDS.iter().filter(|word| word.form.contains('('));
        reductions.filter(|word| !word.word.ends_with("order")).map(|word| word.word.into()).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        let record = self.points.iter().find(|(_, columns)| columns.contains_key(name));
        record.map(|(record, _)| format!("write `final({record}.{name})`"))
    }
}

impl SweepScope<'_> {
    /// `value(record.column, other = quantity)`.
    fn value(
        &self,
        evaluator: &mut Evaluator<Reduced>,
        outer: &dyn Scope<Reduced>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let of = |mistakes: &mut _, name: &_| column_dimension(mistakes, self.points, self.file, name);
        let found = place_of_value(evaluator, outer, function, arguments, &of)?;
        let leaf = evaluator.graph.leaf(Reduced::Where {
            record: found.record,
            column: found.column,
            abscissa: found.abscissa,
            value: found.value,
        });
        Ok(Value::scalar(leaf, found.dimension))
    }
}
