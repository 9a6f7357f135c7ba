//! The figures of a fit: data with the fitted curves, and the residuals.
//!
//! Columns over the same parameter in the same unit share a figure.

use super::super::error::RunError;
use super::response::{Measured, Model};
use crate::fit::Minimum;
use crate::output::{Axis, Figure, Mark, Provenance, Scale, Series};
use crate::scene::Fit;

/// Points of a fitted curve.
const POINTS: u32 = 120;

/// Columns that share axes.
struct Group<'a> {
    parameter: &'a str,
    parameter_unit: &'a str,
    unit: &'a str,
    columns: Vec<&'a Measured>,
}

/// Every figure by its file name.
pub(super) fn draw(
    fit: &Fit,
    measured: &[Measured],
    model: &Model<'_>,
    minimum: &Minimum,
    deviation: f64,
    provenance: &Provenance,
) -> Result<Vec<(String, String)>, RunError> {
    let groups = groups(fit, measured);
    let mut figures = Vec::new();
    for (index, group) in groups.iter().enumerate() {
        let suffix = if index == 0 { String::new() } else { format!("_{}", index + 1) };
        let curves = curves(fit, group, model, minimum, provenance);
        let residuals = residuals(fit, group, deviation, provenance);
        for (name, figure) in [("fit", curves), ("residuals", residuals)] {
            let file = format!("{name}{suffix}.svg");
            let svg = figure.to_svg().map_err(|cause| RunError::Figure { name: file.clone(), cause })?;
            figures.push((file, svg));
        }
    }
    Ok(figures)
}

fn groups<'a>(fit: &'a Fit, measured: &'a [Measured]) -> Vec<Group<'a>> {
    let mut groups: Vec<Group<'a>> = Vec::new();
    for column in measured {
        let drive = &fit.sets[column.set].drive;
        let known = groups.iter_mut().find(|group| {
            group.parameter == drive.parameter
                && group.parameter_unit == drive.unit
                && group.unit == column.unit
        });
        match known {
            Some(group) => group.columns.push(column),
            None => groups.push(Group {
                parameter: &drive.parameter,
                parameter_unit: &drive.unit,
                unit: &column.unit,
                columns: vec![column],
            }),
        }
    }
    groups
}

/// `tension: P.xx`, or only what differs within the figure.
fn label(column: &Measured, group: &Group<'_>) -> String {
    let alike = group.columns.iter().all(|other| other.name == column.name);
    if alike { column.drive.clone() } else { format!("{}: {}", column.drive, column.name) }
}

fn ordinate(group: &Group<'_>) -> String {
    let first = &group.columns[0].name;
    if group.columns.iter().all(|column| column.name == *first) { first.clone() } else { "measured".into() }
}

fn curves(
    fit: &Fit,
    group: &Group<'_>,
    model: &Model<'_>,
    minimum: &Minimum,
    provenance: &Provenance,
) -> Figure {
    let mut figure = Figure {
        title: format!("{}: data and fit", fit.name),
        x: axis(group.parameter, group.parameter_unit),
        y: axis(&ordinate(group), group.unit),
        provenance: provenance.lines(),
        ..Figure::default()
    };
    for (number, column) in group.columns.iter().enumerate() {
        let set = &fit.sets[column.set];
        let place = set.columns.iter().position(|known| known.name == column.name).unwrap_or(0);
        let (Some(first), Some(last)) = (column.rows.first(), column.rows.last()) else { continue };
        let step = (last.at - first.at) / f64::from(POINTS);
        let at: Vec<f64> = (0..=POINTS)
            .map(|i| if i == POINTS { last.at } else { first.at + f64::from(i) * step })
            .collect();
        // A curve that cannot be followed between the data is left out; the data are still shown.
        let values = model.curve(column.set, &minimum.parameters, &at).unwrap_or_default();
        figure.series.push(Series {
            label: label(column, group),
            points: at.into_iter().zip(values.iter().map(|row| row[place])).collect(),
            mark: Mark::Line,
            colour: Some(number),
        });
        figure.series.push(Series {
            label: String::new(),
            points: column.rows.iter().map(|row| (row.at, row.datum)).collect(),
            mark: Mark::Markers,
            colour: Some(number),
        });
    }
    figure
}

fn residuals(fit: &Fit, group: &Group<'_>, deviation: f64, provenance: &Provenance) -> Figure {
    // Data that fit exactly have no deviation to be measured by.
    let scale = if deviation > 0.0 { deviation } else { 1.0 };
    let rows = || group.columns.iter().flat_map(|column| &column.rows);
    let low = rows().map(|row| row.at).fold(f64::INFINITY, f64::min);
    let high = rows().map(|row| row.at).fold(f64::NEG_INFINITY, f64::max);
    let mut figure = Figure {
        title: format!("{}: residuals", fit.name),
        x: axis(group.parameter, group.parameter_unit),
        y: axis("residual in standard deviations", ""),
        provenance: provenance.lines(),
        ..Figure::default()
    };
    for (number, column) in group.columns.iter().enumerate() {
        figure.series.push(Series {
            label: label(column, group),
            points: column.rows.iter().map(|row| (row.at, row.residual() / scale)).collect(),
            mark: Mark::Markers,
            colour: Some(number),
        });
    }
    figure.series.push(Series {
        label: String::new(),
        points: vec![(low, 0.0), (high, 0.0)],
        mark: Mark::Dashed,
        colour: Some(group.columns.len()),
    });
    figure
}

fn axis(label: &str, unit: &str) -> Axis {
    Axis { label: label.into(), unit: unit.into(), scale: Scale::Linear, ..Axis::default() }
}
