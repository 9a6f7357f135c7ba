//! Probes with arguments: `reaction(strip.xmax)`, `at(strip, [x, y, z], J)`.

use super::super::evaluate::{Evaluator, Outcome, Required, Scope, Value};
use super::super::file::{File, Reported};
use super::super::model::{Coordinate, Field, MotionField, Norm, Probe};
use super::super::words::PROBES;
use super::fields::written_field;
use super::probes::{AXES, ProbeScope, vector};
use super::scope::SceneScope;
use super::tables::Tables;
use crate::expression::Tape;
use crate::syntax::{Argument, Code, ExprId, Name};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// A call of a probe as written.
pub(super) struct Call<'a> {
    /// Where names in its arguments mean something.
    pub(super) outer: &'a dyn Scope<Probe>,
    pub(super) function: &'a Name,
    pub(super) arguments: &'a [Argument],
}

impl<'a> Call<'a> {
    /// The file it stands in.
    pub(super) fn file(&self) -> &'a Rc<File> {
        self.outer.file()
    }

    /// Tells how it is written.
    fn form(&self, evaluator: &mut Evaluator<Probe>) -> Reported {
        let function = self.function;
        let form = PROBES.iter().find(|word| word.word == function.text).map_or("", |word| word.form);
        let message = format!("`{}` is written `{form}`", function.text);
        let span = function.span.clone();
        evaluator.mistakes.report(self.file(), Code::WrongForm, span, message, "", None)
    }

    /// A field as its first argument.
    pub(super) fn field(&self, evaluator: &mut Evaluator<Probe>) -> Result<(Field, Dimension), Reported> {
        written_field(evaluator.mistakes, self.file(), self.arguments[0].value)
    }
}

impl ProbeScope<'_> {
    /// `displacement(strip.xmax)` or `displacement(at = [x, y, z], strip)`.
    pub(super) fn displacement(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let file = call.file();
        let at = call
            .arguments
            .iter()
            .find(|argument| argument.name.as_ref().is_some_and(|path| path.parts[0].text == "at"));
        let plain: Vec<ExprId> = call
            .arguments
            .iter()
            .filter(|argument| argument.name.is_none())
            .map(|argument| argument.value)
            .collect();
        match (at, plain.as_slice()) {
            (None, &[face]) => {
                let region = self.bodies.face_of(evaluator.mistakes, file, face)?;
                let probe = |axis| Probe::Displacement { region: region.clone(), axis };
                Ok(vector(evaluator, Dimension::LENGTH, probe))
            }
            (Some(at), plain) if plain.len() <= 1 && call.arguments.len() == plain.len() + 1 => {
                let body = match plain.first() {
                    Some(body) => self.bodies.body_of(evaluator.mistakes, file, *body),
                    None => self.bodies.only_body(
                        evaluator.mistakes,
                        file,
                        &call.function.span,
                        &call.function.text,
                    ),
                };
                let point = self.point(evaluator, call, at.value, body)?;
                let body = body?;
                Ok(vector(evaluator, Dimension::LENGTH, |axis| Probe::DisplacementAt { body, point, axis }))
            }
            _ => Err(call.form(evaluator)),
        }
    }

    /// A reference point of a body, which must lie in its modelled part.
    fn point(
        &self,
        evaluator: &mut Evaluator<Probe>,
        call: &Call<'_>,
        id: ExprId,
        body: Result<usize, Reported>,
    ) -> Result<[f64; 3], Reported> {
        let point = evaluator.constant_vector(
            call.outer,
            id,
            Required { name: "at", dimension: Dimension::LENGTH },
        )?;
        for (axis, value) in point.iter().enumerate() {
            self.inside(evaluator, call.file(), id, body?, axis, *value)?;
        }
        Ok(point)
    }

    fn inside(
        &self,
        evaluator: &mut Evaluator<Probe>,
        file: &File,
        id: ExprId,
        body: usize,
        axis: usize,
        value: f64,
    ) -> Result<(), Reported> {
        let body = &self.bodies.scene.bodies[body];
        let (low, high) = body.shape.bounds();
        let cut = self.bodies.scene.symmetry[axis].as_ref().map(|plane| plane.at);
        let low = cut.unwrap_or(low[axis]);
        let slack = 1e-9 * (high[axis] - low);
        if value >= low - slack && value <= high[axis] + slack {
            return Ok(());
        }
        let length = |value| Quantity::new(value, Dimension::LENGTH);
        let part = if cut.is_some() { "the modelled part of " } else { "" };
        let message = format!(
            "{} = {} lies outside {part}`{}`, which reaches from {} to {}",
            ["X", "Y", "Z"][axis],
            length(value),
            body.name,
            length(low),
            length(high[axis])
        );
        Err(evaluator.mistakes.report(file, Code::WrongForm, file.span(id), message, "outside", None))
    }

    /// `twist(column.ymax)`, of a plane face.
    pub(super) fn twist(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let (file, id) = (call.file(), call.arguments[0].value);
        let region = self.bodies.face_of(evaluator.mistakes, file, id)?;
        if self.bodies.scene.bodies[region.body].shape.face_normal(&region.face).is_none() {
            let message = format!("`{}` is not plane: it has no axis to turn about", file.expression(id));
            let span = file.span(id);
            return Err(evaluator.mistakes.report(file, Code::WrongForm, span, message, "not plane", None));
        }
        Ok(Value::scalar(evaluator.graph.leaf(Probe::Twist { region }), Dimension::NUMBER))
    }

    pub(super) fn reaction(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let (file, id) = (call.file(), call.arguments[0].value);
        let region = self.bodies.face_of(evaluator.mistakes, file, id)?;
        if !self.bodies.scene.prescribed.iter().any(|prescribed| prescribed.region == region) {
            let face = file.expression(id).to_string();
            let message = format!("nothing supports `{face}`, it has no reaction");
            let help =
                Some(format!("write `hold {face}`, `slide {face}` or `pull {face} {{ … }}` in the scene"));
            return Err(evaluator.mistakes.report(
                file,
                Code::WrongForm,
                file.span(id),
                message,
                "free",
                help,
            ));
        }
        Ok(vector(evaluator, Dimension::FORCE, |axis| Probe::Reaction { region: region.clone(), axis }))
    }

    /// `error(x)`: the distance from the exact motion.
    pub(super) fn error(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>, norm: Norm) -> Outcome {
        let (file, id) = (call.file(), call.arguments[0].value);
        let written = file.expression(id);
        let known = [
            ("x", MotionField::Position, Dimension::LENGTH),
            ("v", MotionField::Velocity, Dimension::VELOCITY),
            ("F", MotionField::Gradient, Dimension::NUMBER),
            ("H", MotionField::AreaMap, Dimension::NUMBER),
            ("J", MotionField::VolumeMap, Dimension::NUMBER),
            ("P", MotionField::Stress, Dimension::PRESSURE),
        ];
        let Some((_, field, dimension)) = known.into_iter().find(|(word, ..)| *word == written) else {
            let message = format!("an exact motion has no `{written}` to compare with");
            let help = Some("write error(x), error(v), error(F), error(H), error(J) or error(P)".into());
            return Err(evaluator.mistakes.report(file, Code::UnknownName, file.span(id), message, "", help));
        };
        if self.bodies.scene.motion.is_none() {
            let message = "there is no exact motion to differ from";
            let help = Some("write `motion { x = [ …, …, … ] }` in the scene".into());
            let span = file.span(id);
            return Err(evaluator.mistakes.report(file, Code::WrongForm, span, message, "", help));
        }
        Ok(Value::scalar(evaluator.graph.leaf(Probe::MotionError(field, norm)), dimension))
    }

    /// `impulse(strip.xmax)` or `impulse(strip)`.
    pub(super) fn impulse(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let (file, id) = (call.file(), call.arguments[0].value);
        let (body, face) = if file.expression(id).contains('.') {
            let region = self.bodies.face_of(evaluator.mistakes, file, id)?;
            (region.body, Some(region.face))
        } else {
            (self.bodies.body_of(evaluator.mistakes, file, id)?, None)
        };
        let probe = |axis| Probe::Impulse { body, face: face.clone(), axis };
        Ok(vector(evaluator, Dimension::MOMENTUM, probe))
    }

    /// `section_force(strip, x = 0 mm)`.
    pub(super) fn section_force(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let file = call.file();
        let [body, plane] = call.arguments else { return Err(call.form(evaluator)) };
        let axis =
            plane.name.as_ref().and_then(|path| AXES.iter().position(|axis| *axis == path.parts[0].text));
        let (None, Some(normal)) = (&body.name, axis) else {
            return Err(call.form(evaluator));
        };
        let body = self.bodies.body_of(evaluator.mistakes, file, body.value);
        let required = Required { name: AXES[normal], dimension: Dimension::LENGTH };
        let at = evaluator.constant(call.outer, plane.value, required)?;
        let body = body?;
        self.inside(evaluator, file, plane.value, body, normal, at)?;
        Ok(vector(evaluator, Dimension::FORCE, |axis| Probe::SectionForce {
            body,
            normal: normal as u8,
            at,
            axis,
        }))
    }

    /// `at(strip, [x, y, z], sigma.xx)`.
    pub(super) fn field_at(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let file = call.file();
        let [body, point, value] = call.arguments else { return Err(call.form(evaluator)) };
        let body = self.bodies.body_of(evaluator.mistakes, file, body.value);
        let point = self.point(evaluator, call, point.value, body);
        let value = written_field(evaluator.mistakes, file, value.value);
        let (body, point, (field, dimension)) = (body?, point?, value?);
        Ok(Value::scalar(evaluator.graph.leaf(Probe::FieldAt { body, point, field }), dimension))
    }

    /// `mean(body, displacement.z, weight = …)`.
    pub(super) fn mean(&self, evaluator: &mut Evaluator<Probe>, call: &Call<'_>) -> Outcome {
        let file = call.file();
        let (body, value, weight) = match call.arguments {
            [body, value] => (body, value, None),
            [body, value, weight] => (body, value, Some(weight)),
            _ => return Err(call.form(evaluator)),
        };
        let is_weight =
            |argument: &Argument| argument.name.as_ref().is_some_and(|path| path.parts[0].text == "weight");
        if body.name.is_some() || value.name.is_some() || weight.is_some_and(|weight| !is_weight(weight)) {
            return Err(call.form(evaluator));
        }
        let body = self.bodies.body_of(evaluator.mistakes, file, body.value);
        let (field, dimension) = written_field(evaluator.mistakes, file, value.value)?;
        let weight = match weight {
            None => Tape::constant(1.0),
            Some(weight) => {
                let tables = Tables::new();
                let lets = self.lets.fresh();
                let scope = SceneScope { file, lets, tables: &tables, place: true, time: false };
                let mut over_place = Evaluator::<Coordinate>::new(evaluator.mistakes);
                let required = Required { name: "weight", dimension: Dimension::NUMBER };
                let scalar = over_place.quantity(&scope, weight.value, required)?;
                over_place.tape(scalar)
            }
        };
        let probe = Probe::Mean { body: body?, field, weight };
        Ok(Value::scalar(evaluator.graph.leaf(probe), dimension))
    }
}
