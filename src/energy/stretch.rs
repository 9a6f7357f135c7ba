//! Principal stretches of a deformation gradient.
//!
//! Owns a Jacobi eigen-solver of `C = Fᵀ F`: its eigenvectors are orthonormal to round-off even at
//! equal stretches, so a stress `F Σ (g_i/λ_i) N_i ⊗ N_i` needs no case distinction there.

use crate::tensor::{Mat3, Vec3};

/// Sweeps after which three rows are diagonal for certain; four are the most seen.
const SWEEPS: usize = 12;

/// Principal stretches in descending order and their referential directions, one to a column.
///
/// ```text
/// C = Fᵀ F = Σ λ_i² N_i ⊗ N_i
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `f` | deformation gradient | – |
///
/// Returns numbers without unit; not numbers where `f` holds one that is none.
pub fn principal(f: &Mat3) -> (Vec3, Mat3) {
    let (squares, directions) = symmetric_eigen(&(f.transpose() * f));
    (squares.map(|square| if square > 0.0 { square.sqrt() } else { square * f64::NAN }), directions)
}

/// Eigenvalues in descending order and eigenvectors of a symmetric tensor, one to a column.
///
/// Exact in floating point: the vectors are products of rotations, orthonormal to some 1e-15.
pub fn symmetric_eigen(symmetric: &Mat3) -> (Vec3, Mat3) {
    let mut c = *symmetric;
    let mut n = Mat3::identity();
    for _ in 0..SWEEPS {
        if c[(0, 1)] == 0.0 && c[(0, 2)] == 0.0 && c[(1, 2)] == 0.0 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut c, &mut n, p, q);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| c[(j, j)].total_cmp(&c[(i, i)]));
    let values = Vec3::from_fn(|i, _| c[(order[i], order[i])]);
    let vectors = Mat3::from_fn(|row, i| n[(row, order[i])]);
    (values, vectors)
}

/// One Jacobi rotation that makes `c_pq` zero.
fn rotate(c: &mut Mat3, n: &mut Mat3, p: usize, q: usize) {
    let off = c[(p, q)];
    if off == 0.0 {
        return;
    }
    let theta = (c[(q, q)] - c[(p, p)]) / (2.0 * off);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cosine = 1.0 / (t * t + 1.0).sqrt();
    let sine = t * cosine;
    let r = 3 - p - q;
    let (rp, rq) = (c[(r, p)], c[(r, q)]);
    c[(p, p)] -= t * off;
    c[(q, q)] += t * off;
    c[(p, q)] = 0.0;
    c[(q, p)] = 0.0;
    c[(r, p)] = cosine * rp - sine * rq;
    c[(p, r)] = c[(r, p)];
    c[(r, q)] = sine * rp + cosine * rq;
    c[(q, r)] = c[(r, q)];
    for row in 0..3 {
        let (np, nq) = (n[(row, p)], n[(row, q)]);
        n[(row, p)] = cosine * np - sine * nq;
        n[(row, q)] = sine * np + cosine * nq;
    }
}
