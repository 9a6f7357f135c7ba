//! The step the program takes is stable at the Courant number it defaults to, whatever dissipates.

use tissue::monitor::totals;
use tissue::plan::Plan;
use tissue::scene::{Memory, resolve};
use tissue::solver::Simulation;
use tissue::syntax::Source;

/// A cube full of short waves, followed for some hundred steps.
fn grows(choices: &str) -> f64 {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material rubber {{ energy = neo_hooke(mu = 6.5 MPa) + vol_quadratic(K = 14 MPa)  density = 1100 kg/m^3 }}
scene noise {{
  let m = 1 m
  let w = 1e-4 m/s
  body cube {{ shape = box(m, m, m)  spacing = 0.25 m  material = rubber }}
  start cube {{ velocity = [w*sin(917*X/m + 389*Y/m), w*sin(613*X/m + 411*Z/m), w*sin(589*Y/m + 717*Z/m)] }}
  run {{ until = 1 s  wave_speed_every = 0  {choices} }}
}}
"
    );
    let (document, mistakes) = resolve(&Source { name: "noise".into(), text }, &Memory::default(), &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    let scene = &document.scenes[0];
    let plan = Plan::new(scene);
    let mut simulation = Simulation::new(scene, &plan).expect("the scene can be set up");
    let energy = |simulation: &Simulation| totals(simulation.bodies(), &scene.symmetry).kinetic_energy;
    let start = energy(&simulation);
    for _ in 0..300 {
        if simulation.step_towards(1.0).is_err() {
            return f64::INFINITY;
        }
    }
    energy(&simulation) / start
}

#[test]
fn a_dissipation_of_volumes_beside_little_or_none_of_momentum_is_stable() {
    for volume in ["on", "restoring"] {
        for weight in ["0.5", "3", "30"] {
            for momentum in [
                "momentum_dissipation = off",
                "pressure_wave_weight = 0.1",
                "pressure_wave_weight = 0  shear_wave_weight = 0",
            ] {
                let choices =
                    format!("volume_dissipation = {volume}  volume_wave_weight = {weight}  {momentum}");
                let growth = grows(&choices);
                assert!(growth <= 1.0, "{choices}: kinetic energy grows by {growth:e}");
            }
        }
    }
}
