//! How a law grows towards the ends of its domain.

use super::Subject;
use crate::tensor::{Mat3, Vec3};

/// Logarithmic slopes `d ln ψ/d ln J` of a pure dilation towards both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumetricGrowth {
    /// Between `J = 1e-8` and `1e-4`; 0 if the energy stays finite as the volume vanishes, negative
    /// (logarithmically: about −0.08) if it grows.
    pub towards_zero: f64,
    /// Between `J = 1e4` and `1e8`; 0 if it stays finite, at least 1 for growth with the volume.
    pub towards_infinity: f64,
}

/// Growth of the energy under pure dilation.
pub fn volumetric_growth(subject: &Subject) -> VolumetricGrowth {
    let density = |j: f64| subject.density(&(libm::cbrt(j) * Mat3::identity()));
    let slope = |low: f64, high: f64| libm::log(density(high) / density(low)) / libm::log(high / low);
    VolumetricGrowth { towards_zero: slope(1e-8, 1e-4), towards_infinity: slope(1e4, 1e8) }
}

/// Stretch beyond every tissue's: no search goes further.
const LARGEST_STRETCH: f64 = 1e3;

/// Isochoric stretch along a direction at which the energy leaves the range of numbers.
///
/// ```text
/// F = λ a⊗a + λ^(-1/2) (I − a⊗a)
/// ```
///
/// Returns the stretch to the last bit, or `None` if all is finite up to a thousandfold stretch.
pub fn overflow_stretch(subject: &Subject, along: &Vec3) -> Option<f64> {
    let finite = |stretch: f64| {
        let line = along * along.transpose();
        let f = stretch * line + (Mat3::identity() - line) / stretch.sqrt();
        subject.density(&f).is_finite() && subject.stress(&f).iter().all(|p| p.is_finite())
    };
    if finite(LARGEST_STRETCH) {
        return None;
    }
    let (mut low, mut high) = (1.0, LARGEST_STRETCH);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(high);
        }
        if finite(middle) { low = middle } else { high = middle }
    }
}
