//! Derivatives of a graph, written into it by num-dual.
//!
//! Owns the walk: each node that depends on the seed is run once in duals of handles, the rest is
//! left alone, so that a sum over a hundred directions costs what its terms cost. Knows no rule of
//! differentiation; those are num-dual's.

use super::graph::{Binary, Node, Operation, Unary};
use super::handle::{Handle, Trace};
use crate::expression::Scalar;
use num_dual::Dual;

/// Nodes that are not looked into: what is differentiated by.
pub(super) struct Leaves {
    is_leaf: Vec<bool>,
}

impl Leaves {
    /// The leaves of a graph with so many nodes.
    pub(super) fn new(nodes: impl IntoIterator<Item = Node>, count: usize) -> Self {
        let mut is_leaf = vec![false; count];
        for node in nodes {
            is_leaf[node as usize] = true;
        }
        Self { is_leaf }
    }
}

/// Slopes of the outputs by one leaf, the other leaves held.
///
/// `operations` are the nodes as they were when the leaves were marked; the slopes are new ones.
pub(super) fn slopes(
    trace: &Trace,
    operations: &[Operation],
    outputs: &[Handle],
    leaves: &Leaves,
    seed: Node,
) -> Vec<Handle> {
    let mut slope: Vec<Option<Handle>> = vec![None; operations.len()];
    for (node, operation) in operations.iter().enumerate() {
        if node == seed as usize {
            slope[node] = Some(Handle::constant(1.0));
        } else if !leaves.is_leaf[node] {
            let dual = |child: Node| {
                let slope = slope[child as usize].clone();
                Dual::new(trace.handle(child), slope.unwrap_or_else(|| Handle::constant(0.0)))
            };
            let depends = |child: Node| slope[child as usize].is_some();
            let result = match *operation {
                // linear in the integrand, which vanishes where a part of the sphere ends
                Operation::Directions(rule, body) => {
                    depends(body).then(|| trace.over_directions(rule, &dual(body).eps))
                }
                _ => step(operation, depends, dual),
            };
            slope[node] = result.filter(|slope| slope.fixed() != Some(0.0));
        }
    }
    let of = |output: &Handle| output.node().and_then(|node| slope[node as usize].clone());
    outputs.iter().map(|output| of(output).unwrap_or_else(|| Handle::constant(0.0))).collect()
}

/// Slope of one node, if it can have one.
fn step(
    operation: &Operation,
    depends: impl Fn(Node) -> bool,
    dual: impl Fn(Node) -> Dual<Handle>,
) -> Option<Handle> {
    match *operation {
        Operation::Input(_) | Operation::Constant(_) | Operation::Running(_) | Operation::Directions(..) => {
            None
        }
        Operation::Between(value, limits) => {
            let [upper, at_upper, lower, at_lower] = limits;
            (depends(upper) || depends(lower)).then(|| {
                let [upper, at_upper, lower, at_lower] = [upper, at_upper, lower, at_lower].map(&dual);
                dual(value).between((&upper, &at_upper), (&lower, &at_lower)).eps
            })
        }
        Operation::Unary(function, x) => depends(x).then(|| unary(function, &dual(x)).eps),
        Operation::Binary(function, x, y) => (depends(x) || depends(y)).then(|| match function {
            Binary::Add => (dual(x) + dual(y)).eps,
            Binary::Subtract => (dual(x) - dual(y)).eps,
            Binary::Multiply => (dual(x) * dual(y)).eps,
            Binary::Divide => (dual(x) / dual(y)).eps,
            Binary::Power => dual(x).power(&dual(y)).eps,
        }),
        Operation::Select(comparison, nodes) => {
            let [left, right, then, otherwise] = nodes;
            (depends(then) || depends(otherwise)).then(|| {
                Dual::select(&dual(left), comparison, &dual(right), &dual(then), &dual(otherwise)).eps
            })
        }
    }
}

fn unary(function: Unary, x: &Dual<Handle>) -> Dual<Handle> {
    match function {
        Unary::Same => x.clone(),
        Unary::Negate => -x.clone(),
        Unary::Reciprocal => x.reciprocal(),
        Unary::Sqrt => Scalar::sqrt(x),
        Unary::Cbrt => Scalar::cbrt(x),
        Unary::ReciprocalCbrt => x.reciprocal_cbrt(),
        Unary::Exp => Scalar::exp(x),
        Unary::ExpM1 => Scalar::exp_m1(x),
        Unary::Ln => Scalar::ln(x),
        Unary::Sin => Scalar::sin(x),
        Unary::Cos => Scalar::cos(x),
        Unary::Tan => Scalar::tan(x),
        Unary::Tanh => Scalar::tanh(x),
        Unary::Cosh => Scalar::cosh(x),
        Unary::Sinh => Scalar::sinh(x),
        Unary::Erf => x.erf(),
        Unary::Pos => x.pos(),
        Unary::Step | Unary::StepTaut => x.step(),
    }
}
