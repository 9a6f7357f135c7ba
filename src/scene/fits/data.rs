//! `data = csv(…)`: a table for each drive.

use super::super::drives::probe_of;
use super::super::file::{File, Reported};
use super::super::model::{Drive, FitColumn, FitSet, PointProbe, Weighing};
use super::super::scenes::{Stage, Table};
use super::dimension_of;
use crate::expression::{Node, Tape};
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind, Name, Span};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// Column of the weights of rows.
const WEIGHT: &str = "weight";

/// Largest magnitude of a datum, SI: sums of some 1e8 squares stay finite.
const LARGEST_DATUM: f64 = 1e150;

/// A table and where its columns are asked for.
struct Asked {
    table: Rc<Table>,
    file: Rc<File>,
    id: ExprId,
}

impl Asked {
    /// Where a column is named, or the whole table.
    fn span(&self, column: &str) -> Span {
        let ExprKind::Call { arguments, .. } = &self.file.tree.expr(self.id).kind else {
            return self.file.span(self.id);
        };
        let is_it = |parts: &[Name]| {
            parts.iter().map(|part| part.text.as_str()).collect::<Vec<_>>().join(".") == column
        };
        let found = arguments.iter().find_map(|argument| {
            let name = argument.name.as_ref().filter(|name| is_it(&name.parts))?;
            Some(name.parts.first()?.span.start..name.parts.last()?.span.end)
        });
        found.unwrap_or_else(|| self.file.span(self.id))
    }
}

/// Reads the table of one drive.
pub(super) fn read(
    stage: &mut Stage,
    file: &Rc<File>,
    id: ExprId,
    drive: &Drive,
) -> Result<FitSet, Reported> {
    let asked = Asked { table: table(stage, file, id)?, file: Rc::clone(file), id };
    let reference = &asked.table.reference;
    let values = |name: &str| {
        reference.columns.iter().find(|(column, _)| column == name).map(|(_, values)| values.clone())
    };
    let Some(abscissae) = values(&drive.parameter) else {
        let message =
            format!("the data need the column `{}`, along which `{}` is led", drive.parameter, drive.name);
        let names = asked.table.names().collect::<Vec<_>>().join(", ");
        let help = Some(format!(
            "write `{} = \"…\"` with a column of the file; named so far: {names}",
            drive.parameter
        ));
        return Err(stage.mistakes.report(file, Code::MissingArgument, file.span(id), message, "", help));
    };
    require(stage, &asked, &drive.parameter, dimension_of(&drive.unit))?;
    refuse_outside(stage, &asked, drive, &abscissae)?;
    let row_weights = match values(WEIGHT) {
        Some(weights) => {
            require(stage, &asked, WEIGHT, Dimension::NUMBER)?;
            if !weights.iter().all(|weight| weight.is_finite() && *weight >= 0.0) {
                let message = "weights must be finite and >= 0";
                let span = asked.span(WEIGHT);
                return Err(stage.mistakes.report(file, Code::ParameterOutOfRange, span, message, "", None));
            }
            weights
        }
        None => vec![1.0; abscissae.len()],
    };
    let mut columns = Vec::new();
    let mut sound = true;
    for (name, measured) in &reference.columns {
        if *name == drive.parameter || name == WEIGHT {
            continue;
        }
        let column = column(stage, &asked, drive, name, measured);
        sound &= column.is_ok();
        columns.extend(column);
    }
    if columns.is_empty() && sound {
        let message = format!("nothing in these data was measured: they have only `{}`", drive.parameter);
        let help = Some("write for example `P.xx = \"stress_kPa\"` with a column of the file".into());
        return Err(stage.mistakes.report(file, Code::MissingArgument, file.span(id), message, "", help));
    }
    if !sound {
        return Err(Reported);
    }
    Ok(FitSet { drive: drive.clone(), source: reference.path.clone(), abscissae, row_weights, columns })
}

/// The table of `csv(…)`, or of a `let` by name.
fn table(stage: &mut Stage, file: &Rc<File>, id: ExprId) -> Result<Rc<Table>, Reported> {
    match &file.tree.expr(id).kind {
        ExprKind::Call { function, .. } if function.text == "csv" => stage.table(id).map(Rc::new),
        ExprKind::Name(name) => match stage.tables.get(name) {
            // `None`: why it could not be read has been reported there.
            Some(table) => table.clone().ok_or(Reported),
            None => {
                let message = format!("there is no table `{name}`");
                let help = Some(format!("write `let {name} = csv(\"…\")` in the fit"));
                let span = file.span(id);
                Err(stage.mistakes.report(file, Code::UnknownName, span, message, "not declared", help))
            }
        },
        _ => {
            let message = "`data` is a table";
            let help = Some("write `csv(\"data.csv\", stretch = \"…\", P.xx = \"…\")`".into());
            Err(stage.mistakes.report(file, Code::WrongForm, file.span(id), message, "", help))
        }
    }
}

/// Refuses a column of another dimension.
fn require(stage: &mut Stage, asked: &Asked, column: &str, required: Dimension) -> Result<(), Reported> {
    let found = asked.table.dimension(column).unwrap_or(Dimension::NUMBER);
    if found == required {
        return Ok(());
    }
    let (wanted, given) = (required.describe(), found.describe());
    let code = if found.is_number() { Code::MissingUnit } else { Code::WrongDimension };
    let message = format!("`{column}` is {wanted}, but the column of the file is {given}");
    let help = match required.suggested_units().first() {
        Some(unit) if !required.is_number() => {
            Some(format!("the unit is the last part of a column's name in the file: `name_{unit}`"))
        }
        _ => None,
    };
    Err(stage.mistakes.report(&asked.file, code, asked.span(column), message, given, help))
}

/// Refuses data where the drive does not go.
fn refuse_outside(stage: &mut Stage, asked: &Asked, drive: &Drive, at: &[f64]) -> Result<(), Reported> {
    let (from, to) = (drive.range.0.min(drive.range.1), drive.range.0.max(drive.range.1));
    let slack = 1e-9 * (to - from);
    let Some(outside) = at.iter().find(|value| !(from - slack..=to + slack).contains(*value)) else {
        return Ok(());
    };
    let quantity = |value| Quantity::new(value, dimension_of(&drive.unit)).to_string();
    let message = format!(
        "`{}` is led from {} to {}, but a datum lies at {}",
        drive.name,
        quantity(drive.range.0),
        quantity(drive.range.1),
        quantity(*outside)
    );
    let help = Some(format!("write a range of `{}` in its path that holds all data", drive.parameter));
    let span = asked.span(&drive.parameter);
    Err(stage.mistakes.report(&asked.file, Code::DataOutsidePath, span, message, "outside", help))
}

fn column(
    stage: &mut Stage,
    asked: &Asked,
    drive: &Drive,
    name: &str,
    measured: &[f64],
) -> Result<FitColumn, Reported> {
    let recorded = drive.records.iter().flat_map(|record| {
        record.columns.iter().map(move |column| (format!("{}.{}", record.name, column.name), column))
    });
    let recorded: Vec<_> = recorded.collect();
    let found = match probe_of(name) {
        Some((probe, dimension)) => Some((leaf(probe), dimension)),
        None => recorded
            .iter()
            .find(|(full, column)| full == name || column.name == name)
            .map(|(_, column)| (column.value.clone(), dimension_of(&column.unit))),
    };
    let Some((value, dimension)) = found else {
        let known: Vec<&str> = recorded.iter().map(|(full, _)| full.as_str()).collect();
        let words = ["F.xx", "P.xx", "sigma.xx", "J", "psi", "von_mises", "pressure"];
        let help = match nearest(name, known.iter().copied().chain(words)) {
            Some(meant) => format!("write `{meant} = \"…\"`"),
            None => format!("it can be {}, or a column `{}` records", words.join(", "), drive.name),
        };
        let message = format!("`{name}` is nothing a drive can be asked");
        let span = asked.span(name);
        return Err(stage.mistakes.report(&asked.file, Code::UnknownName, span, message, "", Some(help)));
    };
    require(stage, asked, name, dimension)?;
    if let Some(row) = measured.iter().position(|value| !value.is_finite()) {
        let message = format!("`{name}` has no finite number in row {}", row + 1);
        let help = Some(format!("correct the row in {}, or leave it out", asked.table.reference.path));
        let span = asked.span(name);
        return Err(stage.mistakes.report(&asked.file, Code::WrongForm, span, message, "", help));
    }
    if let Some(row) = measured.iter().position(|value| value.abs() > LARGEST_DATUM) {
        let datum = Quantity::new(measured[row], dimension).to_string();
        let message = format!("`{name}` is {datum} in row {}: its square is no finite number", row + 1);
        let help = Some(format!("correct the row in {}, or leave it out", asked.table.reference.path));
        let span = asked.span(name);
        return Err(stage.mistakes.report(&asked.file, Code::ParameterOutOfRange, span, message, "", help));
    }
    Ok(FitColumn { name: name.into(), value, unit: dimension.si_symbol(), measured: measured.to_vec() })
}

fn leaf(probe: PointProbe) -> Tape<PointProbe> {
    let mut tape = Tape::new();
    tape.push(Node::Leaf(probe));
    tape
}

/// Refuses a weighing the data do not allow.
pub(super) fn refuse_unweighable(stage: &mut Stage, name: &Name, sets: &[FitSet], weighing: Weighing) {
    let columns = || sets.iter().flat_map(|set| set.columns.iter().map(move |column| (set, column)));
    let file = Rc::clone(&stage.file);
    let mut refuse = |message: String, help: &str| {
        let span = name.span.clone();
        stage.mistakes.report(&file, Code::WrongForm, span, message, "", Some(help.into()));
    };
    match weighing {
        Weighing::Uniform => {
            let first = columns().next();
            if let Some((_, other)) =
                columns().find(|(_, column)| first.is_some_and(|(_, first)| first.unit != column.unit))
            {
                let (a, b) = (first.map_or("", |(_, first)| first.name.as_str()), &other.name);
                let message = format!(
                    "`weights = uniform` adds squares of `{a}` and `{b}`, which have different units"
                );
                refuse(message, "write `weights = column`");
            }
        }
        Weighing::Relative => {
            let zero = |column: &FitColumn| column.measured.contains(&0.0);
            if let Some((set, column)) = columns().find(|(_, column)| zero(column)) {
                let message = format!(
                    "`weights = relative` divides by data, but a `{}` in {} is 0",
                    column.name, set.source
                );
                refuse(message, "leave the row out, or write `weights = column`");
            }
        }
        Weighing::Column => {
            if let Some((set, column)) =
                columns().find(|(_, column)| column.measured.iter().all(|value| *value == 0.0))
            {
                let message = format!(
                    "every `{}` in {} is 0: the column has no size to be weighed by",
                    column.name, set.source
                );
                refuse(message, "leave the column out");
            }
        }
    }
}

/// Refuses a fit with less data than parameters.
pub(super) fn refuse_too_few(stage: &mut Stage, name: &Name, sets: &[FitSet], parameters: usize) {
    let data: usize = sets
        .iter()
        .map(|set| set.columns.len() * set.row_weights.iter().filter(|weight| **weight > 0.0).count())
        .sum();
    if data <= parameters {
        let file = Rc::clone(&stage.file);
        let plural = if parameters == 1 { "" } else { "s" };
        let message = format!(
            "{data} data cannot give {parameters} parameter{plural} with an estimate of their errors"
        );
        let help = Some("a fit needs more data than parameters".into());
        stage.mistakes.report(&file, Code::TooFewData, name.span.clone(), message, "", help);
    }
}
