//! Right-hand side, loads, constraints, time stepping.
//!
//! Owns the state and its motion. Knows neither text, units nor files.

mod admissible;
pub mod affine;
mod assemble;
mod body;
mod bond;
mod constraint;
mod diagnosis;
pub mod dissipation;
mod error;
mod exact;
mod follower;
pub mod force;
pub mod hourglass;
pub mod impulse;
pub mod kinematics;
mod ledger;
mod links;
mod loads;
mod pace;
mod pass;
pub mod projection;
mod quad;
mod simulation;
mod spectrum;
mod strut;
pub mod tie;
mod time_step;
mod wide;

pub use assemble::{compile, discretise};
pub use body::{Block, BodyState, CHUNK, DirectionField};
pub use constraint::Support;
pub use error::{Cause, SolveError};
pub use ledger::{Energies, Ledger};
pub use links::{Links, Pair};
pub use quad::{Columns, Quad};
pub use simulation::Simulation;
pub use strut::{Strut, row_bounds, struts};
