//! Integration consistency: the least correction of the gradients that makes boundary areas exact.
//!
//! Owns the constraint and its solution. Knows neither the lattice nor what the gradients are used for.
//!
//! Write `C_ab = V_a G_b(X_a)`. The gradient at `a` is `(1/V_a) Σ_b f_b ⊗ C_ab`, a row of `C`; the force of
//! a uniform stress on `a` is `P Σ_b C_ba`, a column. Rows are linearly exact,
//!
//! ```text
//! Σ_b C_ab = 0,    Σ_b X_b ⊗ C_ab = V_a I,
//! ```
//!
//! and integration by parts asks of the columns what it gives the shape functions (the integration
//! constraint of Chen, Hillman & Rüter 2013):
//!
//! ```text
//! Σ_b C_ba = A_a N_a.
//! ```
//!
//! Among all `C + δ` that satisfy the three we take the one of least `½ Σ_{a≠b} |δ_ab|²/w_ab` with
//! `w_ab = V_a V_b W(|X_b − X_a|)` and `δ_aa = −Σ_{b≠a} δ_ab`. The components of `δ` are independent. For one
//! of them, with multipliers `φ_a` of the columns and `g_a` of the rows' first moments, the function is
//! stationary where
//!
//! ```text
//! δ_ab = w_ab [ (φ_b − φ_a) − g_a · (X_b − X_a) ],
//! ```
//!
//! since `δ_ab` adds to column `b` and, through `δ_aa`, subtracts from column `a`. The first moments
//! `Σ_b δ_ab (X_b − X_a) = 0` make `g_a` the weighted least-squares gradient of `φ`,
//!
//! ```text
//! M_a g_a = Σ_b w_ab (φ_b − φ_a)(X_b − X_a),    M_a = Σ_b w_ab (X_b − X_a) ⊗ (X_b − X_a),
//! ```
//!
//! and the columns, `w` being symmetric, are one system for `φ`:
//!
//! ```text
//! (K φ)_a = Σ_b (δ_ba − δ_ab) = Σ_b w_ab [ (g_a + g_b) · (X_b − X_a) − 2 (φ_b − φ_a) ] = A_a N_a − Σ_b C_ba.
//! ```
//!
//! `φ · K φ = Σ_ab δ_ab²/w_ab ≥ 0`, and zero only for `φ` that every particle sees as linear: `K` is symmetric
//! and positive but for the four linear functions. The right side is orthogonal to those: to constants
//! because `Σ_a A_a N_a = 0` and the rows sum to zero, to coordinates because
//! `Σ_a X_a ⊗ A_a N_a = Σ_a V_a I = Σ_b Σ_a X_a ⊗ C_ba`. So a solution exists exactly if areas and volumes
//! come from one background grid.

use super::conjugate;
use super::error::DiscretisationError;
use super::kernel::Kernel;
use super::moments::{Basis, LINEAR, inverse};
use super::neighbour::Neighbours;
use super::particles::Particles;
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;

/// Leftover of the constraint that is accepted, the root of its sum of squares over particles, as a
/// fraction of the squared spacing. One column sum of some 30 entries rounds to about 1e-15 of it.
const TOLERANCE: f64 = 1e-12;

/// Leftover that is accepted where another run takes less than half of it away: a run starts from the residual formed anew, so
/// what it cannot take away is the rounding of its own correction, 1e-16 times the condition of the system, which nodes
/// just enough for quadratic fields bring to some 1e6. Forces of a uniform stress are wrong by this share of a traction's,
/// a millionth of what the discretisation is.
const ROUND_OFF: f64 = 1e-9;

/// Runs of conjugate gradients after which the constraint counts as not met; each starts from the
/// residual formed anew, because the one carried along drifts.
const MOST_RUNS: usize = 8;

/// Iterations after which a run of conjugate gradients ends; the condition number grows with the fourth
/// power of the number of particles along an edge, the count of iterations with its square.
const MOST_ITERATIONS: usize = 20_000;

/// Corrects `forward`, the entries `V_a G_b(X_a)`, so that the integration constraint holds.
///
/// # Errors
/// [`DiscretisationError::SingularMoments`], [`DiscretisationError::ConstraintNotMet`].
pub(super) fn impose(
    particles: &Particles,
    kernel: Kernel,
    h: f64,
    list: &Neighbours,
    reverse: &[u32],
    forward: &mut [Vec3],
) -> Result<(), DiscretisationError> {
    let system = System::new(particles, kernel, h, list)?;
    meet(&system, particles, list, reverse, forward)
}

/// A system for the multipliers of the columns that knows what its solution changes.
pub(super) trait Columns: conjugate::System {
    /// Adds `δ_ab` of a solution to the entries of every row.
    fn correct(&self, phi: &[Vec3], forward: &mut [Vec3]);

    /// Whether the gradients are to stay exact for quadratic fields.
    fn is_quadratic(&self) -> bool;
}

/// Solves for what the columns miss of their areas and corrects the entries, until nothing is missed.
///
/// # Errors
/// [`DiscretisationError::ConstraintNotMet`].
pub(super) fn meet(
    system: &impl Columns,
    particles: &Particles,
    list: &Neighbours,
    reverse: &[u32],
    forward: &mut [Vec3],
) -> Result<(), DiscretisationError> {
    let target = particles.boundary_area();
    let scale = particles.spacing * particles.spacing;
    let mut iterations = 0;
    let mut before = f64::INFINITY;
    for run in 0.. {
        let residual: Vec<Vec3> = (0..target.len())
            .into_par_iter()
            .map(|a| reverse[list.range(a)].iter().fold(target[a], |r, &entry| r - forward[entry as usize]))
            .collect();
        let (particle, leftover) = residual
            .iter()
            .map(|r| r.amax() / scale)
            .enumerate()
            .fold((0, 0.0), |worst, (a, r)| if r > worst.1 || r.is_nan() { (a, r) } else { worst });
        if leftover <= TOLERANCE {
            break;
        }
        if leftover <= ROUND_OFF && (run == MOST_RUNS || leftover > 0.5 * before) {
            break;
        }
        if run == MOST_RUNS || leftover.is_nan() {
            let (position, quadratic) = (particles.position[particle], system.is_quadratic());
            let missed =
                DiscretisationError::ConstraintNotMet { particle, position, leftover, iterations, quadratic };
            return Err(missed);
        }
        before = leftover;
        let (phi, spent) = conjugate::solve(system, residual, 0.5 * TOLERANCE * scale, MOST_ITERATIONS);
        iterations += spent;
        system.correct(&phi, forward);
    }
    Ok(())
}

/// Weights `w_ab = V_a V_b W(|X_b − X_a|)` of every entry, m³; zero for `b = a`, which drops out.
pub(super) fn weights(particles: &Particles, kernel: Kernel, h: f64, list: &Neighbours) -> Vec<f64> {
    let (position, volume) = (&particles.position[..], &particles.volume[..]);
    let row = |a: usize| {
        list.range(a).map(move |entry| {
            let b = list.neighbour[entry] as usize;
            let r = (position[b] - position[a]).norm();
            if b == a { 0.0 } else { volume[a] * volume[b] * kernel.value(r, h) }
        })
    };
    (0..position.len()).into_par_iter().flat_map_iter(row).collect()
}

/// The system `K φ = r`, three right sides at once.
struct System<'a> {
    list: &'a Neighbours,
    position: &'a [Vec3],
    /// `w_ab` of each entry, m³; zero for `b = a`, which drops out.
    weight: Vec<f64>,
    /// `w_ab (X_b − X_a)` of each entry, m⁴.
    arm: Vec<Vec3>,
    /// `M_a⁻¹`, m⁻⁵.
    inverse_moment: Vec<Mat3>,
    /// Inverse of the diagonal of `K`, m⁻³.
    preconditioner: Vec<f64>,
    /// Orthonormal basis of the linear functions on the particles.
    linear: Vec<Vec<f64>>,
}

impl<'a> System<'a> {
    fn new(
        particles: &'a Particles,
        kernel: Kernel,
        h: f64,
        list: &'a Neighbours,
    ) -> Result<Self, DiscretisationError> {
        let position = &particles.position[..];
        let weight = weights(particles, kernel, h, list);

        let arm = |a: usize| {
            let weight = &weight;
            list.range(a)
                .map(move |entry| weight[entry] * (position[list.neighbour[entry] as usize] - position[a]))
        };
        let arm: Vec<Vec3> = (0..position.len()).into_par_iter().flat_map_iter(arm).collect();

        let sums = |a: usize| {
            let (mut zeroth, mut first, mut second) = (0.0, Vec3::zeros(), Mat3::zeros());
            for entry in list.range(a) {
                let d = position[list.neighbour[entry] as usize] - position[a];
                zeroth += weight[entry];
                first += arm[entry];
                second += arm[entry] * d.transpose();
            }
            ((zeroth, first), inverse(&second))
        };
        let sums: Vec<((f64, Vec3), Option<Mat3>)> = (0..position.len()).into_par_iter().map(sums).collect();
        let (moments, second): (Vec<(f64, Vec3)>, Vec<Option<Mat3>>) = sums.into_iter().unzip();
        let mut inverse_moment = Vec::with_capacity(position.len());
        for (a, moment) in second.into_iter().enumerate() {
            inverse_moment.push(moment.ok_or_else(|| DiscretisationError::SingularMoments {
                particle: a,
                position: position[a],
                neighbours: list.range(a).len(),
            })?);
        }
        let diagonal = |a: usize| {
            let (zeroth, first) = &moments[a];
            let mut diagonal = 2.0 * zeroth - first.dot(&(inverse_moment[a] * first));
            for entry in list.range(a) {
                let b = list.neighbour[entry] as usize;
                diagonal -= arm[entry].dot(&(inverse_moment[b] * arm[entry]));
            }
            1.0 / diagonal
        };
        let preconditioner = (0..position.len()).into_par_iter().map(diagonal).collect();
        let linear = Basis { inverse_length: 1.0 }.orthonormal::<LINEAR>(position);
        Ok(Self { list, position, weight, arm, inverse_moment, preconditioner, linear })
    }

    /// Least-squares gradients of the three components of `φ`, one a row.
    fn gradients(&self, phi: &[Vec3]) -> Vec<Mat3> {
        let gradient = |a: usize| {
            let range = self.list.range(a);
            let entries = self.list.neighbour[range.clone()].iter().zip(&self.arm[range]);
            let sum = entries
                .fold(Mat3::zeros(), |sum, (&b, arm)| sum + (phi[b as usize] - phi[a]) * arm.transpose());
            sum * self.inverse_moment[a]
        };
        (0..phi.len()).into_par_iter().map(gradient).collect()
    }
}

impl Columns for System<'_> {
    fn is_quadratic(&self) -> bool {
        false
    }

    fn correct(&self, phi: &[Vec3], forward: &mut [Vec3]) {
        let g = self.gradients(phi);
        for a in 0..phi.len() {
            let mut own = 0;
            let mut sum = Vec3::zeros();
            for entry in self.list.range(a) {
                let b = self.list.neighbour[entry] as usize;
                if b == a {
                    own = entry;
                    continue;
                }
                let d = self.position[b] - self.position[a];
                let delta = self.weight[entry] * ((phi[b] - phi[a]) - g[a] * d);
                forward[entry] += delta;
                sum += delta;
            }
            forward[own] -= sum;
        }
    }
}

impl conjugate::System for System<'_> {
    fn apply(&self, phi: &[Vec3]) -> Vec<Vec3> {
        let g = self.gradients(phi);
        let row = |a: usize| {
            let range = self.list.range(a);
            let entries = self.list.neighbour[range.clone()].iter();
            entries.zip(&self.arm[range.clone()]).zip(&self.weight[range]).fold(
                Vec3::zeros(),
                |sum, ((&b, arm), w)| {
                    let b = b as usize;
                    sum + ((g[a] + g[b]) * arm - (2.0 * w) * (phi[b] - phi[a]))
                },
            )
        };
        (0..phi.len()).into_par_iter().map(row).collect()
    }

    fn precondition(&self, residual: &[Vec3]) -> Vec<Vec3> {
        residual.iter().zip(&self.preconditioner).map(|(r, &m)| r * m).collect()
    }

    fn null(&self) -> &[Vec<f64>] {
        &self.linear
    }
}
