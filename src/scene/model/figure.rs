//! The description of pictures and figures.

use super::{Field, Place, Reference, ShownPoint};

/// What a plot shows beyond its curves of columns.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// Line above it; the scene's and the plot's names where absent.
    pub title: Option<String>,
    /// Label of the abscissa; the column's name where absent.
    pub x_label: Option<String>,
    /// Label of the ordinate; the column's name where absent.
    pub y_label: Option<String>,
    /// Ends of the abscissa, SI.
    pub x_range: Option<(f64, f64)>,
    /// Ends of the ordinate, SI.
    pub y_range: Option<(f64, f64)>,
    /// Whether the abscissa and the ordinate are logarithmic.
    pub logarithmic: (bool, bool),
    /// Curves and points with a look of their own.
    pub series: Vec<DrawnSeries>,
    /// Regions behind the curves.
    pub bands: Vec<DrawnBand>,
    /// Fields on deformed bodies.
    pub fields: Option<FieldPicture>,
    /// A drawing with dimensions.
    pub drawing: Option<Drawing>,
}

/// A curve or points.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnSeries {
    /// Where its numbers are from.
    pub data: SeriesData,
    /// Its line in the legend, empty for none.
    pub label: String,
    /// How it is drawn.
    pub look: Look,
    /// Number of its colour.
    pub colour: Option<usize>,
}

/// Where the numbers of a series are from.
#[derive(Debug, Clone, PartialEq)]
pub enum SeriesData {
    /// Columns of a record: `record`, or `source.record` in a figure.
    Record {
        /// The record.
        record: String,
        /// Column of the ordinate.
        y: String,
        /// Column of the abscissa.
        x: String,
    },
    /// Columns of a table from a file.
    Reference {
        /// The table.
        reference: Reference,
        /// Column of the ordinate.
        y: String,
        /// Column of the abscissa.
        x: String,
    },
    /// Points of one number each way.
    Points {
        /// The points in order.
        points: Vec<ShownPoint>,
        /// SI units of abscissa and ordinate.
        units: [String; 2],
    },
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Look {
    /// A line.
    Line,
    /// A dashed line.
    Dashed,
    /// Hollow markers.
    Markers,
    /// A line with full markers.
    LineMarkers,
}

/// A region behind curves.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnBand {
    /// Its line in the legend, empty for none.
    pub label: String,
    /// Corners in order, SI.
    pub corners: Vec<(f64, f64)>,
    /// Number of its colour.
    pub colour: usize,
}

/// Deformed bodies side by side, coloured by one field.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldPicture {
    /// The field.
    pub field: Field,
    /// What the colours mean.
    pub label: String,
    /// SI unit of the field.
    pub unit: String,
    /// Values at the ends of the colour bar, SI.
    pub range: Option<(f64, f64)>,
    /// From where.
    pub view: Viewpoint,
    /// Panels in a row.
    pub columns: usize,
    /// The panels.
    pub panels: Vec<FieldPanel>,
}

/// From where bodies are seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Viewpoint {
    /// Along an axis: the axes to the right and upwards.
    Plane(u8, u8),
    /// From above one side.
    Oblique,
    /// From the origin of a quarter model.
    Corner,
}

/// Bodies at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldPanel {
    /// The frames: `frames`, or `source.frames` in a figure.
    pub frames: String,
    /// Which of them.
    pub moment: Moment,
    /// Line below.
    pub caption: String,
    /// Planes at which the image is added: axis and coordinate, m.
    pub mirrors: Vec<(u8, f64)>,
}

/// Which frame of a series.
#[derive(Debug, Clone, PartialEq)]
pub enum Moment {
    /// The last one.
    Last,
    /// The one nearest to a time, s.
    Time(f64),
    /// The one nearest to the time at which a column first has a value.
    When {
        /// The record, whose first column is the time.
        record: String,
        /// The column.
        column: String,
        /// The value, SI.
        value: f64,
    },
}

/// A drawing with dimensions, coordinates on the plane of the page in m.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// Closed outlines.
    pub outlines: Vec<Vec<[f64; 2]>>,
    /// Discs: centre, radius, number of the colour.
    pub discs: Vec<([f64; 2], f64, usize)>,
    /// Dimension lines: ends, offset, text.
    pub dimensions: Vec<([f64; 2], [f64; 2], f64, String)>,
    /// Texts.
    pub notes: Vec<DrawnNote>,
}

/// A text in a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnNote {
    /// Where it begins, m.
    pub at: [f64; 2],
    /// What it names, m.
    pub to: Option<[f64; 2]>,
    /// The text.
    pub text: String,
}

/// A figure of one or several runs.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureOf {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its number.
    pub number: u32,
    /// What it shows.
    pub title: String,
    /// Pictures in a row.
    pub columns: usize,
    /// The runs it needs.
    pub sources: Vec<Source>,
    /// Its pictures.
    pub plots: Vec<super::Plot>,
}

/// A run a figure needs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// What the figure calls it.
    pub name: String,
    /// Path of the file, relative to the working folder.
    pub file: String,
    /// The scene or drive.
    pub scene: String,
    /// Values in place of those written, by path.
    pub full: Vec<(String, String)>,
    /// Further values of the quick tier.
    pub quick: Vec<(String, String)>,
}

impl Source {
    /// The values to set.
    pub fn settings(&self, quick: bool) -> Vec<(String, String)> {
        if !quick {
            return self.full.clone();
        }
        let kept = self.full.iter().filter(|(path, _)| self.quick.iter().all(|(other, _)| other != path));
        kept.chain(&self.quick).cloned().collect()
    }
}

impl Field {
    /// The field of a frame that holds it, and its component there.
    pub fn stored(self) -> (&'static str, usize) {
        // as the frames order a symmetric tensor: xx, yy, zz, xy, yz, xz
        let six = |i: u8, j: u8| match (i.min(j), i.max(j)) {
            (i, j) if i == j => usize::from(i),
            (0, 1) => 3,
            (1, _) => 4,
            _ => 5,
        };
        match self {
            Self::Displacement(axis) => ("displacement", usize::from(axis)),
            Self::Velocity(axis) => ("velocity", usize::from(axis)),
            Self::Sigma(i, j) => ("sigma", six(i, j)),
            Self::P(i, j) => ("P", usize::from(3 * i + j)),
            Self::F(i, j) => ("F", usize::from(3 * i + j)),
            Self::VonMises => ("von_mises", 0),
            Self::Pressure => ("pressure", 0),
            Self::J => ("J", 0),
        }
    }

    /// Whether a mirror normal to an axis turns its sign.
    pub fn flips(self, axis: usize) -> bool {
        let is = |index: u8| usize::from(index) == axis;
        match self {
            Self::Displacement(i) | Self::Velocity(i) => is(i),
            Self::Sigma(i, j) | Self::P(i, j) | Self::F(i, j) => is(i) != is(j),
            Self::VonMises | Self::Pressure | Self::J => false,
        }
    }
}
