//! The description of a sweep: the same scene or drive over several values.

use super::{Column, Drive, Expectation, Place, Reduction, Scene};

/// The same scene or drive over several values.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Its name, also of its folder.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// The scene or drive.
    pub of: String,
    /// What varies, the first slowest.
    pub varied: Vec<Varied>,
    /// Every combination of values, described anew.
    pub points: Vec<SweepPoint>,
    /// Tables to write.
    pub records: Vec<SweepRecord>,
    /// Figures to draw.
    pub plots: Vec<SweepPlot>,
    /// What must hold of the tables.
    pub expectations: Vec<Expectation>,
    /// What is weighed against what, of a `trade`.
    pub trade: Option<Trade>,
}

/// One path and its values.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// The path as written: `strip.spacing`.
    pub path: String,
    /// Name of its column: `spacing`.
    pub column: String,
    /// SI unit symbol, empty for a number and for words.
    pub unit: String,
    /// The values in order.
    pub values: Vec<VariedValue>,
    /// Whether the values are quantities; if not, the column numbers them from 1.
    pub is_quantity: bool,
}

/// One value of a path.
#[derive(Debug, Clone, PartialEq)]
pub struct VariedValue {
    /// SI value, or its number from 1 where it is a word.
    pub value: f64,
    /// As written.
    pub text: String,
}

/// One combination of values.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepPoint {
    /// Index of the value of each varied path.
    pub at: Vec<usize>,
    /// What is computed there.
    pub swept: Swept,
}

/// What a sweep computes.
#[derive(Debug, Clone, PartialEq)]
pub enum Swept {
    /// A scene of particles.
    Scene(Box<Scene>),
    /// A drive of a material point.
    Drive(Box<Drive>),
}

/// A table with one row a point.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRecord {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Columns after the varied values.
    pub columns: Vec<Column<Reduced>>,
}

/// A number read from one point of a sweep.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Reduced {
    /// One number of a column.
    Column {
        /// Which.
        by: Reduction,
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Value of a column where another of the same record first takes a value.
    Where {
        /// The record.
        record: String,
        /// The column.
        column: String,
        /// The column that takes the value.
        abscissa: String,
        /// The value, SI.
        value: f64,
    },
    /// The value of a varied path, by index.
    Varied(usize),
    /// Particles of the modelled part.
    Particles,
    /// Time steps.
    Steps,
    /// Particles times evaluations of the right-hand side.
    ParticleUpdates,
}

/// A figure of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepPlot {
    /// Its name, also of the file.
    pub name: String,
    /// Curves.
    pub curves: Vec<SweepCurve>,
    /// Whether the abscissa and the ordinate are logarithmic.
    pub logarithmic: (bool, bool),
    /// Order of the triangle under the first curve.
    pub slope: Option<f64>,
}

/// One column over another.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepCurve {
    /// A record of the sweep, or of the scene or drive at every point.
    pub record: String,
    /// Column of the ordinate.
    pub y: String,
    /// Column of the abscissa.
    pub x: String,
    /// Whether the record is one of the scene or drive: one curve a point.
    pub of_points: bool,
}

/// Error against cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Trade {
    /// The error that is allowed, SI.
    pub tolerance: Option<f64>,
    /// Unit of error and tolerance.
    pub unit: String,
    /// What the cost is: `particle_updates`.
    pub cost: String,
}
