//! `tissue run` of a sweep or a trade.

use super::Exit;
use super::arguments::RunOptions;
use super::input::Input;
use super::memory::fits;
use super::run::{print_faults, print_verdicts, write_figures};
use crate::output::file::write_atomic;
use crate::output::report::RunStatus;
use crate::output::{Provenance, SweepReport, Table};
use crate::run::{Setting, SweepJob, SweepOutcome, settings, sweep, sweep_figures};
use crate::scene::{Sweep, Swept};
use std::path::Path;

/// Computes the points of a sweep and writes its tables, figures and report.
pub(super) fn run_sweep(options: &RunOptions, input: &Input, described: &Sweep, folder: &Path) -> Exit {
    let name = &described.name;
    let kind = if described.trade.is_some() { "trade" } else { "sweep" };
    for point in &described.points {
        let Swept::Scene(scene) = &point.swept else { continue };
        if let Err(message) = fits(scene) {
            tell!("error: {kind} `{name}`: {message}");
            return Exit::WrongInput;
        }
    }
    let provenance = Provenance::new(&input.name, &input.hash, name);
    let threads = rayon::current_num_threads();
    let job = SweepJob { sweep: described, provenance, folder: Some(folder.to_path_buf()), threads };
    let SweepOutcome { mut report, tables, points } = match sweep(&job) {
        Ok(outcome) => outcome,
        Err(cause) => {
            tell!("error: {kind} `{name}`: {cause}");
            return if cause.is_input() { Exit::WrongInput } else { Exit::Failed };
        }
    };
    let mut exit = if report.status == RunStatus::Held { Exit::Fine } else { Exit::Failed };
    let figures = sweep_figures(described, &tables, &points, &job.provenance);
    let (files, drawn) = write_figures(figures, folder);
    report.files.extend(files);
    if !drawn {
        exit = Exit::Failed;
    }
    if let Err(cause) = write_atomic(&folder.join("run.json"), report.to_json().as_bytes()) {
        tell!("error: cannot write {}: {cause}", folder.join("run.json").display());
        exit = Exit::Failed;
    }
    if let RunStatus::Stopped { cause } = &report.status {
        tell!("error: {kind} `{name}` is not whole: {cause}");
    }
    if options.quiet {
        print_faults(&report.expectations);
    } else {
        print_summary(described, &report, &tables, folder);
    }
    exit
}

fn print_summary(described: &Sweep, report: &SweepReport, tables: &[Table], folder: &Path) {
    let word = if described.trade.is_some() { "trade" } else { "sweep" };
    say!(
        "{word} {}: {} points of `{}` in {:.1} s",
        described.name,
        report.points.len(),
        described.of,
        report.wall_seconds
    );
    for point in &report.points {
        let held = point.expectations.iter().filter(|verdict| verdict.holds).count();
        let of = point.expectations.len();
        if held < of {
            say!("  {}: {held} of {of} expect lines of `{}` hold", point.values.join(", "), described.of);
            print_missed(point);
        }
    }
    if let (Some(trade), Some(table)) = (&described.trade, tables.first()) {
        print_trade(&settings(described, table), &trade.cost, &trade.unit, trade.tolerance);
    }
    print_verdicts(&report.expectations);
    say!("  written to {}", folder.display());
}

/// The lines of a point that do not hold.
fn print_missed(point: &crate::output::PointReport) {
    for verdict in point.expectations.iter().filter(|verdict| !verdict.holds) {
        say!("    {}: {}", verdict.text, verdict.note);
    }
}

/// Every setting, the cheapest first, and the one to take.
fn print_trade(settings: &[Setting], cost: &str, unit: &str, tolerance: Option<f64>) {
    let mut ordered: Vec<&Setting> = settings.iter().collect();
    ordered.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    for setting in &ordered {
        let mark = if setting.on_front { "*" } else { " " };
        let (error, values) = (setting.error, setting.values.join(", "));
        say!("  {mark} error {error:.3e}{unit}  {cost} {:.3e}  {values}", setting.cost);
    }
    say!("  * no other setting is at least as good in both");
    match (tolerance, ordered.iter().find(|setting| setting.allowed)) {
        (Some(tolerance), Some(best)) => say!(
            "  for an error of {tolerance:.3e}{unit} take {}: {cost} {:.3e}",
            best.values.join(", "),
            best.cost
        ),
        (Some(tolerance), None) => {
            say!("  no setting keeps the error within {tolerance:.3e}{unit}; vary further");
        }
        (None, _) => {}
    }
}
