//! Upwinding by the linearised (acoustic) Riemann solver.
//!
//! Owns the interface traction and the interface speed of one interacting pair. The sums over
//! neighbours are in the force pass; nothing here knows a stencil.

use super::quad::{Columns, Quad};

/// Wave speeds that weigh the jump of a pair, with their switches applied.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Speeds {
    /// Pressure wave speed times its weight, m/s.
    pub pressure: f64,
    /// Shear wave speed times its weight, m/s.
    pub shear: f64,
}

/// Stabilising traction of the pair `(a, b)`, the vector of `P_stab = traction ⊗ N`.
///
/// ```text
/// P_stab = S_p (p⁺ − p⁻) ⊗ N                       [NB25 (35)]
/// S_p    = ½ [c_p n ⊗ n + c_s (I − n ⊗ n)]         [NB25 (37)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `jump` | `p⁺ − p⁻`, momentum jump across the pair | kg m⁻² s⁻¹ |
/// | `distance` | `x_b − x_a`, along `n` | m |
/// | `speeds` | `c_p` and `c_s` | m s⁻¹ |
///
/// Returns `S_p jump` in Pa, without a square root: `n ⊗ n = d ⊗ d/|d|²`.
///
/// Exact in floating point: exchanging `a` and `b` flips `jump` and `distance` and flips the result.
#[inline(always)]
pub fn interface_traction(jump: Quad, distance: Quad, speeds: Speeds) -> Quad {
    let along = distance.dot(jump) / distance.dot(distance);
    jump * (0.5 * speeds.shear) + distance * (0.5 * (speeds.pressure - speeds.shear) * along)
}

/// Momentum jump of a pair with states carried to its middle.
///
/// ```text
/// p⁺ − p⁻ = p_b − p_a − ½ (Grad p_a + Grad p_b) (X_b − X_a)
/// ```
///
/// the linear reconstruction of the interface states of [NB25 (33)]. Zero for a linear field, so
/// rigid rotation is free of dissipation.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `difference` | `v_b − v_a` | m s⁻¹ |
/// | `gradient_a`, `gradient_b` | `Grad v` of the two | s⁻¹ |
/// | `half_step` | `½ (X_b − X_a)` | m |
///
/// Returns the jump of velocity in m s⁻¹, to be multiplied by the density.
///
/// Exact in floating point: exchanging `a` and `b` flips the result.
#[inline(always)]
pub fn linear_jump(
    difference: Quad,
    gradient_a: &Columns,
    gradient_b: &Columns,
    half_step: &[f64; 3],
) -> Quad {
    difference - gradient_a.plus(gradient_b).apply(half_step)
}

/// Stabilising momentum of the pair `(a, b)`, for the volume map.
///
/// ```text
/// p_stab = S_P (P⁺ − P⁻) N                         [NB25 (36)]
/// S_P    = 1/(2 c_p) n ⊗ n                         [NB25 (38)]
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `jump` | `(P⁺ − P⁻) N`, traction jump across the pair | Pa |
/// | `distance` | `x_b − x_a`, along `n` | m |
/// | `c_p` | pressure wave speed | m s⁻¹ |
///
/// Returns a momentum per reference volume, kg m⁻² s⁻¹.
///
/// Exact in floating point: unchanged when `a` and `b` are exchanged, for `jump` is unchanged
/// (both `P⁺ − P⁻` and `N` flip) and `distance` enters twice.
#[inline(always)]
pub fn interface_momentum(jump: Quad, distance: Quad, c_p: f64) -> Quad {
    distance * (distance.dot(jump) / (distance.dot(distance) * 2.0 * c_p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tensor::{Mat3, Vec3};
    use proptest::prelude::*;

    const SPEEDS: Speeds = Speeds { pressure: 3.0, shear: 1.0 };

    fn vector() -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-1.0..1.0)
            .prop_map(|v: [f64; 3]| Vec3::from(v))
            .prop_filter("a direction", |v| v.norm() > 0.1)
    }

    proptest! {
        #[test]
        fn exchanging_the_particles_flips_the_traction_exactly(jump in vector(), d in vector()) {
            let there = interface_traction(Quad::new(&jump), Quad::new(&d), SPEEDS);
            let back = interface_traction(Quad::new(&-jump), Quad::new(&-d), SPEEDS);
            prop_assert_eq!(there * -1.0, back);
        }

        // The formula as printed, with S_p formed: the slow route the fast one must match.
        #[test]
        fn the_traction_agrees_with_the_formula_as_printed(jump in vector(), d in vector()) {
            let n = d.normalize();
            let n_n = n * n.transpose();
            let s_p = 0.5 * (SPEEDS.pressure * n_n + SPEEDS.shear * (Mat3::identity() - n_n));
            let fast = interface_traction(Quad::new(&jump), Quad::new(&d), SPEEDS).vector();
            // a dozen operations on numbers below 5
            prop_assert!((fast - s_p * jump).norm() <= 5.0 * 12.0 * f64::EPSILON);
        }

        #[test]
        fn the_traction_never_feeds_the_jump(jump in vector(), d in vector()) {
            let traction = interface_traction(Quad::new(&jump), Quad::new(&d), SPEEDS);
            prop_assert!(traction.dot(Quad::new(&jump)) > 0.0);
        }

        #[test]
        fn a_linear_velocity_has_no_jump(g in prop::array::uniform9(-1.0..1.0), d in vector()) {
            let gradient = Mat3::from_column_slice(&g);
            let columns = Columns::new(&gradient);
            let jump = linear_jump(Quad::new(&(gradient * d)), &columns, &columns, &(0.5 * d).into());
            // two sums of three products below 2
            prop_assert!(jump.vector().norm() <= 2.0 * 12.0 * f64::EPSILON);
        }

        #[test]
        fn the_momentum_agrees_with_the_formula_as_printed(jump in vector(), d in vector()) {
            let n = d.normalize();
            let printed = 1.0 / (2.0 * SPEEDS.pressure) * (n * n.transpose()) * jump;
            let fast = interface_momentum(Quad::new(&jump), Quad::new(&d), SPEEDS.pressure).vector();
            prop_assert!((fast - printed).norm() <= 2.0 * 12.0 * f64::EPSILON);
        }
    }
}
