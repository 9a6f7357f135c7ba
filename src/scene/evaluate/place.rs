//! Coordinates and time.

use super::{Evaluator, Leaves, Outcome, Value};
use crate::expression::Function;
use crate::unit::Dimension;

/// The value of `X`, `Y`, `Z`, `r` or `t`, as far as the formula may depend on place and time.
pub(in crate::scene) fn place_word<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    word: &str,
    place: bool,
    time: bool,
) -> Option<Outcome> {
    let axis = match word {
        "X" => 0,
        "Y" => 1,
        "Z" => 2,
        "r" if place => {
            let two = evaluator.graph.constant(2.0);
            let (x, y) = (evaluator.graph.leaf(L::coordinate(0)?), evaluator.graph.leaf(L::coordinate(1)?));
            let (xx, yy) = (evaluator.graph.power(x, two), evaluator.graph.power(y, two));
            let sum = evaluator.graph.add(xx, yy);
            return Some(Ok(Value::scalar(evaluator.graph.call(Function::Sqrt, sum), Dimension::LENGTH)));
        }
        "t" if time => return Some(Ok(Value::scalar(evaluator.graph.leaf(L::time()?), Dimension::TIME))),
        _ => return None,
    };
    place.then(|| Some(Ok(Value::scalar(evaluator.graph.leaf(L::coordinate(axis)?), Dimension::LENGTH))))?
}
