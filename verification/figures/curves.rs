//! The points of a curve in an SVG file against the numbers of its table.

use crate::output::{Axis, Figure, Series};
use crate::verify::{Claim, Topic};

/// Points on an irregular curve that fills the axes, so that no two share a coordinate.
const POINTS: [(f64, f64); 6] =
    [(0.0, 0.0), (0.07, 0.31), (0.24, 0.12), (0.55, 0.78), (0.83, 0.44), (1.0, 1.0)];

/// A figure shows what its table says.
pub(super) const DRAWN_AS_TABULATED: Claim = Claim {
    topic: Topic::Figures,
    claim: "the points of a drawn curve are the points of its table",
    source: "linear axes: drawn position over extent equals value over range",
    because: "coordinates are whole quarters of a pixel, on axes of more than 350 pixels: 0.125/350, at both ends",
    bound: 7.2e-4,
    measure: || worst(1.0),
    control: || worst(1.02),
};

/// Largest difference of a drawn point from its table's, in shares of the axes, the third one's
/// ordinate times `factor`.
fn worst(factor: f64) -> f64 {
    let series = Series { label: "curve".into(), points: POINTS.to_vec(), ..Series::default() };
    let axis = |label: &str| Axis { label: label.into(), ..Axis::default() };
    let figure = Figure { x: axis("x"), y: axis("y"), series: vec![series], ..Figure::default() };
    let svg = figure.to_svg().expect("a curve of finite points can be drawn");
    let drawn = longest_polyline(&svg);
    if drawn.len() != POINTS.len() {
        return f64::NAN;
    }
    let (first, last) = (drawn[0], drawn[drawn.len() - 1]);
    let share = |value: f64, from: f64, to: f64| (value - from) / (to - from);
    drawn
        .iter()
        .zip(POINTS)
        .enumerate()
        .map(|(i, (&(px, py), (x, y)))| {
            let y = if i == 3 { y * factor } else { y };
            let (dx, dy) = (share(px, first.0, last.0) - x, share(py, first.1, last.1) - y);
            dx.abs().max(dy.abs())
        })
        .fold(0.0, f64::max)
}

/// Coordinates of the polyline of most points: gridlines have two.
fn longest_polyline(svg: &str) -> Vec<(f64, f64)> {
    polylines(svg).into_iter().max_by_key(Vec::len).unwrap_or_default()
}

/// Coordinates of all polylines and polygons.
pub(super) fn polylines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let lists = svg.split("points=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let parse = |list: &str| -> Vec<(f64, f64)> {
        let pair = |word: &str| {
            let (x, y) = word.split_once(',')?;
            Some((x.parse().ok()?, y.parse().ok()?))
        };
        list.split_whitespace().filter_map(pair).collect()
    };
    lists.map(parse).collect()
}
