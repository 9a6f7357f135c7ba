//! How far a wave may travel in one explicit step.
//!
//! Owns the largest eigenvalue of the discrete wave operators. Knows no material and no time integrator.

use super::lattice::random;
use super::stencil::Stencils;
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;

/// Power iterations: the two largest eigenvalues of a lattice lie within some 1e-2 of each other, and the
/// Rayleigh quotient errs by the square of what is left, below 1 % after this many.
const ITERATIONS: usize = 80;

impl Stencils {
    /// Length a wave may travel in one step of a leapfrog scheme.
    ///
    /// ```text
    /// ℓ = 2/√λ,    λ = largest eigenvalue of u ↦ −(1/V_a) Σ_b V_b S_b G_a(X_b),
    ///              S = GRAD u  and  S = (DIV u) I
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `volume` | `V_a` of the particles the stencils were built from | m³ |
    ///
    /// Returns `ℓ` in m: velocity Verlet of an isotropic linear solid without dissipation is stable for
    /// `c_p Δt ≤ ℓ`. With integration consistency 0.98 spacings in a cube, 0.92 in a strip three nodes
    /// thick, 0.95 to 1.0 in bodies with curved boundaries, less where lattice lines are drawn together.
    /// The first operator is what shear waves see, the second pressure waves, both with unit wave speed;
    /// an isotropic solid is a mean of the two. The eigenvalue comes from a fixed number of power
    /// iterations and may fall short by about one per cent.
    ///
    /// # Panics
    /// If `volume` is shorter than the stencils.
    pub fn stable_length(&self, volume: &[f64]) -> f64 {
        let shear = self.largest_eigenvalue(volume, |gradient| gradient);
        let pressure = self.largest_eigenvalue(volume, |gradient| gradient.trace() * Mat3::identity());
        2.0 / shear.max(pressure).sqrt()
    }

    fn largest_eigenvalue(&self, volume: &[f64], stress: impl Fn(Mat3) -> Mat3 + Sync) -> f64 {
        let mut u: Vec<Vec3> =
            (0..self.len()).map(|a| Vec3::from_fn(|axis, _| random(3 * a + axis))).collect();
        let mut eigenvalue = 0.0;
        for _ in 0..ITERATIONS {
            let force = self.wave_operator(volume, &u, &stress);
            let (mut work, mut mass, mut square) = (0.0, 0.0, 0.0);
            for a in 0..u.len() {
                work += volume[a] * u[a].dot(&force[a]);
                mass += volume[a] * u[a].norm_squared();
                square += volume[a] * force[a].norm_squared();
            }
            eigenvalue = work / mass;
            let scale = 1.0 / square.sqrt();
            u = force.into_iter().map(|f| scale * f).collect();
        }
        eigenvalue
    }

    /// `(1/V_a) Σ_b V_b S_b G_a(X_b)`, the sign that makes it positive.
    fn wave_operator(&self, volume: &[f64], u: &[Vec3], stress: impl Fn(Mat3) -> Mat3 + Sync) -> Vec<Vec3> {
        let gradient = |a: usize| {
            let row = self.row(a);
            let pairs = row.neighbours.iter().zip(row.forward);
            let sum = pairs.fold(Mat3::zeros(), |sum, (&b, g)| sum + (u[b as usize] - u[a]) * g.transpose());
            stress(sum / volume[a])
        };
        let stress: Vec<Mat3> = (0..u.len()).into_par_iter().map(gradient).collect();
        let force = |a: usize| {
            let row = self.row(a);
            let pairs = row.neighbours.iter().zip(row.backward);
            pairs.fold(Vec3::zeros(), |sum, (&b, g)| sum + stress[b as usize] * g) / volume[a]
        };
        (0..u.len()).into_par_iter().map(force).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::{Consistency, Kernel, Particles, Shape};

    /// Largest displacement after 400 leapfrog steps of a random start, waves of unit speed.
    fn grown(stencils: &Stencils, volume: &[f64], step: f64) -> f64 {
        let mut u: Vec<Vec3> = (0..stencils.len()).map(|a| Vec3::from_fn(|i, _| random(3 * a + i))).collect();
        let mut v = vec![Vec3::zeros(); u.len()];
        for _ in 0..400 {
            let force = stencils.wave_operator(volume, &u, |g| g);
            let pressure = stencils.wave_operator(volume, &u, |g| g.trace() * Mat3::identity());
            for a in 0..u.len() {
                // a solid between the two limits
                v[a] -= step * (0.1 * force[a] + 0.9 * pressure[a]);
                u[a] += step * v[a];
            }
        }
        u.iter().map(Vec3::amax).fold(0.0, f64::max)
    }

    #[test]
    fn leapfrog_stays_bounded_below_the_stable_length_and_blows_up_beyond_it() {
        let centre = Vec3::zeros();
        let shapes = [
            Shape::Box { min: centre, max: Vec3::new(1.0, 0.8, 0.6) },
            Shape::Cylinder { centre, axis: 2, radius: 0.5, height: 0.6 },
        ];
        for shape in shapes {
            let particles = Particles::lattice(&shape, 0.1, [None; 3], 0.0).unwrap();
            let stencils =
                Stencils::build(&particles, Kernel::WendlandC2, 1.01, Consistency::Integration).unwrap();
            let length = stencils.stable_length(&particles.volume);
            assert!((0.8..1.5).contains(&(length / particles.spacing)), "{}", length / particles.spacing);
            // translations are free and other modes bounded by their start times a condition number
            assert!(grown(&stencils, &particles.volume, 0.98 * length) < 1e3);
            // the mean of two operators is stable a little longer than the worse of them
            assert!(grown(&stencils, &particles.volume, 1.15 * length) > 1e20);
        }
    }
}
