//! `tissue run` of a fit.

use super::Exit;
use super::arguments::RunOptions;
use super::input::Input;
use super::run::{print_faults, print_verdicts};
use crate::output::Provenance;
use crate::output::file::write_atomic;
use crate::output::fit_report::{FitReport, FittedParameter};
use crate::output::report::RunStatus;
use crate::run::{FitJob, FitOutcome, fit};
use crate::scene::Fit;
use crate::verify::quantity;
use std::path::Path;

/// Most parameters whose correlations are printed.
const MOST_CORRELATED: usize = 10;

/// Fits parameters and writes tables, figures and report.
pub(super) fn run_fit(options: &RunOptions, input: &Input, described: &Fit, folder: &Path) -> Exit {
    let name = &described.name;
    let provenance = Provenance::new(&input.name, &input.hash, name);
    let job = FitJob { fit: described, provenance, folder: Some(folder.to_path_buf()) };
    let FitOutcome { report, .. } = match fit(&job) {
        Ok(outcome) => outcome,
        Err(cause) => {
            tell!("error: fit `{name}`: {cause}");
            return if cause.is_input() { Exit::WrongInput } else { Exit::Failed };
        }
    };
    let mut exit = if report.status == RunStatus::Held { Exit::Fine } else { Exit::Failed };
    if let Err(cause) = write_atomic(&folder.join("run.json"), report.to_json().as_bytes()) {
        tell!("error: cannot write {}: {cause}", folder.join("run.json").display());
        exit = Exit::Failed;
    }
    if let RunStatus::Stopped { cause } = &report.status {
        tell!("error: fit `{name}` stopped: {cause}");
    }
    if options.quiet {
        print_faults(&report.expectations);
    } else {
        print_summary(name, &report);
        for finding in &report.findings {
            tell!("warning: {finding}");
        }
        print_verdicts(&report.expectations);
        say!("  written to {}", folder.display());
    }
    exit
}

fn print_summary(name: &str, report: &FitReport) {
    say!(
        "fit {name}: {} data, {} parameters, {} steps in {:.1} ms, {}",
        report.data,
        report.parameters.len(),
        report.steps,
        1e3 * report.wall_seconds,
        report.ending
    );
    let longest = report.parameters.iter().map(|parameter| parameter.name.len()).max().unwrap_or(0);
    for parameter in &report.parameters {
        say!("  {:<longest$}  {}", parameter.name, value(parameter));
    }
    let condition = report.condition.map_or("infinite".into(), |condition| format!("{condition:.2e}"));
    say!("  explains {:.3} % of the weighted spread, condition {condition}", 100.0 * report.r_squared);
    for column in &report.columns {
        let size = match column.unit.as_str() {
            "" => format!("{:.3e}", column.rms_difference),
            unit => quantity(column.rms_difference, unit),
        };
        say!(
            "    {}: {} data of {}, differences {} (root mean square), {:.3} % explained",
            column.drive,
            column.data,
            column.column,
            size,
            100.0 * column.r_squared
        );
    }
    if (2..=MOST_CORRELATED).contains(&report.parameters.len()) {
        say!("  correlation");
        for (parameter, row) in report.parameters.iter().zip(&report.correlation) {
            let entries: Vec<String> = row
                .iter()
                .map(|entry| entry.map_or("      –".into(), |entry| format!("{entry:7.3}")))
                .collect();
            say!("    {:<longest$}{}", parameter.name, entries.concat());
        }
    }
}

/// `19.23 kPa ± 966.5 Pa (5.0 %), from 10.00 kPa`
fn value(parameter: &FittedParameter) -> String {
    let shown = |value: f64| match parameter.unit.as_str() {
        "" => format!("{value:.5}"),
        unit => quantity(value, unit),
    };
    let error = match parameter.standard_error {
        Some(error) => format!("± {} ({:.1} %)", shown(error), 100.0 * error / parameter.value.abs()),
        None if parameter.at_bound => "at its bound".into(),
        None => "not determined".into(),
    };
    format!("{} {error}, from {}", shown(parameter.value), shown(parameter.start))
}
