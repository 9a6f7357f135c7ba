//! Polynomials that rows of gradients are exact on, and their moment matrices.
//!
//! Owns the monomials of a difference of positions. Knows neither kernels nor lists.

use crate::tensor::Vec3;
use nalgebra::{SMatrix, SVector};

/// Monomials of first degree.
pub(super) const LINEAR: usize = 3;
/// Monomials of first and second degree.
pub(super) const QUADRATIC: usize = 9;

/// Factors of the monomials of second degree.
const FACTORS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

/// Moment matrices whose condition number exceeds this are taken as singular: gradients would lose nine
/// of their sixteen digits.
const WORST_CONDITION: f64 = 1e9;

/// The monomials of a difference of positions, measured in a length so that all are of one size.
#[derive(Debug, Clone, Copy)]
pub(super) struct Basis {
    /// One over the length, 1/m; 1 for first degree alone.
    pub inverse_length: f64,
}

impl Basis {
    /// `p(d)`: `d`, and for nine the six products of its components.
    pub fn at<const M: usize>(&self, d: &Vec3) -> SVector<f64, M> {
        let d = d * self.inverse_length;
        SVector::from_fn(
            |m, _| if m < LINEAR { d[m] } else { d[FACTORS[m - LINEAR].0] * d[FACTORS[m - LINEAR].1] },
        )
    }

    /// `Grad p(0)`, a monomial a column, 1/m.
    pub fn gradient<const M: usize>(&self) -> SMatrix<f64, 3, M> {
        SMatrix::from_fn(|i, m| if i == m { self.inverse_length } else { 0.0 })
    }

    /// Derivative of monomial `m` at `d` along an axis, 1/m.
    pub fn slope(&self, d: &Vec3, m: usize, axis: usize) -> f64 {
        if m < LINEAR {
            return if m == axis { self.inverse_length } else { 0.0 };
        }
        let (i, j) = FACTORS[m - LINEAR];
        let other = |i: usize, j: usize| if i == axis { d[j] * self.inverse_length } else { 0.0 };
        self.inverse_length * (other(i, j) + other(j, i))
    }

    /// Orthonormal basis of the constant and the monomials on some positions, by Gram–Schmidt done twice.
    pub fn orthonormal<const M: usize>(&self, position: &[Vec3]) -> Vec<Vec<f64>> {
        let mut basis: Vec<Vec<f64>> = (0..=M)
            .map(|m| match m {
                0 => vec![1.0; position.len()],
                _ => position.iter().map(|x| self.at::<M>(x)[m - 1]).collect(),
            })
            .collect();
        for i in 0..=M {
            let (done, rest) = basis.split_at_mut(i);
            let current = &mut rest[0];
            for _ in 0..2 {
                for other in done.iter() {
                    let overlap: f64 = current.iter().zip(other).map(|(x, y)| x * y).sum();
                    current.iter_mut().zip(other).for_each(|(x, y)| *x -= overlap * y);
                }
                let norm = current.iter().map(|x| x * x).sum::<f64>().sqrt();
                current.iter_mut().for_each(|x| *x /= norm);
            }
        }
        basis
    }
}

/// `p(−d)` from `p(d)`, or any multiple of it.
pub(super) fn reversed<const M: usize>(p: &SVector<f64, M>) -> SVector<f64, M> {
    SVector::from_fn(|m, _| if m < LINEAR { -p[m] } else { p[m] })
}

/// Inverse of a moment matrix, or `None` if it is singular for all practical purposes.
pub(super) fn inverse<const M: usize>(moment: &SMatrix<f64, M, M>) -> Option<SMatrix<f64, M, M>> {
    let inverse = moment.try_inverse()?;
    let condition = moment.norm() * inverse.norm();
    (condition.is_finite() && condition < WORST_CONDITION).then_some(inverse)
}
