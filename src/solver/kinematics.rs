//! Rates of the maps F, H and J.
//!
//! Owns the gradient of the velocity and what follows from it for one particle. The loops over
//! particles are in the passes; nothing here knows a material.

use super::links::Links;
use super::quad::{Columns, Quad};
use crate::tensor::{Mat3, cofactor, contract, cross, volume_map};

/// Velocity gradient of particle `a`, the rate of its deformation gradient.
///
/// ```text
/// dF_a/dt = Σ_b (v_b − v_a) ⊗ G_b(X_a)             [NB25 (28)]
/// ```
///
/// Differs from [NB25 (28)] as printed: the average `½(p_a + p_b)` is written as a difference, the
/// same sum because the gradients of a stencil add up to zero; the printed form without `b = a`
/// does not reproduce a constant.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `links` | pairs of the body | |
/// | `a` | the particle | |
/// | `velocity` | velocities of all particles of the body | m/s |
/// | `inverse_volume` | `1/V_a` | 1/m³ |
///
/// Returns `Grad v` at `a`, 1/s. Summed in stencil order. Exactly zero for a rigid translation.
#[inline(always)]
pub fn velocity_gradient(links: &Links, a: usize, velocity: &[Quad], inverse_volume: f64) -> Columns {
    let own = velocity[a];
    let mut sum = Columns::ZERO;
    let row = links.row(a);
    for (&b, forward) in links.neighbour[row.clone()].iter().zip(&links.forward[row]) {
        sum.add_outer(velocity[b as usize] - own, forward);
    }
    sum.scaled(inverse_volume)
}

/// Rate of the area map.
///
/// ```text
/// dH/dt = F ⨯ Grad v                               [NB25 (29)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `f` | deformation gradient | – |
/// | `gradient` | `Grad v` | 1/s |
///
/// Returns a rate in 1/s.
#[inline(always)]
pub fn area_map_rate(f: &Mat3, gradient: &Mat3) -> Mat3 {
    cross(f, gradient)
}

/// Rate of the volume map without its dissipation.
///
/// ```text
/// dJ/dt = H : Grad v                               [NB25 (30)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `h` | area map | – |
/// | `gradient` | `Grad v` | 1/s |
///
/// Returns a rate in 1/s.
#[inline(always)]
pub fn volume_map_rate(h: &Mat3, gradient: &Mat3) -> f64 {
    contract(h, gradient)
}

/// Rate that draws the evolved volume map to the determinant of the deformation gradient.
///
/// ```text
/// r (det F − J)
/// ```
///
/// Differs from [NB25 (34)], which has no such term: there nothing bounds what D(J) adds to J. With it
/// the gap stays below `max |D(J)| / r`.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `f` | deformation gradient | – |
/// | `j` | evolved volume map | – |
/// | `rate` | `r` | 1/s |
///
/// Returns a rate in 1/s.
#[inline(always)]
pub fn volume_restoring(f: &Mat3, j: f64, rate: f64) -> f64 {
    rate * (volume_map(f, &cofactor(f)) - j)
}
