//! Energies as text: declared, checked once for every value of their parameters, then given numbers.
//!
//! Owns the words an energy may use and the proof that `psi` is a pressure. Knows no material.

mod integral;

use super::evaluate::{Evaluator, Lets, Outcome, Scalar, Scope, Value};
use super::file::{File, Mistakes, Reported};
use super::members::{Members, ParameterDef};
use super::model::Place;
use super::words::{ENERGY, ENERGY_WORDS};
use crate::energy::{Invariant, Leaf};
use crate::syntax::{Argument, Block, Code, ExprId, Name};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// A declared energy.
#[derive(Debug)]
pub(super) struct EnergyDef {
    pub(super) file: Rc<File>,
    pub(super) place: Place,
    pub(super) parameters: Vec<ParameterDef>,
    /// Parameters whose declaration is wrong: known, so that their uses are no further mistakes.
    broken: Vec<String>,
    /// The word after `fibres`, if the energy sums over the fibres of its material.
    pub(super) fibres: Option<Name>,
    /// Directions bound by arguments.
    pub(super) directions: Vec<Name>,
    lets: Lets,
    pub(super) psi: ExprId,
}

/// Reads an energy and proves its dimensions whatever the values of its parameters.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn declare(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    block: &Block,
) -> Result<EnergyDef, Reported> {
    let before = mistakes.len();
    let members = Members::read(mistakes, file, &ENERGY, block);
    let mut parameters = Vec::new();
    let mut broken = Vec::new();
    for entry in &members.parameters {
        match ParameterDef::read(mistakes, file, entry) {
            Ok(parameter) => parameters.push(parameter),
            Err(Reported) => broken.push(entry.name.text.clone()),
        }
    }
    for name in members.names() {
        refuse_taken(mistakes, file, name);
    }
    let psi = members.key(mistakes, file, &ENERGY, block, "psi")?;
    let energy = EnergyDef {
        file: Rc::clone(file),
        place: file.place(&block.kind.span),
        parameters,
        broken,
        fibres: members.fibres.clone(),
        directions: members.directions.clone(),
        lets: Lets::new(members.lets),
        psi,
    };
    energy.prove(mistakes);
    if mistakes.len() > before { Err(Reported) } else { Ok(energy) }
}

/// Refuses a name that already means an invariant.
fn refuse_taken(mistakes: &mut Mistakes, file: &File, name: &Name) {
    if let Some(word) = ENERGY_WORDS.iter().find(|word| word.form == name.text) {
        let message = format!(
            "`{}` already means something in an energy: {}",
            name.text,
            word.doc.trim_end_matches('.')
        );
        mistakes.report(file, Code::DuplicateName, name.span.clone(), message, "choose another name", None);
    }
}

impl EnergyDef {
    /// Evaluates the energy with parameters of unknown value, two fibres and arrays of length two.
    fn prove(&self, mistakes: &mut Mistakes) {
        let mut evaluator = Evaluator::<Leaf>::new(mistakes);
        let mut values = BTreeMap::new();
        let mut next = 0;
        for parameter in &self.parameters {
            let mut leaf = |evaluator: &mut Evaluator<Leaf>| {
                next += 1;
                Value::scalar(evaluator.graph.leaf(Leaf::Parameter(next - 1)), parameter.dimension)
            };
            let value = match &parameter.count {
                None => leaf(&mut evaluator),
                Some(count) => {
                    let two = evaluator.graph.constant(2.0);
                    values.insert(count.text.clone(), Value::scalar(two, Dimension::NUMBER));
                    Value::List(vec![leaf(&mut evaluator), leaf(&mut evaluator)])
                }
            };
            values.insert(parameter.name.text.clone(), value);
        }
        let count = self.directions.len() as u8;
        for (index, direction) in self.directions.iter().enumerate() {
            values.insert(direction.text.clone(), Value::Direction(index as u8));
        }
        let fibres = if self.fibres.is_some() { vec![count, count + 1] } else { vec![] };
        let scope = self.scope(values, fibres);
        for parameter in &self.parameters {
            parameter.prove(&mut evaluator, &scope);
        }
        for definition in self.lets.names().filter(|definition| definition.arguments.is_empty()) {
            // Its mistakes are reported; its value is not needed here.
            let _ = self.lets_of(&scope).name(&mut evaluator, &scope, &definition.name);
        }
        let _ = self.density(&mut evaluator, &scope);
    }

    fn lets_of<'a>(&self, scope: &'a EnergyScope) -> &'a Lets {
        &scope.lets
    }

    /// The scope in which the energy's expressions stand, its names bound to values.
    pub(super) fn scope(&self, values: BTreeMap<String, Value>, fibres: Vec<u8>) -> EnergyScope<'_> {
        EnergyScope { energy: self, values, fibres, lets: self.lets.fresh() }
    }

    /// `psi`, a pressure.
    pub(super) fn density(
        &self,
        evaluator: &mut Evaluator<Leaf>,
        scope: &EnergyScope,
    ) -> Result<Scalar, Reported> {
        let psi = evaluator.scalar(scope, self.psi)?;
        if psi.dimension == Dimension::PRESSURE {
            return Ok(psi);
        }
        let found = psi.dimension.describe();
        let message = format!("`psi` is an energy per volume (a pressure), but the value is {found}");
        let span = self.file.span(self.psi);
        Err(evaluator.mistakes.report(&self.file, Code::EnergyDimension, span, message, found, None))
    }
}

/// The names in an energy.
pub(super) struct EnergyScope<'a> {
    energy: &'a EnergyDef,
    values: BTreeMap<String, Value>,
    fibres: Vec<u8>,
    lets: Lets,
}

impl Scope<Leaf> for EnergyScope<'_> {
    fn file(&self) -> &Rc<File> {
        &self.energy.file
    }

    fn name(&self, evaluator: &mut Evaluator<Leaf>, name: &Name) -> Option<Outcome> {
        if let Some(value) = self.values.get(&name.text) {
            return Some(Ok(value.clone()));
        }
        if self.energy.broken.contains(&name.text) {
            return Some(Err(Reported));
        }
        // A name without arguments knows no direction an integral runs over.
        let within = std::mem::take(&mut evaluator.integrating);
        let outcome = self.lets.name(evaluator, self, name);
        evaluator.integrating = within;
        if let Some(outcome) = outcome {
            return Some(outcome);
        }
        if name.text == "fibres" && self.energy.fibres.is_some() {
            return Some(Ok(Value::List(self.fibres.iter().map(|index| Value::Direction(*index)).collect())));
        }
        let leaf = Leaf::Invariant(invariant(&name.text)?);
        Some(Ok(Value::scalar(evaluator.graph.leaf(leaf), Dimension::NUMBER)))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Leaf>,
        outer: &dyn Scope<Leaf>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        integral::call(evaluator, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        let own = self
            .values
            .keys()
            .cloned()
            .chain(self.lets.names().map(|definition| definition.name.text.clone()));
        own.chain(ENERGY_WORDS.iter().filter(|word| word.form == word.word).map(|word| word.word.into()))
            .collect()
    }

    fn functions(&self) -> Vec<String> {
        let own = self.lets.names().filter(|definition| !definition.arguments.is_empty());
        own.map(|definition| definition.name.text.clone())
            .chain(ENERGY_WORDS.iter().filter(|word| word.form != word.word).map(|word| word.word.into()))
            .collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        (name == "fibres")
            .then(|| "write `fibres a` in the energy to declare that it sums over fibres".into())
    }
}

/// The invariants without arguments.
fn invariant(word: &str) -> Option<Invariant> {
    Some(match word {
        "I1" => Invariant::I1,
        "I2" => Invariant::I2,
        "I3" => Invariant::I3,
        "J" => Invariant::J,
        "I1bar" => Invariant::I1Bar,
        "I2bar" => Invariant::I2Bar,
        "lam1" => Invariant::Stretch(0),
        "lam2" => Invariant::Stretch(1),
        "lam3" => Invariant::Stretch(2),
        "lam1bar" => Invariant::StretchBar(0),
        "lam2bar" => Invariant::StretchBar(1),
        "lam3bar" => Invariant::StretchBar(2),
        _ => return None,
    })
}
