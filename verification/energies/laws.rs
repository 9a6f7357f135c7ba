//! The energies the claims are about, as tapes.
//!
//! Owns nothing but the building: ψ as it stands in `specs/energies`, node by node, so that claims
//! on derivatives do not wait for the language.

use crate::energy::{Invariant, Law, Leaf};
use crate::expression::{Function, Node, NodeId, Tape};
use crate::tensor::{Mat3, Vec3};

/// Parameters of the law of equations 46 to 49 of the paper.
pub(crate) struct Artery {
    /// Half the shear modulus of the matrix, Pa.
    pub(crate) c: f64,
    /// Stiffness of a fibre family, Pa.
    pub(crate) k1: f64,
    /// Its stiffening.
    pub(crate) k2: f64,
    /// Its dispersion.
    pub(crate) kappa: f64,
    /// Compressibility, 1/Pa.
    pub(crate) d: f64,
}

/// The paper's Table 1, with `D` in 1/Pa.
pub(crate) const ARTERY: Artery = Artery { c: 7.64e3, k1: 996.6e3, k2: 524.6, kappa: 0.0, d: 1e-7 };

/// The same with dispersed fibres.
pub(crate) const DISPERSED: Artery = Artery { kappa: 0.226, ..ARTERY };

/// The same without fibres.
pub(crate) const MATRIX: Artery = Artery { k1: 0.0, ..ARTERY };

/// Angle of the fibres to the circumferential direction.
const FIBRE_ANGLE: f64 = 49.98;

/// Both families in the first two axes, `degrees` from the first.
pub(crate) fn families(degrees: f64) -> [Vec3; 2] {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    [Vec3::new(cos, sin, 0.0), Vec3::new(cos, -sin, 0.0)]
}

/// The families of a circumferential strip, whose length is the first axis.
pub(crate) fn circumferential() -> [Vec3; 2] {
    families(FIBRE_ANGLE)
}

/// A tape being written.
#[derive(Default)]
pub(crate) struct Writer {
    tape: Tape<Leaf>,
}

impl Writer {
    pub(crate) fn number(&mut self, value: f64) -> NodeId {
        self.tape.push(Node::Constant(value))
    }
    pub(crate) fn invariant(&mut self, invariant: Invariant) -> NodeId {
        self.tape.push(Node::Leaf(Leaf::Invariant(invariant)))
    }
    pub(crate) fn parameter(&mut self, index: u32) -> NodeId {
        self.tape.push(Node::Leaf(Leaf::Parameter(index)))
    }
    pub(crate) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.tape.push(Node::Add(a, b))
    }
    pub(crate) fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.tape.push(Node::Subtract(a, b))
    }
    pub(crate) fn minus(&mut self, a: NodeId, value: f64) -> NodeId {
        let b = self.number(value);
        self.subtract(a, b)
    }
    pub(crate) fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.tape.push(Node::Multiply(a, b))
    }
    pub(crate) fn divide(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.tape.push(Node::Divide(a, b))
    }
    pub(crate) fn power(&mut self, a: NodeId, exponent: f64) -> NodeId {
        let b = self.number(exponent);
        self.tape.push(Node::Power(a, b))
    }
    pub(crate) fn call(&mut self, function: Function, a: NodeId) -> NodeId {
        self.tape.push(Node::Call(function, a))
    }
    pub(crate) fn finish(self) -> Tape<Leaf> {
        self.tape
    }

    /// `C (Ī1 − 3)`
    fn matrix(&mut self, c: NodeId) -> NodeId {
        let i1_bar = self.invariant(Invariant::I1Bar);
        let excess = self.minus(i1_bar, 3.0);
        self.multiply(c, excess)
    }
}

/// `ψ = ½ μ (Ī1 − 3) + ½ k (J − 1)²` over the parameters μ and k.
pub(crate) fn neo_hooke() -> Tape<Leaf> {
    let mut w = Writer::default();
    let (mu, two, k) = (w.parameter(0), w.number(2.0), w.parameter(1));
    let c = w.divide(mu, two);
    let matrix = w.matrix(c);
    let j = w.invariant(Invariant::J);
    let dilation = w.minus(j, 1.0);
    let squared = w.power(dilation, 2.0);
    let half = w.divide(k, two);
    let volume = w.multiply(half, squared);
    w.add(matrix, volume);
    w.finish()
}

/// `ψ = C (Ī1 − 3) + k1/(2 k2) Σ_α [exp(k2 ⟨Ē_α⟩²) − 1] + (1/D)((J² − 1)/2 − ln J)`, parameters in that
/// order: C, k1, k2, κ, D. Without `bracket` a fibre also resists compression.
pub(crate) fn goh(families: u8, bracket: bool) -> Tape<Leaf> {
    let mut w = Writer::default();
    let [c, k1, k2, kappa, d] = std::array::from_fn(|index| w.parameter(index as u32));
    let mut psi = w.matrix(c);
    let (one, two, three) = (w.number(1.0), w.number(2.0), w.number(3.0));
    let mut sum = w.number(0.0);
    for a in 0..families {
        let i1_bar = w.invariant(Invariant::I1Bar);
        let excess = w.minus(i1_bar, 3.0);
        let dispersed = w.multiply(kappa, excess);
        let i4_bar = w.invariant(Invariant::I4Bar(a));
        let stretch = w.minus(i4_bar, 1.0);
        let triple = w.multiply(three, kappa);
        let aligned = w.subtract(one, triple);
        let along = w.multiply(aligned, stretch);
        let strain = w.add(dispersed, along);
        let pulled = if bracket { w.call(Function::Pos, strain) } else { strain };
        let squared = w.power(pulled, 2.0);
        let exponent = w.multiply(k2, squared);
        let growth = w.call(Function::Exp, exponent);
        let term = w.minus(growth, 1.0);
        sum = w.add(sum, term);
    }
    let twice = w.multiply(two, k2);
    let factor = w.divide(k1, twice);
    let fibres = w.multiply(factor, sum);
    psi = w.add(psi, fibres);
    let j = w.invariant(Invariant::J);
    let squared = w.power(j, 2.0);
    let numerator = w.minus(squared, 1.0);
    let half = w.divide(numerator, two);
    let logarithm = w.call(Function::Ln, j);
    let difference = w.subtract(half, logarithm);
    let inverse = w.divide(one, d);
    let volume = w.multiply(inverse, difference);
    w.add(psi, volume);
    w.finish()
}

impl Artery {
    pub(crate) fn parameters(&self) -> [f64; 5] {
        [self.c, self.k1, self.k2, self.kappa, self.d]
    }

    /// The law with two families.
    pub(crate) fn law(&self) -> Law {
        compiled(&goh(2, true), &self.parameters())
    }
}

/// A law that compiles.
pub(crate) fn compiled(psi: &Tape<Leaf>, parameters: &[f64]) -> Law {
    Law::compile(psi, parameters).expect("the laws of the claims are complete")
}

/// Numbers in `[0, 1)`, the same ones every time: splitmix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In `[-size, size)`.
    pub(crate) fn around_zero(&mut self, size: f64) -> f64 {
        size * (2.0 * self.number() - 1.0)
    }

    /// The identity and up to `size` more in every component.
    pub(crate) fn deformation(&mut self, size: f64) -> Mat3 {
        Mat3::from_fn(|i, j| f64::from(u8::from(i == j)) + self.around_zero(size))
    }

    pub(crate) fn unit(&mut self) -> Vec3 {
        loop {
            let v = Vec3::from_fn(|_, _| self.around_zero(1.0));
            if v.norm() > 0.1 {
                return v.normalize();
            }
        }
    }

    pub(crate) fn rotation(&mut self) -> Mat3 {
        let axis = nalgebra::Unit::new_normalize(self.unit());
        *nalgebra::Rotation3::from_axis_angle(&axis, self.around_zero(3.0)).matrix()
    }
}

/// The larger of two errors, or the one that is not a number: `f64::max` would drop it.
pub(crate) fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}
