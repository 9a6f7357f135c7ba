//! Second-order gradients: exact for quadratic fields, and integrating linear stresses by parts.
//!
//! Owns the correction and its constraints. Knows neither the lattice nor what the gradients are used for.
//!
//! As in [`super::integration`], `C_ab = V_a G_b(X_a)`. Rows are made exact for the nine monomials
//! `p(X_b − X_a)` of first and second degree; columns, the force of a stress, for linear stresses:
//!
//! ```text
//! Σ_b C_ab = 0,            Σ_b C_ab p(X_b − X_a) = V_a Grad p(0),
//! Σ_b C_ba = A_a N_a,      Σ_b C_ba ⊗ (X_b − X_a) = B_aᵀ − V_a I,
//! ```
//!
//! by the `δ` of least `½ Σ_{a≠b} |δ_ab|²/w_ab`, `δ_aa = −Σ_{b≠a} δ_ab`; its multipliers and their system are in
//! [`super::columns`]. There is a `δ` only if volumes, areas and their first moments `B_a` integrate quadratic
//! fields, which [`Particles::integrate_quadratics`] makes them do: summation by parts asks the same of its weights
//! (Kreiss & Scherer 1974). With the trapezium rule's, differences that integrate by parts are of first
//! order at a boundary, and so are stresses; and a column that misses its first moment, as it does at every
//! displaced node, errs by its share of the gradient of the stress.
//!
//! Sums hold to round-off, so that a uniform stress is in equilibrium with its tractions. First moments are taken
//! care of before, to about a hundredth of what they missed; where a body has none, at curved faces, sums alone.

use super::coarse::{self, Coarse};
use super::columns::{Columns, MOMENTS, SUMS, arm};
use super::conjugate;
use super::error::DiscretisationError;
use super::integration::{self, Columns as _};
use super::kernel::Kernel;
use super::moments::{Basis, QUADRATIC, inverse};
use super::neighbour::Neighbours;
use super::particles::Particles;
use crate::tensor::{Mat3, Vec3};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

/// Kernel that weighs a change reaches this much farther than the one of the gradients, so that neighbours
/// at the edge of the list, which second derivatives need, are not ruled out.
const REACH: f64 = 1.5;

/// Where sums and first moments are near enough, the root of the sum of squares over particles in squared spacings.
const MOMENT_TOLERANCE: f64 = 1e-6;

/// Most iterations for them: what is left after these is smooth, and smooth errors cost no order.
const MOMENT_ITERATIONS: usize = 100;

type Moments = SMatrix<f64, QUADRATIC, QUADRATIC>;
pub(super) type Monomials = SVector<f64, QUADRATIC>;
pub(super) type Fit = SMatrix<f64, 3, QUADRATIC>;

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
    let coarse = Coarse::new(rows.position, particles.spacing, &rows);
    if !particles.first_moment.is_empty() {
        let missing = rows.missing_moments(particles, reverse, forward);
        let system = Columns::<MOMENTS>::new(&rows, coarse.as_ref());
        let tolerance = MOMENT_TOLERANCE * particles.spacing * particles.spacing;
        let (field, _) = conjugate::solve(&system, missing, tolerance, MOMENT_ITERATIONS);
        system.correct(&field, forward);
        // large multipliers leave rounding behind
        rows.complete(&particles.volume, forward);
    }
    integration::meet(&Columns::<SUMS>::new(&rows, coarse.as_ref()), particles, list, reverse, forward)
}

/// Weights and moments of all rows.
pub(super) struct Rows<'a> {
    pub list: &'a Neighbours,
    pub position: &'a [Vec3],
    basis: Basis,
    /// `w_ab` of each entry, m³; zero for `b = a`, which drops out.
    pub weight: Vec<f64>,
    /// `(Σ_b w_ab p pᵀ)⁻¹`, m⁻³.
    pub inverse_moment: Vec<Moments>,
    /// Quadratic functions, orthonormal on the particles.
    pub null: Vec<Vec<f64>>,
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
    pub fn monomials(&self, a: usize, entry: usize) -> Monomials {
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

    /// What the columns miss of their sums and of their first moments, four a particle, m².
    fn missing_moments(&self, particles: &Particles, reverse: &[u32], forward: &[Vec3]) -> Vec<Vec3> {
        let area = particles.boundary_area();
        let missing = |a: usize| {
            let moment = self.basis.inverse_length
                * (particles.first_moment[a].transpose() - particles.volume[a] * Mat3::identity());
            let mut missing =
                [area[a], moment.column(0).into(), moment.column(1).into(), moment.column(2).into()];
            for entry in self.list.range(a) {
                let arm = arm::<MOMENTS>(&self.monomials(a, entry));
                for (missing, arm) in missing.iter_mut().zip(&arm) {
                    *missing -= *arm * forward[reverse[entry] as usize];
                }
            }
            missing
        };
        (0..area.len()).into_par_iter().flat_map_iter(missing).collect()
    }

    /// Adds `w_ab` times something to the entries of row `a` and takes its sum from the row's own entry.
    pub fn add(&self, a: usize, forward: &mut [Vec3], delta: impl Fn(usize, &Monomials) -> Vec3) {
        let (mut own, mut sum) = (0, Vec3::zeros());
        for entry in self.list.range(a) {
            if self.list.neighbour[entry] as usize == a {
                own = entry;
                continue;
            }
            let delta = self.weight[entry] * delta(entry, &self.monomials(a, entry));
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

#[cfg(test)]
mod tests {
    use crate::discretisation::{Consistency, DiscretisationError, Kernel, Particles, Shape, Stencils};
    use crate::tensor::{Mat3, Vec3};

    fn built(jitter: f64, smoothing: f64) -> (Particles, Stencils) {
        let shape = Shape::Box { min: Vec3::new(-0.1, 0.0, 0.2), max: Vec3::new(0.9, 0.6, 0.6) };
        let mut particles = Particles::lattice(&shape, 0.1, [None, Some(0.2), None], jitter).unwrap();
        particles.integrate_quadratics().unwrap();
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
    fn columns_are_exact_for_linear_stresses_to_a_hundredth() {
        for (jitter, smoothing) in [(0.0, 1.2), (0.2, 1.2)] {
            let (particles, stencils) = built(jitter, smoothing);
            let missed = |stencils: &Stencils| {
                let square = |a: usize| {
                    let row = stencils.row(a);
                    let moment =
                        row.neighbours.iter().zip(row.backward).fold(Mat3::zeros(), |sum, (&b, c)| {
                            sum + c * (particles.position[b as usize] - particles.position[a]).transpose()
                        });
                    let target =
                        particles.first_moment[a].transpose() - particles.volume[a] * Mat3::identity();
                    (moment - target).norm_squared()
                };
                (0..particles.len()).map(square).sum::<f64>().sqrt() / 0.1_f64.powi(3)
            };
            let linear =
                Stencils::build(&particles, Kernel::WendlandC2, smoothing, Consistency::Integration).unwrap();
            let (missed, before) = (missed(&stencils), missed(&linear));
            assert!(missed < 0.01 * before, "{missed} of {before}");
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
