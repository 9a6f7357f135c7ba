//! Volumes and areas of the background grid against the divergence theorem.

use super::block;
use crate::discretisation::Particles;
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

/// `Σ_a V_a` is the volume of the body.
pub(crate) const VOLUME: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "the volumes of the nodes add up to the body's, jitter 0 and 0.3",
    source: "V_a = integral of N_a, and the N_a add up to 1",
    because: "495 volumes of some 64 products each: a random walk of 180 roundings of 1.1e-16",
    bound: 2e-14,
    measure: || both(|particles| (particles.volume.iter().sum::<f64>() - 0.32).abs() / 0.32),
    control: || {
        // every node given a whole cell, as if none lay on the boundary
        both(|particles| (particles.len() as f64 * 1e-3 - 0.32).abs() / 0.32)
    },
};

/// `Σ_a A_a N_a = 0`.
pub(crate) const CLOSED_SURFACE: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "the boundary areas of a body add up to nothing, jitter 0 and 0.3",
    source: "divergence theorem for a constant; NB25 (31) for A_a",
    because: "areas of a whole side, at most 0.8 m^2 = 80 dx^2, in 300 terms: 80 sqrt(300) 1.1e-16 dx^2",
    bound: 2e-13,
    measure: || both(|particles| particles.boundary_area().iter().sum::<Vec3>().norm() / 1e-2),
    control: || {
        // the plane of symmetry forgotten
        both(|particles| {
            let faces = particles.faces.iter().filter(|face| face.name != "symmetry_z");
            faces.flat_map(|face| &face.area).sum::<Vec3>().norm() / 1e-2
        })
    },
};

/// `Σ_a X_a ⊗ A_a N_a = (Σ_a V_a) I`: without it integration consistency has no solution.
pub(crate) const FIRST_MOMENTS: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "first moments of the boundary areas are the volume times the identity, jitter 0 and 0.3",
    source: "divergence theorem for coordinates",
    because: "moments of a whole side, at most 0.9 * 0.8 m^3 over 0.32 m^3, in 300 terms",
    bound: 2e-14,
    measure: || both(|particles| first_moments(particles, |normal| normal)),
    control: || both(|particles| first_moments(particles, |normal| 1.001 * normal)),
};

/// The larger of a measure without and with jitter.
fn both(measure: impl Fn(&Particles) -> f64) -> f64 {
    measure(&block(0.1, 0.0)).max(measure(&block(0.1, 0.3)))
}

/// Relative difference between first moments and volume, areas altered by `alter`.
fn first_moments(particles: &Particles, alter: impl Fn(Vec3) -> Vec3) -> f64 {
    let volume: f64 = particles.volume.iter().sum();
    let area = particles.boundary_area();
    let moments: Mat3 = particles.position.iter().zip(area).map(|(x, n)| x * alter(n).transpose()).sum();
    (moments / volume - Mat3::identity()).norm()
}
