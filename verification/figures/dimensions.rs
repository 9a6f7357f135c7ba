//! The length of a dimension line in an SVG file against the number written beside it.

use crate::output::{Dimension, Sketch};
use crate::verify::{Claim, Topic};

/// Width of the outline, m.
const WIDTH: f64 = 0.1;

/// A drawing is to scale.
pub(super) const DRAWN_TO_SCALE: Claim = Claim {
    topic: Topic::Figures,
    claim: "a dimension line is as long, in widths of its outline, as its number says",
    source: "a drawing to scale: drawn length over drawn width equals length over width",
    because: "ends are whole quarters of a unit, the width more than 500 units: 0.125/500 for each of two ends",
    bound: 1e-3,
    measure: || worst(1.0),
    control: || worst(1.02),
};

/// Largest difference over several lengths, the number read times `factor`.
fn worst(factor: f64) -> f64 {
    [0.0123, 0.033, 0.0777]
        .into_iter()
        .map(|length| {
            let sketch = Sketch {
                outlines: vec![vec![(0.0, 0.0), (WIDTH, 0.0), (WIDTH, 0.02), (0.0, 0.02)]],
                dimensions: vec![Dimension {
                    from: (0.01, 0.01),
                    to: (0.01 + length, 0.01),
                    ..Dimension::default()
                }],
                ..Sketch::default()
            };
            let svg = sketch.to_svg().expect("a drawing with an extent");
            let lines = super::curves::polylines(&svg);
            let extent = |line: &Vec<(f64, f64)>| {
                let most = line.iter().map(|p| p.0).fold(f64::NEG_INFINITY, f64::max);
                most - line.iter().map(|p| p.0).fold(f64::INFINITY, f64::min)
            };
            let (Some(outline), Some(line)) =
                (lines.iter().find(|l| l.len() == 5), lines.iter().find(|l| l.len() == 2))
            else {
                return f64::NAN;
            };
            let millimetres = svg.split(" mm").next().and_then(|text| text.rsplit(['\n', ' ']).next());
            let written = millimetres.and_then(|text| text.parse::<f64>().ok()).unwrap_or(f64::NAN);
            (extent(line) / extent(outline) - factor * 1e-3 * written / WIDTH).abs()
        })
        .fold(0.0, |worst: f64, error| if error <= worst { worst } else { error })
}
