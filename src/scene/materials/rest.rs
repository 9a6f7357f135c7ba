//! What must hold of a material at rest: no stress, and a resistance to any change of volume.

use super::*;
use crate::energy::{Kink, Law};
use crate::tensor::{Mat3, Vec3, cross};

/// Stress or bulk modulus relative to the tangent below which they are zero.
///
/// Both are sums of some hundred products of the size of the tangent, each rounded to 1.1e-16.
const ZERO: f64 = 1e-11;

/// Refuses an energy whose undeformed state is under stress or gives way to a change of volume.
///
/// ```text
/// P(I) = 0,   K = 1/9 ∂²ψ/∂F_iI ∂F_jJ δ_iI δ_jJ > 0
/// ```
///
/// The bulk modulus is that of compression, in which fibres with a Macaulay bracket are slack.
pub(super) fn check(mistakes: &mut Mistakes, energy: &Site, material: &Material) -> Result<(), Reported> {
    let span = energy.file.span(energy.id);
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    let law = Law::compile(&material.energy, &values).map_err(|error| {
        let message = format!("the energy cannot be compiled: {error}");
        mistakes.report(&energy.file, Code::WrongForm, span.clone(), message, "", None)
    })?;
    let directions = fixed(&material.directions);
    let identity = Mat3::identity();
    let p = at_rest(&law, &directions);
    let tangent = law.tangent(&identity, &directions, Kink::Slack);
    let stiffness = tangent.norm();
    if !(p.norm().is_finite() && stiffness.is_finite()) {
        let message = "the energy has no finite stress and stiffness at F = I";
        return Err(mistakes.report(&energy.file, Code::StressAtRest, span, message, "", None));
    }
    if p.norm() > ZERO * stiffness {
        let found = stress(&p, stiffness);
        let message = format!("the undeformed state must be free of stress, but at F = I it has P = {found}");
        let help = "write invariants with `bar` for the part that changes no volume, or add the missing volumetric term";
        return Err(mistakes.report(&energy.file, Code::StressAtRest, span, message, "", Some(help.into())));
    }
    let diagonal = [0, 4, 8];
    let sum: f64 = diagonal.iter().map(|&i| diagonal.iter().map(|&j| tangent[(i, j)]).sum::<f64>()).sum();
    let bulk = sum / 9.0;
    if bulk > ZERO * stiffness {
        let softest = softest_wave(&tangent);
        if softest >= -ZERO * stiffness {
            return Ok(());
        }
        let found = Quantity::new(softest, Dimension::PRESSURE);
        let message = format!(
            "the undeformed material must resist shear, but its acoustic tensor has the eigenvalue {found}"
        );
        let help = "check the signs of the terms: a positive modulus makes a term of `I1bar - 3` stable";
        return Err(mistakes.report(
            &energy.file,
            Code::NoVolumetricTerm,
            span,
            message,
            "",
            Some(help.into()),
        ));
    }
    let names: Vec<String> = material.terms.iter().map(|(name, _)| format!("`{name}`")).collect();
    let names = names.join(" + ");
    let (message, help) = if bulk < -ZERO * stiffness {
        let found = Quantity::new(bulk, Dimension::PRESSURE);
        (format!("the bulk modulus of {names} must be positive, but it is {found}"), None)
    } else {
        let help = "add a volumetric term, for example `+ vol_ogden2(D = 1e-7 Pa^-1)`".into();
        (format!("the bulk modulus is 0: {names} does not resist a change of volume"), Some(help))
    };
    Err(mistakes.report(&energy.file, Code::NoVolumetricTerm, span, message, "", help))
}

/// First Piola–Kirchhoff stress at `F = I`, Pa.
fn at_rest(law: &Law, directions: &[Vec3]) -> Mat3 {
    let identity = Mat3::identity();
    let stresses = law.conjugate_stresses(&identity, &identity, 1.0, directions);
    stresses.sigma_f + cross(&stresses.sigma_h, &identity) + stresses.sigma_j * identity
}

/// Stress at rest relative to the tangent that varying directions may cause: that of their lengths' last digits.
const ZERO_AT_PLACE: f64 = 1e-9;

/// The first of the places at which directions that vary put the undeformed body under stress, and that stress.
///
/// Places where a direction is not of unit length are passed over: they may lie outside the body.
pub(in crate::scene) fn stressed(material: &Material, places: &[Vec3]) -> Option<(Vec3, String)> {
    let is_fixed = |tape: &Tape<Coordinate>| matches!(tape.nodes(), [crate::expression::Node::Constant(_)]);
    if material.directions.iter().all(|direction| direction.components.iter().all(is_fixed)) {
        return None;
    }
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    let law = Law::compile(&material.energy, &values).ok()?;
    let mut scratch = Vec::new();
    places.iter().find_map(|place| {
        let leaf = |leaf: &Coordinate| match leaf {
            Coordinate::X(axis) => place[usize::from(*axis)],
            Coordinate::Time => 0.0,
        };
        let mut directions = Vec::new();
        for direction in &material.directions {
            let [x, y, z] =
                direction.components.each_ref().map(|component| component.evaluate(leaf, &mut scratch));
            let length = Vec3::new(x, y, z).norm();
            let is_unit = (length - 1.0).abs() < 1e-6;
            if !is_unit {
                return None;
            }
            directions.push(Vec3::new(x, y, z) / length);
        }
        let p = at_rest(&law, &directions);
        let stiffness = law.tangent(&Mat3::identity(), &directions, Kink::Slack).norm();
        (p.norm() > ZERO_AT_PLACE * stiffness).then(|| (*place, stress(&p, stiffness)))
    })
}

/// Smallest eigenvalue of the acoustic tensors along axes, face and space diagonals, Pa.
///
/// A modulus of zero is no mistake: the toe of some tissues has none.
fn softest_wave(tangent: &crate::energy::Tangent) -> f64 {
    let mut softest = f64::INFINITY;
    for x in [-1.0, 0.0, 1.0] {
        for y in [-1.0, 0.0, 1.0] {
            for z in [0.0, 1.0] {
                let Some(n) = Vec3::new(x, y, z).try_normalize(0.5) else { continue };
                let q = Mat3::from_fn(|i, j| {
                    (0..3)
                        .flat_map(|k| (0..3).map(move |l| (k, l)))
                        .fold(0.0, |sum, (k, l)| sum + n[k] * n[l] * tangent[(i + 3 * k, j + 3 * l)])
                });
                softest = softest.min(q.symmetric_eigenvalues().min());
            }
        }
    }
    softest
}

/// The directions at rest; one that depends on place is replaced by an axis, which is as good a unit vector.
fn fixed(directions: &[Direction]) -> Vec<Vec3> {
    let component = |tape: &Tape<Coordinate>| match tape.nodes() {
        [crate::expression::Node::Constant(value)] => Some(*value),
        _ => None,
    };
    directions
        .iter()
        .enumerate()
        .map(|(index, direction)| match direction.components.each_ref().map(component) {
            [Some(x), Some(y), Some(z)] => Vec3::new(x, y, z),
            _ => Vec3::ith(index % 3, 1.0),
        })
        .collect()
}

/// A stress in words: its diagonal if it has nothing else, its largest component otherwise.
fn stress(p: &Mat3, stiffness: f64) -> String {
    let off = p - Mat3::from_diagonal(&p.diagonal());
    if off.norm() <= ZERO * stiffness {
        return format!("diag({:.4e}, {:.4e}, {:.4e}) Pa", p[(0, 0)], p[(1, 1)], p[(2, 2)]);
    }
    let rows: Vec<String> =
        (0..3).map(|i| format!("[{:.4e}, {:.4e}, {:.4e}]", p[(i, 0)], p[(i, 1)], p[(i, 2)])).collect();
    format!("[{}] Pa", rows.join(", "))
}
