//! What holds of every law, whatever its energy.

use super::{Directions, EnergyError, Invariant, Law, Leaf, Maps, Scratch};
use crate::expression::{Cone, Function, Node, Sphere, Tape};
use crate::tensor::{Mat3, Vec3};

/// `Σ invariants` and their products with the next one: every gradient and Hessian entry is alive.
fn everything() -> Tape<Leaf> {
    let invariants = [
        Invariant::I1,
        Invariant::I2,
        Invariant::I3,
        Invariant::J,
        Invariant::I1Bar,
        Invariant::I2Bar,
        Invariant::Stretch(0),
        Invariant::StretchBar(1),
        Invariant::Stretch(2),
        Invariant::I4(0),
        Invariant::I5(0),
        Invariant::I4Bar(1),
        Invariant::I5Bar(1),
        Invariant::I8(0, 1),
        Invariant::Green(1, 0),
        Invariant::Green(0, 1),
        Invariant::I8(1, 0),
        Invariant::I8(1, 1),
        Invariant::Green(0, 0),
        Invariant::RightCauchyGreen(0, 0),
        Invariant::RightCauchyGreen(2, 1),
        Invariant::Component(1, 2),
        Invariant::RightCauchyGreenBar(1, 1),
        Invariant::RightCauchyGreenBar(0, 2),
    ];
    let mut tape = Tape::new();
    let mut sum = tape.push(Node::Constant(1.0));
    for pair in invariants.windows(2) {
        let a = tape.push(Node::Leaf(Leaf::Invariant(pair[0])));
        let b = tape.push(Node::Leaf(Leaf::Invariant(pair[1])));
        let product = tape.push(Node::Multiply(a, b));
        sum = tape.push(Node::Add(sum, product));
    }
    // a fibre that is pulled, and every kernel of its own
    let fourth = tape.push(Node::Leaf(Leaf::Invariant(Invariant::I4Bar(0))));
    let one = tape.push(Node::Constant(1.0));
    let strain = tape.push(Node::Subtract(fourth, one));
    let pulled = tape.push(Node::Call(Function::Pos, strain));
    let power = tape.push(Node::Constant(2.3));
    let powered = tape.push(Node::Power(pulled, power));
    let growth = tape.push(Node::Call(Function::Exp, powered));
    let logarithm = tape.push(Node::Call(Function::Ln, growth));
    let product = tape.push(Node::Multiply(growth, logarithm));
    sum = tape.push(Node::Add(sum, product));
    // directions everywhere, and those that are stretched
    let bar = |i, j| Leaf::Invariant(Invariant::RightCauchyGreenBar(i, j));
    let shape =
        [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(i, j)| tape.push(Node::Leaf(bar(i, j))));
    let n = [0, 1, 2].map(|axis| tape.push(Node::Leaf(Leaf::Running(axis))));
    let mut strain = tape.push(Node::Constant(-1.0));
    for i in 0..3 {
        for j in 0..3 {
            let c = if i == j { shape[i] } else { shape[2 + i + j] };
            let along = tape.push(Node::Multiply(n[i], n[j]));
            let term = tape.push(Node::Multiply(along, c));
            strain = tape.push(Node::Add(strain, term));
        }
    }
    let square = tape.push(Node::Multiply(strain, strain));
    let skew = tape.push(Node::Multiply(square, n[0]));
    let uneven = tape.push(Node::Call(Function::Exp, skew));
    let everywhere = Sphere { order: 30, part: None };
    let all = tape.push(Node::Directions { sphere: everywhere, body: uneven });
    let within = tape.push(Node::Multiply(square, all));
    let stretched = Sphere { order: 60, part: Some(Cone { shape, above: one }) };
    let pulled = tape.push(Node::Directions { sphere: stretched, body: within });
    sum = tape.push(Node::Add(sum, all));
    tape.push(Node::Add(sum, pulled));
    tape
}

fn state() -> (Mat3, [Vec3; 2]) {
    let f = Mat3::new(1.2, 0.3, -0.1, 0.05, 0.9, 0.2, 0.15, -0.25, 1.1);
    (f, [Vec3::new(0.6, 0.8, 0.0), Vec3::new(0.0, 0.28, 0.96)])
}

fn density(law: &Law, f: &Mat3, directions: &[Vec3]) -> f64 {
    let mut out = [0.0];
    let maps = Maps { f: &[*f], h: None, j: None };
    law.density(maps, Directions::Uniform(directions), &mut out, &mut Scratch::default());
    out[0]
}

fn stress(law: &Law, f: &Mat3, directions: &[Vec3]) -> Mat3 {
    let mut out = [Mat3::zeros()];
    let maps = Maps { f: &[*f], h: None, j: None };
    law.stress(maps, Directions::Uniform(directions), &mut out, &mut Scratch::default());
    out[0]
}

#[test]
fn stress_and_tangent_of_every_invariant_are_derivatives() {
    let law = Law::compile(&everything(), &[]).unwrap();
    let (f, directions) = state();
    let p = stress(&law, &f, &directions);
    let tangent = law.tangent(&f, &directions, super::Kink::Slack);
    let step = 1e-4;
    for place in 0..9 {
        let mut e = Mat3::zeros();
        e.as_mut_slice()[place] = step;
        let slope =
            (density(&law, &(f + e), &directions) - density(&law, &(f - e), &directions)) / (2.0 * step);
        // the third derivative is some 1e2 times p; times step²/6 that is below 1e-6 p
        assert!((slope - p.as_slice()[place]).abs() < 1e-6 * p.norm(), "{slope} {p}");
        let change =
            (stress(&law, &(f + e), &directions) - stress(&law, &(f - e), &directions)) / (2.0 * step);
        let column = tangent.column(place);
        let error = change.iter().zip(column.iter()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error < 1e-6 * tangent.norm(), "{place}: {error} of {}", tangent.norm());
    }
}

#[test]
fn wider_instructions_change_no_bit() {
    let law = Law::compile(&everything(), &[]).unwrap();
    let (f, directions) = state();
    let states: Vec<Mat3> = (0..50).map(|k| f * (1.0 + 0.01 * f64::from(k))).collect();
    let maps = Maps { f: &states, h: None, j: None };
    let directions = Directions::Uniform(&directions);
    let run = |narrow: bool| {
        super::wide::NARROW.with(|cell| cell.set(narrow));
        let mut scratch = Scratch::default();
        let (mut p, mut psi, mut c) = (vec![Mat3::zeros(); 50], vec![0.0; 50], vec![0.0; 50]);
        law.stress(maps, directions, &mut p, &mut scratch);
        law.density(maps, directions, &mut psi, &mut scratch);
        law.wave_speed_block(maps, directions, 1.0, &mut c, &mut scratch);
        (p, psi, c)
    };
    assert_eq!(run(true), run(false));
}

#[test]
fn a_particles_stress_has_the_same_bits_wherever_it_stands() {
    let law = Law::compile(&everything(), &[]).unwrap();
    let (f, directions) = state();
    let alone = stress(&law, &f, &directions);
    for count in [2, 15, 16, 17, 40] {
        let maps: Vec<Mat3> = (0..count).map(|k| f * (1.0 + 0.01 * k as f64)).rev().collect();
        let mut out = vec![Mat3::zeros(); count];
        let given = Maps { f: &maps, h: None, j: None };
        law.stress(given, Directions::Uniform(&directions), &mut out, &mut Scratch::default());
        assert_eq!(out[count - 1], alone);
    }
}

#[test]
fn inadmissible_states_give_what_is_no_number_and_never_panic() {
    let law = Law::compile(&everything(), &[]).unwrap();
    let (f, directions) = state();
    let mirror = Mat3::from_diagonal(&Vec3::new(-1.0, 1.0, 1.0));
    for bad in [f * mirror, Mat3::zeros(), Mat3::repeat(f64::NAN), f * f64::INFINITY, f * 1e-120] {
        let p = stress(&law, &bad, &directions);
        assert!(!p.iter().all(|value| value.is_finite()), "{bad} gives {p}");
        assert!(!density(&law, &bad, &directions).is_finite());
        assert!(law.wave_speeds(&bad, &directions, 1.0).is_err());
        let mut speed = [0.0];
        let maps = Maps { f: &[bad], h: None, j: None };
        let mut scratch = Scratch::default();
        law.wave_speed_block(maps, Directions::Uniform(&directions), 1.0, &mut speed, &mut scratch);
        assert!(speed[0].is_nan());
    }
}

#[test]
fn a_law_that_is_not_complete_is_refused() {
    let refused = |leaf| Law::compile(&Tape::leaf(leaf), &[1.0]).map(|_| ());
    assert_eq!(Law::compile(&Tape::new(), &[]).map(|_| ()), Err(EnergyError::Empty));
    let missing = EnergyError::MissingParameter { index: 1, supplied: 1 };
    assert_eq!(refused(Leaf::Parameter(1)), Err(missing));
    let absent = EnergyError::NoSuchStretch { index: 3 };
    assert_eq!(refused(Leaf::Invariant(Invariant::Stretch(3))), Err(absent));
}
