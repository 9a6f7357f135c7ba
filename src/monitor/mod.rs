//! Pure functions from a state to numbers.
//!
//! Owns totals, involutions and probes, always of the whole body where planes of symmetry model a
//! part. Does not know how the state was computed.

mod field;
mod involution;
mod mean;
mod motion;
mod point;
mod probe;
mod residual;
mod roughness;
mod totals;
mod twist;

pub use field::{cauchy_stress, field_value, von_mises};
pub use involution::{Involutions, curl_and_divergence, involutions};
pub use motion::{FieldErrors, MotionErrors, motion_errors};
pub use point::Interpolation;
pub use probe::{Observer, ProbeError};
pub use residual::{RESIDUAL_MOMENT, largest_residual, residual};
pub use roughness::roughness;
pub use totals::{Totals, totals};
