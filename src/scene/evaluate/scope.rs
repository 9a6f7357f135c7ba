//! What names mean where an expression stands.

use super::super::file::{File, Reported};
use super::{Evaluator, Leaves, Outcome, Value};
use crate::syntax::{Argument, ExprId, Name, Span};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The names an expression may use.
pub(in crate::scene) trait Scope<L: Leaves> {
    /// The file the expression stands in.
    fn file(&self) -> &Rc<File>;

    /// The value of a name; `None` if it has none here.
    fn name(&self, evaluator: &mut Evaluator<L>, name: &Name) -> Option<Outcome>;

    /// The value of `base.name`; `None` if it has no meaning of its own here.
    fn member(
        &self,
        _evaluator: &mut Evaluator<L>,
        _base: ExprId,
        _name: &Name,
        _span: &Span,
    ) -> Option<Outcome> {
        None
    }

    /// The value of a call; `None` if the function is none of this scope's.
    ///
    /// `outer` is the scope the arguments stand in: this one, or one with bound names around it.
    fn call(
        &self,
        _evaluator: &mut Evaluator<L>,
        _outer: &dyn Scope<L>,
        _function: &Name,
        _arguments: &[Argument],
    ) -> Option<Outcome> {
        None
    }

    /// The names there are, for "did you mean".
    fn names(&self) -> Vec<String>;

    /// The functions there are beside those known everywhere.
    fn functions(&self) -> Vec<String> {
        Vec::new()
    }

    /// Where to find out more: the context named in the help of an unknown name.
    fn hint(&self, _name: &str) -> Option<String> {
        None
    }
}

/// A scope with one more name.
pub(in crate::scene) struct Local<'a, L> {
    pub(in crate::scene) outer: &'a dyn Scope<L>,
    pub(in crate::scene) name: &'a str,
    pub(in crate::scene) value: Value,
}

impl<L: Leaves> Scope<L> for Local<'_, L> {
    fn file(&self) -> &Rc<File> {
        self.outer.file()
    }

    fn name(&self, evaluator: &mut Evaluator<L>, name: &Name) -> Option<Outcome> {
        if name.text == self.name { Some(Ok(self.value.clone())) } else { self.outer.name(evaluator, name) }
    }

    fn member(
        &self,
        evaluator: &mut Evaluator<L>,
        base: ExprId,
        name: &Name,
        span: &Span,
    ) -> Option<Outcome> {
        self.outer.member(evaluator, base, name, span)
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<L>,
        outer: &dyn Scope<L>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        self.outer.call(evaluator, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        let mut names = self.outer.names();
        names.push(self.name.into());
        names
    }

    fn functions(&self) -> Vec<String> {
        self.outer.functions()
    }

    fn hint(&self, name: &str) -> Option<String> {
        self.outer.hint(name)
    }
}

/// A scope whose names are used in an expression of another file: a value given on the command line.
pub(in crate::scene) struct Elsewhere<'a, L> {
    pub(in crate::scene) outer: &'a dyn Scope<L>,
    pub(in crate::scene) file: Rc<File>,
}

impl<L: Leaves> Scope<L> for Elsewhere<'_, L> {
    fn file(&self) -> &Rc<File> {
        &self.file
    }

    fn name(&self, evaluator: &mut Evaluator<L>, name: &Name) -> Option<Outcome> {
        self.outer.name(evaluator, name)
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<L>,
        outer: &dyn Scope<L>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        self.outer.call(evaluator, outer, function, arguments)
    }

    fn names(&self) -> Vec<String> {
        self.outer.names()
    }

    fn functions(&self) -> Vec<String> {
        self.outer.functions()
    }

    fn hint(&self, name: &str) -> Option<String> {
        self.outer.hint(name)
    }
}

/// One `let`: its formal arguments and its expression.
#[derive(Debug, Clone)]
pub(in crate::scene) struct Let {
    pub(in crate::scene) name: Name,
    pub(in crate::scene) arguments: Vec<Name>,
    pub(in crate::scene) value: ExprId,
}

/// The `let`s of a block, each evaluated at most once per formula.
///
/// The results belong to one evaluator, so every evaluator needs its own clone.
#[derive(Debug, Default)]
pub(in crate::scene) struct Lets {
    lets: Rc<BTreeMap<String, Let>>,
    known: RefCell<BTreeMap<String, Option<Outcome>>>,
}

impl Lets {
    pub(in crate::scene) fn new(lets: BTreeMap<String, Let>) -> Self {
        Self { lets: Rc::new(lets), known: RefCell::default() }
    }

    /// The same definitions with nothing evaluated yet.
    pub(in crate::scene) fn fresh(&self) -> Self {
        Self { lets: Rc::clone(&self.lets), known: RefCell::default() }
    }

    pub(in crate::scene) fn names(&self) -> impl Iterator<Item = &Let> {
        self.lets.values()
    }

    /// The value of a `let` without arguments, evaluated in `scope`, the scope it is declared in.
    pub(in crate::scene) fn name<L: Leaves>(
        &self,
        evaluator: &mut Evaluator<L>,
        scope: &dyn Scope<L>,
        name: &Name,
    ) -> Option<Outcome> {
        let definition = self.lets.get(&name.text).filter(|definition| definition.arguments.is_empty())?;
        let known = self.known.borrow().get(&name.text).cloned();
        let outcome = match known {
            Some(Some(outcome)) => outcome,
            // Being evaluated: it is defined by itself.
            Some(None) => Err(evaluator.circular(scope, definition)),
            None => {
                self.known.borrow_mut().insert(name.text.clone(), None);
                let outcome = evaluator.evaluate(scope, definition.value);
                self.known.borrow_mut().insert(name.text.clone(), Some(outcome.clone()));
                outcome
            }
        };
        Some(outcome)
    }

    /// The value of a `let` with arguments: `scope` is the one it is declared in, `outer` the caller's.
    pub(in crate::scene) fn call<L: Leaves>(
        &self,
        evaluator: &mut Evaluator<L>,
        scope: &dyn Scope<L>,
        outer: &dyn Scope<L>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        let definition =
            self.lets.get(&function.text).filter(|definition| !definition.arguments.is_empty())?;
        Some(self.apply(evaluator, scope, outer, definition, function, arguments))
    }

    fn apply<L: Leaves>(
        &self,
        evaluator: &mut Evaluator<L>,
        scope: &dyn Scope<L>,
        outer: &dyn Scope<L>,
        definition: &Let,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let values: Vec<Outcome> =
            arguments.iter().map(|argument| evaluator.evaluate(outer, argument.value)).collect();
        let values: Vec<Value> = values.into_iter().collect::<Result<_, Reported>>()?;
        if values.len() != definition.arguments.len() {
            return Err(evaluator.wrong_count(outer, function, definition.arguments.len(), values.len()));
        }
        bind(evaluator, scope, &definition.arguments, &values, definition.value)
    }
}

/// Evaluates a body with names bound to values, one scope inside the other.
fn bind<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    scope: &dyn Scope<L>,
    names: &[Name],
    values: &[Value],
    body: ExprId,
) -> Outcome {
    match (names.split_first(), values.split_first()) {
        (Some((name, names)), Some((value, values))) => {
            let local = Local { outer: scope, name: &name.text, value: value.clone() };
            bind(evaluator, &local, names, values, body)
        }
        _ => evaluator.evaluate(scope, body),
    }
}
