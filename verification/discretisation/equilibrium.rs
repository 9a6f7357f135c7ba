//! Uniform stress is in equilibrium with its own tractions.

use super::worst;
use crate::discretisation::{Consistency, Particles, Stencils};
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

/// `Σ_b V_b G_a(X_b) = A_a N_a`.
pub(crate) const BOUNDARY_AREAS: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "discrete boundary areas are the grid's: sum of V_b G_a(X_b) = A_a N_a, jitter 0 and 0.3, every kernel",
    source: "integration constraint of Chen, Hillman & Rueter 2013",
    because: "conjugate gradients stop at a leftover of 1e-12 dx^2, summed over particles",
    bound: 1e-12,
    measure: || worst(&[Consistency::Integration], |particles, stencils, _, _| areas(particles, stencils)),
    control: || worst(&[Consistency::Kernel], |particles, stencils, _, _| areas(particles, stencils)),
};

/// `V_a (E_a − T_a) = 0` for a uniform stress `P` and the traction `P N`.
pub(crate) const UNIFORM_TRACTION: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "a uniform stress is in equilibrium with its traction at every node, jitter 0 and 0.3, every kernel",
    source: "NB25 (31)-(32) with P_a = P and t_B = P N",
    because: "the leftover of the boundary areas times |P|, which is 1",
    bound: 1e-12,
    measure: || {
        worst(&[Consistency::Integration], |particles, stencils, _, _| imbalance(particles, stencils))
    },
    control: || worst(&[Consistency::Kernel], |particles, stencils, _, _| imbalance(particles, stencils)),
};

/// A stress with no symmetry and Frobenius norm 1.
fn stress() -> Mat3 {
    Mat3::new(0.9, 0.3, -0.2, 0.1, -0.5, 0.4, 0.0, 0.7, 0.6).normalize()
}

/// Largest `|Σ_b V_b G_a(X_b) − A_a N_a|`, in squared spacings.
fn areas(particles: &Particles, stencils: &Stencils) -> f64 {
    let area = particles.boundary_area();
    let miss = |a: usize| (stencils.row(a).backward.iter().sum::<Vec3>() - area[a]).norm();
    (0..particles.len()).map(miss).fold(0.0, f64::max) / particles.spacing.powi(2)
}

/// Largest force left over at a node, over the squared spacing and `|P|`: internal force as (32) prints
/// it, pair by pair, against the traction.
pub(super) fn imbalance(particles: &Particles, stencils: &Stencils) -> f64 {
    let p = stress();
    let area = particles.boundary_area();
    let miss = |a: usize| {
        let row = stencils.row(a);
        let pairs = row.backward.iter().zip(row.forward);
        let internal: Vec3 = pairs.map(|(backward, forward)| p * backward - p * forward).sum();
        (internal - p * area[a]).norm()
    };
    (0..particles.len()).map(miss).fold(0.0, f64::max) / particles.spacing.powi(2)
}
