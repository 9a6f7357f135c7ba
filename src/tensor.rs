//! Two-point tensors of three dimensions.
//!
//! Owns the algebra the method is written in: tensor cross product, cofactor, contraction.
//! Spatial index first, reference index second. Knows nothing else of the project.

/// A vector of three components.
pub type Vec3 = nalgebra::Vector3<f64>;

/// A 3 × 3 tensor; of a two-point tensor the row is spatial, the column referential.
pub type Mat3 = nalgebra::Matrix3<f64>;

/// Tensor cross product.
///
/// ```text
/// (A ⨯ B)_iI = ε_ijk ε_IJK A_jJ B_kK
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `a`, `b` | two-point tensors | any |
///
/// Returns a two-point tensor in the product of the two units.
///
/// Exact in floating point: symmetric in its arguments up to the order of two additions.
pub fn cross(a: &Mat3, b: &Mat3) -> Mat3 {
    Mat3::from_fn(|i, j| {
        let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
        let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
        (a[(i1, j1)] * b[(i2, j2)] - a[(i1, j2)] * b[(i2, j1)])
            + (b[(i1, j1)] * a[(i2, j2)] - b[(i1, j2)] * a[(i2, j1)])
    })
}

/// Cofactor, the area map of a deformation gradient.
///
/// ```text
/// H = cof F = ½ F ⨯ F = J F⁻ᵀ                     [NB25 (9)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `f` | deformation gradient | – |
///
/// Returns `cof F`; defined for singular `f` as well.
pub fn cofactor(f: &Mat3) -> Mat3 {
    Mat3::from_fn(|i, j| {
        let (i1, i2) = ((i + 1) % 3, (i + 2) % 3);
        let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
        f[(i1, j1)] * f[(i2, j2)] - f[(i1, j2)] * f[(i2, j1)]
    })
}

/// Volume map of a deformation gradient whose cofactor is known.
///
/// ```text
/// J = ⅓ H : F = det F                              [NB25 (13)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `f`, `h` | deformation gradient and its cofactor | – |
///
/// Returns `J`, expanded along the first row of `f`.
pub fn volume_map(f: &Mat3, h: &Mat3) -> f64 {
    f[(0, 0)] * h[(0, 0)] + f[(0, 1)] * h[(0, 1)] + f[(0, 2)] * h[(0, 2)]
}

/// Full contraction `A : B = A_iI B_iI`, summed column by column.
pub fn contract(a: &Mat3, b: &Mat3) -> f64 {
    a.iter().zip(b.iter()).fold(0.0, |sum, (x, y)| sum + x * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn matrix() -> impl Strategy<Value = Mat3> {
        prop::array::uniform9(-2.0..2.0).prop_map(|m: [f64; 9]| Mat3::from_column_slice(&m))
    }

    /// ε_ijk as the product formula, the definition the fast forms must match.
    fn levi_civita(i: usize, j: usize, k: usize) -> f64 {
        let (i, j, k) = (i as f64, j as f64, k as f64);
        (j - i) * (k - i) * (k - j) / 2.0
    }

    proptest! {
        #[test]
        fn cross_agrees_with_its_definition(a in matrix(), b in matrix()) {
            let mut printed = Mat3::zeros();
            for i in 0..3 { for j in 0..3 { for k in 0..3 {
                for l in 0..3 { for m in 0..3 { for n in 0..3 {
                    printed[(i, l)] += levi_civita(i, j, k) * levi_civita(l, m, n) * a[(j, m)] * b[(k, n)];
                }}}
            }}}
            // four products of at most 4, each rounded to 1.1e-16, summed in another order
            prop_assert!((cross(&a, &b) - printed).norm() <= 9.0 * 16.0 * f64::EPSILON);
        }

        #[test]
        fn cofactor_is_half_the_cross_product(f in matrix()) {
            prop_assert!((0.5 * cross(&f, &f) - cofactor(&f)).norm() <= 9.0 * 8.0 * f64::EPSILON);
        }

        #[test]
        fn cofactor_is_the_volume_map_times_the_inverse_transpose(f in matrix()) {
            let h = cofactor(&f);
            let j = volume_map(&f, &h);
            prop_assert!((f * h.transpose() - j * Mat3::identity()).norm() <= 9.0 * 24.0 * f64::EPSILON);
            prop_assert!((contract(&h, &f) / 3.0 - j).abs() <= 24.0 * 8.0 * f64::EPSILON);
        }
    }
}
