//! A fit from its starting values to files and verdicts.
//!
//! Owns the path from a description to residuals, and from a minimum to tables and figures. The
//! minimisation and its statistics are the fit layer's, equilibrium the drive layer's.

mod figures;
mod response;
mod tables;

use super::error::RunError;
use super::expect::judge_all;
use crate::fit::{Ending, Minimum, Statistics, minimise};
use crate::output::file::write_atomic;
use crate::output::fit_report::{ColumnFit, FitReport, FittedParameter};
use crate::output::report::RunStatus;
use crate::output::{Provenance, Table};
use crate::scene::{Fit, Sought};
use response::{Measured, Model};
use std::path::PathBuf;
use std::time::Instant;

/// What to fit, and where to write.
#[derive(Debug)]
pub struct FitJob<'a> {
    /// The fit.
    pub fit: &'a Fit,
    /// What every file says of its origin.
    pub provenance: Provenance,
    /// An existing folder to write to; `None` keeps everything in memory.
    pub folder: Option<PathBuf>,
}

/// What a fit left behind.
#[derive(Debug)]
pub struct FitOutcome {
    /// The report.
    pub report: FitReport,
    /// Data, fitted values and differences, a table a drive.
    pub tables: Vec<Table>,
    /// Values and standard errors as `expect` reads them, a row each.
    pub found: Vec<Table>,
    /// Figures by file name.
    pub figures: Vec<(String, String)>,
}

/// Finds the parameters.
///
/// # Errors
/// If a law cannot be compiled, a drive has no equilibrium at the starting values, or a file cannot be
/// written. Parameters the data do not determine are findings of the report, no error.
pub fn fit(job: &FitJob<'_>) -> Result<FitOutcome, RunError> {
    let clock = Instant::now();
    let fit = job.fit;
    let mut model = Model::new(fit)?;
    let start: Vec<f64> = fit.vary.iter().map(|varied| varied.start).collect();
    let ranges: Vec<_> = fit.vary.iter().map(|varied| varied.range).collect();
    let minimum = minimise(&start, &ranges, |values| model.linear(values)).ok_or_else(|| model.fault())?;
    let statistics = Statistics::of(&minimum, &ranges);
    let measured = model.measured(&minimum.parameters)?;
    let tables = tables::of(fit, &measured, &job.provenance);
    let r_squared = r_squared(&measured, &minimum);
    let found = tables::found(fit, &minimum, &statistics, r_squared);
    let mut report = report(job, &minimum, &statistics, &measured, r_squared);
    let figures = figures::draw(fit, &measured, &model, &minimum, statistics.deviation, &job.provenance)?;
    let mut files: Vec<(String, String)> = Vec::new();
    files.push(("parameters.csv".into(), report.parameters_csv()));
    files.push(("correlation.csv".into(), report.correlation_csv()));
    for table in &tables {
        files.push((format!("{}.csv", table.name), table.to_csv()?));
    }
    files.extend(figures.iter().cloned());
    for (name, text) in files {
        if let Some(folder) = &job.folder {
            let path = folder.join(&name);
            write_atomic(&path, text.as_bytes()).map_err(|cause| RunError::Io { path, cause })?;
        }
        report.files.push(name);
    }
    report.expectations = judge_all(&fit.expectations, &found);
    let arrived = !matches!(minimum.ending, Ending::Stalled | Ending::OutOfSteps);
    report.status = if !arrived {
        RunStatus::Stopped { cause: "the sum of squares did not arrive at a minimum".into() }
    } else if report.expectations.iter().all(|verdict| verdict.holds) {
        RunStatus::Held
    } else {
        RunStatus::ExpectationFailed
    };
    report.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(FitOutcome { report, tables, found, figures })
}

/// `1 − Σ r²/Σ (y − ȳ)²`, both weighted, `ȳ` the weighted mean of each column.
fn r_squared(measured: &[Measured], minimum: &Minimum) -> f64 {
    let total: f64 = measured.iter().map(Measured::spread).sum();
    1.0 - minimum.sum / total
}

fn report(
    job: &FitJob<'_>,
    minimum: &Minimum,
    statistics: &Statistics,
    measured: &[Measured],
    r_squared: f64,
) -> FitReport {
    let fit = job.fit;
    let parameter = |(index, varied): (usize, &Sought)| {
        let value = minimum.parameters[index];
        FittedParameter {
            name: varied.name.clone(),
            value,
            unit: varied.unit.clone(),
            standard_error: statistics.standard_errors[index],
            start: varied.start,
            lower: varied.range.lower.map(|end| end.value),
            upper: varied.range.upper.map(|end| end.value),
            at_bound: varied.range.side(value) != 0,
        }
    };
    let finite = |value: f64| value.is_finite().then_some(value);
    let count = fit.vary.len();
    let row = |i: usize| (0..count).map(|j| finite(statistics.correlation[(i, j)])).collect();
    let column = |column: &Measured| ColumnFit {
        drive: column.drive.clone(),
        column: column.name.clone(),
        unit: column.unit.clone(),
        data: column.rows.len() as u64,
        rms_difference: column.rms_difference(),
        r_squared: column.r_squared(),
    };
    FitReport {
        provenance: job.provenance.clone(),
        weights: fit.weighing.word().into(),
        data: minimum.linear.residuals.len() as u64,
        parameters: fit.vary.iter().enumerate().map(parameter).collect(),
        correlation: (0..count).map(row).collect(),
        condition: finite(statistics.condition),
        deviation: finite(statistics.deviation),
        r_squared,
        first_sum: minimum.first_sum,
        sum: minimum.sum,
        columns: measured.iter().map(column).collect(),
        findings: statistics.findings.iter().map(|finding| tables::sentence(finding, fit)).collect(),
        steps: u64::from(minimum.steps),
        evaluations: u64::from(minimum.evaluations),
        ending: format!("{:?}", minimum.ending).to_lowercase(),
        ..FitReport::default()
    }
}
