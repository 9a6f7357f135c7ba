//! The colour bar beside a picture.

use super::axis::Ruler;
use super::canvas::{Anchor, Canvas};
use super::colour_map::viridis;
use super::model::FigureError;
use super::palette::INK;

/// Size of its letters, units.
const LETTERS: f64 = 16.0;
/// Width of the colours, units.
const WIDTH: f64 = 18.0;
const SHADES: u32 = 128;

/// Where a colour bar stands on the page, units.
pub(super) struct ColourBar {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
    /// Middle of its label, which runs upwards.
    pub(super) label: f64,
}

impl ColourBar {
    /// Draws the colours with the numbers and the label of `ruler`.
    pub(super) fn draw(&self, canvas: &Canvas<'_>, ruler: &Ruler) -> Result<(), FigureError> {
        let &Self { left, top, bottom, label } = self;
        let right = left + WIDTH;
        let up = |fraction: f64| bottom - (bottom - top) * fraction;
        for i in 0..SHADES {
            let part = |i: u32| f64::from(i) / f64::from(SHADES);
            let colour = viridis(0.5 * (part(i) + part(i + 1)));
            // Each shade reaches under the next, so no line of paper shows between them.
            let over = if i + 1 < SHADES { part(i + 2) } else { 1.0 };
            canvas.box_filled((left, up(over)), (right, up(part(i))), colour)?;
        }
        canvas.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], INK, 1.0)?;
        for (value, text) in &ruler.major {
            let y = up(ruler.fraction(*value));
            canvas.line(&[(right, y), (right + 5.0, y)], INK, 1.25)?;
            canvas.text(text, (right + 8.0, y), LETTERS, Anchor::Left, false)?;
        }
        canvas.text(&ruler.label, (label, 0.5 * (top + bottom)), LETTERS, Anchor::Centre, true)
    }
}
