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

    /// The leaves in order of first appearance on the tape, repetitions included.
    pub fn leaves(&self) -> impl Iterator<Item = &L> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Leaf(leaf) => Some(leaf),
            _ => None,
        })
    }
}
