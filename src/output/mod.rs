//! Tables, frames, figures and reports: from data to bytes, and bytes to files.
//!
//! Owns the formats of everything written. Nothing here knows the solver or how a number was
//! computed; figures are drawn from tables and frames only.

pub mod drive_report;
pub mod figure;
pub mod file;
pub mod fit_report;
pub mod frame;

pub mod provenance;
pub mod report;
pub mod sweep_report;
pub mod table;

pub use drive_report::DriveReport;
pub use figure::{
    Axis, Band, Cell, Dimension, FieldFigure, Figure, FigureError, MapFigure, Mark, Note, Panel, Patch,
    Scale, Series, Sketch, Slope, View, sheet,
};
pub use fit_report::FitReport;
pub use frame::{Collection, Frame, FrameError, FrameField};
pub use provenance::Provenance;
pub use report::RunReport;
pub use sweep_report::{PointReport, SweepReport};
pub use table::{Table, TableColumn, TableError, TableWriter};
