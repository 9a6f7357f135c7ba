//! Fields over points at one time, as VTK files.

mod collection;
mod model;
mod read;
mod vtu;

pub use collection::Collection;
pub use model::{Frame, FrameError, FrameField};
