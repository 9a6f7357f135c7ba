//! Dimensions and unit symbols.
