//! The tape: nodes in order, children before parents, the last node the result.

/// Index of a node on its tape.
pub type NodeId = u32;

/// Functions of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Square root.
    Sqrt,
    /// Cube root.
    Cbrt,
    /// Absolute value.
    Abs,
    /// Macaulay bracket `max(x, 0)`: value 0 and derivative 0 at 0.
    Pos,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Hyperbolic tangent.
    Tanh,
    /// Hyperbolic cosine.
    Cosh,
    /// Error function.
    Erf,
}

/// Relations a `Select` can test.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// One operation of a tape over leaves of type `L`.
#[derive(Debug, Clone, PartialEq)]
pub enum Node<L> {
    /// A number, SI.
    Constant(f64),
    /// A named quantity the caller supplies, SI.
    Leaf(L),
    /// `-a`
    Negate(NodeId),
    /// `a + b`
    Add(NodeId, NodeId),
    /// `a - b`
    Subtract(NodeId, NodeId),
    /// `a * b`
    Multiply(NodeId, NodeId),
    /// `a / b`
    Divide(NodeId, NodeId),
    /// `a ^ b`
    Power(NodeId, NodeId),
    /// `f(a)`
    Call(Function, NodeId),
    /// `min(a, b)`
    Min(NodeId, NodeId),
    /// `max(a, b)`
    Max(NodeId, NodeId),
    /// `if(left <comparison> right, then, otherwise)`
    Select {
        /// Left side of the condition.
        left: NodeId,
        /// Relation of the condition.
        comparison: Comparison,
        /// Right side of the condition.
        right: NodeId,
        /// Value where the condition holds.
        then: NodeId,
        /// Value where it does not.
        otherwise: NodeId,
    },
    /// `∫ f(n) dS` over directions `n` of the unit sphere.
    Directions {
        /// Which directions.
        sphere: Sphere,
        /// `f`, over leaves that stand for the components of `n`.
        body: NodeId,
    },
    /// `∫ f(s) ds` between two limits; its derivatives are those of the limits, exactly.
    Between {
        /// The integral, by a rule of quadrature.
        value: NodeId,
        /// Upper limit.
        upper: NodeId,
        /// `f(upper)`
        at_upper: NodeId,
        /// Lower limit.
        lower: NodeId,
        /// `f(lower)`
        at_lower: NodeId,
    },
}

/// Directions of the unit sphere an integral runs over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Degree of the polynomials in the components of `n` the rule is exact for.
    pub order: u16,
    /// The part of the sphere where it is not the whole.
    pub part: Option<Cone>,
}

/// Directions with `n · S n > above`, `S` symmetric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Components of `S`: 11, 22, 33, 12, 13, 23.
    pub shape: [NodeId; 6],
    /// The bound, a number that does not depend on the leaves.
    pub above: NodeId,
}

/// A formula: nodes in evaluation order, the last one its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Tape<L> {
    nodes: Vec<Node<L>>,
}

impl<L> Default for Tape<L> {
    fn default() -> Self {
        Self { nodes: Vec::new() }
    }
}

impl<L> Tape<L> {
    /// An empty tape, to be filled by [`Tape::push`].
    pub fn new() -> Self {
        Self::default()
    }

    /// The tape of a single number.
    pub fn constant(value: f64) -> Self {
        Self { nodes: vec![Node::Constant(value)] }
    }

    /// The tape of a single leaf.
    pub fn leaf(leaf: L) -> Self {
        Self { nodes: vec![Node::Leaf(leaf)] }
    }

    /// Appends a node and returns its index; its children must already be on the tape.
    pub fn push(&mut self, node: Node<L>) -> NodeId {
        self.nodes.push(node);
        (self.nodes.len() - 1) as NodeId
    }

    /// The nodes, children before parents.
    pub fn nodes(&self) -> &[Node<L>] {
        &self.nodes
    }

    /// The same formula with the orders of its integrals over directions changed.
    #[must_use]
    pub fn with_orders(mut self, order: impl Fn(u16) -> u16) -> Self {
        for node in &mut self.nodes {
            if let Node::Directions { sphere, .. } = node {
                sphere.order = order(sphere.order);
            }
        }
        self
    }

    /// Orders of the integrals over directions.
    pub fn orders(&self) -> impl Iterator<Item = u16> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Directions { sphere, .. } => Some(sphere.order),
            _ => None,
        })
    }

    /// Places of the formula's `if`s.
    pub fn choices(&self) -> impl Iterator<Item = NodeId> {
        let is_choice = |(_, node): &(usize, &Node<L>)| matches!(node, Node::Select { .. });
        self.nodes.iter().enumerate().filter(is_choice).map(|(place, _)| place as NodeId)
    }

    /// The same formula with one of its `if`s decided, whatever its condition.
    #[must_use]
    pub fn decided(mut self, choice: NodeId, holds: bool) -> Self {
        if let Some(Node::Select { left, comparison, right, .. }) = self.nodes.get_mut(choice as usize) {
            // a number compared with itself
            *right = *left;
            *comparison = if holds { Comparison::LessEqual } else { Comparison::Less };
        }
        self
    }

    /// `left − right` of the condition of one of the `if`s.
    #[must_use]
    pub fn margin(mut self, choice: NodeId) -> Self {
        if let Some(Node::Select { left, right, .. }) = self.nodes.get(choice as usize) {
            let margin = Node::Subtract(*left, *right);
            self.nodes.truncate(choice as usize);
            self.nodes.push(margin);
        }
        self
    }

    /// The leaves in order of first appearance on the tape, repetitions included.
    pub fn leaves(&self) -> impl Iterator<Item = &L> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Leaf(leaf) => Some(leaf),
            _ => None,
        })
    }
}
