//! Tables of numbers with named, dimensioned columns, as CSV.

mod model;
mod read;
mod write;

pub use model::{Table, TableColumn, TableError};
pub use write::{TableWriter, number};
