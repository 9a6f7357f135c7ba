//! The numbers a picture shows, as tables.
//!
//! Owns what is kept: points of curves, the outer faces of bodies with their values, outlines.

use super::point::both;
use super::results::Results;
use crate::output::figure::outer_faces;
use crate::output::{Frame, Table, TableColumn};
use crate::run::interpolate::crossing;
use crate::scene::{FieldPanel, FieldPicture, FigureOf, Moment, Plot, SeriesData};
use std::collections::BTreeMap;

/// Significant digits of a curve's points.
const CURVE_DIGITS: usize = 10;
/// Significant digits of positions and values of fields.
const FIELD_DIGITS: usize = 6;

/// The tables of every plot of a figure, named after the plots.
///
/// # Errors
/// What is missing among the results.
pub fn extract_figure(figure: &FigureOf, results: &Results) -> Result<Vec<Table>, String> {
    let mut tables = Vec::new();
    for plot in &figure.plots {
        tables.extend(extract(plot, results).map_err(|cause| format!("plot `{}`: {cause}", plot.name))?);
    }
    Ok(tables)
}

/// The names of the tables of every plot of a figure, in the order of [`extract_figure`].
pub fn table_names(figure: &FigureOf) -> Vec<String> {
    let of = |plot: &Plot| -> Vec<String> {
        let suffixes: &[&str] = match (&plot.picture.fields, &plot.picture.drawing) {
            (Some(_), _) => &["_points", "_faces"],
            (None, Some(_)) => &["_outlines"],
            (None, None) => &[""],
        };
        suffixes.iter().map(|suffix| format!("{}{suffix}", plot.name)).collect()
    };
    figure.plots.iter().flat_map(of).collect()
}

/// The tables of a plot: everything that is drawn, so that it can be drawn again from them alone.
///
/// # Errors
/// What is missing among the results.
pub fn extract(plot: &Plot, results: &Results) -> Result<Vec<Table>, String> {
    match (&plot.picture.fields, &plot.picture.drawing) {
        (Some(fields), _) => field_tables(&plot.name, fields, results),
        (None, Some(drawing)) => {
            let columns = vec![
                TableColumn::new("outline", "", "number of the closed outline"),
                TableColumn::new("x", "m", "to the right"),
                TableColumn::new("y", "m", "upwards"),
            ];
            let rows = drawing.outlines.iter().enumerate().flat_map(|(i, outline)| {
                outline
                    .iter()
                    .map(move |[x, y]| vec![i as f64, rounded(*x, CURVE_DIGITS), rounded(*y, CURVE_DIGITS)])
            });
            Ok(vec![table(&format!("{}_outlines", plot.name), columns, rows.collect(), results.provenance())])
        }
        (None, None) => Ok(vec![curve_table(plot, results)?]),
    }
}

fn table(name: &str, columns: Vec<TableColumn>, rows: Vec<Vec<f64>>, provenance: Vec<String>) -> Table {
    Table { name: name.into(), columns, rows, provenance }
}

/// `value` to a number of significant digits.
fn rounded(value: f64, digits: usize) -> f64 {
    // a number written by the formatter reads back
    format!("{:.*e}", digits - 1, value).parse().unwrap_or(value)
}

/// Where the numbers of the series of a plot are from, in the order they are drawn.
pub(super) fn all_series(plot: &Plot) -> Vec<SeriesData> {
    let curves = plot.curves.iter().map(|curve| SeriesData::Record {
        record: curve.record.clone(),
        y: curve.y.clone(),
        x: curve.x.clone(),
    });
    let points = plot.points.iter().map(|points| SeriesData::Reference {
        reference: points.reference.clone(),
        y: points.y.clone(),
        x: points.x.clone(),
    });
    curves.chain(points).chain(plot.picture.series.iter().map(|series| series.data.clone())).collect()
}

fn curve_table(plot: &Plot, results: &Results) -> Result<Table, String> {
    let mut rows = Vec::new();
    let mut units: Option<(String, String)> = None;
    for (number, data) in all_series(plot).iter().enumerate() {
        let points: Vec<(f64, f64)> = match data {
            SeriesData::Record { record, y, x } => {
                let table = results.table(record);
                let found = table.and_then(|t| Some((t, t.position(x)?, t.position(y)?)));
                let (table, x, y) =
                    found.ok_or_else(|| format!("no columns `{x}` and `{y}` of `{record}` were recorded"))?;
                let unit = |at: usize| table.columns[at].unit.clone();
                units.get_or_insert_with(|| (unit(x), unit(y)));
                table.rows.iter().map(|row| (row[x], row[y])).collect()
            }
            SeriesData::Reference { reference, y, x } => {
                let column = |name: &str| {
                    let found = reference.columns.iter().find(|(known, _)| known == name);
                    let missing = || format!("{} has no column `{name}`", reference.path);
                    found.map(|(_, values)| values).ok_or_else(missing)
                };
                column(x)?.iter().copied().zip(column(y)?.iter().copied()).collect()
            }
            SeriesData::Points { points, units: [x, y] } => {
                units.get_or_insert_with(|| (x.clone(), y.clone()));
                let read = |point| both(point, results);
                points.iter().map(read).collect::<Result<_, _>>()?
            }
        };
        // a reference may have cells without a number
        let points = points.into_iter().filter(|(x, y)| x.is_finite() && y.is_finite());
        let digits = |value| rounded(value, CURVE_DIGITS);
        rows.extend(points.map(|(x, y)| vec![number as f64, digits(x), digits(y)]));
    }
    let (x_unit, y_unit) = units.unwrap_or_default();
    let columns = vec![
        TableColumn::new("series", "", "number of the curve, in the order drawn"),
        TableColumn::new("x", &x_unit, plot.picture.x_label.as_deref().unwrap_or("abscissa")),
        TableColumn::new("y", &y_unit, plot.picture.y_label.as_deref().unwrap_or("ordinate")),
    ];
    Ok(table(&plot.name, columns, rows, results.provenance()))
}

fn field_tables(name: &str, picture: &FieldPicture, results: &Results) -> Result<Vec<Table>, String> {
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    let mut provenance = results.provenance();
    for (number, panel) in picture.panels.iter().enumerate() {
        let frame = results.frame(&panel.frames, moment(panel, results)?)?;
        provenance.push(format!("panel {number}: {} at t = {:e} s", panel.frames, frame.time));
        surface(number, picture, &frame, &mut points, &mut faces)?;
    }
    let panel = || TableColumn::new("panel", "", "number of the panel");
    let (kept, _) = picture.field.stored();
    let point_columns = vec![
        panel(),
        TableColumn::new("x", "m", "current position"),
        TableColumn::new("y", "m", "current position"),
        TableColumn::new("z", "m", "current position"),
        TableColumn::new("value", &picture.unit, kept),
    ];
    let corner = |name: &str| TableColumn::new(name, "", "corner: number of the point in its panel");
    let face_columns = vec![panel(), corner("a"), corner("b"), corner("c"), corner("d")];
    Ok(vec![
        table(&format!("{name}_points"), point_columns, points, provenance.clone()),
        table(&format!("{name}_faces"), face_columns, faces, provenance),
    ])
}

/// The time of a panel, `None` for the last frame.
fn moment(panel: &FieldPanel, results: &Results) -> Result<Option<f64>, String> {
    match &panel.moment {
        Moment::Last => Ok(None),
        Moment::Time(time) => Ok(Some(*time)),
        Moment::When { record, column, value } => {
            let table = results.table(record).ok_or_else(|| format!("nothing was recorded as `{record}`"))?;
            let values = |name: &str| table.column(name).unwrap_or_default();
            let first = table.columns.first().map_or("", |column| column.name.as_str());
            let time = crossing(&values(column), &values(first), *value);
            match time {
                Some(time) => Ok(Some(time)),
                None if results.short => Ok(None),
                None => Err(format!("`{record}.{column}` never takes the value {value:e}")),
            }
        }
    }
}

/// Adds the points and faces of the surface of a frame.
fn surface(
    number: usize,
    picture: &FieldPicture,
    frame: &Frame,
    points: &mut Vec<Vec<f64>>,
    faces: &mut Vec<Vec<f64>>,
) -> Result<(), String> {
    let (name, component) = picture.field.stored();
    let positions = frame.positions();
    let values: Vec<f64> = match frame.field(name) {
        Some(field) => field.values.iter().skip(component).step_by(field.components).copied().collect(),
        None if name == "displacement" => frame.displacement.iter().map(|u| u[component]).collect(),
        None => return Err(format!("the frame does not hold `{name}`")),
    };
    let outer = outer_faces(&frame.hexahedra);
    let used: BTreeMap<usize, usize> = {
        let mut corners: Vec<usize> = outer.iter().flatten().copied().collect();
        corners.sort_unstable();
        corners.dedup();
        corners.into_iter().enumerate().map(|(new, old)| (old, new)).collect()
    };
    let digits = |value: f64| rounded(value, FIELD_DIGITS);
    for &old in used.keys() {
        let x = positions[old];
        points.push(vec![number as f64, digits(x.x), digits(x.y), digits(x.z), digits(values[old])]);
    }
    for face in &outer {
        let corner = |i: usize| used[&face[i.min(face.len() - 1)]] as f64;
        faces.push(vec![number as f64, corner(0), corner(1), corner(2), corner(3)]);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_to_their_significant_digits() {
        assert_eq!(rounded(-1.234_567_89e-5, 6), -1.23457e-5);
        assert_eq!((rounded(0.0, 6), rounded(2.0, 10)), (0.0, 2.0));
    }
}
