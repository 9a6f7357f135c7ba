//! `plot` of a sweep.

use super::super::file::Reported;
use super::super::members::Members;
use super::super::model::{SweepCurve, SweepPlot, Swept};
use super::super::scenes::{Stage, column_dimension, listed};
use super::super::words::SWEEP_PLOT;
use super::record::columns;
use crate::syntax::{Block, Code, ExprId};
use crate::unit::Dimension;
use std::rc::Rc;

/// Reads every plot of a sweep, whose own columns are known to the stage.
pub(super) fn read(stage: &mut Stage, members: &Members, swept: &Swept) -> Vec<SweepPlot> {
    let points = columns(swept);
    let names: Vec<String> = points.keys().cloned().collect();
    for (name, columns) in points {
        stage.columns.entry(name).or_insert(columns);
    }
    let blocks = members.blocks.iter().filter(|block| block.kind.text == "plot");
    blocks.filter_map(|block| one(stage, block, &names).ok()).collect()
}

fn one(stage: &mut Stage, block: &Block, of_points: &[String]) -> Result<SweepPlot, Reported> {
    let name = stage.output_name(block)?;
    let file = Rc::clone(&stage.file);
    let members = Members::read(stage.mistakes, &file, &SWEEP_PLOT, block);
    let logarithmic = stage.scale(&members, &SWEEP_PLOT)?;
    let slope = match members.written("slope") {
        Some(site) => {
            let order = stage.constant(site, "slope", Dimension::NUMBER)?;
            let refused = match (logarithmic, order) {
                ((true, true), order) if order != 0.0 => None,
                ((true, true), _) => Some("a slope of 0 needs no triangle"),
                _ => Some("a slope is an order only where both axes are logarithmic"),
            };
            if let Some(message) = refused {
                let help = Some("write `scale = log_log  slope = 2`".into());
                let span = site.file.span(site.id);
                return Err(stage.mistakes.report(&site.file, Code::WrongForm, span, message, "", help));
            }
            Some(order)
        }
        None => None,
    };
    let site = members.required(stage.mistakes, &file, &SWEEP_PLOT, block, "curve")?;
    let mut curves = Vec::new();
    let mut dimensions: Option<(Dimension, Dimension, ExprId)> = None;
    for id in listed(&site) {
        let (y, x) = stage.pair(&site.file, id)?;
        stage.same_source(&site.file, &y, &x)?;
        let found = (
            column_dimension(stage.mistakes, &stage.columns, &site.file, &y)?,
            column_dimension(stage.mistakes, &stage.columns, &site.file, &x)?,
        );
        stage.same_axes(&site.file, id, found, &mut dimensions)?;
        let of_points = of_points.contains(&y.table.text);
        curves.push(SweepCurve { record: y.table.text, y: y.column.text, x: x.column.text, of_points });
    }
    Ok(SweepPlot { name: name.text, curves, logarithmic, slope })
}
