//! The evolved deformation gradient against the positions.

use crate::monitor::{Involutions, involutions};
use crate::output::Figure;
use crate::solver::{BodyState, Quad, Simulation};
use crate::tensor::{Mat3, Vec3};
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{bounded, history};
use crate::verify::claims::scene::{scene, simulation, step, thrown_cube};
use crate::verify::{Claim, Topic};

/// Steps each measure takes.
const STEPS: u64 = 200;

/// F and x are advanced with the same velocities and F's rate is the discrete gradient of them.
pub(super) const VERLET: Claim = Claim {
    topic: Topic::Consistency,
    claim: "F stays the discrete gradient of the positions, by velocity Verlet",
    source: "NB25 (7), (8), (28)",
    because: "200 steps, each rounding 30 products of a gradient weight (below 1/dx) and a position (below 10 dx) \
              to 1.1e-16, errors adding up without cancelling: 200 * 30 * 10 * 1.1e-16 = 7e-12 at worst, and \
              1e-12 is what the method asks for",
    bound: 1e-12,
    measure: || gap(""),
    control: || lagging_gap(""),
};

/// The same for the paper's integrator.
pub(super) const HEUN: Claim = Claim {
    topic: Topic::Consistency,
    claim: "F stays the discrete gradient of the positions, by two-stage Runge-Kutta",
    source: "NB25 (7), (8), (28), (39)-(41)",
    because: VERLET.because,
    bound: 1e-12,
    measure: || gap("integrator = tvd_rk2"),
    control: || lagging_gap("integrator = tvd_rk2"),
};

/// A body thrown without deformation.
pub(super) const TRANSLATION: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a rigid translation leaves the body free of stress",
    source: "NB25 (28): differences of equal velocities",
    because: "every velocity difference is zero but for what the springs make of positions rounded to 1.1e-16 of up to 9 \
              spacings: two of those to a difference and twice that in its gradient, 4 * 9 * 1.1e-16, beside the \
              stress of the identity, 20 operations rounded to 1.1e-16 of a bulk modulus, relative to it",
    bound: 6.2e-15,
    measure: || translated_stress(""),
    control: || translated_stress("+ 1 s^-1 * X"),
};

/// Positions turned rigidly: gradient a rotation, stress zero, whatever the jitter.
pub(super) const ROTATION: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a rigid rotation leaves the body free of stress",
    source: "NB25 (26) reproduces linear fields, energies are objective",
    because: "the gradient of turned positions errs by 30 products rounded to 1.1e-16 of 10, the stress by \
              that times a modulus: 30 * 10 * 1.1e-16 relative to the bulk modulus, times 3 for trace and shear",
    bound: 1e-13,
    measure: || rotated_stress(1.0),
    control: || rotated_stress(1.001),
};

/// Involutions over time.
pub(super) const FIGURES: [Illustration; 2] = [
    Illustration { claim: VERLET.claim, figure: || histories("") },
    Illustration { claim: HEUN.claim, figure: || histories("integrator = tvd_rk2") },
];

fn histories(run: &str) -> Figure {
    let scene = scene(&thrown_cube(run, ""));
    let mut simulation = simulation(&scene);
    let mut rows: Vec<(f64, Involutions)> = Vec::new();
    for _ in 0..STEPS / 10 {
        step(&mut simulation, &scene, 10);
        rows.push((simulation.time(), involutions(simulation.bodies())));
    }
    let line =
        |of: fn(&Involutions) -> f64| rows.iter().map(|(t, found)| (*t, of(found))).collect::<Vec<_>>();
    let lines = [
        ("|F - Grad x|", line(|found| found.gradient)),
        ("dx |CURL F|", line(|found| found.curl_f)),
        ("dx |DIV H|", line(|found| found.div_h)),
    ];
    let title = "A thrown cube: involutions, largest over particles";
    bounded(history(title, "violation", &lines, 1e-18), VERLET.bound)
}

fn gap(run: &str) -> f64 {
    let scene = scene(&thrown_cube(run, ""));
    let mut simulation = simulation(&scene);
    step(&mut simulation, &scene, STEPS);
    involutions(simulation.bodies()).gradient
}

/// The wrong variant: positions one step behind.
fn lagging_gap(run: &str) -> f64 {
    let scene = scene(&thrown_cube(run, ""));
    let mut simulation = simulation(&scene);
    step(&mut simulation, &scene, STEPS - 1);
    let behind = simulation.bodies()[0].x.clone();
    step(&mut simulation, &scene, 1);
    let body = &simulation.bodies()[0];
    (0..body.len()).map(|a| (body.f(a) - gradient(body, &behind, a)).norm()).fold(0.0, f64::max)
}

/// `Σ_b (x_b − x_a) ⊗ G_b(X_a)` of given positions.
fn gradient(body: &BodyState, positions: &[Quad], a: usize) -> Mat3 {
    let mut sum = Mat3::zeros();
    for entry in body.links.row(a) {
        let b = body.links.neighbour[entry] as usize;
        let difference = positions[b].vector() - positions[a].vector();
        sum += difference * Vec3::from(body.links.forward[entry]).transpose();
    }
    sum * body.inverse_volume[a]
}

/// Bulk modulus of the material below, Pa.
const BULK: f64 = 200e3;

fn translated(more: &str) -> Simulation {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 200 kPa)  density = 1000 kg/m^3 }}
scene translation {{
  body cube {{ shape = box(5 mm, 5 mm, 5 mm)  spacing = 1 mm  jitter = 0.2  material = gel }}
  start cube {{ velocity = [0.7 m/s {more}, -0.3 m/s, 0.1 m/s] }}
  run {{ until = 1 s }}
}}
"
    );
    let scene = scene(&text);
    let mut simulation = simulation(&scene);
    step(&mut simulation, &scene, 100);
    simulation
}

fn translated_stress(more: &str) -> f64 {
    let simulation = translated(more);
    let body = &simulation.bodies()[0];
    (0..body.len()).map(|a| body.stress(a).norm()).fold(0.0, f64::max) / BULK
}

/// Largest stress, over the bulk modulus, of the discrete gradient of turned and scaled positions.
fn rotated_stress(scale: f64) -> f64 {
    let simulation = translated("");
    let body = &simulation.bodies()[0];
    let axis = nalgebra::Unit::new_normalize(Vec3::new(1.0, -2.0, 0.5));
    let turn = nalgebra::Rotation3::from_axis_angle(&axis, 2.0).into_inner() * scale;
    let turned: Vec<Quad> = body.particles.position.iter().map(|x| Quad::new(&(turn * x))).collect();
    let stress = |a: usize| {
        let f = gradient(body, &turned, a);
        let h = crate::tensor::cofactor(&f);
        let j = crate::tensor::volume_map(&f, &h);
        let sigma = body.law.conjugate_stresses(&f, &h, j, &[]);
        (sigma.sigma_f + crate::tensor::cross(&sigma.sigma_h, &f) + sigma.sigma_j * h).norm()
    };
    (0..body.len()).map(stress).fold(0.0, f64::max) / BULK
}
