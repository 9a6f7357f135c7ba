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

    /// Places where the formula is one of two pieces: `if`, `max`, `min`, `abs` and the Macaulay bracket.
    ///
    /// Those that depend on a leaf that `bound` names are left out: what an integral runs over.
    pub fn choices(&self, bound: impl Fn(&L) -> bool) -> Vec<NodeId> {
        let mut is_bound: Vec<bool> = Vec::with_capacity(self.nodes.len());
        let mut found = Vec::new();
        for (place, node) in self.nodes.iter().enumerate() {
            let of = |ids: &[NodeId]| ids.iter().any(|&id| is_bound[id as usize]);
            let inside = match node {
                Node::Constant(_) | Node::Directions { .. } => false,
                Node::Leaf(leaf) => bound(leaf),
                Node::Negate(a) | Node::Call(_, a) => of(&[*a]),
                Node::Add(a, b)
                | Node::Subtract(a, b)
                | Node::Multiply(a, b)
                | Node::Divide(a, b)
                | Node::Power(a, b)
                | Node::Max(a, b)
                | Node::Min(a, b) => of(&[*a, *b]),
                Node::Select { left, right, then, otherwise, .. } => of(&[*left, *right, *then, *otherwise]),
                Node::Between { value, upper, lower, .. } => of(&[*value, *upper, *lower]),
            };
            is_bound.push(inside);
            if !inside && self.choice(place as NodeId).is_some() {
                found.push(place as NodeId);
            }
        }
        found
    }

    /// The word of a choice, what is compared, and the pieces where its margin is positive and where it is not.
    fn choice(&self, place: NodeId) -> Option<(&'static str, Compared, [Piece; 2])> {
        Some(match *self.nodes.get(place as usize)? {
            Node::Select { left, comparison, right, then, otherwise } => {
                let above = matches!(comparison, Comparison::Greater | Comparison::GreaterEqual);
                let pieces = if above { [then, otherwise] } else { [otherwise, then] };
                ("if", (left, Some(right)), pieces.map(Piece::Same))
            }
            Node::Max(a, b) => ("max", (a, Some(b)), [Piece::Same(a), Piece::Same(b)]),
            Node::Min(a, b) => ("min", (a, Some(b)), [Piece::Same(b), Piece::Same(a)]),
            Node::Call(Function::Abs, a) => ("abs", (a, None), [Piece::Same(a), Piece::Negated(a)]),
            Node::Call(Function::Pos, a) => ("pos", (a, None), [Piece::Same(a), Piece::Zero]),
            _ => return None,
        })
    }

    /// The word a choice is written with.
    pub fn choice_word(&self, place: NodeId) -> &'static str {
        self.choice(place).map_or("", |(word, ..)| word)
    }

    /// The same formula with one of its choices decided: as where its margin is positive, or where it is not.
    #[must_use]
    pub fn decided(mut self, place: NodeId, above: bool) -> Self {
        if let Some((_, _, pieces)) = self.choice(place) {
            self.nodes[place as usize] = match pieces[usize::from(!above)] {
                // a number compared with itself
                Piece::Same(a) => Node::Select {
                    left: a,
                    comparison: Comparison::LessEqual,
                    right: a,
                    then: a,
                    otherwise: a,
                },
                Piece::Negated(a) => Node::Negate(a),
                Piece::Zero => Node::Constant(0.0),
            };
        }
        self
    }

    /// What is compared in one of the choices: left less right, or what is compared with zero.
    #[must_use]
    pub fn margin(mut self, place: NodeId) -> Self {
        if let Some((_, (left, right), _)) = self.choice(place) {
            match right {
                Some(right) => {
                    self.nodes.truncate(place as usize);
                    self.nodes.push(Node::Subtract(left, right));
                }
                None => self.nodes.truncate(left as usize + 1),
            }
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

/// What a choice compares: two numbers, or one with zero.
type Compared = (NodeId, Option<NodeId>);

/// What a choice gives on one side.
enum Piece {
    Same(NodeId),
    Negated(NodeId),
    Zero,
}
