//! `plot`: curves of columns, fields on bodies, drawings.
//!
//! Owns the reading of the block and its curves; what its inner blocks say is read in the neighbouring
//! files.

mod columns;
mod drawing;
mod fields;
mod series;
mod shown;

use super::super::blocks::unknown_block;
use super::super::file::{File, Reported};
use super::super::members::{Members, Site};
use super::super::model::{Curve, Picture, Plot, ReferenceCurve};
use super::super::words::PLOT;
use super::stage::Stage;
use crate::schema::Declaration;
use crate::syntax::{BinaryOperator, Block, Code, Diagnostic, ExprId, ExprKind};
use crate::unit::Dimension;
pub(in crate::scene) use columns::{ColumnName, column_dimension, column_name, dotted, table_dimension};
use std::rc::Rc;

/// Dimensions of ordinate and abscissa, and the curve that settled them.
pub(in crate::scene) type Axes = Option<(Dimension, Dimension, ExprId)>;

impl Stage<'_> {
    pub(in crate::scene) fn plot(&mut self, block: &Block) -> Result<(), Reported> {
        let name = self.output_name(block)?;
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &PLOT, block);
        let mut axes: Axes = None;
        let mut curves = Vec::new();
        for id in members.written("curve").map(listed).unwrap_or_default() {
            let (y, x) = self.recorded(&file, id, &mut axes)?;
            curves.push(Curve { record: y.table.text, y: y.column.text, x: x.column.text });
        }
        let mut points = Vec::new();
        for id in members.written("points").map(listed).unwrap_or_default() {
            let (reference, y, x) = self.tabulated(&file, id, &mut axes)?;
            points.push(ReferenceCurve { reference, y, x });
        }
        let mut picture = Picture {
            title: self.text(&members, "title")?,
            x_label: self.text(&members, "x_label")?,
            y_label: self.text(&members, "y_label")?,
            ..Picture::default()
        };
        for inner in &members.blocks {
            match inner.kind.text.as_str() {
                "series" => picture.series.push(self.series(inner, &mut axes)?),
                "band" | "panel" | "outline" | "disc" | "dimension" | "note" => {}
                _ => {
                    unknown_block(self.mistakes, &file, inner, Some(PLOT.word));
                    return Err(Reported);
                }
            }
        }
        for inner in members.blocks.iter().filter(|inner| inner.kind.text == "band") {
            picture.bands.push(self.band(inner, axes)?);
        }
        let (y, x) = axes.map_or((Dimension::NUMBER, Dimension::NUMBER), |(y, x, _)| (y, x));
        picture.x_range = self.range(&members, "x_range", x)?;
        picture.y_range = self.range(&members, "y_range", y)?;
        picture.logarithmic = self.scale(&members, &PLOT)?;
        picture.fields = self.fields_of(block, &members)?;
        picture.drawing = self.drawing(&members)?;
        let kinds = [axes.is_some(), picture.fields.is_some(), picture.drawing.is_some()];
        if kinds.iter().filter(|kind| **kind).count() != 1 {
            let message = match kinds.contains(&true) {
                true => "a plot shows curves, or panels, or a drawing, but not several of them",
                false => "the plot shows nothing",
            };
            let help = "write `curve = record.y over record.x`, `panel name { … }` with `field = …`, or `outline name { … }`";
            let span = block.kind.span.start..name.span.end;
            return Err(self.mistakes.report(&file, Code::MissingKey, span, message, "", Some(help.into())));
        }
        let place = file.place(&block.kind.span);
        self.scene.plots.push(Plot { name: name.text, place, curves, points, picture });
        Ok(())
    }

    /// Whether the abscissa and the ordinate of a plot are logarithmic.
    pub(in crate::scene) fn scale(
        &mut self,
        members: &Members,
        of: &'static Declaration,
    ) -> Result<(bool, bool), Reported> {
        let scale = match members.written("scale") {
            Some(site) => self.choice(site, of, "scale")?,
            None => "linear",
        };
        Ok((matches!(scale, "log_log" | "log_x"), matches!(scale, "log_log" | "log_y")))
    }

    /// The text of a key, if it is written.
    pub(in crate::scene) fn text(
        &mut self,
        members: &Members,
        key: &str,
    ) -> Result<Option<String>, Reported> {
        let Some(site) = members.written(key) else { return Ok(None) };
        match &site.file.tree.expr(site.id).kind {
            ExprKind::Text(text) => Ok(Some(text.clone())),
            _ => {
                let message = format!("`{key}` is a text in quotes");
                let help = Some(format!("write `{key} = \"…\"`"));
                let span = site.file.span(site.id);
                Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", help))
            }
        }
    }

    /// Two ends `[low, high]`, if they are written.
    fn range(
        &mut self,
        members: &Members,
        key: &str,
        dimension: Dimension,
    ) -> Result<Option<(f64, f64)>, Reported> {
        let Some(site) = members.written(key) else { return Ok(None) };
        let [low, high] = self.pair_of(&site.file, site.id, key, [dimension; 2])?;
        if low < high {
            return Ok(Some((low, high)));
        }
        let message = format!("`{key}` must reach upwards");
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "", None))
    }

    /// A list of two values.
    fn pair_of(
        &mut self,
        file: &Rc<File>,
        id: ExprId,
        key: &str,
        dimensions: [Dimension; 2],
    ) -> Result<[f64; 2], Reported> {
        let ExprKind::List(ids) = &file.tree.expr(id).kind else {
            return Err(self.not_two(file, id, key));
        };
        let &[a, b] = ids.as_slice() else { return Err(self.not_two(file, id, key)) };
        let mut values = [0.0; 2];
        for ((value, id), dimension) in values.iter_mut().zip([a, b]).zip(dimensions) {
            *value = self.constant(&Site { file: Rc::clone(file), id }, key, dimension)?;
        }
        Ok(values)
    }

    fn not_two(&mut self, file: &File, id: ExprId, key: &str) -> Reported {
        let message = format!("`{key}` is a list of two values");
        self.mistakes.report(file, Code::WrongForm, file.span(id), message, "", None)
    }

    /// A whole number of at least one, if it is written.
    pub(in crate::scene) fn count(&mut self, site: &Site, key: &str) -> Result<u32, Reported> {
        let value = self.constant(site, key, Dimension::NUMBER)?;
        if (1.0..=1000.0).contains(&value) && value.fract() == 0.0 {
            // whole and at most a thousand
            return Ok(value as u32);
        }
        let message = format!("`{key}` must be a whole number from 1 to 1000");
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "", None))
    }

    /// Columns of one record that can share the axes of the plot.
    fn recorded(
        &mut self,
        file: &File,
        id: ExprId,
        axes: &mut Axes,
    ) -> Result<(ColumnName, ColumnName), Reported> {
        let (y, x) = self.pair(file, id)?;
        self.same_source(file, &y, &x)?;
        let found = (
            column_dimension(self.mistakes, &self.columns, file, &y)?,
            column_dimension(self.mistakes, &self.columns, file, &x)?,
        );
        self.same_axes(file, id, found, axes)?;
        Ok((y, x))
    }

    /// Columns of a table from a file that can share the axes of the plot.
    fn tabulated(
        &mut self,
        file: &File,
        id: ExprId,
        axes: &mut Axes,
    ) -> Result<(super::super::model::Reference, String, String), Reported> {
        let (y, x) = self.pair(file, id)?;
        self.same_source(file, &y, &x)?;
        let found = (
            table_dimension(self.mistakes, &self.tables, file, &y)?,
            table_dimension(self.mistakes, &self.tables, file, &x)?,
        );
        self.same_axes(file, id, found, axes)?;
        let table = self.tables.get(&y.table.text).cloned().flatten().ok_or(Reported)?;
        Ok((table.reference.clone(), y.column.text, x.column.text))
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
        first: &mut Axes,
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
