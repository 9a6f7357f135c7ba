//! Figures as SVG, drawn from tables and frames only.

mod axis;
mod canvas;
mod colour_map;
mod curves;
mod field;
mod field_page;
mod legend;
mod mark;
mod model;
mod palette;
mod surface;
mod symbol;

pub use field::{FieldFigure, Panel, View};
pub use model::{Axis, Figure, FigureError, Mark, Scale, Series, Slope};
