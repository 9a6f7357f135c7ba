//! What a material must satisfy, should satisfy, and had better be known for.

use super::elliptic::EllipticPath;
use super::quadrature::Quadrature;
use super::render::quantity;
use crate::energy::Kink;
use crate::energy::audit::{
    Subject, asymmetry_of_tangent, baker_ericksen, derivative_error, derivative_order,
    deviator_under_dilation, material_symmetry_error, objectivity_error, smallest_volumetric_stiffness,
    stress_at_rest, volumetric_growth,
};
use crate::tensor::Mat3;
use serde::Serialize;

/// How a property stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// It holds.
    Holds,
    /// It does not, and nothing computed with the law makes sense.
    Broken,
    /// It does not hold everywhere looked at; the law may still be used where it does.
    Warns,
    /// The question does not arise.
    NotAsked,
}

/// One property of a material.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Property {
    /// The property as a word.
    pub property: &'static str,
    /// How it stands.
    pub standing: Standing,
    /// The number it is judged by; not a number if there is none.
    pub measured: f64,
    /// The bound on that number, where there is one.
    pub bound: Option<f64>,
    /// What was found, in words.
    pub found: String,
}

/// Relative error of sums of some hundred products rounded to 1.1e-16 that cancel a thousandfold.
const ROUND_OFF: f64 = 1e-11;

/// Step of the differences of the energy; its square times the exponents of stiff tissue is 1e-4.
const DIFFERENCE: f64 = 1e-4;

/// Relative error of differences at which the order says nothing any more: 1e-16 over the step, thousandfold.
const EXACT: f64 = 1e-9;

/// Order that central differences must show.
const ORDER: f64 = 1.9;

/// Stretch at which a fibre must feel that the body was blown up.
const BLOWN_UP: f64 = 1.02;

/// Stretches to an edge of the cube of Baker and Ericksen.
const EDGE: usize = 8;

/// Volumes scanned for convexity.
const VOLUMES: ([f64; 2], usize) = ([0.5, 2.0], 60);

/// All properties, the indispensable ones first.
pub(super) fn properties(
    subject: &Subject,
    ellipticity: &[EllipticPath],
    stretches: [f64; 2],
    quadrature: Option<Quadrature>,
) -> Vec<Property> {
    let f = generic(subject);
    let mut properties = vec![
        derivative(subject, &f),
        stress_free(subject),
        round_off("objective", "|P(QF) - Q P(F)|/|P|", objectivity_error(subject, &f)),
        round_off("symmetric_tangent", "|A - A^T|/|A|", asymmetry_of_tangent(subject, &f)),
        material_symmetry(subject, &f, quadrature.as_ref()),
        elliptic(ellipticity, stretches),
        ordered(subject, stretches),
        convex_in_volume(subject),
        grows(subject),
        feels_volume(subject),
    ];
    properties.extend(quadrature.map(integrated));
    properties
}

/// A rule over the whole sphere stands in the common axes; turning the body turns it by its error.
fn material_symmetry(subject: &Subject, f: &Mat3, quadrature: Option<&Quadrature>) -> Property {
    let error = material_symmetry_error(subject, f);
    let what = "|P(FQ^T; Qa) - P(F; a)Q^T|/|P|";
    let bound = quadrature.map_or(ROUND_OFF, |quadrature| ROUND_OFF.max(10.0 * quadrature.worst));
    let standing = hard(error <= bound);
    let found = format!("{what} = {error:.1e}");
    Property { property: "material_symmetry", standing, measured: error, bound: Some(bound), found }
}

/// Relative error of a stress that no measurement of tissue could tell.
const INTEGRATED: f64 = 1e-6;

fn integrated(quadrature: Quadrature) -> Property {
    let Quadrature { order, worst, place } = quadrature;
    let found = format!("order {order} against twice that: {worst:.1e} of the stress at {place}");
    let standing = soft(worst <= INTEGRATED);
    Property { property: "integration", standing, measured: worst, bound: Some(INTEGRATED), found }
}

/// A state of some 5 % strain without any symmetry, or a smaller one where stiff exponentials overflow.
fn generic(subject: &Subject) -> Mat3 {
    let strain = Mat3::new(0.6, 0.3, -0.2, 0.1, -0.4, 0.5, -0.3, 0.2, 0.35);
    let mut size = 0.05;
    for _ in 0..10 {
        let f = Mat3::identity() + size * strain;
        let tangent = subject.law.tangent(&f, subject.directions, Kink::Slack);
        if tangent.iter().all(|value| value.is_finite()) && subject.density(&f).is_finite() {
            break;
        }
        size *= 0.5;
    }
    Mat3::identity() + size * strain
}

/// `Broken` unless the condition holds; written so that what is no number breaks it.
fn hard(holds: bool) -> Standing {
    if holds { Standing::Holds } else { Standing::Broken }
}

fn soft(holds: bool) -> Standing {
    if holds { Standing::Holds } else { Standing::Warns }
}

fn round_off(property: &'static str, what: &str, error: f64) -> Property {
    let found = format!("{what} = {error:.1e}");
    Property { property, standing: hard(error <= ROUND_OFF), measured: error, bound: Some(ROUND_OFF), found }
}

fn derivative(subject: &Subject, f: &Mat3) -> Property {
    let order = derivative_order(subject, f, DIFFERENCE);
    let error = derivative_error(subject, f, DIFFERENCE);
    let is_exact = error <= EXACT;
    let found = match is_exact {
        true => format!("P equals the differences of the energy to {error:.0e}"),
        false => format!("P equals the differences of the energy with order {order:.2}"),
    };
    let standing = soft(is_exact || order >= ORDER);
    Property { property: "derivative", standing, measured: order, bound: Some(ORDER), found }
}

fn stress_free(subject: &Subject) -> Property {
    let stiffness = subject.law.tangent(&Mat3::identity(), subject.directions, Kink::Slack).norm();
    let error = stress_at_rest(subject).norm() / stiffness;
    round_off("stress_free", "|P(I)|/|A(I)|", error)
}

fn elliptic(paths: &[EllipticPath], [low, high]: [f64; 2]) -> Property {
    let lost = places(paths, |path| [path.lost_in_compression, path.lost_in_tension]);
    let unknown = places(paths, |path| [path.unknown_in_compression, path.unknown_in_tension]);
    let at_rest = paths.iter().find(|path| path.lost_in_tension == Some(1.0)).and_then(|path| path.travel);
    let smallest = paths.iter().min_by(|a, b| a.smallest.total_cmp(&b.smallest));
    let (measured, place) = smallest.map_or((f64::NAN, String::new()), |path| {
        (path.smallest, format!("{:.3} of {}", path.smallest_at, path.path))
    });
    let mut found = match at_rest {
        Some([x, y, z]) => {
            format!("lost at rest: no stiffness against a wave along [{x:.2}, {y:.2}, {z:.2}]")
        }
        None if lost.is_empty() => {
            format!("stretches {low} to {high}: at least {} (at {place})", quantity(measured, "Pa"))
        }
        None => format!("lost at {lost}"),
    };
    if !unknown.is_empty() {
        found.push_str(&format!("; too stiff to tell from {unknown}"));
    }
    let standing = soft(lost.is_empty());
    let measured = if lost.is_empty() { measured } else { 0.0 };
    Property { property: "elliptic", standing, measured, bound: Some(0.0), found }
}

/// `0.7985 and 1.1143 of isochoric stretch along a1, 0.8451 of dilation`
fn places(paths: &[EllipticPath], at: fn(&EllipticPath) -> [Option<f64>; 2]) -> String {
    let on_path = |path: &EllipticPath| {
        let stretches: Vec<String> = at(path).into_iter().flatten().map(|at| format!("{at:.4}")).collect();
        (!stretches.is_empty()).then(|| format!("{} of {}", stretches.join(" and "), path.path))
    };
    paths.iter().filter_map(on_path).collect::<Vec<_>>().join(", ")
}

fn ordered(subject: &Subject, [low, high]: [f64; 2]) -> Property {
    let property = "baker_ericksen";
    let Some(worst) = baker_ericksen(subject, low, high, EDGE) else {
        let found = "asked of isotropic laws only".into();
        return Property { property, standing: Standing::NotAsked, measured: f64::NAN, bound: None, found };
    };
    let l = worst.stretches;
    let found = format!(
        "smallest slope {} at stretches {:.2}, {:.2}, {:.2}",
        quantity(worst.smallest, "Pa"),
        l.x,
        l.y,
        l.z
    );
    Property {
        property,
        standing: soft(worst.smallest > 0.0),
        measured: worst.smallest,
        bound: Some(0.0),
        found,
    }
}

fn convex_in_volume(subject: &Subject) -> Property {
    let ([low, high], count) = VOLUMES;
    let (smallest, at) = smallest_volumetric_stiffness(subject, low, high, count);
    let found = format!(
        "smallest d2psi/dJ2 {} at J = {at:.2}; necessary for polyconvexity of a split law only",
        quantity(smallest, "Pa")
    );
    let standing = soft(smallest >= 0.0);
    Property { property: "convex_in_volume", standing, measured: smallest, bound: Some(0.0), found }
}

fn grows(subject: &Subject) -> Property {
    let growth = volumetric_growth(subject);
    // a logarithm grows with −0.08 between the volumes looked at
    let resists_crushing = growth.towards_zero < -0.01 || growth.towards_zero.is_nan();
    let crushed = match resists_crushing {
        true => "unbounded as J -> 0",
        false => "finite as J -> 0: the law can be crushed to nothing",
    };
    let outwards = match growth.towards_infinity.is_finite() {
        true => format!("J^{:.2} as J -> infinity", growth.towards_infinity),
        false => "beyond all numbers as J grows".into(),
    };
    let standing =
        soft(resists_crushing && (growth.towards_infinity.is_nan() || growth.towards_infinity >= 1.0));
    let found = format!("{crushed}; {outwards}");
    Property { property: "volumetric_growth", standing, measured: growth.towards_zero, bound: None, found }
}

fn feels_volume(subject: &Subject) -> Property {
    let property = "fibres_feel_volume";
    if subject.law.directions() == 0 {
        let found = "the law reads no direction".into();
        return Property { property, standing: Standing::NotAsked, measured: f64::NAN, bound: None, found };
    }
    let share = deviator_under_dilation(subject, BLOWN_UP);
    let f = BLOWN_UP * Mat3::identity();
    let pressure = subject.stress(&f).trace() / 3.0 / (BLOWN_UP * BLOWN_UP);
    let pressure = quantity(pressure, "Pa");
    let feel = share > ROUND_OFF;
    let found = match feel {
        true => format!("{:.1} % of the stress at F = {BLOWN_UP} I is theirs", 100.0 * share),
        false => format!("blind: at F = {BLOWN_UP} I the stress is hydrostatic, {pressure}"),
    };
    Property { property, standing: soft(feel), measured: share, bound: Some(ROUND_OFF), found }
}
