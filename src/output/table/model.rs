//! What a table is, and how one fails to be written or read.
//!
//! Owns the data; the text form is in the neighbouring files.

use std::fmt;
use std::io;

/// Columns of numbers over common rows, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// Its name, also of the file: `pull` is written to `pull.csv`.
    pub name: String,
    /// What each column holds; the first is the one rows are ordered by.
    pub columns: Vec<TableColumn>,
    /// One value a column each.
    pub rows: Vec<Vec<f64>>,
    /// Lines at the head of the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

/// One column of a [`Table`].
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TableColumn {
    /// Its name.
    pub name: String,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// What it is, for example the expression as written.
    pub text: String,
}

impl TableColumn {
    /// A column named `name` in `unit`, described by `text`.
    pub fn new(name: &str, unit: &str, text: &str) -> Self {
        Self { name: name.into(), unit: unit.into(), text: text.into() }
    }
}

impl Table {
    /// Position of the column named `name`.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// The values of the column named `name`, from the first row to the last.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let at = self.position(name)?;
        Some(self.rows.iter().map(|row| row[at]).collect())
    }
}

/// Why a table was not written or read.
#[derive(Debug)]
#[non_exhaustive]
pub enum TableError {
    /// The file system refused.
    Io {
        /// The table.
        table: String,
        /// What it reported.
        cause: io::Error,
    },
    /// A row has another number of values than there are columns.
    Ragged {
        /// The table.
        table: String,
        /// Line of the file or number of the row, from 1.
        line: u64,
        /// Values found.
        found: usize,
        /// Columns required.
        required: usize,
    },
    /// A value to be written is infinite or not a number.
    NotFinite {
        /// The table.
        table: String,
        /// The column.
        column: String,
        /// Value of the first column in that row.
        at: f64,
        /// The value.
        value: f64,
    },
    /// A field is not a number.
    NotANumber {
        /// The table.
        table: String,
        /// The column.
        column: String,
        /// Line of the file, from 1.
        line: u64,
        /// The text found.
        found: String,
    },
    /// Two columns have one name.
    DuplicateColumn {
        /// The table.
        table: String,
        /// The name.
        column: String,
    },
    /// There is no line with the names of the columns.
    NoHeader {
        /// The table.
        table: String,
    },
    /// The text is not CSV, or not UTF-8.
    Malformed {
        /// The table.
        table: String,
        /// What the reader reported.
        cause: csv::Error,
    },
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io { table, cause } => write!(f, "table `{table}`: {cause}"),
            Self::Ragged { table, line, found, required } => {
                write!(f, "table `{table}`, line {line}: {found} values for {required} columns")
            }
            Self::NotFinite { table, column, at, value } => {
                write!(f, "table `{table}`: column `{column}` is {value} in the row that starts with {at:e}")
            }
            Self::NotANumber { table, column, line, found } => {
                write!(f, "table `{table}`, line {line}: `{found}` in column `{column}` is not a number")
            }
            Self::DuplicateColumn { table, column } => {
                write!(f, "table `{table}`: two columns are named `{column}`")
            }
            Self::NoHeader { table } => write!(f, "table `{table}` has no line that names its columns"),
            Self::Malformed { table, cause } => write!(f, "table `{table}`: {cause}"),
        }
    }
}

impl std::error::Error for TableError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io { cause, .. } => Some(cause),
            Self::Malformed { cause, .. } => Some(cause),
            _ => None,
        }
    }
}
