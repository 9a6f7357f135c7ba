//! Tangents of a block of particles, lane by lane.
//!
//! Owns what [`super::tangent`] owns for one state, for sixteen at once: gradients and curvatures of
//! the raw invariants, summed into one triangle of `∂²ψ/∂F∂F`.

#![expect(clippy::needless_range_loop, reason = "one lane index runs through many rows")]

use super::kinematics::Block;
use super::lanes::{Tensor, Vector, ZERO};
use super::law::{Law, Scratch};
use super::program::{LANES, Row};
use super::raw::Raw;
use super::tangent::Kink;
use super::trace::pair;
use crate::tensor::{Mat3, Vec3};

/// Upper triangle of a symmetric 9 × 9 tensor, place of `(p, q)`, `p <= q`.
pub(super) const fn place(p: usize, q: usize) -> usize {
    q * (q + 1) / 2 + p
}

/// A symmetric 3 × 3 tensor: 00, 01, 11, 02, 12, 22.
pub(super) type Symmetric = [Row; 6];

/// Tangents of a block, one triangle.
#[derive(Debug, Clone)]
pub(super) struct Tangents([Row; 45]);

impl Default for Tangents {
    fn default() -> Self {
        Self([ZERO; 45])
    }
}

impl Law {
    /// Whether the tangents are made lane by lane.
    pub(super) fn has_tangents_by_lanes(&self) -> bool {
        self.raws.iter().all(|raw| !matches!(raw, Raw::Stretch(_) | Raw::Fifth(_) | Raw::I2))
    }

    #[inline(always)]
    pub(super) fn tangents(&self, scratch: &mut Scratch) {
        let Scratch { rows, block, tangents, .. } = scratch;
        let program = &self.hessians[1];
        let outputs = program.outputs();
        let (first, second) = outputs.split_at(self.raws.len());
        *tangents = Tangents::default();
        for (&raw, &register) in self.raws.iter().zip(first) {
            tangents.add_curvature(raw, &rows[register as usize], block);
        }
        for (k, &raw) in self.raws.iter().enumerate() {
            let Some(gradient) = block.gradient(raw) else { continue };
            // G_k ⊗ (½ h_kk G_k + Σ_{l>k} h_kl G_l), made symmetric
            let mut partner = [ZERO; 9];
            for (l, &other) in self.raws.iter().enumerate().skip(k) {
                if program.is_zero(self.raws.len() + pair(k, l)) {
                    continue;
                }
                let Some(column) = block.gradient(other) else { continue };
                let row = &rows[second[pair(k, l)] as usize];
                let half = if k == l { 0.5 } else { 1.0 };
                for (to, from) in partner.iter_mut().zip(&column) {
                    for lane in 0..LANES {
                        to[lane] += half * row[lane] * from[lane];
                    }
                }
            }
            tangents.add_symmetric(&gradient, &partner);
        }
    }

    /// Laws of stretches, areas or fifth invariants: the scalar tangent, particle by particle.
    pub(super) fn tangents_one_by_one(&self, scratch: &mut Scratch) {
        for lane in 0..LANES {
            let f = Mat3::from_fn(|i, j| scratch.block.f[i + 3 * j][lane]);
            let directions: Vec<Vec3> =
                (0..self.directions()).map(|index| scratch.block.direction(index, lane)).collect();
            let tangent = self.tangent(&f, &directions, Kink::Taut);
            for q in 0..9 {
                for p in 0..=q {
                    scratch.tangents.0[place(p, q)][lane] = tangent[(p, q)];
                }
            }
        }
    }
}
impl Tangents {
    /// Adds `d ∂²I/∂F∂F`.
    #[inline(always)]
    fn add_curvature(&mut self, raw: Raw, d: &Row, block: &Block) {
        match raw {
            Raw::I1 => {
                for p in 0..9 {
                    add(&mut self.0[place(p, p)], d, &[2.0; LANES]);
                }
            }
            Raw::J => {
                // ∂²J/∂F_iI∂F_jJ = ε_ijk ε_IJK F_kK
                for (column, row) in (0..3).flat_map(|column| (0..3).map(move |row| (column, row))) {
                    let at = |c: usize, r: usize| (row + r) % 3 + 3 * ((column + c) % 3);
                    let f = &block.f[row + 3 * column];
                    add(&mut self.0[ordered(at(1, 1), at(2, 2))], d, f);
                    add(&mut self.0[ordered(at(1, 2), at(2, 1))], &d.map(|d| -d), f);
                }
            }
            Raw::Fourth(a) => {
                let a = block.rows_of(a);
                self.add_lines(&d.map(|d| 2.0 * d), a, a);
            }
            Raw::Eighth(a, b) => {
                let (a, b) = (block.rows_of(a), block.rows_of(b));
                self.add_lines(d, a, b);
                self.add_lines(d, b, a);
            }
            Raw::Metric(i, j) => {
                let (i, j) = (usize::from(i), usize::from(j));
                for row in 0..3 {
                    let factor = if i == j { 2.0 } else { 1.0 };
                    add(&mut self.0[ordered(row + 3 * i, row + 3 * j)], d, &[factor; LANES]);
                }
            }
            Raw::I2 | Raw::Fifth(_) | Raw::Stretch(_) | Raw::Dot(..) | Raw::Component(..) => {}
        }
    }

    /// Adds `d δ_ij a_I b_J` to the triangle; both orders of `a ≠ b` must be added.
    #[inline(always)]
    fn add_lines(&mut self, d: &Row, a: &Vector, b: &Vector) {
        for j in 0..3 {
            for i in 0..=j {
                let mut product = ZERO;
                for lane in 0..LANES {
                    product[lane] = a[i][lane] * b[j][lane];
                }
                for row in 0..3 {
                    add(&mut self.0[place(row + 3 * i, row + 3 * j)], d, &product);
                }
            }
        }
    }

    #[inline(always)]
    fn add_symmetric(&mut self, x: &Tensor, y: &Tensor) {
        for q in 0..9 {
            for p in 0..=q {
                let to = &mut self.0[place(p, q)];
                for lane in 0..LANES {
                    to[lane] += x[p][lane] * y[q][lane] + x[q][lane] * y[p][lane];
                }
            }
        }
    }

    /// `Q_ij = N_I N_J A_iIjJ`, or with `polarised` `R_IJ = n_i n_j A_iIjJ`.
    #[inline(always)]
    pub(super) fn contracted(&self, n: &Vector, polarised: bool) -> Symmetric {
        let at = |free: usize, bound: usize| if polarised { bound + 3 * free } else { free + 3 * bound };
        let mut result = [ZERO; 6];
        for bound_j in 0..3 {
            for bound_i in 0..3 {
                let mut weight = ZERO;
                for lane in 0..LANES {
                    weight[lane] = n[bound_i][lane] * n[bound_j][lane];
                }
                for j in 0..3 {
                    for i in 0..=j {
                        let from = &self.0[ordered(at(i, bound_i), at(j, bound_j))];
                        add(&mut result[place(i, j)], &weight, from);
                    }
                }
            }
        }
        result
    }
}

/// Place of `(p, q)` in either order.
#[inline(always)]
pub(super) const fn ordered(p: usize, q: usize) -> usize {
    if p <= q { place(p, q) } else { place(q, p) }
}

#[inline(always)]
pub(super) fn add(to: &mut Row, x: &Row, y: &Row) {
    for lane in 0..LANES {
        to[lane] += x[lane] * y[lane];
    }
}

impl Block {
    /// Rows of a direction.
    #[inline(always)]
    pub(super) fn rows_of(&self, index: u8) -> &Vector {
        &self.directions[usize::from(index)]
    }

    fn direction(&self, index: usize, lane: usize) -> Vec3 {
        Vec3::from_fn(|i, _| self.directions[index][i][lane])
    }

    /// `∂I/∂F`, for the invariants whose tangents are made lane by lane.
    #[inline(always)]
    fn gradient(&self, raw: Raw) -> Option<Tensor> {
        let dyad = |m: &Vector, a: &Vector, factor: f64| {
            let mut result = [ZERO; 9];
            for (place, row) in result.iter_mut().enumerate() {
                for lane in 0..LANES {
                    row[lane] = factor * m[place % 3][lane] * a[place / 3][lane];
                }
            }
            result
        };
        match raw {
            Raw::I1 => Some(self.f.map(|row| row.map(|value| 2.0 * value))),
            Raw::J => Some(self.h),
            Raw::Fourth(a) => Some(dyad(&self.images[usize::from(a)], self.rows_of(a), 2.0)),
            Raw::Eighth(a, b) => {
                let mut sum = dyad(&self.images[usize::from(a)], self.rows_of(b), 1.0);
                let other = dyad(&self.images[usize::from(b)], self.rows_of(a), 1.0);
                for (sum, other) in sum.iter_mut().zip(&other) {
                    for lane in 0..LANES {
                        sum[lane] += other[lane];
                    }
                }
                Some(sum)
            }
            Raw::Metric(i, j) => {
                let mut sum = [ZERO; 9];
                for (line, image) in [(i, j), (j, i)] {
                    for row in 0..3 {
                        for lane in 0..LANES {
                            sum[3 * usize::from(line) + row][lane] += self.column(image)[row][lane];
                        }
                    }
                }
                Some(sum)
            }
            Raw::I2 | Raw::Fifth(_) | Raw::Stretch(_) | Raw::Dot(..) | Raw::Component(..) => None,
        }
    }
}
