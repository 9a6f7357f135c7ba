//! `csv(…)`: a table from a file, in SI.

use super::super::file::Reported;
use super::super::loader::relative_to;
use super::super::model::Reference;
use super::stage::Stage;
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind, Span};
use crate::unit::{Dimension, Unit, parse_unit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Tables by name; `None` where one could not be read.
pub(in crate::scene) type Tables = BTreeMap<String, Option<Rc<Table>>>;

/// A table and the dimensions of its columns.
#[derive(Debug)]
pub(in crate::scene) struct Table {
    pub(in crate::scene) reference: Reference,
    /// In the order of the reference's columns.
    pub(in crate::scene) dimensions: Vec<Dimension>,
}

impl Table {
    /// The dimension of a column.
    pub(in crate::scene) fn dimension(&self, column: &str) -> Option<Dimension> {
        let index = self.reference.columns.iter().position(|(name, _)| name == column)?;
        self.dimensions.get(index).copied()
    }

    /// The names of the columns.
    pub(in crate::scene) fn names(&self) -> impl Iterator<Item = &str> {
        self.reference.columns.iter().map(|(name, _)| name.as_str())
    }
}

/// The text of a table: its header and its rows.
struct Text<'a> {
    header: Vec<&'a str>,
    rows: Vec<(usize, Vec<&'a str>)>,
}

impl Stage<'_> {
    /// Reads `csv("path", name = "column", …)`.
    pub(in crate::scene) fn table(&mut self, id: ExprId) -> Result<Table, Reported> {
        let file = Rc::clone(&self.file);
        let ExprKind::Call { arguments, .. } = &file.tree.expr(id).kind else { return Err(Reported) };
        let mut path = None;
        let mut wanted: Vec<(String, String, Span)> = Vec::new();
        for argument in arguments {
            let ExprKind::Text(text) = &file.tree.expr(argument.value).kind else {
                let message = "`csv` takes texts in quotes";
                let help = Some("write `csv(\"data.csv\", d = \"disp_mm\")`".into());
                return Err(self.mistakes.report(
                    &file,
                    Code::WrongForm,
                    file.span(argument.value),
                    message,
                    "",
                    help,
                ));
            };
            let span = file.span(argument.value);
            match &argument.name {
                None if path.is_none() => path = Some((text.clone(), span)),
                None => {
                    let message = "a column needs a name here";
                    let help = Some(format!("write `name = \"{text}\"`"));
                    return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", help));
                }
                Some(name) => {
                    let name: Vec<&str> = name.parts.iter().map(|part| part.text.as_str()).collect();
                    wanted.push((name.join("."), text.clone(), span));
                }
            }
        }
        let Some((path, span)) = path else {
            let message = "`csv` needs the path of a file";
            return Err(self.mistakes.report(&file, Code::MissingArgument, file.span(id), message, "", None));
        };
        let full = relative_to(&file.source.name, &path);
        let text = self.loader.load(&full).map_err(|error| {
            let message = format!("`{full}` cannot be read: {error}");
            self.mistakes.report(&file, Code::FileNotFound, span.clone(), message, "", None)
        })?;
        let Some(table) = split(&text) else {
            let message = format!("`{full}` has no header line");
            return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", None));
        };
        if table.rows.is_empty() {
            let message = format!("`{full}` has a header line and no rows below it");
            let help = Some("write a line of numbers for each row of the table".into());
            return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "empty", help));
        }
        if let Some((line, row)) = table.rows.iter().find(|(_, row)| row.len() > table.header.len()) {
            let (found, known) = (row.len(), table.header.len());
            let message =
                format!("`{full}` has {found} cells on line {line}, but its header names {known} columns");
            let help = Some("write a decimal point, not a comma, or name every column in the header".into());
            return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", help));
        }
        let all = wanted.is_empty();
        if all {
            wanted = table
                .header
                .iter()
                .map(|name| (stem(name).to_string(), (*name).to_string(), span.clone()))
                .collect();
        }
        let mut columns = Vec::new();
        let mut dimensions = Vec::new();
        for (name, column, span) in wanted {
            let (values, dimension) = self.column(&full, &table, &column, &span)?;
            // a column nobody named may hold anything, for nobody may read it
            if let Some(row) = values.iter().position(|value| !value.is_finite()).filter(|_| !all) {
                let message =
                    format!("`{full}` has no finite number for `{column}` on line {}", table.rows[row].0);
                let help = Some("correct that row, or leave it out".into());
                return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", help));
            }
            columns.push((name, values));
            dimensions.push(dimension);
        }
        let place = file.place(&file.span(id));
        Ok(Table { reference: Reference { place, path, columns }, dimensions })
    }

    fn column(
        &mut self,
        path: &str,
        table: &Text,
        column: &str,
        span: &Span,
    ) -> Result<(Vec<f64>, Dimension), Reported> {
        let file = Rc::clone(&self.file);
        let Some(index) = table.header.iter().position(|name| *name == column) else {
            let message = format!("`{path}` has no column `{column}`");
            let help = match nearest(column, table.header.iter().copied()) {
                Some(meant) => format!("write `{meant}`"),
                None if table.header.len() == 1 => {
                    format!("its only column is `{}`; columns are separated by commas", table.header[0])
                }
                None => format!("its columns are {}", table.header.join(", ")),
            };
            return Err(self.mistakes.report(
                &file,
                Code::UnknownName,
                span.clone(),
                message,
                "",
                Some(help),
            ));
        };
        let unit = unit_of(column);
        let mut values = Vec::with_capacity(table.rows.len());
        for (line, row) in &table.rows {
            match row.get(index).and_then(|cell| cell.parse::<f64>().ok()) {
                Some(value) => values.push(unit.as_ref().map_or(value, |unit| unit.to_si(value))),
                None => {
                    let message = format!("`{path}` has no number for `{column}` on line {line}");
                    let help = Some("write numbers such as 1.5 or 2e-3, separated by commas".into());
                    let span = span.clone();
                    return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", help));
                }
            }
        }
        Ok((values, unit.map_or(Dimension::NUMBER, |unit| unit.dimension)))
    }
}

/// Header and rows without comments and empty lines.
fn split(text: &str) -> Option<Text<'_>> {
    let mut lines = text
        .trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let header = lines.next()?.1.split(',').map(str::trim).collect();
    let rows = lines.map(|(index, line)| (index, line.split(',').map(str::trim).collect())).collect();
    Some(Text { header, rows })
}

/// The unit a column's name ends with: `end_disp_mm`, `force_N`; none for a number.
fn unit_of(column: &str) -> Option<Unit> {
    let (_, suffix) = column.rsplit_once('_')?;
    parse_unit(suffix).ok()
}

/// A column's name without its unit.
fn stem(column: &str) -> &str {
    match (unit_of(column), column.rsplit_once('_')) {
        (Some(_), Some((stem, _))) => stem,
        _ => column,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_has_the_unit_its_name_ends_with() {
        assert_eq!(unit_of("end_disp_mm").map(|unit| unit.to_si(1.0)), Some(1e-3));
        assert_eq!(unit_of("nominal_stress_MPa").map(|unit| unit.dimension), Some(Dimension::PRESSURE));
        assert_eq!(unit_of("J_centre"), None);
        assert_eq!(unit_of("newton"), None);
        assert_eq!((stem("force_N"), stem("J_centre")), ("force", "J_centre"));
    }

    #[test]
    fn comments_and_empty_lines_are_no_rows() {
        let table = split("# a comment\n\nt_s,F_N\r\n# another\n0,1\n2,3\n").expect("there is a header");
        assert_eq!(table.header, ["t_s", "F_N"]);
        assert_eq!(table.rows, [(5, vec!["0", "1"]), (6, vec!["2", "3"])]);
    }
}
