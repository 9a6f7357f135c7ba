//! Figures of claims: orders over a step or a spacing, histories over time.
//!
//! Owns the two forms; what is drawn is measured beside the claim. A topic lists its figures beside its claims,
//! `illustrations` here lists the topics.

use super::{conservation, consistency, discretisation, energies};
use crate::output::{Axis, Figure, Mark, Scale, Series, Slope};
use crate::verify::claim::Illustration;

/// The figures of all claims that have one.
pub fn illustrations() -> Vec<Illustration> {
    let groups = [
        energies::ILLUSTRATIONS,
        discretisation::ILLUSTRATIONS,
        conservation::ILLUSTRATIONS,
        consistency::ILLUSTRATIONS,
    ];
    groups.concat()
}

/// Errors over a spacing or a step on logarithmic axes, with a triangle of the order claimed.
pub(super) fn orders(title: &str, x: (&str, &str), lines: &[(&str, Vec<(f64, f64)>)], order: f64) -> Figure {
    let axis = |label: &str, unit: &str| Axis {
        label: label.into(),
        unit: unit.into(),
        scale: Scale::Logarithmic,
        ..Axis::default()
    };
    Figure {
        title: title.into(),
        x: axis(x.0, x.1),
        y: axis("error", ""),
        series: lines.iter().map(|(label, points)| series(label, points, Mark::LineMarkers)).collect(),
        slopes: vec![Slope { series: 0, order }],
        ..Figure::default()
    }
}

/// Numbers over time, the ordinate logarithmic; what is zero is drawn at `floor`.
pub(super) fn history(title: &str, label: &str, lines: &[(&str, Vec<(f64, f64)>)], floor: f64) -> Figure {
    let raised =
        |points: &[(f64, f64)]| points.iter().map(|&(t, value)| (t, value.max(floor))).collect::<Vec<_>>();
    Figure {
        title: title.into(),
        x: Axis { label: "time".into(), unit: "s".into(), scale: Scale::Linear, ..Axis::default() },
        y: Axis { label: label.into(), unit: String::new(), scale: Scale::Logarithmic, ..Axis::default() },
        series: lines.iter().map(|(label, points)| series(label, &raised(points), Mark::Line)).collect(),
        ..Figure::default()
    }
}

fn series(label: &str, points: &[(f64, f64)], mark: Mark) -> Series {
    Series { label: label.into(), points: points.to_vec(), mark, colour: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::{full, quick};

    #[test]
    fn every_figure_is_of_a_claim_and_is_drawn() {
        let claims: Vec<&str> = quick().iter().chain(&full()).map(|claim| claim.claim).collect();
        for illustration in illustrations() {
            assert!(claims.contains(&illustration.claim), "no claim `{}`", illustration.claim);
            let svg = (illustration.figure)().to_svg();
            assert!(svg.is_ok(), "`{}`: {svg:?}", illustration.claim);
        }
    }
}
