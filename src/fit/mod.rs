//! Least squares within bounds, and what the data say of the parameters.
//!
//! Owns the minimisation of a sum of squares, standard errors, correlations and the signs that data do
//! not determine a parameter. Knows neither laws nor points nor text.

mod decomposition;
mod minimise;
mod range;
mod statistics;

#[cfg(test)]
mod tests;

pub use minimise::{Ending, Linear, Minimum, minimise};
pub use range::{Bound, Range};
pub use statistics::{Finding, Statistics};
