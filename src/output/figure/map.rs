//! A map: one number over two others, as coloured cells.
//!
//! Owns the picture of a [`MapFigure`]: axes, cells, a colour bar, and two kinds of cell without a colour of
//! the bar, crossed out and grey.

use super::axis::Ruler;
use super::canvas::{Anchor, Canvas, Point, page, text_width};
use super::colour_bar::{Beyond, ColourBar};
use super::colour_map::viridis;
use super::model::{Axis, FigureError, Scale};
use super::palette::{self, Colour, INK};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
const SMALL: f64 = 16.0;
const LARGE: f64 = 18.0;
const TICK: f64 = 6.0;
/// Width of the colour bar with its numbers and label, units.
const BAR: f64 = 122.0;
/// Ground of cells nothing is known of.
const UNKNOWN: Colour = (0xcc, 0xcc, 0xcc);
/// Range of values from which the colours follow the logarithm.
const DECADES: f64 = 30.0;

/// One cell of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell {
    /// A value of the colour bar.
    Value(f64),
    /// Crossed out: what the map is about fails here.
    Lost,
    /// Nothing is known.
    Unknown,
    /// Not part of the map: left white.
    Absent,
}

/// One number over two others.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapFigure {
    /// Line above the axes.
    pub title: String,
    /// The abscissa.
    pub x: Axis,
    /// The ordinate.
    pub y: Axis,
    /// What the colours show.
    pub value: Axis,
    /// Middles of the cells along x, evenly spaced.
    pub across: Vec<f64>,
    /// Middles of the cells along y, evenly spaced.
    pub up: Vec<f64>,
    /// Cells, a row of x for each y.
    pub cells: Vec<Vec<Cell>>,
    /// What crossed-out cells mean.
    pub lost: String,
    /// What grey cells mean.
    pub unknown: String,
    /// A point to mark.
    pub mark: Option<(f64, f64)>,
    /// Lines kept in the file.
    pub provenance: Vec<String>,
}

impl MapFigure {
    /// The map as SVG; the same map gives the same bytes on every machine.
    ///
    /// # Errors
    /// [`FigureError::Empty`] without two cells either way, [`FigureError::Panel`] where rows are missing or
    /// a value is not finite, and [`FigureError::Drawing`].
    pub fn to_svg(&self) -> Result<String, FigureError> {
        if self.across.len() < 2 || self.up.len() < 2 {
            return Err(FigureError::Empty);
        }
        let whole = self.cells.len() == self.up.len()
            && self.cells.iter().all(|row| row.len() == self.across.len())
            && self.values().all(f64::is_finite);
        if !whole {
            return Err(FigureError::Panel { caption: self.title.clone() });
        }
        let layout = Layout::new(self);
        page((WIDTH, HEIGHT), &self.title, &self.provenance.join("\n"), |canvas| layout.draw(canvas))
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.cells.iter().flatten().filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value),
            _ => None,
        })
    }
}

struct Layout<'a> {
    figure: &'a MapFigure,
    x: Ruler,
    y: Ruler,
    bar: Ruler,
    /// left, right, top, bottom
    frame: [f64; 4],
}

impl<'a> Layout<'a> {
    fn new(figure: &'a MapFigure) -> Self {
        let ends = |middles: &[f64]| {
            let half = 0.5 * (middles[1] - middles[0]).abs();
            let low = middles.iter().copied().fold(f64::INFINITY, f64::min);
            let high = middles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            (low - half, high + half)
        };
        let (low, high) = ends(&figure.across);
        let x = Ruler::new(&figure.x, low, high);
        let (low, high) = ends(&figure.up);
        let y = Ruler::new(&figure.y, low, high);
        let low = figure.values().fold(f64::INFINITY, f64::min);
        let high = figure.values().fold(f64::NEG_INFINITY, f64::max);
        let is_wide = low > 0.0 && high / low > DECADES;
        let scale = if is_wide { Scale::Logarithmic } else { figure.value.scale };
        let bar = if low <= high {
            Ruler::new(&Axis { scale, ..figure.value.clone() }, low, high)
        } else {
            Ruler::new(&Axis { scale: Scale::Linear, ..figure.value.clone() }, 0.0, 1.0)
        };
        let widest = y.major.iter().map(|(_, text)| text_width(text, SMALL)).fold(0.0, f64::max);
        let frame = [
            12.0 + LARGE + 8.0 + widest + 4.0 + TICK,
            f64::from(WIDTH) - BAR - 14.0,
            46.0,
            f64::from(HEIGHT) - (TICK + 4.0 + SMALL + 8.0 + LARGE + 40.0),
        ];
        Self { figure, x, y, bar, frame }
    }

    fn place(&self, x: f64, y: f64) -> Point {
        let [left, right, top, bottom] = self.frame;
        (left + (right - left) * self.x.fraction(x), bottom - (bottom - top) * self.y.fraction(y))
    }

    fn draw(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let figure = self.figure;
        let half_x = 0.5 * (figure.across[1] - figure.across[0]);
        let half_y = 0.5 * (figure.up[1] - figure.up[0]);
        for (&y, row) in figure.up.iter().zip(&figure.cells) {
            for (&x, cell) in figure.across.iter().zip(row) {
                let from = self.place(x - half_x, y + half_y);
                let to = self.place(x + half_x, y - half_y);
                let colour = match cell {
                    Cell::Value(value) => viridis(self.bar.fraction(*value)),
                    Cell::Unknown => UNKNOWN,
                    Cell::Lost | Cell::Absent => continue,
                };
                // A cell reaches under the next, so no line of paper shows between them.
                canvas.box_filled(from, (to.0 + 0.5, to.1 + 0.5), colour)?;
            }
        }
        // Crosses last, so that no neighbour covers them.
        for (&y, row) in figure.up.iter().zip(&figure.cells) {
            for (&x, _) in figure.across.iter().zip(row).filter(|(_, cell)| **cell == Cell::Lost) {
                let from = self.place(x - half_x, y + half_y);
                let to = self.place(x + half_x, y - half_y);
                cross(canvas, from, to)?;
            }
        }
        if let Some((x, y)) = figure.mark {
            canvas.circle(self.place(x, y), 5.0, INK, false)?;
        }
        self.draw_axes(canvas)?;
        self.draw_bar(canvas)?;
        self.draw_key(canvas)
    }

    fn draw_axes(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let [left, right, top, bottom] = self.frame;
        for (value, text) in &self.x.major {
            let at = left + (right - left) * self.x.fraction(*value);
            canvas.line(&[(at, bottom), (at, bottom + TICK)], INK, 1.25)?;
            canvas.text(text, (at, bottom + TICK + 4.0 + 0.5 * SMALL), SMALL, Anchor::Centre, false)?;
        }
        for (value, text) in &self.y.major {
            let at = bottom - (bottom - top) * self.y.fraction(*value);
            canvas.line(&[(left - TICK, at), (left, at)], INK, 1.25)?;
            canvas.text(text, (left - TICK - 4.0, at), SMALL, Anchor::Right, false)?;
        }
        canvas.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], INK, 1.25)?;
        let below = (0.5 * (left + right), bottom + TICK + 4.0 + SMALL + 8.0 + 0.5 * LARGE);
        canvas.text(&self.x.label, below, LARGE, Anchor::Centre, false)?;
        let side = (12.0 + 0.5 * LARGE, 0.5 * (top + bottom));
        canvas.text(&self.y.label, side, LARGE, Anchor::Centre, true)?;
        canvas.text(&self.figure.title, (0.5 * f64::from(WIDTH), 24.0), LARGE, Anchor::Centre, false)
    }

    fn draw_bar(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let [_, frame_right, top, bottom] = self.frame;
        let bar = ColourBar { left: frame_right + 16.0, top, bottom, label: f64::from(WIDTH) - 12.0 };
        bar.draw(canvas, &self.bar, &self.figure.value.unit, Beyond::default())
    }

    /// What cells without a colour of the bar mean, where there are any.
    fn draw_key(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let has = |kind: Cell| self.figure.cells.iter().flatten().any(|cell| *cell == kind);
        let (mut left, y, size) = (self.frame[0], f64::from(HEIGHT) - 16.0, 14.0);
        for (kind, text) in [(Cell::Lost, &self.figure.lost), (Cell::Unknown, &self.figure.unknown)] {
            if !has(kind) {
                continue;
            }
            let (from, to) = ((left, y - 0.5 * size), (left + size, y + 0.5 * size));
            match kind {
                Cell::Lost => cross(canvas, from, to)?,
                _ => canvas.box_filled(from, to, UNKNOWN)?,
            }
            canvas.text(text, (left + size + 8.0, y), SMALL, Anchor::Left, false)?;
            left += size + 8.0 + text_width(text, SMALL) + 24.0;
        }
        Ok(())
    }
}

/// A cell crossed out in the colour of warnings.
fn cross(canvas: &Canvas<'_>, from: Point, to: Point) -> Result<(), FigureError> {
    let colour = palette::series(1);
    canvas.line(&[from, to], colour, 1.0)?;
    canvas.line(&[(from.0, to.1), (to.0, from.1)], colour, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> MapFigure {
        let middles: Vec<f64> = (0..9).map(|i| 0.8 + 0.05 * f64::from(i)).collect();
        let cell = |x: f64, y: f64| match x + y {
            sum if sum < 1.7 => Cell::Lost,
            sum if sum > 2.35 => Cell::Unknown,
            sum => Cell::Value(1e3 * sum * sum),
        };
        let axis =
            |label: &str, unit: &str| Axis { label: label.into(), unit: unit.into(), ..Axis::default() };
        MapFigure {
            title: "a law".into(),
            x: axis("stretch along x", ""),
            y: axis("stretch along y", ""),
            value: axis("smallest acoustic eigenvalue", "Pa"),
            cells: middles.iter().map(|&y| middles.iter().map(|&x| cell(x, y)).collect()).collect(),
            across: middles.clone(),
            up: middles,
            lost: "ellipticity lost".into(),
            unknown: "too stiff to tell".into(),
            mark: Some((1.0, 1.0)),
            provenance: vec!["tissue 0.1.0".into()],
        }
    }

    #[test]
    fn a_map_draws_cells_crosses_key_and_colour_bar() {
        insta::assert_snapshot!("map", map().to_svg().expect("drawn"));
    }

    #[test]
    fn a_map_with_missing_cells_or_values_that_are_none_is_refused() {
        let mut broken = map();
        broken.cells[3].pop();
        assert!(matches!(broken.to_svg(), Err(FigureError::Panel { .. })));
        let mut broken = map();
        broken.cells[3][3] = Cell::Value(f64::NAN);
        assert!(matches!(broken.to_svg(), Err(FigureError::Panel { .. })));
        assert_eq!(MapFigure::default().to_svg(), Err(FigureError::Empty));
    }
}
