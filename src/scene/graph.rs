//! A formula under construction: nodes shared, constants folded.
//!
//! Owns the step between an expression and its tape. Every node is stored once, so a `let` used ten
//! times is computed once. Knows neither text nor what a leaf means.

use crate::expression::{Comparison, Cone, Function, Node, NodeId, Scalar, Sphere, Tape};
use std::collections::HashMap;

/// Nodes over leaves of type `L`, children before parents.
#[derive(Debug, Clone)]
pub(super) struct Graph<L> {
    leaves: Vec<L>,
    nodes: Vec<Node<usize>>,
    index: HashMap<Key, NodeId>,
}

/// Identity of a node: its operation, its children, the bits of its constant.
type Key = (u8, u64, [NodeId; 8]);

impl<L: Clone + PartialEq> Graph<L> {
    pub(super) fn new() -> Self {
        Self { leaves: Vec::new(), nodes: Vec::new(), index: HashMap::new() }
    }

    pub(super) fn constant(&mut self, value: f64) -> NodeId {
        self.intern(Node::Constant(value))
    }

    pub(super) fn leaf(&mut self, leaf: L) -> NodeId {
        let index = self.leaves.iter().position(|known| *known == leaf).unwrap_or_else(|| {
            self.leaves.push(leaf);
            self.leaves.len() - 1
        });
        self.intern(Node::Leaf(index))
    }

    pub(super) fn number(&self, node: NodeId) -> Option<f64> {
        match self.nodes[node as usize] {
            Node::Constant(value) => Some(value),
            _ => None,
        }
    }

    pub(super) fn negate(&mut self, a: NodeId) -> NodeId {
        self.fold(Node::Negate(a))
    }

    pub(super) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Add(a, b))
    }

    pub(super) fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Subtract(a, b))
    }

    pub(super) fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Multiply(a, b))
    }

    pub(super) fn divide(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Divide(a, b))
    }

    pub(super) fn power(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Power(a, b))
    }

    pub(super) fn call(&mut self, function: Function, a: NodeId) -> NodeId {
        self.fold(Node::Call(function, a))
    }

    pub(super) fn min(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Min(a, b))
    }

    pub(super) fn max(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.fold(Node::Max(a, b))
    }

    pub(super) fn select(
        &mut self,
        (left, comparison, right): (NodeId, Comparison, NodeId),
        then: NodeId,
        otherwise: NodeId,
    ) -> NodeId {
        self.fold(Node::Select { left, comparison, right, then, otherwise })
    }

    /// `∫ body dS` over directions.
    pub(super) fn directions(&mut self, sphere: Sphere, body: NodeId) -> NodeId {
        self.intern(Node::Directions { sphere, body })
    }

    /// An integral of this value between an upper and a lower limit, each with the integrand there.
    pub(super) fn between(
        &mut self,
        value: NodeId,
        (upper, at_upper): (NodeId, NodeId),
        (lower, at_lower): (NodeId, NodeId),
    ) -> NodeId {
        self.fold(Node::Between { value, upper, at_upper, lower, at_lower })
    }

    /// Whether a leaf of this kind is needed for the value of a node.
    pub(super) fn reads(&self, root: NodeId, wanted: impl Fn(&L) -> bool) -> bool {
        self.needed(root).iter().enumerate().any(|(id, &needed)| {
            needed && matches!(self.nodes[id], Node::Leaf(leaf) if wanted(&self.leaves[leaf]))
        })
    }

    /// Which nodes the value of one needs, itself included.
    fn needed(&self, root: NodeId) -> Vec<bool> {
        let mut needed = vec![false; root as usize + 1];
        needed[root as usize] = true;
        for id in (0..=root as usize).rev() {
            if needed[id] {
                let (count, ids) = children(&self.nodes[id]);
                for &child in &ids[..count] {
                    needed[child as usize] = true;
                }
            }
        }
        needed
    }

    /// The formula of a node as a tape of exactly the nodes it needs.
    pub(super) fn tape(&self, root: NodeId) -> Tape<L> {
        let needed = self.needed(root);
        let mut place = vec![0; root as usize + 1];
        let mut tape = Tape::new();
        for id in (0..=root as usize).filter(|&id| needed[id]) {
            let node = renumber(&self.nodes[id], &place, |leaf| self.leaves[*leaf].clone());
            place[id] = tape.push(node);
        }
        tape
    }

    /// The value of a node where every leaf has a value.
    pub(super) fn value(&self, root: NodeId, leaf: impl Fn(&L) -> Option<f64>) -> Option<f64> {
        let mut values: Vec<Option<f64>> = Vec::with_capacity(root as usize + 1);
        for node in &self.nodes[..=root as usize] {
            let value = match node {
                Node::Leaf(index) => leaf(&self.leaves[*index]),
                other => apply(other, |child| values[child as usize]),
            };
            values.push(value);
        }
        values[root as usize]
    }

    fn fold(&mut self, node: Node<usize>) -> NodeId {
        match apply(&node, |child| self.number(child)) {
            Some(value) => self.constant(value),
            None => self.intern(node),
        }
    }

    fn intern(&mut self, node: Node<usize>) -> NodeId {
        *self.index.entry(key(&node)).or_insert_with(|| {
            self.nodes.push(node);
            (self.nodes.len() - 1) as NodeId
        })
    }
}

fn key(node: &Node<usize>) -> Key {
    let (_, ids) = children(node);
    let (kind, word) = match *node {
        Node::Constant(value) => (0, value.to_bits()),
        Node::Leaf(leaf) => (1, leaf as u64),
        Node::Negate(_) => (2, 0),
        Node::Add(..) => (3, 0),
        Node::Subtract(..) => (4, 0),
        Node::Multiply(..) => (5, 0),
        Node::Divide(..) => (6, 0),
        Node::Power(..) => (7, 0),
        Node::Call(function, _) => (8, function as u64),
        Node::Min(..) => (9, 0),
        Node::Max(..) => (10, 0),
        Node::Select { comparison, .. } => (11, comparison as u64),
        Node::Directions { sphere, .. } if sphere.part.is_some() => (12, u64::from(sphere.order)),
        Node::Directions { sphere, .. } => (13, u64::from(sphere.order)),
        Node::Between { .. } => (14, 0),
    };
    (kind, word, ids)
}

/// The children of a node: so many of the list.
fn children<L>(node: &Node<L>) -> (usize, [NodeId; 8]) {
    let listed = |ids: &[NodeId]| {
        let mut all = [0; 8];
        all[..ids.len()].copy_from_slice(ids);
        (ids.len(), all)
    };
    match *node {
        Node::Constant(_) | Node::Leaf(_) => listed(&[]),
        Node::Negate(a) | Node::Call(_, a) => listed(&[a]),
        Node::Add(a, b)
        | Node::Subtract(a, b)
        | Node::Multiply(a, b)
        | Node::Divide(a, b)
        | Node::Power(a, b)
        | Node::Min(a, b)
        | Node::Max(a, b) => listed(&[a, b]),
        Node::Select { left, right, then, otherwise, .. } => listed(&[left, right, then, otherwise]),
        Node::Directions { sphere: Sphere { part: None, .. }, body } => listed(&[body]),
        Node::Directions {
            sphere: Sphere { part: Some(Cone { shape: [a, b, c, d, e, f], above }), .. },
            body,
        } => listed(&[body, above, a, b, c, d, e, f]),
        Node::Between { value, upper, at_upper, lower, at_lower } => {
            listed(&[value, upper, at_upper, lower, at_lower])
        }
    }
}

/// The same node with other indices and leaves.
pub(super) fn renumber<L, M>(node: &Node<L>, place: &[NodeId], leaf: impl Fn(&L) -> M) -> Node<M> {
    let at = |id: NodeId| place[id as usize];
    match *node {
        Node::Constant(value) => Node::Constant(value),
        Node::Leaf(ref old) => Node::Leaf(leaf(old)),
        Node::Negate(a) => Node::Negate(at(a)),
        Node::Add(a, b) => Node::Add(at(a), at(b)),
        Node::Subtract(a, b) => Node::Subtract(at(a), at(b)),
        Node::Multiply(a, b) => Node::Multiply(at(a), at(b)),
        Node::Divide(a, b) => Node::Divide(at(a), at(b)),
        Node::Power(a, b) => Node::Power(at(a), at(b)),
        Node::Call(function, a) => Node::Call(function, at(a)),
        Node::Min(a, b) => Node::Min(at(a), at(b)),
        Node::Max(a, b) => Node::Max(at(a), at(b)),
        Node::Select { left, comparison, right, then, otherwise } => Node::Select {
            left: at(left),
            comparison,
            right: at(right),
            then: at(then),
            otherwise: at(otherwise),
        },
        Node::Directions { sphere, body } => {
            let cone = |cone: Cone| Cone { shape: cone.shape.map(at), above: at(cone.above) };
            Node::Directions { sphere: Sphere { part: sphere.part.map(cone), ..sphere }, body: at(body) }
        }
        Node::Between { value, upper, at_upper, lower, at_lower } => Node::Between {
            value: at(value),
            upper: at(upper),
            at_upper: at(at_upper),
            lower: at(lower),
            at_lower: at(at_lower),
        },
    }
}

/// Value of an operation from the values of its children, as a tape evaluates it.
fn apply<L>(node: &Node<L>, value: impl Fn(NodeId) -> Option<f64>) -> Option<f64> {
    Some(match *node {
        Node::Constant(constant) => constant,
        Node::Leaf(_) | Node::Directions { .. } => return None,
        Node::Negate(a) => -value(a)?,
        Node::Add(a, b) => value(a)? + value(b)?,
        Node::Subtract(a, b) => value(a)? - value(b)?,
        Node::Multiply(a, b) => value(a)? * value(b)?,
        Node::Divide(a, b) => value(a)? / value(b)?,
        Node::Power(a, b) => libm::pow(value(a)?, value(b)?),
        Node::Call(function, a) => function.of(&value(a)?),
        Node::Min(a, b) => Scalar::min(&value(a)?, &value(b)?),
        Node::Max(a, b) => Scalar::max(&value(a)?, &value(b)?),
        Node::Select { left, comparison, right, then, otherwise } => {
            let holds = comparison.holds(value(left)?, value(right)?);
            if holds { value(then)? } else { value(otherwise)? }
        }
        Node::Between { value: integral, .. } => value(integral)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_written_twice_is_stored_once() {
        let mut graph = Graph::new();
        let x = graph.leaf('x');
        let y = graph.leaf('y');
        let first = graph.multiply(x, y);
        let again = graph.leaf('x');
        let second = graph.multiply(again, y);
        assert_eq!(first, second);
        let other = graph.multiply(y, x);
        assert_ne!(first, other);
    }

    #[test]
    fn a_tape_holds_only_the_nodes_its_result_needs() {
        let mut graph = Graph::new();
        let x = graph.leaf('x');
        let unused = graph.leaf('u');
        let _ = graph.add(unused, x);
        let two = graph.constant(2.0);
        let square = graph.power(x, two);
        let tape = graph.tape(square);
        assert_eq!(tape.nodes(), &[Node::Leaf('x'), Node::Constant(2.0), Node::Power(0, 1)]);
    }

    #[test]
    fn arithmetic_of_constants_is_done_at_once() {
        let mut graph = Graph::<char>::new();
        let one = graph.constant(1.0);
        let three = graph.constant(3.0);
        let third = graph.divide(one, three);
        assert_eq!(graph.number(third), Some(1.0 / 3.0));
    }
}
