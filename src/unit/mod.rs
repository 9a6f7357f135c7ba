//! Dimensions and unit symbols.
//!
//! Owns what a dimension is, what it is called and which unit symbols there are. Knows no text of a
//! file, no place in it and no tensor.

mod dimension;
mod known;
mod quantity;
mod symbol;

pub use dimension::{Dimension, Exponent};
pub use known::{Known, known_dimensions};
pub use quantity::Quantity;
pub use symbol::{Unit, UnitError, parse_unit, unit_symbols};
