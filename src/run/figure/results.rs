//! Tables and frames of the runs a picture shows.
//!
//! Owns names: `pull` of the only run, `axial.pull` of one of several.

use crate::output::{Collection, Frame, Table};
use std::fs;
use std::path::{Path, PathBuf};

/// What one run left behind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RunResults {
    /// What the figure calls it; empty for the run a plot itself belongs to.
    pub name: String,
    /// Its tables.
    pub tables: Vec<Table>,
    /// Where its frames are.
    pub folder: Option<PathBuf>,
    /// Lines that say what it was computed from.
    pub provenance: Vec<String>,
}

/// What the runs of a figure left behind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Results {
    /// Run by run.
    pub runs: Vec<RunResults>,
}

impl RunResults {
    /// Reads the tables of a run from its folder.
    ///
    /// # Errors
    /// Which file cannot be read, and why.
    pub fn read(
        name: &str,
        folder: &Path,
        records: &[String],
        provenance: Vec<String>,
    ) -> Result<Self, String> {
        let mut tables = Vec::new();
        for record in records {
            let path = folder.join(format!("{record}.csv"));
            let text = fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))?;
            tables.push(Table::parse(record, &text).map_err(|cause| format!("{}: {cause}", path.display()))?);
        }
        Ok(Self { name: name.into(), tables, folder: Some(folder.to_path_buf()), provenance })
    }
}

impl Results {
    /// The run a dotted name belongs to, and the name within it.
    fn run<'a>(&self, name: &'a str) -> Option<(&RunResults, &'a str)> {
        let (run, inner) = name.split_once('.').unwrap_or(("", name));
        self.runs.iter().find(|known| known.name == run).map(|found| (found, inner))
    }

    /// A table by name.
    pub(super) fn table(&self, name: &str) -> Option<&Table> {
        let (run, inner) = self.run(name)?;
        run.tables.iter().find(|table| table.name == inner)
    }

    /// The frame of a series nearest to a time, or the last one.
    pub(super) fn frame(&self, name: &str, time: Option<f64>) -> Result<Frame, String> {
        let (run, inner) = self.run(name).ok_or_else(|| format!("there are no frames `{name}`"))?;
        let folder = run.folder.as_ref().ok_or("frames are drawn from files, but nothing was written")?;
        let read = |file: &str| {
            let path = folder.join(file);
            fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
        };
        let pvd = format!("{inner}.pvd");
        let collection = Collection::from_pvd(&read(&pvd)?).map_err(|cause| format!("{pvd}: {cause}"))?;
        let distance = |at: &f64| time.map_or(-at, |time| (at - time).abs());
        let nearest = collection.frames.iter().min_by(|a, b| distance(&a.0).total_cmp(&distance(&b.0)));
        let (at, file) = nearest.ok_or_else(|| format!("{pvd} lists no frame"))?;
        let frame = Frame::from_vtu(&read(file)?).map_err(|cause| format!("{file}: {cause}"))?;
        Ok(Frame { time: *at, ..frame })
    }

    /// What the runs were computed from.
    pub(super) fn provenance(&self) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for run in &self.runs {
            for line in &run.provenance {
                // the program's version once
                if !(line.starts_with("tissue ") && lines.contains(line)) {
                    lines.push(line.clone());
                }
            }
        }
        lines
    }
}
