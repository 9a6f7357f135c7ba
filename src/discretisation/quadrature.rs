//! Nodal volumes and areas that integrate quadratic fields exactly.
//!
//! Owns the correction of the background grid's integrals. Knows no kernel.
//!
//! Hats `N_a` reproduce linear fields. Of a quadratic `f` with second derivatives `K` the interpolant errs by
//!
//! ```text
//! Σ_a N_a(X) f(X_a) − f(X) = ½ K : S(X),    S(X) = Σ_a N_a(X) (X_a − X) ⊗ (X_a − X),
//! ```
//!
//! so with `K_a`, the share of node `a` in a least-squares fit of second derivatives from the nodes round the
//! cell, the functions `Ñ_a = N_a − ½ K_a : S` reproduce quadratic fields, and
//!
//! ```text
//! V_a = ∫ Ñ_a dV,    A_a N_a = ∮ Ñ_a N dS,    B_a = ∮ Ñ_a (X − X_a) ⊗ N dS
//! ```
//!
//! satisfy `Σ_a V_a f(X_a) = ∫ f dV` and `Σ_a f(X_a) A_a N_a = ∮ f N dS` for quadratic `f`: behind a plane face of a
//! lattice the layers have Gregory's 3/8, 7/6, 23/24, 1 of a cell instead of the trapezium rule's 1/2, 1, 1, 1. They
//! are what gradients and their columns can both be of second order with.
//!
//! The fit on a face uses its own nodes, so no traction acts inside; a face of several planes that meet at edges, as
//! the inner one of an L, is fitted plane by plane. The nodes of a curved face do not tell second derivatives along
//! it from its curvature: a body that has one keeps the integrals of its hats.

mod patch;

use super::error::DiscretisationError;
use super::grid::{cell_hats, quad_hats};
use super::particles::{Bulge, FaceNodes, Particles};
use crate::tensor::{Mat3, Vec3};
use nalgebra::{SMatrix, SVector};
use patch::Patch;
use rayon::prelude::*;

/// Three-point Gauss rule, exact to degree 5: quadratic fields on trilinear cells are of degree 4 in each variable.
const RULE: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// Products of powers 0, 1, 2 of the coordinates of space, and of a plane: as they are products, so are
/// the weights of a lattice, and those of edges and corners are positive with those of faces.
const SPACE: usize = 27;
const PLANE: usize = 9;

/// The monomials of second degree among those, with the coordinates they are products of.
const SECOND: [(usize, (usize, usize)); 6] =
    [(2, (0, 0)), (6, (1, 1)), (18, (2, 2)), (4, (0, 1)), (12, (1, 2)), (10, (0, 2))];

impl Particles {
    /// Replaces volumes and areas by such that integrate quadratic fields, and finds the first moments of areas.
    ///
    /// A body with a curved face, or so distorted that a volume would not be positive, keeps its volumes and has
    /// no first moments; of its areas only the balance is mended.
    ///
    /// # Errors
    /// [`DiscretisationError::SingularQuadratics`] if the nodes round a cell do not tell products of quadratics
    /// apart.
    pub fn integrate_quadratics(&mut self) -> Result<(), DiscretisationError> {
        let patches: Option<Vec<Vec<Patch>>> =
            self.faces.iter().map(|face| patch::planes(face, &self.position)).collect();
        if let Some(patches) = patches {
            let volume = self.quadratic_volumes()?;
            if volume.iter().all(|&v| v > 0.0) && self.integrate_faces(&patches) {
                self.volume = volume;
            }
        }
        self.balance_second_moments();
        Ok(())
    }

    /// `V_a = ∫ Ñ_a dV`.
    fn quadratic_volumes(&self) -> Result<Vec<f64>, DiscretisationError> {
        let rings = Rings::new(&self.cells, self.len());
        let cell = |cell: &[u32; 8]| {
            let corner = cell.map(|a| self.position[a as usize]);
            let frame = self.frame(&corner, Mat3::identity());
            let ring = rings.around(cell, &self.cells);
            match self.shares(&ring, &frame, &cell_excess(&corner, &frame)) {
                Some(shares) => Ok((ring, shares)),
                None => Err(self.singular(cell, &ring)),
            }
        };
        let corrections: Vec<_> = self.cells.par_iter().map(cell).collect();
        let mut volume = self.volume.clone();
        for correction in corrections {
            let (ring, shares) = correction?;
            for (a, share) in ring.into_iter().zip(shares) {
                volume[a as usize] -= share[0];
            }
        }
        Ok(volume)
    }

    /// `A_a N_a = ∮ Ñ_a N dS` of every face, and `B_a`; nothing changes, and it is told, where the nodes of a plane do
    /// not tell products of quadratics apart.
    fn integrate_faces(&mut self, patches: &[Vec<Patch>]) -> bool {
        let mut moment = vec![Mat3::zeros(); self.len()];
        let mut integrated = Vec::new();
        for (face, patches) in self.faces.iter().zip(patches) {
            let mut face = face.clone();
            for patch in patches {
                if self.patch_integrals(patch, &mut face, &mut moment).is_none() {
                    return false;
                }
            }
            integrated.push(face);
        }
        self.faces = integrated;
        self.first_moment = moment;
        true
    }

    fn frame(&self, corner: &[Vec3], axes: Mat3) -> Frame {
        let origin = corner.iter().sum::<Vec3>() / corner.len() as f64;
        Frame { origin, axes, scale: 1.0 / self.spacing }
    }

    fn singular(&self, cell: &[u32], ring: &[u32]) -> DiscretisationError {
        let particle = cell[0] as usize;
        DiscretisationError::SingularQuadratics {
            particle,
            position: self.position[particle],
            neighbours: ring.len(),
        }
    }

    /// Changes the areas of a plane's nodes, which are among those of its face, finds its bulges and adds its share
    /// of the first moments.
    fn patch_integrals(
        &self,
        Patch { normal, quads }: &Patch,
        face: &mut FaceNodes,
        moment: &mut [Mat3],
    ) -> Option<()> {
        let rings = Rings::new(quads, self.len());
        let along = normal.cross(&Vec3::ith(normal.iamin(), 1.0)).normalize();
        let axes =
            Mat3::from_rows(&[along.transpose(), normal.cross(&along).transpose(), normal.transpose()]);
        for quad in quads {
            let corner = quad.map(|a| self.position[a as usize]);
            for (x, hats, normal) in quad_points(&corner) {
                for (&a, hat) in quad.iter().zip(hats) {
                    moment[a as usize] += (x - self.position[a as usize]) * (hat * normal).transpose();
                }
            }
            let frame = self.frame(&corner, axes);
            let ring = rings.around(quad, quads);
            let shares = self.shares(&ring, &frame, &quad_excess(&corner, &frame))?;
            let size = 0.5 * (corner[2] - corner[0]).cross(&(corner[3] - corner[1])).norm();
            let bulge = ring.iter().zip(&shares).map(|(&a, share)| (a, share[0] / size)).collect();
            face.bulges.push(Bulge { quad: *quad, shares: bulge });
            for (a, share) in ring.into_iter().zip(shares) {
                let node = face.nodes.partition_point(|&node| node < a);
                face.area[node] -= share[0] * normal;
                let place = self.position[a as usize] - frame.origin;
                let first = share.fixed_rows::<3>(1) - share[0] * place;
                moment[a as usize] -= first * normal.transpose();
            }
        }
        Some(())
    }

    /// What each node of a ring takes of the excess of the monomials: `w_a p(X_a)ᵀ M⁻¹ s`, a column each.
    fn shares<const M: usize, const R: usize>(
        &self,
        ring: &[u32],
        frame: &Frame,
        excess: &SMatrix<f64, M, R>,
    ) -> Option<Vec<SVector<f64, R>>> {
        let terms: Vec<(f64, SVector<f64, M>)> = ring
            .iter()
            .map(|&a| {
                let d = frame.local(&self.position[a as usize]);
                let near = 1.0 + d.norm_squared();
                (1.0 / (near * near), monomials(&d))
            })
            .collect();
        let mut moment = SMatrix::<f64, M, M>::zeros();
        for (w, p) in &terms {
            moment.ger(*w, p, p, 1.0);
        }
        let coefficients = moment.cholesky()?.solve(excess);
        Some(terms.iter().map(|(w, p)| coefficients.tr_mul(p) * *w).collect())
    }
}

/// Coordinates round a cell in spacings.
#[derive(Clone, Copy)]
struct Frame {
    origin: Vec3,
    /// Axes, a row each.
    axes: Mat3,
    scale: f64,
}

impl Frame {
    fn local(&self, x: &Vec3) -> Vec3 {
        self.axes * (x - self.origin) * self.scale
    }
}

/// The products of powers, the first coordinate fastest.
fn monomials<const M: usize>(d: &Vec3) -> SVector<f64, M> {
    let power = |x: f64, n: usize| [1.0, x, x * x][n];
    SVector::from_fn(|m, _| power(d.x, m % 3) * power(d.y, m / 3 % 3) * power(d.z, m / 9))
}

/// `∫ S dV` of a cell by the monomials of second degree, m³.
fn cell_excess(corner: &[Vec3; 8], frame: &Frame) -> SVector<f64, SPACE> {
    let mut excess = SVector::zeros();
    for (i, wi) in RULE {
        for (j, wj) in RULE {
            for (k, wk) in RULE {
                let (hats, determinant) = cell_hats(corner, [i, j, k]);
                excess += (wi * wj * wk * determinant) * interpolation_excess(corner, &hats, frame);
            }
        }
    }
    excess
}

/// `∫ S dS` and `∫ S (X − X_c) dS` of a plane quadrilateral, m² and m³.
fn quad_excess(corner: &[Vec3; 4], frame: &Frame) -> SMatrix<f64, PLANE, 4> {
    let mut excess = SMatrix::zeros();
    for (x, hats, normal) in quad_points(corner) {
        let d = x - frame.origin;
        let weight = normal.norm() * nalgebra::RowVector4::new(1.0, d.x, d.y, d.z);
        excess += interpolation_excess::<PLANE>(corner, &hats, frame) * weight;
    }
    excess
}

/// Gauss points of a quadrilateral: place, hats, area.
fn quad_points(corner: &[Vec3; 4]) -> impl Iterator<Item = (Vec3, [f64; 4], Vec3)> + '_ {
    RULE.iter().flat_map(move |&(i, wi)| {
        RULE.iter().map(move |&(j, wj)| {
            let (hats, normal) = quad_hats(corner, [i, j]);
            (place(corner, &hats), hats, wi * wj * normal)
        })
    })
}

/// `Σ_a N_a X_a`.
fn place(corner: &[Vec3], hats: &[f64]) -> Vec3 {
    corner.iter().zip(hats).fold(Vec3::zeros(), |sum, (x, hat)| sum + *hat * x)
}

/// By how much the interpolant of each monomial of second degree exceeds it at a point: `S`.
fn interpolation_excess<const M: usize>(corner: &[Vec3], hats: &[f64], frame: &Frame) -> SVector<f64, M> {
    let x = frame.local(&place(corner, hats));
    let mut excess = SVector::zeros();
    for (at, hat) in corner.iter().zip(hats) {
        let d = frame.local(at) - x;
        for (m, (i, j)) in SECOND {
            if m < M {
                excess[m] += hat * d[i] * d[j];
            }
        }
    }
    excess
}

/// Nodes of the cells, or quadrilaterals, that share a node with one.
struct Rings {
    start: Vec<u32>,
    member: Vec<u32>,
}

impl Rings {
    fn new<const N: usize>(cells: &[[u32; N]], nodes: usize) -> Self {
        let mut start = vec![0u32; nodes + 1];
        for &a in cells.iter().flatten() {
            start[a as usize + 1] += 1;
        }
        for a in 0..nodes {
            start[a + 1] += start[a];
        }
        let mut next = start.clone();
        let mut member = vec![0; N * cells.len()];
        for (cell, nodes) in cells.iter().enumerate() {
            for &a in nodes {
                member[next[a as usize] as usize] = cell as u32;
                next[a as usize] += 1;
            }
        }
        Self { start, member }
    }

    fn around<const N: usize>(&self, cell: &[u32; N], cells: &[[u32; N]]) -> Vec<u32> {
        let mut ring: Vec<u32> = cell
            .iter()
            .flat_map(|&a| &self.member[self.start[a as usize] as usize..self.start[a as usize + 1] as usize])
            .flat_map(|&cell| cells[cell as usize])
            .collect();
        ring.sort_unstable();
        ring.dedup();
        ring
    }
}

#[cfg(test)]
mod tests;
