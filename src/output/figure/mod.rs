//! Figures as SVG, drawn from tables and frames only.

mod axis;
mod canvas;
mod clip;
mod colour_bar;
mod colour_map;
mod curves;
mod field;
mod field_page;
mod legend;
mod map;
mod mark;
mod model;
mod palette;
mod sheet;
mod sketch;
mod surface;
mod symbol;

pub use field::{FieldFigure, Panel, View};
pub use map::{Cell, MapFigure};
pub use model::{Axis, Band, Figure, FigureError, Mark, Scale, Series, Slope};
pub use sheet::sheet;
pub use sketch::{Dimension, Note, Patch, Sketch};
pub(crate) use surface::outer_faces;
