//! Tree and vocabulary to a checked description.
//!
//! Owns meaning: SI numbers, proved dimensions, every name resolved, all mistakes collected. Knows
//! neither the solver nor files written.

mod model;

pub use model::*;
