//! Smoothing kernels.
//!
//! Owns value and gradient of the uncorrected kernels, normalised in three dimensions. Knows no particle
//! but the one at the kernel's centre.

use crate::tensor::Vec3;
use std::f64::consts::PI;

/// Smoothing kernels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kernel {
    /// Wendland's C2 function of support 2 h.
    WendlandC2,
    /// The cubic B-spline of support 2 h.
    CubicSpline,
    /// The quintic B-spline of support 3 h.
    QuinticSpline,
    /// The parabola of Johnson, Stryk & Beissel 1996, of support 2 h; its slope does not vanish at the
    /// centre, so that particles pressed together still repel.
    Quadratic,
}

impl Kernel {
    /// Radius beyond which the kernel vanishes, in units of the smoothing length.
    pub const fn support(self) -> f64 {
        match self {
            Self::WendlandC2 | Self::CubicSpline | Self::Quadratic => 2.0,
            Self::QuinticSpline => 3.0,
        }
    }

    /// Value of the kernel at a distance from its centre.
    ///
    /// ```text
    /// Wendland C2    W = 21/(16 π h³) (1 − q/2)⁴ (1 + 2q),                   q = r/h < 2
    /// cubic spline   W = 1/(π h³) { 1 − 3/2 q² + 3/4 q³  (q < 1),  1/4 (2 − q)³  (q < 2) }
    /// quintic        W = 1/(120 π h³) [ (3 − q)₊⁵ − 6 (2 − q)₊⁵ + 15 (1 − q)₊⁵ ]
    /// quadratic      W = 15/(16 π h³) (1 − q/2)²,                            q < 2
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `r` | distance from the centre | m |
    /// | `h` | smoothing length | m |
    ///
    /// Returns `W` in 1/m³; its integral over space is 1. Exactly zero beyond the support.
    pub fn value(self, r: f64, h: f64) -> f64 {
        let q = r / h;
        if q >= self.support() {
            return 0.0;
        }
        match self {
            Self::WendlandC2 => {
                let s = (1.0 - 0.5 * q) * (1.0 - 0.5 * q);
                21.0 / (16.0 * PI * h * h * h) * s * s * (1.0 + 2.0 * q)
            }
            Self::CubicSpline => {
                let shape = if q < 1.0 {
                    1.0 - q * q * (1.5 - 0.75 * q)
                } else {
                    0.25 * (2.0 - q) * (2.0 - q) * (2.0 - q)
                };
                shape / (PI * h * h * h)
            }
            Self::QuinticSpline => {
                let shape = fifth(3.0 - q) - 6.0 * fifth(2.0 - q) + 15.0 * fifth(1.0 - q);
                shape / (120.0 * PI * h * h * h)
            }
            Self::Quadratic => 15.0 / (16.0 * PI * h * h * h) * (1.0 - 0.5 * q) * (1.0 - 0.5 * q),
        }
    }

    /// Gradient of the kernel with respect to the point it is evaluated at.
    ///
    /// ```text
    /// ∇W = W'(r) d/r,    d = X − X_b
    /// Wendland C2    W'(r)/r = −5 · 21/(16 π h⁵) (1 − q/2)³
    /// cubic spline   W'(r)/r = 1/(π h⁵) { −3 + 9/4 q  (q < 1),  −3/4 (2 − q)²/q  (q < 2) }
    /// quintic        W'(r)/r = −1/(24 π h⁵) [ (3 − q)₊⁴ − 6 (2 − q)₊⁴ + 15 (1 − q)₊⁴ ]/q
    /// quadratic      W'(r)/r = −15/(16 π h⁵) (1 − q/2)/q
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `d` | from the centre to the point | m |
    /// | `h` | smoothing length | m |
    ///
    /// Returns `∇W` in 1/m⁴, zero at the centre.
    ///
    /// Exact in floating point: odd in `d`.
    pub fn gradient(self, d: &Vec3, h: f64) -> Vec3 {
        let q = d.norm() / h;
        if q == 0.0 || q >= self.support() {
            return Vec3::zeros();
        }
        let h5 = h * h * h * h * h;
        let slope = match self {
            Self::WendlandC2 => {
                let s = 1.0 - 0.5 * q;
                -5.0 * 21.0 / (16.0 * PI * h5) * s * s * s
            }
            Self::CubicSpline if q < 1.0 => (-3.0 + 2.25 * q) / (PI * h5),
            Self::CubicSpline => -0.75 * (2.0 - q) * (2.0 - q) / (q * PI * h5),
            Self::QuinticSpline => {
                let shape = fourth(3.0 - q) - 6.0 * fourth(2.0 - q) + 15.0 * fourth(1.0 - q);
                -shape / (24.0 * PI * h5 * q)
            }
            Self::Quadratic => -15.0 / (16.0 * PI * h5) * (1.0 - 0.5 * q) / q,
        };
        slope * d
    }
}

/// Fourth power of the positive part.
fn fourth(x: f64) -> f64 {
    let x = x.max(0.0);
    (x * x) * (x * x)
}

/// Fifth power of the positive part.
fn fifth(x: f64) -> f64 {
    x.max(0.0) * fourth(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Kernel; 4] =
        [Kernel::WendlandC2, Kernel::CubicSpline, Kernel::QuinticSpline, Kernel::Quadratic];

    #[test]
    fn the_integral_over_space_is_one() {
        // Simpson between knots: polynomials of degree at most 7 in 200 panels, so the
        // error is below (1/200)^4.
        for kernel in ALL {
            let h = 0.7;
            let mut integral = 0.0;
            for side in 0..3 {
                let n = 400;
                let dr = h / n as f64;
                for i in 0..=n {
                    let r = side as f64 * h + i as f64 * dr;
                    let weight = if i == 0 || i == n { 1.0 } else { [2.0, 4.0][i % 2] };
                    integral += weight * dr / 3.0 * 4.0 * PI * r * r * kernel.value(r, h);
                }
            }
            assert!((integral - 1.0).abs() < 2e-9, "{kernel:?}: {integral}");
        }
    }

    #[test]
    fn the_gradient_is_the_derivative_of_the_value() {
        // central differences of step 1e-5: truncation 1e-10, round-off 1e-11, relative to W/h of order 1
        for kernel in ALL {
            let (h, step) = (1.3, 1e-5);
            for d in [Vec3::new(0.2, -0.4, 0.1), Vec3::new(1.1, 0.9, -0.3), Vec3::new(1.5, 1.5, 1.2)] {
                for axis in 0..3 {
                    let mut e = Vec3::zeros();
                    e[axis] = step;
                    let difference =
                        (kernel.value((d + e).norm(), h) - kernel.value((d - e).norm(), h)) / (2.0 * step);
                    assert!((kernel.gradient(&d, h)[axis] - difference).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn value_and_gradient_vanish_at_the_support() {
        for kernel in ALL {
            let h = 0.5;
            let edge = kernel.support() * h;
            assert_eq!(kernel.value(edge, h), 0.0);
            assert_eq!(kernel.gradient(&Vec3::new(edge, 0.0, 0.0), h), Vec3::zeros());
            // at least the second power of 2e-6 h and a factor of at most 100
            assert!(kernel.value(edge - 1e-6, h) < 1e-10);
        }
    }

    #[test]
    fn the_gradient_is_odd_to_the_last_bit() {
        for kernel in ALL {
            for d in [Vec3::new(0.2, -0.4, 0.1), Vec3::new(0.9, 0.9, -0.3)] {
                assert_eq!(kernel.gradient(&d, 0.8), -kernel.gradient(&-d, 0.8));
            }
        }
    }
}
