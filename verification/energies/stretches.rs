//! Laws of the principal stretches where stretches are equal, or nearly.

use super::derivatives::density;
use super::known_values::stress;
use super::laws::{Random, Writer, compiled, worse};
use crate::energy::{Invariant, Kink, Law};
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

/// `ψ = Σ (μ/α) λ_i^α` with μ = 630, α = 1.3.
const MU: f64 = 630.0;
const ALPHA: f64 = 1.3;

fn ogden() -> Law {
    let mut w = Writer::default();
    let mut psi = w.number(0.0);
    for i in 0..3 {
        let stretch = w.invariant(Invariant::Stretch(i));
        let power = w.power(stretch, ALPHA);
        psi = w.add(psi, power);
    }
    let factor = w.number(MU / ALPHA);
    w.multiply(factor, psi);
    compiled(&w.finish(), &[])
}

/// `R diag(λ) Qᵀ`, with the stress `R diag(μ λ^(α−1)) Qᵀ` that belongs to it.
fn state(random: &mut Random, stretches: &Vec3, exponent: f64) -> (Mat3, Mat3) {
    let (r, q) = (random.rotation(), random.rotation());
    let slopes = stretches.map(|stretch| MU * libm::pow(stretch, exponent));
    (r * Mat3::from_diagonal(stretches) * q.transpose(), r * Mat3::from_diagonal(&slopes) * q.transpose())
}

/// Stretches apart by 1e-1 to 1e-16 and not at all, two alike and three.
fn nearly_equal() -> impl Iterator<Item = Vec3> {
    let gaps = (1..=16).map(|k| libm::pow(10.0, -f64::from(k))).chain([0.0]);
    gaps.flat_map(|gap| {
        [
            Vec3::new(1.2, 1.2 * (1.0 + gap), 0.8),
            Vec3::new(1.0, 1.0 + gap, 1.0 - gap),
            Vec3::new(3.0, 0.5, 0.5 + gap),
        ]
    })
}

/// Stress at nearly equal stretches.
pub(crate) const EQUAL_STRETCHES: Claim = Claim {
    topic: Topic::Energies,
    claim: "the stress of a law of stretches is exact at stretches apart by 1e-1 to 1e-16 and at F = I",
    source: "P = R diag(psi_i) Q^T for F = R diag(l_i) Q^T",
    because: "eigenvectors orthonormal to 1e-15, squares of stretches 36 apart: some 1e-14; the requirement is 1e-12",
    bound: 1e-13,
    measure: || stress_error(ALPHA - 1.0),
    control: || stress_error(ALPHA - 1.0 + 1e-9),
};

fn stress_error(exponent: f64) -> f64 {
    let law = ogden();
    let mut random = Random(1944);
    let at_rest = stress(&law, &Mat3::identity(), &[]) - MU * Mat3::identity();
    nearly_equal().fold(at_rest.norm() / MU, |worst, stretches| {
        (0..20).fold(worst, |worst, _| {
            let (f, p) = state(&mut random, &stretches, exponent);
            worse(worst, (stress(&law, &f, &[]) - p).norm() / p.norm())
        })
    })
}

/// Tangent at nearly equal stretches.
pub(crate) const EQUAL_STRETCHES_TANGENT: Claim = Claim {
    topic: Topic::Energies,
    claim: "the tangent of a law of stretches is the slope of its stress at nearly equal stretches",
    source: "central differences of the stress, which is exact there",
    because: "differences of step 1e-5 err by its square over 6 times a third derivative of some 10, and by 1e-14/1e-5",
    bound: 1e-8,
    measure: || tangent_error(1.0),
    control: || tangent_error(1.0 + 1e-6),
};

fn tangent_error(factor: f64) -> f64 {
    let law = ogden();
    let mut random = Random(1984);
    nearly_equal().fold(0.0, |worst, stretches| {
        let (f, _) = state(&mut random, &stretches, 0.0);
        let tangent = factor * law.tangent(&f, &[], Kink::Slack);
        let step = 1e-5;
        (0..9).fold(worst, |worst, place| {
            let mut e = Mat3::zeros();
            e.as_mut_slice()[place] = step;
            let slope = (stress(&law, &(f + e), &[]) - stress(&law, &(f - e), &[])) / (2.0 * step);
            let column = Mat3::from_column_slice(tangent.column(place).as_slice());
            worse(worst, (slope - column).norm() / tangent.norm())
        })
    })
}

/// A half, a third and an irrational power at and below zero.
pub(crate) const REAL_EXPONENTS: Claim = Claim {
    topic: Topic::Energies,
    claim: "real powers of the stretch have the slopes e l^(e-1), negative, half and irrational ones too",
    source: "power rule",
    because: "a power and an eigenvalue, each rounded to some 2e-16, times the exponent",
    bound: 2e-14,
    measure: || exponent_error(1.0),
    control: || exponent_error(1.0 + 1e-12),
};

fn exponent_error(factor: f64) -> f64 {
    let exponents =
        [-9.2, -2.0, -1.0, -0.5, 0.5, 1.0 / 3.0, 1.5, std::f64::consts::E, 3.0, 7.0, 24.5, 64.0, 65.0];
    exponents.iter().fold(0.0, |worst, &exponent| {
        let mut w = Writer::default();
        let stretch = w.invariant(Invariant::Stretch(0));
        w.power(stretch, exponent);
        let law = compiled(&w.finish(), &[]);
        let f = Mat3::from_diagonal(&Vec3::new(0.7, 1.3, 0.9));
        let slope = factor * exponent * libm::pow(1.3, exponent - 1.0);
        let worst = worse(worst, (stress(&law, &f, &[])[(1, 1)] / slope - 1.0).abs());
        worse(worst, (factor * density(&law, &f, &[]) / libm::pow(1.3, exponent) - 1.0).abs())
    })
}
