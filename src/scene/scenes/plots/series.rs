//! `series` and `band`.

use super::super::super::file::Reported;
use super::super::super::members::{Members, Site};
use super::super::super::model::{DrawnBand, DrawnSeries, Look, SeriesData};
use super::super::super::words::{BAND, SERIES};
use super::super::stage::Stage;
use super::{Axes, columns};
use crate::schema::{Declaration, Kind};
use crate::syntax::{BinaryOperator, Block, Code, ExprKind};
use crate::unit::Dimension;
use std::rc::Rc;

impl Stage<'_> {
    pub(super) fn series(&mut self, block: &Block, axes: &mut Axes) -> Result<DrawnSeries, Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &SERIES, block);
        let (data, is_table) = self.data(block, &members, axes)?;
        let look = match members.written("mark") {
            Some(site) => look(self.choice(site, &SERIES, "mark")?),
            None if is_table => Look::Markers,
            None => Look::Line,
        };
        let colour = self.colour(&members, &SERIES)?;
        let label = self.text(&members, "label")?.unwrap_or_default();
        Ok(DrawnSeries { data, label, look, colour })
    }

    /// What a series shows, and whether that is single points rather than a run's course.
    fn data(
        &mut self,
        block: &Block,
        members: &Members,
        axes: &mut Axes,
    ) -> Result<(SeriesData, bool), Reported> {
        let file = Rc::clone(&self.file);
        let site = match (members.written("draw"), members.written("points")) {
            (Some(site), None) => site,
            (None, Some(site)) => {
                let (points, units) = self.shown(site, axes)?;
                return Ok((SeriesData::Points { points, units }, true));
            }
            (found, _) => {
                let (code, message) = match found {
                    Some(_) => (Code::Conflict, "a series has either `draw` or `points`"),
                    None => (Code::MissingKey, "the series shows nothing"),
                };
                let help = "write `draw = record.y over record.x`, or `points = [[x, y]]` with numbers read from tables";
                let span = block.kind.span.clone();
                return Err(self.mistakes.report(&file, code, span, message, "", Some(help.into())));
            }
        };
        // a table read with csv(…) is known by one name; anything else is a record
        let is_table = match &file.tree.expr(site.id).kind {
            ExprKind::Binary { operator: BinaryOperator::Over, left, .. } => {
                columns::column_name(self.mistakes, &file, *left)
                    .is_ok_and(|name| self.tables.contains_key(&name.table.text))
            }
            _ => false,
        };
        let data = if is_table {
            let (reference, y, x) = self.tabulated(&file, site.id, axes)?;
            SeriesData::Reference { reference, y, x }
        } else {
            let (y, x) = self.recorded(&file, site.id, axes)?;
            SeriesData::Record { record: y.table.text, y: y.column.text, x: x.column.text }
        };
        Ok((data, is_table))
    }

    /// The number of the colour chosen, if one is.
    pub(super) fn colour(
        &mut self,
        members: &Members,
        declaration: &Declaration,
    ) -> Result<Option<usize>, Reported> {
        let Some(site) = members.written("colour") else { return Ok(None) };
        let word = self.choice(site, declaration, "colour")?;
        let Some(Kind::Choice(choices)) = declaration.key("colour").map(|key| key.kind) else {
            return Ok(None);
        };
        Ok(choices.iter().position(|choice| choice.word == word))
    }

    pub(super) fn band(&mut self, block: &Block, axes: Axes) -> Result<DrawnBand, Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &BAND, block);
        let Some((y, x, _)) = axes else {
            let message = "a band lies behind curves, but the plot has none";
            return Err(self.mistakes.report(
                &file,
                Code::MissingKey,
                block.kind.span.clone(),
                message,
                "",
                None,
            ));
        };
        let site = members.required(self.mistakes, &file, &BAND, block, "corners")?;
        let corners = self.places(&site, "corners", [x, y])?;
        let colour = self.colour(&members, &BAND)?.unwrap_or(BLACK);
        Ok(DrawnBand { label: self.text(&members, "label")?.unwrap_or_default(), corners, colour })
    }

    /// A list of at least three pairs.
    fn places(
        &mut self,
        site: &Site,
        key: &str,
        dimensions: [Dimension; 2],
    ) -> Result<Vec<(f64, f64)>, Reported> {
        let ids = match &site.file.tree.expr(site.id).kind {
            ExprKind::List(ids) if ids.len() > 2 => ids.clone(),
            _ => {
                let message = format!("`{key}` is a list of at least three corners");
                let help = Some("write `[[x, y], [x, y], [x, y]]`".into());
                let span = site.file.span(site.id);
                return Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", help));
            }
        };
        let mut places = Vec::new();
        for id in ids {
            let [x, y] = self.pair_of(&site.file, id, key, dimensions)?;
            places.push((x, y));
        }
        Ok(places)
    }
}

/// Its number in the palette.
const BLACK: usize = 6;

fn look(word: &str) -> Look {
    match word {
        "dashed" => Look::Dashed,
        "markers" => Look::Markers,
        "line_markers" => Look::LineMarkers,
        _ => Look::Line,
    }
}
