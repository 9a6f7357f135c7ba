//! Functions known in every expression.

use super::super::file::Reported;
use super::super::words::FUNCTIONS;
use super::arithmetic::Parts;
use super::read::read_as_unit;
use super::{Evaluator, Leaves, Local, Outcome, Scalar, Scope, Value};
use crate::expression::{Comparison, Function};
use crate::schema::nearest;
use crate::syntax::{Argument, BinaryOperator, Code, ExprId, ExprKind, Name};
use crate::unit::Dimension;
use std::rc::Rc;

impl<L: Leaves> Evaluator<'_, L> {
    pub(super) fn function(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let file = Rc::clone(scope.file());
        if let Some(named) = arguments.iter().find_map(|argument| argument.name.as_ref()) {
            let known = FUNCTIONS.iter().any(|word| word.word == function.text);
            if known {
                let span = named.parts[0].span.clone();
                return Err(self.wrong_form(
                    &file,
                    &span,
                    "a name",
                    &format!("`{}` takes plain arguments", function.text),
                ));
            }
        }
        let ids: Vec<ExprId> = arguments.iter().map(|argument| argument.value).collect();
        match (function.text.as_str(), ids.as_slice()) {
            ("exp", &[x]) => self.of_number(scope, function, Function::Exp, x),
            ("ln", &[x]) => self.of_number(scope, function, Function::Ln, x),
            ("sin", &[x]) => self.of_number(scope, function, Function::Sin, x),
            ("cos", &[x]) => self.of_number(scope, function, Function::Cos, x),
            ("tan", &[x]) => self.of_number(scope, function, Function::Tan, x),
            ("tanh", &[x]) => self.of_number(scope, function, Function::Tanh, x),
            ("cosh", &[x]) => self.of_number(scope, function, Function::Cosh, x),
            ("erf", &[x]) => self.of_number(scope, function, Function::Erf, x),
            ("sqrt", &[x]) => self.of_any(scope, Function::Sqrt, x, Dimension::sqrt),
            ("cbrt", &[x]) => self.of_any(scope, Function::Cbrt, x, Dimension::cbrt),
            ("abs", &[x]) => self.of_any(scope, Function::Abs, x, |d| d),
            ("pos", &[x]) => self.of_any(scope, Function::Pos, x, |d| d),
            ("min" | "max", &[a, b]) => self.extreme(scope, function, a, b),
            ("if", &[condition, then, otherwise]) => self.choice(scope, function, condition, then, otherwise),
            ("sum", &[binder, body]) => self.sum(scope, binder, body),
            ("norm", &[x]) => {
                let vector = self.vector(scope, x)?;
                self.length(&vector).map(Value::Scalar).ok_or(Reported)
            }
            ("unit", &[x]) => self.unit_vector(scope, x),
            ("tilt", &[a, b, angle]) => self.tilt(scope, a, b, angle),
            (name, _) => match FUNCTIONS.iter().find(|word| word.word == name && word.form.contains('(')) {
                Some(word) => {
                    let message =
                        format!("`{name}` is written `{}`, but {} arguments are given", word.form, ids.len());
                    Err(self.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", None))
                }
                None => Err(self.unknown_function(scope, function)),
            },
        }
    }

    fn unknown_function(&mut self, scope: &dyn Scope<L>, function: &Name) -> Reported {
        let file = Rc::clone(scope.file());
        let own = scope.functions();
        let everywhere = FUNCTIONS.iter().filter(|word| word.form.contains('(')).map(|word| word.word);
        let meant = nearest(&function.text, own.iter().map(String::as_str).chain(everywhere));
        let help = meant.map(|meant| format!("write `{meant}(…)`"));
        let message = format!("there is no function `{}` here", function.text);
        self.mistakes.report(
            &file,
            Code::UnknownFunction,
            function.span.clone(),
            message,
            "not declared",
            help,
        )
    }

    fn of_number(&mut self, scope: &dyn Scope<L>, name: &Name, function: Function, id: ExprId) -> Outcome {
        let x = self.scalar(scope, id)?;
        if !x.dimension.is_number() {
            let file = Rc::clone(scope.file());
            let found = x.dimension.describe();
            let message = format!("`{}` takes a number, but its argument is {found}", name.text);
            let help = read_as_unit(&file, id);
            return Err(self.mistakes.report(&file, Code::NotANumber, file.span(id), message, found, help));
        }
        Ok(Value::scalar(self.graph.call(function, x.node), Dimension::NUMBER))
    }

    fn of_any(
        &mut self,
        scope: &dyn Scope<L>,
        function: Function,
        id: ExprId,
        dimension: impl Fn(Dimension) -> Dimension,
    ) -> Outcome {
        let x = self.scalar(scope, id)?;
        Ok(Value::scalar(self.graph.call(function, x.node), dimension(x.dimension)))
    }

    fn extreme(&mut self, scope: &dyn Scope<L>, function: &Name, left: ExprId, right: ExprId) -> Outcome {
        let (a, b) = (self.scalar(scope, left), self.scalar(scope, right));
        let (a, b) = (a?, b?);
        let operator = if function.text == "min" { BinaryOperator::Less } else { BinaryOperator::Greater };
        self.same(scope, &Parts { operator, at: &function.span, left, right }, a.dimension, b.dimension)?;
        let node = if function.text == "min" {
            self.graph.min(a.node, b.node)
        } else {
            self.graph.max(a.node, b.node)
        };
        Ok(Value::scalar(node, a.dimension))
    }

    fn choice(
        &mut self,
        scope: &dyn Scope<L>,
        function: &Name,
        condition: ExprId,
        then: ExprId,
        otherwise: ExprId,
    ) -> Outcome {
        let condition = self.comparison(scope, condition);
        let (a, b) = (self.evaluate(scope, then), self.evaluate(scope, otherwise));
        let (left, comparison, right) = condition?;
        let parts =
            Parts { operator: BinaryOperator::Equal, at: &function.span, left: then, right: otherwise };
        self.select(scope, &parts, (left, comparison, right), &a?, &b?)
    }

    fn select(
        &mut self,
        scope: &dyn Scope<L>,
        parts: &Parts,
        condition: (Scalar, Comparison, Scalar),
        a: &Value,
        b: &Value,
    ) -> Outcome {
        match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                self.same(scope, parts, a.dimension, b.dimension)?;
                let (left, comparison, right) = condition;
                let node = self.graph.select((left.node, comparison, right.node), a.node, b.node);
                Ok(Value::scalar(node, a.dimension))
            }
            (Value::List(a), Value::List(b)) if a.len() == b.len() => {
                let values = a.iter().zip(b).map(|(a, b)| self.select(scope, parts, condition, a, b));
                Ok(Value::List(values.collect::<Result<_, _>>()?))
            }
            _ => {
                let file = Rc::clone(scope.file());
                let found = format!("`if` between {} and {}", a.describe(), b.describe());
                Err(self.wrong_form(&file, parts.at, &found, "both must be alike"))
            }
        }
    }

    fn sum(&mut self, scope: &dyn Scope<L>, binder: ExprId, body: ExprId) -> Outcome {
        let file = Rc::clone(scope.file());
        let ExprKind::Binder { name, over } = &file.tree.expr(binder).kind else {
            let required = "the first argument of `sum` binds a name: `i in 1 .. n` or `a in fibres`";
            return Err(self.wrong_form(&file, &file.span(binder), "this", required));
        };
        let Value::List(values) = self.evaluate(scope, *over)? else {
            return Err(self.wrong_form(
                &file,
                &file.span(*over),
                "a single value",
                "a range or a list is required",
            ));
        };
        let mut total: Option<Scalar> = None;
        for value in values {
            let local = Local { outer: scope, name: &name.text, value };
            let term = self.scalar(&local, body)?;
            total = Some(match total {
                None => term,
                Some(sum) => {
                    let parts = Parts {
                        operator: BinaryOperator::Add,
                        at: &file.span(body),
                        left: body,
                        right: body,
                    };
                    self.same(scope, &parts, sum.dimension, term.dimension)?;
                    Scalar { node: self.graph.add(sum.node, term.node), dimension: sum.dimension }
                }
            });
        }
        match total {
            Some(total) => Ok(Value::Scalar(total)),
            None => Err(self.wrong_form(
                &file,
                &file.span(*over),
                "an empty range",
                "a sum has at least one term",
            )),
        }
    }

    /// Three components of one dimension.
    pub(in crate::scene) fn vector(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
    ) -> Result<[Scalar; 3], Reported> {
        let value = self.evaluate(scope, id)?;
        if let Value::List(values) = &value
            && let [Value::Scalar(a), Value::Scalar(b), Value::Scalar(c)] = values.as_slice()
            && a.dimension == b.dimension
            && b.dimension == c.dimension
        {
            return Ok([*a, *b, *c]);
        }
        let file = Rc::clone(scope.file());
        let found = value.describe();
        Err(self.wrong_form(
            &file,
            &file.span(id),
            &found,
            "three components of one dimension are required: `[a, b, c]`",
        ))
    }

    fn length(&mut self, vector: &[Scalar; 3]) -> Option<Scalar> {
        let two = self.graph.constant(2.0);
        let mut total = None;
        for component in vector {
            let square = self.graph.power(component.node, two);
            total = Some(match total {
                None => square,
                Some(sum) => self.graph.add(sum, square),
            });
        }
        let node = self.graph.call(Function::Sqrt, total?);
        Some(Scalar { node, dimension: vector[0].dimension })
    }

    fn unit_vector(&mut self, scope: &dyn Scope<L>, id: ExprId) -> Outcome {
        let vector = self.vector(scope, id)?;
        let length = self.length(&vector).ok_or(Reported)?;
        if self.graph.number(length.node) == Some(0.0) {
            let file = Rc::clone(scope.file());
            return Err(self.wrong_form(
                &file,
                &file.span(id),
                "a vector of length 0",
                "it has no direction",
            ));
        }
        let components =
            vector.map(|c| Value::scalar(self.graph.divide(c.node, length.node), Dimension::NUMBER));
        Ok(Value::List(components.into()))
    }

    fn tilt(&mut self, scope: &dyn Scope<L>, a: ExprId, b: ExprId, angle: ExprId) -> Outcome {
        let (first, second) = (self.vector(scope, a), self.vector(scope, b));
        let turn = self.scalar(scope, angle);
        let (first, second, turn) = (first?, second?, turn?);
        let file = Rc::clone(scope.file());
        if !turn.dimension.is_number() {
            let found = turn.dimension.describe();
            let message = format!("`tilt` takes an angle, but this is {found}");
            return Err(self.mistakes.report(
                &file,
                Code::NotANumber,
                file.span(angle),
                message,
                found,
                None,
            ));
        }
        let (cos, sin) =
            (self.graph.call(Function::Cos, turn.node), self.graph.call(Function::Sin, turn.node));
        let mut components = Vec::with_capacity(3);
        for (u, v) in first.iter().zip(&second) {
            let parts = Parts { operator: BinaryOperator::Add, at: &file.span(b), left: a, right: b };
            self.same(scope, &parts, u.dimension, v.dimension)?;
            let (along, across) = (self.graph.multiply(cos, u.node), self.graph.multiply(sin, v.node));
            components.push(Value::scalar(self.graph.add(along, across), u.dimension));
        }
        Ok(Value::List(components))
    }
}
