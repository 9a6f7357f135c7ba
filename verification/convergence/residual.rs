//! An exact motion first has to pass its own test.

use super::cube::{self, Cube};
use crate::monitor::largest_residual;
use crate::tensor::{Vec3, cofactor, volume_map};
use crate::verify::{Claim, Topic};

const BECAUSE: &str = "differences extrapolated to a step of zero keep 13 digits of F and of the acceleration; the \
                       stress loses the ratio of modulus to stress, about 10, its difference over a hundredth of the \
                       cube another 100: 1e-13 * 1e3, as the specification asks";

/// The body force of a motion of an isotropic solid.
pub(super) const NEO_HOOKE: Claim = Claim {
    topic: Topic::Convergence,
    claim: "the body force of an exact motion balances momentum by finite differences, neo-Hookean",
    source: "NB25 (5) by differences of positions and stresses",
    because: BECAUSE,
    bound: 1e-10,
    measure: || residual(cube::NEO_HOOKE, ""),
    control: || residual(cube::NEO_HOOKE, "body_force = off"),
};

/// The same where fibres are pulled; a fibre that is not makes the measure no number.
pub(super) const FIBRES: Claim = Claim {
    topic: Topic::Convergence,
    claim: "the body force of an exact motion balances momentum by finite differences, with fibres pulled",
    source: "NB25 (5) by differences of positions and stresses",
    because: BECAUSE,
    bound: 1e-10,
    measure: || pulled() * residual(cube::FIBRES, ""),
    control: || residual(cube::FIBRES, "body_force = off"),
};

fn cube(energy: &'static str, boundary: &'static str) -> Cube {
    Cube { energy, cells: 3, jitter: 0.0, boundary, run: "" }
}

fn residual(energy: &'static str, boundary: &'static str) -> f64 {
    largest_residual(cube(energy, boundary).start().bodies(), 0.037)
}

/// 1 where the strain of the fibres is positive at the place and time of the residual, else not a number.
fn pulled() -> f64 {
    let simulation = cube(cube::FIBRES, "").start();
    let exact = simulation.bodies()[0].exact.as_ref().expect("the scene has a motion");
    let f = exact.states(&[Vec3::new(0.43, 0.57, 0.38)], 0.71 * 0.037)[0].gradient;
    let r2 = volume_map(&f, &cofactor(&f)).powf(-2.0 / 3.0);
    let along = f * Vec3::new(1.0, 1.0, 0.0).normalize();
    let strain = 0.1 * (r2 * f.norm_squared() - 3.0) + 0.7 * (r2 * along.norm_squared() - 1.0);
    if strain > 0.0 { 1.0 } else { f64::NAN }
}
