//! Drives against closed forms.

use super::*;
use crate::energy::{Invariant, Law, Leaf};
use crate::expression::{Node, Tape};
use crate::tensor::{Mat3, Vec3};

const SHEAR: f64 = 3.5e3;

/// `½ μ (Ī1 − 3) + ½ k (J − 1)²`; without the volumetric part where `bulk` is zero.
fn neo_hooke(bulk: f64) -> Law {
    let mut tape = Tape::new();
    let i1_bar = tape.push(Node::Leaf(Leaf::Invariant(Invariant::I1Bar)));
    let three = tape.push(Node::Constant(3.0));
    let excess = tape.push(Node::Subtract(i1_bar, three));
    let half_shear = tape.push(Node::Constant(0.5 * SHEAR));
    let matrix = tape.push(Node::Multiply(half_shear, excess));
    if bulk != 0.0 {
        let j = tape.push(Node::Leaf(Leaf::Invariant(Invariant::J)));
        let one = tape.push(Node::Constant(1.0));
        let dilation = tape.push(Node::Subtract(j, one));
        let squared = tape.push(Node::Multiply(dilation, dilation));
        let half_bulk = tape.push(Node::Constant(0.5 * bulk));
        let volume = tape.push(Node::Multiply(half_bulk, squared));
        tape.push(Node::Add(matrix, volume));
    }
    Law::compile(&tape, &[]).expect("a law")
}

fn incompressible(law: &Law) -> Drive<'_> {
    Drive { volume: Volume::Incompressible, ..Drive::new(law, &[]) }
}

fn steps(from: f64, to: f64, n: u32) -> Vec<f64> {
    (0..=n).map(|i| from + (to - from) * f64::from(i) / f64::from(n)).collect()
}

/// Largest difference of the stresses to closed forms, over the shear modulus.
fn worst(points: &[Point], exact: impl Fn(f64) -> [(usize, usize, f64); 3]) -> f64 {
    let differences = points.iter().flat_map(|point| {
        exact(point.parameter).map(|(i, j, wanted)| (point.cauchy[(i, j)] / SHEAR - wanted).abs())
    });
    differences.fold(0.0, f64::max)
}

// Closed forms of the incompressible neo-Hookean solid (Ogden 1984). Stretches reach 3, terms 10, and
// the equilibrium is good to some 10 round-offs of the largest term: 1e-14 of the modulus.

#[test]
fn incompressible_tension_follows_the_closed_form_from_compression_to_threefold_length() {
    let law = neo_hooke(0.0);
    let points = incompressible(&law).follow(Target::uniaxial, &steps(0.4, 3.0, 26)).expect("driven");
    assert!(worst(&points, |l| [(0, 0, l * l - 1.0 / l), (1, 1, 0.0), (2, 2, 0.0)]) < 1e-13);
    assert!(worst(&points, |l| [(0, 0, l * l - 1.001 / l), (1, 1, 0.0), (2, 2, 0.0)]) > 1e-4);
    for point in &points {
        assert!((point.j - 1.0).abs() < 1e-15 * 10.0, "{point:?}");
        let l = point.parameter;
        assert!((point.psi / SHEAR - 0.5 * (l * l + 2.0 / l - 3.0)).abs() < 1e-14);
    }
}

#[test]
fn incompressible_sheets_follow_their_closed_forms() {
    let law = neo_hooke(0.0);
    let drive = incompressible(&law);
    let stretches = steps(1.0, 2.0, 10);
    let points = drive.follow(Target::equibiaxial, &stretches).expect("driven");
    assert!(
        worst(&points, |l| {
            let sigma = l * l - 1.0 / (l * l * l * l);
            [(0, 0, sigma), (1, 1, sigma), (2, 2, 0.0)]
        }) < 1e-13
    );
    let points = drive.follow(Target::planar, &stretches).expect("driven");
    let exact = |l: f64| [(0, 0, l * l - 1.0 / (l * l)), (1, 1, 1.0 - 1.0 / (l * l)), (2, 2, 0.0)];
    assert!(worst(&points, exact) < 1e-13);
    let path = |l: f64| Target::biaxial(l, 1.0 + 0.5 * (l - 1.0));
    let points = drive.follow(path, &stretches).expect("driven");
    assert!(
        worst(&points, |l| {
            let m = 1.0 + 0.5 * (l - 1.0);
            let thickness = 1.0 / (l * m * l * m);
            [(0, 0, l * l - thickness), (1, 1, m * m - thickness), (2, 2, 0.0)]
        }) < 1e-13
    );
}

#[test]
fn simple_shear_has_the_poynting_stress_in_any_plane() {
    let law = neo_hooke(0.0);
    let (m, n) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, 1.0, 0.0));
    let frame = frame(&m, &n).expect("orthonormal");
    let drive = Drive { frame, ..incompressible(&law) };
    let points = drive.follow(Target::simple_shear_free, &steps(0.0, 1.5, 6)).expect("driven");
    for Point { parameter: g, cauchy, f, .. } in &points {
        assert!((m.dot(&(cauchy * n)) / SHEAR - g).abs() < 1e-13);
        assert!((m.dot(&(cauchy * m)) / SHEAR - g * g).abs() < 1e-13);
        assert!((n.dot(&(cauchy * n)) / SHEAR).abs() < 1e-13);
        assert!((f - (Mat3::identity() + *g * m * n.transpose())).norm() < 1e-14);
    }
    let g = points[6].parameter;
    assert!((points[6].cauchy[(0, 0)] / SHEAR - g * g).abs() > 0.1, "the axes of the frame matter");
}

// ψ = c (I1bar − 3)² + c (J − 1)²: no stiffness against shear at rest, σ11 = 4 c (I1 − 3) (λ² − 1/λ) away from it.
#[test]
fn a_law_without_stiffness_at_rest_leaves_it() {
    let mut tape = Tape::new();
    let i1_bar = tape.push(Node::Leaf(Leaf::Invariant(Invariant::I1Bar)));
    let three = tape.push(Node::Constant(3.0));
    let excess = tape.push(Node::Subtract(i1_bar, three));
    let squared = tape.push(Node::Multiply(excess, excess));
    let j = tape.push(Node::Leaf(Leaf::Invariant(Invariant::J)));
    let one = tape.push(Node::Constant(1.0));
    let dilation = tape.push(Node::Subtract(j, one));
    let resisted = tape.push(Node::Multiply(dilation, dilation));
    let sum = tape.push(Node::Add(squared, resisted));
    let c = tape.push(Node::Constant(SHEAR));
    tape.push(Node::Multiply(c, sum));
    let law = Law::compile(&tape, &[]).expect("a law");
    let stiffening = |l: f64| 4.0 * (l * l + 2.0 / l - 3.0) * (l * l - 1.0 / l);
    let points = incompressible(&law).follow(Target::uniaxial, &steps(1.1, 2.0, 9)).expect("driven");
    // Stresses reach 28 moduli, good to some ten round-offs.
    assert!(worst(&points, |l| [(0, 0, stiffening(l)), (1, 1, 0.0), (2, 2, 0.0)]) < 1e-13);
    assert!(worst(&points, |l| [(0, 0, 1.001 * stiffening(l)), (1, 1, 0.0), (2, 2, 0.0)]) > 1e-4);
    for point in &points {
        assert!((point.f[(1, 1)] - point.f[(2, 2)]).abs() < 1e-12, "it stays as round as it was: {point:?}");
    }
}

#[test]
fn a_nearly_incompressible_law_converges_to_the_incompressible_one() {
    // The difference falls in proportion to μ/k: by ten for ten times the bulk modulus.
    let exact = incompressible(&neo_hooke(0.0)).follow(Target::uniaxial, &[2.0]).expect("driven")[0];
    let difference = |bulk: f64| {
        let law = neo_hooke(bulk);
        let point = Drive::new(&law, &[]).follow(Target::uniaxial, &[2.0]).expect("driven")[0];
        (point.cauchy[(0, 0)] - exact.cauchy[(0, 0)]).abs()
    };
    let ratio = difference(1e7) / difference(1e8);
    assert!((ratio - 10.0).abs() < 0.05, "{ratio}");
}

#[test]
fn driving_by_the_stress_found_returns_the_stretch() {
    let law = neo_hooke(1e5);
    let drive = Drive::new(&law, &[]);
    let stretches = steps(0.7, 1.6, 9);
    let by_stretch = drive.follow(Target::uniaxial, &stretches).expect("driven");
    let with = |control: fn(f64) -> Control, value: fn(&Point) -> f64| -> Vec<f64> {
        let loads: Vec<f64> = by_stretch.iter().map(value).collect();
        let path = |load: f64| {
            let mut target = Target::uniaxial(1.0);
            target.components[0][0] = control(load);
            target
        };
        let points = drive.follow(path, &loads).expect("driven");
        points.iter().map(|point| point.f[(0, 0)]).collect()
    };
    let by_force = with(Control::FirstPiola, |point| point.first_piola[(0, 0)]);
    let by_traction = with(Control::Cauchy, |point| point.cauchy[(0, 0)]);
    for ((stretch, force), traction) in stretches.iter().zip(&by_force).zip(&by_traction) {
        assert!((stretch - force).abs() < 1e-13 && (stretch - traction).abs() < 1e-13);
    }
}

#[test]
fn a_prescribed_deformation_gradient_is_imposed_as_it_is() {
    let law = neo_hooke(1e5);
    let path = |t: f64| Mat3::identity() + t * Mat3::new(0.3, 0.4, -0.1, 0.2, -0.2, 0.5, 0.0, 0.1, 0.3);
    let points = Drive::new(&law, &[]).follow(|t| Target::deformation(&path(t)), &steps(0.0, 1.0, 4));
    for point in points.expect("driven") {
        assert_eq!(point.f, path(point.parameter));
        assert_eq!(point.residual, 0.0);
    }
}

#[test]
fn what_cannot_be_driven_is_refused_with_its_cause() {
    let law = neo_hooke(0.0);
    let message = |result: Result<Vec<Point>, DriveError>| result.expect_err("impossible").to_string();
    assert!(
        message(incompressible(&law).follow(Target::simple_shear, &[0.1]))
            .starts_with("all of F is prescribed at parameter 1.0")
    );
    assert!(message(incompressible(&law).follow(Target::uniaxial, &[1.1, f64::NAN])).contains("not finite"));
    let error = incompressible(&law).follow(Target::uniaxial, &[1.0, 0.5, -0.5]).expect_err("inverts");
    assert!(
        matches!(error, DriveError::NoEquilibrium { reached, wanted: -0.5, .. } if reached > 0.0 && reached < 0.5),
        "{error}"
    );
    let error = incompressible(&law).follow(Target::uniaxial, &[-0.5]).expect_err("inverts");
    assert!(matches!(error, DriveError::NoStart { wanted: -0.5, part, .. } if part < 0.67), "{error}");
    // A dead load beyond what a law in compression can carry: k (J − 1) is bounded by −k.
    let bounded = neo_hooke(1e5);
    let crush = |load: f64| {
        let mut target = Target::deformation(&Mat3::identity());
        for i in 0..3 {
            target.components[i][i] = Control::Cauchy(load);
        }
        target
    };
    let error = Drive::new(&bounded, &[]).follow(crush, &[-0.5e5, -1.5e5]).expect_err("crushed");
    assert!(matches!(error, DriveError::NoEquilibrium { .. }), "{error}");
    assert!(matches!(frame(&Vec3::x(), &Vec3::new(0.1, 1.0, 0.0)), Err(DriveError::Frame { .. })));
    assert!(Drive::new(&law, &[]).follow(Target::uniaxial, &[]).expect("nothing").is_empty());
}
