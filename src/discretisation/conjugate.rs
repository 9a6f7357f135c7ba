//! Conjugate gradients for three right sides at once.
//!
//! Owns the iteration, its fixed order of sums and the functions a system cannot see. Knows no stencil.

use crate::tensor::Vec3;
use rayon::prelude::*;

/// Particles whose partial sums are added before those of the next ones: a fixed order on any number of
/// threads.
const CHUNK: usize = 1024;

/// A symmetric operator, the same for each of the three components, positive but for the functions in
/// [`System::null`].
pub(super) trait System {
    /// The operator on a field.
    fn apply(&self, field: &[Vec3]) -> Vec<Vec3>;

    /// An approximate inverse on a residual; symmetric and positive.
    fn precondition(&self, residual: &[Vec3]) -> Vec<Vec3>;

    /// Orthonormal functions of the particles that the operator maps to zero.
    fn null(&self) -> &[Vec<f64>];
}

/// Solves `K φ = residual` by preconditioned conjugate gradients, each component with its own step, and
/// returns `φ` and the iterations spent. Ends where the norm of each component is at most `tolerance`, or
/// after `most` iterations.
pub(super) fn solve(
    system: &impl System,
    mut residual: Vec<Vec3>,
    tolerance: f64,
    most: usize,
) -> (Vec<Vec3>, usize) {
    remove(system.null(), &mut residual);
    let mut phi = vec![Vec3::zeros(); residual.len()];
    let small = tolerance * tolerance;
    let mut z = system.precondition(&residual);
    let mut direction = z.clone();
    let mut rho = inner(&residual, &z);
    for iteration in 0..most {
        let norm = inner(&residual, &residual);
        if (0..3).all(|i| norm[i] <= small) {
            return (phi, iteration);
        }
        let image = system.apply(&direction);
        let curvature = inner(&direction, &image);
        // a component that is done has neither residual nor curvature left
        let step = Vec3::from_fn(|i, _| if norm[i] <= small { 0.0 } else { rho[i] / curvature[i] });
        for a in 0..phi.len() {
            phi[a] += step.component_mul(&direction[a]);
            residual[a] -= step.component_mul(&image[a]);
        }
        remove(system.null(), &mut residual);
        z = system.precondition(&residual);
        let next = inner(&residual, &z);
        let turn = Vec3::from_fn(|i, _| if rho[i] == 0.0 { 0.0 } else { next[i] / rho[i] });
        rho = next;
        for (d, z) in direction.iter_mut().zip(&z) {
            *d = z + turn.component_mul(d);
        }
    }
    (phi, most)
}

/// Removes the part that rounding brings in and the system cannot see.
fn remove(null: &[Vec<f64>], field: &mut [Vec3]) {
    for basis in null {
        let sum = chunked(field.len(), |a| field[a] * basis[a]);
        for (x, &b) in field.iter_mut().zip(basis) {
            *x -= b * sum;
        }
    }
}

/// Inner products of two fields, one of each component.
fn inner(x: &[Vec3], y: &[Vec3]) -> Vec3 {
    chunked(x.len(), |a| x[a].component_mul(&y[a]))
}

/// Sum over particles, in chunks of a fixed size.
fn chunked(len: usize, term: impl Fn(usize) -> Vec3 + Sync) -> Vec3 {
    let partial = |chunk: usize| {
        (chunk * CHUNK..((chunk + 1) * CHUNK).min(len)).fold(Vec3::zeros(), |sum, a| sum + term(a))
    };
    let partial: Vec<Vec3> = (0..len.div_ceil(CHUNK)).into_par_iter().map(partial).collect();
    partial.iter().sum()
}
