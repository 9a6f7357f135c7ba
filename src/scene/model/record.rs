//! The description of what a run writes and draws: tables, frames, curves.

use super::{Picture, Place, Probe};
use crate::expression::Tape;

/// A table sampled in time.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Columns after `t`.
    pub columns: Vec<Column<Probe>>,
    /// Sampling interval, s.
    pub every: f64,
}

/// A column of a table: a number read from what `L` names.
#[derive(Debug, Clone, PartialEq)]
pub struct Column<L> {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its value.
    pub value: Tape<L>,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// The expression as written.
    pub text: String,
}

/// Frames written for a viewer.
#[derive(Debug, Clone, PartialEq)]
pub struct Frames {
    /// Its name, also of the files.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Names of the fields asked for: `displacement`, `velocity`, `sigma`, `von_mises`, `pressure`, `J`, `F`, `P`.
    pub values: Vec<String>,
    /// Interval, s.
    pub every: f64,
}

/// A table from a file, its columns renamed.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Where it is named.
    pub place: Place,
    /// Path as written, relative to the file that names it.
    pub path: String,
    /// Columns in SI, by the name given in the scene.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Curves.
    pub curves: Vec<Curve>,
    /// Reference points.
    pub points: Vec<ReferenceCurve>,
    /// Everything else.
    pub picture: Picture,
}

/// One record column over another.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The record.
    pub record: String,
    /// Column of the ordinate.
    pub y: String,
    /// Column of the abscissa.
    pub x: String,
}

/// Reference points of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceCurve {
    /// The table.
    pub reference: Reference,
    /// Column of the ordinate.
    pub y: String,
    /// Column of the abscissa.
    pub x: String,
}
