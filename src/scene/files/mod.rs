//! Shapes in files of other programs: bytes to triangles, points and cells.
//!
//! Owns the formats. Knows neither units nor what becomes of the numbers.

mod stl;
mod vtu;

pub(super) use stl::triangles;
pub(super) use vtu::points;

use std::fmt;

/// Why a file of a shape could not be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum FileError {
    /// The file ends before it has what it announces.
    Short {
        /// What is missing.
        what: &'static str,
    },
    /// Something that is no number stands where one must.
    NotANumber {
        /// What stands there.
        found: String,
        /// Its line, from 1.
        line: usize,
    },
    /// A word is missing.
    Missing {
        /// The word: `vertex`, `<Points>`.
        word: String,
    },
    /// A variant of the format that is not read.
    Unsupported {
        /// What it is.
        what: String,
    },
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Short { what } => write!(f, "it ends before its {what}"),
            Self::NotANumber { found, line } => write!(f, "`{found}` on line {line} is no number"),
            Self::Missing { word } => write!(f, "it has no `{word}`"),
            Self::Unsupported { what } => write!(f, "{what} is not read"),
        }
    }
}
