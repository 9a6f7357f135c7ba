//! The fastest wave of each particle of a block, lane by lane.
//!
//! Owns the fast search: the tangent of sixteen particles at once, candidates for the direction of
//! travel, and a few turns of the climb of [`super::wave`] from the best of them, every eigenvector
//! by repeated squaring. No branch depends on a particle, so neighbours do not matter.

use super::kinematics::{Block, Tensor, Vector, ZERO};
use super::law::{Directions, Law, Maps, Scratch};
use super::program::{LANES, Row};
use super::raw::Raw;
use super::tangent::Kink;
use super::trace::pair;
use crate::tensor::{Mat3, Vec3};

/// Turns of the climb.
const TURNS: usize = 6;

/// Squarings of a tensor: its 2⁶-th power leaves its largest eigenvector.
///
/// A Rayleigh quotient of it misses the eigenvalue by at most 1/(2e 2⁶), 0.3 %, whatever the gap.
const SQUARINGS: usize = 6;

/// What is added to the speeds for the climb's early end and the squarings' share.
///
/// Over the states of the claim the search stays below the true speed by 1.1 % at most.
const MARGIN: f64 = 1.02;

/// Upper triangle of a symmetric 9 × 9 tensor, place of `(p, q)`, `p <= q`.
const fn place(p: usize, q: usize) -> usize {
    q * (q + 1) / 2 + p
}

/// A symmetric 3 × 3 tensor: 00, 01, 11, 02, 12, 22.
type Symmetric = [Row; 6];

/// Tangents of a block, one triangle.
#[derive(Debug, Clone)]
pub(super) struct Tangents([Row; 45]);

impl Default for Tangents {
    fn default() -> Self {
        Self([ZERO; 45])
    }
}

impl Law {
    /// Fastest wave of each particle, m/s, Macaulay brackets at their kink taken as loaded.
    ///
    /// An estimate from above: candidates for the direction of travel (axes, directions of the law,
    /// largest stretch of lines and of areas), six turns of the climb of [`Law::wave_speeds`] from
    /// the best of them, and 2 % on top. It is above the largest speed over all directions in every
    /// state of the claim that holds it, by 2 % as a rule; at strains of 30 % of aligned artery fibres,
    /// far beyond their strength, 0.8 % below was seen.
    ///
    /// Not a number where the tangent is not finite, nor where no wave travels.
    ///
    /// # Panics
    /// As [`Law::stress`].
    pub fn wave_speed_block(
        &self,
        maps: Maps,
        directions: Directions,
        density: f64,
        out: &mut [f64],
        scratch: &mut Scratch,
    ) {
        self.check(&maps, &directions, out.len());
        let program = &self.hessians[1];
        self.prepare(program, scratch);
        let by_lanes = self.raws.iter().all(|raw| !matches!(raw, Raw::Stretch(_) | Raw::Fifth(_) | Raw::I2));
        for (start, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
            scratch.block.load(&maps, &directions, start, self.reads);
            if by_lanes {
                self.run(program, scratch);
                self.tangents(scratch);
            } else {
                self.tangents_one_by_one(scratch);
            }
            let speeds = fastest(&scratch.tangents, &scratch.block, self.directions());
            for (out, square) in out.iter_mut().zip(speeds) {
                *out = if square > 0.0 { MARGIN * (square / density).sqrt() } else { f64::NAN };
            }
        }
    }

    fn tangents(&self, scratch: &mut Scratch) {
        let Scratch { rows, block, tangents, .. } = scratch;
        let outputs = self.hessians[1].outputs();
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
    fn tangents_one_by_one(&self, scratch: &mut Scratch) {
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
            Raw::I2 | Raw::Fifth(_) | Raw::Stretch(_) | Raw::Dot(..) => {}
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
    fn contracted(&self, n: &Vector, polarised: bool) -> Symmetric {
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
const fn ordered(p: usize, q: usize) -> usize {
    if p <= q { place(p, q) } else { place(q, p) }
}

#[inline(always)]
fn add(to: &mut Row, x: &Row, y: &Row) {
    for lane in 0..LANES {
        to[lane] += x[lane] * y[lane];
    }
}

/// `x · S x`
#[inline(always)]
fn quadratic(s: &Symmetric, x: &Vector) -> Row {
    let y = product(s, x);
    let mut value = ZERO;
    for i in 0..3 {
        add(&mut value, &x[i], &y[i]);
    }
    value
}

#[inline(always)]
fn product(s: &Symmetric, x: &Vector) -> Vector {
    let mut y = [ZERO; 3];
    for (i, y) in y.iter_mut().enumerate() {
        for (j, x) in x.iter().enumerate() {
            add(y, &s[ordered(i, j)], x);
        }
    }
    y
}

/// Unit eigenvector of the eigenvalue of largest size: the largest column of a high power.
#[inline(always)]
fn top_vector(s: &Symmetric) -> Vector {
    let mut power = *s;
    for _ in 0..SQUARINGS {
        let mut scale = ZERO;
        for lane in 0..LANES {
            let trace = power[0][lane].abs() + power[2][lane].abs() + power[5][lane].abs();
            scale[lane] = 1.0 / trace;
        }
        for entry in &mut power {
            for lane in 0..LANES {
                entry[lane] *= scale[lane];
            }
        }
        let old = power;
        for j in 0..3 {
            for i in 0..=j {
                let mut entry = ZERO;
                for k in 0..3 {
                    add(&mut entry, &old[ordered(i, k)], &old[ordered(k, j)]);
                }
                power[place(i, j)] = entry;
            }
        }
    }
    // the diagonal holds the squares of the vector's components: take the largest one's column
    let mut vector = [ZERO; 3];
    for lane in 0..LANES {
        let diagonal = [power[0][lane], power[2][lane], power[5][lane]];
        let first = diagonal[0] >= diagonal[1] && diagonal[0] >= diagonal[2];
        let second = diagonal[1] >= diagonal[2];
        let pick = |x: usize, y: usize, z: usize| {
            if first {
                power[x][lane]
            } else if second {
                power[y][lane]
            } else {
                power[z][lane]
            }
        };
        let v = [pick(0, 1, 3), pick(1, 2, 4), pick(3, 4, 5)];
        let norm = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        for (row, v) in vector.iter_mut().zip(v) {
            row[lane] = v / norm;
        }
    }
    vector
}

/// Gram tensor `XᵀX`.
#[inline(always)]
fn gram(x: &Tensor) -> Symmetric {
    let mut result = [ZERO; 6];
    for j in 0..3 {
        for i in 0..=j {
            for k in 0..3 {
                add(&mut result[place(i, j)], &x[k + 3 * i], &x[k + 3 * j]);
            }
        }
    }
    result
}

/// `max (n⊗N) : A : (n⊗N)` as far as the search finds it.
#[inline(always)]
fn fastest(tangents: &Tangents, block: &Block, directions: usize) -> Row {
    let mut best = [f64::NEG_INFINITY; LANES];
    let mut travel = [ZERO; 3];
    let mut consider = |candidate: &Vector| {
        let q = tangents.contracted(candidate, false);
        let value = quadratic(&q, &top_vector(&q));
        for lane in 0..LANES {
            // a NaN is kept: no comparison with it holds
            let worse = value[lane] <= best[lane];
            best[lane] = if worse { best[lane] } else { value[lane] };
            for (travel, candidate) in travel.iter_mut().zip(candidate) {
                travel[lane] = if worse { travel[lane] } else { candidate[lane] };
            }
        }
    };
    for axis in 0..3 {
        let mut candidate = [ZERO; 3];
        candidate[axis] = [1.0; LANES];
        consider(&candidate);
    }
    consider(&top_vector(&gram(&block.f)));
    consider(&top_vector(&gram(&block.h)));
    for index in 0..directions {
        consider(block.rows_of(index as u8));
    }
    for _ in 0..TURNS {
        let n = top_vector(&tangents.contracted(&travel, false));
        let r = tangents.contracted(&n, true);
        travel = top_vector(&r);
        let value = quadratic(&r, &travel);
        for lane in 0..LANES {
            best[lane] = if value[lane] <= best[lane] { best[lane] } else { value[lane] };
        }
    }
    best
}

impl Block {
    /// Rows of a direction.
    #[inline(always)]
    fn rows_of(&self, index: u8) -> &Vector {
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
            Raw::I2 | Raw::Fifth(_) | Raw::Stretch(_) | Raw::Dot(..) => None,
        }
    }
}
