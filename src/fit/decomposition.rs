//! Singular values of a tall matrix by rotations of its columns (Hestenes 1958).
//!
//! Sums, products and square roots only, in a fixed order: the same bits everywhere.

use nalgebra::{DMatrix, DVector};

/// Sweeps after which the columns are orthogonal for certain; eight are the most seen.
const SWEEPS: usize = 40;
/// Cosine of the angle between two columns that counts as none.
const ORTHOGONAL: f64 = 1e-15;

/// `A = U S Vᵀ`
pub(super) struct Decomposition {
    /// `U S`: a column each of the length of its singular value.
    scaled: DMatrix<f64>,
    /// `V`, orthogonal.
    pub(super) right: DMatrix<f64>,
    /// Singular values, in no order.
    pub(super) values: Vec<f64>,
}

impl Decomposition {
    pub(super) fn of(mut a: DMatrix<f64>) -> Self {
        let count = a.ncols();
        let mut right = DMatrix::identity(count, count);
        for _ in 0..SWEEPS {
            let mut is_done = true;
            for q in 1..count {
                for p in 0..q {
                    is_done &= !rotate(&mut a, &mut right, p, q);
                }
            }
            if is_done {
                break;
            }
        }
        let values = a.column_iter().map(|column| column.norm()).collect();
        Self { scaled: a, right, values }
    }

    /// `−V S (S² + damping)⁻¹ Uᵀ r`, the step of Levenberg and Marquardt.
    pub(super) fn damped_step(&self, residuals: &DVector<f64>, damping: f64) -> DVector<f64> {
        let mut step = DVector::zeros(self.values.len());
        for (i, &value) in self.values.iter().enumerate() {
            let weight = value * value + damping;
            if weight > 0.0 {
                let share = self.scaled.column(i).dot(residuals) / weight;
                step -= share * self.right.column(i);
            }
        }
        step
    }
}

/// Makes columns `p` and `q` orthogonal; whether they were not.
fn rotate(a: &mut DMatrix<f64>, right: &mut DMatrix<f64>, p: usize, q: usize) -> bool {
    let (pp, qq) = (a.column(p).norm_squared(), a.column(q).norm_squared());
    let pq = a.column(p).dot(&a.column(q));
    if pq == 0.0 || pq.abs() <= ORTHOGONAL * (pp * qq).sqrt() {
        return false;
    }
    let theta = (qq - pp) / (2.0 * pq);
    let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    for matrix in [a, right] {
        for row in 0..matrix.nrows() {
            let (x, y) = (matrix[(row, p)], matrix[(row, q)]);
            matrix[(row, p)] = cosine * x - sine * y;
            matrix[(row, q)] = sine * x + cosine * y;
        }
    }
    true
}
