//! What a record can ask of the state.

use super::super::evaluate::{Evaluator, Lets, Outcome, Scope, Value};
use super::super::file::File;
use super::super::model::{Norm, Probe};
use super::super::words::{FIELD_WORDS, PROBES};
use super::faces::Bodies;
use super::probe_calls::Call;
use crate::syntax::{Argument, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// The names in a record.
pub(super) struct ProbeScope<'a> {
    pub(super) file: &'a Rc<File>,
    pub(super) lets: Lets,
    pub(super) bodies: Bodies<'a>,
}

/// Names of the components of a vector.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

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
        let call = Call { outer, function, arguments };
        let one = |evaluator: &mut Evaluator<Probe>, probe, dimension| {
            Value::scalar(evaluator.graph.leaf(probe), dimension)
        };
        Some(match (function.text.as_str(), arguments.len()) {
            ("displacement", _) => self.displacement(evaluator, &call),
            ("twist", 1) => self.twist(evaluator, &call),
            ("reaction", 1) => self.reaction(evaluator, &call),
            ("impulse", 1) => self.impulse(evaluator, &call),
            ("section_force", _) => self.section_force(evaluator, &call),
            ("mean", _) => self.mean(evaluator, &call),
            ("at", _) => self.field_at(evaluator, &call),
            ("error", 1) => self.error(evaluator, &call, Norm::RootMeanSquare),
            ("mean_error", 1) => self.error(evaluator, &call, Norm::Mean),
            ("roughness", 1) => call
                .field(evaluator)
                .map(|(field, _)| one(evaluator, Probe::Roughness(field), Dimension::NUMBER)),
            ("max", 1) => call
                .field(evaluator)
                .map(|(field, dimension)| one(evaluator, Probe::FieldMax(field), dimension)),
            ("min", 1) => call
                .field(evaluator)
                .map(|(field, dimension)| one(evaluator, Probe::FieldMin(field), dimension)),
            _ => return None,
        })
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

/// Three components of one probe.
pub(super) fn vector(
    evaluator: &mut Evaluator<Probe>,
    dimension: Dimension,
    probe: impl Fn(u8) -> Probe,
) -> Value {
    Value::List((0..3).map(|axis| Value::scalar(evaluator.graph.leaf(probe(axis)), dimension)).collect())
}
