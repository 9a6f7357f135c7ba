//! Gradients that belong to the centroids of the nodes' hats.
//!
//! Owns where the gradient of a node is evaluated and the rows that are exact there. Knows neither the lattice nor what
//! the gradients are used for.
//!
//! The energy of a body is a sum over its nodes, `Σ_a V_a f_a` with `V_a = ∫ N_a dV`. With `f_a = f(X_a)` it is the
//! trapezium rule: a bar of `n` cells across is `1 + 2/n²` as stiff in bending as it should be. With the one-sided rows
//! of a boundary, which see second-degree fields a quarter of a spacing inside, it is too soft instead. In between,
//! with the centroid of the hat
//!
//! ```text
//! X_a + c_a,    c_a = 1/V_a ∫ N_a (X − X_a) dV,
//! ```
//!
//! half of the way is exact to second order: hats reproduce linear fields, so for `f` of second degree with `f'' = K`
//!
//! ```text
//! ∫ f dV = Σ_a ∫ N_a [f(X_a) + f'(X_a)·(X − X_a) + ½ K : (X − X_a) ⊗ (X − X_a)] dV
//!        = Σ_a V_a [f(X_a) + ½ f'(X_a)·c_a]  =  Σ_a V_a [f(X_a + ½c_a) − ⅛ c_a·K c_a],
//! ```
//!
//! the second line because `Σ_a N_a(X) (X_a − X) = 0` makes `Σ_a ∫ N_a f'(X_a)·(X − X_a) dV` the negative of twice the
//! term of `K`. Rows keep constants and linear fields, and of second-degree `q` they are made to satisfy
//!
//! ```text
//! Σ_b C_ab q(X_b − X_a) = V_a Grad q(½c_a)
//! ```
//!
//! by the `δ` of least `½ Σ_{a≠b} |δ_ab|²/w_ab`, the `C` and `w` of [`super::integration`], as far as the neighbours tell
//! second-degree fields well from linear ones: behind a face all but the square of the depth, which next to nothing but two
//! layers of particles weighs in. (Rows exact for that as well reach for the third layer: a fifth of the interface areas is
//! then below zero and the step a fifth shorter, for nothing gained in bending.) Inside a lattice nothing changes; a node of a
//! plane face is evaluated a sixth of a spacing inside.
//!
//! A plane of symmetry is no boundary: its nodes have half of a hat whose other half is the mirror image, and `c_a` is that
//! of both, in the plane.

use super::error::DiscretisationError;
use super::grid::cell_hats;
use super::integration;
use super::kernel::Kernel;
use super::moments::inverse;
use super::neighbour::Neighbours;
use super::particles::Particles;
use crate::tensor::{Mat3, Vec3};
use nalgebra::{SMatrix, SVector, SymmetricEigen};
use rayon::prelude::*;

/// Monomials of second degree.
const SECOND: usize = 6;

/// Moments of second-degree fields, less their linear part, are told apart above this share of the mean moment. On
/// lattices with `h/dx` from 1.01 to 1.5 the square of the depth behind a face has at most 0.13, all else at least 0.24;
/// with two layers of particles it has none.
const TOLD_APART: f64 = 0.15;

type Square = SMatrix<f64, SECOND, SECOND>;
type Quadratic = SVector<f64, SECOND>;
type Mixed = SMatrix<f64, 3, SECOND>;

/// The products `d_i d_j`, those of two components with `√2`: rotations of `d` are rotations of these.
fn products(d: &Vec3) -> Quadratic {
    let r = std::f64::consts::SQRT_2;
    Quadratic::from([d.x * d.x, d.y * d.y, d.z * d.z, r * d.x * d.y, r * d.y * d.z, r * d.z * d.x])
}

/// Their gradients at `d`, one a column.
fn slopes(d: &Vec3) -> Mixed {
    let r = std::f64::consts::SQRT_2;
    Mixed::from_columns(&[
        Vec3::new(2.0 * d.x, 0.0, 0.0),
        Vec3::new(0.0, 2.0 * d.y, 0.0),
        Vec3::new(0.0, 0.0, 2.0 * d.z),
        r * Vec3::new(d.y, d.x, 0.0),
        r * Vec3::new(0.0, d.z, d.y),
        r * Vec3::new(d.z, 0.0, d.x),
    ])
}

/// `c_a` of every node, m; in planes of symmetry along them.
pub(super) fn offsets(particles: &Particles) -> Vec<Vec3> {
    let moments = |cell: &[u32; 8]| {
        let corner = cell.map(|a| particles.position[a as usize]);
        let mut moment = [Vec3::zeros(); 8];
        for (hats, x, volume) in points(&corner) {
            for ((moment, hat), at) in moment.iter_mut().zip(hats).zip(&corner) {
                *moment += (volume * hat) * (x - at);
            }
        }
        moment
    };
    let moments: Vec<[Vec3; 8]> = particles.cells.par_iter().map(moments).collect();
    let mut offset = vec![Vec3::zeros(); particles.len()];
    for (cell, moment) in particles.cells.iter().zip(moments) {
        for (&a, moment) in cell.iter().zip(moment) {
            offset[a as usize] += moment;
        }
    }
    for (offset, volume) in offset.iter_mut().zip(&particles.volume) {
        *offset /= *volume;
    }
    for (axis, name) in ["symmetry_x", "symmetry_y", "symmetry_z"].into_iter().enumerate() {
        for &a in particles.face(name).map_or(&[][..], |face| &face.nodes) {
            offset[a as usize][axis] = 0.0;
        }
    }
    offset
}

/// Gauss points of a cell: its hats, the place and the volume each stands for.
fn points(corner: &[Vec3; 8]) -> impl Iterator<Item = ([f64; 8], Vec3, f64)> + '_ {
    // three points are exact to degree 5; hats times places times the map are of degree 4 in each variable
    const RULE: [(f64, f64); 3] =
        [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];
    (0..27).map(move |point| {
        let [(x, u), (y, v), (z, w)] = [RULE[point % 3], RULE[point / 3 % 3], RULE[point / 9]];
        let (hats, determinant) = cell_hats(corner, [x, y, z]);
        let place = corner.iter().zip(hats).fold(Vec3::zeros(), |sum, (x, hat)| sum + hat * x);
        (hats, place, u * v * w * determinant)
    })
}

/// Corrects `forward`, the entries `V_a G_b(X_a)`, as the module says.
///
/// # Errors
/// [`DiscretisationError::SingularMoments`].
pub(super) fn impose(
    particles: &Particles,
    kernel: Kernel,
    h: f64,
    list: &Neighbours,
    forward: &mut [Vec3],
) -> Result<(), DiscretisationError> {
    let rows = Rows { particles, list, weight: integration::weights(particles, kernel, h, list) };
    let offset = offsets(particles);
    let before = &*forward;
    let corrected: Result<Vec<Vec<Vec3>>, DiscretisationError> =
        (0..particles.len()).into_par_iter().map(|a| rows.corrected(a, &offset[a], before)).collect();
    forward.iter_mut().zip(corrected?.into_iter().flatten()).for_each(|(entry, new)| *entry = new);
    Ok(())
}

/// What the rows are corrected with.
struct Rows<'a> {
    particles: &'a Particles,
    list: &'a Neighbours,
    /// `w_ab` of each entry, m³; zero for `b = a`, which drops out.
    weight: Vec<f64>,
}

impl Rows<'_> {
    /// `X_b − X_a` of an entry, in spacings.
    fn distance(&self, a: usize, entry: usize) -> Vec3 {
        let position = &self.particles.position;
        (position[self.list.neighbour[entry] as usize] - position[a]) / self.particles.spacing
    }

    /// The entries of row `a`, exact for second-degree fields half-way to the centroid `offset`.
    fn corrected(&self, a: usize, offset: &Vec3, before: &[Vec3]) -> Result<Vec<Vec3>, DiscretisationError> {
        let range = self.list.range(a);
        let (mut linear, mut mixed, mut second) = (Mat3::zeros(), Mixed::zeros(), Square::zeros());
        let scale = self.particles.spacing;
        let mut missing = (self.particles.volume[a] / scale) * slopes(&(offset * (0.5 / scale)));
        for entry in range.clone() {
            let (w, d) = (self.weight[entry], self.distance(a, entry));
            let q = products(&d);
            linear += (w * d) * d.transpose();
            mixed += (w * d) * q.transpose();
            second += (w * q) * q.transpose();
            missing -= before[entry] * q.transpose();
        }
        let singular = || DiscretisationError::SingularMoments {
            particle: a,
            position: self.particles.position[a],
            neighbours: range.len(),
        };
        let onto_linear = inverse(&linear).ok_or_else(singular)? * mixed;
        let curved = second - mixed.transpose() * onto_linear;
        let fit = missing * pseudo_inverse(curved, TOLD_APART * second.trace() / SECOND as f64);
        let slope = fit * onto_linear.transpose();
        let mut row = before[range.clone()].to_vec();
        let (mut own, mut sum) = (0, Vec3::zeros());
        for (place, entry) in range.enumerate() {
            if self.list.neighbour[entry] as usize == a {
                own = place;
                continue;
            }
            let d = self.distance(a, entry);
            let delta = self.weight[entry] * (fit * products(&d) - slope * d);
            row[place] += delta;
            sum += delta;
        }
        row[own] -= sum;
        Ok(row)
    }
}

/// Inverse of a symmetric matrix within the eigenvectors whose eigenvalues exceed `least`.
fn pseudo_inverse(matrix: Square, least: f64) -> Square {
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(matrix);
    (0..SECOND).filter(|&i| eigenvalues[i] > least).fold(Square::zeros(), |sum, i| {
        let vector = eigenvectors.column(i);
        sum + (vector / eigenvalues[i]) * vector.transpose()
    })
}

#[cfg(test)]
mod tests;
