//! A sweep from its points to one table and verdicts.
//!
//! Owns the order in which points are computed and what is read from each. Points are independent and
//! their results are put together in the order of the sweep, so the number of threads changes no bit.

use super::drive::{DriveJob, drive};
use super::error::RunError;
use super::execute::{Job, execute};
use super::expect::{column_of, judge_all};
use super::interpolate::crossing;
use crate::output::file::write_atomic;
use crate::output::report::RunStatus;
use crate::output::{PointReport, Provenance, SweepReport, Table, TableColumn};
use crate::plan::Plan;
use crate::scene::{Reduced, Sweep, SweepPoint, SweepRecord, Swept};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// What to sweep, and where to write.
#[derive(Debug)]
pub struct SweepJob<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// What every file says of its origin.
    pub provenance: Provenance,
    /// An existing folder to write tables to; `None` keeps everything in memory.
    pub folder: Option<PathBuf>,
    /// Threads to compute on.
    pub threads: usize,
}

/// What a sweep left behind.
#[derive(Debug)]
pub struct SweepOutcome {
    /// The report, without the figures.
    pub report: SweepReport,
    /// The tables of the sweep, also written as CSV.
    pub tables: Vec<Table>,
    /// The tables of each point, in the order of the sweep.
    pub points: Vec<Vec<Table>>,
}

/// Particles up to which a scene is computed on one thread beside others.
///
/// Below, the loops of one scene are too short to share well: two strips of 1 600 particles side by
/// side take about as long as one of them on both cores of a machine.
const FEW: f64 = 20_000.0;

/// Whether the points are computed side by side, one thread each, instead of one after the other.
pub fn side_by_side(sweep: &Sweep, threads: usize) -> bool {
    let few = |point: &SweepPoint| match &point.swept {
        Swept::Drive(_) => true,
        Swept::Scene(scene) => scene.most_particles() <= FEW,
    };
    threads > 1 && sweep.points.len() > 1 && sweep.points.iter().all(few)
}

/// What one point gave.
struct Computed {
    tables: Vec<Table>,
    report: PointReport,
}

/// Computes every point, and judges what is read from them.
///
/// # Errors
/// If a point cannot be set up, or a table cannot be written. A point that stops on its way is no error:
/// it is in the report, its columns that were not reached are missing, and no expectation holds.
pub fn sweep(job: &SweepJob<'_>) -> Result<SweepOutcome, RunError> {
    let clock = Instant::now();
    let sweep = job.sweep;
    let computed = if side_by_side(sweep, job.threads) {
        beside(sweep, job.threads, &job.provenance)
    } else {
        sweep.points.iter().map(|point| compute(sweep, point, &job.provenance)).collect()
    };
    let computed = computed.into_iter().collect::<Result<Vec<Computed>, RunError>>()?;
    let mut report = SweepReport {
        provenance: job.provenance.clone(),
        of: sweep.of.clone(),
        varied: sweep.varied.iter().map(|varied| varied.path.clone()).collect(),
        ..SweepReport::default()
    };
    let stopped = computed.iter().find_map(|point| point.report.stopped.clone());
    let mut tables = Vec::new();
    let mut unread = None;
    for record in &sweep.records {
        let (table, missing) = table(sweep, record, &computed, &job.provenance);
        unread = unread.or(missing);
        let name = format!("{}.csv", record.name);
        if let Some(folder) = &job.folder {
            let path = folder.join(&name);
            write_atomic(&path, table.to_csv()?.as_bytes()).map_err(|cause| RunError::Io { path, cause })?;
        }
        report.files.push(name);
        tables.push(table);
    }
    report.expectations = judge_all(&sweep.expectations, &tables);
    report.status = match stopped.or(unread) {
        Some(cause) => RunStatus::Stopped { cause },
        None if report.expectations.iter().all(|verdict| verdict.holds) => RunStatus::Held,
        None => RunStatus::ExpectationFailed,
    };
    let (reports, points) = computed.into_iter().map(|point| (point.report, point.tables)).unzip();
    report.points = reports;
    report.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(SweepOutcome { report, tables, points })
}

/// Points taken by whichever thread is free, results by their place.
fn beside(sweep: &Sweep, threads: usize, provenance: &Provenance) -> Vec<Result<Computed, RunError>> {
    let next = AtomicUsize::new(0);
    let count = sweep.points.len();
    let done: Vec<Mutex<Option<Result<Computed, RunError>>>> = (0..count).map(|_| Mutex::new(None)).collect();
    let work = || {
        // A pool of one: the loops of a scene stay on this thread.
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(point) = sweep.points.get(index) else { break };
            let result = match &alone {
                Ok(pool) => pool.install(|| compute(sweep, point, provenance)),
                Err(_) => compute(sweep, point, provenance),
            };
            if let Ok(mut slot) = done[index].lock() {
                *slot = Some(result);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.min(count) {
            scope.spawn(work);
        }
        work();
    });
    let taken = done.into_iter().zip(&sweep.points);
    taken
        .map(|(slot, point)| match slot.into_inner() {
            Ok(Some(result)) => result,
            // The thread that had it ended without a result.
            _ => compute(sweep, point, provenance),
        })
        .collect()
}

fn compute(sweep: &Sweep, point: &SweepPoint, provenance: &Provenance) -> Result<Computed, RunError> {
    let values = sweep.varied.iter().zip(&point.at);
    let mut report = PointReport {
        values: values.map(|(varied, &at)| format!("{} = {}", varied.path, varied.values[at].text)).collect(),
        ..PointReport::default()
    };
    let provenance =
        Provenance { scene: format!("{} of {}", sweep.of, provenance.scene), ..provenance.clone() };
    let tables = match &point.swept {
        Swept::Drive(described) => {
            let outcome = drive(&DriveJob { drive: described, provenance, folder: None })?;
            report.expectations = outcome.report.expectations;
            report.stopped = outcome.failure.map(|cause| cause.to_string());
            outcome.tables
        }
        Swept::Scene(scene) => {
            let plan = Plan::new(scene);
            let outcome = execute(&Job { scene, plan: &plan, provenance, folder: None }, &mut ())?;
            report.particles = outcome.report.particles;
            report.steps = outcome.report.steps;
            report.evaluations = outcome.report.evaluations;
            report.expectations = outcome.report.expectations;
            report.stopped = outcome.failure.map(|cause| cause.to_string());
            outcome.tables
        }
    };
    if let Some(cause) = &mut report.stopped {
        *cause = format!("{}: {cause}", report.values.join(", "));
    }
    Ok(Computed { tables, report })
}

/// The table of a record, without the points that lack a value, and the first that does.
fn table(
    sweep: &Sweep,
    record: &SweepRecord,
    computed: &[Computed],
    provenance: &Provenance,
) -> (Table, Option<String>) {
    let mut columns: Vec<TableColumn> = sweep
        .varied
        .iter()
        .map(|varied| {
            let words: Vec<String> =
                varied.values.iter().map(|value| format!("{} {}", value.value, value.text)).collect();
            let numbered = if varied.is_quantity { String::new() } else { format!(": {}", words.join(", ")) };
            TableColumn::new(&varied.column, &varied.unit, &format!("{}{numbered}", varied.path))
        })
        .collect();
    columns.extend(record.columns.iter().map(|c| TableColumn::new(&c.name, &c.unit, &c.text)));
    let mut table =
        Table { name: record.name.clone(), columns, rows: Vec::new(), provenance: provenance.lines() };
    let mut missing = None;
    for (point, computed) in sweep.points.iter().zip(computed) {
        let varied: Vec<f64> =
            sweep.varied.iter().zip(&point.at).map(|(varied, &at)| varied.values[at].value).collect();
        let mut row = varied.clone();
        let mut lacking = None;
        for column in &record.columns {
            let mut scratch = Vec::new();
            let value = column.value.evaluate(
                |reduced| {
                    read(reduced, &varied, computed).unwrap_or_else(|reason| {
                        lacking.get_or_insert(reason);
                        f64::NAN
                    })
                },
                &mut scratch,
            );
            if !value.is_finite() && lacking.is_none() {
                lacking = Some(format!("`{}` is {value}", column.name));
            }
            row.push(value);
        }
        match lacking {
            None => table.rows.push(row),
            Some(reason) => {
                let place = computed.report.values.join(", ");
                missing = missing.or(Some(format!("{place}: {reason}")));
            }
        }
    }
    (table, missing)
}

fn read(reduced: &Reduced, varied: &[f64], computed: &Computed) -> Result<f64, String> {
    let column = |record: &str, column: &str| column_of(&computed.tables, record, column);
    let work = &computed.report;
    match reduced {
        Reduced::Column { by, record, column: name } => {
            by.of(column(record, name)?).ok_or_else(|| format!("`{record}` has no rows"))
        }
        Reduced::Where { record, column: name, abscissa, value } => {
            let (x, y) = (column(record, abscissa)?, column(record, name)?);
            crossing(&x, &y, *value)
                .ok_or_else(|| format!("`{record}.{abscissa}` never takes the value {value:.6e}"))
        }
        Reduced::Varied(index) => varied.get(*index).copied().ok_or_else(|| "no such varied value".into()),
        Reduced::Particles => Ok(work.particles as f64),
        Reduced::Steps => Ok(work.steps as f64),
        Reduced::ParticleUpdates => Ok(work.particles as f64 * work.evaluations as f64),
    }
}
