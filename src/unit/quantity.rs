//! A number with a dimension.

use super::dimension::Dimension;
use std::fmt;

/// An SI value and its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// The value in SI units.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

impl Quantity {
    /// A quantity of an SI value.
    pub const fn new(value: f64, dimension: Dimension) -> Self {
        Self { value, dimension }
    }

    /// A pure number.
    pub const fn number(value: f64) -> Self {
        Self::new(value, Dimension::NUMBER)
    }
}

impl fmt::Display for Quantity {
    /// The SI value with its symbol: `7640 Pa`; a bare number for a number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbol = self.dimension.si_symbol();
        // Very large and very small values read better with an exponent.
        let size = self.value.abs();
        if size != 0.0 && size.is_finite() && !(1e-3..1e7).contains(&size) {
            write!(f, "{:e}", self.value)?;
        } else {
            write!(f, "{}", self.value)?;
        }
        if symbol.is_empty() { Ok(()) } else { write!(f, " {symbol}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_is_written_with_its_unit() {
        assert_eq!(Quantity::new(7640.0, Dimension::PRESSURE).to_string(), "7640 Pa");
        assert_eq!(Quantity::new(1e-7, Dimension::PRESSURE.recip()).to_string(), "1e-7 Pa^-1");
        assert_eq!(Quantity::number(0.0).to_string(), "0");
    }
}
