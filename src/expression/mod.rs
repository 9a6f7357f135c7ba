//! Arithmetic over named leaves, as a flat tape.
//!
//! Owns the one form every formula of a `.tissue` file takes once its names are resolved and its
//! units are gone: energies over invariants, directions and initial fields over coordinates,
//! records over probes. Knows neither text nor what a leaf means.

mod tape;

pub use tape::{Comparison, Function, Node, NodeId, Tape};
