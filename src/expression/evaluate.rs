//! Running a tape in any scalar.

use super::scalar::Scalar;
use super::tape::{Function, Node, NodeId, Tape};

impl<L> Tape<L> {
    /// Value of the formula, with `leaf` supplying its leaves.
    ///
    /// `scratch` holds the nodes' values; its former contents are dropped and its allocation reused.
    /// `exp(x) - 1` is evaluated as `exp_m1(x)`, which keeps its digits near `x = 0`.
    ///
    /// # Panics
    /// If the tape is empty or a node names one that does not precede it.
    pub fn evaluate<T: Scalar>(&self, mut leaf: impl FnMut(&L) -> T, scratch: &mut Vec<T>) -> T {
        scratch.clear();
        for node in self.nodes() {
            let value = self.node_value(node, scratch, &mut leaf);
            scratch.push(value);
        }
        scratch.last().expect("a tape has at least one node").clone()
    }

    fn node_value<T: Scalar>(&self, node: &Node<L>, values: &[T], leaf: &mut impl FnMut(&L) -> T) -> T {
        let at = |id: NodeId| values[id as usize].clone();
        match node {
            Node::Constant(value) => T::constant(*value),
            Node::Leaf(name) => leaf(name),
            Node::Negate(a) => -at(*a),
            Node::Add(a, b) => match (self.exponential_of(*a), self.exponential_of(*b)) {
                (Some(x), _) if values[*b as usize].fixed() == Some(-1.0) => values[x as usize].exp_m1(),
                (_, Some(x)) if values[*a as usize].fixed() == Some(-1.0) => values[x as usize].exp_m1(),
                _ => at(*a) + at(*b),
            },
            Node::Subtract(a, b) => match self.exponential_of(*a) {
                Some(x) if values[*b as usize].fixed() == Some(1.0) => values[x as usize].exp_m1(),
                _ => at(*a) - at(*b),
            },
            Node::Multiply(a, b) => at(*a) * at(*b),
            Node::Divide(a, b) => at(*a) / at(*b),
            Node::Power(a, b) => values[*a as usize].power(&values[*b as usize]),
            Node::Call(function, a) => function.of(&values[*a as usize]),
            Node::Min(a, b) => values[*a as usize].min(&values[*b as usize]),
            Node::Max(a, b) => values[*a as usize].max(&values[*b as usize]),
            Node::Select { left, comparison, right, then, otherwise } => {
                let at = |id: &NodeId| &values[*id as usize];
                T::select(at(left), *comparison, at(right), at(then), at(otherwise))
            }
            Node::Directions { sphere, body } => {
                let part = sphere.part.map(|cone| (cone.shape.map(at), at(cone.above)));
                values[*body as usize].over_directions(sphere.order, part)
            }
            Node::Between { value, upper, at_upper, lower, at_lower } => {
                let at = |id: &NodeId| &values[*id as usize];
                at(value).between((at(upper), at(at_upper)), (at(lower), at(at_lower)))
            }
        }
    }

    /// The argument, if the node is an exponential.
    fn exponential_of(&self, node: NodeId) -> Option<NodeId> {
        match self.nodes()[node as usize] {
            Node::Call(Function::Exp, argument) => Some(argument),
            _ => None,
        }
    }
}

impl Function {
    /// The function of any scalar.
    pub fn of<T: Scalar>(self, x: &T) -> T {
        match self {
            Self::Exp => x.exp(),
            Self::Ln => x.ln(),
            Self::Sqrt => x.sqrt(),
            Self::Cbrt => x.cbrt(),
            Self::Abs => x.abs(),
            Self::Pos => x.pos(),
            Self::Sin => x.sin(),
            Self::Cos => x.cos(),
            Self::Tan => x.tan(),
            Self::Tanh => x.tanh(),
            Self::Cosh => x.cosh(),
            Self::Erf => x.erf(),
        }
    }
}
