//! What the columns of gradients are made to satisfy, and the system of its multipliers.
//!
//! Owns the system for sums of columns alone and for sums and first moments. Knows neither targets nor areas.
//!
//! With multipliers `φ_a` of the sum and `ψ_a` of the first moments of column `a`, entry `(a, b)` sees
//!
//! ```text
//! s_ab = φ_b − ψ_b · (X_b − X_a) − φ_a,    δ_ab = w_ab [s_ab − q_a p(X_b − X_a)],
//! ```
//!
//! `q_a` being the weighted least-squares fit of `s_ab` around `a`, which keeps the rows exact for quadratic
//! fields. The system is what `δ` adds to the columns: `Σ_b δ_ba` and `Σ_b δ_ba ⊗ (X_b − X_a)`.

use super::coarse::Coarse;
use super::conjugate;
use super::integration;
use super::moments::reversed;
use super::quadratic::{Fit, Monomials, Rows};
use crate::tensor::Vec3;
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

/// Sums of columns alone.
pub(super) const SUMS: usize = 1;
/// Sums and first moments.
pub(super) const MOMENTS: usize = 4;

/// Share of its diagonal that is added to the block of `ψ`: smooth fields of multipliers move no entry, or next to
/// none, and would take all iterations. What it leaves of a first moment that errs from node to node is of its
/// own size.
const SHIFT: f64 = 1e-3;

/// The system for the first `K` of `φ, ψ_x, ψ_y, ψ_z`; a field has `K` consecutive entries a particle.
pub(super) struct Columns<'a, const K: usize> {
    rows: &'a Rows<'a>,
    /// What is added to the diagonal of `ψ`, m³.
    shift: Vec<f64>,
    /// Inverse of each particle's block, m⁻³.
    preconditioner: Vec<SMatrix<f64, K, K>>,
    /// Preconditioner of what is smooth in `φ`.
    coarse: Option<&'a Coarse>,
    /// Quadratic `φ`, orthonormal.
    null: Vec<Vec<f64>>,
}

/// The multipliers of one particle, a column each.
fn at<const K: usize>(field: &[Vec3], a: usize) -> SMatrix<f64, 3, K> {
    SMatrix::from_columns(&field[K * a..K * (a + 1)])
}

/// `1, X_b − X_a` in spacings, of which column `a` takes moments.
pub(super) fn arm<const K: usize>(p: &Monomials) -> SVector<f64, K> {
    SVector::from_fn(|k, _| if k == 0 { 1.0 } else { p[k - 1] })
}

impl<'a, const K: usize> Columns<'a, K> {
    pub fn new(rows: &'a Rows<'a>, coarse: Option<&'a Coarse>) -> Self {
        let block = |a: usize| {
            let mut block = SMatrix::<f64, K, K>::zeros();
            let (mut sum, mut first) = (0.0, Monomials::zeros());
            for entry in rows.list.range(a) {
                let (w, p) = (rows.weight[entry], rows.monomials(a, entry));
                sum += w;
                first += w * p;
                let (arm, back) = (arm::<K>(&p), reversed(&p));
                let other = rows.list.neighbour[entry] as usize;
                let left = w - w * w * back.dot(&(rows.inverse_moment[other] * back));
                block += left * arm * arm.transpose();
            }
            block[(0, 0)] += sum - first.dot(&(rows.inverse_moment[a] * first));
            let shift: f64 = (1..K).map(|k| SHIFT * block[(k, k)] / (K - 1) as f64).sum();
            for k in 1..K {
                block[(k, k)] += shift;
            }
            // a block that cannot be inverted preconditions nothing, which costs iterations only
            (shift, block.try_inverse().unwrap_or_else(|| SMatrix::identity() / block.trace()))
        };
        let (shift, preconditioner) = (0..rows.position.len()).into_par_iter().map(block).unzip();
        let interleaved = |null: &Vec<f64>| -> Vec<f64> {
            null.iter().flat_map(|&x| (0..K).map(move |k| if k == 0 { x } else { 0.0 })).collect()
        };
        Self { rows, shift, preconditioner, coarse, null: rows.null.iter().map(interleaved).collect() }
    }

    /// `s_ab` of an entry of row `a`.
    fn seen(&self, field: &[Vec3], a: usize, entry: usize, p: &Monomials) -> Vec3 {
        let b = self.rows.list.neighbour[entry] as usize;
        at::<K>(field, b) * arm::<K>(&reversed(p)) - field[K * a]
    }

    /// Least-squares fits of `s_ab` around every particle.
    fn fits(&self, field: &[Vec3]) -> Vec<Fit> {
        let fit = |a: usize| {
            let sum = self.rows.list.range(a).fold(Fit::zeros(), |sum, entry| {
                let p = self.rows.monomials(a, entry);
                sum + (self.rows.weight[entry] * self.seen(field, a, entry, &p)) * p.transpose()
            });
            sum * self.rows.inverse_moment[a]
        };
        (0..self.rows.position.len()).into_par_iter().map(fit).collect()
    }
}

impl<const K: usize> integration::Columns for Columns<'_, K> {
    fn is_quadratic(&self) -> bool {
        true
    }

    fn correct(&self, field: &[Vec3], forward: &mut [Vec3]) {
        for (a, fit) in self.fits(field).iter().enumerate() {
            self.rows.add(a, forward, |entry, p| self.seen(field, a, entry, p) - fit * p);
        }
    }
}

impl<const K: usize> conjugate::System for Columns<'_, K> {
    fn apply(&self, field: &[Vec3]) -> Vec<Vec3> {
        let fit = self.fits(field);
        let columns = |a: usize| {
            let own = at::<K>(field, a);
            let mut out = SMatrix::<f64, 3, K>::zeros();
            for entry in self.rows.list.range(a) {
                let (b, p) = (self.rows.list.neighbour[entry] as usize, self.rows.monomials(a, entry));
                let arm = arm::<K>(&p);
                let forward = self.seen(field, a, entry, &p) - fit[a] * p;
                let backward = own * arm - field[K * b] - fit[b] * reversed(&p);
                out += (self.rows.weight[entry] * backward) * arm.transpose();
                let mut sum = out.column_mut(0);
                sum -= self.rows.weight[entry] * forward;
            }
            for k in 1..K {
                let mut moment = out.column_mut(k);
                moment += self.shift[a] * own.column(k);
            }
            (0..K).map(move |k| Vec3::from(out.column(k)))
        };
        (0..fit.len()).into_par_iter().flat_map_iter(columns).collect()
    }

    fn precondition(&self, residual: &[Vec3]) -> Vec<Vec3> {
        let rough = |a: usize| {
            let z = at::<K>(residual, a) * self.preconditioner[a];
            (0..K).map(move |k| Vec3::from(z.column(k)))
        };
        let mut z: Vec<Vec3> = (0..self.preconditioner.len()).into_par_iter().flat_map_iter(rough).collect();
        if let Some(coarse) = self.coarse {
            let sums: Vec<Vec3> = residual.iter().step_by(K).copied().collect();
            z.iter_mut().step_by(K).zip(coarse.correct(&sums)).for_each(|(z, smooth)| *z += smooth);
        }
        z
    }

    fn null(&self) -> &[Vec<f64>] {
        &self.null
    }
}
