//! What a figure of curves shows, and why one cannot be drawn.
//!
//! Owns the data; drawing is in the neighbouring files.

use std::fmt;

/// Curves and points over common axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// Line above the axes; may be empty.
    pub title: String,
    /// The abscissa.
    pub x: Axis,
    /// The ordinate.
    pub y: Axis,
    /// Regions drawn below the curves.
    pub bands: Vec<Band>,
    /// What is drawn, the first below the others.
    pub series: Vec<Series>,
    /// Triangles that show an order of convergence; for two logarithmic axes.
    pub slopes: Vec<Slope>,
    /// Lines kept in the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

/// One axis of a [`Figure`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Axis {
    /// What is measured along it.
    pub label: String,
    /// SI unit of the values; drawn with a prefix where it takes one.
    pub unit: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Values between which something is drawn; what lies beyond is cut off. All values where absent.
    pub range: Option<(f64, f64)>,
}

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// In proportion.
    #[default]
    Linear,
    /// In proportion to the logarithm; all values must be positive.
    Logarithmic,
}

/// One curve, or one set of points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Its line in the legend; an empty one has none.
    pub label: String,
    /// Abscissa and ordinate in SI units.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub mark: Mark,
    /// Number of its colour, so that a curve and its reference points can share one; the position in
    /// the figure where absent.
    pub colour: Option<usize>,
}

/// A filled region, as for what was measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Band {
    /// Its line in the legend; an empty one has none.
    pub label: String,
    /// Corners in order, SI.
    pub corners: Vec<(f64, f64)>,
    /// Number of its colour, of which a tint is drawn.
    pub colour: usize,
}

/// How a [`Series`] is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mark {
    /// A line through the points.
    #[default]
    Line,
    /// A dashed line through the points.
    Dashed,
    /// A hollow marker at each point, as for references.
    Markers,
    /// A line with a full marker at each point, as for errors over spacing.
    LineMarkers,
}

/// A triangle that shows the slope of an order of convergence under a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope {
    /// Index of the series it stands under.
    pub series: usize,
    /// The slope, in decades of the ordinate per decade of the abscissa.
    pub order: f64,
}

/// Why a figure was not drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FigureError {
    /// There is no point in any series.
    Empty,
    /// A coordinate is infinite or not a number.
    NotFinite {
        /// Legend of the series.
        series: String,
        /// Index of the point.
        point: usize,
    },
    /// A coordinate on a logarithmic axis is zero or negative.
    NotPositive {
        /// Legend of the series.
        series: String,
        /// Index of the point.
        point: usize,
        /// The value.
        value: f64,
    },
    /// A slope is asked for where it means nothing: an axis is linear, the series does not exist, or
    /// the order is zero or no number.
    Slope {
        /// The series named.
        series: usize,
    },
    /// An axis is asked to reach over a range that is none.
    Range {
        /// Label of the axis.
        axis: String,
        /// Its start.
        low: f64,
        /// Its end.
        high: f64,
    },
    /// A frame has no such field or component.
    NoField {
        /// Name of the field.
        field: String,
        /// Component asked for.
        component: usize,
    },
    /// A panel lacks values, names corners that do not exist, or has no size of its discs; or the range
    /// of the colours is none.
    Panel {
        /// Its caption.
        caption: String,
    },
    /// The drawing library failed.
    Drawing {
        /// What it reported.
        cause: String,
    },
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "a figure without points cannot be drawn"),
            Self::NotFinite { series, point } => {
                write!(f, "point {point} of `{series}` is not finite")
            }
            Self::NotPositive { series, point, value } => {
                write!(f, "point {point} of `{series}` is {value:e}, but a logarithmic axis requires > 0")
            }
            Self::Slope { series } => write!(
                f,
                "a slope under series {series} requires two logarithmic axes, two points and an order"
            ),
            Self::Range { axis, low, high } => {
                write!(f, "the axis `{axis}` cannot reach from {low:e} to {high:e}")
            }
            Self::NoField { field, component } => {
                write!(f, "the frame has no component {component} of a field `{field}`")
            }
            Self::Panel { caption } => write!(f, "panel `{caption}` is not complete"),
            Self::Drawing { cause } => write!(f, "drawing failed: {cause}"),
        }
    }
}

impl std::error::Error for FigureError {}

impl Figure {
    /// Whether every number can be drawn on its axis.
    ///
    /// # Errors
    /// The first fault, series by series.
    pub fn check(&self) -> Result<(), FigureError> {
        if self.series.iter().all(|series| series.points.is_empty()) {
            return Err(FigureError::Empty);
        }
        let curves = self.series.iter().map(|series| (&series.label, &series.points));
        let bands = self.bands.iter().map(|band| (&band.label, &band.corners));
        for (label, points) in curves.chain(bands) {
            for (point, &(x, y)) in points.iter().enumerate() {
                for (value, axis) in [(x, &self.x), (y, &self.y)] {
                    let name = || label.clone();
                    if !value.is_finite() {
                        return Err(FigureError::NotFinite { series: name(), point });
                    }
                    if axis.scale == Scale::Logarithmic && value <= 0.0 {
                        return Err(FigureError::NotPositive { series: name(), point, value });
                    }
                }
            }
        }
        for axis in [&self.x, &self.y] {
            if let Some((low, high)) = axis.range {
                let is_range = low < high && high.is_finite() && low.is_finite();
                if !is_range || (axis.scale == Scale::Logarithmic && low <= 0.0) {
                    return Err(FigureError::Range { axis: axis.label.clone(), low, high });
                }
            }
        }
        for &Slope { series, order } in &self.slopes {
            let logarithmic = [self.x.scale, self.y.scale] == [Scale::Logarithmic; 2];
            let long_enough = self.series.get(series).is_some_and(|series| series.points.len() >= 2);
            if !(logarithmic && long_enough && order.is_finite() && order != 0.0) {
                return Err(FigureError::Slope { series });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(points: Vec<(f64, f64)>, scale: Scale) -> Figure {
        let axis = Axis { label: "h".into(), unit: "m".into(), scale, range: None };
        let series = vec![Series { label: "u".into(), points, ..Series::default() }];
        Figure { x: axis.clone(), y: axis, series, ..Figure::default() }
    }

    #[test]
    fn what_cannot_be_drawn_is_refused_with_its_series_and_point() {
        let fault = |figure: Figure| figure.check().expect_err("unfit").to_string();
        assert_eq!(fault(Figure::default()), "a figure without points cannot be drawn");
        assert_eq!(
            fault(figure(vec![(0.0, 0.0), (1.0, f64::NAN)], Scale::Linear)),
            "point 1 of `u` is not finite"
        );
        assert_eq!(
            fault(figure(vec![(1.0, 1.0), (2.0, 0.0)], Scale::Logarithmic)),
            "point 1 of `u` is 0e0, but a logarithmic axis requires > 0"
        );
        let mut sloped = figure(vec![(1.0, 1.0), (2.0, 1.0)], Scale::Linear);
        assert_eq!(sloped.check(), Ok(()));
        sloped.slopes.push(Slope { series: 0, order: 2.0 });
        assert_eq!(sloped.check(), Err(FigureError::Slope { series: 0 }));
    }
}
