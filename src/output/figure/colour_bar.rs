//! The colour bar beside a picture.
//!
//! Owns its picture. Where values lie beyond its range the end is drawn as a tip, with the value that lies
//! farthest beyond, so that nothing is cut off unseen.

use super::axis::{Ruler, ten};
use super::canvas::{Anchor, Canvas, Point};
use super::colour_map::viridis;
use super::model::FigureError;
use super::palette::INK;
use super::symbol::{decimal, scaled};

/// Size of its letters, units.
const LETTERS: f64 = 16.0;
/// Width of the colours, units.
const WIDTH: f64 = 18.0;
/// Height of a tip, units.
const TIP: f64 = 14.0;
/// Height of a tip with its number, units.
const ROOM: f64 = 22.0;
const SHADES: u32 = 128;

/// Where a colour bar stands on the page, units.
pub(super) struct ColourBar {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
    /// Middle of its label, which runs upwards.
    pub(super) label: f64,
}

/// The values that lie farthest beyond the ends of a colour bar.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Beyond {
    below: Option<f64>,
    above: Option<f64>,
}

impl Beyond {
    /// Of the values `seen` those beyond the ends of `ruler`.
    pub(super) fn new(ruler: &Ruler, seen: impl Iterator<Item = f64>) -> Self {
        let (low, high) = seen.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        // tables keep six digits: a value that misses the end by less is the end
        let below = Some(low).filter(|&low| low.is_finite() && ruler.fraction(low) < -1e-5);
        let above = Some(high).filter(|&high| high.is_finite() && ruler.fraction(high) > 1.0 + 1e-5);
        Self { below, above }
    }
}

impl ColourBar {
    /// Draws the colours with the numbers and the label of `ruler`, whose values have the SI unit `unit`.
    pub(super) fn draw(
        &self,
        canvas: &Canvas<'_>,
        ruler: &Ruler,
        unit: &str,
        beyond: Beyond,
    ) -> Result<(), FigureError> {
        let &Self { left, top, bottom, label } = self;
        let room = |tip: Option<f64>| if tip.is_some() { ROOM } else { 0.0 };
        let (top, bottom) = (top + room(beyond.above), bottom - room(beyond.below));
        let right = left + WIDTH;
        let up = |fraction: f64| bottom - (bottom - top) * fraction;
        for i in 0..SHADES {
            let part = |i: u32| f64::from(i) / f64::from(SHADES);
            let colour = viridis(0.5 * (part(i) + part(i + 1)));
            // Each shade reaches under the next, so no line of paper shows between them.
            let over = if i + 1 < SHADES { part(i + 2) } else { 1.0 };
            canvas.box_filled((left, up(over)), (right, up(part(i))), colour)?;
        }
        let exponent = scaled(unit, ruler.low.abs().max(ruler.high.abs())).exponent;
        let number = |name: &str, value: f64, y: f64| {
            let value = value / ten(1, exponent);
            let decimals = if value.abs() < 1.0 { 2 } else { 1 };
            canvas.text(
                &format!("{name} {}", decimal(value, decimals)),
                (left, y),
                LETTERS,
                Anchor::Left,
                false,
            )
        };
        let middle = 0.5 * (left + right);
        let mut outline: Vec<Point> = vec![(left, top)];
        if let Some(value) = beyond.above {
            let tip = (middle, top - TIP);
            canvas.patch(&[(left, top), tip, (right, top)], viridis(1.0))?;
            outline.push(tip);
            number("max", value, tip.1 - 12.0)?;
        }
        outline.extend([(right, top), (right, bottom)]);
        if let Some(value) = beyond.below {
            let tip = (middle, bottom + TIP);
            canvas.patch(&[(right, bottom), tip, (left, bottom)], viridis(0.0))?;
            outline.push(tip);
            number("min", value, tip.1 + 12.0)?;
        }
        outline.extend([(left, bottom), (left, top)]);
        canvas.line(&outline, INK, 1.0)?;
        for (value, text) in &ruler.major {
            let y = up(ruler.fraction(*value));
            canvas.line(&[(right, y), (right + 5.0, y)], INK, 1.25)?;
            canvas.text(text, (right + 8.0, y), LETTERS, Anchor::Left, false)?;
        }
        canvas.text(&ruler.label, (label, 0.5 * (top + bottom)), LETTERS, Anchor::Centre, true)
    }
}
