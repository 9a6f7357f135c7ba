//! The description of points made of single numbers.

use super::{Reduction, Reference};
use crate::expression::Tape;

/// A point of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownPoint {
    /// Abscissa.
    pub x: Tape<Shown>,
    /// Ordinate.
    pub y: Tape<Shown>,
}

/// A number a point is made of.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Shown {
    /// One number of a recorded column.
    Reduced {
        /// Which.
        by: Reduction,
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Value of a recorded column where another of the same record first takes a value.
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
    /// Value of a column of a table from a file where another takes a value.
    Reference {
        /// The table.
        reference: Reference,
        /// The column.
        column: String,
        /// The column that takes the value.
        abscissa: String,
        /// The value, SI.
        value: f64,
    },
    /// Distance of neighbouring particles of a body.
    Spacing {
        /// The source.
        source: String,
        /// The body.
        body: String,
    },
}
