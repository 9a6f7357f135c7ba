//! `traction`, `body_force`, `gravity`, `start` and the ramp.

use super::super::evaluate::{Evaluator, Outcome, Scalar, Scope, Value, symbol};
use super::super::file::Reported;
use super::super::members::Members;
use super::super::model::{Coordinate, Load, Region, Start};
use super::super::words::{BODY_FORCE, GRAVITY, PRESSURE, START, TRACTION};
use super::stage::Stage;
use crate::discretisation::Shape;
use crate::expression::Comparison;
use crate::syntax::{Argument, BinaryOperator, Block, Code, Diagnostic, ExprKind, Name};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

impl Stage<'_> {
    pub(super) fn traction(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &TRACTION, block);
        let region = self.loaded_face(block);
        let site = members.required(self.mistakes, &file, &TRACTION, block, "value")?;
        let traction = self.fields(&site, "value", Dimension::PRESSURE, (true, true))?;
        let load = Load::Traction { place: file.place(&block.kind.span), region: region?, traction };
        self.scene.loads.push(load);
        self.load_sites.push(super::stage::heading(block));
        Ok(())
    }

    pub(super) fn pressure(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &PRESSURE, block);
        let region = self.loaded_face(block);
        let site = members.required(self.mistakes, &file, &PRESSURE, block, "value")?;
        let pressure = self.field(&site, "value", Dimension::PRESSURE, (true, true))?;
        let load = Load::Pressure { place: file.place(&block.kind.span), region: region?, pressure };
        self.scene.loads.push(load);
        self.load_sites.push(super::stage::heading(block));
        Ok(())
    }

    /// The face a force per area acts on: it must have an area.
    fn loaded_face(&mut self, block: &Block) -> Result<Region, Reported> {
        let region = self.target_face(block)?;
        if !matches!(self.scene.bodies[region.body].shape, Shape::Points(_)) {
            return Ok(region);
        }
        let file = Rc::clone(&self.file);
        let name = &self.scene.bodies[region.body].name;
        let message = format!("`{name}` is made of points without cells, its faces have no area");
        let help = Some("write `body_force`, `move`, or give a file with hexahedra".into());
        let span = super::stage::heading(block);
        Err(self.mistakes.report(&file, Code::Conflict, span, message, "", help))
    }

    pub(super) fn body_force(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &BODY_FORCE, block);
        let body = self.target_body(block);
        let site = members.required(self.mistakes, &file, &BODY_FORCE, block, "value")?;
        let force = self.fields(&site, "value", Dimension::PRESSURE / Dimension::LENGTH, (true, true))?;
        let load = Load::BodyForce { place: file.place(&block.kind.span), body: body?, force };
        self.scene.loads.push(load);
        self.load_sites.push(super::stage::heading(block));
        Ok(())
    }

    pub(super) fn gravity(&mut self, block: &Block) -> Result<(), Reported> {
        self.only_one(block)?;
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &GRAVITY, block);
        let site = members.required(self.mistakes, &file, &GRAVITY, block, "acceleration")?;
        let acceleration = self.constants(&site, "acceleration", Dimension::ACCELERATION)?;
        let load = Load::Gravity { place: file.place(&block.kind.span), acceleration };
        self.scene.loads.push(load);
        self.load_sites.push(super::stage::heading(block));
        Ok(())
    }

    pub(super) fn start(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &START, block);
        let body = self.target_body(block);
        let site = members.required(self.mistakes, &file, &START, block, "velocity")?;
        let velocity = self.fields(&site, "velocity", Dimension::VELOCITY, (true, false))?;
        let body = body?;
        if let Some(first) = self.scene.starts.iter().find(|start| start.body == body) {
            let message = format!(
                "the start of `{}` is given twice, first on line {}",
                self.scene.bodies[body].name, first.place.line
            );
            let span = block.kind.span.clone();
            return Err(self.mistakes.report(&file, Code::Conflict, span, message, "here again", None));
        }
        self.scene.starts.push(Start { place: file.place(&block.kind.span), body, velocity });
        Ok(())
    }
}

/// `ramp(a -> b, over = T, shape = smooth | linear)`.
///
/// ```text
/// a + (b − a) w(t/T),   w(s) = s³ (10 − 15 s + 6 s²) smooth,   w(s) = s linear,   s clipped to [0, 1]
/// ```
///
/// The smooth ramp has no velocity and no acceleration at either end.
pub(super) fn ramp(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    function: &Name,
    arguments: &[Argument],
) -> Outcome {
    let file = Rc::clone(scope.file());
    let mut ends = None;
    let mut over = None;
    let mut linear = false;
    for argument in arguments {
        let kind = &file.tree.expr(argument.value).kind;
        match (argument.name.as_ref().map(|path| path.parts[0].text.as_str()), kind) {
            (None, ExprKind::Binary { operator: BinaryOperator::Arrow, at, left, right }) => {
                let (a, b) = (evaluator.scalar(scope, *left), evaluator.scalar(scope, *right));
                let (a, b) = (a?, b?);
                if a.dimension != b.dimension {
                    let (from, to) = (a.dimension.describe(), b.dimension.describe());
                    let arrow = symbol(BinaryOperator::Arrow);
                    let message = format!("`{arrow}` leads from {from} to {to}");
                    let diagnostic = Diagnostic::new(Code::MixedDimensions, message, at.clone(), "")
                        .with_label(file.span(*left), from)
                        .with_label(file.span(*right), to);
                    return Err(evaluator.mistakes.push(&file, diagnostic));
                }
                ends = Some((a, b));
            }
            (Some("over"), _) => {
                let required = super::super::evaluate::Required { name: "over", dimension: Dimension::TIME };
                let duration = evaluator.constant(scope, argument.value, required)?;
                if duration <= 0.0 {
                    let found = Quantity::new(duration, Dimension::TIME);
                    let message = format!("`over` must be > 0, but the value is {found}");
                    let span = file.span(argument.value);
                    return Err(evaluator.mistakes.report(
                        &file,
                        Code::ParameterOutOfRange,
                        span,
                        message,
                        "outside",
                        None,
                    ));
                }
                over = Some(duration);
            }
            (Some("shape"), ExprKind::Name(word)) if word == "linear" || word == "smooth" => {
                linear = word == "linear"
            }
            _ => {
                let message = format!("`ramp` has no argument `{}`", file.expression(argument.value));
                let help = Some("write `ramp(0 mm -> 1 mm, over = 2 ms)` or with `shape = linear`".into());
                let span = file.span(argument.value);
                return Err(evaluator.mistakes.report(&file, Code::UnknownArgument, span, message, "", help));
            }
        }
    }
    let (Some((a, b)), Some(duration)) = (ends, over) else {
        let message = "`ramp` needs what it leads from and to, and the time it takes";
        let help = Some("write `ramp(0 mm -> 1 mm, over = 2 ms)`".into());
        return Err(evaluator.mistakes.report(
            &file,
            Code::MissingArgument,
            function.span.clone(),
            message,
            "",
            help,
        ));
    };
    evaluator.ramps.push((Rc::clone(&file), function.span.clone(), duration));
    Ok(Value::Scalar(ramp_formula(evaluator, a, b, duration, linear)))
}

fn ramp_formula(
    evaluator: &mut Evaluator<Coordinate>,
    a: Scalar,
    b: Scalar,
    duration: f64,
    linear: bool,
) -> Scalar {
    let graph = &mut evaluator.graph;
    let time = graph.leaf(Coordinate::Time);
    let end = graph.constant(duration);
    let s = graph.divide(time, end);
    let weight = if linear {
        s
    } else {
        // s³ (10 − s (15 − 6 s))
        let (six, ten, fifteen) = (graph.constant(6.0), graph.constant(10.0), graph.constant(15.0));
        let inner = graph.multiply(six, s);
        let inner = graph.subtract(fifteen, inner);
        let inner = graph.multiply(s, inner);
        let inner = graph.subtract(ten, inner);
        let three = graph.constant(3.0);
        let cube = graph.power(s, three);
        graph.multiply(cube, inner)
    };
    let way = graph.subtract(b.node, a.node);
    let moved = graph.multiply(way, weight);
    let moving = graph.add(a.node, moved);
    // Exactly b after the end, whatever the polynomial rounds to.
    let node = graph.select((time, Comparison::Less, end), moving, b.node);
    Scalar { node, dimension: a.dimension }
}
