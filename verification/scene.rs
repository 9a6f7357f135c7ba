//! Scenes written as text for claims about the solver.
//!
//! Owns the way from text to a running simulation; a scene that does not resolve or run is a fault of the
//! claim, so it panics with the mistakes, and the claim fails with them as its cause.

use crate::plan::Plan;
use crate::scene::{Memory, Scene, resolve};
use crate::solver::Simulation;
use crate::syntax::Source;

/// The only scene of a text.
pub(super) fn scene(text: &str) -> Scene {
    let source = Source { name: "claim.tissue".into(), text: text.into() };
    let (document, mistakes) = resolve(&source, &Memory::default(), &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    document.scenes.into_iter().next().expect("the text has a scene")
}

/// A simulation of a scene at time zero.
pub(super) fn simulation(scene: &Scene) -> Simulation {
    Simulation::new(scene, &Plan::new(scene))
        .unwrap_or_else(|cause| panic!("the scene of a claim cannot be set up: {cause}"))
}

/// Takes one step towards a time, s; whether that is reached.
pub(super) fn stepped(simulation: &mut Simulation, until: f64) -> bool {
    simulation.step_towards(until).unwrap_or_else(|cause| panic!("the scene of a claim stopped: {cause}"))
}

/// Takes all steps to a time, s.
pub(super) fn advance(simulation: &mut Simulation, until: f64) {
    while !stepped(simulation, until) {}
}

/// The only scene of a text at its end.
pub(super) fn ended(text: &str) -> Simulation {
    let scene = scene(text);
    let mut simulation = simulation(&scene);
    advance(&mut simulation, scene.run.until);
    simulation
}

/// Brings velocities to the time of the positions.
pub(super) fn synchronised(simulation: &mut Simulation) {
    simulation.synchronise().unwrap_or_else(|cause| panic!("the scene of a claim stopped: {cause}"));
}

/// Takes `steps` steps towards the end of a scene.
pub(super) fn step(simulation: &mut Simulation, scene: &Scene, steps: u64) {
    let end = simulation.steps() + steps;
    while simulation.steps() < end {
        let reached = stepped(simulation, scene.run.until);
        assert!(!reached || simulation.steps() >= end, "the scene of a claim is long enough");
    }
}

/// A cube of 1 m with 125 particles that spins with 105 rad/s about its diagonal, for some turns.
pub(super) fn spinning_cube(run: &str, turns: f64) -> String {
    let until = turns * 0.059_839_860_1;
    format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material rubber {{ energy = neo_hooke(mu = 6.538 MPa) + vol_quadratic(K = 14.167 MPa)  density = 1100 kg/m^3 }}
scene spin {{
  body cube {{ shape = box(1 m, 1 m, 1 m, centre = [0 m, 0 m, 0 m])  spacing = 0.25 m  material = rubber }}
  start cube {{ velocity = [60.62 s^-1 * (Z - Y), 60.62 s^-1 * (X - Z), 60.62 s^-1 * (Y - X)] }}
  run {{ until = {until} s  {run} }}
}}
"
    )
}

/// The same as [`thrown_cube`] with 64 particles, for many steps.
pub(super) fn small_cube(run: &str, more: &str) -> String {
    thrown_cube(run, more).replace("box(6 mm, 6 mm, 6 mm)", "box(3 mm, 3 mm, 3 mm)")
}

/// A free fibrous cube, its nodes displaced by a fifth of the spacing, thrown, spun and stretched.
///
/// `{run}` stands for further choices of its run block, `{more}` for further blocks.
pub(super) fn thrown_cube(run: &str, more: &str) -> String {
    format!(
        "tissue 1
import std.energies {{ goh, vol_quadratic }}
material gel {{
  energy  = goh(C = 10 kPa, k1 = 50 kPa, k2 = 2, kappa = 0.1) + vol_quadratic(K = 200 kPa)
  density = 1000 kg/m^3
  fibre a = unit([1, 2, 0.5])
}}
scene thrown {{
  body cube {{ shape = box(6 mm, 6 mm, 6 mm)  spacing = 1 mm  jitter = 0.2  material = gel }}
  start cube {{
    velocity = [1 m/s + 100 s^-1 * X - 200 s^-1 * Y, 200 s^-1 * X - 60 s^-1 * Z, 0.3 m/s + 80 s^-1 * Y - 50 s^-1 * Z]
  }}
  {more}
  run {{ until = 1 s  {run} }}
}}
"
    )
}
