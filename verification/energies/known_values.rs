//! The artery's law at single states, against numbers found elsewhere.

use super::laws::{ARTERY, Artery, MATRIX, circumferential};
use crate::energy::{Directions, Law, Maps, Scratch};
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

/// First Piola–Kirchhoff stress of one state.
pub(crate) fn stress(law: &Law, f: &Mat3, directions: &[Vec3]) -> Mat3 {
    let mut out = [Mat3::zeros()];
    let maps = Maps { f: &[*f], h: None, j: None };
    law.stress(maps, Directions::Uniform(directions), &mut out, &mut Scratch::default());
    out[0]
}

/// Speed at rest without fibres.
pub(crate) const MATRIX_WAVE_SPEED: Claim = Claim {
    topic: Topic::Energies,
    claim: "the artery's matrix carries pressure waves at sqrt((2/D + 4/3 2C)/rho) at rest",
    source: "linear elasticity; METHOD, trial 9: 142 m/s",
    because: "a second derivative of about 100 operations, each rounded to 1.1e-16",
    bound: 1e-13,
    measure: || matrix_speed_error(4.0 / 3.0),
    control: || matrix_speed_error(1.0),
};

fn matrix_speed_error(shear_factor: f64) -> f64 {
    let density = 1000.0;
    let expected = ((2.0 / MATRIX.d + shear_factor * 2.0 * MATRIX.c) / density).sqrt();
    let speeds = MATRIX.law().wave_speeds(&Mat3::identity(), &circumferential(), density);
    speeds.map_or(f64::INFINITY, |speeds| (speeds.pressure / expected - 1.0).abs())
}

/// A ball blown up feels no fibre: their invariants are blind to volume.
pub(crate) const HYDROSTATIC: Claim = Claim {
    topic: Topic::Energies,
    claim: "at F = 1.02 I the stress of the artery is 1.18885665 MPa in all directions",
    source: "BENCHMARKS, section C",
    because: "half of the last digit given",
    bound: 0.5e-8 / 1.18885665,
    measure: || hydrostatic_error(ARTERY.d),
    control: || hydrostatic_error(ARTERY.d * (1.0 + 1e-6)),
};

fn hydrostatic_error(d: f64) -> f64 {
    let law = Artery { d, ..ARTERY }.law();
    let f = 1.02 * Mat3::identity();
    let p = stress(&law, &f, &circumferential());
    let sigma = p * f.transpose() / f.determinant();
    (sigma - 1.188_856_65e6 * Mat3::identity()).abs().max() / 1.188_856_65e6
}
