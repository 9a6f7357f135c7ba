//! A hash-consed graph of real operations: equal expressions are one node.
//!
//! Owns the operations a traced law is made of and the rewrites that keep every value bit for bit:
//! constants are folded, neutral elements vanish, negation moves outwards, commuting operands are
//! put in order, a bracket absorbs its slope. Knows no derivative; those are written into it by num-dual.

use super::mixture::Mixture;
use crate::expression::{Comparison, Scalar};
use std::collections::HashMap;
use std::hash::BuildHasherDefault;

/// Index of a node.
pub(super) type Node = u32;

/// Functions of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Unary {
    Negate,
    Reciprocal,
    Sqrt,
    Cbrt,
    ReciprocalCbrt,
    Exp,
    ExpM1,
    Ln,
    Sin,
    Cos,
    Tan,
    Tanh,
    Cosh,
    Sinh,
    Erf,
    Pos,
    Step,
    /// The step that counts the kink itself as loaded.
    StepTaut,
    /// The value itself, by another name.
    Same,
}

/// Functions of two arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    /// `x^e`, the exponent a constant.
    Power,
}

/// One node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    /// A quantity supplied from outside, by its place in the list.
    Input(u32),
    /// A number, by its bits.
    Constant(u64),
    Unary(Unary, Node),
    Binary(Binary, Node, Node),
    Select(Comparison, [Node; 4]),
    /// Component of the direction an integral runs over.
    Running(u8),
    /// The integral of a node over directions, by one of the graph's rules.
    Directions(u32, Node),
    /// A value between two limits: upper and the integrand there, lower and the integrand there.
    Between(Node, [Node; 4]),
}

/// Which directions an integral runs over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Domain {
    /// Degree the rule is exact for.
    pub(super) order: u16,
    /// `S` of `n · S n > above` and the bits of `above`; the whole sphere if none.
    pub(super) cone: Option<([Node; 6], u64)>,
}

/// How far below its kink a bracket still counts as taut: a fibre at rest, up to round-off.
///
/// Arguments of brackets are strain-like numbers; 1e-8 is far above round-off at rest and far
/// below any strain that matters.
pub(super) const TAUT_FROM: f64 = -1e-8;

impl Unary {
    /// The operation on a number; the definition every faster route is held to.
    pub(super) fn of(self, x: f64) -> f64 {
        match self {
            Self::Negate => -x,
            Self::Reciprocal => x.reciprocal(),
            Self::Sqrt => x.sqrt(),
            Self::Cbrt => Scalar::cbrt(&x),
            Self::ReciprocalCbrt => x.reciprocal_cbrt(),
            Self::Exp => Scalar::exp(&x),
            Self::ExpM1 => x.exp_m1_here(),
            Self::Ln => Scalar::ln(&x),
            Self::Sin => Scalar::sin(&x),
            Self::Cos => Scalar::cos(&x),
            Self::Tan => Scalar::tan(&x),
            Self::Tanh => Scalar::tanh(&x),
            Self::Cosh => Scalar::cosh(&x),
            Self::Sinh => Scalar::sinh(&x),
            Self::Erf => Scalar::erf(&x),
            Self::Pos => x.pos(),
            Self::Step => x.step(),
            Self::Same => x,
            Self::StepTaut => f64::from(u8::from(x >= TAUT_FROM)),
        }
    }
}

/// `f64` has an `exp_m1` of its own, the platform's; this names ours.
trait Here {
    fn exp_m1_here(&self) -> f64;
}

impl Here for f64 {
    fn exp_m1_here(&self) -> f64 {
        Scalar::exp_m1(self)
    }
}

impl Binary {
    /// The operation on two numbers.
    pub(super) fn of(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Add => x + y,
            Self::Subtract => x - y,
            Self::Multiply => x * y,
            Self::Divide => x / y,
            Self::Power => x.real_power(y),
        }
    }
}

/// The graph: nodes in order, children before parents, no two equal.
#[derive(Debug, Default)]
pub(super) struct Graph {
    nodes: Vec<Operation>,
    index: HashMap<Operation, Node, BuildHasherDefault<Mixture>>,
    domains: Vec<Domain>,
}

impl Graph {
    pub(super) fn nodes(&self) -> &[Operation] {
        &self.nodes
    }

    /// The node of an operation, new or known.
    pub(super) fn insert(&mut self, operation: Operation) -> Node {
        if let Some(&node) = self.index.get(&operation) {
            return node;
        }
        let node = self.nodes.len() as Node;
        self.nodes.push(operation);
        self.index.insert(operation, node);
        node
    }

    pub(super) fn constant(&mut self, value: f64) -> Node {
        self.insert(Operation::Constant(value.to_bits()))
    }

    /// The number a node is, if it is one.
    pub(super) fn value(&self, node: Node) -> Option<f64> {
        match self.nodes[node as usize] {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn negated(&self, node: Node) -> Option<Node> {
        match self.nodes[node as usize] {
            Operation::Unary(Unary::Negate, inner) => Some(inner),
            _ => None,
        }
    }

    /// Whether `step` is the slope of the bracket `pos`: their product is the bracket itself.
    fn is_step_of_bracket(&self, step: Node, pos: Node) -> bool {
        match (self.nodes[step as usize], self.nodes[pos as usize]) {
            (Operation::Unary(Unary::Step, x), Operation::Unary(Unary::Pos, y)) => x == y,
            _ => false,
        }
    }

    fn negate(&mut self, node: Node) -> Node {
        self.unary(Unary::Negate, node)
    }

    pub(super) fn unary(&mut self, function: Unary, x: Node) -> Node {
        if let Some(value) = self.value(x) {
            return self.constant(function.of(value));
        }
        match (function, self.negated(x)) {
            (Unary::Negate, Some(inner)) => inner,
            _ => self.insert(Operation::Unary(function, x)),
        }
    }

    pub(super) fn binary(&mut self, function: Binary, x: Node, y: Node) -> Node {
        if let (Some(a), Some(b)) = (self.value(x), self.value(y)) {
            return self.constant(function.of(a, b));
        }
        match function {
            Binary::Add => self.add(x, y),
            Binary::Subtract => self.subtract(x, y),
            Binary::Multiply => self.multiply(x, y),
            Binary::Divide if self.value(y) == Some(1.0) => x,
            Binary::Divide | Binary::Power => self.insert(Operation::Binary(function, x, y)),
        }
    }

    fn add(&mut self, x: Node, y: Node) -> Node {
        if self.value(x) == Some(0.0) {
            return y;
        }
        if self.value(y) == Some(0.0) {
            return x;
        }
        match (self.negated(x), self.negated(y)) {
            (_, Some(b)) => self.subtract(x, b),
            (Some(a), None) => self.subtract(y, a),
            (None, None) => self.insert(Operation::Binary(Binary::Add, x.min(y), x.max(y))),
        }
    }

    fn subtract(&mut self, x: Node, y: Node) -> Node {
        if self.value(y) == Some(0.0) {
            return x;
        }
        if self.value(x) == Some(0.0) {
            return self.negate(y);
        }
        match self.negated(y) {
            Some(b) => self.add(x, b),
            None => self.insert(Operation::Binary(Binary::Subtract, x, y)),
        }
    }

    fn multiply(&mut self, x: Node, y: Node) -> Node {
        if self.is_step_of_bracket(x, y) {
            return y;
        }
        if self.is_step_of_bracket(y, x) {
            return x;
        }
        for (constant, other) in [(x, y), (y, x)] {
            match self.value(constant) {
                // a derivative that is identically zero
                Some(0.0) => return self.constant(0.0),
                Some(1.0) => return other,
                Some(-1.0) => return self.negate(other),
                _ => {}
            }
        }
        match (self.negated(x), self.negated(y)) {
            (Some(a), Some(b)) => self.multiply(a, b),
            (Some(a), None) => {
                let product = self.multiply(a, y);
                self.negate(product)
            }
            (None, Some(b)) => {
                let product = self.multiply(x, b);
                self.negate(product)
            }
            (None, None) => self.insert(Operation::Binary(Binary::Multiply, x.min(y), x.max(y))),
        }
    }

    /// The domains integrals run over, in the order of their rules.
    pub(super) fn domains(&self) -> &[Domain] {
        &self.domains
    }

    /// `∫ body dS`; zero of zero, so that what does not depend on the seed costs nothing.
    pub(super) fn over_directions(&mut self, domain: Domain, body: Node) -> Node {
        if self.value(body) == Some(0.0) {
            return body;
        }
        let rule = self.domains.iter().position(|known| *known == domain).unwrap_or_else(|| {
            self.domains.push(domain);
            self.domains.len() - 1
        });
        self.insert(Operation::Directions(rule as u32, body))
    }

    pub(super) fn between(&mut self, value: Node, limits: [Node; 4]) -> Node {
        match [limits[0], limits[2]].map(|limit| self.value(limit)) {
            [Some(_), Some(_)] => value,
            _ => self.insert(Operation::Between(value, limits)),
        }
    }

    pub(super) fn select(&mut self, comparison: Comparison, nodes: [Node; 4]) -> Node {
        let [left, right, then, otherwise] = nodes;
        if then == otherwise {
            return then;
        }
        match (self.value(left), self.value(right)) {
            (Some(a), Some(b)) if comparison.holds(a, b) => then,
            (Some(_), Some(_)) => otherwise,
            _ => self.insert(Operation::Select(comparison, nodes)),
        }
    }
}
