//! Expression to program to derivatives to stress, tangent and wave speed.
//!
//! Owns constitutive laws: a tape over invariants is traced once, differentiated by num-dual and
//! run over blocks of particles. Knows neither particles nor time nor text.

pub mod audit;
mod differentiate;
mod error;
mod graph;
mod handle;
mod invariant;
mod kinematics;
mod lanes;
mod law;
mod mixture;
mod motion;
mod parameter_slopes;
mod parity;
mod program;
mod raw;
mod schedule;
mod sphere;
mod stretch;
mod tangent;
mod tangent_block;
mod trace;
mod wave;
mod wave_block;
mod wide;

#[cfg(test)]
mod tests;

pub use error::EnergyError;
pub use invariant::{Invariant, Leaf};
pub use law::{ConjugateStresses, Directions, Law, Maps, Scratch};
pub use motion::{ExactMotion, MotionSource, MotionState};
pub use parameter_slopes::{ParameterSlope, ParameterSlopes};
pub use sphere::LARGEST_ORDER;
pub use stretch::{principal, symmetric_eigen};
pub use tangent::{Kink, Tangent};
pub use wave::WaveSpeeds;
