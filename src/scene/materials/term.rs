//! The sum of energies of a material, each with its arguments.

use super::super::evaluate::example_with_unit;
use super::super::model::{Constraint, Place};
use super::arguments::{Arguments, Given};
use super::*;
use crate::schema::nearest;
use crate::syntax::{BinaryOperator, ExprId, ExprKind};

/// The energies a file knows by name; `None` where the declaration itself is wrong.
pub(in crate::scene) type Energies = BTreeMap<String, Option<Rc<EnergyDef>>>;

/// A sum under construction.
pub(super) struct Sum<'a> {
    scope: &'a dyn Scope<Leaf>,
    energies: &'a Energies,
    overrides: &'a Overrides,
    material: &'a str,
    fibres: usize,
    total: Result<Option<Scalar>, Reported>,
    terms: Vec<(String, Place)>,
    parameters: Vec<MaterialParameter>,
    constraints: Vec<Open>,
}

/// A formula given to a parameter, while the graph it stands in grows.
pub(super) struct Open {
    name: String,
    value: Scalar,
    range: Range,
}

impl Open {
    /// The constraint on its own.
    pub(super) fn closed(self, evaluator: &Evaluator<Leaf>) -> Constraint {
        Constraint { name: self.name, value: evaluator.tape(self.value), range: self.range }
    }
}

/// A finished sum: its formula, what it is made of, the values of its parameters, formulas given to them.
pub(super) struct Whole {
    pub(super) total: Scalar,
    pub(super) terms: Vec<(String, Place)>,
    pub(super) parameters: Vec<MaterialParameter>,
    pub(super) constraints: Vec<Open>,
}

impl<'a> Sum<'a> {
    pub(super) fn new(
        scope: &'a dyn Scope<Leaf>,
        energies: &'a Energies,
        overrides: &'a Overrides,
        (material, fibres): (&'a str, usize),
        parameters: Vec<MaterialParameter>,
    ) -> Self {
        Self {
            scope,
            energies,
            overrides,
            material,
            fibres,
            total: Ok(None),
            terms: Vec::new(),
            parameters,
            constraints: Vec::new(),
        }
    }

    /// The sum, what it is made of, and the parameters.
    pub(super) fn finish(self) -> Result<Whole, Reported> {
        let total = self.total?.ok_or(Reported)?;
        Ok(Whole { total, terms: self.terms, parameters: self.parameters, constraints: self.constraints })
    }

    /// Adds an expression of the form `a(…) + b(…)`.
    pub(super) fn add(&mut self, evaluator: &mut Evaluator<Leaf>, id: ExprId) {
        let file = self.scope.file();
        match &file.tree.expr(id).kind {
            ExprKind::Binary { operator: BinaryOperator::Add, left, right, .. } => {
                self.add(evaluator, *left);
                self.add(evaluator, *right);
            }
            ExprKind::Call { function, arguments } => {
                let term = self.term(evaluator, function, arguments);
                self.total = match (self.total, term) {
                    (Ok(None), Ok(term)) => Ok(Some(term)),
                    (Ok(Some(total)), Ok(term)) => {
                        let node = evaluator.graph.add(total.node, term.node);
                        Ok(Some(Scalar { node, dimension: total.dimension }))
                    }
                    _ => Err(Reported),
                };
            }
            ExprKind::Name(name) if self.energies.contains_key(name) => {
                let message = format!("`{name}` needs its parameters");
                let help = format!("write `{name}(…)`");
                let span = file.span(id);
                evaluator.mistakes.report(file, Code::MissingArgument, span, message, "", Some(help));
                self.total = Err(Reported);
            }
            _ => {
                let required = "an energy is one or a sum of several such as `neo_hooke(mu = 10 kPa)`";
                evaluator.wrong_form(file, &file.span(id), "this", required);
                self.total = Err(Reported);
            }
        }
    }

    fn term(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        function: &Name,
        arguments: &[Argument],
    ) -> Result<Scalar, Reported> {
        let file = self.scope.file();
        let Some(energy) = self.energies.get(&function.text) else {
            let help = match nearest(&function.text, self.energies.keys().map(String::as_str)) {
                Some(meant) => Some(format!("write `{meant}`")),
                None => super::super::library::library()
                    .iter()
                    .find(|file| file.library == "energies" && file.name == function.text)
                    .map(|file| {
                        format!("write `import std.energies {{ {} }}` at the top of the file", file.name)
                    }),
            };
            let message = format!("there is no energy `{}` here", function.text);
            let span = function.span.clone();
            return Err(evaluator.mistakes.report(
                file,
                Code::UnknownName,
                span,
                message,
                "not declared",
                help,
            ));
        };
        // What is wrong with its declaration has been reported there.
        let energy = energy.clone().ok_or(Reported)?;
        let known: Vec<&str> = energy
            .parameters
            .iter()
            .map(|parameter| parameter.name.text.as_str())
            .chain(energy.directions.iter().map(|direction| direction.text.as_str()))
            .collect();
        let mut given = Arguments::read(evaluator.mistakes, file, function, arguments, &known);
        let prefix = self.prefix(&function.text);
        given.replace(&energy, self.overrides, (self.material, &prefix));
        let lacks_fibres = energy.fibres.is_some() && self.fibres == 0;
        if lacks_fibres {
            let message = format!(
                "`{}` sums over fibres, but the material `{}` has none",
                function.text, self.material
            );
            let help = "write `fibre a1 = [1, 0, 0]` with the direction that is meant";
            let span = function.span.clone();
            evaluator.mistakes.report(file, Code::NoFibres, span, message, "needs fibres", Some(help.into()));
        }
        // Mistakes of its arguments are told as well.
        let values = self.bind(evaluator, function, &energy, &given, &prefix)?;
        if lacks_fibres {
            return Err(Reported);
        }
        let scope = energy.scope(values, (0..self.fibres as u8).collect());
        self.terms.push((function.text.clone(), energy.place.clone()));
        energy.density(evaluator, &scope)
    }

    /// The values of an energy's parameters and directions.
    fn bind(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        function: &Name,
        energy: &EnergyDef,
        given: &Arguments,
        prefix: &str,
    ) -> Result<BTreeMap<String, Value>, Reported> {
        let mut values = BTreeMap::new();
        let mut sound = given.sound;
        for direction in &energy.directions {
            let value = self.direction(evaluator, function, given, direction);
            sound &= value.is_ok();
            values.extend(value.map(|value| (direction.text.clone(), value)));
        }
        for parameter in &energy.parameters {
            let name = &parameter.name.text;
            let bound = match given.get(name) {
                Some(argument) => self.argument(evaluator, energy, parameter, argument, prefix, &mut values),
                None if given.is_misspelt(name) => Err(Reported),
                None => self.default(evaluator, function, energy, parameter, prefix, &values),
            };
            sound &= bound.is_ok();
            values.extend(bound.map(|value| (parameter.name.text.clone(), value)));
        }
        if sound { Ok(values) } else { Err(Reported) }
    }

    /// `goh`, or `goh2` for the second one of a sum.
    fn prefix(&self, energy: &str) -> String {
        match self.terms.iter().filter(|(name, _)| name == energy).count() {
            0 => energy.into(),
            earlier => format!("{energy}{}", earlier + 1),
        }
    }

    fn direction(
        &self,
        evaluator: &mut Evaluator<Leaf>,
        function: &Name,
        given: &Arguments,
        direction: &Name,
    ) -> Result<Value, Reported> {
        let file = self.scope.file();
        if given.is_misspelt(&direction.text) {
            return Err(Reported);
        }
        let Some(argument) = given.get(&direction.text) else {
            let message = format!("`{}` needs the direction `{}`", function.text, direction.text);
            let help = format!("write `{} = ` and the name of a fibre of the material", direction.text);
            let span = function.span.clone();
            return Err(evaluator.mistakes.report(
                file,
                Code::MissingArgument,
                span,
                message,
                "",
                Some(help),
            ));
        };
        match evaluator.evaluate(self.scope, argument.site.id)? {
            value @ Value::Direction(_) => Ok(value),
            other => {
                let required =
                    format!("`{}` is a direction, the name of a fibre is required", direction.text);
                Err(evaluator.wrong_form(file, &file.span(argument.site.id), &other.describe(), &required))
            }
        }
    }

    fn argument(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        energy: &EnergyDef,
        parameter: &ParameterDef,
        argument: &Given,
        prefix: &str,
        values: &mut BTreeMap<String, Value>,
    ) -> Result<Value, Reported> {
        let (file, id) = (Rc::clone(&argument.site.file), argument.site.id);
        let name = format!("{prefix}.{}", parameter.name.text);
        let Some(count) = &parameter.count else {
            return self.one(evaluator, energy, parameter, (&file, id), name);
        };
        let ExprKind::List(ids) = &file.tree.expr(id).kind else {
            let required =
                format!("`{}` is an array, a list such as `[1, 2]` is required", parameter.name.text);
            return Err(evaluator.wrong_form(&file, &file.span(id), "this", &required));
        };
        let length = ids.len() as f64;
        let counted = values.get(&count.text).and_then(Value::as_scalar);
        if let Some(known) = counted.and_then(|scalar| evaluator.graph.number(scalar.node))
            && known != length
        {
            let message = format!(
                "`{}` must have {known} elements as the other arrays of length `{}`, but it has {length}",
                parameter.name.text, count.text
            );
            let span = file.span(id);
            return Err(evaluator.mistakes.report(&file, Code::WrongForm, span, message, "", None));
        }
        let node = evaluator.graph.constant(length);
        values.insert(count.text.clone(), Value::scalar(node, Dimension::NUMBER));
        let elements = ids.iter().enumerate().map(|(index, id)| {
            self.one(evaluator, energy, parameter, (&file, *id), format!("{name}[{}]", index + 1))
        });
        let elements: Vec<Result<Value, Reported>> = elements.collect();
        Ok(Value::List(elements.into_iter().collect::<Result<_, _>>()?))
    }

    /// One number: a parameter of its own if it is written as one, else the formula as given.
    fn one(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        energy: &EnergyDef,
        parameter: &ParameterDef,
        (file, id): (&Rc<File>, ExprId),
        name: String,
    ) -> Result<Value, Reported> {
        let required = Required { name: &parameter.name.text, dimension: parameter.dimension };
        let scope = Elsewhere { outer: self.scope, file: Rc::clone(file) };
        let scalar = evaluator.quantity(&scope, id, required)?;
        let Some(value) = evaluator.known(scalar) else {
            let message = format!("`{}` must be a number", parameter.name.text);
            return Err(evaluator.mistakes.report(file, Code::WrongForm, file.span(id), message, "", None));
        };
        let home = energy.scope(BTreeMap::new(), vec![]);
        within::check(evaluator, &home, parameter, value, file, file.span(id))?;
        let range = within::range(evaluator, &home, parameter)?;
        Ok(match evaluator.graph.number(scalar.node) {
            Some(_) => self.own(evaluator, parameter, name, (value, range)),
            None => {
                self.constraints.push(Open { name, value: scalar, range });
                Value::Scalar(scalar)
            }
        })
    }

    fn own(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        parameter: &ParameterDef,
        name: String,
        (value, range): (f64, Range),
    ) -> Value {
        let leaf = Leaf::Parameter(self.parameters.len() as u32);
        let unit = parameter.dimension.si_symbol();
        self.parameters.push(MaterialParameter { name, value, unit, range, turns_direction: false });
        evaluator.parameters.push(value);
        Value::scalar(evaluator.graph.leaf(leaf), parameter.dimension)
    }

    fn default(
        &mut self,
        evaluator: &mut Evaluator<Leaf>,
        function: &Name,
        energy: &EnergyDef,
        parameter: &ParameterDef,
        prefix: &str,
        values: &BTreeMap<String, Value>,
    ) -> Result<Value, Reported> {
        let name = &parameter.name.text;
        if let Some(default) = parameter.default {
            let home = energy.scope(values.clone(), vec![]);
            let required = Required { name, dimension: parameter.dimension };
            let scalar = evaluator.quantity(&home, default, required)?;
            let range = within::range(evaluator, &home, parameter)?;
            return Ok(match evaluator.graph.number(scalar.node) {
                Some(value) => self.own(evaluator, parameter, format!("{prefix}.{name}"), (value, range)),
                None => Value::Scalar(scalar),
            });
        }
        let file = self.scope.file();
        let range = parameter.bounds.as_ref().map_or("", |bounds| energy.file.text(&bounds.span)).trim();
        let kind = [parameter.written.as_str(), range].join(" ");
        let message = format!("`{}` needs `{name}` ({})", function.text, kind.trim());
        let doc = parameter.doc.join(" ");
        let help = match doc.as_str() {
            "" => format!(
                "write `{name} = {}` with the value that is meant",
                example_with_unit("1", parameter.dimension)
            ),
            doc => format!("`{name}`: {doc}"),
        };
        let span = function.span.clone();
        Err(evaluator.mistakes.report(file, Code::MissingArgument, span, message, "", Some(help)))
    }
}
