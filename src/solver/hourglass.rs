//! Spring and dashpot against what no particle's gradient sees.
//!
//! Owns the pair that both act between, its forces, energy and dissipated power. The corrected gradient is a
//! central difference: even and odd nodes of a lattice may stretch or move differently and no `F_a` tells. Both
//! terms read what a pair's positions and velocities miss of the line their gradients draw, and both enter the
//! momentum balance by the exact adjoint of that reading, so the spring has an energy and the dashpot can only
//! lose it, whatever nodes, weights or completeness. Knows neither materials nor time.

use super::body::{BodyState, CHUNK};
use super::dissipation::Speeds;
use super::links::Links;
use super::quad::{Columns, Quad};
use super::strut::{Strut, struts};
use super::wide::wide;
use crate::tensor::{Mat3, cofactor};
use rayon::prelude::*;

/// What a neighbour shows of its motion to the pair loop.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C, align(32))]
pub struct Packet {
    /// Deformation gradient `F`, –.
    pub f: Columns,
    /// `Grad v`, 1/s.
    pub gradient: Columns,
    /// Half the spin, `½ ω` with `ω` the axial vector of the skew part of `Grad v F⁻¹`, 1/s.
    pub half_spin: Quad,
}

impl Packet {
    /// Sets the spin from the maps.
    #[inline(always)]
    pub fn turn(&mut self, inverse_transposed: &Mat3) {
        // L = Grad v F⁻¹, of which only what is off the diagonal counts
        let rate = self.gradient.matrix() * inverse_transposed.transpose();
        let part = |i: usize, j: usize| 0.25 * (rate[(j, i)] - rate[(i, j)]);
        self.half_spin = Quad([part(1, 2), part(2, 0), part(0, 1), 0.0]);
    }
}

/// Constants and results of the pair pass.
#[derive(Debug, Clone, Default)]
pub struct Hourglass {
    /// Geometry of each pair, in the order of the links.
    struts: Vec<Strut>,
    /// Modulus of the springs, `ξ μ`, Pa; zero for none.
    pub modulus: f64,
    /// `ρR` times the weighted wave speeds of the dashpots, kg m⁻² s⁻¹; zero for none.
    pub impedance: Speeds,
    /// Direct force on each particle, N.
    pub force: Vec<Quad>,
    /// Stress of the energy and of the pairs together, Pa.
    pub stress: Vec<Columns>,
    /// Twice the power the dashpots take, a chunk an entry, each pair counted from both ends, W.
    power: Vec<f64>,
}

impl Hourglass {
    /// Springs and dashpots of a body.
    ///
    /// ```text
    /// k_ab = ξ μ A_ab / |X_b − X_a|,   S_ab = A_ab ½ ρR [ w_p c_p n ⊗ n + w_s c_s (I − n ⊗ n) ]
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `links` | pairs of the body | |
    /// | `inverse_volume` | `1/V_a` | 1/m³ |
    /// | `modulus` | `ξ μ`, the dimensionless stiffness times the shear modulus of the matrix | Pa |
    /// | `impedance` | `ρR w c` of pressure and shear waves | kg m⁻² s⁻¹ |
    ///
    /// A bar of that modulus with the pair's interface area `A_ab`, see [`struts`], and length.
    pub fn new(links: &Links, inverse_volume: &[f64], modulus: f64, impedance: Speeds) -> Self {
        let count = inverse_volume.len();
        Self {
            struts: struts(links, inverse_volume),
            modulus,
            impedance,
            force: vec![Quad::ZERO; count],
            stress: vec![Columns::ZERO; count],
            power: vec![0.0; count.div_ceil(CHUNK)],
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        self.struts.len() * size_of::<Strut>()
            + self.force.len() * size_of::<Quad>()
            + self.stress.len() * size_of::<Columns>()
            + self.power.len() * size_of::<f64>()
    }

    /// Power the dashpots took at the last pass, `Σ_{a<b} d_ab · S_ab d_ab ≥ 0`, W.
    pub fn dissipated_power(&self) -> f64 {
        // each pair is met twice
        0.5 * self.power.iter().sum::<f64>()
    }
}

/// What a pair's positions miss of the line their gradients draw.
///
/// ```text
/// m_ab = x_b − x_a − ½ (F_a + F_b) (X_b − X_a)
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `distance` | `x_b − x_a` | m |
/// | `f_a`, `f_b` | deformation gradients | – |
/// | `half_step` | `½ (X_b − X_a)` | m |
///
/// Returns m. Zero for affine motions, of third order in the distance for smooth ones (the trapezium
/// rule), turned by a rotation. With velocities and their gradients for positions and theirs it is the jump of the
/// linear reconstruction, [`super::dissipation::linear_jump`]. Exact in floating point: exchanging `a` and `b`
/// flips it.
#[inline(always)]
pub fn mismatch(distance: Quad, f_a: &Columns, f_b: &Columns, half_step: &[f64; 3]) -> Quad {
    f_a.plus(f_b).taken_from(distance, half_step)
}

/// Rate of the mismatch in a frame that turns with the pair.
///
/// ```text
/// d_ab = v_b − v_a − ½ (Grad v_a + Grad v_b) (X_b − X_a) − ½ (ω_a + ω_b) × m_ab
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `rate` | [`mismatch`] of the velocities | m/s |
/// | `mismatch` | `m_ab` | m |
/// | `half_spins` | `½ (ω_a + ω_b)` | 1/s |
///
/// Returns m/s. Zero for `v = Ω × x + c` whatever the deformation: what turns as a whole loses nothing, and what
/// has no power has no torque. Exact in floating point: exchanging `a` and `b` flips it.
#[inline(always)]
pub fn corotational_rate(rate: Quad, mismatch: Quad, half_spins: Quad) -> Quad {
    let product = half_spins.products_plus(mismatch.rotated(), Quad::ZERO);
    let turned = (-half_spins.rotated()).products_plus(mismatch, product);
    rate - turned.rotated()
}

/// Traction of a dashpot.
///
/// ```text
/// S d = ½ [ z_p n ⊗ n + z_s (I − n ⊗ n) ] d,    n along x_b − x_a      [NB25 (37)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `rate` | `d_ab` | m/s |
/// | `distance` | `x_b − x_a` | m |
/// | `impedance` | `z_p`, `z_s` | kg m⁻² s⁻¹ |
///
/// Returns Pa; nothing along a pair of no length. Its power `d · S d` is never negative. Exact in floating point:
/// flips with `rate` and `distance`.
#[inline(always)]
fn dashpot(rate: Quad, distance: Quad, impedance: Speeds) -> Quad {
    let square = distance.dot(distance) + f64::MIN_POSITIVE;
    let along = 0.5 * (impedance.pressure - impedance.shear) * (distance.dot(rate) / square);
    distance.times_plus(along, rate * (0.5 * impedance.shear))
}

/// Energy of the springs, J.
///
/// ```text
/// Φ = Σ_{a<b} ½ k_ab |m_ab|²
/// ```
///
/// Zero where the body has none. Summed in stencil order.
pub fn energy(body: &BodyState) -> f64 {
    let Some(hourglass) = body.hourglass.as_ref().filter(|hourglass| hourglass.modulus > 0.0) else {
        return 0.0;
    };
    let mut sum = 0.0;
    for a in 0..body.len() {
        let own = Columns::new(body.f(a));
        for entry in body.links.row(a) {
            let b = body.links.neighbour[entry] as usize;
            let other = Columns::new(body.f(b));
            let strut = &hourglass.struts[entry];
            let m = mismatch(body.x[b] - body.x[a], &own, &other, &strut.half_step);
            // each pair is met twice
            sum += 0.25 * hourglass.modulus * strut.area * strut.inverse_length * m.dot(m);
        }
    }
    sum
}

/// The pass: forces of springs and dashpots where `F` is the discrete gradient of `x` and `Grad v` that of `v`.
///
/// ```text
/// t_ab = k_ab m_ab + S_ab d_ab
/// force on a    Σ_b t_ab
/// stress of a   P_a − 1/V_a { Σ_b t_ab ⊗ ½ (X_b − X_a) + ¼ [Σ_b m_ab × t_ab]_× F_a⁻ᵀ }
/// ```
///
/// the derivatives of `Φ = Σ ½ k m²` by positions and of `R = Σ ½ d · S d` by velocities. Differs from [NB25 (33)],
/// whose traction works against the whole difference of velocities and may feed it: here the power is
/// `−Σ_{a<b} d·S d ≤ 0` for any nodes, weights and completeness. The springs' share of `m × t` is zero. Both keep
/// linear momentum exactly and angular momentum to round-off, since neither `m` under a rotation nor `d` for
/// `Ω × x + c` has a power.
pub fn hourglass(body: &mut BodyState) {
    let BodyState { links, x, v, packets, stress, inverse_volume, hourglass, .. } = body;
    let Some(Hourglass { struts, modulus, impedance, force, stress: total, power }) = hourglass else {
        return;
    };
    let read = Read { links, struts, x, v, packets, modulus: *modulus, impedance: *impedance };
    let (stress, inverse_volume) = (&stress[..], &inverse_volume[..]);
    force
        .par_chunks_mut(CHUNK)
        .zip(total.par_chunks_mut(CHUNK).zip(power.par_iter_mut()))
        .enumerate()
        .for_each(|(chunk, (force, (total, power)))| {
            let start = chunk * CHUNK;
            let own = (&stress[start..start + force.len()], &inverse_volume[start..start + force.len()]);
            *power = wide!(read.chunk(start, own, force, total));
        });
}

/// What the loop over the pairs of a chunk reads.
#[derive(Clone, Copy)]
struct Read<'a> {
    links: &'a Links,
    struts: &'a [Strut],
    x: &'a [Quad],
    v: &'a [Quad],
    packets: &'a [Packet],
    modulus: f64,
    impedance: Speeds,
}

/// Sums over the pairs of a particle.
struct Sums {
    /// `Σ t`, N.
    force: Quad,
    /// `Σ t ⊗ ½ (X_b − X_a)`, N m.
    moment: Columns,
    /// `Σ m × t`, N m.
    couple: Quad,
    /// `Σ d · S d`, W.
    power: f64,
}

impl Read<'_> {
    /// Forces and stresses of the particles from `start` on; returns the power of their pairs, W.
    #[inline(always)]
    fn chunk(
        self,
        start: usize,
        (stress, inverse_volume): (&[Columns], &[f64]),
        force: &mut [Quad],
        total: &mut [Columns],
    ) -> f64 {
        let damped = self.impedance.pressure > 0.0 || self.impedance.shear > 0.0;
        let mut power = 0.0;
        for i in 0..force.len() {
            let a = start + i;
            let sums = if damped { self.sums::<true>(a) } else { self.sums::<false>(a) };
            force[i] = sums.force;
            let mut moment = sums.moment;
            if damped {
                let f = self.packets[a].f.matrix();
                let h = cofactor(&f);
                let volume = h.row(0).dot(&f.row(0));
                let [x, y, z, _] = sums.couple.0.map(|couple| 0.25 * couple / volume);
                let [r, s, t] = [0, 1, 2].map(|i| h.row(i).into_owned());
                // the rows of [c]_× cof F
                let turned = Mat3::from_rows(&[t * y - s * z, r * z - t * x, s * x - r * y]);
                moment = moment.plus(&Columns::new(&turned));
            }
            total[i] = stress[i].plus(&moment.scaled(-inverse_volume[i]));
            power += sums.power;
        }
        power
    }

    #[inline(always)]
    fn sums<const DAMPED: bool>(self, a: usize) -> Sums {
        let own = &self.packets[a];
        let (x_a, v_a) = (self.x[a], self.v[a]);
        let mut sums = Sums { force: Quad::ZERO, moment: Columns::ZERO, couple: Quad::ZERO, power: 0.0 };
        let mut work = Quad::ZERO;
        let row = self.links.row(a);
        for (&b, strut) in self.links.neighbour[row.clone()].iter().zip(&self.struts[row]) {
            let b = b as usize;
            let other = &self.packets[b];
            let distance = self.x[b] - x_a;
            let m = mismatch(distance, &own.f, &other.f, &strut.half_step);
            let mut traction = m * (self.modulus * strut.inverse_length);
            if DAMPED {
                let rate = mismatch(self.v[b] - v_a, &own.gradient, &other.gradient, &strut.half_step);
                let rate = corotational_rate(rate, m, own.half_spin + other.half_spin);
                let damping = dashpot(rate, distance, self.impedance);
                work = (damping * strut.area).products_plus(rate, work);
                traction += damping;
            }
            let t = traction * strut.area;
            sums.force += t;
            sums.moment.gather_outer(t, &strut.half_step);
            if DAMPED {
                sums.couple = m.products_plus(t.rotated(), sums.couple);
                sums.couple = (-m.rotated()).products_plus(t, sums.couple);
            }
        }
        sums.couple = sums.couple.rotated();
        sums.power = work.0[0] + work.0[1] + work.0[2];
        sums
    }
}

/// Square of the fastest frequency the springs give the body, 1/s²; zero where it has none.
///
/// The springs are linear in the positions and do not depend on the state, so this is found once: the largest
/// eigenvalue of `u ↦ −f(u)/m`.
pub fn stiffest(body: &BodyState) -> f64 {
    let Some(hourglass) = body.hourglass.as_ref().filter(|hourglass| hourglass.modulus > 0.0) else {
        return 0.0;
    };
    let traction = |strut: &Strut, m: Quad| m * (hourglass.modulus * strut.inverse_length);
    largest(body, &hourglass.struts, traction)
}

/// Fastest rate at which dashpots of an impedance change a velocity field of the undeformed body, 1/s.
///
/// ```text
/// ζ = largest eigenvalue of v ↦ −f(v)/m
/// ```
///
/// Zero where the body has none.
pub fn dashpot_rate(body: &BodyState, impedance: Speeds) -> f64 {
    let Some(hourglass) = &body.hourglass else { return 0.0 };
    let traction = |strut: &Strut, d: Quad| {
        let [x, y, z] = strut.half_step;
        dashpot(d, Quad([x, y, z, 0.0]), impedance)
    };
    largest(body, &hourglass.struts, traction)
}

/// Largest eigenvalue of minus the forces of a traction of the mismatch, over the masses.
///
/// The operator is symmetric in the masses, and the mismatch is that of the undeformed body.
fn largest(body: &BodyState, struts: &[Strut], traction: impl Fn(&Strut, Quad) -> Quad + Sync) -> f64 {
    let (links, inverse_volume) = (&body.links, &body.inverse_volume[..]);
    let mut gradient = vec![Columns::ZERO; body.len()];
    let mut sums = vec![(Quad::ZERO, Columns::ZERO); body.len()];
    let mut stress = vec![Columns::ZERO; body.len()];
    super::spectrum::largest(body.len(), |field, out| {
        gradient.par_iter_mut().enumerate().for_each(|(a, gradient)| {
            *gradient = super::kinematics::velocity_gradient(links, a, field, inverse_volume[a]);
        });
        sums.par_iter_mut().zip(&mut stress).enumerate().for_each(|(a, (sums, stress))| {
            let (mut force, mut moment) = (Quad::ZERO, Columns::ZERO);
            let row = links.row(a);
            for (&b, strut) in links.neighbour[row.clone()].iter().zip(&struts[row]) {
                let b = b as usize;
                let miss = mismatch(field[b] - field[a], &gradient[a], &gradient[b], &strut.half_step);
                let t = traction(strut, miss) * strut.area;
                force += t;
                moment.gather_outer(t, &strut.half_step);
            }
            *sums = (force, moment);
            *stress = moment.scaled(-inverse_volume[a]);
        });
        out.par_iter_mut().enumerate().for_each(|(a, out)| {
            let internal = super::force::internal(links, a, &stress, 1.0);
            *out = (internal + sums[a].0) * (inverse_volume[a] / body.density);
        });
    })
}

#[cfg(test)]
#[path = "hourglass/tests.rs"]
mod tests;
