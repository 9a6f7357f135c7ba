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
            Node::Call(function, a) => call(*function, &values[*a as usize]),
            Node::Min(a, b) => values[*a as usize].min(&values[*b as usize]),
            Node::Max(a, b) => values[*a as usize].max(&values[*b as usize]),
            Node::Select { left, comparison, right, then, otherwise } => {
                let at = |id: &NodeId| &values[*id as usize];
                T::select(at(left), *comparison, at(right), at(then), at(otherwise))
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

fn call<T: Scalar>(function: Function, x: &T) -> T {
    match function {
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Sqrt => x.sqrt(),
        Function::Cbrt => x.cbrt(),
        Function::Abs => x.abs(),
        Function::Pos => x.pos(),
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Tanh => x.tanh(),
        Function::Cosh => x.cosh(),
        Function::Erf => x.erf(),
    }
}
