//! A sheet to draw on, in the units of the page.
//!
//! Owns the only use of the drawing library. Coordinates are rounded to a quarter of a unit, so the
//! bytes depend on no machine. Text is left to the reader's fonts.

use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{Circle, PathElement, Polygon, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, IntoFont, RGBColor, ShapeStyle, TextStyle};

use super::model::FigureError;
use super::palette::{Colour, PAPER};

/// Steps of the drawing per unit of the page.
const STEPS: f64 = 4.0;
/// The library writes font sizes divided by this.
const FONT_FACTOR: f64 = 1.24;
/// Width of a character of a sans-serif font on average, in font sizes.
const CHARACTER: f64 = 0.56;

/// A point of the page, in units from the upper left.
pub(super) type Point = (f64, f64);

/// Where text stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    /// The point is the left end.
    Left,
    /// The point is the middle.
    Centre,
    /// The point is the right end.
    Right,
}

/// Draws onto a page and gives it as SVG.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// Width of `text` set in `size`, estimated since no font is known.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * CHARACTER * size
}

/// The drawing made by `draw` on a page of `width` by `height` units, as SVG.
///
/// # Errors
/// What `draw` returns, and [`FigureError::Drawing`].
pub(super) fn page(
    (width, height): (u32, u32),
    title: &str,
    description: &str,
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), FigureError>,
) -> Result<String, FigureError> {
    let mut text = String::new();
    let steps = (step(f64::from(width)).unsigned_abs(), step(f64::from(height)).unsigned_abs());
    {
        let canvas = Canvas { area: SVGBackend::with_string(&mut text, steps).into_drawing_area() };
        canvas.box_filled((0.0, 0.0), (f64::from(width), f64::from(height)), PAPER)?;
        draw(&canvas)?;
        canvas.area.present().map_err(drawing)?;
    }
    // The library's opening tag gives the page the size of its steps; ours gives it its own.
    let body = text.split_once(">\n").map_or("", |(_, body)| body);
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    Ok(format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {} {}\" \
         xmlns=\"http://www.w3.org/2000/svg\">\n<title>{}</title>\n<desc>{}</desc>\n{body}",
        steps.0,
        steps.1,
        escaped(title),
        escaped(description)
    ))
}

fn step(unit: f64) -> i32 {
    libm::round(unit * STEPS) as i32
}

fn steps((x, y): Point) -> (i32, i32) {
    (step(x), step(y))
}

fn drawing(cause: impl std::fmt::Display) -> FigureError {
    FigureError::Drawing { cause: cause.to_string() }
}

fn stroke((r, g, b): Colour, width: f64) -> ShapeStyle {
    RGBColor(r, g, b).stroke_width(step(width).unsigned_abs())
}

fn filled((r, g, b): Colour) -> ShapeStyle {
    RGBColor(r, g, b).filled()
}

impl Canvas<'_> {
    /// A line through `points`.
    pub(super) fn line(&self, points: &[Point], colour: Colour, width: f64) -> Result<(), FigureError> {
        let path: Vec<(i32, i32)> = points.iter().copied().map(steps).collect();
        self.area.draw(&PathElement::new(path, stroke(colour, width))).map_err(drawing)
    }

    /// A line of dashes of `dash` units with gaps two thirds as long.
    pub(super) fn dashed(
        &self,
        points: &[Point],
        colour: Colour,
        width: f64,
        dash: f64,
    ) -> Result<(), FigureError> {
        let period = dash * 5.0 / 3.0;
        let mut travelled = 0.0;
        for pair in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let length = libm::hypot(x1 - x0, y1 - y0);
            let at = |s: f64| (x0 + (x1 - x0) * s / length, y0 + (y1 - y0) * s / length);
            let mut from = 0.0;
            while from < length {
                let phase = (travelled + from) % period;
                let (to, is_drawn) =
                    if phase < dash { (from + dash - phase, true) } else { (from + period - phase, false) };
                // Progress even where the rest of a period is lost in rounding.
                let to = to.max(from + 1e-6).min(length);
                if is_drawn {
                    self.line(&[at(from), at(to)], colour, width)?;
                }
                from = to;
            }
            travelled += length;
        }
        Ok(())
    }

    /// A closed outline on white ground, or a filled shape.
    pub(super) fn shape(
        &self,
        corners: &[Point],
        colour: Colour,
        is_filled: bool,
    ) -> Result<(), FigureError> {
        let path: Vec<(i32, i32)> = corners.iter().copied().map(steps).collect();
        let ground = if is_filled { colour } else { PAPER };
        self.area.draw(&Polygon::new(path.clone(), filled(ground))).map_err(drawing)?;
        let closed: Vec<(i32, i32)> = path.iter().chain(path.first()).copied().collect();
        self.area.draw(&PathElement::new(closed, stroke(colour, 1.75))).map_err(drawing)
    }

    /// A circle, hollow on white ground or filled.
    pub(super) fn circle(
        &self,
        centre: Point,
        radius: f64,
        colour: Colour,
        is_filled: bool,
    ) -> Result<(), FigureError> {
        let ground = if is_filled { colour } else { PAPER };
        let (centre, radius) = (steps(centre), step(radius));
        self.area.draw(&Circle::new(centre, radius, filled(ground))).map_err(drawing)?;
        self.area.draw(&Circle::new(centre, radius, stroke(colour, 1.75))).map_err(drawing)
    }

    /// A filled shape a little larger than its corners, so that neighbours leave no gap.
    pub(super) fn patch(&self, corners: &[Point], colour: Colour) -> Result<(), FigureError> {
        let n = corners.len() as f64;
        let centre =
            (corners.iter().map(|c| c.0).sum::<f64>() / n, corners.iter().map(|c| c.1).sum::<f64>() / n);
        let grown = |&(x, y): &Point| {
            let away = (x - centre.0, y - centre.1);
            let length = libm::hypot(away.0, away.1).max(1e-9);
            steps((x + 0.6 * away.0 / length, y + 0.6 * away.1 / length))
        };
        let path: Vec<(i32, i32)> = corners.iter().map(grown).collect();
        self.area.draw(&Polygon::new(path, filled(colour))).map_err(drawing)
    }

    /// A filled region without an outline.
    pub(super) fn area_filled(&self, corners: &[Point], colour: Colour) -> Result<(), FigureError> {
        let path: Vec<(i32, i32)> = corners.iter().copied().map(steps).collect();
        self.area.draw(&Polygon::new(path, filled(colour))).map_err(drawing)
    }

    /// A filled disc without an outline.
    pub(super) fn dot(&self, centre: Point, radius: f64, colour: Colour) -> Result<(), FigureError> {
        self.area.draw(&Circle::new(steps(centre), step(radius), filled(colour))).map_err(drawing)
    }

    /// A filled rectangle between two corners.
    pub(super) fn box_filled(&self, from: Point, to: Point, colour: Colour) -> Result<(), FigureError> {
        self.area.draw(&Rectangle::new([steps(from), steps(to)], filled(colour))).map_err(drawing)
    }

    /// Text centred in height on `at`; `turned` reads upwards.
    pub(super) fn text(
        &self,
        text: &str,
        at: Point,
        size: f64,
        anchor: Anchor,
        turned: bool,
    ) -> Result<(), FigureError> {
        let (r, g, b) = super::palette::INK;
        let horizontal = match anchor {
            Anchor::Left => HPos::Left,
            Anchor::Centre => HPos::Center,
            Anchor::Right => HPos::Right,
        };
        let turn = if turned { FontTransform::Rotate270 } else { FontTransform::None };
        let font = ("sans-serif", size * STEPS * FONT_FACTOR).into_font().transform(turn);
        let style: TextStyle<'_> = font.color(&RGBColor(r, g, b)).pos(Pos::new(horizontal, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), steps(at), style)).map_err(drawing)
    }
}
