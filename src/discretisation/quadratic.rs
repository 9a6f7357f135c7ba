//! Second-order gradients: exact for quadratic fields, and integrating by parts.
//!
//! Owns the correction and its constraints. Knows neither the lattice nor what the gradients are used for.
//!
//! As in [`super::integration`], `C_ab = V_a G_b(X_a)`. Rows are made exact for the nine monomials
//! `p(X_b − X_a)` of first and second degree, columns meet the integration constraint,
//!
//! ```text
//! Σ_b C_ab = 0,    Σ_b C_ab p(X_b − X_a) = V_a Grad p(0),    Σ_b C_ba = A_a N_a,
//! ```
//!
//! by the `δ` of least `½ Σ_{a≠b} |δ_ab|²/w_ab`, `δ_aa = −Σ_{b≠a} δ_ab`. With multipliers `φ_a` of the columns
//!
//! ```text
//! δ_ab = w_ab [ (φ_b − φ_a) − q_a p(X_b − X_a) ],
//! ```
//!
//! `q_a` being the weighted least-squares fit of `φ` around `a`, and the columns are one symmetric system for
//! `φ` that cannot see quadratic functions. It has a solution if the second moments of areas and volumes agree:
//! [`Particles::balance_second_moments`].
//!
//! A uniform stress is then in equilibrium with its tractions. A linear one is not, neither at a boundary, where
//! differences that integrate by parts with weights `V_a` exact for linear functions are of first order
//! (summation by parts, Kreiss & Scherer 1974), nor at displaced nodes, whose columns miss
//! `Σ_b C_ba ⊗ (X_b − X_a) = −V_a I` by their displacement.

use super::coarse::{self, Coarse};
use super::conjugate;
use super::error::DiscretisationError;
use super::integration;
use super::kernel::Kernel;
use super::moments::{Basis, QUADRATIC, inverse, reversed};
use super::neighbour::Neighbours;
use super::particles::Particles;
use crate::tensor::Vec3;
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

/// Kernel that weighs a change reaches this much farther than the one of the gradients, so that neighbours
/// at the edge of the list, which second derivatives need, are not ruled out.
const REACH: f64 = 1.5;

type Moments = SMatrix<f64, QUADRATIC, QUADRATIC>;
type Monomials = SVector<f64, QUADRATIC>;
type Fit = SMatrix<f64, 3, QUADRATIC>;

/// Corrects `forward`, the entries `V_a G_b(X_a)`, as the module says.
///
/// # Errors
/// [`DiscretisationError::SingularQuadratics`] if the neighbours of a particle do not tell quadratic fields apart;
/// [`DiscretisationError::ConstraintNotMet`].
pub(super) fn impose(
    particles: &Particles,
    kernel: Kernel,
    h: f64,
    list: &Neighbours,
    reverse: &[u32],
    forward: &mut [Vec3],
) -> Result<(), DiscretisationError> {
    let rows = Rows::new(particles, kernel, REACH * h, list)?;
    rows.complete(&particles.volume, forward);
    integration::meet(&Columns::new(&rows), particles, list, reverse, forward)
}

/// Weights and moments of all rows.
struct Rows<'a> {
    list: &'a Neighbours,
    position: &'a [Vec3],
    basis: Basis,
    /// `w_ab` of each entry, m³; zero for `b = a`, which drops out.
    weight: Vec<f64>,
    /// `(Σ_b w_ab p pᵀ)⁻¹`, m⁻³.
    inverse_moment: Vec<Moments>,
    /// Quadratic functions, orthonormal on the particles.
    null: Vec<Vec<f64>>,
}

impl<'a> Rows<'a> {
    fn new(
        particles: &'a Particles,
        kernel: Kernel,
        h: f64,
        list: &'a Neighbours,
    ) -> Result<Self, DiscretisationError> {
        let position = &particles.position[..];
        let basis = Basis { inverse_length: 1.0 / particles.spacing };
        let weight = integration::weights(particles, kernel, h, list);
        let moments = |a: usize| {
            let mut second = Moments::zeros();
            for entry in list.range(a) {
                let p: Monomials = basis.at(&(position[list.neighbour[entry] as usize] - position[a]));
                second += (weight[entry] * p) * p.transpose();
            }
            inverse(&second)
        };
        let moments: Vec<Option<Moments>> = (0..position.len()).into_par_iter().map(moments).collect();
        let mut inverse_moment = Vec::with_capacity(position.len());
        for (a, moment) in moments.into_iter().enumerate() {
            inverse_moment.push(moment.ok_or_else(|| DiscretisationError::SingularQuadratics {
                particle: a,
                position: position[a],
                neighbours: list.range(a).len(),
            })?);
        }
        let null = basis.orthonormal::<QUADRATIC>(position);
        Ok(Self { list, position, basis, weight, inverse_moment, null })
    }

    /// `p(X_b − X_a)` of an entry.
    fn monomials(&self, a: usize, entry: usize) -> Monomials {
        self.basis.at(&(self.position[self.list.neighbour[entry] as usize] - self.position[a]))
    }

    /// Makes every row exact for quadratic fields, by the least change.
    fn complete(&self, volume: &[f64], forward: &mut [Vec3]) {
        for (a, volume) in volume.iter().enumerate() {
            let mut missing = self.basis.gradient() * *volume;
            for entry in self.list.range(a) {
                missing -= forward[entry] * self.monomials(a, entry).transpose();
            }
            let fit = missing * self.inverse_moment[a];
            self.add(a, forward, |_, p| fit * p);
        }
    }

    /// Adds `w_ab` times something to the entries of row `a` and takes its sum from the row's own entry.
    fn add(&self, a: usize, forward: &mut [Vec3], delta: impl Fn(usize, &Monomials) -> Vec3) {
        let (mut own, mut sum) = (0, Vec3::zeros());
        for entry in self.list.range(a) {
            let b = self.list.neighbour[entry] as usize;
            if b == a {
                own = entry;
                continue;
            }
            let delta = self.weight[entry] * delta(b, &self.monomials(a, entry));
            forward[entry] += delta;
            sum += delta;
        }
        forward[own] -= sum;
    }
}

impl coarse::Row for Rows<'_> {
    fn neighbours(&self, a: usize) -> &[u32] {
        &self.list.neighbour[self.list.range(a)]
    }

    fn change(&self, a: usize, difference: &[f64], change: &mut [f64]) {
        let range = self.list.range(a);
        let seen = range.clone().zip(difference).fold(Monomials::zeros(), |sum, (entry, difference)| {
            sum + (self.weight[entry] * difference) * self.monomials(a, entry)
        });
        let fit = self.inverse_moment[a] * seen;
        for ((entry, difference), change) in range.zip(difference).zip(change) {
            *change = self.weight[entry] * (difference - fit.dot(&self.monomials(a, entry)));
        }
    }
}

/// The system of the columns' sums.
struct Columns<'a> {
    rows: &'a Rows<'a>,
    /// Inverse of the diagonal, m⁻³.
    preconditioner: Vec<f64>,
    /// Preconditioner of what is smooth.
    coarse: Option<Coarse>,
}

impl<'a> Columns<'a> {
    fn new(rows: &'a Rows<'a>) -> Self {
        let diagonal = |a: usize| {
            let (mut diagonal, mut first) = (0.0, Monomials::zeros());
            for entry in rows.list.range(a) {
                let (w, p) = (rows.weight[entry], rows.monomials(a, entry));
                first += w * p;
                let p = reversed(&p);
                let other = rows.list.neighbour[entry] as usize;
                diagonal += 2.0 * w - w * w * p.dot(&(rows.inverse_moment[other] * p));
            }
            1.0 / (diagonal - first.dot(&(rows.inverse_moment[a] * first)))
        };
        let preconditioner = (0..rows.position.len()).into_par_iter().map(diagonal).collect();
        let coarse = Coarse::new(rows.position, 1.0 / rows.basis.inverse_length, rows);
        Self { rows, preconditioner, coarse }
    }

    /// Least-squares fits of `φ` around every particle.
    fn fits(&self, phi: &[Vec3]) -> Vec<Fit> {
        let fit = |a: usize| {
            let entries = self.rows.list.range(a);
            let sum = entries.fold(Fit::zeros(), |sum, entry| {
                let difference = phi[self.rows.list.neighbour[entry] as usize] - phi[a];
                sum + (self.rows.weight[entry] * difference) * self.rows.monomials(a, entry).transpose()
            });
            sum * self.rows.inverse_moment[a]
        };
        (0..phi.len()).into_par_iter().map(fit).collect()
    }
}

impl integration::Columns for Columns<'_> {
    fn correct(&self, phi: &[Vec3], forward: &mut [Vec3]) {
        for (a, fit) in self.fits(phi).iter().enumerate() {
            self.rows.add(a, forward, |b, p| phi[b] - phi[a] - fit * p);
        }
    }
}

impl conjugate::System for Columns<'_> {
    fn apply(&self, phi: &[Vec3]) -> Vec<Vec3> {
        let fit = self.fits(phi);
        let column = |a: usize| {
            self.rows.list.range(a).fold(Vec3::zeros(), |sum, entry| {
                let (b, p) = (self.rows.list.neighbour[entry] as usize, self.rows.monomials(a, entry));
                let seen = fit[a] * p - fit[b] * reversed(&p);
                sum + self.rows.weight[entry] * (seen - 2.0 * (phi[b] - phi[a]))
            })
        };
        (0..phi.len()).into_par_iter().map(column).collect()
    }

    fn precondition(&self, residual: &[Vec3]) -> Vec<Vec3> {
        let mut rough: Vec<Vec3> = residual.iter().zip(&self.preconditioner).map(|(r, &m)| r * m).collect();
        if let Some(coarse) = &self.coarse {
            rough.iter_mut().zip(coarse.correct(residual)).for_each(|(z, smooth)| *z += smooth);
        }
        rough
    }

    fn null(&self) -> &[Vec<f64>] {
        &self.rows.null
    }
}

#[cfg(test)]
mod tests {
    use crate::discretisation::{Consistency, DiscretisationError, Kernel, Particles, Shape, Stencils};
    use crate::tensor::Vec3;

    fn built(jitter: f64, smoothing: f64) -> (Particles, Stencils) {
        let shape = Shape::Box { min: Vec3::new(-0.1, 0.0, 0.2), max: Vec3::new(0.9, 0.6, 0.6) };
        let mut particles = Particles::lattice(&shape, 0.1, [None, Some(0.2), None], jitter).unwrap();
        particles.balance_second_moments();
        let stencils =
            Stencils::build(&particles, Kernel::WendlandC2, smoothing, Consistency::Quadratic).unwrap();
        (particles, stencils)
    }

    #[test]
    fn quadratic_fields_have_their_gradient_at_every_node() {
        let field = |x: &Vec3| 3.0 + x.x - 2.0 * x.y + x.z * x.z - 4.0 * x.x * x.y + 0.5 * x.x * x.x;
        let slope = |x: &Vec3| Vec3::new(1.0 - 4.0 * x.y + x.x, -2.0 - 4.0 * x.x, 2.0 * x.z);
        for (jitter, smoothing) in [(0.0, 1.01), (0.2, 1.2)] {
            let (particles, stencils) = built(jitter, smoothing);
            let error = |consistency| {
                let stencils =
                    Stencils::build(&particles, Kernel::WendlandC2, smoothing, consistency).unwrap();
                worst(&particles, &stencils, field, slope)
            };
            // values of order 5, entries of some 10/dx, moment matrices of condition 1e3
            assert!(worst(&particles, &stencils, field, slope) < 1e-10);
            assert!(error(Consistency::Integration) > 1e-2);
        }
    }

    fn worst(
        particles: &Particles,
        stencils: &Stencils,
        field: impl Fn(&Vec3) -> f64,
        slope: impl Fn(&Vec3) -> Vec3,
    ) -> f64 {
        let error = |a: usize| {
            let row = stencils.row(a);
            let sum = row
                .neighbours
                .iter()
                .zip(row.forward)
                .fold(Vec3::zeros(), |sum, (&b, c)| sum + c * field(&particles.position[b as usize]));
            (sum / particles.volume[a] - slope(&particles.position[a])).amax()
        };
        (0..particles.len()).map(error).fold(0.0, f64::max)
    }

    #[test]
    fn columns_sum_to_the_areas() {
        for (jitter, smoothing) in [(0.0, 1.01), (0.2, 1.2)] {
            let (particles, stencils) = built(jitter, smoothing);
            let area = particles.boundary_area();
            for (a, area) in area.iter().enumerate() {
                let sum: Vec3 = stencils.row(a).backward.iter().sum();
                // what the conjugate gradients leave, in squared spacings
                assert!((sum - area).amax() <= 1e-12 * 0.01);
            }
        }
    }

    #[test]
    fn two_layers_of_particles_are_refused_by_name() {
        let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.5, 0.5, 0.1) };
        let particles = Particles::lattice(&shape, 0.1, [None; 3], 0.0).unwrap();
        let error =
            Stencils::build(&particles, Kernel::WendlandC2, 1.01, Consistency::Quadratic).unwrap_err();
        assert!(matches!(error, DiscretisationError::SingularQuadratics { particle: 0, .. }), "{error}");
    }
}
