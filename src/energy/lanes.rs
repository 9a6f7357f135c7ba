//! Vectors and tensors of a block, lane by lane.
//!
//! Owns their algebra. Sums have a fixed order in each lane.

use super::program::{LANES, Row};

pub(super) const ZERO: Row = [0.0; LANES];

/// Components of a vector, lane by lane.
pub(super) type Vector = [Row; 3];

/// Components of a tensor in the order of a [`Mat3`]'s storage, lane by lane.
pub(super) type Tensor = [Row; 9];

#[inline(always)]
pub(super) fn norm_squared(x: &Tensor, to: &mut Row) {
    *to = ZERO;
    for row in x {
        for lane in 0..LANES {
            to[lane] += row[lane] * row[lane];
        }
    }
}

#[inline(always)]
pub(super) fn dot(x: &Vector, y: &Vector, to: &mut Row) {
    for lane in 0..LANES {
        to[lane] = x[0][lane] * y[0][lane] + x[1][lane] * y[1][lane] + x[2][lane] * y[2][lane];
    }
}

#[inline(always)]
pub(super) fn times(f: &Tensor, a: &Vector) -> Vector {
    let mut product = [ZERO; 3];
    for (i, row) in product.iter_mut().enumerate() {
        for lane in 0..LANES {
            row[lane] = f[i][lane] * a[0][lane] + f[i + 3][lane] * a[1][lane] + f[i + 6][lane] * a[2][lane];
        }
    }
    product
}

#[inline(always)]
pub(super) fn transposed_times(f: &Tensor, a: &Vector) -> Vector {
    let mut product = [ZERO; 3];
    for (i, row) in product.iter_mut().enumerate() {
        let column = 3 * i;
        for lane in 0..LANES {
            row[lane] = f[column][lane] * a[0][lane]
                + f[column + 1][lane] * a[1][lane]
                + f[column + 2][lane] * a[2][lane];
        }
    }
    product
}

#[inline(always)]
pub(super) fn scaled(x: &Tensor, factor: &Row, to: &mut Tensor) {
    for (to, x) in to.iter_mut().zip(x) {
        for lane in 0..LANES {
            to[lane] += factor[lane] * x[lane];
        }
    }
}

#[inline(always)]
pub(super) fn dyad(m: &Vector, a: &Vector, factor: &Row, to: &mut Tensor) {
    for column in 0..3 {
        let mut weighted = ZERO;
        for lane in 0..LANES {
            weighted[lane] = factor[lane] * a[column][lane];
        }
        for row in 0..3 {
            for lane in 0..LANES {
                to[row + 3 * column][lane] += m[row][lane] * weighted[lane];
            }
        }
    }
}
