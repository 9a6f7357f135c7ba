//! A figure of curves: layout, axes, lines and markers.
//!
//! Owns the picture of a [`Figure`]. 640 by 480 units with text of 16 units and more, readable at the
//! width of a journal's column.

use super::axis::Ruler;
use super::canvas::{Anchor, Canvas, Point, page, text_width};
use super::clip;
use super::legend::Legend;
use super::mark::draw_mark;
use super::model::{Figure, FigureError, Mark, Series, Slope};
use super::palette::{self, GRID, INK};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
/// Font size of numbers, units.
const SMALL: f64 = 16.0;
/// Font size of labels and the title, units.
const LARGE: f64 = 18.0;
/// Length of a tick, units.
const TICK: f64 = 6.0;

/// The rectangle of the axes on the page, units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

impl Figure {
    /// The figure as SVG; the same figure gives the same bytes on every machine.
    ///
    /// # Errors
    /// As [`Figure::check`], and [`FigureError::Drawing`].
    pub fn to_svg(&self) -> Result<String, FigureError> {
        self.check()?;
        let plot = Plot::new(self);
        page((WIDTH, HEIGHT), &self.title, &self.provenance.join("\n"), |canvas| plot.draw(canvas))
    }
}

/// A figure with its axes and layout settled.
struct Plot<'a> {
    figure: &'a Figure,
    x: Ruler,
    y: Ruler,
    frame: Area,
    legend: Legend<'a>,
    /// Upper left of the legend; rows above the axes where absent.
    corner: Option<Point>,
}

impl<'a> Plot<'a> {
    fn new(figure: &'a Figure) -> Self {
        let corners = || figure.bands.iter().flat_map(|band| &band.corners);
        let all = || figure.series.iter().flat_map(|series| &series.points).chain(corners());
        let range = |pick: fn(&(f64, f64)) -> f64| {
            let low = all().map(pick).fold(f64::INFINITY, f64::min);
            let high = all().map(pick).fold(f64::NEG_INFINITY, f64::max);
            (low, high)
        };
        let (low, high) = range(|point| point.0);
        let x = Ruler::new(&figure.x, low, high);
        let (low, high) = range(|point| point.1);
        let y = Ruler::new(&figure.y, low, high);
        let widest = y.major.iter().map(|(_, text)| text_width(text, SMALL)).fold(0.0, f64::max);
        let overhang = x.major.last().map_or(0.0, |(_, text)| 0.5 * text_width(text, SMALL));
        let frame = Area {
            left: 12.0 + LARGE + 8.0 + widest + 4.0 + TICK,
            right: f64::from(WIDTH) - overhang.max(10.0) - 8.0,
            top: if figure.title.is_empty() { 18.0 } else { 46.0 },
            bottom: f64::from(HEIGHT) - (TICK + 4.0 + SMALL + 8.0 + LARGE + 12.0),
        };
        let legend = Legend::new(figure);
        let mut plot = Self { figure, x, y, frame, legend, corner: None };
        plot.corner = plot.legend.free_corner(&plot.frame, &plot.drawn());
        if plot.corner.is_none() {
            plot.frame.top += plot.legend.rows_height(plot.frame.right - plot.frame.left) + 8.0;
        }
        plot
    }

    /// Place of a value pair on the page.
    fn place(&self, &(x, y): &(f64, f64)) -> Point {
        let Area { left, right, top, bottom } = self.frame;
        (left + (right - left) * self.x.fraction(x), bottom - (bottom - top) * self.y.fraction(y))
    }

    fn places(&self, series: &Series) -> Vec<Point> {
        series.points.iter().map(|point| self.place(point)).collect()
    }

    /// The lines of a series, or its markers, cut off at the axes.
    fn parts(&self, series: &Series) -> Vec<Vec<Point>> {
        let places = self.places(series);
        let is_line = series.mark != Mark::Markers;
        if places.iter().all(|place| clip::holds(&self.frame, *place)) {
            return vec![places];
        }
        if is_line {
            return clip::line(&places, &self.frame);
        }
        vec![places.into_iter().filter(|place| clip::holds(&self.frame, *place)).collect()]
    }

    /// Points of the page that something is drawn on, close enough together for the legend to avoid.
    fn drawn(&self) -> Vec<Point> {
        let mut all = Vec::new();
        for series in &self.figure.series {
            let parts = self.parts(series);
            all.extend(parts.iter().filter_map(|part| part.first().copied()));
            for pair in parts.iter().flat_map(|part| part.windows(2)) {
                let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
                // Bounded by the size of the page: every place is on it.
                let n = 1 + libm::ceil(libm::hypot(x1 - x0, y1 - y0) / 4.0) as u32;
                let is_line = series.mark != Mark::Markers;
                let between = if is_line { 1..=n } else { n..=n };
                all.extend(between.map(|i| {
                    let s = f64::from(i) / f64::from(n);
                    (x0 + s * (x1 - x0), y0 + s * (y1 - y0))
                }));
            }
        }
        all
    }

    fn draw(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        self.draw_axes(canvas)?;
        for (i, series) in self.figure.series.iter().enumerate() {
            let number = series.colour.unwrap_or(i);
            for part in self.parts(series) {
                draw_mark(canvas, &part, series.mark, palette::series(number), number)?;
            }
        }
        for slope in &self.figure.slopes {
            self.draw_slope(canvas, *slope)?;
        }
        match self.corner {
            Some(corner) => self.legend.draw_column(canvas, corner),
            None => {
                let Area { left, right, top, .. } = self.frame;
                let height = self.legend.rows_height(right - left);
                self.legend.draw_rows(canvas, (left, top - height - 6.0), right - left)
            }
        }
    }

    fn draw_axes(&self, canvas: &Canvas<'_>) -> Result<(), FigureError> {
        let Area { left, right, top, bottom } = self.frame;
        for band in &self.figure.bands {
            let places: Vec<Point> = band.corners.iter().map(|corner| self.place(corner)).collect();
            let inside = clip::region(&places, &self.frame);
            if inside.len() > 2 {
                canvas.area_filled(&inside, palette::tint(band.colour))?;
            }
        }
        let across = |value: f64| left + (right - left) * self.x.fraction(value);
        let up = |value: f64| bottom - (bottom - top) * self.y.fraction(value);
        for (value, _) in &self.x.major {
            canvas.line(&[(across(*value), top), (across(*value), bottom)], GRID, 1.0)?;
        }
        for (value, _) in &self.y.major {
            canvas.line(&[(left, up(*value)), (right, up(*value))], GRID, 1.0)?;
        }
        for value in &self.x.minor {
            canvas.line(&[(across(*value), bottom), (across(*value), bottom + 0.5 * TICK)], INK, 1.0)?;
        }
        for value in &self.y.minor {
            canvas.line(&[(left - 0.5 * TICK, up(*value)), (left, up(*value))], INK, 1.0)?;
        }
        for (value, text) in &self.x.major {
            let at = across(*value);
            canvas.line(&[(at, bottom), (at, bottom + TICK)], INK, 1.25)?;
            canvas.text(text, (at, bottom + TICK + 4.0 + 0.5 * SMALL), SMALL, Anchor::Centre, false)?;
        }
        for (value, text) in &self.y.major {
            let at = up(*value);
            canvas.line(&[(left - TICK, at), (left, at)], INK, 1.25)?;
            canvas.text(text, (left - TICK - 4.0, at), SMALL, Anchor::Right, false)?;
        }
        let outline = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        canvas.line(&outline, INK, 1.25)?;
        let (middle, height) = (0.5 * (left + right), f64::from(HEIGHT));
        canvas.text(&self.x.label, (middle, height - 10.0 - 0.5 * LARGE), LARGE, Anchor::Centre, false)?;
        let side = (12.0 + 0.5 * LARGE, 0.5 * (top + bottom));
        canvas.text(&self.y.label, side, LARGE, Anchor::Centre, true)?;
        canvas.text(&self.figure.title, (0.5 * f64::from(WIDTH), 24.0), LARGE, Anchor::Centre, false)
    }

    /// A right triangle below the middle of a series, its hypotenuse of the given order.
    fn draw_slope(&self, canvas: &Canvas<'_>, slope: Slope) -> Result<(), FigureError> {
        let points = &self.figure.series[slope.series].points;
        let low = points.iter().copied().fold(points[0], |a, b| if b.0 < a.0 { b } else { a });
        let high = points.iter().copied().fold(points[0], |a, b| if b.0 > a.0 { b } else { a });
        // A third of the series' width, from one third on, a third of its height lower.
        let ratio = high.0 / low.0;
        let (x0, x1) = (low.0 * libm::cbrt(ratio), low.0 * libm::cbrt(ratio * ratio));
        let y0 = low.1 * libm::pow(x0 / low.0, libm::log(high.1 / low.1) / libm::log(ratio));
        let y1 = y0 * libm::pow(x1 / x0, slope.order);
        let drop = 18.0;
        let below = |(x, y): Point| (x, y + drop);
        let (a, b) = (below(self.place(&(x0, y0))), below(self.place(&(x1, y1))));
        let corner = (b.0, a.1);
        canvas.line(&[a, corner, b, a], INK, 1.25)?;
        let text = super::symbol::decimal(slope.order, usize::from(slope.order.fract() != 0.0));
        canvas.text(&text, (b.0 + 6.0, 0.5 * (a.1 + b.1)), SMALL, Anchor::Left, false)
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::{Axis, Scale};
    use super::*;

    fn force() -> Figure {
        let curve = |k: f64| {
            (0..=40)
                .map(|i| {
                    let d = 5e-5 * f64::from(i);
                    (d, 0.02 * k * (libm::exp(d * 2.3e3) - 1.0))
                })
                .collect::<Vec<_>>()
        };
        let reference = curve(0.97).into_iter().step_by(5).collect();
        Figure {
            title: "Axial strip, κ = 0.226".into(),
            x: Axis { label: "end displacement".into(), unit: "m".into(), ..Axis::default() },
            y: Axis { label: "force".into(), unit: "N".into(), ..Axis::default() },
            series: vec![
                Series { label: "particles".into(), points: curve(1.0), ..Series::default() },
                Series {
                    label: "mid-section".into(),
                    points: curve(0.8),
                    mark: Mark::Dashed,
                    colour: Some(2),
                },
                Series {
                    label: "finite elements".into(),
                    points: reference,
                    mark: Mark::Markers,
                    colour: Some(0),
                },
            ],
            provenance: vec!["tissue 0.1.0".into(), "input a & b.tissue".into()],
            ..Figure::default()
        }
    }

    fn orders() -> Figure {
        let error = |c: f64, p: f64| [0.1, 0.05, 0.025, 0.0125].map(|h| (h, c * libm::pow(h, p))).to_vec();
        let axis = |label: &str, unit: &str| Axis {
            label: label.into(),
            unit: unit.into(),
            scale: Scale::Logarithmic,
            range: None,
        };
        Figure {
            title: "Manufactured solution".into(),
            x: axis("spacing", "m"),
            y: axis("error", ""),
            series: ["u", "v", "P"]
                .iter()
                .zip([(0.5, 2.0), (0.2, 2.1), (3.0, 1.9)])
                .map(|(name, (c, p))| Series {
                    label: (*name).into(),
                    points: error(c, p),
                    mark: Mark::LineMarkers,
                    colour: None,
                })
                .collect(),
            slopes: vec![Slope { series: 1, order: 2.0 }],
            ..Figure::default()
        }
    }

    /// A curve through all corners, so that the legend has to leave the axes.
    fn crowded() -> Figure {
        let zigzag = (0..=60).map(|i| (f64::from(i), if i % 2 == 0 { -4e5 } else { 4e5 })).collect();
        let mut figure = force();
        figure.y.unit = "kg m^-2 s^-1".into();
        figure.series =
            vec![Series { label: "momentum of the whole body".into(), points: zigzag, ..Series::default() }];
        figure
    }

    #[test]
    fn the_same_figure_gives_the_same_bytes_and_another_gives_others() {
        assert_eq!(force().to_svg(), force().to_svg());
        let mut other = force();
        other.series[0].points[20].1 *= 1.1;
        assert_ne!(force().to_svg(), other.to_svg());
    }

    #[test]
    fn a_curve_figure_draws_axes_units_legend_and_provenance() {
        insta::assert_snapshot!("force", force().to_svg().expect("drawn"));
        insta::assert_snapshot!("orders", orders().to_svg().expect("drawn"));
        insta::assert_snapshot!("crowded", crowded().to_svg().expect("drawn"));
    }

    #[test]
    fn every_point_is_drawn_inside_the_axes() {
        for figure in [force(), orders(), crowded()] {
            let plot = Plot::new(&figure);
            let Area { left, right, top, bottom } = plot.frame;
            assert!(left > 0.0 && right < 640.0 && top > 0.0 && bottom < 480.0);
            for (x, y) in plot.drawn() {
                assert!(
                    (left - 1e-9..=right + 1e-9).contains(&x) && (top - 1e-9..=bottom + 1e-9).contains(&y)
                );
            }
        }
    }

    #[test]
    fn the_legend_leaves_the_axes_where_every_corner_is_taken() {
        assert!(Plot::new(&force()).corner.is_some());
        assert!(Plot::new(&crowded()).corner.is_none());
    }
}
