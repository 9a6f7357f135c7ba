//! Columns of records and tables by name.

use super::super::super::file::{File, Mistakes, Reported};
use super::super::stage::Records;
use super::super::tables::Tables;
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind, Name};
use crate::unit::Dimension;

/// A column by name: where it is from and what it is called there.
pub(in crate::scene) struct ColumnName {
    pub(in crate::scene) table: Name,
    pub(in crate::scene) column: Name,
}

/// `table.column`.
pub(in crate::scene) fn column_name(
    mistakes: &mut Mistakes,
    file: &File,
    id: ExprId,
) -> Result<ColumnName, Reported> {
    if let ExprKind::Member { base, name } = &file.tree.expr(id).kind
        && let Some(table) = dotted(file, *base)
    {
        return Ok(ColumnName { table, column: name.clone() });
    }
    let message = "a column of a record is required";
    let help = Some("write `record.column`".into());
    Err(mistakes.report(file, Code::WrongForm, file.span(id), message, "", help))
}

/// `record`, or `source.record` in a figure.
pub(in crate::scene) fn dotted(file: &File, id: ExprId) -> Option<Name> {
    match &file.tree.expr(id).kind {
        ExprKind::Name(name) => Some(Name { text: name.clone(), span: file.span(id) }),
        ExprKind::Member { base, name } => match &file.tree.expr(*base).kind {
            ExprKind::Name(source) => {
                Some(Name { text: format!("{source}.{}", name.text), span: file.span(id) })
            }
            _ => None,
        },
        _ => None,
    }
}

/// The dimension of a recorded column.
pub(in crate::scene) fn column_dimension(
    mistakes: &mut Mistakes,
    records: &Records,
    file: &File,
    name: &ColumnName,
) -> Result<Dimension, Reported> {
    let Some(columns) = records.get(&name.table.text) else {
        let help = match nearest(&name.table.text, records.keys().map(String::as_str)) {
            Some(meant) => Some(format!("write `{meant}`")),
            None if records.is_empty() => None,
            None => {
                Some(format!("the records are {}", records.keys().cloned().collect::<Vec<_>>().join(", ")))
            }
        };
        let message = format!("there is no record `{}`", name.table.text);
        let span = name.table.span.clone();
        return Err(mistakes.report(file, Code::UnknownName, span, message, "not declared", help));
    };
    match columns.get(&name.column.text) {
        // `None`: what is wrong with the column has been reported there.
        Some(dimension) => dimension.ok_or(Reported),
        None => {
            let names: Vec<&str> = columns.keys().map(String::as_str).collect();
            let help = match nearest(&name.column.text, names.iter().copied()) {
                Some(meant) => format!("write `{}.{meant}`", name.table.text),
                None => format!("its columns are {}", names.join(", ")),
            };
            let message = format!("the record `{}` has no column `{}`", name.table.text, name.column.text);
            let span = name.column.span.clone();
            Err(mistakes.report(file, Code::UnknownName, span, message, "", Some(help)))
        }
    }
}

/// The dimension of a column of a table read from a file.
pub(in crate::scene) fn table_dimension(
    mistakes: &mut Mistakes,
    tables: &Tables,
    file: &File,
    name: &ColumnName,
) -> Result<Dimension, Reported> {
    let Some(table) = tables.get(&name.table.text) else {
        let message = format!("there is no table `{}`", name.table.text);
        let help = Some(format!("write `let {} = csv(\"…\")` in the scene", name.table.text));
        let span = name.table.span.clone();
        return Err(mistakes.report(file, Code::UnknownName, span, message, "not declared", help));
    };
    // `None`: why it could not be read has been reported there.
    let table = table.clone().ok_or(Reported)?;
    table.dimension(&name.column.text).ok_or_else(|| {
        let message = format!("the table `{}` has no column `{}`", name.table.text, name.column.text);
        let help = format!("its columns are {}", table.names().collect::<Vec<_>>().join(", "));
        mistakes.report(file, Code::UnknownName, name.column.span.clone(), message, "", Some(help))
    })
}
