//! Expression to program to derivatives to stress, tangent and wave speed.
//!
//! Owns constitutive laws: a tape over invariants is traced once, differentiated by num-dual and
//! run over blocks of particles. Knows neither particles nor time nor text.

mod invariant;

pub use invariant::{Invariant, Leaf};
