//! Internal force, upwinding between constant states, and volume dissipation of one particle.
//!
//! Owns the sums over neighbours that read stresses. Knows neither materials nor time.

use super::dissipation::{Speeds, interface_momentum, interface_traction};
use super::links::Links;
use super::quad::{Columns, Quad};

/// Internal force on particle `a` per reference volume.
///
/// ```text
/// −T_a = −Σ_b V_b ( P_b ∇̃W̃_a(X_b) − P_a ∇̃W̃_b(X_a) )      [NB25 (32)]
///      = 1/V_a Σ_b ( P_a A_ab − P_b A_ba ),   A_ab = V_a G_b(X_a)
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `links` | pairs of the body | |
/// | `a` | the particle | |
/// | `stress` | stresses of all particles of the body | Pa |
/// | `inverse_volume` | `1/V_a` | 1/m³ |
///
/// Returns N/m³. Summed in stencil order. Exact in floating point: the term of `(b, a)` is the
/// negative of the term of `(a, b)`, so the forces of a pair cancel.
#[inline(always)]
pub fn internal(links: &Links, a: usize, stress: &[Columns], inverse_volume: f64) -> Quad {
    let own = stress[a];
    let mut sum = Quad::ZERO;
    let row = links.row(a);
    let pairs =
        links.neighbour[row.clone()].iter().zip(&links.forward[row.clone()]).zip(&links.backward[row]);
    for ((&b, forward), backward) in pairs {
        sum += own.apply(forward) - stress[b as usize].apply(backward);
    }
    sum * inverse_volume
}

/// Internal force and upwinding between the particles' own momenta together, one walk over the neighbours.
///
/// ```text
/// D(p_a) = Σ_b V_b P_stab ( ∇̃W̃_b(X_a) − ∇̃W̃_a(X_b) )       [NB25 (33)]
///        = 1/V_a Σ_b S_p (p_b − p_a) N·(A_ab − A_ba)
/// ```
///
/// Arguments as [`internal`], and
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `position`, `velocity` | of all particles of the body | m, m/s |
/// | `impedance` | `ρR` times the weighted wave speeds | kg m⁻² s⁻¹ |
///
/// Returns N/m³. Pairs cancel exactly, as in [`internal`].
#[inline(always)]
pub fn internal_and_upwinding(
    links: &Links,
    a: usize,
    stress: &[Columns],
    position: &[Quad],
    velocity: &[Quad],
    impedance: Speeds,
    inverse_volume: f64,
) -> Quad {
    let own = stress[a];
    let (x_a, v_a) = (position[a], velocity[a]);
    let mut sum = Quad::ZERO;
    let row = links.row(a);
    let gradients = links.forward[row.clone()].iter().zip(&links.backward[row.clone()]);
    let pairs = links.neighbour[row.clone()].iter().zip(gradients).zip(&links.pair[row]);
    for ((&b, (forward, backward)), pair) in pairs {
        let b = b as usize;
        let traction = interface_traction(velocity[b] - v_a, position[b] - x_a, impedance);
        sum += own.apply(forward) - stress[b].apply(backward) + traction * pair.interface;
    }
    sum * inverse_volume
}

/// Volume dissipation of particle `a`.
///
/// ```text
/// D(J_a) = Σ_b V_b (p_stab/ρR) · [ H_a ∇̃W̃_b(X_a) − H_b ∇̃W̃_a(X_b) ]     [NB25 (34)]
/// ```
///
/// with the particles' own stresses as interface states.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `links`, `a`, `stress`, `inverse_volume` | as [`internal`] | |
/// | `position` | of all particles of the body | m |
/// | `area_map` | `H` of all particles of the body | – |
/// | `density` | `ρR` | kg/m³ |
/// | `c_p` | pressure wave speed | m/s |
///
/// Returns 1/s. Exact in floating point: `V_a` times the term of `(a, b)` is the negative of `V_b`
/// times the term of `(b, a)`, so the total volume `Σ V_a J_a` is not changed by it.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "a pure kernel takes its state as values")]
pub fn volume_dissipation(
    links: &Links,
    a: usize,
    stress: &[Columns],
    position: &[Quad],
    area_map: &[Columns],
    density: f64,
    c_p: f64,
    inverse_volume: f64,
) -> f64 {
    let mut sum = 0.0;
    let row = links.row(a);
    let gradients = links.forward[row.clone()].iter().zip(&links.backward[row.clone()]);
    let pairs = links.neighbour[row.clone()].iter().zip(gradients).zip(&links.pair[row]);
    for ((&b, (forward, backward)), pair) in pairs {
        let b = b as usize;
        let step = pair.half_step;
        let length = libm::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
        let normal = step.map(|component| component / length);
        let jump = stress[b].apply(&normal) - stress[a].apply(&normal);
        let p_stab = interface_momentum(jump, position[b] - position[a], c_p);
        let area = area_map[a].apply(forward) - area_map[b].apply(backward);
        sum += p_stab.dot(area);
    }
    sum * inverse_volume / density
}
