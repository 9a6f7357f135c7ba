//! Figures as SVG, drawn from tables and frames only.

mod axis;
mod canvas;
mod curves;
mod legend;
mod mark;
mod model;
mod palette;
mod symbol;

pub use model::{Axis, Figure, FigureError, Mark, Scale, Series, Slope};
