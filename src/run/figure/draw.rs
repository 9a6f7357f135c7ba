//! Pictures from their own tables.
//!
//! Owns the way from the rows of a plot's tables to what the output layer draws.

use super::extract::all_series;
use crate::output::{
    Axis, Band, Dimension, FieldFigure, Figure, Mark, Note, Panel, Patch, Scale, Series, Sketch, Table, View,
    sheet,
};
use crate::scene::{Drawing, FieldPicture, FigureOf, Look, Plot, SeriesData, Viewpoint};
use crate::tensor::Vec3;

/// A figure as SVG from the tables of its plots.
///
/// # Errors
/// What is missing among the tables, or why they cannot be drawn.
pub fn draw_figure(figure: &FigureOf, tables: &[Table]) -> Result<String, String> {
    let mut pictures = Vec::new();
    for plot in &figure.plots {
        pictures.push(draw(plot, "", tables).map_err(|cause| format!("plot `{}`: {cause}", plot.name))?);
    }
    let provenance = tables.first().map(|table| table.provenance.clone()).unwrap_or_default();
    sheet(&figure.title, &provenance, &pictures, figure.columns).map_err(|cause| cause.to_string())
}

/// A plot as SVG from its tables; `title` stands above it where the plot has none of its own.
///
/// # Errors
/// What is missing among the tables, or why they cannot be drawn.
pub fn draw(plot: &Plot, title: &str, tables: &[Table]) -> Result<String, String> {
    let title = plot.picture.title.as_deref().unwrap_or(title);
    let find = |suffix: &str| {
        let name = format!("{}{suffix}", plot.name);
        tables.iter().find(|table| table.name == name).ok_or_else(|| format!("there is no table `{name}`"))
    };
    let drawn = match (&plot.picture.fields, &plot.picture.drawing) {
        (Some(fields), _) => fields_of(fields, title, find("_points")?, find("_faces")?)?.to_svg(),
        (None, Some(drawing)) => sketch(drawing, title, find("_outlines")?)?.to_svg(),
        (None, None) => curves(plot, title, find("")?)?.to_svg(),
    };
    drawn.map_err(|cause| cause.to_string())
}

/// The rows of a table whose first column is `number`.
fn rows_of(table: &Table, number: usize) -> impl Iterator<Item = &Vec<f64>> {
    table.rows.iter().filter(move |row| row.first() == Some(&(number as f64)))
}

/// Whether a table, which may have been edited, has its columns, their units and no row of what is not drawn.
fn complete(table: &Table, columns: usize, drawn: usize) -> Result<(), String> {
    let name = &table.name;
    if table.columns.len() != columns || table.rows.iter().any(|row| row.len() != columns) {
        return Err(format!("the table `{name}` has not {columns} columns"));
    }
    if let Some(column) = table.columns.iter().find(|column| column.text.is_empty()) {
        let column = &column.name;
        return Err(format!(
            "the table `{name}` has no line `# column {column} [unit] description` for its column `{column}`"
        ));
    }
    let is_drawn = |row: &Vec<f64>| (0..drawn).any(|number| row.first() == Some(&(number as f64)));
    match table.rows.iter().find(|row| !is_drawn(row)) {
        Some(row) => Err(format!(
            "the table `{name}` has a row of number {}, and {drawn} are drawn, from 0",
            row.first().copied().unwrap_or(f64::NAN)
        )),
        None => Ok(()),
    }
}

fn curves(plot: &Plot, title: &str, table: &Table) -> Result<Figure, String> {
    let picture = &plot.picture;
    let data = all_series(plot);
    complete(table, 3, data.len())?;
    let named = data.first().map(|data| match data {
        SeriesData::Record { y, x, .. } | SeriesData::Reference { y, x, .. } => (x.clone(), y.clone()),
        SeriesData::Points { .. } => ("abscissa".into(), "ordinate".into()),
    });
    let (x_name, y_name) = named.unwrap_or_default();
    let scale = |is_logarithmic| if is_logarithmic { Scale::Logarithmic } else { Scale::Linear };
    let axis = |at: usize, label: &Option<String>, name: String, range, is_logarithmic| Axis {
        label: label.clone().unwrap_or(name),
        unit: table.columns[at].unit.clone(),
        scale: scale(is_logarithmic),
        range,
    };
    let mut figure = Figure {
        title: title.into(),
        x: axis(1, &picture.x_label, x_name, picture.x_range, picture.logarithmic.0),
        y: axis(2, &picture.y_label, y_name, picture.y_range, picture.logarithmic.1),
        provenance: table.provenance.clone(),
        ..Figure::default()
    };
    let plain = plot.curves.len() + plot.points.len();
    for (number, data) in data.iter().enumerate() {
        let points = rows_of(table, number).map(|row| (row[1], row[2])).collect();
        let (label, mark, colour) = match (data, number.checked_sub(plain)) {
            (_, Some(own)) => {
                let series = &picture.series[own];
                (series.label.clone(), mark(series.look), series.colour)
            }
            (SeriesData::Record { record, y, .. }, None) => (format!("{record}.{y}"), Mark::Line, None),
            (SeriesData::Reference { reference, .. }, None) => {
                (file_name(&reference.path), Mark::Markers, None)
            }
            // written in a `series` only
            (SeriesData::Points { .. }, None) => (String::new(), Mark::Markers, None),
        };
        figure.series.push(Series { label, points, mark, colour });
    }
    let bands = picture.bands.iter();
    figure.bands = bands
        .map(|band| Band { label: band.label.clone(), corners: band.corners.clone(), colour: band.colour })
        .collect();
    Ok(figure)
}

fn mark(look: Look) -> Mark {
    match look {
        Look::Line => Mark::Line,
        Look::Dashed => Mark::Dashed,
        Look::Markers => Mark::Markers,
        Look::LineMarkers => Mark::LineMarkers,
    }
}

/// A reference's name in a legend: its file name without folder and ending.
fn file_name(path: &str) -> String {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    file.strip_suffix(".csv").unwrap_or(file).to_string()
}

fn fields_of(
    picture: &FieldPicture,
    title: &str,
    points: &Table,
    faces: &Table,
) -> Result<FieldFigure, String> {
    complete(points, 5, picture.panels.len())?;
    complete(faces, 5, picture.panels.len())?;
    let mut panels = Vec::new();
    for (number, described) in picture.panels.iter().enumerate() {
        let rows = || rows_of(points, number);
        let positions: Vec<Vec3> = rows().map(|row| Vec3::new(row[1], row[2], row[3])).collect();
        // a negative or fractional corner is none, and refused with those beyond the last point
        let corner = |value: f64| if value >= 0.0 { value as usize } else { usize::MAX };
        let corners = |row: &Vec<f64>| {
            let mut corners: Vec<usize> = row[1..].iter().map(|value| corner(*value)).collect();
            corners.dedup();
            corners
        };
        let mut panel = Panel {
            caption: described.caption.clone(),
            positions,
            values: rows().map(|row| row[4]).collect(),
            faces: rows_of(faces, number).map(corners).collect(),
            spacing: 0.0,
        };
        let count = panel.positions.len();
        if panel.faces.iter().flatten().any(|&corner| corner >= count) {
            return Err(format!("a face of panel {number} names a point that is not there"));
        }
        for &(axis, at) in &described.mirrors {
            panel = panel.mirrored(usize::from(axis), at, picture.field.flips(usize::from(axis)));
        }
        panels.push(panel);
    }
    Ok(FieldFigure {
        title: title.into(),
        label: picture.label.clone(),
        unit: picture.unit.clone(),
        panels,
        columns: picture.columns,
        view: view(picture.view),
        range: picture.range,
        provenance: points.provenance.clone(),
    })
}

fn view(viewpoint: Viewpoint) -> View {
    let axis = |i: u8| Vec3::ith(usize::from(i), 1.0);
    match viewpoint {
        Viewpoint::Plane(right, up) => View { right: axis(right), up: axis(up) },
        Viewpoint::Oblique => View::oblique(),
        Viewpoint::Corner => View::corner(),
    }
}

fn sketch(drawing: &Drawing, title: &str, table: &Table) -> Result<Sketch, String> {
    complete(table, 3, drawing.outlines.len())?;
    let pair = |[x, y]: [f64; 2]| (x, y);
    let outline = |number: usize| rows_of(table, number).map(|row| (row[1], row[2])).collect();
    let disc = |centre: [f64; 2], radius: f64| {
        let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / 96.0;
        (0..96)
            .map(|i| (centre[0] + radius * libm::cos(angle(i)), centre[1] + radius * libm::sin(angle(i))))
            .collect()
    };
    Ok(Sketch {
        title: title.into(),
        outlines: (0..drawing.outlines.len()).map(outline).collect(),
        patches: drawing
            .discs
            .iter()
            .map(|&(centre, radius, colour)| Patch { corners: disc(centre, radius), colour })
            .collect(),
        dimensions: drawing
            .dimensions
            .iter()
            .map(|(from, to, offset, text)| Dimension {
                from: pair(*from),
                to: pair(*to),
                offset: *offset,
                text: text.clone(),
            })
            .collect(),
        notes: drawing
            .notes
            .iter()
            .map(|note| Note { at: pair(note.at), to: note.to.map(pair), text: note.text.clone() })
            .collect(),
        provenance: table.provenance.clone(),
    })
}
