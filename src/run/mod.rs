//! A planned scene from its first step to files and verdicts.
//!
//! Owns the order of a run: step, sample, write, judge. Knows neither the terminal nor text.

mod cost;
mod drive;
mod error;
mod execute;
mod expect;
mod figure;
mod fit;
mod interpolate;
mod order;
mod sampling;
mod schedule;
mod snapshot;
mod sweep;
mod sweep_figure;
mod trade;

pub use cost::Cost;
pub use drive::{DriveJob, DriveOutcome, drive};
pub use error::{ColumnFault, RunError};
pub use execute::{Job, Outcome, Progress, execute};
pub use expect::{control, judge, judge_all};
pub use figure::{Results, RunResults, draw_figure, extract_figure, figures, table_names};
pub use fit::{FitJob, FitOutcome, fit};
pub use interpolate::{crossing, reference_value};
pub use order::order;
pub use sweep::{SweepJob, SweepOutcome, side_by_side, sweep};
pub use sweep_figure::sweep_figures;
pub use trade::{Setting, front, settings};
