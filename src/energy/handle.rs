//! A number that is not known yet: a handle into a graph, as a part of num-dual's duals.

use super::graph::{Binary, Domain, Graph, Node, Operation, Unary};
use crate::expression::dual_parts::implement_dual_num;
use crate::expression::{Comparison, Part, Scalar};
use std::cell::{Ref, RefCell};
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
    /// The handle of a quantity supplied from outside.
    pub(super) fn input(&self, place: usize) -> Handle {
        let node = self.graph.borrow_mut().insert(Operation::Input(place as u32));
        Handle::Node(Rc::clone(&self.graph), node)
    }

    /// The handle of a component of the direction an integral runs over.
    pub(super) fn running(&self, axis: u8) -> Handle {
        let node = self.graph.borrow_mut().insert(Operation::Running(axis));
        Handle::Node(Rc::clone(&self.graph), node)
    }

    /// The integral of a handle over directions, by a rule of the graph.
    pub(super) fn over_directions(&self, rule: u32, body: &Handle) -> Handle {
        let domain = self.graph.borrow().domains()[rule as usize];
        let body = body.node_in(&self.graph);
        let node = self.graph.borrow_mut().over_directions(domain, body);
        Handle::of(&self.graph, node)
    }

    /// The handle of a node of the graph.
    pub(super) fn handle(&self, node: Node) -> Handle {
        Handle::of(&self.graph, node)
    }

    /// The nodes written so far.
    pub(super) fn operations(&self) -> Vec<Operation> {
        self.graph.borrow().nodes().to_vec()
    }

    /// The nodes of handles.
    pub(super) fn nodes(&self, handles: &[Handle]) -> Vec<Node> {
        handles.iter().map(|handle| handle.node_in(&self.graph)).collect()
    }

    /// The graph written so far.
    pub(super) fn graph(&self) -> Ref<'_, Graph> {
        self.graph.borrow()
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
    fn over_directions(&self, order: u16, part: Option<([Self; 6], Self)>) -> Self {
        let everything = part.iter().flat_map(|(shape, above)| shape.iter().chain([above]));
        let graph = everything.chain([self]).find_map(|handle| match handle {
            Self::Node(graph, _) => Some(graph),
            Self::Constant(_) => None,
        });
        let Some(graph) = graph else {
            // a constant over the whole sphere: its area
            return self.clone() * Self::Constant(4.0 * std::f64::consts::PI);
        };
        let cone = part.as_ref().map(|(shape, above)| {
            let bound = above.fixed().unwrap_or(f64::NAN);
            (shape.each_ref().map(|handle| handle.node_in(graph)), bound.to_bits())
        });
        let body = self.node_in(graph);
        let result = graph.borrow_mut().over_directions(Domain { order, cone }, body);
        Self::of(graph, result)
    }
    fn between(&self, upper: (&Self, &Self), lower: (&Self, &Self)) -> Self {
        let Self::Node(graph, value) = self else { return self.clone() };
        let limits = [upper.0, upper.1, lower.0, lower.1].map(|handle| handle.node_in(graph));
        let result = graph.borrow_mut().between(*value, limits);
        Self::of(graph, result)
    }
    functions!(reciprocal Reciprocal, sqrt Sqrt, cbrt Cbrt, reciprocal_cbrt ReciprocalCbrt, exp Exp, exp_m1 ExpM1,
        ln Ln, sin Sin, cos Cos, tan Tan, tanh Tanh, cosh Cosh, sinh Sinh, erf Erf, pos Pos, step Step);
}

implement_dual_num!(Handle);
