//! The description of what must hold of the tables.

use super::{Place, Reference};
use crate::expression::Tape;

/// Something that must hold of the tables a run writes.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// Where it is written.
    pub place: Place,
    /// The line as written.
    pub text: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// Form of an expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum Judgement {
    /// `left <relation> right within tolerance at abscissa = values`.
    Compare {
        /// Left side.
        left: Tape<Sample>,
        /// Relation.
        relation: Relation,
        /// Right side.
        right: Tape<Sample>,
        /// Tolerance, of an equality.
        tolerance: Option<Tolerance>,
        /// Where: record, column, values. Without it both sides hold no bare column.
        at: Option<(String, String, Vec<f64>)>,
        /// SI unit symbol of both sides.
        unit: String,
    },
    /// The column never exceeds its running minimum by more than round-off.
    NeverGrows {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
}

/// Relation of two sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `==`, with a tolerance.
    Equal,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// How far two sides may lie apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Of the right side's magnitude: `0.5 %`.
    Relative(f64),
    /// In the unit of the sides.
    Absolute(f64),
}

/// A leaf of an expectation: a number read from a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Sample {
    /// A record's column, interpolated where the abscissa takes the value asked for.
    Column {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// A reference's column, interpolated in the reference's column of the abscissa's name.
    Reference {
        /// The table.
        reference: Reference,
        /// The column.
        column: String,
    },
    /// One number of a column.
    Reduced {
        /// Which.
        by: Reduction,
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Exponent of a column's magnitude in the first varied value of a sweep.
    Order {
        /// The record.
        record: String,
        /// The column.
        column: String,
        /// Columns of the varied values, the one the order runs over first.
        varied: Vec<String>,
        /// Whether it is the smallest between neighbours instead of the least-squares one over all.
        between_neighbours: bool,
    },
    /// Integral of a column over time, by the trapezoidal rule.
    Integral {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
}

/// Which one number stands for a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// Its largest value.
    Max,
    /// Its smallest value.
    Min,
    /// Its first value.
    Initial,
    /// Its last value.
    Final,
}

impl Reduction {
    /// The reduction a word of the language names.
    pub fn named(word: &str) -> Option<Self> {
        Some(match word {
            "max" => Self::Max,
            "min" => Self::Min,
            "initial" => Self::Initial,
            "final" => Self::Final,
            _ => return None,
        })
    }

    /// The number of a column's values; not a number where one of those compared is none, nothing without values.
    pub fn of(self, values: impl IntoIterator<Item = f64>) -> Option<f64> {
        values.into_iter().reduce(|old, new| {
            let better = match self {
                Self::Max => new > old || new.is_nan(),
                Self::Min => new < old || new.is_nan(),
                Self::Initial => false,
                Self::Final => true,
            };
            if better { new } else { old }
        })
    }
}
