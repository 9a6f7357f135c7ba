//! Tables and frames of the runs a picture shows.
//!
//! Owns names: `pull` of the only run, `axial.pull` of one of several.

use crate::output::{Collection, Frame, FrameField, Table};
use std::fs;
use std::path::{Path, PathBuf};

/// What one run left behind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RunResults {
    /// What the figure calls it; empty for the run a plot itself belongs to.
    pub name: String,
    /// Its tables.
    pub tables: Vec<Table>,
    /// Spacings of its bodies by name, m.
    pub spacings: Vec<(String, f64)>,
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
    /// Whether the runs were cut short, as for a quick look: a moment they do not reach is their last.
    pub short: bool,
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
        spacings: Vec<(String, f64)>,
        provenance: Vec<String>,
    ) -> Result<Self, String> {
        let mut tables = Vec::new();
        for record in records {
            let path = folder.join(format!("{record}.csv"));
            let text = fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))?;
            tables.push(Table::parse(record, &text).map_err(|cause| format!("{}: {cause}", path.display()))?);
        }
        Ok(Self { name: name.into(), tables, spacings, folder: Some(folder.to_path_buf()), provenance })
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

    /// The spacing of a body of a run.
    pub(super) fn spacing(&self, run: &str, body: &str) -> Option<f64> {
        let run = self.runs.iter().find(|known| known.name == run)?;
        run.spacings.iter().find(|(name, _)| name == body).map(|(_, spacing)| *spacing)
    }

    /// The frame of a series at a time, or the last one: between two frames positions and fields run
    /// linearly, before the first and after the last they stay.
    pub(super) fn frame(&self, name: &str, time: Option<f64>) -> Result<Frame, String> {
        let (run, inner) = self.run(name).ok_or_else(|| format!("there are no frames `{name}`"))?;
        let folder = run.folder.as_ref().ok_or("frames are drawn from files, but nothing was written")?;
        let read = |file: &str| {
            let path = folder.join(file);
            fs::read_to_string(&path).map_err(|cause| format!("{}: {cause}", path.display()))
        };
        let pvd = format!("{inner}.pvd");
        let collection = Collection::from_pvd(&read(&pvd)?).map_err(|cause| format!("{pvd}: {cause}"))?;
        let frame = |(at, file): &(f64, String)| -> Result<Frame, String> {
            let frame = Frame::from_vtu(&read(file)?).map_err(|cause| format!("{file}: {cause}"))?;
            Ok(Frame { time: *at, ..frame })
        };
        let frames = &collection.frames;
        let (first, last) =
            frames.first().zip(frames.last()).ok_or_else(|| format!("{pvd} lists no frame"))?;
        let Some(time) = time else { return frame(last) };
        // a frame and a time that differ by round-off are one
        let same = SAME * last.0.abs();
        if let Some(exact) = frames.iter().find(|known| (known.0 - time).abs() <= same) {
            return frame(exact);
        }
        match frames.iter().position(|known| known.0 > time) {
            None => frame(last),
            Some(0) => frame(first),
            Some(i) => between(&frame(&frames[i - 1])?, &frame(&frames[i])?, time)
                .ok_or_else(|| format!("{pvd}: frames {} and {i} do not fit together", i - 1)),
        }
    }

    /// What the runs were computed from.
    pub(super) fn provenance(&self) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for (number, run) in self.runs.iter().enumerate() {
            // a run that several sources name is one, as under `--quick`
            if self.runs[..number].iter().any(|earlier| earlier.provenance == run.provenance) {
                continue;
            }
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

/// Share of the last time below which two times are one.
const SAME: f64 = 1e-6;

/// Positions and fields at a time between two frames, `None` where they are not of the same particles.
///
/// ```text
/// f(t) = f₀ + (t − t₀)/(t₁ − t₀) (f₁ − f₀)
/// ```
///
/// The error is that of linear interpolation, `⅛ (t₁ − t₀)² f̈`, with the interval of the frames.
fn between(before: &Frame, after: &Frame, time: f64) -> Option<Frame> {
    let share = (time - before.time) / (after.time - before.time);
    let fits = before.displacement.len() == after.displacement.len()
        && before.fields.len() == after.fields.len()
        && before.fields.iter().zip(&after.fields).all(|(a, b)| a.values.len() == b.values.len());
    if !fits {
        return None;
    }
    let pairs = before.displacement.iter().zip(&after.displacement);
    let displacement = pairs.map(|(a, b)| a + share * (b - a)).collect();
    let fields = before.fields.iter().zip(&after.fields);
    let fields = fields
        .map(|(a, b)| {
            let values = a.values.iter().zip(&b.values).map(|(a, b)| a + share * (b - a)).collect();
            FrameField { values, ..a.clone() }
        })
        .collect();
    Some(Frame { time, displacement, fields, ..before.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tensor::Vec3;

    fn frame(time: f64, x: f64, values: &[f64]) -> Frame {
        let at = |_: &f64| Vec3::new(x, 0.0, -x);
        Frame {
            time,
            reference: values.iter().map(|_| Vec3::zeros()).collect(),
            displacement: values.iter().map(at).collect(),
            fields: vec![FrameField::scalar("J", "", values)],
            ..Frame::default()
        }
    }

    #[test]
    fn between_two_frames_positions_and_fields_run_linearly() {
        let (a, b) = (frame(1.0, 2.0, &[4.0, 8.0]), frame(3.0, 6.0, &[8.0, 0.0]));
        let middle = between(&a, &b, 1.5).expect("the same particles");
        assert_eq!((middle.time, middle.displacement[1]), (1.5, Vec3::new(3.0, 0.0, -3.0)));
        assert_eq!(middle.fields[0].values, [5.0, 6.0]);
        assert_eq!(between(&a, &frame(3.0, 6.0, &[8.0]), 1.5), None);
    }
}
