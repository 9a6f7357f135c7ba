//! Figures of claims: orders over a step or a spacing, histories over time.
//!
//! Owns the forms; what is drawn is measured beside the claim. A topic lists its figures beside its claims,
//! `illustrations` here lists the topics.

use super::{conservation, consistency, convergence, discretisation, energies};
use crate::output::{Axis, Figure, Mark, Scale, Series, Slope};
use crate::verify::claim::Illustration;

/// Curves by what they are called.
pub(super) type Lines<'a> = [(&'a str, Vec<(f64, f64)>)];

/// The figures of all claims that have one.
pub fn illustrations() -> Vec<Illustration> {
    let groups = [
        energies::ILLUSTRATIONS,
        discretisation::ILLUSTRATIONS,
        conservation::ILLUSTRATIONS,
        consistency::ILLUSTRATIONS,
        convergence::ILLUSTRATIONS,
    ];
    groups.concat()
}

/// Errors over a spacing or a step on logarithmic axes, each with its slope, and a triangle of the order claimed
/// under the first.
pub(super) fn orders(title: &str, x: (&str, &str), y: (&str, &str), lines: &Lines<'_>, order: f64) -> Figure {
    let line = |(label, points): &(&str, Vec<(f64, f64)>)| {
        let logarithms: Vec<_> = points.iter().map(|&(x, y)| (libm::log(x), libm::log(y))).collect();
        series(&format!("{label}: order {:.2}", slope(&logarithms)), points, Mark::LineMarkers)
    };
    Figure {
        title: title.into(),
        x: axis(x.0, x.1, Scale::Logarithmic),
        y: axis(y.0, y.1, Scale::Logarithmic),
        series: lines.iter().map(line).collect(),
        slopes: vec![Slope { series: 0, order }],
        ..Figure::default()
    }
}

/// Numbers over time, the ordinate logarithmic; what is less than `floor` is drawn there.
pub(super) fn history(title: &str, label: &str, lines: &Lines<'_>, floor: f64) -> Figure {
    let raised =
        |points: &[(f64, f64)]| points.iter().map(|&(t, value)| (t, value.max(floor))).collect::<Vec<_>>();
    Figure {
        title: title.into(),
        x: axis("time", "s", Scale::Linear),
        y: axis(label, "", Scale::Logarithmic),
        series: lines.iter().map(|(label, points)| series(label, &raised(points), Mark::Line)).collect(),
        ..Figure::default()
    }
}

/// Numbers over time, both axes linear.
pub(super) fn course(title: &str, label: &str, lines: &Lines<'_>) -> Figure {
    let mut figure = history(title, label, lines, f64::NEG_INFINITY);
    figure.y.scale = Scale::Linear;
    figure
}

/// The same with a bound drawn across, dashed, in the colour of no line.
pub(super) fn bounded(mut figure: Figure, bound: f64) -> Figure {
    let times = || figure.series.iter().flat_map(|series| &series.points).map(|point| point.0);
    let (first, last) = (times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max));
    figure.series.push(series("bound", &[(first, bound), (last, bound)], Mark::Dashed));
    figure
}

/// Least-squares slope of some points.
pub(super) fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
    let (above, below) = points.iter().fold((0.0, 0.0), |(above, below), point| {
        let d = point.0 - x;
        (above + d * (point.1 - y), below + d * d)
    });
    above / below
}

fn axis(label: &str, unit: &str, scale: Scale) -> Axis {
    Axis { label: label.into(), unit: unit.into(), scale, ..Axis::default() }
}

fn series(label: &str, points: &[(f64, f64)], mark: Mark) -> Series {
    Series { label: label.into(), points: points.to_vec(), mark, colour: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::{full, quick};

    #[test]
    fn every_figure_is_of_a_claim() {
        let claims: Vec<&str> = quick().iter().chain(&full()).map(|claim| claim.claim).collect();
        for illustration in illustrations() {
            assert!(claims.contains(&illustration.claim), "no claim `{}`", illustration.claim);
        }
    }

    // Those of conservation are drawn by the tests of the command; others take seconds each and are left to it.
    #[test]
    fn figures_that_take_no_time_are_drawn() {
        for illustration in energies::ILLUSTRATIONS {
            let svg = (illustration.figure)().to_svg();
            assert!(svg.is_ok(), "`{}`: {svg:?}", illustration.claim);
        }
    }

    #[test]
    fn every_claim_on_convergence_in_space_or_time_has_a_figure() {
        let drawn: Vec<&str> = illustrations().iter().map(|illustration| illustration.claim).collect();
        for claim in quick().into_iter().chain(full()).filter(|claim| claim.claim.contains("order")) {
            assert!(drawn.contains(&claim.claim), "no figure of `{}`", claim.claim);
        }
    }
}
