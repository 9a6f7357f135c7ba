//! The expect lines of the benchmark scenes as verdicts.
//!
//! Owns the running of embedded scenes in memory: what `tissue verify benchmarks` holds is what
//! `tissue run` judges in the same file.

use super::claim::{Topic, Verdict};
use super::claims::benchmarks::{BenchmarkFile, FILES, SCENES};
use crate::output::Provenance;
use crate::plan::Plan;
use crate::run::{Job, control, execute};
use crate::scene::{LoadError, Loader, Scene, resolve};
use crate::syntax::Source;

/// Files compiled into the program, by their path in the project.
struct Embedded;

impl Loader for Embedded {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        let found = FILES.iter().find(|file| file.path == path);
        found.map(|file| file.text.to_string()).ok_or(LoadError::Missing)
    }
}

/// Resolves a benchmark scene from its embedded file, with values set in place of those written.
///
/// # Errors
/// The rendered mistakes if the file does not resolve.
pub fn benchmark(path: &str, overrides: &[(String, String)]) -> Result<Vec<Scene>, String> {
    let text = Embedded.load(path).map_err(|cause| format!("{path}: {cause}"))?;
    let (document, mistakes) = resolve(&Source { name: path.into(), text }, &Embedded, overrides);
    if mistakes.is_empty() {
        return Ok(document.scenes);
    }
    Err(mistakes.iter().map(|mistake| mistake.render()).collect::<Vec<_>>().join("\n"))
}

/// Runs every benchmark scene and judges its expect lines.
///
/// # Errors
/// If a scene does not resolve or cannot be set up. A run that stops early is a verdict that fails.
pub fn scene_verdicts() -> Result<Vec<Verdict>, String> {
    let mut verdicts = Vec::new();
    for BenchmarkFile { path, .. } in SCENES {
        for scene in benchmark(path, &[])? {
            verdicts.extend(verdicts_of(path, &scene)?);
        }
    }
    Ok(verdicts)
}

fn verdicts_of(path: &str, scene: &Scene) -> Result<Vec<Verdict>, String> {
    let plan = Plan::new(scene);
    let provenance = Provenance::new(path, "", &scene.name);
    let job = Job { scene, plan: &plan, provenance, folder: None };
    let outcome = execute(&job, &mut ()).map_err(|cause| format!("{path}: {cause}"))?;
    let judged = scene.expectations.iter().zip(&outcome.report.expectations);
    Ok(judged
        .map(|(expectation, verdict)| Verdict {
            topic: Topic::Benchmarks,
            claim: format!("{}: {}", scene.name, verdict.text),
            source: verdict.place.clone(),
            because: "the tolerance the scene states; the control reads the same line twenty tolerances off"
                .into(),
            measured: verdict.measured.unwrap_or(f64::NAN),
            bound: verdict.bound,
            control: control(expectation, &outcome.tables).unwrap_or(f64::NAN),
            holds: verdict.holds && outcome.failure.is_none(),
        })
        .collect())
}
