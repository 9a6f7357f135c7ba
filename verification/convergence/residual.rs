//! An exact motion first has to pass its own test.

use crate::monitor::largest_residual;
use crate::tensor::{Vec3, cofactor, volume_map};
use crate::verify::claims::cube::{Case, Cube};
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
    measure: || residual(Case::NeoHooke, ""),
    control: || residual(Case::NeoHooke, "body_force = off"),
};

/// The same where fibres are pulled; a fibre that is not makes the measure no number.
pub(super) const FIBRES: Claim = Claim {
    topic: Topic::Convergence,
    claim: "the body force of an exact motion balances momentum by finite differences, with fibres pulled",
    source: "NB25 (5) by differences of positions and stresses",
    because: BECAUSE,
    bound: 1e-10,
    measure: || pulled() * residual(Case::Fibres, ""),
    control: || residual(Case::Fibres, "body_force = off"),
};

/// The standing wave of linear elasticity needs next to no body force.
pub(super) const STANDING_WAVE: Claim = Claim {
    topic: Topic::Convergence,
    claim: "the swinging cube solves the equations by itself up to the square of its amplitude",
    source: "linear elastodynamics: an isochoric shear wave of speed sqrt(mu/rho)",
    because: "next term of the expansion in the strain, 2 * 5e-4 * pi/2 = 1.6e-3, times the ratio of bulk to shear \
              modulus of its factor, 3, over a sum of three terms of equal size",
    bound: 5e-3,
    measure: || residual(Case::Swinging(0.3), "body_force = off"),
    // a material whose waves are faster than the motion
    control: || residual(Case::NeoHooke, "body_force = off"),
};

fn cube(case: Case, motion: &'static str) -> Cube {
    Cube { motion, ..Cube::new(case, 3) }
}

fn residual(case: Case, motion: &'static str) -> f64 {
    let cube = cube(case, motion);
    largest_residual(cube.start().bodies(), cube.until())
}

/// 1 where the strain of the fibres is positive at the place and time of the residual, else not a number.
fn pulled() -> f64 {
    let cube = cube(Case::Fibres, "");
    let simulation = cube.start();
    let exact = simulation.bodies()[0].exact.as_ref().expect("the scene has a motion");
    let f = exact.states(&[Vec3::new(0.43, 0.57, 0.38)], 0.71 * cube.until())[0].gradient;
    let r2 = volume_map(&f, &cofactor(&f)).powf(-2.0 / 3.0);
    let along = f * Vec3::new(1.0, 1.0, 0.0).normalize();
    let strain = 0.1 * (r2 * f.norm_squared() - 3.0) + 0.7 * (r2 * along.norm_squared() - 1.0);
    if strain > 0.0 { 1.0 } else { f64::NAN }
}
