//! Arguments of a shape by name.

use super::super::evaluate::{Evaluator, Required, Scope};
use super::super::file::Reported;
use super::super::model::Coordinate;
use super::shapes::form;
use crate::schema::nearest;
use crate::syntax::{Argument, Code, ExprId, ExprKind, Name, Span};
use crate::tensor::Vec3;
use crate::unit::{Dimension, Quantity};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The arguments of one call of a shape.
pub(super) struct Dimensions<'e, 'm, 's> {
    evaluator: &'e mut Evaluator<'m, Coordinate>,
    scope: &'s dyn Scope<Coordinate>,
    function: &'s Name,
    given: BTreeMap<&'static str, ExprId>,
}

impl<'e, 'm, 's> Dimensions<'e, 'm, 's> {
    /// Reads arguments given by name, or in the order of `names`.
    pub(super) fn read(
        evaluator: &'e mut Evaluator<'m, Coordinate>,
        scope: &'s dyn Scope<Coordinate>,
        function: &'s Name,
        arguments: &[Argument],
        names: &'static [&'static str],
    ) -> Result<Self, Reported> {
        let file = Rc::clone(scope.file());
        let mut given = BTreeMap::new();
        for (index, argument) in arguments.iter().enumerate() {
            let (known, span) = match argument.name.as_ref().map(|path| &path.parts[0]) {
                Some(name) => (names.iter().find(|known| **known == name.text), name.span.clone()),
                None => (names.get(index), file.span(argument.value)),
            };
            let Some(known) = known else {
                let written = file.text(&span);
                let message = format!("`{}` has no argument `{written}`", function.text);
                let help = match nearest(written, names.iter().copied()) {
                    Some(meant) => format!("write `{meant}`"),
                    None => format!("its arguments are {}", names.join(", ")),
                };
                let code = Code::UnknownArgument;
                return Err(evaluator.mistakes.report(&file, code, span, message, "", Some(help)));
            };
            if given.insert(*known, argument.value).is_some() {
                let message = format!("`{known}` of `{}` is given twice", function.text);
                return Err(evaluator.mistakes.report(
                    &file,
                    Code::DuplicateName,
                    span,
                    message,
                    "here again",
                    None,
                ));
            }
        }
        Ok(Self { evaluator, scope, function, given })
    }

    /// The expression of an argument that must be given.
    pub(super) fn required(&mut self, name: &str) -> Result<ExprId, Reported> {
        self.given.get(name).copied().ok_or_else(|| {
            let file = Rc::clone(self.scope.file());
            let message = format!("`{}` needs `{name}`", self.function.text);
            let help = Some(format!("write `{}`", form(&self.function.text)));
            let span = self.function.span.clone();
            self.evaluator.mistakes.report(&file, Code::MissingArgument, span, message, "", help)
        })
    }

    /// Whether an argument is given.
    pub(super) fn has(&self, name: &str) -> bool {
        self.given.contains_key(name)
    }

    /// A text in quotes that must be given, and where it stands.
    pub(super) fn text(&mut self, name: &'static str) -> Result<(String, ExprId), Reported> {
        let id = self.required(name)?;
        let file = Rc::clone(self.scope.file());
        if let ExprKind::Text(text) = &file.tree.expr(id).kind {
            return Ok((text.clone(), id));
        }
        let message = format!("`{name}` is a text in quotes");
        let help = Some(format!("write `{}`", form(&self.function.text)));
        Err(self.evaluator.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", help))
    }

    /// A length greater than 0.
    pub(super) fn length(&mut self, name: &'static str, default: Option<f64>) -> Result<f64, Reported> {
        if let (None, Some(value)) = (self.given.get(name), default) {
            return Ok(value);
        }
        let id = self.required(name)?;
        let value = self.constant(id, name, Dimension::LENGTH)?;
        if value > 0.0 { Ok(value) } else { Err(self.outside(id, name, "> 0", value, Dimension::LENGTH)) }
    }

    /// A length that may be 0, and is unless it is given.
    pub(super) fn length_or_zero(&mut self, name: &'static str) -> Result<f64, Reported> {
        let Some(&id) = self.given.get(name) else { return Ok(0.0) };
        let value = self.constant(id, name, Dimension::LENGTH)?;
        if value >= 0.0 { Ok(value) } else { Err(self.outside(id, name, ">= 0", value, Dimension::LENGTH)) }
    }

    /// A whole number from 1 to 1000.
    pub(super) fn count(&mut self, name: &'static str) -> Result<usize, Reported> {
        let id = self.required(name)?;
        let value = self.constant(id, name, Dimension::NUMBER)?;
        if value.fract() == 0.0 && (1.0..=1000.0).contains(&value) {
            return Ok(value as usize);
        }
        Err(self.outside(id, name, "a whole number from 1 to 1000", value, Dimension::NUMBER))
    }

    /// An angle, rad.
    pub(super) fn angle(&mut self, name: &'static str) -> Result<Option<f64>, Reported> {
        let Some(&id) = self.given.get(name) else { return Ok(None) };
        self.constant(id, name, Dimension::NUMBER).map(Some)
    }

    /// A point, m.
    pub(super) fn point(&mut self, name: &'static str) -> Result<Option<Vec3>, Reported> {
        let Some(&id) = self.given.get(name) else { return Ok(None) };
        let required = Required { name, dimension: Dimension::LENGTH };
        self.evaluator.constant_vector(self.scope, id, required).map(|point| Some(point.into()))
    }

    /// The index of one of several words.
    pub(super) fn choice(
        &mut self,
        name: &'static str,
        words: &[&'static str],
    ) -> Result<Option<usize>, Reported> {
        let Some(&id) = self.given.get(name) else { return Ok(None) };
        let file = Rc::clone(self.scope.file());
        let written = file.expression(id);
        let found = words.iter().position(|word| *word == written);
        let is_name = matches!(&file.tree.expr(id).kind, ExprKind::Name(_));
        if let (Some(found), true) = (found, is_name) {
            return Ok(Some(found));
        }
        let message = format!("`{name}` cannot be `{written}`");
        let help = match nearest(written, words.iter().copied()) {
            Some(meant) => format!("write `{meant}`"),
            None => format!("write one of {}", words.join(", ")),
        };
        let span = file.span(id);
        Err(self.evaluator.mistakes.report(&file, Code::UnknownName, span, message, "", Some(help)))
    }

    fn constant(&mut self, id: ExprId, name: &'static str, dimension: Dimension) -> Result<f64, Reported> {
        self.evaluator.constant(self.scope, id, Required { name, dimension })
    }

    fn outside(&mut self, id: ExprId, name: &str, must: &str, value: f64, dimension: Dimension) -> Reported {
        let file = Rc::clone(self.scope.file());
        let found = Quantity::new(value, dimension);
        let message = format!("`{name}` must be {must}, but the value is {found}");
        let span: Span = file.span(id);
        self.evaluator.mistakes.report(&file, Code::ParameterOutOfRange, span, message, "outside", None)
    }
}
