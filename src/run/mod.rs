//! A planned scene from its first step to files and verdicts.
//!
//! Owns the order of a run: step, sample, write, judge. Knows neither the terminal nor text.

mod error;
mod execute;
mod expect;
mod interpolate;
mod schedule;
mod snapshot;

pub use error::RunError;
pub use execute::{Job, Outcome, Progress, execute};
pub use expect::{judge, judge_all};
pub use interpolate::{crossing, reference_value};
