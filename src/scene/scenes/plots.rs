//! `plot`.

use super::super::file::{File, Mistakes, Reported};
use super::super::members::{Members, Site};
use super::super::model::{Curve, Plot, ReferenceCurve};
use super::super::words::PLOT;
use super::stage::{Records, Stage};
use super::tables::Tables;
use crate::schema::nearest;
use crate::syntax::{BinaryOperator, Block, Code, Diagnostic, ExprId, ExprKind, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// A column by name: where it is from and what it is called there.
pub(in crate::scene) struct ColumnName {
    pub(in crate::scene) table: Name,
    pub(in crate::scene) column: Name,
}

impl Stage<'_> {
    pub(in crate::scene) fn plot(&mut self, block: &Block) -> Result<(), Reported> {
        let name = self.output_name(block)?;
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &PLOT, block);
        let site = members.required(self.mistakes, &file, &PLOT, block, "curve")?;
        let mut curves = Vec::new();
        let mut dimensions: Option<(Dimension, Dimension, ExprId)> = None;
        for id in listed(&site) {
            let (y, x) = self.pair(&site.file, id)?;
            self.same_source(&site.file, &y, &x)?;
            let found = (
                column_dimension(self.mistakes, &self.columns, &site.file, &y)?,
                column_dimension(self.mistakes, &self.columns, &site.file, &x)?,
            );
            self.same_axes(&site.file, id, found, &mut dimensions)?;
            curves.push(Curve { record: y.table.text, y: y.column.text, x: x.column.text });
        }
        let mut points = Vec::new();
        if let Some(site) = members.written("points") {
            for id in listed(site) {
                let (y, x) = self.pair(&site.file, id)?;
                self.same_source(&site.file, &y, &x)?;
                let found = (
                    table_dimension(self.mistakes, &self.tables, &site.file, &y)?,
                    table_dimension(self.mistakes, &self.tables, &site.file, &x)?,
                );
                self.same_axes(&site.file, id, found, &mut dimensions)?;
                let table = self.tables.get(&y.table.text).cloned().flatten().ok_or(Reported)?;
                points.push(ReferenceCurve {
                    reference: table.reference.clone(),
                    y: y.column.text,
                    x: x.column.text,
                });
            }
        }
        self.scene.plots.push(Plot { name: name.text, place: file.place(&block.kind.span), curves, points });
        Ok(())
    }

    /// The two sides of `a.y over a.x`.
    pub(in crate::scene) fn pair(
        &mut self,
        file: &File,
        id: ExprId,
    ) -> Result<(ColumnName, ColumnName), Reported> {
        if let ExprKind::Binary { operator: BinaryOperator::Over, left, right, .. } = &file.tree.expr(id).kind
        {
            let (y, x) = (column_name(self.mistakes, file, *left), column_name(self.mistakes, file, *right));
            return Ok((y?, x?));
        }
        let message = "a curve is one column over another";
        let help = Some("write `record.y over record.x`".into());
        Err(self.mistakes.report(file, Code::WrongForm, file.span(id), message, "", help))
    }

    pub(in crate::scene) fn same_source(
        &mut self,
        file: &File,
        y: &ColumnName,
        x: &ColumnName,
    ) -> Result<(), Reported> {
        if y.table.text == x.table.text {
            return Ok(());
        }
        let message = format!(
            "both columns of a curve must be of one table, but these are of `{}` and `{}`",
            y.table.text, x.table.text
        );
        let diagnostic = Diagnostic::new(Code::WrongForm, message, y.table.span.clone(), "")
            .with_label(x.table.span.clone(), "");
        Err(self.mistakes.push(file, diagnostic))
    }

    /// Refuses curves that cannot share their axes.
    pub(in crate::scene) fn same_axes(
        &mut self,
        file: &File,
        id: ExprId,
        found: (Dimension, Dimension),
        first: &mut Option<(Dimension, Dimension, ExprId)>,
    ) -> Result<(), Reported> {
        match first {
            Some((y, x, _)) if (*y, *x) != found => {
                let message = format!(
                    "the first curve is {} over {}, but this is {} over {}",
                    y.describe(),
                    x.describe(),
                    found.0.describe(),
                    found.1.describe()
                );
                Err(self.mistakes.report(file, Code::MixedDimensions, file.span(id), message, "", None))
            }
            Some(_) => Ok(()),
            None => {
                *first = Some((found.0, found.1, id));
                Ok(())
            }
        }
    }
}

/// The elements of a list, or the one expression that is none.
pub(in crate::scene) fn listed(site: &Site) -> Vec<ExprId> {
    match &site.file.tree.expr(site.id).kind {
        ExprKind::List(ids) => ids.clone(),
        _ => vec![site.id],
    }
}

/// `table.column`.
pub(in crate::scene) fn column_name(
    mistakes: &mut Mistakes,
    file: &File,
    id: ExprId,
) -> Result<ColumnName, Reported> {
    if let ExprKind::Member { base, name } = &file.tree.expr(id).kind
        && let ExprKind::Name(table) = &file.tree.expr(*base).kind
    {
        let table = Name { text: table.clone(), span: file.span(*base) };
        return Ok(ColumnName { table, column: name.clone() });
    }
    let message = "a column of a record is required";
    let help = Some("write `record.column`".into());
    Err(mistakes.report(file, Code::WrongForm, file.span(id), message, "", help))
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
pub(super) fn table_dimension(
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
