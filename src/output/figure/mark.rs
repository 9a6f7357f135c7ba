//! Lines and markers.
//!
//! Owns what each [`Mark`] looks like, in the axes and in the legend.

use super::canvas::{Canvas, Point};
use super::model::{FigureError, Mark};
use super::palette::Colour;

/// Draws places as `mark`; the shape of markers follows the number of the colour.
pub(super) fn draw_mark(
    canvas: &Canvas<'_>,
    places: &[Point],
    mark: Mark,
    colour: Colour,
    number: usize,
) -> Result<(), FigureError> {
    match mark {
        Mark::Line | Mark::LineMarkers => canvas.line(places, colour, 2.25)?,
        Mark::Dashed => canvas.dashed(places, colour, 2.25, 9.0)?,
        Mark::Markers => {}
    }
    if matches!(mark, Mark::Markers | Mark::LineMarkers) {
        for &place in places {
            draw_marker(canvas, place, colour, number, mark == Mark::LineMarkers)?;
        }
    }
    Ok(())
}

/// A marker of about ten units: circle, square, triangle, diamond by turns.
fn draw_marker(
    canvas: &Canvas<'_>,
    (x, y): Point,
    colour: Colour,
    number: usize,
    is_filled: bool,
) -> Result<(), FigureError> {
    match number % 4 {
        0 => canvas.circle((x, y), 4.5, colour, is_filled),
        1 => {
            let r = 4.0;
            let corners = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)];
            canvas.shape(&corners, colour, is_filled)
        }
        2 => canvas.shape(&[(x, y - 5.5), (x + 5.0, y + 3.5), (x - 5.0, y + 3.5)], colour, is_filled),
        _ => canvas.shape(&[(x, y - 6.0), (x + 5.0, y), (x, y + 6.0), (x - 5.0, y)], colour, is_filled),
    }
}
