//! Internal force and dissipation of one particle.
//!
//! Owns the two sums over neighbours that change momentum and the one that changes volume. Knows
//! neither materials nor time.

use super::dissipation::{Speeds, interface_momentum, interface_traction, limited_jump, linear_jump};
use super::links::{Links, Pair};
use super::quad::{Columns, Quad};

/// What a neighbour shows of itself to the force loop.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C, align(64))]
pub struct Packet {
    /// First Piola–Kirchhoff stress, Pa.
    pub stress: Columns,
    /// `Grad v`, 1/s.
    pub gradient: Columns,
}

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
/// | `packets` | stresses of all particles of the body | Pa |
/// | `inverse_volume` | `1/V_a` | 1/m³ |
///
/// Returns N/m³. Summed in stencil order. Exact in floating point: the term of `(b, a)` is the
/// negative of the term of `(a, b)`, so the forces of a pair cancel.
#[inline(always)]
pub fn internal(links: &Links, a: usize, packets: &[Packet], inverse_volume: f64) -> Quad {
    let own = packets[a].stress;
    let mut sum = Quad::ZERO;
    let row = links.row(a);
    let pairs = links.neighbour[row.clone()].iter().zip(&links.forward[row.clone()]).zip(&links.pair[row]);
    for ((&b, forward), pair) in pairs {
        sum += own.apply(forward) - packets[b as usize].stress.apply(&pair.backward);
    }
    sum * inverse_volume
}

/// What the interface states of a pair are made of.
#[derive(Debug, Clone, Copy)]
pub struct Meeting<'a> {
    /// `v_b − v_a`, m/s.
    difference: Quad,
    /// `x_b − x_a`, m.
    distance: Quad,
    /// `Grad v` of the two, 1/s.
    gradients: [&'a Columns; 2],
    /// Constants of the pair.
    pair: &'a Pair,
}

/// Jump between the particles' own velocities, m/s.
#[inline(always)]
pub fn constant_states(of: Meeting<'_>) -> Quad {
    of.difference
}

/// Jump between velocities carried to the middle of the pair, m/s.
#[inline(always)]
pub fn linear_states(of: Meeting<'_>) -> Quad {
    linear_jump(of.difference, of.gradients[0], of.gradients[1], &of.pair.half_step)
}

/// The same, limited so that the pair loses energy, m/s.
///
/// A pair whose dissipation weighs less than nothing, as integration consistency may leave a few of on an
/// irregular lattice, takes none and has no jump.
#[inline(always)]
pub fn limited_states(of: Meeting<'_>) -> Quad {
    let weighed = if of.pair.dissipation > 0.0 { 1.0 } else { 0.0 };
    limited_jump(linear_states(of), of.difference, of.distance) * weighed
}

/// Internal force and momentum dissipation together, one walk over the neighbours.
///
/// ```text
/// D(p_a) = Σ_b V_b P_stab ( ∇̃W̃_b(X_a) − ∇̃W̃_a(X_b) )       [NB25 (33)]
///        = 1/V_a Σ_b S_p (p⁺ − p⁻) N·(A_ab − A_ba)
/// ```
///
/// with `p⁺ − p⁻` from `jump`, one of [`constant_states`], [`linear_states`] and [`limited_states`]. Arguments as
/// [`internal`], and
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `position`, `velocity` | of all particles of the body | m, m/s |
/// | `impedance` | `ρR` times the weighted wave speeds | kg m⁻² s⁻¹ |
/// | `jump` | of velocity between the states of a pair | m/s |
///
/// Returns N/m³. Pairs cancel exactly, as in [`internal`].
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "a pure kernel takes its state as values")]
pub fn internal_and_dissipation(
    links: &Links,
    a: usize,
    packets: &[Packet],
    position: &[Quad],
    velocity: &[Quad],
    impedance: Speeds,
    inverse_volume: f64,
    jump: impl Fn(Meeting<'_>) -> Quad,
) -> Quad {
    let own = packets[a];
    let (x_a, v_a) = (position[a], velocity[a]);
    let mut sum = Quad::ZERO;
    let row = links.row(a);
    let pairs = links.neighbour[row.clone()].iter().zip(&links.forward[row.clone()]).zip(&links.pair[row]);
    for ((&b, forward), pair) in pairs {
        let b = b as usize;
        let other = &packets[b];
        let (difference, distance) = (velocity[b] - v_a, position[b] - x_a);
        let gradients = [&own.gradient, &other.gradient];
        let traction =
            interface_traction(jump(Meeting { difference, distance, gradients, pair }), distance, impedance);
        sum += own.stress.apply(forward) - other.stress.apply(&pair.backward) + traction * pair.dissipation;
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
/// | `links`, `a`, `packets`, `inverse_volume` | as [`internal`] | |
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
    packets: &[Packet],
    position: &[Quad],
    area_map: &[Columns],
    density: f64,
    c_p: f64,
    inverse_volume: f64,
) -> f64 {
    let mut sum = 0.0;
    let row = links.row(a);
    let pairs = links.neighbour[row.clone()].iter().zip(&links.forward[row.clone()]).zip(&links.pair[row]);
    for ((&b, forward), pair) in pairs {
        let b = b as usize;
        let step = pair.half_step;
        let length = libm::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
        let normal = step.map(|component| component / length);
        let jump = packets[b].stress.apply(&normal) - packets[a].stress.apply(&normal);
        let p_stab = interface_momentum(jump, position[b] - position[a], c_p);
        let area = area_map[a].apply(forward) - area_map[b].apply(&pair.backward);
        sum += p_stab.dot(area);
    }
    sum * inverse_volume / density
}
