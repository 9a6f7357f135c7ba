//! What a record can ask of the state.

use super::super::evaluate::{Evaluator, Lets, Outcome, Required, Scope, Value};
use super::super::file::{File, Mistakes, Reported};
use super::super::model::{Coordinate, Field, MotionField, Norm, Probe};
use super::super::words::{FIELD_WORDS, PROBES};
use super::faces::Bodies;
use super::scope::SceneScope;
use super::tables::Tables;
use crate::expression::Tape;
use crate::schema::nearest;
use crate::syntax::{Argument, Code, ExprId, ExprKind, Name};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// The names in a record.
pub(super) struct ProbeScope<'a> {
    pub(super) file: &'a Rc<File>,
    pub(super) lets: Lets,
    pub(super) bodies: Bodies<'a>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

impl Scope<Probe> for ProbeScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<Probe>, name: &Name) -> Option<Outcome> {
        if let Some(outcome) = self.lets.name(evaluator, self, name) {
            return Some(outcome);
        }
        let mut one = |probe, dimension| Some(Ok(Value::scalar(evaluator.graph.leaf(probe), dimension)));
        match name.text.as_str() {
            "t" => one(Probe::Time, Dimension::TIME),
            "kinetic_energy" => one(Probe::KineticEnergy, Dimension::ENERGY),
            "strain_energy" => one(Probe::StrainEnergy, Dimension::ENERGY),
            "total_energy" => one(Probe::TotalEnergy, Dimension::ENERGY),
            "volume" => one(Probe::Volume, Dimension::VOLUME),
            "gradient_error" => one(Probe::GradientError, Dimension::NUMBER),
            "area_map_error" => one(Probe::AreaMapError, Dimension::NUMBER),
            "volume_map_error" => one(Probe::VolumeMapError, Dimension::NUMBER),
            "curl_F" => one(Probe::CurlF, Dimension::NUMBER),
            "div_H" => one(Probe::DivH, Dimension::NUMBER),
            "momentum" => Some(Ok(vector(evaluator, Dimension::MOMENTUM, Probe::Momentum))),
            "angular_momentum" => {
                Some(Ok(vector(evaluator, Dimension::ANGULAR_MOMENTUM, Probe::AngularMomentum)))
            }
            _ => None,
        }
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        match (function.text.as_str(), arguments.len()) {
            ("displacement", _) => Some(self.displacement(evaluator, outer, function, arguments)),
            ("twist", 1) => Some(self.twist(evaluator, outer, arguments)),
            ("reaction", 1) => Some(self.reaction(evaluator, outer, arguments)),
            ("impulse", 1) => Some(self.impulse(evaluator, outer, arguments)),
            ("section_force", _) => Some(self.section_force(evaluator, outer, function, arguments)),
            ("mean", _) => Some(self.mean(evaluator, outer, function, arguments)),
            ("roughness", 1) => {
                let found = written_field(evaluator.mistakes, outer.file(), arguments[0].value);
                Some(found.map(|(field, _)| {
                    Value::scalar(evaluator.graph.leaf(Probe::Roughness(field)), Dimension::NUMBER)
                }))
            }
            ("at", _) => Some(self.field_at(evaluator, outer, function, arguments)),
            ("error", 1) => {
                Some(self.error(evaluator, outer.file(), arguments[0].value, Norm::RootMeanSquare))
            }
            ("mean_error", 1) => Some(self.error(evaluator, outer.file(), arguments[0].value, Norm::Mean)),
            ("max" | "min", 1) => {
                Some(written_field(evaluator.mistakes, outer.file(), arguments[0].value).map(
                    |(field, dimension)| {
                        let probe = if function.text == "max" {
                            Probe::FieldMax(field)
                        } else {
                            Probe::FieldMin(field)
                        };
                        Value::scalar(evaluator.graph.leaf(probe), dimension)
                    },
                ))
            }
            _ => None,
        }
    }

    fn names(&self) -> Vec<String> {
        let lets = self.lets.names().map(|definition| definition.name.text.clone());
        let plain = PROBES.iter().filter(|word| !word.form.contains('(')).map(|word| word.word.to_string());
        lets.chain(plain).chain(["t".to_string()]).collect()
    }

    fn functions(&self) -> Vec<String> {
        PROBES.iter().filter(|word| word.form.contains('(')).map(|word| word.word.to_string()).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        let field = FIELD_WORDS.iter().any(|word| word.word == name);
        field.then(|| format!("`{name}` is a field: write `max({name})` or `at(body, [X, Y, Z], {name})`"))
    }
}

fn vector(evaluator: &mut Evaluator<Probe>, dimension: Dimension, probe: impl Fn(u8) -> Probe) -> Value {
    Value::List((0..3).map(|axis| Value::scalar(evaluator.graph.leaf(probe(axis)), dimension)).collect())
}

impl ProbeScope<'_> {
    /// `displacement(strip.xmax)` or `displacement(at = [x, y, z], strip)`.
    fn displacement(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let at = arguments
            .iter()
            .find(|argument| argument.name.as_ref().is_some_and(|path| path.parts[0].text == "at"));
        let plain: Vec<ExprId> = arguments
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
            (Some(at), plain) if plain.len() <= 1 && arguments.len() == plain.len() + 1 => {
                let body = match plain.first() {
                    Some(body) => self.bodies.body_of(evaluator.mistakes, file, *body),
                    None => self.bodies.only_body(evaluator.mistakes, file, &function.span, &function.text),
                };
                let point = self.point(evaluator, outer, at.value, body)?;
                let body = body?;
                Ok(vector(evaluator, Dimension::LENGTH, |axis| Probe::DisplacementAt { body, point, axis }))
            }
            _ => Err(self.form(evaluator, file, function)),
        }
    }

    fn form(&self, evaluator: &mut Evaluator<Probe>, file: &File, function: &Name) -> Reported {
        let form = PROBES.iter().find(|word| word.word == function.text).map_or("", |word| word.form);
        let message = format!("`{}` is written `{form}`", function.text);
        evaluator.mistakes.report(file, Code::WrongForm, function.span.clone(), message, "", None)
    }

    /// A reference point of a body, which must lie in its modelled part.
    fn point(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        id: ExprId,
        body: Result<usize, Reported>,
    ) -> Result<[f64; 3], Reported> {
        let point =
            evaluator.constant_vector(outer, id, Required { name: "at", dimension: Dimension::LENGTH })?;
        for (axis, value) in point.iter().enumerate() {
            self.inside(evaluator, outer.file(), id, body?, axis, *value)?;
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
    fn twist(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let id = arguments[0].value;
        let region = self.bodies.face_of(evaluator.mistakes, file, id)?;
        if self.bodies.scene.bodies[region.body].shape.face_normal(&region.face).is_none() {
            let message = format!("`{}` is not plane: it has no axis to turn about", file.expression(id));
            let span = file.span(id);
            return Err(evaluator.mistakes.report(file, Code::WrongForm, span, message, "not plane", None));
        }
        Ok(Value::scalar(evaluator.graph.leaf(Probe::Twist { region }), Dimension::NUMBER))
    }

    fn reaction(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let id = arguments[0].value;
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
    fn error(&self, evaluator: &mut Evaluator<Probe>, file: &File, id: ExprId, norm: Norm) -> Outcome {
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
    fn impulse(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        arguments: &[Argument],
    ) -> Outcome {
        let (file, id) = (outer.file(), arguments[0].value);
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
    fn section_force(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let [body, plane] = arguments else { return Err(self.form(evaluator, file, function)) };
        let axis =
            plane.name.as_ref().and_then(|path| AXES.iter().position(|axis| *axis == path.parts[0].text));
        let (None, Some(normal)) = (&body.name, axis) else {
            return Err(self.form(evaluator, file, function));
        };
        let body = self.bodies.body_of(evaluator.mistakes, file, body.value);
        let required = Required { name: AXES[normal], dimension: Dimension::LENGTH };
        let at = evaluator.constant(outer, plane.value, required)?;
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
    fn field_at(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let [body, point, value] = arguments else { return Err(self.form(evaluator, file, function)) };
        let body = self.bodies.body_of(evaluator.mistakes, file, body.value);
        let point = self.point(evaluator, outer, point.value, body);
        let value = written_field(evaluator.mistakes, file, value.value);
        let (body, point, (field, dimension)) = (body?, point?, value?);
        Ok(Value::scalar(evaluator.graph.leaf(Probe::FieldAt { body, point, field }), dimension))
    }
}

impl ProbeScope<'_> {
    /// `mean(body, displacement.z, weight = …)`.
    fn mean(
        &self,
        evaluator: &mut Evaluator<Probe>,
        outer: &dyn Scope<Probe>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let file = outer.file();
        let (body, value, weight) = match arguments {
            [body, value] => (body, value, None),
            [body, value, weight] => (body, value, Some(weight)),
            _ => return Err(self.form(evaluator, file, function)),
        };
        let is_weight =
            |argument: &Argument| argument.name.as_ref().is_some_and(|path| path.parts[0].text == "weight");
        if body.name.is_some() || value.name.is_some() || weight.is_some_and(|weight| !is_weight(weight)) {
            return Err(self.form(evaluator, file, function));
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

/// A field of the particles, `sigma.xx`, and its dimension.
pub(super) fn written_field(
    mistakes: &mut Mistakes,
    file: &File,
    id: ExprId,
) -> Result<(Field, Dimension), Reported> {
    let written = file.expression(id);
    let (word, component) = written.split_once('.').unwrap_or((written, ""));
    let axis = AXES.iter().position(|axis| *axis == component).map(|axis| axis as u8);
    let pair: Vec<u8> = component.chars().filter_map(|c| "xyz".find(c)).map(|axis| axis as u8).collect();
    let pair = (component.len() == 2 && pair.len() == 2).then(|| (pair[0], pair[1]));
    let found = match (word, axis, pair) {
        ("displacement", Some(axis), _) => Some((Field::Displacement(axis), Dimension::LENGTH)),
        ("velocity", Some(axis), _) => Some((Field::Velocity(axis), Dimension::VELOCITY)),
        ("sigma", _, Some((i, j))) => Some((Field::Sigma(i, j), Dimension::PRESSURE)),
        ("P", _, Some((i, j))) => Some((Field::P(i, j), Dimension::PRESSURE)),
        ("F", _, Some((i, j))) => Some((Field::F(i, j), Dimension::NUMBER)),
        ("von_mises", ..) if component.is_empty() => Some((Field::VonMises, Dimension::PRESSURE)),
        ("pressure", ..) if component.is_empty() => Some((Field::Pressure, Dimension::PRESSURE)),
        ("J", ..) if component.is_empty() => Some((Field::J, Dimension::NUMBER)),
        _ => None,
    };
    found.ok_or_else(|| {
        let forms: Vec<&str> = FIELD_WORDS.iter().map(|word| word.form).collect();
        let message = format!("`{written}` is not a field of the particles");
        let help = match FIELD_WORDS.iter().find(|known| known.word == word) {
            Some(known) => format!("write `{}`", known.form),
            None => match nearest(word, FIELD_WORDS.iter().map(|word| word.word)) {
                Some(meant) => format!("write `{meant}`"),
                None => format!("the fields are {}", forms.join(", ")),
            },
        };
        // A field may be called by an expression of any form; what stands there is marked whole.
        let name = matches!(file.tree.expr(id).kind, ExprKind::Name(_) | ExprKind::Member { .. });
        let code = if name { Code::UnknownName } else { Code::WrongForm };
        mistakes.report(file, code, file.span(id), message, "", Some(help))
    })
}
