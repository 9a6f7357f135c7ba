//! Arithmetic over named leaves, as a flat tape.
//!
//! Owns the one form every formula of a `.tissue` file takes once its names are resolved and its
//! units are gone: energies over invariants, directions and initial fields over coordinates,
//! records over probes; and how a tape is evaluated in numbers, duals and traced handles. Knows
//! neither text nor what a leaf means.

pub(crate) mod dual_parts;
pub mod elementary;
mod evaluate;
mod gauss;
mod number;
mod scalar;
mod tape;

pub use gauss::gauss_legendre;
pub use number::Number;
pub use scalar::{Part, Scalar};
pub use tape::{Comparison, Cone, Function, Node, NodeId, Sphere, Tape};
