//! The loop of a run.
//!
//! Owns the order step, sample, write. Tables grow on disk row by row and frames are whole files,
//! so whatever ends the run, what was computed before it is readable.

use super::error::RunError;
use super::expect::judge_all;
use super::sampling::{Filming, Recording};
use super::schedule::Schedule;
use crate::monitor::{Observer, RESIDUAL_MOMENT, largest_residual, totals};
use crate::output::report::{Balance, Choice, RunStatus, TotalChange};
use crate::output::{Provenance, RunReport, Table, TableColumn, TableWriter};
use crate::plan::Plan;
use crate::scene::Scene;
use crate::solver::{Simulation, SolveError};
use std::fs::File;
use std::path::PathBuf;
use std::time::Instant;

/// What to run, and where to.
#[derive(Debug)]
pub struct Job<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its plan.
    pub plan: &'a Plan,
    /// What every file says of its origin.
    pub provenance: Provenance,
    /// An existing folder to write to; `None` keeps everything in memory.
    pub folder: Option<PathBuf>,
}

impl Job<'_> {
    /// The report of a run that has not ended: what it is and which files it is about to write.
    pub fn announcement(&self) -> RunReport {
        let tables = self.scene.records.iter().map(|record| format!("{}.csv", record.name));
        let frames = self.scene.frames.iter().map(|frames| format!("{}.pvd", frames.name));
        RunReport {
            provenance: self.provenance.clone(),
            plan: self.plan.to_string().lines().map(String::from).collect(),
            choices: self.plan.choices.iter().map(choice).collect(),
            files: tables
                .chain(self.scene.motion.iter().map(|_| "motion.csv".into()))
                .chain(frames)
                .collect(),
            ..RunReport::default()
        }
    }
}

/// What a run left behind.
#[derive(Debug)]
pub struct Outcome {
    /// The report, also written as `run.json`.
    pub report: RunReport,
    /// The tables, also written as CSV.
    pub tables: Vec<Table>,
    /// Why the run stopped early, if it did.
    pub failure: Option<RunError>,
}

/// Who watches a run.
pub trait Progress {
    /// Called after every step with the steps taken, the time, the last step and the end, all s.
    fn step(&mut self, steps: u64, time: f64, step: f64, end: f64);

    /// Whether the run is to stop before its next step.
    fn is_interrupted(&self) -> bool {
        false
    }
}

impl Progress for () {
    fn step(&mut self, _: u64, _: f64, _: f64, _: f64) {}
}

/// Runs a scene to its end or its failure.
///
/// # Errors
/// If it cannot be set up, or a file cannot be written. A simulation that goes wrong on the way is
/// no error here but [`Outcome::failure`], with everything before it written.
pub fn execute(job: &Job<'_>, progress: &mut dyn Progress) -> Result<Outcome, RunError> {
    let clock = Instant::now();
    let mut simulation = Simulation::new(job.scene, job.plan)?;
    let scene = job.scene;
    let tapes = scene.records.iter().flat_map(|record| record.columns.iter().map(|column| &column.value));
    let observer = Observer::new(scene, simulation.bodies(), tapes)?;
    refuse_floods(scene)?;
    let before = totals(simulation.bodies(), &scene.symmetry);
    let mut records = Vec::new();
    for record in &scene.records {
        records.push(Recording::new(job, record)?);
    }
    let mut frames: Vec<Filming<'_>> = scene.frames.iter().map(|frames| Filming::new(job, frames)).collect();
    let exact = motion_table(job, &simulation)?;
    let setup = clock.elapsed();
    let failure;
    loop {
        let time = simulation.time();
        let mut schedules = records.iter().map(|r| &r.schedule).chain(frames.iter().map(|f| &f.schedule));
        if schedules.any(|schedule| schedule.is_due(time))
            && let Err(cause) = simulation.synchronise()
        {
            failure = Some(RunError::Solve(cause));
            break;
        }
        match records.iter_mut().try_for_each(|recording| recording.sample(&simulation, &observer, time)) {
            Ok(()) => {}
            // a column without a value ends the run like a state without one
            Err(cause @ RunError::ColumnWithoutValue(_)) => {
                failure = Some(cause);
                break;
            }
            Err(cause) => return Err(cause),
        }
        for filming in &mut frames {
            filming.sample(&simulation, time)?;
        }
        let due = records.iter().map(|r| &r.schedule).chain(frames.iter().map(|f| &f.schedule));
        let next = due.filter_map(Schedule::next).fold(scene.run.until, f64::min);
        if time >= scene.run.until {
            failure = simulation.judge_energy().err().map(RunError::Solve);
            break;
        }
        match advance(&mut simulation, next, scene.run.until, progress) {
            Ok(true) => {}
            Ok(false) => {
                failure = Some(RunError::Interrupted);
                break;
            }
            Err(cause) => {
                failure = Some(RunError::Solve(cause));
                break;
            }
        }
    }
    let wall = (clock.elapsed() - setup).as_secs_f64();
    let after = totals(simulation.bodies(), &scene.symmetry);
    let tables: Vec<Table> = records.into_iter().map(|recording| recording.table).chain(exact).collect();
    let expectations = judge_all(&scene.expectations, &tables);
    let status = match &failure {
        Some(RunError::Interrupted) => RunStatus::Interrupted,
        Some(cause) => RunStatus::Stopped { cause: cause.to_string() },
        None if expectations.iter().all(|verdict| verdict.holds) => RunStatus::Held,
        None => RunStatus::ExpectationFailed,
    };
    let updates = simulation.particles() as f64 * simulation.evaluations() as f64;
    let mut report = RunReport {
        provenance: job.provenance.clone(),
        plan: job.plan.to_string().lines().map(String::from).collect(),
        choices: job.plan.choices.iter().map(choice).collect(),
        particles: simulation.particles() as u64,
        steps: simulation.steps(),
        evaluations: simulation.evaluations(),
        end_time: simulation.time(),
        wall_seconds: wall,
        updates_per_second: updates / wall.max(f64::MIN_POSITIVE),
        totals: total_changes(&before, &after),
        balance: balance(&mut simulation, scene),
        expectations,
        files: Vec::new(),
        status,
    };
    report.files = tables.iter().map(|table| format!("{}.csv", table.name)).collect();
    for filming in &frames {
        report.files.push(format!("{}.pvd", filming.frames.name));
        report.files.extend(filming.collection.frames.iter().map(|(_, file)| file.clone()));
    }
    Ok(Outcome { report, tables, failure })
}

/// Rows a table may have, and frames a series.
const MOST_ROWS: f64 = 1e6;
const MOST_FRAMES: f64 = 1e5;

/// Refuses intervals that would fill the disk.
fn refuse_floods(scene: &Scene) -> Result<(), RunError> {
    let until = scene.run.until;
    let records = scene.records.iter().map(|record| (&record.name, record.every, MOST_ROWS));
    let frames = scene.frames.iter().map(|frames| (&frames.name, frames.every, MOST_FRAMES));
    for (name, every, most) in records.chain(frames) {
        if until / every > most {
            return Err(RunError::TooManySamples { name: name.clone(), samples: until / every, most });
        }
    }
    Ok(())
}

/// The self-test of an exact motion: what it leaves of the momentum balance, as a table of one row.
fn motion_table(job: &Job<'_>, simulation: &Simulation) -> Result<Option<Table>, RunError> {
    if job.scene.motion.is_none() {
        return Ok(None);
    }
    let text = "momentum balance by finite differences, relative to its terms";
    let columns = vec![TableColumn::new("t", "s", "time"), TableColumn::new("residual", "", text)];
    let residual = largest_residual(simulation.bodies(), job.scene.run.until);
    if !residual.is_finite() {
        return Err(RunError::Motion { time: RESIDUAL_MOMENT * job.scene.run.until });
    }
    let rows = vec![vec![0.0, residual]];
    let table = Table { name: "motion".into(), columns, rows, provenance: job.provenance.lines() };
    if let Some(folder) = &job.folder {
        let path = folder.join("motion.csv");
        let file = File::create(&path).map_err(|cause| RunError::Io { path, cause })?;
        TableWriter::new(file, &table)?;
    }
    Ok(Some(table))
}

/// Takes all steps to the next sample; whether it was reached.
fn advance(
    simulation: &mut Simulation,
    next: f64,
    until: f64,
    progress: &mut dyn Progress,
) -> Result<bool, SolveError> {
    loop {
        if progress.is_interrupted() {
            return Ok(false);
        }
        let reached = simulation.step_towards(next)?;
        progress.step(simulation.steps(), simulation.time(), simulation.last_step(), until);
        if reached {
            return Ok(true);
        }
    }
}

/// The ledger of a simulation, for the whole bodies.
fn balance(simulation: &mut Simulation, scene: &Scene) -> Balance {
    let now = simulation.energies();
    let ledger = simulation.ledger();
    let images = f64::from(2_u32.pow(scene.symmetry.iter().flatten().count() as u32));
    let smallest_j = simulation.bodies().iter().flat_map(|body| {
        (0..body.len()).map(move |a| crate::monitor::field_value(body, a, crate::scene::Field::J))
    });
    Balance {
        start: images * ledger.start.total(),
        kinetic: images * now.kinetic,
        strain: images * now.strain,
        springs: images * now.springs,
        loads: images * ledger.loads,
        supports: images * ledger.supports,
        dissipated: images * ledger.dissipated,
        damped: images * ledger.damped,
        residual: images * ledger.residual(&now),
        smallest_j: smallest_j.fold(f64::INFINITY, f64::min),
    }
}

fn choice(choice: &crate::plan::Choice) -> Choice {
    Choice { key: choice.key.into(), value: choice.value.clone(), why: choice.origin.clone() }
}

fn total_changes(before: &crate::monitor::Totals, after: &crate::monitor::Totals) -> Vec<TotalChange> {
    let change =
        |name: String, unit: &str, start: f64, end: f64| TotalChange { name, unit: unit.into(), start, end };
    let mut changes = Vec::new();
    for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
        let (start, end) = (before.momentum[axis], after.momentum[axis]);
        changes.push(change(format!("momentum_{letter}"), "kg m/s", start, end));
    }
    for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
        let (start, end) = (before.angular_momentum[axis], after.angular_momentum[axis]);
        changes.push(change(format!("angular_momentum_{letter}"), "kg m^2/s", start, end));
    }
    changes.push(change("kinetic_energy".into(), "J", before.kinetic_energy, after.kinetic_energy));
    changes.push(change("strain_energy".into(), "J", before.strain_energy, after.strain_energy));
    changes.push(change("volume".into(), "m^3", before.volume, after.volume));
    changes
}
