//! The evolved maps and who reads them.

use crate::energy::{Directions, Maps, Scratch};
use crate::monitor::involutions;
use crate::tensor::{Mat3, cofactor, cross, volume_map};
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::history;
use crate::verify::claims::scene::{scene, simulation, spinning_cube, step, stepped};
use crate::verify::{Claim, Topic};

/// An energy of I2 sees the H that is evolved, not the cofactor of F.
pub(super) const EVOLVED_H: Claim = Claim {
    topic: Topic::Consistency,
    claim: "in formulation pFHJ an energy of I2 reads the evolved H, and P = S_F + S_H x F + S_J H",
    source: "Mooney-Rivlin by hand: S_F = 2 C10 F, S_H = 2 C01 H, S_J = K (J - 1) - 2 (C10 + 2 C01)/J",
    because: "six products and sums of the modulus' size a component, rounded to 1.1e-16, and three for those of \
              the program: relative to the bulk modulus 20 * 1.1e-16",
    bound: 2.2e-15,
    measure: || stress_gap(|h, _| *h),
    control: || stress_gap(|_, f| cofactor(f)),
};

/// The restoring term holds J within what D(J) adds in one relaxation time.
pub(super) const RESTORED_J: Claim = Claim {
    topic: Topic::Consistency,
    claim: "with the restoring term the gap between J and det F stays below max |D(J)|/r",
    source: "dJ/dt = H : Grad v + D(J) + r (det F - J), of which dg/dt = D(J) - r g for the gap g",
    because: "g is at most max |D(J)|/r by the comparison of g with its bound; the measure is g r/max |D(J)| over three \
              turns of a spinning cube, of which the time discretisation of J is a thousandth",
    bound: 1.001,
    measure: || drift(1.0),
    // a bound formed with twenty times the rate: the gap is as large as the relaxation lets it become
    control: || drift(20.0),
};

/// The gap over time.
pub(super) const FIGURES: [Illustration; 1] = [Illustration {
    claim: RESTORED_J.claim,
    figure: || {
        let gap = |dissipation: &str| {
            let run = format!("formulation = pFJ  volume_dissipation = {dissipation}");
            let scene = scene(&cube(&run));
            let mut simulation = simulation(&scene);
            let mut points = Vec::new();
            while !stepped(&mut simulation, scene.run.until) {
                points.push((simulation.time(), involutions(simulation.bodies()).volume_map));
            }
            points
        };
        let lines = [("restoring", gap("restoring")), ("as printed", gap("on"))];
        history("A spinning cube with D(J): largest |J - det F|", "gap", &lines, 1e-4)
    },
}];

/// The spinning cube for three turns.
fn cube(run: &str) -> String {
    spinning_cube(run, 3.0)
}

/// Largest gap, over the largest D(J) times the relaxation time of so many times the rate in force.
fn drift(assumed: f64) -> f64 {
    let scene = scene(&cube("formulation = pFJ  volume_dissipation = restoring"));
    let mut simulation = simulation(&scene);
    let rate = simulation.bodies()[0].rest.pressure / simulation.bodies()[0].particles.spacing;
    let (mut gap, mut dissipated) = (0.0_f64, 0.0_f64);
    while !stepped(&mut simulation, scene.run.until) {
        for block in &simulation.bodies()[0].blocks {
            for (i, total) in block.volume_dissipation.iter().enumerate() {
                let behind = volume_map(&block.f[i], &cofactor(&block.f[i])) - block.j[i];
                gap = gap.max(behind.abs());
                dissipated = dissipated.max((total - rate * behind).abs());
            }
        }
    }
    gap * assumed * rate / dissipated
}

/// Moduli below, Pa.
const C10: f64 = 30e3;
const C01: f64 = 40e3;
const BULK: f64 = 1e6;

/// Largest gap between the stress of a run and the formula by hand, over the bulk modulus; `area` gives the
/// area map the formula reads.
fn stress_gap(area: fn(&Mat3, &Mat3) -> Mat3) -> f64 {
    let text = "tissue 1
energy mooney {
  param C10 : pressure > 0
  param C01 : pressure > 0
  param K   : pressure > 0
  psi = C10*(I1 - 3) + C01*(I2 - 3) + K/2*(J - 1)^2 - 2*(C10 + 2*C01)*ln(J)
}
material rubber { energy = mooney(C10 = 30 kPa, C01 = 40 kPa, K = 1 MPa)  density = 1000 kg/m^3 }
scene thrown {
  body cube { shape = box(3 mm, 3 mm, 3 mm)  spacing = 1 mm  jitter = 0.2  material = rubber }
  start cube { velocity = [1500 s^-1 * X - 2000 s^-1 * Y, 2000 s^-1 * X - 900 s^-1 * Z, 800 s^-1 * Y] }
  run { until = 1 s  formulation = pFHJ  integrator = tvd_rk2 }
}
";
    let scene = scene(text);
    let mut simulation = simulation(&scene);
    step(&mut simulation, &scene, 40);
    simulation.synchronise().expect("the cube swings");
    let body = &simulation.bodies()[0];
    let gap = |a: usize| {
        let (f, evolved) = (body.f(a), body.h(a).expect("H is evolved"));
        let (h, j) = (area(evolved, f), body.j(a).expect("J is evolved"));
        let sigma_j = BULK * (j - 1.0) - 2.0 * (C10 + 2.0 * C01) / j;
        let printed = 2.0 * C10 * f + cross(&(2.0 * C01 * h), f) + sigma_j * h;
        (body.stress(a) - printed).norm() / BULK
    };
    (0..body.len()).map(gap).fold(0.0, f64::max)
}

/// The same of the law alone, for maps that belong to no motion.
pub(super) const FREE_MAPS: Claim = Claim {
    topic: Topic::Consistency,
    claim: "the stress of maps that belong to no motion is that of the energy in F, H and J",
    source: EVOLVED_H.source,
    because: EVOLVED_H.because,
    bound: 2.2e-15,
    measure: || free_maps(1.0),
    control: || free_maps(1.001),
};

fn free_maps(scale: f64) -> f64 {
    let scene = scene(
        "tissue 1
energy mooney {
  param C10 : pressure > 0
  param C01 : pressure > 0
  param K   : pressure > 0
  psi = C10*(I1 - 3) + C01*(I2 - 3) + K/2*(J - 1)^2 - 2*(C10 + 2*C01)*ln(J)
}
material rubber { energy = mooney(C10 = 30 kPa, C01 = 40 kPa, K = 1 MPa)  density = 1000 kg/m^3 }
scene still {
  body cube { shape = box(3 mm, 3 mm, 3 mm)  spacing = 1 mm  material = rubber }
  run { until = 1 s }
}
",
    );
    let simulation = simulation(&scene);
    let law = &simulation.bodies()[0].law;
    let f = Mat3::new(1.1, 0.2, -0.1, 0.05, 0.9, 0.3, -0.2, 0.1, 1.05);
    let h = Mat3::new(0.8, -0.1, 0.4, 0.3, 1.2, -0.2, 0.1, 0.25, 0.95);
    let j = 1.3;
    let maps = Maps { f: &[f], h: Some(&[h]), j: Some(&[j]) };
    let mut stress = [Mat3::zeros()];
    law.stress(maps, Directions::Uniform(&[]), &mut stress, &mut Scratch::default());
    let sigma_j = BULK * (j - 1.0) - 2.0 * (C10 + 2.0 * C01) / j;
    let printed = 2.0 * C10 * f + cross(&(2.0 * C01 * scale * h), &f) + sigma_j * h;
    (stress[0] - printed).norm() / BULK
}
