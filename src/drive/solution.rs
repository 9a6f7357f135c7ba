//! The linear equations of one iteration.
//!
//! Owns what is done where they have many solutions. Knows nothing of stresses.

use super::system::{Column, Matrix, SIZE};
use nalgebra::{Const, LU};

/// Smallest pivot, of the largest, that is more than round-off of the ten sums before it.
const SMALLEST_PIVOT: f64 = 1e-13;

/// A factorised matrix.
pub(super) enum Factors {
    /// One solution.
    Unique(Box<LU<f64, Const<SIZE>, Const<SIZE>>>),
    /// Many solutions or none: a mode without stiffness, such as a shear the law gives no weight.
    Singular(Box<Matrix>),
}

impl Factors {
    pub(super) fn of(matrix: Matrix) -> Self {
        let lu = matrix.lu();
        let pivots = lu.u().diagonal().abs();
        if pivots.min() > SMALLEST_PIVOT * pivots.max() {
            Self::Unique(Box::new(lu))
        } else {
            Self::Singular(Box::new(matrix))
        }
    }

    /// The solution; of many the shortest, which leaves modes without stiffness where they are.
    ///
    /// Where there is none it is the step of least residual, and the caller sees that the residual stays.
    pub(super) fn solve(&self, right: &Column) -> Option<Column> {
        match self {
            Self::Unique(lu) => lu.solve(right),
            Self::Singular(matrix) => {
                let svd = matrix.svd(true, true);
                let smallest = SMALLEST_PIVOT * svd.singular_values.max();
                svd.solve(right, smallest).ok()
            }
        }
    }

    pub(super) fn is_singular(&self) -> bool {
        matches!(self, Self::Singular(_))
    }
}
