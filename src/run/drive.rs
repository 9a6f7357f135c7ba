//! A drive from its first point to files and verdicts.
//!
//! Owns the path from a description to targets, and from equilibria to tables. Equilibrium itself is
//! the drive layer's.

use super::error::RunError;
use super::expect::judge_all;
use super::sampling::without_value;
use crate::drive::{Control, Drive as MaterialPoint, Point, Target, Volume, frame};
use crate::energy::Law;
use crate::monitor::von_mises;
use crate::output::file::write_atomic;
use crate::output::report::RunStatus;
use crate::output::{DriveReport, Provenance, Table, TableColumn};
use crate::scene::{Drive, Path, PathControl, PointProbe, PointRecord, VolumeChange};
use crate::tensor::{Mat3, Vec3};
use std::path::PathBuf;
use std::time::Instant;

/// What to drive, and where to write.
#[derive(Debug)]
pub struct DriveJob<'a> {
    /// The drive.
    pub drive: &'a Drive,
    /// What every file says of its origin.
    pub provenance: Provenance,
    /// An existing folder to write tables to; `None` keeps everything in memory.
    pub folder: Option<PathBuf>,
}

/// What a drive left behind.
#[derive(Debug)]
pub struct DriveOutcome {
    /// The report, without the figures.
    pub report: DriveReport,
    /// The tables, also written as CSV.
    pub tables: Vec<Table>,
    /// Why the drive stopped early, if it did.
    pub failure: Option<RunError>,
}

/// Drives a material point to the end of its path or its failure.
///
/// # Errors
/// If it cannot be set up, or a table cannot be written. A point without equilibrium is no error here
/// but [`DriveOutcome::failure`], with every point before it in the tables; so is a column without a value.
pub fn drive(job: &DriveJob<'_>) -> Result<DriveOutcome, RunError> {
    let clock = Instant::now();
    let drive = job.drive;
    let values: Vec<f64> = drive.material.parameters.iter().map(|parameter| parameter.value).collect();
    let law = Law::compile(&drive.material.energy, &values)
        .map_err(|cause| RunError::Law { material: drive.material.name.clone(), cause })?;
    let directions: Vec<Vec3> = drive.directions.iter().map(|&direction| Vec3::from(direction)).collect();
    let axes = frame(&Vec3::from(drive.axes[0]), &Vec3::from(drive.axes[1]))?;
    let incompressible = drive.volume == VolumeChange::Incompressible;
    let volume = if incompressible { Volume::Incompressible } else { Volume::Compressible };
    let point = MaterialPoint { law: &law, directions: &directions, frame: axes, volume };
    let mut tables: Vec<Table> =
        drive.records.iter().map(|record| table(drive, record, &job.provenance)).collect();
    let mut report = DriveReport {
        provenance: job.provenance.clone(),
        material: drive.material.name.clone(),
        path: drive.written.clone(),
        incompressible,
        ..DriveReport::default()
    };
    let mut scratch = Vec::new();
    let found = point.visit(
        |parameter| target(&drive.path, parameter, incompressible),
        &drive.parameters(),
        |point| {
            report.points += 1;
            report.iterations += u64::from(point.iterations);
            report.largest_residual = report.largest_residual.max(point.residual);
            let seen = Seen::from(point, &axes);
            for (record, table) in drive.records.iter().zip(&mut tables) {
                table.rows.push(row(record, &seen, &mut scratch));
            }
        },
    );
    let failure = cut(drive, &mut tables).or(found.err().map(RunError::Drive));
    for table in &tables {
        let name = format!("{}.csv", table.name);
        let text = table.to_csv()?;
        if let Some(folder) = &job.folder {
            let path = folder.join(&name);
            write_atomic(&path, text.as_bytes()).map_err(|cause| RunError::Io { path, cause })?;
        }
        report.files.push(name);
    }
    report.expectations = judge_all(&drive.expectations, &tables);
    report.status = match &failure {
        Some(cause) => RunStatus::Stopped { cause: cause.to_string() },
        None if report.expectations.iter().all(|verdict| verdict.holds) => RunStatus::Held,
        None => RunStatus::ExpectationFailed,
    };
    report.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(DriveOutcome { report, tables, failure })
}

/// Ends all tables before the first row in which a column has no value; which one that is.
fn cut(drive: &Drive, tables: &mut [Table]) -> Option<RunError> {
    let mut first: Option<(usize, RunError)> = None;
    for (record, table) in drive.records.iter().zip(tables.iter()) {
        let fault =
            |row: &Vec<f64>| without_value(&record.name, &record.columns, &drive.parameter, &drive.unit, row);
        let found = table.rows.iter().enumerate().find_map(|(at, row)| fault(row).map(|fault| (at, fault)));
        if let Some((at, fault)) = found
            && first.as_ref().is_none_or(|(before, _)| at < *before)
        {
            first = Some((at, fault));
        }
    }
    let (at, fault) = first?;
    for table in tables {
        table.rows.truncate(at);
    }
    Some(fault)
}

/// What a path prescribes at a value of its parameter.
pub(super) fn target(path: &Path, parameter: f64, incompressible: bool) -> Target {
    match path {
        Path::Uniaxial => Target::uniaxial(parameter),
        Path::Biaxial { ratio } => Target::biaxial(parameter, 1.0 + ratio * (parameter - 1.0)),
        Path::Equibiaxial => Target::equibiaxial(parameter),
        Path::Planar => Target::planar(parameter),
        Path::SimpleShear if incompressible => Target::simple_shear_free(parameter),
        Path::SimpleShear => Target::simple_shear(parameter),
        Path::Deformation(controls) => {
            let mut scratch = Vec::new();
            let components = controls.each_ref().map(|row| {
                row.each_ref().map(|control| match control {
                    PathControl::Deformation(tape) => {
                        Control::Deformation(tape.evaluate(|_| parameter, &mut scratch))
                    }
                    PathControl::FirstPiola(tape) => {
                        Control::FirstPiola(tape.evaluate(|_| parameter, &mut scratch))
                    }
                    PathControl::Cauchy(tape) => Control::Cauchy(tape.evaluate(|_| parameter, &mut scratch)),
                })
            });
            Target { components }
        }
    }
}

/// A point with its tensors in the axes of the path.
pub(super) struct Seen {
    point: Point,
    f: Mat3,
    first_piola: Mat3,
    pub(super) cauchy: Mat3,
}

impl Seen {
    pub(super) fn from(point: &Point, axes: &Mat3) -> Self {
        let turned = |tensor: &Mat3| axes.transpose() * tensor * axes;
        Self {
            point: *point,
            f: turned(&point.f),
            first_piola: turned(&point.first_piola),
            cauchy: turned(&point.cauchy),
        }
    }

    pub(super) fn value(&self, probe: PointProbe) -> f64 {
        let at = |tensor: &Mat3, i: u8, j: u8| tensor[(usize::from(i), usize::from(j))];
        match probe {
            PointProbe::Parameter => self.point.parameter,
            PointProbe::F(i, j) => at(&self.f, i, j),
            PointProbe::P(i, j) => at(&self.first_piola, i, j),
            PointProbe::Sigma(i, j) => at(&self.cauchy, i, j),
            PointProbe::Psi => self.point.psi,
            PointProbe::J => self.point.j,
            PointProbe::VonMises => von_mises(&self.cauchy),
            PointProbe::Pressure => self.cauchy.trace() / 3.0,
            PointProbe::ConstraintStress => self.point.constraint_stress,
            PointProbe::Residual => self.point.residual,
        }
    }
}

fn table(drive: &Drive, record: &PointRecord, provenance: &Provenance) -> Table {
    let mut columns = vec![TableColumn::new(&drive.parameter, &drive.unit, "parameter of the path")];
    columns.extend(record.columns.iter().map(|c| TableColumn::new(&c.name, &c.unit, &c.text)));
    Table { name: record.name.clone(), columns, rows: Vec::new(), provenance: provenance.lines() }
}

fn row(record: &PointRecord, seen: &Seen, scratch: &mut Vec<f64>) -> Vec<f64> {
    let columns = record.columns.iter();
    let values = columns.map(|column| column.value.evaluate(|probe| seen.value(*probe), scratch));
    std::iter::once(seen.point.parameter).chain(values).collect()
}
