//! One material point, driven through deformations and stresses.
//!
//! Owns control, equilibrium and step length of a homogeneous state. Knows neither particles nor text.

mod control;
mod error;
mod follow;
mod response;
mod solution;
mod state;
mod system;

#[cfg(test)]
mod tests;

pub use control::{Control, Target, frame};
pub use error::DriveError;
pub use follow::{Drive, Volume};
pub use response::PointSlope;
pub use state::Point;
