//! A figure of particle fields: panels, scale bar, colour bar.
//!
//! Owns the picture of a [`FieldFigure`]. All panels have one scale and one colour bar.

use super::axis::{Ruler, round_below, ten};
use super::canvas::{Anchor, Canvas, Point, page};
use super::colour_bar::{Beyond, ColourBar};
use super::colour_map::viridis;
use super::field::FieldFigure;
use super::model::{Axis, FigureError};
use super::palette::INK;
use super::surface::{Piece, pieces};
use super::symbol::{decimal, scaled};

const WIDTH: u32 = 640;
/// Tallest panel, units.
const TALLEST: f64 = 400.0;
/// Least height of the page, units, which the colour bar needs.
const LEAST_HEIGHT: f64 = 220.0;
/// Width of the colour bar with its numbers and label, units.
const BAR: f64 = 118.0;
const GAP: f64 = 16.0;
const SMALL: f64 = 16.0;
const LARGE: f64 = 18.0;

impl FieldFigure {
    /// The figure as SVG; the same figure gives the same bytes on every machine.
    ///
    /// # Errors
    /// As [`FieldFigure::check`], and [`FigureError::Drawing`].
    pub fn to_svg(&self) -> Result<String, FigureError> {
        self.check()?;
        let layout = Layout::new(self);
        // Flat cells seen from the side have no face to draw.
        if !(layout.scale.is_finite() && layout.scale > 0.0) {
            return Err(FigureError::Empty);
        }
        // Positive and below some thousand: a row is at most as tall as a panel may be.
        let height = libm::ceil(layout.height) as u32;
        let description = self.provenance.join("\n");
        page((WIDTH, height), &self.title, &description, |canvas| layout.draw(canvas))
    }
}

/// Panels with their places settled.
struct Layout<'a> {
    figure: &'a FieldFigure,
    /// What is seen of each panel.
    pieces: Vec<Vec<Piece>>,
    /// The colour bar.
    ruler: Ruler,
    beyond: Beyond,
    /// Least and largest coordinates on the plane of the view over all panels, m.
    low: Point,
    high: Point,
    /// Units of the page per m.
    scale: f64,
    columns: usize,
    cell: Point,
    top: f64,
    height: f64,
}

impl<'a> Layout<'a> {
    fn new(figure: &'a FieldFigure) -> Self {
        let pieces: Vec<Vec<Piece>> = figure.panels.iter().map(|panel| pieces(panel, &figure.view)).collect();
        let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
        let mut include = |(x, y): Point| {
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        };
        for piece in pieces.iter().flatten() {
            match *piece {
                Piece::Share(ref corners, _) => corners.iter().copied().for_each(&mut include),
                Piece::Edge(ends) => ends.into_iter().for_each(&mut include),
                Piece::Disc((x, y), r, _) => {
                    include((x - r, y - r));
                    include((x + r, y + r));
                }
            }
        }
        let columns = figure.columns.clamp(1, figure.panels.len());
        let rows = figure.panels.len().div_ceil(columns);
        let width = (f64::from(WIDTH) - BAR - GAP) / columns as f64 - GAP;
        let (wide, tall) = (high.0 - low.0, high.1 - low.1);
        let scale = (width / wide).min(TALLEST / tall);
        let has_captions = figure.panels.iter().any(|panel| !panel.caption.is_empty());
        let caption = if has_captions { SMALL + 8.0 } else { 0.0 };
        let cell = (width + GAP, scale * tall + caption + GAP);
        let top = if figure.title.is_empty() { GAP } else { 46.0 };
        let needed = top + cell.1 * rows as f64 + SMALL + 26.0;
        let (first, last) = figure.values_range();
        let (label, unit) = (figure.label.clone(), figure.unit.clone());
        let axis =
            Axis { label, unit, range: figure.range.filter(|range| range.0 < range.1), ..Axis::default() };
        let seen = pieces.iter().flatten().filter_map(|piece| match *piece {
            Piece::Share(_, value) | Piece::Disc(_, _, value) => Some(value),
            Piece::Edge(_) => None,
        });
        let ruler = Ruler::new(&axis, first, last);
        let beyond = Beyond::new(&ruler, seen);
        Self {
            figure,
            pieces,
            ruler,
            beyond,
            low,
            high,
            scale,
            columns,
            cell,
            top,
            height: needed.max(LEAST_HEIGHT),
        }
    }

    fn draw(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let middle = 0.5 * (f64::from(WIDTH) - BAR);
        canvas.text(&self.figure.title, (middle, 24.0), LARGE, Anchor::Centre, false)?;
        for (i, (panel, pieces)) in self.figure.panels.iter().zip(&self.pieces).enumerate() {
            let left = GAP + self.cell.0 * (i % self.columns) as f64;
            let top = self.top + self.cell.1 * (i / self.columns) as f64;
            // In the middle of its column.
            let spare = self.cell.0 - GAP - self.scale * (self.high.0 - self.low.0);
            let origin = (left + 0.5 * spare, top + self.scale * (self.high.1 - self.low.1));
            for piece in pieces {
                self.draw_piece(canvas, piece, origin)?;
            }
            let below = (left + 0.5 * (self.cell.0 - GAP), origin.1 + 8.0 + 0.5 * SMALL);
            canvas.text(&panel.caption, below, SMALL, Anchor::Centre, false)?;
        }
        self.draw_scale(canvas)?;
        self.draw_bar(canvas)
    }

    fn draw_piece(&self, canvas: &Canvas<'_>, piece: &Piece, origin: Point) -> Result<(), FigureError> {
        let place = |(x, y): Point| {
            (origin.0 + self.scale * (x - self.low.0), origin.1 - self.scale * (y - self.low.1))
        };
        match *piece {
            Piece::Share(ref corners, value) => {
                let corners: Vec<Point> = corners.iter().copied().map(place).collect();
                canvas.patch(&corners, viridis(self.ruler.fraction(value)))
            }
            Piece::Edge(ends) => canvas.line(&ends.map(place), INK, 0.75),
            Piece::Disc(centre, radius, value) => {
                canvas.dot(place(centre), self.scale * radius, viridis(self.ruler.fraction(value)))
            }
        }
    }

    /// A bar of round length at the foot of the page.
    fn draw_scale(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let length = round_below(0.3 * (self.high.0 - self.low.0));
        let unit = scaled("m", length);
        let drawn = length / ten(1, unit.exponent);
        let text = format!("{} {}", decimal(drawn, usize::from(drawn.fract() != 0.0)), unit.text);
        let y = self.height - 14.0;
        let (left, right) = (GAP, GAP + self.scale * length);
        canvas.line(&[(left, y - 5.0), (left, y + 5.0)], INK, 1.5)?;
        canvas.line(&[(left, y), (right, y)], INK, 1.5)?;
        canvas.line(&[(right, y - 5.0), (right, y + 5.0)], INK, 1.5)?;
        canvas.text(&text, (right + 8.0, y), SMALL, Anchor::Left, false)
    }

    fn draw_bar(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let page = f64::from(WIDTH);
        let bar =
            ColourBar { left: page - BAR + 6.0, top: 22.0, bottom: self.height - 22.0, label: page - 14.0 };
        bar.draw(canvas, &self.ruler, &self.figure.unit, self.beyond)
    }
}

#[cfg(test)]
mod tests {
    use super::super::field::{Panel, View};
    use super::super::surface::outer_faces;
    use super::*;
    use crate::output::frame::{Frame, FrameField};
    use crate::tensor::Vec3;

    /// A strip of 10 × 3 × 0.5 mm pulled by `stretch`, its waist narrowed, an eighth of it as particles.
    fn strip(stretch: f64) -> Frame {
        let mut frame = Frame::default();
        let mut pressure = Vec::new();
        for k in 0..2 {
            for j in 0..7 {
                for i in 0..21 {
                    let x = Vec3::new(f64::from(i) * 0.25e-3, f64::from(j) * 0.25e-3, f64::from(k) * 0.25e-3);
                    let waist = 1.0 - (stretch - 1.0) * (1.0 - x.x * x.x / 25e-6);
                    let u = Vec3::new((stretch - 1.0) * x.x, (waist - 1.0) * x.y, 0.0);
                    frame.reference.push(x);
                    frame.displacement.push(u);
                    pressure.push((waist - 0.9) * 1e5);
                }
            }
        }
        frame.fields.push(FrameField::scalar("pressure", "Pa", &pressure));
        frame
    }

    fn panel(stretch: f64) -> Panel {
        let caption = format!("stretch {stretch}");
        let panel = Panel::new(&caption, &strip(stretch), "pressure", 0, 0.25e-3).expect("has a pressure");
        panel.mirrored(0, 0.0, false).mirrored(1, 0.0, false)
    }

    fn stages() -> FieldFigure {
        FieldFigure {
            title: "Axial strip".into(),
            label: "pressure".into(),
            unit: "Pa".into(),
            panels: vec![panel(1.1), panel(1.2)],
            columns: 1,
            ..FieldFigure::default()
        }
    }

    /// A cube of cells, sheared and seen obliquely.
    fn cube() -> FieldFigure {
        let n = 8;
        let m = n + 1;
        let at = |i: usize, j: usize, k: usize| i + m * (j + m * k);
        let mut panel = Panel::default();
        let mut hexahedra = Vec::new();
        for (k, j, i) in (0..m * m * m).map(|c| (c / (m * m), c / m % m, c % m)) {
            let x = Vec3::new(i as f64, j as f64, k as f64) / n as f64;
            panel.positions.push(Vec3::new(x.x + 0.3 * x.z, x.y, x.z));
            panel.values.push(1e-6 * (x.x * x.y - x.z));
            if i < n && j < n && k < n {
                let layer = |k| [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)];
                let (low, high) = (layer(k), layer(k + 1));
                hexahedra.push(std::array::from_fn(|c| if c < 4 { low[c] } else { high[c - 4] }));
            }
        }
        panel.faces = outer_faces(&hexahedra);
        FieldFigure {
            label: "J − 1".into(),
            panels: vec![panel],
            columns: 1,
            view: View::oblique(),
            ..FieldFigure::default()
        }
    }

    #[test]
    fn field_figures_draw_bodies_captions_scale_and_colour_bar() {
        insta::assert_snapshot!("stages", stages().to_svg().expect("drawn"));
        insta::assert_snapshot!("cube", cube().to_svg().expect("drawn"));
    }

    #[test]
    fn every_piece_is_drawn_inside_the_page_left_of_the_colour_bar() {
        for figure in [stages(), cube(), FieldFigure { columns: 2, ..stages() }] {
            let layout = Layout::new(&figure);
            let right = GAP + layout.cell.0 * (layout.columns - 1) as f64 + layout.cell.0 - GAP;
            assert!(right <= f64::from(WIDTH) - BAR + 1e-9);
            assert!(layout.scale * (layout.high.0 - layout.low.0) <= layout.cell.0 - GAP + 1e-9);
            assert!(layout.height < 900.0);
        }
    }

    #[test]
    fn a_panel_without_its_field_or_with_missing_values_is_refused() {
        let error = Panel::new("a", &strip(1.1), "sigma", 0, 1.0).expect_err("no such field");
        assert_eq!(error.to_string(), "the frame has no component 0 of a field `sigma`");
        let mut figure = stages();
        figure.panels[1].values.pop();
        assert_eq!(figure.to_svg(), Err(FigureError::Panel { caption: "stretch 1.2".into() }));
        let mut flat = cube();
        flat.panels[0].positions.iter_mut().for_each(|x| x.fill(0.0));
        assert_eq!(flat.to_svg(), Err(FigureError::Empty));
        figure.panels.clear();
        assert_eq!(figure.to_svg(), Err(FigureError::Empty));
    }
}
