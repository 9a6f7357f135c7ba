//! Observed orders: the slope of the errors over the spacings, by least squares in logarithms.

use crate::monitor::{FieldErrors, MotionErrors};
use crate::verify::claims::cube::{Case, Cube};
use crate::verify::claims::picture::slope;

/// Orders of the errors at the end of a cube's motion.
#[derive(Debug, Clone)]
pub(super) struct Orders {
    /// Of root mean squares.
    pub(super) rms: FieldErrors,
    /// The errors themselves, by cells along an edge.
    pub(super) errors: Vec<(f64, MotionErrors)>,
}

/// Orders over a list of cells along an edge.
pub(super) fn orders(cells: &[u32], cube: impl Fn(u32) -> Cube) -> Orders {
    let errors: Vec<_> = cells.iter().map(|&cells| (f64::from(cells), cube(cells).errors())).collect();
    let rms: Vec<(f64, FieldErrors)> = errors.iter().map(|(n, errors)| (*n, errors.rms)).collect();
    Orders { rms: slopes(&rms), errors }
}

/// The slope of every field's error.
fn slopes(errors: &[(f64, FieldErrors)]) -> FieldErrors {
    let of = |field: fn(&FieldErrors) -> f64| {
        slope(
            &errors.iter().map(|(n, errors)| (libm::log(*n), -libm::log(field(errors)))).collect::<Vec<_>>(),
        )
    };
    FieldErrors {
        position: of(|errors| errors.position),
        velocity: of(|errors| errors.velocity),
        gradient: of(|errors| errors.gradient),
        area_map: of(|errors| errors.area_map),
        volume_map: of(|errors| errors.volume_map),
        stress: of(|errors| errors.stress),
    }
}

/// By how much an order falls short of a tenth above what is claimed: the bound of such a claim is that
/// tenth, and a control has an order lower by one at least.
pub(super) fn shortfall(claimed: f64, order: f64) -> f64 {
    if order.is_nan() { f64::NAN } else { (claimed + ALLOWED - order).max(0.0) }
}

/// The tenth.
pub(super) const ALLOWED: f64 = 0.1;

/// A claim that an order is at least so much: name, sentence, order, source, reason, measure, control.
macro_rules! order_claim {
    ($(#[$doc:meta])* $name:ident, $claim:literal, $least:literal, $source:expr, $because:expr, $order:expr, $control:expr) => {
        $(#[$doc])*
        pub(super) const $name: Claim = Claim {
            topic: $crate::verify::Topic::Convergence,
            claim: $claim,
            source: $source,
            because: $because,
            bound: $crate::verify::claims::convergence::orders::ALLOWED,
            measure: || $crate::verify::claims::convergence::orders::shortfall($least, $order),
            control: || $crate::verify::claims::convergence::orders::shortfall($least, $control),
        };
    };
}
pub(super) use order_claim;

/// The wrong variant of every case: the body force its large motion needs is left out.
pub(super) fn unforced(cells: u32) -> Cube {
    let motion = "normal = [cube.xmin, cube.ymin, cube.zmin]  tangential = [cube.xmax, cube.ymax, cube.zmax]
    body_force = off";
    Cube { motion, ..Cube::new(Case::NeoHooke, cells) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_has_its_exponent_as_slope() {
        let points: Vec<(f64, f64)> =
            [2.0_f64, 3.0, 5.0].iter().map(|n| (n.ln(), -(7.0 * n.powi(-2)).ln())).collect();
        assert!((slope(&points) - 2.0).abs() <= 1e-14);
    }
}
