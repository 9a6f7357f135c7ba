//! The tables of a fit, and its findings in words.

use super::response::Measured;
use crate::fit::{Ending, Finding, Minimum, Statistics};
use crate::output::{Provenance, Table, TableColumn};
use crate::scene::{ERRORS, FITTED, Fit};

/// Data, fitted values and differences of each drive.
pub(super) fn of(fit: &Fit, measured: &[Measured], provenance: &Provenance) -> Vec<Table> {
    let mut tables: Vec<Table> = Vec::new();
    for (index, set) in fit.sets.iter().enumerate() {
        let earlier = tables.iter().filter(|table| is_of(&table.name, &set.drive.name)).count();
        let suffix = if earlier == 0 { String::new() } else { format!("_{}", earlier + 1) };
        for column in measured.iter().filter(|column| column.set == index) {
            let drive = &set.drive;
            let file = if set.columns.len() == 1 {
                format!("data_{}{suffix}", drive.name)
            } else {
                format!("data_{}{suffix}_{}", drive.name, column.name.replace('.', "_"))
            };
            let columns = vec![
                TableColumn::new(&drive.parameter, &drive.unit, "parameter of the path"),
                TableColumn::new("measured", &column.unit, &format!("{} of {}", column.name, set.source)),
                TableColumn::new("fitted", &column.unit, "the same of the drive at the fitted parameters"),
                TableColumn::new("difference", &column.unit, "fitted less measured"),
                TableColumn::new("residual", "", "weighted difference, whose squares are added"),
            ];
            let rows = column
                .rows
                .iter()
                .map(|row| vec![row.at, row.datum, row.model, row.model - row.datum, row.residual()]);
            tables.push(Table { name: file, columns, rows: rows.collect(), provenance: provenance.lines() });
        }
    }
    tables
}

fn is_of(table: &str, drive: &str) -> bool {
    table.strip_prefix("data_").is_some_and(|name| name == drive || name.starts_with(&format!("{drive}_")))
}

/// Values and standard errors, a row each, as `expect` reads them.
pub(super) fn found(fit: &Fit, minimum: &Minimum, statistics: &Statistics, r_squared: f64) -> Vec<Table> {
    let column = |(name, unit): (&str, &str)| TableColumn::new(name, unit, "");
    let parameters = || fit.vary.iter().map(|varied| (varied.name.as_str(), varied.unit.as_str()));
    let numbers = [("r_squared", ""), ("condition", "")];
    let mut values = minimum.parameters.clone();
    values.extend([r_squared, statistics.condition]);
    let errors = statistics.standard_errors.iter().map(|error| error.unwrap_or(f64::NAN));
    vec![
        Table {
            name: FITTED.into(),
            columns: parameters().chain(numbers).map(column).collect(),
            rows: vec![values],
            provenance: Vec::new(),
        },
        Table {
            name: ERRORS.into(),
            columns: parameters().map(column).collect(),
            rows: vec![errors.collect()],
            provenance: Vec::new(),
        },
    ]
}

/// A finding in words.
pub(super) fn sentence(finding: &Finding, fit: &Fit) -> String {
    let name = |index: usize| fit.vary[index].name.as_str();
    match finding {
        Finding::NotArrived(Ending::OutOfSteps) => {
            "the sum of squares was still falling when the steps were used up; start nearer".into()
        }
        Finding::NotArrived(_) => {
            "no step made the sum of squares smaller, yet it is no minimum; start elsewhere".into()
        }
        Finding::NoInfluence { parameter } => {
            format!("`{}` cannot be identified: it changes nothing that was measured", name(*parameter))
        }
        Finding::AtBound { parameter, bound } => format!(
            "`{}` was stopped by the bound of its range, {bound:.6e} {}; it has no standard error, and those of the others hold with it fixed",
            name(*parameter),
            fit.vary[*parameter].unit
        ),
        Finding::Undetermined { combination } => {
            let parts: Vec<String> = combination
                .iter()
                .map(|(index, change)| format!("{} by {:+.3}", name(*index), change))
                .collect();
            format!(
                "parameters cannot be identified: changing {} (relative to their values) changes nothing that was measured",
                parts.join(", ")
            )
        }
        Finding::Correlated { pair: (i, j), correlation } => format!(
            "`{}` and `{}` are hard to tell apart: their estimates have correlation {correlation:.4}",
            name(*i),
            name(*j)
        ),
        Finding::Loose { parameter, relative } => format!(
            "`{}` is not determined: its standard error is {relative:.1} times its value",
            name(*parameter)
        ),
    }
}
