//! Momentum of bodies that are bonded and otherwise free.

use super::super::scene::{scene, simulation, step};
use crate::monitor::totals;
use crate::tensor::Vec3;
use crate::verify::{Claim, Topic};

/// Steps each measure takes.
const STEPS: u64 = 200;

/// Forces across the interface act on one point of common mass.
pub(super) const MOMENTUM: Claim = Claim {
    topic: Topic::Conservation,
    claim: "bonded bodies of different density exchange momentum and keep their sum",
    source: "conservation of momentum over both bodies: forces of either on the other cancel on the shared nodes",
    because: "two kicks a step of either body and the sharing between them, 200 steps, errors adding up without \
              cancelling: 600 * 1.1e-16",
    bound: 6.6e-14,
    measure: || drift(2),
    // the first body alone, which the other pushes
    control: || drift(1),
};

/// What is shared is shared to the last bit.
pub(super) const ONE_PLACE: Claim = Claim {
    topic: Topic::Conservation,
    claim: "shared nodes of bonded bodies have one position and one velocity to the last bit",
    source: "equal states advanced by equal accelerations",
    because: "every operation on the members of a shared node has the same operands",
    bound: 0.0,
    measure: || apart("bond inner.zmax { to = outer.zmin }"),
    control: || apart(""),
};

fn thrown(bond: &str) -> String {
    format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material heavy {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = 1800 kg/m^3 }}
material light {{ energy = neo_hooke(mu = 4 kPa) + vol_quadratic(K = 40 kPa)  density = 900 kg/m^3 }}
scene thrown {{
  body inner {{ shape = box(4 mm, 3 mm, 2 mm)  spacing = 1 mm  material = heavy }}
  body outer {{ shape = box(4 mm, 3 mm, 2 mm, centre = [2 mm, 1.5 mm, 3 mm])  spacing = 1 mm  material = light }}
  {bond}
  start inner {{ velocity = [0.3 m/s - 90 s^-1 * Y, 90 s^-1 * X, 40 s^-1 * Z] }}
  start outer {{ velocity = [0.3 m/s - 90 s^-1 * Y, 90 s^-1 * X - 30 s^-1 * (Z - 2 mm), 80 mm/s - 20 s^-1 * (Z - 2 mm)] }}
  run {{ until = 1 s }}
}}
"
    )
}

/// Change of the momentum of the first `bodies` bodies over `Σ V |p|` of all.
fn drift(bodies: usize) -> f64 {
    let scene = scene(&thrown("bond inner.zmax { to = outer.zmin }"));
    let mut simulation = simulation(&scene);
    let scale = totals(simulation.bodies(), &scene.symmetry).momentum_scale;
    let before = totals(&simulation.bodies()[..bodies], &scene.symmetry).momentum;
    step(&mut simulation, &scene, STEPS);
    (totals(&simulation.bodies()[..bodies], &scene.symmetry).momentum - before).norm() / scale
}

/// Largest distance, m, and difference in velocity, m/s, of nodes at one reference position.
fn apart(bond: &str) -> f64 {
    let scene = scene(&thrown(bond));
    let mut simulation = simulation(&scene);
    step(&mut simulation, &scene, STEPS);
    let [inner, outer] = simulation.bodies() else { return f64::NAN };
    let mut worst = 0.0_f64;
    for (a, at) in inner.particles.position.iter().enumerate().filter(|(_, x)| x.z == 2e-3) {
        let near = |x: &Vec3| (x - at).norm() < 1e-9;
        let Some(b) = outer.particles.position.iter().position(near) else { return f64::NAN };
        worst = worst.max((inner.x[a].vector() - outer.x[b].vector()).norm());
        worst = worst.max((inner.v[a].vector() - outer.v[b].vector()).norm());
    }
    worst
}
