//! What must hold of every law: its derivative, its symmetries, its rest.

use super::Subject;
use crate::energy::tangent::Kink;
use crate::tensor::{Mat3, Vec3, contract};

/// A rotation about a skew axis by about 86 degrees.
fn rotation() -> Mat3 {
    let axis = nalgebra::Unit::new_normalize(Vec3::new(1.0, -2.0, 0.5));
    let (sin, cos) = (libm::sin(1.5), libm::cos(1.5));
    let cross = Mat3::new(0.0, -axis.z, axis.y, axis.z, 0.0, -axis.x, -axis.y, axis.x, 0.0);
    Mat3::identity() * cos + cross * sin + axis.as_ref() * axis.transpose() * (1.0 - cos)
}

/// Order at which `|P − P_differences|` vanishes with the step at a state; 2 for a true derivative.
///
/// Central differences of ψ with the steps `h` and `h/2`. Not a number if both errors are zero to
/// round-off, as for an energy of second degree.
pub fn derivative_order(subject: &Subject, f: &Mat3, h: f64) -> f64 {
    libm::log2(derivative_error(subject, f, h) / derivative_error(subject, f, 0.5 * h))
}

/// `|P − P_differences|/|P|` with central differences of ψ over `2h` at a state.
pub fn derivative_error(subject: &Subject, f: &Mat3, h: f64) -> f64 {
    let p = subject.stress(f);
    let difference = Mat3::from_fn(|i, j| {
        let mut e = Mat3::zeros();
        e[(i, j)] = h;
        (subject.density(&(f + e)) - subject.density(&(f - e))) / (2.0 * h)
    });
    (p - difference).norm() / p.norm()
}

/// Stress of the reference configuration, Pa.
pub fn stress_at_rest(subject: &Subject) -> Mat3 {
    subject.stress(&Mat3::identity())
}

/// `|P(QF) − Q P(F)|/|P(F)|` for a rotation about a skew axis.
pub fn objectivity_error(subject: &Subject, f: &Mat3) -> f64 {
    let (q, p) = (rotation(), subject.stress(f));
    (subject.stress(&(q * f)) - q * p).norm() / p.norm()
}

/// `|P(F Qᵀ; Q a) − P(F; a) Qᵀ|/|P(F; a)|`: turning the body and its directions turns the answer.
///
/// For a law without directions this is isotropy.
pub fn material_symmetry_error(subject: &Subject, f: &Mat3) -> f64 {
    let (q, p) = (rotation(), subject.stress(f));
    let turned: Vec<Vec3> = subject.directions.iter().map(|direction| q * direction).collect();
    let subject = Subject { law: subject.law, directions: &turned };
    (subject.stress(&(f * q.transpose())) - p * q.transpose()).norm() / p.norm()
}

/// `|A − Aᵀ|/|A|` of the tangent at a state.
pub fn asymmetry_of_tangent(subject: &Subject, f: &Mat3) -> f64 {
    let a = subject.law.tangent(f, subject.directions, Kink::Slack);
    (a - a.transpose()).norm() / a.norm()
}

/// Share of the stress under pure dilation that is not hydrostatic, 0 to 1.
///
/// Zero although the law reads directions means fibres that do not feel a change of volume: a body
/// blown up stretches them and they do not pull.
pub fn deviator_under_dilation(subject: &Subject, stretch: f64) -> f64 {
    let p = subject.stress(&(stretch * Mat3::identity()));
    let deviator = p - p.trace() / 3.0 * Mat3::identity();
    (contract(&deviator, &deviator) / contract(&p, &p)).sqrt()
}
