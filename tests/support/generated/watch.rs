//! Runs a scene and says what it did wrong.
//!
//! Owns the properties that hold of every scene. Knows no drawing.

use super::ledger::Ledger;
use super::momenta::Momenta;
use super::states::{admissible, gradients, initial_gap, sound};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::OnceLock;
use tissue::discretisation::DiscretisationError;
use tissue::monitor::Observer;
use tissue::plan::Plan;
use tissue::scene::{FileSystem, Mistake, Scene, resolve};
use tissue::solver::{Cause, Simulation, SolveError};
use tissue::syntax::Source;

/// What became of a scene that did nothing wrong.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The text was refused: first lines of the mistakes.
    Mistaken(Vec<String>),
    /// It could not be set up, and why.
    Refused(String),
    /// It ran so many steps; largest share of the allowed energy it had.
    Ran(u64, f64),
    /// It stopped with a cause, after so many steps.
    Stopped(u64, String),
}

/// A property that does not hold, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// The property in a word.
    pub kind: &'static str,
    /// What was found.
    pub found: String,
}

/// How closely to look.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Most steps taken.
    pub steps: u64,
    /// Whether everything at work is far below what the material bears, so that no run may stop.
    pub calm: bool,
    /// Whether to run it on three threads too.
    pub threads: bool,
    /// An override, as of `--set`: what a message advised.
    pub set: Option<(&'static str, &'a str)>,
    /// What a control makes the properties blind to.
    pub blind: Option<Blind>,
}

/// Something a control leaves out of the accounts, so that a sound run must look like a fault.
#[derive(Clone, Copy, PartialEq)]
pub enum Blind {
    /// The work of loads and supports: energy comes from nothing.
    Work,
    /// Their impulse: so does momentum.
    Impulse,
    /// The scene's Courant number: the energy is judged by this one.
    Courant(f64),
    /// F: the area map, which is no gradient, is held against the bound of round-off in its place.
    Gradient,
}

impl Watch<'_> {
    /// So many steps of a scene.
    pub fn new(steps: u64, calm: bool) -> Self {
        Self { steps, calm, threads: true, set: None, blind: None }
    }
}

/// A fault of a kind.
pub fn fault(kind: &'static str, found: impl Into<String>) -> Fault {
    Fault { kind, found: found.into() }
}

/// Runs the scene of a file, which may panic: that is a fault too.
///
/// # Errors
/// The first property that does not hold.
pub fn watch(path: &Path, look: Watch<'_>) -> Result<Outcome, Fault> {
    let watched = catch_unwind(AssertUnwindSafe(|| pool(1).install(|| watch_scene(path, look))));
    watched.unwrap_or_else(|cause| {
        let text = cause.downcast_ref::<String>().cloned();
        let text = text.or_else(|| cause.downcast_ref::<&str>().map(|text| text.to_string()));
        Err(fault("panic", text.unwrap_or_default()))
    })
}

fn pool(threads: usize) -> &'static rayon::ThreadPool {
    static ONE: OnceLock<rayon::ThreadPool> = OnceLock::new();
    static THREE: OnceLock<rayon::ThreadPool> = OnceLock::new();
    let pool =
        || rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
    if threads == 1 { ONE.get_or_init(pool) } else { THREE.get_or_init(pool) }
}

fn watch_scene(path: &Path, look: Watch<'_>) -> Result<Outcome, Fault> {
    let text = std::fs::read_to_string(path).map_err(|cause| fault("file", cause.to_string()))?;
    let name = path.display().to_string();
    let set: Vec<(String, String)> =
        look.set.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
    let (document, mistakes) = resolve(&Source { name, text }, &FileSystem, &set);
    if !mistakes.is_empty() {
        let first = |mistake: &Mistake| mistake.render().lines().next().unwrap_or_default().to_string();
        return Ok(Outcome::Mistaken(mistakes.iter().map(first).collect()));
    }
    let mut scene = document.scenes.into_iter().next().ok_or_else(|| fault("text", "no scene"))?;
    let plan = Plan::new(&scene);
    let mut simulation = match Simulation::new(&scene, &plan) {
        Ok(simulation) => simulation,
        Err(cause) => return refused(path, look, &scene, &cause),
    };
    let tapes = |scene: &Scene| -> Vec<_> {
        scene
            .records
            .iter()
            .flat_map(|record| record.columns.iter().map(|column| column.value.clone()))
            .collect()
    };
    let tapes = tapes(&scene);
    let observer = match Observer::new(&scene, simulation.bodies(), tapes.iter()) {
        Ok(observer) => observer,
        Err(cause) => return Ok(Outcome::Refused(cause.to_string())),
    };
    sound(simulation.bodies())?;
    if look.threads {
        same_bits(&scene, &plan)?;
    }
    let until = scene.run.until;
    if let Some(Blind::Courant(cfl)) = look.blind {
        scene.run.cfl = cfl;
    }
    let mut ledger = Ledger::new(&scene, &simulation, look.blind != Some(Blind::Work));
    let gap = initial_gap(&simulation)?;
    let mut momenta = Momenta::new(&scene, &simulation);
    let mut share = 0.0_f64;
    while simulation.steps() < look.steps {
        let done = match simulation.step_towards(until) {
            Ok(done) => done,
            Err(cause) => return stopped(path, look, &simulation, &cause),
        };
        let balance = ledger.enter(&simulation);
        if Ledger::is_complete(&scene) {
            if !(balance.energy <= balance.allowed) {
                let found = format!(
                    "{:.3e} J of {:.3e} J allowed after {} steps, {:.3e} s",
                    balance.energy,
                    balance.allowed,
                    simulation.steps(),
                    simulation.time()
                );
                return Err(fault("energy", found));
            }
            share = share.max(balance.energy / balance.allowed);
        }
        momenta.note(&scene, &simulation);
        if done || simulation.steps().is_multiple_of(50) || simulation.steps() == look.steps {
            if let Err(cause) = simulation.synchronise() {
                return stopped(path, look, &simulation, &cause);
            }
            let recorded = observer.evaluate(&simulation, tapes.iter());
            if let Some(at) = recorded.iter().position(|value| !value.is_finite()) {
                let column = &scene.records[0].columns[at].name;
                return Err(fault(
                    "record",
                    format!("`{column}` is {} at step {}", recorded[at], simulation.steps()),
                ));
            }
            let column = |name: &str| {
                let at = scene.records[0].columns.iter().position(|column| column.name == name);
                at.filter(|_| look.blind != Some(Blind::Impulse)).map_or(0.0, |at| recorded[at])
            };
            admissible(simulation.bodies())?;
            gradients(&simulation, gap, look.blind == Some(Blind::Gradient))?;
            momenta.judge(&scene, &simulation, &column)?;
        }
        if done {
            break;
        }
    }
    Ok(Outcome::Ran(simulation.steps(), share))
}

/// A refusal tells which body, material or word it is about, and one of the things it advises helps.
fn refused(path: &Path, look: Watch<'_>, scene: &Scene, cause: &SolveError) -> Result<Outcome, Fault> {
    let text = cause.to_string();
    let advised: Vec<(&'static str, String)> = match cause {
        SolveError::Discretisation { body, cause } => {
            let spacing =
                scene.bodies.iter().find(|known| known.name == *body).map_or(0.0, |body| body.spacing);
            let key = if body == "b" { ["b.spacing", "b.jitter"] } else { ["a.spacing", "a.jitter"] };
            let finer = |share: f64| (key[0], format!("{:e} m", share * spacing));
            match cause {
                DiscretisationError::UnevenSpacing { suggestion, .. } => {
                    vec![(key[0], format!("{suggestion:e} m"))]
                }
                DiscretisationError::ConstraintNotMet { quadratic, .. } => {
                    let first =
                        if *quadratic { ("run.completeness", "linear") } else { ("run.smoothing", "1.2") };
                    vec![(first.0, first.1.into()), finer(0.5), (key[1], "0".into())]
                }
                DiscretisationError::InvertedCell { .. } => {
                    vec![(key[1], "0".into()), finer(0.5), finer(0.25)]
                }
                DiscretisationError::SingularQuadratics { .. } => {
                    vec![("run.completeness", "linear".into()), finer(0.5)]
                }
                DiscretisationError::SingularMoments { .. } | DiscretisationError::NodesMeet { .. } => {
                    vec![finer(0.7), finer(0.5), ("run.smoothing", "1.5".into())]
                }
                _ => Vec::new(),
            }
        }
        SolveError::Energy { .. }
        | SolveError::DirectionNotUnit { .. }
        | SolveError::Unsupported { .. }
        | SolveError::Jump { .. }
        | SolveError::NotSymmetric { .. }
        | SolveError::NotBonded { .. }
        | SolveError::BondedApart { .. } => Vec::new(),
        _ => return Err(fault("set-up", text)),
    };
    let helps = |(key, value): &(&'static str, String)| {
        let tried = watch_scene(path, Watch { set: Some((key, value.as_str())), steps: 1, ..look });
        // something else may be in the way next
        !matches!(&tried, Ok(Outcome::Refused(again)) if class(again) == class(&text))
    };
    if look.set.is_none() && !advised.is_empty() && !advised.iter().any(helps) {
        return Err(fault("advice", format!("{text}; tried {advised:?}")));
    }
    Ok(Outcome::Refused(text))
}

/// The class of a message: its words without numbers.
pub fn class(text: &str) -> String {
    let number = |word: &str| word.contains(|c: char| c.is_ascii_digit());
    let words = text.split_whitespace().map(|word| if number(word) { "#" } else { word });
    words.take(24).collect::<Vec<_>>().join(" ")
}

/// A stop must name a cause; where nothing is near what the material bears there is none.
fn stopped(
    path: &Path,
    look: Watch<'_>,
    simulation: &Simulation,
    cause: &SolveError,
) -> Result<Outcome, Fault> {
    let text = cause.to_string();
    if look.calm {
        return Err(fault("stop", text));
    }
    let told = match cause {
        SolveError::NonPositiveJacobian { cause, .. } | SolveError::NotFinite { cause, .. } => Some(*cause),
        SolveError::TimeStepTooSmall { .. } => None,
        _ => return Err(fault("stop", text)),
    };
    match told {
        Some(Cause::Unknown) => Err(fault("cause", text)),
        // the advice is tried: smaller steps must go further
        Some(Cause::CourantNumber(_)) if look.set.is_none() => {
            let steps = 10 * (simulation.steps() + 10);
            let other = Watch { set: Some(("run.cfl", "0.2")), steps, ..look };
            match watch_scene(path, other) {
                Ok(Outcome::Ran(..)) => Ok(Outcome::Stopped(simulation.steps(), text)),
                other => Err(fault("advice", format!("{text}; with cfl = 0.2: {other:?}"))),
            }
        }
        _ => Ok(Outcome::Stopped(simulation.steps(), text)),
    }
}

/// Twelve steps on one thread and on three.
fn same_bits(scene: &Scene, plan: &Plan) -> Result<(), Fault> {
    let [one, three] = [1, 3].map(|threads| pool(threads).install(|| bits(scene, plan, 12)));
    if one == three { Ok(()) } else { Err(fault("threads", "one and three threads differ after 12 steps")) }
}

/// Positions and velocities after some steps, bit by bit; those before it if a step fails.
pub fn bits(scene: &Scene, plan: &Plan, steps: u64) -> Vec<u64> {
    let Ok(mut simulation) = Simulation::new(scene, plan) else { return Vec::new() };
    for _ in 0..steps {
        if !matches!(simulation.step_towards(scene.run.until), Ok(false)) {
            break;
        }
    }
    let state = simulation.bodies().iter().flat_map(|body| body.x.iter().chain(&body.v));
    state.flat_map(|quad| quad.0.map(f64::to_bits)).collect()
}
