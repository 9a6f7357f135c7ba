use super::*;
use crate::expression::{Function, Node, Number};

/// `x = X + a sin(k·X + w t)`, every component of the wave's own.
fn wave() -> [Tape<Input>; 3] {
    let component = |axis: usize| {
        let mut tape = Tape::new();
        let own = tape.push(Node::Leaf(axis));
        let mut phase = tape.push(Node::Constant(0.3));
        for (input, weight) in [1.1, -0.7, 0.9, 40.0].into_iter().enumerate() {
            let weight = tape.push(Node::Constant(weight + 0.2 * axis as f64));
            let leaf = tape.push(Node::Leaf(input));
            let product = tape.push(Node::Multiply(weight, leaf));
            phase = tape.push(Node::Add(phase, product));
        }
        let sine = tape.push(Node::Call(Function::Sin, phase));
        let amplitude = tape.push(Node::Constant(0.1 - 0.03 * axis as f64));
        let product = tape.push(Node::Multiply(amplitude, sine));
        tape.push(Node::Add(own, product));
        tape
    };
    [component(0), component(1), component(2)]
}

/// Every invariant that is a formula of `F`, in products of two, and a fibre that is pulled.
fn everything() -> Tape<Leaf> {
    use Invariant::{Green, I1, I1Bar, I2, I2Bar, I3, I4, I4Bar, I5, I5Bar, I8, J};
    let all = [I1, I2, I3, J, I1Bar, I2Bar, I4(0), I5(0), I4Bar(1), I5Bar(1), I8(0, 1), Green(0, 1), J];
    let mut tape = Tape::new();
    let mut sum = tape.push(Node::Constant(1.0));
    for pair in all.windows(2) {
        let a = tape.push(Node::Leaf(Leaf::Invariant(pair[0])));
        let b = tape.push(Node::Leaf(Leaf::Invariant(pair[1])));
        let product = tape.push(Node::Multiply(a, b));
        sum = tape.push(Node::Add(sum, product));
    }
    let fourth = tape.push(Node::Leaf(Leaf::Invariant(I4Bar(0))));
    let half = tape.push(Node::Constant(0.5));
    let strain = tape.push(Node::Subtract(fourth, half));
    let pulled = tape.push(Node::Call(Function::Pos, strain));
    let square = tape.push(Node::Multiply(pulled, pulled));
    let growth = tape.push(Node::Call(Function::Exp, square));
    tape.push(Node::Add(sum, growth));
    tape
}

/// A direction that turns with the place, and one that does not.
fn directions() -> [[Tape<Input>; 3]; 2] {
    let turning = |function| {
        let mut tape = Tape::new();
        let x = tape.push(Node::Leaf(0));
        tape.push(Node::Call(function, x));
        tape
    };
    [
        [turning(Function::Cos), turning(Function::Sin), Tape::constant(0.0)],
        [Tape::constant(0.0), Tape::constant(0.6), Tape::constant(0.8)],
    ]
}

fn points() -> Vec<Vec3> {
    (0..37).map(|n| Vec3::new(0.013 * f64::from(n), 0.4 - 0.007 * f64::from(n), 0.21)).collect()
}

#[test]
fn the_traced_force_is_that_of_the_nested_duals() {
    let (position, energy, directions) = (wave(), everything(), directions());
    let source = MotionSource {
        position: &position,
        energy: &energy,
        parameters: &[],
        directions: &directions,
        density: 3.0,
        input: |leaf| *leaf,
    };
    let motion = ExactMotion::compile(&source).expect("the energy names no stretch");
    let (points, time) = (points(), 0.017);
    let mut traced = vec![Vec3::zeros(); points.len()];
    motion.body_forces(&points, time, &mut traced, &mut Scratch::default());
    for (point, traced) in points.iter().zip(traced) {
        let at = [point.x, point.y, point.z, time].map(Number);
        let direct = Vec3::from(source.body_force(&at).map(|component| component.0));
        // some 2000 operations, their roundings adding up like a random walk, of terms ten times the sum
        assert!((traced - direct).norm() <= 1e-13 * direct.norm(), "{traced} {direct}");
    }
}

#[test]
fn a_state_has_the_slopes_of_its_position() {
    let (position, energy) = (wave(), everything());
    let source = MotionSource {
        position: &position,
        energy: &energy,
        parameters: &[],
        directions: &directions(),
        density: 1.0,
        input: |leaf| *leaf,
    };
    let motion = ExactMotion::compile(&source).expect("the energy names no stretch");
    let (points, time) = (points(), 0.017);
    let mut states = vec![MotionState::default(); points.len()];
    motion.states(&points, time, &mut states, &mut Scratch::default());
    for (x, state) in points.iter().zip(states) {
        for axis in 0..3 {
            let amplitude = 0.1 - 0.03 * axis as f64;
            let k = Vec3::new(1.1, -0.7, 0.9).add_scalar(0.2 * axis as f64);
            let w = 40.0 + 0.2 * axis as f64;
            let phase = 0.3 + k.dot(x) + w * time;
            let slope = amplitude * libm::cos(phase);
            assert!((state.position[axis] - x[axis] - amplitude * libm::sin(phase)).abs() <= 1e-15);
            assert!((state.velocity[axis] - slope * w).abs() <= 1e-14);
            for column in 0..3 {
                let own = if axis == column { 1.0 } else { 0.0 };
                assert!((state.gradient[(axis, column)] - own - slope * k[column]).abs() <= 1e-15);
            }
        }
    }
}

#[test]
fn stretches_are_refused() {
    let energy = Tape::leaf(Leaf::Invariant(Invariant::Stretch(0)));
    let source = MotionSource {
        position: &wave(),
        energy: &energy,
        parameters: &[],
        directions: &[],
        density: 1.0,
        input: |leaf| *leaf,
    };
    assert_eq!(ExactMotion::compile(&source).err(), Some(EnergyError::StretchOfMotion));
}
