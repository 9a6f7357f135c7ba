//! Records and frames on their way to files while a run proceeds.
//!
//! Owns when each is due and what of it is on disk; the order of sampling is the loop's.

use super::error::{ColumnFault, RunError};
use super::execute::Job;
use super::schedule::Schedule;
use super::snapshot::frame;
use crate::monitor::Observer;
use crate::output::file::write_atomic;
use crate::output::{Collection, Table, TableColumn, TableWriter};
use crate::scene::{Column, Frames, Record};
use crate::solver::Simulation;
use std::fs::File;
use std::path::Path;

/// A record on its way to a table.
pub(super) struct Recording<'a> {
    record: &'a Record,
    pub(super) schedule: Schedule,
    pub(super) table: Table,
    writer: Option<TableWriter<File>>,
}

impl<'a> Recording<'a> {
    pub(super) fn new(job: &Job<'_>, record: &'a Record) -> Result<Self, RunError> {
        let mut columns = vec![TableColumn::new("t", "s", "time")];
        columns.extend(
            record.columns.iter().map(|Column { name, unit, text, .. }| TableColumn::new(name, unit, text)),
        );
        let table = Table {
            name: record.name.clone(),
            columns,
            rows: Vec::new(),
            provenance: job.provenance.lines(),
        };
        let writer = match &job.folder {
            None => None,
            Some(folder) => {
                let path = folder.join(format!("{}.csv", record.name));
                let file = File::create(&path).map_err(|cause| RunError::Io { path, cause })?;
                Some(TableWriter::new(file, &table)?)
            }
        };
        Ok(Self { record, schedule: Schedule::new(record.every, job.scene.run.until), table, writer })
    }

    pub(super) fn sample(
        &mut self,
        simulation: &Simulation,
        observer: &Observer,
        time: f64,
    ) -> Result<(), RunError> {
        if !self.schedule.take(time) {
            return Ok(());
        }
        let tapes = self.record.columns.iter().map(|column| &column.value);
        let mut row = vec![time];
        row.extend(observer.evaluate(simulation, tapes));
        if let Some(fault) = without_value(&self.record.name, &self.record.columns, "t", "s", &row) {
            return Err(fault);
        }
        if let Some(writer) = &mut self.writer {
            writer.append(&row)?;
        }
        self.table.rows.push(row);
        Ok(())
    }
}

/// A series of frames on its way to files.
pub(super) struct Filming<'a> {
    pub(super) frames: &'a Frames,
    pub(super) schedule: Schedule,
    pub(super) collection: Collection,
    folder: Option<&'a Path>,
    provenance: Vec<String>,
}

impl<'a> Filming<'a> {
    pub(super) fn new(job: &'a Job<'_>, frames: &'a Frames) -> Self {
        let provenance = job.provenance.lines();
        Self {
            frames,
            schedule: Schedule::new(frames.every, job.scene.run.until),
            collection: Collection { provenance: provenance.clone(), ..Collection::default() },
            folder: job.folder.as_deref(),
            provenance,
        }
    }

    pub(super) fn sample(&mut self, simulation: &Simulation, time: f64) -> Result<(), RunError> {
        if !self.schedule.take(time) {
            return Ok(());
        }
        let Some(folder) = self.folder else { return Ok(()) };
        let write = |name: &str, text: String| {
            let path = folder.join(name);
            write_atomic(&path, text.as_bytes()).map_err(|cause| RunError::Io { path, cause })
        };
        let name = self.collection.next_name(&self.frames.name);
        write(&name, frame(simulation, &self.frames.values, &self.provenance).to_vtu()?)?;
        self.collection.frames.push((time, name));
        write(&format!("{}.pvd", self.frames.name), self.collection.to_pvd())
    }
}

/// The first column of a row, after the one it starts with, that is infinite or undefined.
pub(super) fn without_value<L>(
    record: &str,
    columns: &[Column<L>],
    abscissa: &str,
    unit: &str,
    row: &[f64],
) -> Option<RunError> {
    let (at, values) = row.split_first()?;
    let (column, &value) = columns.iter().zip(values).find(|(_, value)| !value.is_finite())?;
    let at =
        if unit.is_empty() { format!("{abscissa} = {at}") } else { format!("{abscissa} = {at:.4e} {unit}") };
    let fault = ColumnFault {
        record: record.into(),
        column: column.name.clone(),
        expression: column.text.clone(),
        place: column.place.clone(),
        at,
        value,
    };
    Some(RunError::ColumnWithoutValue(Box::new(fault)))
}
