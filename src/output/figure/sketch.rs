//! A drawing of a body with its dimensions.
//!
//! Owns the picture: outlines, filled regions, dimension lines whose numbers are the distances they span.

use super::canvas::{Anchor, Canvas, Point, page};
use super::model::FigureError;
use super::palette::{self, INK};
use super::symbol::{decimal, scaled};

const WIDTH: u32 = 640;
/// Room around the drawing for text, units.
const MARGIN: f64 = 44.0;
/// Tallest drawing, units.
const TALLEST: f64 = 620.0;
const SMALL: f64 = 16.0;
const LARGE: f64 = 18.0;
/// Length of an arrow's head, units.
const HEAD: f64 = 9.0;

/// Outlines on a plane with dimensions; coordinates in m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sketch {
    /// Line above the drawing; may be empty.
    pub title: String,
    /// Closed outlines.
    pub outlines: Vec<Vec<(f64, f64)>>,
    /// Filled regions.
    pub patches: Vec<Patch>,
    /// Dimension lines.
    pub dimensions: Vec<Dimension>,
    /// Texts.
    pub notes: Vec<Note>,
    /// Lines kept in the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

/// A filled region, drawn below the outlines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Patch {
    /// Corners in order, m.
    pub corners: Vec<(f64, f64)>,
    /// Number of its colour, of which a tint is drawn.
    pub colour: usize,
}

/// A distance between two points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dimension {
    /// Its ends, m.
    pub from: (f64, f64),
    /// Its ends, m.
    pub to: (f64, f64),
    /// How far beside the two points the line is drawn, to the left of the way from one to the other, m.
    pub offset: f64,
    /// What stands before the number: `radius`.
    pub text: String,
}

/// A text at a point, joined by a line to what it names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Note {
    /// Where the text begins, m.
    pub at: (f64, f64),
    /// What it names, m; no line where absent.
    pub to: Option<(f64, f64)>,
    /// The text.
    pub text: String,
}

impl Dimension {
    fn ends(&self) -> [(f64, f64); 2] {
        let (dx, dy) = (self.to.0 - self.from.0, self.to.1 - self.from.1);
        let length = libm::hypot(dx, dy);
        let (nx, ny) = (-dy / length * self.offset, dx / length * self.offset);
        [(self.from.0 + nx, self.from.1 + ny), (self.to.0 + nx, self.to.1 + ny)]
    }

    /// The text with the distance behind it: `R 0.3 m`.
    fn label(&self) -> String {
        let length = libm::hypot(self.to.0 - self.from.0, self.to.1 - self.from.1);
        let unit = scaled("m", length);
        // as many places as the number has, three at most
        let drawn = round_to(length / super::axis::ten(1, unit.exponent), 3);
        let places = (0..3).find(|&n| (drawn - round_to(drawn, n)).abs() < 1e-9 * drawn.abs()).unwrap_or(3);
        format!("{} {} {}", self.text, decimal(drawn, places), unit.text).trim().to_owned()
    }
}

fn round_to(value: f64, places: usize) -> f64 {
    let factor = super::axis::ten(1, i32::try_from(places).unwrap_or(0));
    libm::round(value * factor) / factor
}

impl Sketch {
    /// The drawing as SVG; the same drawing gives the same bytes on every machine.
    ///
    /// # Errors
    /// [`FigureError::Empty`] without an extent, [`FigureError::NotFinite`], [`FigureError::Drawing`].
    pub fn to_svg(&self) -> Result<String, FigureError> {
        let all = self.points();
        if let Some(point) = all.iter().position(|p| !(p.0.is_finite() && p.1.is_finite())) {
            return Err(FigureError::NotFinite { series: self.title.clone(), point });
        }
        let least = |pick: fn(&Point) -> f64| all.iter().map(pick).fold(f64::INFINITY, f64::min);
        let most = |pick: fn(&Point) -> f64| all.iter().map(pick).fold(f64::NEG_INFINITY, f64::max);
        let (low, high) = ((least(|p| p.0), least(|p| p.1)), (most(|p| p.0), most(|p| p.1)));
        let scale = ((f64::from(WIDTH) - 2.0 * MARGIN) / (high.0 - low.0)).min(TALLEST / (high.1 - low.1));
        if !(scale.is_finite() && scale > 0.0) {
            return Err(FigureError::Empty);
        }
        let top = if self.title.is_empty() { MARGIN } else { MARGIN + 30.0 };
        let height = top + scale * (high.1 - low.1) + MARGIN;
        let spare = f64::from(WIDTH) - scale * (high.0 - low.0);
        let place = |p: Point| (0.5 * spare + scale * (p.0 - low.0), top + scale * (high.1 - p.1));
        // at most some hundred units by the bounds on width and height
        let size = (WIDTH, libm::ceil(height) as u32);
        page(size, &self.title, &self.provenance.join("\n"), |canvas| self.draw(canvas, &place))
    }

    fn points(&self) -> Vec<Point> {
        let mut all: Vec<Point> = self.outlines.iter().flatten().copied().collect();
        all.extend(self.patches.iter().flat_map(|patch| patch.corners.iter().copied()));
        all.extend(self.dimensions.iter().flat_map(Dimension::ends));
        all.extend(self.notes.iter().map(|note| note.at));
        all
    }

    fn draw(&self, canvas: &Canvas<'_>, place: &dyn Fn(Point) -> Point) -> Result<(), FigureError> {
        for patch in &self.patches {
            let corners: Vec<Point> = patch.corners.iter().copied().map(place).collect();
            canvas.area_filled(&corners, palette::tint(patch.colour))?;
        }
        for outline in &self.outlines {
            let closed: Vec<Point> = outline.iter().chain(outline.first()).copied().map(place).collect();
            canvas.line(&closed, INK, 2.0)?;
        }
        for dimension in &self.dimensions {
            draw_dimension(canvas, dimension, place)?;
        }
        for note in &self.notes {
            let at = place(note.at);
            if let Some(to) = note.to {
                canvas.line(&[(at.0 - 4.0, at.1), place(to)], INK, 1.0)?;
            }
            canvas.text(&note.text, at, SMALL, Anchor::Left, false)?;
        }
        canvas.text(&self.title, (0.5 * f64::from(WIDTH), 24.0), LARGE, Anchor::Centre, false)
    }
}

/// Two thin lines from the points, a line with arrows between them, the number beside it.
fn draw_dimension(
    canvas: &Canvas<'_>,
    dimension: &Dimension,
    place: &dyn Fn(Point) -> Point,
) -> Result<(), FigureError> {
    let ends = dimension.ends().map(place);
    for (point, end) in [dimension.from, dimension.to].map(place).into_iter().zip(ends) {
        let (dx, dy) = (end.0 - point.0, end.1 - point.1);
        let length = libm::hypot(dx, dy);
        if length > 1.0 {
            let beyond = (end.0 + 5.0 * dx / length, end.1 + 5.0 * dy / length);
            canvas.line(&[point, beyond], INK, 0.75)?;
        }
    }
    canvas.line(&ends, INK, 1.0)?;
    let (dx, dy) = (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1);
    let length = libm::hypot(dx, dy).max(1e-9);
    let along = (dx / length, dy / length);
    for (end, sign) in [(ends[0], 1.0), (ends[1], -1.0)] {
        let back = (end.0 + sign * HEAD * along.0, end.1 + sign * HEAD * along.1);
        let half = (-0.3 * HEAD * along.1, 0.3 * HEAD * along.0);
        let corners = [end, (back.0 + half.0, back.1 + half.1), (back.0 - half.0, back.1 - half.1)];
        canvas.area_filled(&corners, INK)?;
    }
    let middle = (0.5 * (ends[0].0 + ends[1].0), 0.5 * (ends[0].1 + ends[1].1));
    let label = dimension.label();
    if along.0.abs() < 0.3 {
        // upright: the text reads upwards on the left of the line
        return canvas.text(&label, (middle.0 - 12.0, middle.1), SMALL, Anchor::Centre, true);
    }
    if along.1.abs() < 0.3 {
        return canvas.text(&label, (middle.0, middle.1 - 11.0), SMALL, Anchor::Centre, false);
    }
    // oblique: on the side the line falls away from
    let anchor = if along.0 * along.1 < 0.0 { Anchor::Right } else { Anchor::Left };
    let aside = if anchor == Anchor::Right { -8.0 } else { 8.0 };
    canvas.text(&label, (middle.0 + aside, middle.1 - 8.0), SMALL, anchor, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate() -> Sketch {
        let square = |r: f64| vec![(-r, -r), (r, -r), (r, r), (-r, r)];
        Sketch {
            title: "Plate".into(),
            outlines: vec![square(2.0), square(0.5)],
            patches: vec![Patch { corners: square(1.0), colour: 1 }],
            dimensions: vec![
                Dimension { from: (-2.0, 2.0), to: (2.0, 2.0), offset: 0.4, text: "width".into() },
                Dimension { from: (-2.0, -2.0), to: (-2.0, 2.0), offset: 0.4, text: String::new() },
                Dimension { from: (0.0, 0.0), to: (1.5, 1.5), offset: 0.0, text: "R".into() },
            ],
            notes: vec![Note { at: (1.0, -1.5), to: Some((0.8, -0.8)), text: "loaded".into() }],
            ..Sketch::default()
        }
    }

    #[test]
    fn a_sketch_draws_outlines_regions_dimensions_and_notes() {
        insta::assert_snapshot!("sketch", plate().to_svg().expect("drawn"));
    }

    #[test]
    fn a_dimension_says_the_distance_it_spans() {
        let label = |to, text: &str| Dimension { to, text: text.into(), ..Dimension::default() }.label();
        assert_eq!(label((0.0, 4.0), ""), "4 m");
        assert_eq!(label((0.033, 0.0), "gauge"), "gauge 33 mm");
        assert_eq!(label((3e-3, 4.123e-3), ""), "5.099 mm");
        // the diagonal of 0.919 m by 0.919 m
        assert_eq!(label((0.919, 0.919), ""), "1.3 m");
    }

    #[test]
    fn a_sketch_without_extent_or_with_a_broken_point_is_refused() {
        assert_eq!(Sketch::default().to_svg(), Err(FigureError::Empty));
        let mut broken = plate();
        broken.outlines[0][1].0 = f64::NAN;
        assert!(matches!(broken.to_svg(), Err(FigureError::NotFinite { point: 1, .. })));
    }
}
