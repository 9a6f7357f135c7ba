//! The expect lines of the benchmark scenes and of the library's drives as verdicts.
//!
//! Owns the running of embedded files in memory: what `tissue verify benchmarks` holds is what
//! `tissue run` judges in the same file.

use super::caught::caught;
use super::claim::{CONTROL_FACTOR, Tier, Topic, Verdict};
use super::claims::benchmarks::{BenchmarkFile, FILES, SCENES};
use super::page::Shown;
use crate::output::report::{ExpectationVerdict, RunStatus};
use crate::output::{Provenance, Table};
use crate::plan::Plan;
use crate::run::{
    DriveJob, FitJob, Job, SweepJob, SweepOutcome, control, drive, execute, figures, fit, sweep_figures,
};
use crate::scene::{
    Document, Drive, Expectation, Fit, LoadError, Loader, Plot, Scene, Sweep, library, resolve,
};
use crate::syntax::Source;

/// Files compiled into the program, by their path in the project.
struct Embedded;

impl Loader for Embedded {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        let found = FILES.iter().find(|(known, _)| *known == path);
        found.map(|(_, text)| text.to_string()).ok_or(LoadError::Missing)
    }
}

/// Resolves a benchmark scene from its embedded file, with values set in place of those written.
///
/// # Errors
/// The rendered mistakes if the file does not resolve.
pub fn benchmark(path: &str, overrides: &[(String, String)]) -> Result<Vec<Scene>, String> {
    let text = Embedded.load(path).map_err(|cause| format!("{path}: {cause}"))?;
    document(path, text, overrides).map(|document| document.scenes)
}

fn document(path: &str, text: String, overrides: &[(String, String)]) -> Result<Document, String> {
    let (document, mistakes) = resolve(&Source { name: path.into(), text }, &Embedded, overrides);
    if mistakes.is_empty() {
        return Ok(document);
    }
    Err(mistakes.iter().map(|mistake| mistake.render()).collect::<Vec<_>>().join("\n"))
}

/// Runs every benchmark scene and sweep of a tier and below, and every drive of the library, and judges
/// their expect lines; the plots of each stand beside its first line.
///
/// What does not resolve, cannot be set up or stops early is a verdict that fails, with its cause.
pub fn scene_verdicts(tier: Tier) -> (Vec<Verdict>, Vec<Shown>) {
    let mut held = Held::default();
    for BenchmarkFile { path, wrong, .. } in SCENES.iter().filter(|file| file.tier <= tier) {
        let text = Embedded.load(path).map_err(|cause| format!("{path}: {cause}"));
        held.document(path, text.and_then(|text| document(path, text, &[])), wrong);
    }
    held.verdicts.extend(library_verdicts());
    (held.verdicts, held.figures)
}

/// Runs every drive of the standard library and judges its expect lines.
pub fn library_verdicts() -> Vec<Verdict> {
    let mut held = Held::default();
    for file in library() {
        let path = format!("specs/{}/{}.tissue", file.library, file.name);
        held.document(&path, document(&path, file.text.into(), &[]), &[]);
    }
    held.verdicts
}

/// Verdicts and plots so far.
#[derive(Default)]
struct Held {
    verdicts: Vec<Verdict>,
    figures: Vec<Shown>,
}

impl Held {
    /// Adds what a file says, or the one verdict that it cannot be read.
    fn document(&mut self, path: &str, read: Result<Document, String>, wrong: &[(&str, &str)]) {
        let document = match read {
            Ok(document) => document,
            Err(cause) => {
                return self.verdicts.push(not_measured(format!("{path} can be read"), path.into(), &cause));
            }
        };
        for drive in &document.drives {
            self.add(path, &drive.name, &drive.expectations, || verdicts_of_drive(path, drive));
        }
        for fit in &document.fits {
            self.add(path, &fit.name, &fit.expectations, || Ok((verdicts_of_fit(path, fit)?, Vec::new())));
        }
        for scene in &document.scenes {
            self.add(path, &scene.name, &scene.expectations, || verdicts_of(path, scene, wrong));
        }
        for sweep in &document.sweeps {
            self.add(path, &sweep.name, &sweep.expectations, || verdicts_of_sweep(path, sweep, wrong));
        }
    }

    /// Adds the verdicts of a run, its plots beside the first; where it could not be judged, each of its lines fails.
    fn add(&mut self, path: &str, name: &str, expectations: &[Expectation], judge: impl FnOnce() -> Judged) {
        match caught(judge).and_then(|judged| judged) {
            Ok((verdicts, plots)) => {
                if let Some(first) = verdicts.first() {
                    let (claim, source) = (&first.claim, &first.source);
                    let shown = |svg| Shown { claim: claim.clone(), source: Some(source.clone()), svg };
                    self.figures.extend(plots.into_iter().map(shown));
                }
                self.verdicts.extend(verdicts);
            }
            Err(cause) if expectations.is_empty() => {
                self.verdicts.push(not_measured(format!("{name} can be run"), path.into(), &cause));
            }
            Err(cause) => self.verdicts.extend(expectations.iter().map(|expectation| {
                let place = format!("{}:{}", expectation.place.file, expectation.place.line);
                not_measured(format!("{name}: {}", expectation.text), place, &cause)
            })),
        }
    }
}

/// The verdict on a line of which nothing could be measured.
fn not_measured(claim: String, source: String, cause: &str) -> Verdict {
    Verdict {
        topic: Topic::Benchmarks,
        claim,
        source,
        because: "the tolerance the file states".into(),
        measured: f64::NAN,
        bound: f64::NAN,
        control: f64::NAN,
        cause: Some(format!("it could not be measured: {cause}")),
        holds: false,
    }
}

/// Verdicts of a run and its plots as SVG.
type Judged = Result<(Vec<Verdict>, Vec<String>), String>;

/// Curves of a run that reached its end; fields would need frames, which nothing in memory has.
fn pictures(
    name: &str,
    plots: &[Plot],
    tables: &[Table],
    provenance: &Provenance,
) -> Result<Vec<String>, String> {
    let plots: Vec<Plot> = plots.iter().filter(|plot| plot.picture.fields.is_none()).cloned().collect();
    drawn(name, figures(name, &plots, tables, provenance, None))
}

/// Plots that were drawn, or the first that could not be.
fn drawn(name: &str, plots: Vec<(String, Result<String, String>)>) -> Result<Vec<String>, String> {
    plots
        .into_iter()
        .map(|(plot, svg)| svg.map_err(|cause| format!("{name}, plot `{plot}`: {cause}")))
        .collect()
}

fn verdicts_of(path: &str, scene: &Scene, changes: &[(&str, &str)]) -> Judged {
    let plan = Plan::new(scene);
    let provenance = Provenance::new(path, "", &scene.name);
    let job = Job { scene, plan: &plan, provenance: provenance.clone(), folder: None };
    let outcome = execute(&job, &mut ()).map_err(|cause| format!("{path}: {cause}"))?;
    let (report, stopped) = (&outcome.report, cause_of(&outcome.report.status));
    let mut verdicts =
        judged(&scene.name, &scene.expectations, &report.expectations, &outcome.tables, stopped);
    let shown = if stopped.is_some() {
        Vec::new()
    } else {
        pictures(&scene.name, &scene.plots, &outcome.tables, &provenance)?
    };
    let results = wrong_variant(path, &scene.name, changes)?;
    for (verdict, wrong) in verdicts.iter_mut().zip(results) {
        // a line the wrong scene breaks shows what it can tell; others hold of any material
        if let Some(measured) = wrong.measured.filter(|measured| *measured > CONTROL_FACTOR * verdict.bound) {
            verdict.control = measured;
            verdict.because =
                format!("the tolerance the file states; the control is the scene with {}", listed(changes));
        }
    }
    Ok((verdicts, shown))
}

/// Changed values as they would be written: `a = 1 mm, b = 2`.
fn listed(changes: &[(&str, &str)]) -> String {
    changes.iter().map(|(key, value)| format!("{key} = {value}")).collect::<Vec<_>>().join(", ")
}

/// The expect lines of a scene judged on a run of its wrong variant; none where nothing is changed.
fn wrong_variant(
    path: &str,
    name: &str,
    changes: &[(&str, &str)],
) -> Result<Vec<ExpectationVerdict>, String> {
    if changes.is_empty() {
        return Ok(Vec::new());
    }
    let overrides: Vec<(String, String)> =
        changes.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
    let scenes = benchmark(path, &overrides)?;
    let Some(scene) = scenes.iter().find(|scene| scene.name == name) else { return Ok(Vec::new()) };
    let plan = Plan::new(scene);
    let job = Job { scene, plan: &plan, provenance: Provenance::new(path, "", name), folder: None };
    let outcome = execute(&job, &mut ()).map_err(|cause| format!("{path}, wrong variant: {cause}"))?;
    Ok(outcome.report.expectations)
}

fn verdicts_of_sweep(path: &str, described: &Sweep, changes: &[(&str, &str)]) -> Judged {
    let name = &described.name;
    let outcome = swept(path, described)?;
    let stopped = cause_of(&outcome.report.status);
    let found = &outcome.report.expectations;
    let mut verdicts = judged(name, &described.expectations, found, &outcome.tables, stopped);
    let provenance = Provenance::new(path, "", name);
    let shown = if stopped.is_some() {
        Vec::new()
    } else {
        drawn(name, sweep_figures(described, &outcome.tables, &outcome.points, &provenance))?
    };
    if changes.is_empty() {
        return Ok((verdicts, shown));
    }
    let overrides: Vec<(String, String)> =
        changes.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
    let text = Embedded.load(path).map_err(|cause| format!("{path}: {cause}"))?;
    let changed = document(path, text, &overrides)?;
    let Some(wrong) = changed.sweeps.iter().find(|sweep| sweep.name == *name) else {
        return Ok((verdicts, shown));
    };
    for (verdict, wrong) in verdicts.iter_mut().zip(swept(path, wrong)?.report.expectations) {
        if let Some(measured) = wrong.measured.filter(|measured| *measured > CONTROL_FACTOR * verdict.bound) {
            verdict.control = measured;
            verdict.because =
                format!("the tolerance the file states; the control is the sweep with {}", listed(changes));
        }
    }
    Ok((verdicts, shown))
}

fn swept(path: &str, sweep: &Sweep) -> Result<SweepOutcome, String> {
    let provenance = Provenance::new(path, "", &sweep.name);
    let threads = rayon::current_num_threads();
    let job = SweepJob { sweep, provenance, folder: None, threads };
    crate::run::sweep(&job).map_err(|cause| format!("{path}: {cause}"))
}

fn verdicts_of_drive(path: &str, described: &Drive) -> Judged {
    let provenance = Provenance::new(path, "", &described.name);
    let job = DriveJob { drive: described, provenance: provenance.clone(), folder: None };
    let outcome = drive(&job).map_err(|cause| format!("{path}: {cause}"))?;
    let (report, stopped) = (&outcome.report, cause_of(&outcome.report.status));
    let name = &described.name;
    let verdicts = judged(name, &described.expectations, &report.expectations, &outcome.tables, stopped);
    let shown = if stopped.is_some() {
        Vec::new()
    } else {
        pictures(name, &described.plots, &outcome.tables, &provenance)?
    };
    Ok((verdicts, shown))
}

fn verdicts_of_fit(path: &str, described: &Fit) -> Result<Vec<Verdict>, String> {
    let provenance = Provenance::new(path, "", &described.name);
    let outcome = fit(&FitJob { fit: described, provenance, folder: None })
        .map_err(|cause| format!("{path}: {cause}"))?;
    let stopped = cause_of(&outcome.report.status);
    let report = &outcome.report;
    Ok(judged(&described.name, &described.expectations, &report.expectations, &outcome.found, stopped))
}

/// Why a run stopped early, if it did.
fn cause_of(status: &RunStatus) -> Option<&str> {
    match status {
        RunStatus::Stopped { cause } => Some(cause),
        _ => None,
    }
}

fn judged(
    name: &str,
    expectations: &[Expectation],
    verdicts: &[ExpectationVerdict],
    tables: &[Table],
    stopped: Option<&str>,
) -> Vec<Verdict> {
    let pairs = expectations.iter().zip(verdicts);
    pairs
        .map(|(expectation, verdict)| Verdict {
            topic: Topic::Benchmarks,
            claim: format!("{name}: {}", verdict.text),
            source: verdict.place.clone(),
            because: "the tolerance the file states; the control reads the same line twenty tolerances off"
                .into(),
            measured: verdict.measured.unwrap_or(f64::NAN),
            bound: verdict.bound,
            control: control(expectation, tables).unwrap_or(f64::NAN),
            cause: stopped.map(|cause| format!("it stopped early: {cause}")).or_else(|| {
                verdict.measured.is_none().then(|| format!("it could not be measured: {}", verdict.note))
            }),
            holds: verdict.holds && stopped.is_none(),
        })
        .collect()
}

#[cfg(test)]
mod tests;
