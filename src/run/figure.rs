//! The plots of a scene or a drive, drawn from its tables.
//!
//! Owns the choice of what goes into a figure; drawing is the output layer's.

use crate::output::{Axis, Figure, Mark, Provenance, Scale, Series, Table};
use crate::scene::Plot;

/// Name and SVG text, or what was in the way, of every plot; `title` is the scene's or the drive's name.
pub fn figures(
    title: &str,
    plots: &[Plot],
    tables: &[Table],
    provenance: &Provenance,
) -> Vec<(String, Result<String, String>)> {
    let draw =
        |plot: &Plot| curves(title, plot, tables, provenance)?.to_svg().map_err(|cause| cause.to_string());
    plots.iter().map(|plot| (plot.name.clone(), draw(plot))).collect()
}

fn curves(title: &str, plot: &Plot, tables: &[Table], provenance: &Provenance) -> Result<Figure, String> {
    let mut figure = Figure {
        title: format!("{title}: {}", plot.name),
        provenance: provenance.lines(),
        ..Figure::default()
    };
    for curve in &plot.curves {
        let table = tables.iter().find(|table| table.name == curve.record);
        let columns = table.and_then(|t| Some((t, t.position(&curve.x)?, t.position(&curve.y)?)));
        let (table, x, y) =
            columns.ok_or_else(|| format!("no columns `{}` and `{}` were recorded", curve.x, curve.y))?;
        let axis = |at: usize| Axis {
            label: table.columns[at].name.clone(),
            unit: table.columns[at].unit.clone(),
            scale: Scale::Linear,
        };
        if figure.series.is_empty() {
            (figure.x, figure.y) = (axis(x), axis(y));
        }
        figure.series.push(Series {
            label: format!("{}.{}", curve.record, curve.y),
            points: table.rows.iter().map(|row| (row[x], row[y])).collect(),
            mark: Mark::Line,
            colour: None,
        });
    }
    for points in &plot.points {
        let column = |name: &str| {
            let found = points.reference.columns.iter().find(|(known, _)| known == name);
            found
                .map(|(_, values)| values)
                .ok_or_else(|| format!("{} has no column `{name}`", points.reference.path))
        };
        let (x, y) = (column(&points.x)?, column(&points.y)?);
        figure.series.push(Series {
            label: label(&points.reference.path),
            points: x.iter().copied().zip(y.iter().copied()).collect(),
            mark: Mark::Markers,
            colour: None,
        });
    }
    Ok(figure)
}

/// A reference's name in a legend: its file name without folder and ending.
fn label(path: &str) -> String {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    file.strip_suffix(".csv").unwrap_or(file).to_string()
}
