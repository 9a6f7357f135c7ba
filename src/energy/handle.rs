//! A number that is not known yet: a handle into a graph, as a part of num-dual's duals.

use super::graph::{Binary, Graph, Node, Operation, Unary};
use crate::expression::dual_parts::implement_dual_num;
use crate::expression::{Comparison, Part, Scalar};
use std::cell::RefCell;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::rc::Rc;

/// A constant, or a node of a graph. Arithmetic on handles writes the graph.
///
/// All handles of one computation belong to one [`Trace`]; asking one for its value, or comparing
/// two, is a fault of this crate and panics.
#[derive(Clone)]
pub(super) enum Handle {
    Constant(f64),
    Node(Rc<RefCell<Graph>>, Node),
}

/// The graph being written.
#[derive(Default)]
pub(super) struct Trace {
    graph: Rc<RefCell<Graph>>,
}

impl Trace {
    /// A trace whose brackets count as loaded at their kink, if `taut`.
    pub(super) fn new(taut: bool) -> Self {
        let trace = Self::default();
        trace.graph.borrow_mut().taut = taut;
        trace
    }

    /// The handle of a quantity supplied from outside.
    pub(super) fn input(&self, place: usize) -> Handle {
        let node = self.graph.borrow_mut().insert(Operation::Input(place as u32));
        Handle::Node(Rc::clone(&self.graph), node)
    }

    /// The handle of a node of the graph.
    pub(super) fn handle(&self, node: Node) -> Handle {
        Handle::of(&self.graph, node)
    }

    /// The nodes written so far.
    pub(super) fn operations(&self) -> Vec<Operation> {
        self.graph.borrow().nodes().to_vec()
    }

    /// The graph, and the nodes of the given handles in it.
    pub(super) fn finish(self, outputs: Vec<Handle>) -> (Graph, Vec<Node>) {
        let nodes = outputs.into_iter().map(|output| output.node_in(&self.graph)).collect();
        (self.graph.take(), nodes)
    }
}

impl fmt::Debug for Handle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(value) => write!(f, "{value}"),
            Self::Node(_, node) => write!(f, "n{node}"),
        }
    }
}

impl PartialEq for Handle {
    fn eq(&self, other: &Self) -> bool {
        self.real() == other.real()
    }
}

impl Handle {
    fn real(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Node(..) => panic!("the value of a traced number is not known: branch through select"),
        }
    }

    /// Its node, if it is no constant.
    pub(super) fn node(&self) -> Option<Node> {
        match self {
            Self::Constant(_) => None,
            Self::Node(_, node) => Some(*node),
        }
    }

    fn node_in(&self, graph: &Rc<RefCell<Graph>>) -> Node {
        match self {
            Self::Constant(value) => graph.borrow_mut().constant(*value),
            Self::Node(_, node) => *node,
        }
    }

    /// The handle of a node, constants by value.
    fn of(graph: &Rc<RefCell<Graph>>, node: Node) -> Self {
        let value = graph.borrow().value(node);
        value.map_or_else(|| Self::Node(Rc::clone(graph), node), Self::Constant)
    }

    fn unary(&self, function: Unary) -> Self {
        match self {
            Self::Constant(value) => Self::Constant(function.of(*value)),
            Self::Node(graph, node) => {
                let result = graph.borrow_mut().unary(function, *node);
                Self::of(graph, result)
            }
        }
    }

    fn binary(&self, function: Binary, other: &Self) -> Self {
        let graph = match (self, other) {
            (Self::Constant(x), Self::Constant(y)) => return Self::Constant(function.of(*x, *y)),
            (Self::Node(graph, _), _) | (_, Self::Node(graph, _)) => graph,
        };
        let (x, y) = (self.node_in(graph), other.node_in(graph));
        let result = graph.borrow_mut().binary(function, x, y);
        Self::of(graph, result)
    }
}

impl Neg for Handle {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Unary::Negate)
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident $operation:ident),*) => {$(
        impl $trait for Handle {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                self.binary(Binary::$operation, &other)
            }
        }
    )*};
}
operators!(Add add Add, Sub sub Subtract, Mul mul Multiply, Div div Divide);

macro_rules! functions {
    ($($function:ident $operation:ident),*) => {
        $(fn $function(&self) -> Self { self.unary(Unary::$operation) })*
    };
}

impl Part for Handle {}

impl Scalar for Handle {
    fn constant(value: f64) -> Self {
        Self::Constant(value)
    }
    fn fixed(&self) -> Option<f64> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Node(..) => None,
        }
    }
    fn real_power(&self, exponent: f64) -> Self {
        self.binary(Binary::Power, &Self::Constant(exponent))
    }
    fn select(left: &Self, comparison: Comparison, right: &Self, then: &Self, otherwise: &Self) -> Self {
        let all = [left, right, then, otherwise];
        let graph = all.iter().find_map(|handle| match handle {
            Self::Node(graph, _) => Some(graph),
            Self::Constant(_) => None,
        });
        let Some(graph) = graph else {
            return if comparison.holds(left.real(), right.real()) {
                then.clone()
            } else {
                otherwise.clone()
            };
        };
        let nodes = all.map(|handle| handle.node_in(graph));
        let result = graph.borrow_mut().select(comparison, nodes);
        Self::of(graph, result)
    }
    functions!(reciprocal Reciprocal, sqrt Sqrt, cbrt Cbrt, reciprocal_cbrt ReciprocalCbrt, exp Exp, exp_m1 ExpM1,
        ln Ln, sin Sin, cos Cos, tan Tan, tanh Tanh, cosh Cosh, sinh Sinh, erf Erf, pos Pos, step Step);
}

implement_dual_num!(Handle);
