//! `tissue run` of a drive.

use super::Exit;
use super::arguments::RunOptions;
use super::input::Input;
use super::run::{draw, print_faults, print_verdicts, tell_at};
use crate::output::file::write_atomic;
use crate::output::report::RunStatus;
use crate::output::{DriveReport, Provenance};
use crate::run::{DriveJob, DriveOutcome, RunError, drive};
use crate::scene::Drive;
use std::path::Path;

/// Drives a material point and writes its tables, figures and report.
pub(super) fn run_drive(options: &RunOptions, input: &Input, described: &Drive, folder: &Path) -> Exit {
    let name = &described.name;
    let provenance = Provenance::new(&input.name, &input.hash, name);
    let job = DriveJob { drive: described, provenance, folder: Some(folder.to_path_buf()) };
    let DriveOutcome { mut report, tables, failure } = match drive(&job) {
        Ok(outcome) => outcome,
        Err(cause) => {
            tell!("error: drive `{name}`: {cause}");
            return Exit::Failed;
        }
    };
    let mut exit = if report.status == RunStatus::Held { Exit::Fine } else { Exit::Failed };
    let (files, drawn) = draw(name, &described.plots, &tables, &job.provenance, folder);
    report.files.extend(files);
    if !drawn {
        exit = Exit::Failed;
    }
    if let Err(cause) = write_atomic(&folder.join("run.json"), report.to_json().as_bytes()) {
        tell!("error: cannot write {}: {cause}", folder.join("run.json").display());
        exit = Exit::Failed;
    }
    if let Some(cause) = failure {
        tell!("error: drive `{name}` stopped: {cause}");
        if let RunError::ColumnWithoutValue(fault) = &cause {
            tell_at(&fault.place);
        }
        tell!("  every point before it is kept in {}", folder.display());
    }
    if options.quiet {
        print_faults(&report.expectations);
    } else {
        print_summary(name, &report, folder);
    }
    exit
}

fn print_summary(name: &str, report: &DriveReport, folder: &Path) {
    say!(
        "drive {name}: {} points, {} iterations in {:.1} ms, largest residual {:.1e} Pa",
        report.points,
        report.iterations,
        1e3 * report.wall_seconds,
        report.largest_residual
    );
    print_verdicts(&report.expectations);
    say!("  written to {}", folder.display());
}
