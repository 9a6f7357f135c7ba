//! How far an integral over directions is from one of twice its order.

use super::elliptic::ways;
use crate::energy::audit::Subject;
use crate::energy::{EnergyError, LARGEST_ORDER, Law};
use crate::scene::Material;
use crate::tensor::{Mat3, Vec3};

/// Stretches the two are compared at, along each way.
const STRETCHES: [f64; 6] = [0.85, 0.95, 1.02, 1.05, 1.1, 1.3];

/// Amounts of shear.
const SHEARS: [f64; 3] = [0.02, 0.1, 0.4];

/// The largest difference found.
pub(super) struct Quadrature {
    /// Largest order the law is integrated with.
    pub(super) order: u16,
    /// `|P − P'|/|P'|`, `P'` with twice the order.
    pub(super) worst: f64,
    /// The state it was found at.
    pub(super) place: String,
}

/// Compares the law with itself at twice the order; `None` if it integrates over no directions.
///
/// States: stretches along every direction at constant volume and confined, wide strips that keep
/// their width, and simple shears. Half of these have a cone of stretched directions with a saddle on it,
/// the worst case of a rule.
pub(super) fn error(
    subject: &Subject,
    material: &Material,
    values: &[f64],
    named: &[(String, Vec3)],
) -> Result<Option<Quadrature>, EnergyError> {
    let Some(order) = material.energy.orders().max() else { return Ok(None) };
    let twice = |order: u16| (2 * order).min(LARGEST_ORDER);
    let finer = Law::compile(&material.energy.clone().with_orders(twice), values)?;
    let reference = Subject { law: &finer, directions: subject.directions };
    let mut found = Quadrature { order, worst: 0.0, place: "rest".into() };
    for (place, f) in states(named) {
        let (p, exact) = (subject.stress(&f), reference.stress(&f));
        let error = (p - exact).norm() / exact.norm();
        if error > found.worst {
            (found.worst, found.place) = (error, place);
        }
    }
    Ok(Some(found))
}

fn states(named: &[(String, Vec3)]) -> Vec<(String, Mat3)> {
    let mut states = Vec::new();
    for (name, way) in ways(named) {
        states.extend(STRETCHES.map(|stretch| (format!("{stretch} of {name}"), way.state(stretch))));
    }
    let mut axes = vec![Vec3::x(), Vec3::y(), Vec3::z()];
    axes.extend(named.iter().map(|(_, a)| *a));
    for (first, a) in axes.iter().enumerate() {
        let across = axes.iter().map(|b| b - a.dot(b) * a).find(|b| b.norm() > 0.1);
        let Some(b) = across.map(|b| b.normalize()) else { continue };
        for stretch in STRETCHES {
            let f = Mat3::identity()
                + (stretch - 1.0) * a * a.transpose()
                + (1.0 / stretch - 1.0) * b * b.transpose();
            states.push((format!("{stretch} of planar stretch {}", first + 1), f));
        }
        for amount in SHEARS {
            states.push((
                format!("simple shear {amount}, {}", first + 1),
                Mat3::identity() + amount * a * b.transpose(),
            ));
        }
    }
    states
}
