//! The names in a scene.

use super::super::evaluate::{Evaluator, Lets, Outcome, Scope, place_word};
use super::super::file::{File, Mistakes, Reported};
use super::super::model::Coordinate;
use super::tables::Tables;
use crate::syntax::{Argument, ExprId, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// The names in a scene: its `let`s, and place and time where they mean something.
pub(super) struct SceneScope<'a> {
    pub(super) file: &'a Rc<File>,
    pub(super) lets: Lets,
    pub(super) tables: &'a Tables,
    pub(super) place: bool,
    pub(super) time: bool,
}

impl Scope<Coordinate> for SceneScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<Coordinate>, name: &Name) -> Option<Outcome> {
        if self.tables.get(&name.text).is_some_and(Option::is_none) {
            return Some(Err(Reported));
        }
        let outcome = self.lets.name(evaluator, self, name);
        outcome.or_else(|| place_word(evaluator, &name.text, self.place, self.time))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Coordinate>,
        outer: &dyn Scope<Coordinate>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        match function.text.as_str() {
            "ramp" if self.time => Some(super::loads::ramp(evaluator, outer, function, arguments)),
            "table" if self.time => {
                Some(super::timetable::table(evaluator, outer, self.tables, function, arguments))
            }
            _ => None,
        }
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> =
            self.lets.names().map(|definition| definition.name.text.clone()).collect();
        if self.place {
            names.extend(["X", "Y", "Z", "r"].map(String::from));
        }
        if self.time {
            names.push("t".into());
        }
        names
    }

    fn functions(&self) -> Vec<String> {
        if self.time { vec!["ramp".into(), "table".into()] } else { vec![] }
    }

    fn hint(&self, name: &str) -> Option<String> {
        if self.tables.contains_key(name) {
            return Some(format!("`{name}` is a table: its columns stand in `plot`, `expect` and `table`"));
        }
        match name {
            "x" | "y" | "z" if self.place => {
                Some(format!("write `{}` for the reference coordinate", name.to_uppercase()))
            }
            "t" => Some("this value cannot depend on time".into()),
            "X" | "Y" | "Z" | "r" => Some("this value cannot depend on place".into()),
            _ => None,
        }
    }
}

/// The fixed quantity an expression is by itself, if it is one; nothing is reported.
pub(in crate::scene) fn fixed_quantity(file: &Rc<File>, id: ExprId) -> Option<(f64, Dimension)> {
    let mut silent = Mistakes::default();
    let tables = Tables::new();
    let scope = SceneScope { file, lets: Lets::default(), tables: &tables, place: false, time: false };
    let mut evaluator = Evaluator::<Coordinate>::new(&mut silent);
    let scalar = evaluator.scalar(&scope, id).ok()?;
    let value = evaluator.known(scalar).filter(|value| value.is_finite())?;
    Some((value, scalar.dimension))
}
