//! Pictures from results: first the numbers a picture shows as tables, then the picture from those
//! tables alone.
//!
//! Owns the choice of what goes into a picture; drawing is the output layer's. What is drawn can always
//! be drawn again from the tables beside it.

mod draw;
mod extract;
mod point;
mod results;

pub use draw::{draw, draw_figure};
pub use extract::{extract, extract_figure, table_names};
pub use results::{Results, RunResults};

use crate::output::{Provenance, Table};
use crate::scene::Plot;
use std::path::Path;

/// Name and SVG text, or what was in the way, of every plot; `title` is the scene's or the drive's name,
/// `folder` where its frames are.
pub fn figures(
    title: &str,
    plots: &[Plot],
    tables: &[Table],
    provenance: &Provenance,
    folder: Option<&Path>,
) -> Vec<(String, Result<String, String>)> {
    let results = Results {
        runs: vec![RunResults {
            name: String::new(),
            tables: tables.to_vec(),
            spacings: Vec::new(),
            folder: folder.map(Path::to_path_buf),
            provenance: provenance.lines(),
        }],
        short: false,
    };
    let one = |plot: &Plot| {
        let data = extract(plot, &results)?;
        draw(plot, &format!("{title}: {}", plot.name), &data)
    };
    plots.iter().map(|plot| (plot.name.clone(), one(plot))).collect()
}
