//! The legend: what each mark means, where it hides nothing.
//!
//! Owns its place and its drawing.

use super::canvas::{Anchor, Canvas, Point, text_width};
use super::curves::Area;
use super::mark::draw_mark;
use super::model::{Figure, FigureError, Mark};
use super::palette::{self, PAPER};

/// Font size of the entries, units.
const SIZE: f64 = 16.0;
/// Height of an entry, units.
const ROW: f64 = 22.0;
/// Length of the sample of a mark, units.
const SAMPLE: f64 = 34.0;
/// Distance of the legend from the axes, units.
const INSET: f64 = 10.0;

/// An entry: legend text, mark (none of a region) and number of the colour.
struct Entry<'a> {
    text: &'a str,
    mark: Option<Mark>,
    colour: usize,
}

/// Entries in a column at a corner of the axes, or in rows above them.
pub(super) struct Legend<'a> {
    entries: Vec<Entry<'a>>,
}

impl<'a> Legend<'a> {
    /// The entries of the series that have a label; of equal ones the first.
    pub(super) fn new(figure: &'a Figure) -> Self {
        let mut entries: Vec<Entry<'a>> = Vec::new();
        for (i, series) in figure.series.iter().enumerate() {
            let (text, mark) = (series.label.as_str(), Some(series.mark));
            let entry = Entry { text, mark, colour: series.colour.unwrap_or(i) };
            let is_known =
                entries.iter().any(|e| (e.text, e.mark, e.colour) == (entry.text, entry.mark, entry.colour));
            if !entry.text.is_empty() && !is_known {
                entries.push(entry);
            }
        }
        let bands = figure.bands.iter().filter(|band| !band.label.is_empty());
        entries.extend(bands.map(|band| Entry { text: &band.label, mark: None, colour: band.colour }));
        Self { entries }
    }

    fn width(&self) -> f64 {
        let widest = self.entries.iter().map(|e| text_width(e.text, SIZE)).fold(0.0, f64::max);
        SAMPLE + 8.0 + widest
    }

    /// The upper left of the column at the corner where it covers none of `drawn`, if there is one.
    pub(super) fn free_corner(&self, frame: &Area, drawn: &[Point]) -> Option<Point> {
        let (width, height) = (self.width() + 8.0, ROW * self.entries.len() as f64 + 8.0);
        let (left, right) = (frame.left + INSET, frame.right - INSET - width);
        let (top, bottom) = (frame.top + INSET, frame.bottom - INSET - height);
        if right < left || bottom < top {
            return None;
        }
        [(left, top), (right, top), (right, bottom), (left, bottom)].into_iter().find(|&(x, y)| {
            !drawn.iter().any(|&(a, b)| {
                (x - 6.0..=x + width + 6.0).contains(&a) && (y - 6.0..=y + height + 6.0).contains(&b)
            })
        })
    }

    /// Draws the column with its upper left at `at`.
    pub(super) fn draw_column(&self, canvas: &Canvas<'_>, (x, y): Point) -> Result<(), FigureError> {
        if self.entries.is_empty() {
            return Ok(());
        }
        let height = ROW * self.entries.len() as f64 + 8.0;
        canvas.box_filled((x, y), (x + self.width() + 8.0, y + height), PAPER)?;
        for (i, entry) in self.entries.iter().enumerate() {
            entry.draw(canvas, (x + 4.0, y + 4.0 + ROW * (i as f64 + 0.5)))?;
        }
        Ok(())
    }

    /// Rows of entries no wider than `width`.
    fn rows(&self, width: f64) -> Vec<Vec<&Entry<'a>>> {
        let mut rows: Vec<Vec<&Entry<'a>>> = Vec::new();
        let mut used = f64::INFINITY;
        for entry in &self.entries {
            if used + entry.width() > width {
                rows.push(Vec::new());
                used = 0.0;
            }
            used += entry.width();
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
        }
        rows
    }

    /// Height of the rows, units.
    pub(super) fn rows_height(&self, width: f64) -> f64 {
        ROW * self.rows(width).len() as f64
    }

    /// Draws rows of at most `width` with their upper left at `at`.
    pub(super) fn draw_rows(
        &self,
        canvas: &Canvas<'_>,
        (left, top): Point,
        width: f64,
    ) -> Result<(), FigureError> {
        for (i, row) in self.rows(width).iter().enumerate() {
            let mut x = left;
            for entry in row {
                entry.draw(canvas, (x, top + ROW * (i as f64 + 0.5)))?;
                x += entry.width();
            }
        }
        Ok(())
    }
}

impl Entry<'_> {
    fn width(&self) -> f64 {
        SAMPLE + 8.0 + text_width(self.text, SIZE) + 16.0
    }

    fn draw(&self, canvas: &Canvas<'_>, (x, y): Point) -> Result<(), FigureError> {
        let colour = palette::series(self.colour);
        let middle = [(x + 0.5 * SAMPLE, y)];
        match self.mark {
            None => {
                let (from, to) = ((x, y - 6.0), (x + SAMPLE, y + 6.0));
                canvas.box_filled(from, to, palette::tint(self.colour))?;
            }
            Some(mark) => {
                if mark != Mark::Markers {
                    let line = if mark == Mark::Dashed { Mark::Dashed } else { Mark::Line };
                    draw_mark(canvas, &[(x, y), (x + SAMPLE, y)], line, colour, self.colour)?;
                }
                if matches!(mark, Mark::Markers | Mark::LineMarkers) {
                    draw_mark(canvas, &middle, mark, colour, self.colour)?;
                }
            }
        }
        canvas.text(self.text, (x + SAMPLE + 8.0, y), SIZE, Anchor::Left, false)
    }
}
