//! Invariants of directions and integrals: over directions, and between two limits.
//!
//! Owns what `I4(n)` is where `n` runs over the sphere, and which directions and points an integral is
//! made of. How the sums over directions are run is the energy layer's.

use super::super::evaluate::{Evaluator, Local, Outcome, Scalar, Scope, Value};
use super::super::file::Reported;
use crate::energy::{Invariant, LARGEST_ORDER, Leaf};
use crate::expression::{Cone, NodeId, Sphere, gauss_legendre};
use crate::syntax::{Argument, BinaryOperator, ExprId, ExprKind, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// Index that stands for the direction an integral runs over; a material has fewer.
const RUNNING: u8 = u8::MAX;

/// Points of an integral between two limits: exact for polynomials of degree 63.
const POINTS: usize = 32;

const INTEGRATE: &str = "the first argument of `integrate` binds a name: `n in sphere(24)` or `s in 1 .. l`";

/// The value of a function of directions, or of an integral; `None` if the function is neither.
pub(super) fn call(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    function: &Name,
    arguments: &[Argument],
) -> Option<Outcome> {
    let node = match function.text.as_str() {
        "I4" | "I5" | "I4bar" | "I5bar" => directions::<1>(evaluator, outer, function, arguments)
            .map(|[a]| of_one(evaluator, &function.text, a)),
        "I8" | "E" | "dot" => directions::<2>(evaluator, outer, function, arguments)
            .map(|[a, b]| of_two(evaluator, &function.text, a, b)),
        "integrate" => return Some(integrate(evaluator, outer, function, arguments)),
        _ => return None,
    };
    Some(node.map(|node| Value::scalar(node, Dimension::NUMBER)))
}

fn directions<const N: usize>(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    function: &Name,
    arguments: &[Argument],
) -> Result<[u8; N], Reported> {
    if arguments.len() != N {
        return Err(evaluator.wrong_count(outer, function, N, arguments.len()));
    }
    let mut directions = [0; N];
    for (direction, argument) in directions.iter_mut().zip(arguments) {
        match evaluator.evaluate(outer, argument.value)? {
            Value::Direction(index) => *direction = index,
            other => {
                let file = Rc::clone(outer.file());
                let required = format!("`{}` takes a direction", function.text);
                let span = file.span(argument.value);
                return Err(evaluator.wrong_form(&file, &span, &other.describe(), &required));
            }
        }
    }
    Ok(directions)
}

fn leaf(evaluator: &mut Evaluator<Leaf>, invariant: Invariant) -> NodeId {
    evaluator.graph.leaf(Leaf::Invariant(invariant))
}

fn of_one(evaluator: &mut Evaluator<Leaf>, function: &str, a: u8) -> NodeId {
    let is_bar = function.ends_with("bar");
    if a == RUNNING {
        return match function {
            "I4" | "I4bar" => product(evaluator, is_bar, a, a),
            _ => {
                let image = image(evaluator, is_bar, a);
                sum_of_products(evaluator, image, image)
            }
        };
    }
    let invariant = match function {
        "I4" => Invariant::I4(a),
        "I5" => Invariant::I5(a),
        "I4bar" => Invariant::I4Bar(a),
        _ => Invariant::I5Bar(a),
    };
    leaf(evaluator, invariant)
}

/// All three are symmetric in their directions.
fn of_two(evaluator: &mut Evaluator<Leaf>, function: &str, a: u8, b: u8) -> NodeId {
    let is_running = a == RUNNING || b == RUNNING;
    let cosine = |evaluator: &mut Evaluator<Leaf>| {
        let (a, b) = (components(evaluator, a), components(evaluator, b));
        sum_of_products(evaluator, a, b)
    };
    match function {
        "dot" => cosine(evaluator),
        "I8" if is_running => product(evaluator, false, a, b),
        "I8" => leaf(evaluator, Invariant::I8(a.min(b), a.max(b))),
        _ if is_running => {
            let (stretched, at_rest) = (product(evaluator, false, a, b), cosine(evaluator));
            let change = evaluator.graph.subtract(stretched, at_rest);
            let half = evaluator.graph.constant(0.5);
            evaluator.graph.multiply(half, change)
        }
        _ => leaf(evaluator, Invariant::Green(a.min(b), a.max(b))),
    }
}

/// Components of a direction in the common axes.
fn components(evaluator: &mut Evaluator<Leaf>, a: u8) -> [NodeId; 3] {
    [0, 1, 2].map(|axis| match a {
        RUNNING => evaluator.graph.leaf(Leaf::Running(axis)),
        _ => leaf(evaluator, Invariant::Component(a, axis)),
    })
}

fn sum_of_products(evaluator: &mut Evaluator<Leaf>, a: [NodeId; 3], b: [NodeId; 3]) -> NodeId {
    let [x, y, z] = [0, 1, 2].map(|i| evaluator.graph.multiply(a[i], b[i]));
    let sum = evaluator.graph.add(x, y);
    evaluator.graph.add(sum, z)
}

fn metric(is_bar: bool) -> fn(u8, u8) -> Invariant {
    if is_bar { Invariant::RightCauchyGreenBar } else { Invariant::RightCauchyGreen }
}

/// `C a`, or its isochoric part.
fn image(evaluator: &mut Evaluator<Leaf>, is_bar: bool, a: u8) -> [NodeId; 3] {
    let components = components(evaluator, a);
    [0, 1, 2].map(|i| {
        let row = [0, 1, 2].map(|j| leaf(evaluator, metric(is_bar)(i.min(j), i.max(j))));
        sum_of_products(evaluator, row, components)
    })
}

/// `a · C b`, or its isochoric part.
fn product(evaluator: &mut Evaluator<Leaf>, is_bar: bool, a: u8, b: u8) -> NodeId {
    let (image, components) = (image(evaluator, is_bar, b), components(evaluator, a));
    sum_of_products(evaluator, image, components)
}

fn integrate(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    function: &Name,
    arguments: &[Argument],
) -> Outcome {
    let file = Rc::clone(outer.file());
    let &[binder, body] = arguments.iter().map(|argument| argument.value).collect::<Vec<_>>().as_slice()
    else {
        return Err(evaluator.wrong_count(outer, function, 2, arguments.len()));
    };
    let ExprKind::Binder { name, over } = &file.tree.expr(binder).kind else {
        return Err(evaluator.wrong_form(&file, &file.span(binder), "this", INTEGRATE));
    };
    if evaluator.integrating {
        let required = "name the inner integral by a `let` and use it here";
        return Err(evaluator.wrong_form(&file, &function.span, "an integral within an integral", required));
    }
    let domain = &file.tree.expr(*over).kind;
    evaluator.integrating = true;
    let outcome = match domain {
        ExprKind::Call { function, arguments } if function.text == "sphere" => {
            over_sphere(evaluator, outer, name, function, arguments, body)
        }
        ExprKind::Binary { operator: BinaryOperator::Range, left, right, .. } => {
            between(evaluator, outer, name, (*left, *right), body)
        }
        _ => Err(evaluator.wrong_form(
            &file,
            &file.span(*over),
            "this",
            "an integral runs over `sphere(24)` or between two limits `1 .. l`",
        )),
    };
    evaluator.integrating = false;
    outcome
}

fn over_sphere(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    name: &Name,
    sphere: &Name,
    arguments: &[Argument],
    body: ExprId,
) -> Outcome {
    let file = Rc::clone(outer.file());
    let Some(first) = arguments.first().filter(|_| arguments.len() <= 2) else {
        let required = "`sphere(24)` or `sphere(24, I4bar(n) > 1)` is required";
        return Err(evaluator.wrong_form(&file, &sphere.span, "this", required));
    };
    let order = evaluator.scalar(outer, first.value)?;
    let number = evaluator.graph.number(order.node).filter(|_| order.dimension.is_number());
    let is_order = |number: &f64| number.fract() == 0.0 && (1.0..=f64::from(LARGEST_ORDER)).contains(number);
    let Some(order) = number.filter(is_order) else {
        let found = number.map_or("this order".into(), |number| format!("the order {number}"));
        let required = format!("the degree of the rule is a whole number from 1 to {LARGEST_ORDER}");
        return Err(evaluator.wrong_form(&file, &file.span(first.value), &found, &required));
    };
    let part = match arguments.get(1) {
        Some(condition) => Some(cone(evaluator, outer, name, condition.value)?),
        None => None,
    };
    let local = Local { outer, name: &name.text, value: Value::Direction(RUNNING) };
    let integrand = evaluator.scalar(&local, body)?;
    let sphere = Sphere { order: order as u16, part };
    let node = evaluator.graph.directions(sphere, integrand.node);
    Ok(Value::scalar(node, integrand.dimension))
}

/// `I4bar(n) > 1`: the directions that are longer than a bound.
fn cone(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    name: &Name,
    condition: ExprId,
) -> Result<Cone, Reported> {
    let file = Rc::clone(outer.file());
    let word = match &file.tree.expr(condition).kind {
        ExprKind::Binary { operator: BinaryOperator::Greater, left, right, .. } => {
            stretch_of(&file.tree.expr(*left).kind, name, |id| &file.tree.expr(id).kind).zip(Some(*right))
        }
        _ => None,
    };
    let Some((is_bar, bound)) = word else {
        let required = format!("`I4bar({0}) > 1` or `I4({0}) > 1` is required", name.text);
        return Err(evaluator.wrong_form(&file, &file.span(condition), "this condition", &required));
    };
    let above = evaluator.scalar(outer, bound)?;
    let varies = |leaf: &Leaf| !matches!(leaf, Leaf::Parameter(_));
    if !above.dimension.is_number() || evaluator.graph.reads(above.node, varies) {
        let required = "a number that does not depend on the deformation is required";
        return Err(evaluator.wrong_form(&file, &file.span(bound), "this bound", required));
    }
    let shape = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    Ok(Cone { shape: shape.map(|(i, j)| leaf(evaluator, metric(is_bar)(i, j))), above: above.node })
}

/// Whether an expression is `I4bar(n)`, `false` for `I4(n)`.
fn stretch_of<'a>(kind: &ExprKind, name: &Name, kind_of: impl Fn(ExprId) -> &'a ExprKind) -> Option<bool> {
    let ExprKind::Call { function, arguments } = kind else { return None };
    let [argument] = arguments.as_slice() else { return None };
    let ExprKind::Name(of) = kind_of(argument.value) else { return None };
    match function.text.as_str() {
        "I4bar" if *of == name.text => Some(true),
        "I4" if *of == name.text => Some(false),
        _ => None,
    }
}

/// The integral by Gauss's rule, its derivatives by the limits those of the integrand there.
fn between(
    evaluator: &mut Evaluator<Leaf>,
    outer: &dyn Scope<Leaf>,
    name: &Name,
    (lower, upper): (ExprId, ExprId),
    body: ExprId,
) -> Outcome {
    let file = Rc::clone(outer.file());
    let (a, b) = (evaluator.scalar(outer, lower), evaluator.scalar(outer, upper));
    let (a, b) = (a?, b?);
    if a.dimension != b.dimension {
        let (found, required) = (b.dimension.describe(), a.dimension.describe());
        let required = format!("the lower limit is {required}");
        return Err(evaluator.wrong_form(&file, &file.span(upper), &found, &required));
    }
    let at = |evaluator: &mut Evaluator<Leaf>, node: NodeId| {
        let local = Local { outer, name: &name.text, value: Value::scalar(node, a.dimension) };
        evaluator.scalar(&local, body)
    };
    // any leaf that stands for nothing else: what is left beside it varies with the deformation
    let placeholder = evaluator.graph.leaf(Leaf::Running(RUNNING));
    let integrand = at(evaluator, placeholder)?;
    let varies = |leaf: &Leaf| matches!(leaf, Leaf::Invariant(_));
    if evaluator.graph.reads(integrand.node, varies) {
        let required = format!("it may depend on `{}` and on parameters only", name.text);
        return Err(evaluator.wrong_form(&file, &file.span(body), "this integrand", &required));
    }
    let (at_upper, at_lower) = (at(evaluator, b.node)?, at(evaluator, a.node)?);
    let length = evaluator.graph.subtract(b.node, a.node);
    let mut total: Option<NodeId> = None;
    for (x, weight) in gauss_legendre(POINTS) {
        let part = evaluator.graph.constant(x);
        let step = evaluator.graph.multiply(part, length);
        let point = evaluator.graph.add(a.node, step);
        let value: Scalar = at(evaluator, point)?;
        let weight = evaluator.graph.constant(weight);
        let term = evaluator.graph.multiply(weight, value.node);
        total = Some(total.map_or(term, |sum| evaluator.graph.add(sum, term)));
    }
    let value = evaluator.graph.multiply(length, total.ok_or(Reported)?);
    let node = evaluator.graph.between(value, (b.node, at_upper.node), (a.node, at_lower.node));
    Ok(Value::scalar(node, integrand.dimension * a.dimension))
}
