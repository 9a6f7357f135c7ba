//! Materials: an energy with numbers, a density and directions.
//!
//! Owns the giving of arguments to energies. Knows no scene.

mod arguments;
mod directions;
mod rest;
mod term;
mod used;

use super::energies::EnergyDef;
use super::evaluate::{
    Elsewhere, Evaluator, Leaves, Lets, Outcome, Required, Scalar, Scope, Value, place_word,
};
use super::file::{File, Mistakes, Reported};
use super::members::{Members, Overrides, ParamEntry, ParameterDef, Site, within};
use super::model::{Coordinate, Direction, Material, MaterialParameter};
use super::words::{FRAME, MATERIAL};
use crate::energy::Leaf;
use crate::expression::Tape;
use crate::fit::Range;
use crate::syntax::{Argument, Block, Code, Diagnostic, Name, Span};
use crate::unit::{Dimension, Quantity};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

pub(super) use rest::stressed;
pub(super) use term::Energies;
pub(super) use used::{Declared, Materials, used};

/// Values in place of those written in a material: of the command line, then of the use.
struct Instead<'a> {
    overrides: &'a Overrides,
    given: &'a BTreeMap<String, Site>,
}

/// A parameter of the material itself.
struct Own {
    name: String,
    value: f64,
    dimension: Dimension,
    range: Range,
    /// Whether a direction has read it.
    turns: Cell<bool>,
}

impl Own {
    fn new(name: &str, value: f64, dimension: Dimension, range: Range) -> Self {
        Self { name: name.into(), value, dimension, range, turns: Cell::new(false) }
    }
}

/// Reads a material, its parameters with the values `given` for them in place of those written.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    energies: &Energies,
    overrides: &Overrides,
    given: &BTreeMap<String, Site>,
) -> Result<Material, Reported> {
    let before = mistakes.len();
    let members = Members::read_with(mistakes, file, &MATERIAL, block, overrides, &[&name.text]);
    let lets = Lets::new(members.lets.clone());
    let own = parameters(mistakes, file, &members, &lets, &Instead { overrides, given }, &name.text);
    let frame = frame(mistakes, file, &members);
    let density = density(mistakes, file, block, &members, &lets, &own);
    let directions = directions::read(mistakes, file, &members, &lets, &own, &frame);
    let energy = members.required(mistakes, file, &MATERIAL, block, "energy");
    let energy = energy?;
    let mut evaluator = Evaluator::<Leaf>::new(mistakes);
    evaluator.parameters = own.iter().map(|own| own.value).collect();
    let fibres: Vec<String> = members.fibre.iter().map(|(name, _)| name.text.clone()).collect();
    let scope = MaterialScope {
        file: Rc::clone(file),
        own: &own,
        lets: lets.fresh(),
        directions: Named::Indices { fibres: &fibres, frame: &frame, used: RefCell::default() },
    };
    let listed: Vec<MaterialParameter> = own
        .iter()
        .map(|own| MaterialParameter {
            name: own.name.clone(),
            value: own.value,
            unit: own.dimension.si_symbol(),
            range: own.range,
            turns_direction: own.turns.get(),
        })
        .collect();
    let written = Elsewhere { outer: &scope, file: Rc::clone(&energy.file) };
    let mut sum = term::Sum::new(&written, energies, overrides, (&name.text, fibres.len()), listed);
    sum.add(&mut evaluator, energy.id);
    let (whole, density, directions) = (sum.finish()?, density?, directions?);
    let Named::Indices { used, .. } = &scope.directions else { return Err(Reported) };
    let material = Material {
        name: name.text.clone(),
        place: file.place(&block.kind.span),
        density,
        energy: evaluator.tape(whole.total),
        parameters: whole.parameters,
        constraints: whole.constraints.into_iter().map(|open| open.closed(&evaluator)).collect(),
        terms: whole.terms,
        directions: directions.named(fibres.iter().chain(&*used.borrow())),
        frame: directions.named(frame.iter().map(|(name, _)| &name.text)),
    };
    if mistakes.len() > before {
        return Err(Reported);
    }
    rest::check(mistakes, &energy, &material)?;
    Ok(material)
}

/// The parameters of the material itself, with what stands instead of their values.
fn parameters(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    members: &Members,
    lets: &Lets,
    instead: &Instead,
    material: &str,
) -> Vec<Own> {
    let mut own: Vec<Own> = Vec::new();
    for entry in &members.parameters {
        let Ok(parameter) = ParameterDef::read(mistakes, file, entry) else {
            own.push(Own::new(&entry.name.text, f64::NAN, Dimension::NUMBER, Range::default()));
            continue;
        };
        let value = parameter_value(mistakes, file, entry, &parameter, (lets, &own), instead, material);
        // A parameter without a value stays known, so that its uses are no further mistakes.
        let (value, range) = value.unwrap_or((f64::NAN, Range::default()));
        own.push(Own::new(&parameter.name.text, value, parameter.dimension, range));
    }
    own
}

fn parameter_value(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    entry: &ParamEntry,
    parameter: &ParameterDef,
    (lets, own): (&Lets, &[Own]),
    instead: &Instead,
    material: &str,
) -> Result<(f64, Range), Reported> {
    let name = &parameter.name.text;
    if let Some(count) = &parameter.count {
        let message = "an array can be a parameter of an energy, not of a material";
        return Err(mistakes.report(file, Code::WrongForm, count.span.clone(), message, "", None));
    }
    let given = instead.overrides.find(&[material], name).or_else(|| instead.given.get(name).cloned());
    let written = entry.default.map(|id| Site { file: Rc::clone(file), id });
    let Some(site) = given.or(written) else {
        let example = super::evaluate::example_with_unit("1", parameter.dimension);
        let message = format!("the parameter `{name}` of a material needs a value");
        let help =
            format!("write `param {name} : {} = {example}` with the value that is meant", parameter.written);
        return Err(mistakes.report(
            file,
            Code::MissingArgument,
            entry.name.span.clone(),
            message,
            "no value",
            Some(help),
        ));
    };
    let mut evaluator = Evaluator::<Coordinate>::new(mistakes);
    let home = MaterialScope { file: Rc::clone(file), own, lets: lets.fresh(), directions: Named::None };
    let scope = Elsewhere { outer: &home, file: Rc::clone(&site.file) };
    let required = Required { name, dimension: parameter.dimension };
    let value = evaluator.constant(&scope, site.id, required)?;
    let span = site.file.span(site.id);
    within::check(&mut evaluator, &home, parameter, value, &site.file, span)?;
    Ok((value, within::range(&mut evaluator, &home, parameter)?))
}

/// The entries of the material's frames.
fn frame(mistakes: &mut Mistakes, file: &Rc<File>, members: &Members) -> Vec<(Name, crate::syntax::ExprId)> {
    let mut frame = Vec::new();
    for block in &members.blocks {
        if block.kind.text == FRAME.word {
            frame.extend(Members::read(mistakes, file, &FRAME, block).free);
        } else {
            super::blocks::unknown_block(mistakes, file, block, Some(MATERIAL.word));
        }
    }
    frame
}

fn density(
    mistakes: &mut Mistakes,
    file: &Rc<File>,
    block: &Block,
    members: &Members,
    lets: &Lets,
    own: &[Own],
) -> Result<f64, Reported> {
    let site = members.required(mistakes, file, &MATERIAL, block, "density")?;
    let mut evaluator = Evaluator::<Coordinate>::new(mistakes);
    let home = MaterialScope { file: Rc::clone(file), own, lets: lets.fresh(), directions: Named::None };
    let scope = Elsewhere { outer: &home, file: Rc::clone(&site.file) };
    let required = Required { name: "density", dimension: Dimension::DENSITY };
    let value = evaluator.constant(&scope, site.id, required)?;
    if value > 0.0 {
        return Ok(value);
    }
    let found = Quantity::new(value, Dimension::DENSITY);
    let message = format!("`density` must be > 0, but the value is {found}");
    let span = site.file.span(site.id);
    Err(mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "outside", None))
}

/// What the names of directions are bound to.
enum Named<'a> {
    /// Nothing: directions are not known here.
    None,
    /// Their indices; those of the frame are counted when they are used.
    Indices { fibres: &'a [String], frame: &'a [(Name, crate::syntax::ExprId)], used: RefCell<Vec<String>> },
    /// Their components, as far as they are evaluated.
    Components(&'a RefCell<BTreeMap<String, Outcome>>),
}

/// The names in a material.
struct MaterialScope<'a> {
    file: Rc<File>,
    own: &'a [Own],
    lets: Lets,
    directions: Named<'a>,
}

impl<L: Leaves> Scope<L> for MaterialScope<'_> {
    fn file(&self) -> &Rc<File> {
        &self.file
    }

    fn name(&self, evaluator: &mut Evaluator<L>, name: &Name) -> Option<Outcome> {
        if let Some(index) = self.own.iter().position(|own| own.name == name.text) {
            let own = &self.own[index];
            if own.value.is_nan() {
                return Some(Err(Reported));
            }
            if matches!(self.directions, Named::Components(_)) {
                own.turns.set(true);
            }
            let node = match L::parameter(index as u32) {
                Some(leaf) => evaluator.graph.leaf(leaf),
                None => evaluator.graph.constant(own.value),
            };
            return Some(Ok(Value::scalar(node, own.dimension)));
        }
        if let Some(outcome) = self.lets.name(evaluator, self, name) {
            return Some(outcome);
        }
        match &self.directions {
            Named::None => None,
            Named::Indices { fibres, frame, used } => {
                let index = match fibres.iter().position(|fibre| *fibre == name.text) {
                    Some(index) => index,
                    None => {
                        frame.iter().find(|(direction, _)| direction.text == name.text)?;
                        let mut used = used.borrow_mut();
                        let position =
                            used.iter().position(|known| *known == name.text).unwrap_or_else(|| {
                                used.push(name.text.clone());
                                used.len() - 1
                            });
                        fibres.len() + position
                    }
                };
                Some(Ok(Value::Direction(index as u8)))
            }
            Named::Components(known) => {
                let known = known.borrow().get(&name.text).cloned();
                known.or_else(|| place_word(evaluator, &name.text, true, false))
            }
        }
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<L>,
        outer: &dyn Scope<L>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        self.lets.call(evaluator, self, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        let own = self.own.iter().map(|own| own.name.clone());
        let lets = self.lets.names().map(|definition| definition.name.text.clone());
        let directions: Vec<String> = match &self.directions {
            Named::None => vec![],
            Named::Indices { fibres, frame, .. } => {
                fibres.iter().cloned().chain(frame.iter().map(|(name, _)| name.text.clone())).collect()
            }
            Named::Components(known) => known.borrow().keys().cloned().collect(),
        };
        own.chain(lets).chain(directions).collect()
    }
}
