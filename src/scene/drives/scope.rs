//! The names in a path: `let`s, directions, and the parameter where the formula may depend on it.

use super::super::evaluate::{Evaluator, Leaves, Lets, Outcome, Scope, Value};
use super::super::file::File;
use super::super::model::PathParameter;
use crate::schema::nearest;
use crate::syntax::{Argument, Name};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

impl Leaves for PathParameter {}

/// The names in a path.
pub(super) struct PathScope<'a> {
    pub(super) file: &'a Rc<File>,
    pub(super) lets: Lets,
    /// Directions by name.
    pub(super) directions: &'a BTreeMap<String, [f64; 3]>,
    /// The parameter and its dimension, where it is one of the names.
    pub(super) parameter: Option<(&'a str, Dimension)>,
}

impl Scope<PathParameter> for PathScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<PathParameter>, name: &Name) -> Option<Outcome> {
        if let Some((_, dimension)) = self.parameter.filter(|(parameter, _)| *parameter == name.text) {
            return Some(Ok(Value::scalar(evaluator.graph.leaf(PathParameter), dimension)));
        }
        if let Some(outcome) = self.lets.name(evaluator, self, name) {
            return Some(outcome);
        }
        let components = self.directions.get(&name.text)?;
        let number = |value: f64| Value::scalar(evaluator.graph.constant(value), Dimension::NUMBER);
        Some(Ok(Value::List(components.map(number).into())))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<PathParameter>,
        outer: &dyn Scope<PathParameter>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        self.lets.call(evaluator, self, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        let lets = self.lets.names().map(|definition| definition.name.text.clone());
        let parameter = self.parameter.iter().map(|(name, _)| (*name).to_string());
        lets.chain(self.directions.keys().cloned()).chain(parameter).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        if matches!(name, "X" | "Y" | "Z" | "t") {
            return Some("a drive has neither place nor time: it has the parameter of its path".into());
        }
        let known: Vec<&str> = self.directions.keys().map(String::as_str).collect();
        // Where the parameter is a name, a formula is read; elsewhere it may be a direction.
        (self.parameter.is_none() && nearest(name, known.iter().copied()).is_none())
            .then(|| format!("the directions here are {}", known.join(", ")))
    }
}
