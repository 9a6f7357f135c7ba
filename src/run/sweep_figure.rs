//! The figures of a sweep, drawn from its tables.
//!
//! Owns what becomes one curve: rows that agree in every varied value but the one along the axis.

use super::trade::{Setting, settings};
use crate::output::{Axis, Figure, Mark, Provenance, Scale, Series, Slope, Table};
use crate::scene::{Sweep, SweepCurve, SweepPlot};

/// Name and SVG text, or what was in the way, of every plot.
pub fn sweep_figures(
    sweep: &Sweep,
    tables: &[Table],
    points: &[Vec<Table>],
    provenance: &Provenance,
) -> Vec<(String, Result<String, String>)> {
    let mut drawn: Vec<(String, Result<String, String>)> = Vec::new();
    for plot in &sweep.plots {
        let svg = figure(sweep, plot, tables, points, provenance)
            .and_then(|figure| figure.to_svg().map_err(|cause| cause.to_string()));
        drawn.push((plot.name.clone(), svg));
    }
    if sweep.trade.is_some() {
        let svg = pareto(sweep, tables, provenance)
            .and_then(|figure| figure.to_svg().map_err(|cause| cause.to_string()));
        drawn.push(("pareto".into(), svg));
    }
    drawn
}

fn figure(
    sweep: &Sweep,
    plot: &SweepPlot,
    tables: &[Table],
    points: &[Vec<Table>],
    provenance: &Provenance,
) -> Result<Figure, String> {
    let scale = |logarithmic| if logarithmic { Scale::Logarithmic } else { Scale::Linear };
    let mut figure = Figure {
        title: format!("{}: {}", sweep.name, plot.name),
        provenance: provenance.lines(),
        ..Figure::default()
    };
    for curve in &plot.curves {
        let (series, axes) =
            if curve.of_points { family(sweep, curve, points)? } else { own(sweep, curve, tables)? };
        if figure.series.is_empty() {
            let axis = |(label, unit): &(String, String), logarithmic| Axis {
                label: label.clone(),
                unit: unit.clone(),
                scale: scale(logarithmic),
                range: None,
            };
            figure.x = axis(&axes[0], plot.logarithmic.0);
            figure.y = axis(&axes[1], plot.logarithmic.1);
        }
        figure.series.extend(series);
    }
    if plot.logarithmic.1 {
        // The magnitude of an error is what a logarithmic axis shows.
        figure.series.iter_mut().flat_map(|s| &mut s.points).for_each(|point| point.1 = point.1.abs());
    }
    figure.slopes.extend(plot.slope.map(|order| Slope { series: 0, order }));
    Ok(figure)
}

/// Label and unit of abscissa and ordinate.
type Axes = [(String, String); 2];

/// One curve a point, over a record of the scene or drive.
fn family(sweep: &Sweep, curve: &SweepCurve, points: &[Vec<Table>]) -> Result<(Vec<Series>, Axes), String> {
    let mut series = Vec::new();
    let mut axes = None;
    for (point, tables) in sweep.points.iter().zip(points) {
        let (table, x, y) = columns(tables, curve)?;
        axes.get_or_insert_with(|| axes_of(table, x, y));
        series.push(Series {
            label: label(sweep, &point.at, |_| true),
            points: table.rows.iter().map(|row| (row[x], row[y])).collect(),
            mark: Mark::Line,
            colour: None,
        });
    }
    Ok((series, axes.ok_or("there is no point")?))
}

/// Columns of the sweep's own table: one curve for each combination of the values off the abscissa.
fn own(sweep: &Sweep, curve: &SweepCurve, tables: &[Table]) -> Result<(Vec<Series>, Axes), String> {
    let (table, x, y) = columns(tables, curve)?;
    let along = sweep.varied.iter().position(|varied| varied.column == curve.x).unwrap_or(0);
    let mut series: Vec<(Vec<f64>, Series)> = Vec::new();
    for row in &table.rows {
        let key: Vec<f64> = (0..sweep.varied.len()).filter(|i| *i != along).map(|i| row[i]).collect();
        let point = (row[x], row[y]);
        if let Some((_, found)) = series.iter_mut().find(|(known, _)| *known == key) {
            found.points.push(point);
            continue;
        }
        let at: Vec<usize> = sweep
            .varied
            .iter()
            .zip(row)
            .map(|(varied, value)| varied.values.iter().position(|v| v.value == *value).unwrap_or(0))
            .collect();
        let others = label(sweep, &at, |i| i != along);
        let name = if others.is_empty() { curve.y.clone() } else { format!("{}, {others}", curve.y) };
        let new = Series { label: name, points: vec![point], mark: Mark::LineMarkers, colour: None };
        series.push((key, new));
    }
    Ok((series.into_iter().map(|(_, series)| series).collect(), axes_of(table, x, y)))
}

fn columns<'a>(tables: &'a [Table], curve: &SweepCurve) -> Result<(&'a Table, usize, usize), String> {
    let table = tables.iter().find(|table| table.name == curve.record);
    let found = table.and_then(|t| Some((t, t.position(&curve.x)?, t.position(&curve.y)?)));
    found.ok_or_else(|| format!("no columns `{}` and `{}` were recorded", curve.x, curve.y))
}

fn axes_of(table: &Table, x: usize, y: usize) -> Axes {
    [x, y].map(|at| (table.columns[at].name.clone(), table.columns[at].unit.clone()))
}

/// `kappa = 0.226, spacing = 0.5 mm` of the varied values that are wanted.
fn label(sweep: &Sweep, at: &[usize], wanted: impl Fn(usize) -> bool) -> String {
    let named = sweep.varied.iter().zip(at).enumerate().filter(|(index, _)| wanted(*index));
    let parts: Vec<String> =
        named.map(|(_, (varied, &at))| format!("{} = {}", varied.column, varied.values[at].text)).collect();
    parts.join(", ")
}

/// Error over cost, the settings no other beats in both joined by a line.
fn pareto(sweep: &Sweep, tables: &[Table], provenance: &Provenance) -> Result<Figure, String> {
    let trade = sweep.trade.as_ref().ok_or("no trade")?;
    let table = tables.first().ok_or("no table")?;
    let settings = settings(sweep, table);
    let place = |setting: &Setting| (setting.cost, setting.error);
    let on_front = settings.iter().filter(|setting| setting.on_front);
    let mut front: Vec<(f64, f64)> = on_front.map(place).collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    let others: Vec<(f64, f64)> = settings.iter().filter(|s| !s.on_front).map(place).collect();
    let axis = |label: &str, unit: &str| Axis {
        label: label.into(),
        unit: unit.into(),
        scale: Scale::Logarithmic,
        range: None,
    };
    let mut series = vec![Series {
        label: "beaten by no other".into(),
        points: front,
        mark: Mark::LineMarkers,
        colour: Some(0),
    }];
    if !others.is_empty() {
        series.push(Series { label: "beaten".into(), points: others, mark: Mark::Markers, colour: Some(1) });
    }
    Ok(Figure {
        title: format!("{}: error against cost", sweep.name),
        x: axis(&trade.cost.replace('_', " "), ""),
        y: axis("error", &trade.unit),
        series,
        bands: Vec::new(),
        slopes: Vec::new(),
        provenance: provenance.lines(),
    })
}
