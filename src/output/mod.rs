//! Tables, frames and figures.
