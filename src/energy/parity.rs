//! Which integrands are even in the direction they are integrated over.
//!
//! Owns the rules of parity; what it cannot prove it takes for neither even nor odd.

use super::graph::{Binary as B, Graph, Node, Operation, Unary};
use std::collections::HashMap;

/// How a value answers to the opposite direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parity {
    Even,
    Odd,
    Neither,
}

/// Whether integrals tell no direction from its opposite; `body` is what they are made of, in order.
pub(super) fn is_even(graph: &Graph, sums: &[Node], body: &[Node]) -> bool {
    let mut known = HashMap::new();
    let parity = |known: &HashMap<Node, Parity>, node: Node| {
        let running = matches!(graph.nodes()[node as usize], Operation::Running(_));
        if running { Parity::Odd } else { known.get(&node).copied().unwrap_or(Parity::Even) }
    };
    for &node in body {
        let of = |child| parity(&known, child);
        let found = match graph.nodes()[node as usize] {
            Operation::Unary(function, x) => match (of(x), function) {
                (Parity::Even, _) => Parity::Even,
                (Parity::Odd, Unary::Cos | Unary::Cosh) => Parity::Even,
                (Parity::Odd, Unary::Negate | Unary::Reciprocal | Unary::Cbrt | Unary::Sin | Unary::Tan) => {
                    Parity::Odd
                }
                (Parity::Odd, Unary::Tanh | Unary::Sinh | Unary::Erf) => Parity::Odd,
                _ => Parity::Neither,
            },
            Operation::Binary(function, x, y) => {
                match (function, of(x), of(y)) {
                    (B::Add | B::Subtract, x, y) if x == y => x,
                    (B::Multiply | B::Divide, x, y) if x != Parity::Neither && y != Parity::Neither => {
                        if x == y { Parity::Even } else { Parity::Odd }
                    }
                    (B::Power, Parity::Even, Parity::Even) => Parity::Even,
                    _ => Parity::Neither,
                }
            }
            Operation::Select(_, [left, right, then, otherwise]) => {
                let blind = of(left) == Parity::Even && of(right) == Parity::Even;
                if blind && of(then) == of(otherwise) { of(then) } else { Parity::Neither }
            }
            Operation::Between(value, _) => of(value),
            _ => Parity::Neither,
        };
        known.insert(node, found);
    }
    sums.iter().all(|&sum| match graph.nodes()[sum as usize] {
        Operation::Directions(_, body) => parity(&known, body) == Parity::Even,
        _ => false,
    })
}
