//! A planned scene from its first step to files and verdicts.
//!
//! Owns the order of a run: step, sample, write, judge. Knows neither the terminal nor text.

mod cost;
mod drive;
mod error;
mod execute;
mod expect;
mod figure;
mod interpolate;
mod schedule;
mod snapshot;

pub use cost::Cost;
pub use drive::{DriveJob, DriveOutcome, drive};
pub use error::RunError;
pub use execute::{Job, Outcome, Progress, execute};
pub use expect::{control, judge, judge_all};
pub use figure::figures;
pub use interpolate::{crossing, reference_value};
