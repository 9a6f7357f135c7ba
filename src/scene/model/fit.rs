//! The description of a fit: drives, data, the parameters sought.

use super::{Drive, Expectation, Place, PointProbe};
use crate::expression::Tape;
use crate::fit::Range;

/// Parameters to be found from data.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Its name, also of its folder.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Drives with their data.
    pub sets: Vec<FitSet>,
    /// The parameters sought.
    pub vary: Vec<Sought>,
    /// How data count against each other.
    pub weighing: Weighing,
    /// What must hold of the result.
    pub expectations: Vec<Expectation>,
}

/// A drive and the data measured on it.
#[derive(Debug, Clone, PartialEq)]
pub struct FitSet {
    /// The drive.
    pub drive: Drive,
    /// Path of the table as written.
    pub source: String,
    /// Values of the drive's parameter, a row each, in the table's order; SI.
    pub abscissae: Vec<f64>,
    /// Weight of each row, 1 where the table has none.
    pub row_weights: Vec<f64>,
    /// What was measured.
    pub columns: Vec<FitColumn>,
}

/// One measured quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct FitColumn {
    /// What it is, as written: `P.xx`.
    pub name: String,
    /// The same of a material point.
    pub value: Tape<PointProbe>,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// The data, a row each; SI.
    pub measured: Vec<f64>,
}

/// A parameter to be found.
#[derive(Debug, Clone, PartialEq)]
pub struct Sought {
    /// Its name as written: `gel.mu`.
    pub name: String,
    /// The material.
    pub material: String,
    /// Index among the material's parameters.
    pub index: usize,
    /// Value to start from, SI.
    pub start: f64,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// Where it may lie; SI.
    pub range: Range,
}

/// How data count against each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Weighing {
    /// Differences over the root mean square of their column.
    Column,
    /// Differences as they are.
    Uniform,
    /// Differences over their datum.
    Relative,
}

impl Weighing {
    /// The word of the language.
    pub fn word(self) -> &'static str {
        match self {
            Self::Column => "column",
            Self::Uniform => "uniform",
            Self::Relative => "relative",
        }
    }
}
