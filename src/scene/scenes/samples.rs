//! What an expectation can ask of the tables.

use super::super::evaluate::{Evaluator, Lets, Outcome, Scope, Value};
use super::super::file::{File, Reported};
use super::super::model::{Reduction, Sample};
use super::super::words::SAMPLES;
use super::motions::RESIDUAL;
use super::plots::{ColumnName, column_dimension, column_name, table_dimension};
use super::records::TIME;
use super::stage::Records;
use super::tables::Tables;
use crate::syntax::{Argument, Code, ExprId, ExprKind, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The names in an expectation.
pub(super) struct SampleScope<'a> {
    pub(super) file: &'a Rc<File>,
    pub(super) lets: Lets,
    pub(super) records: &'a Records,
    pub(super) tables: &'a Tables,
    /// Columns of the varied values, in a sweep.
    pub(super) varied: &'a [String],
    /// What a fit finds, by name.
    pub(super) fitted: &'a BTreeMap<String, Dimension>,
}

/// Table of a fit's values, one row.
pub const FITTED: &str = "fitted";
/// Table of their standard errors, one row.
pub const ERRORS: &str = "standard errors";

impl Scope<Sample> for SampleScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<Sample>, name: &Name) -> Option<Outcome> {
        self.lets.name(evaluator, self, name).or_else(|| self.fitted(evaluator, FITTED, &name.text).map(Ok))
    }

    fn member(
        &self,
        evaluator: &mut Evaluator<Sample>,
        base: ExprId,
        name: &Name,
        span: &Span,
    ) -> Option<Outcome> {
        if let Some(value) = self.fitted(evaluator, FITTED, self.file.text(span)) {
            return Some(Ok(value));
        }
        if !self.fitted.is_empty() {
            // a part of a longer name: `media` of `media.goh.k1`
            let message = format!("the fit does not vary `{}`", self.file.text(span));
            let mut known: Vec<&str> = self.fitted.keys().map(String::as_str).collect();
            // parameters first, then the numbers every fit has
            known.sort_by_key(|name| !name.contains('.'));
            let help = Some(format!("what it finds is {}", known.join(", ")));
            let file = self.file;
            return Some(Err(evaluator.mistakes.report(
                file,
                Code::UnknownName,
                span.clone(),
                message,
                "",
                help,
            )));
        }
        let ExprKind::Name(table) = &self.file.tree.expr(base).kind else { return None };
        let column = ColumnName {
            table: Name { text: table.clone(), span: self.file.span(base) },
            column: name.clone(),
        };
        Some(self.column(evaluator, &column))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Sample>,
        outer: &dyn Scope<Sample>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        let [argument] = arguments else { return None };
        if function.text == "error" && !self.fitted.is_empty() {
            let written = self.file.expression(argument.value);
            return Some(match self.fitted(evaluator, ERRORS, written) {
                Some(value) if written.contains('.') => Ok(value),
                _ => {
                    let required = "`error` takes a parameter the fit varies";
                    Err(evaluator.wrong_form(self.file, &self.file.span(argument.value), "this", required))
                }
            });
        }
        match function.text.as_str() {
            "residual" => return Some(self.residual(evaluator, argument.value)),
            "order" | "least_order" if !self.varied.is_empty() => {
                return Some(self.order(evaluator, function.text == "least_order", argument.value));
            }
            "never_grows" => {
                let required = "it is a claim of its own: `expect never_grows(record.column)`";
                return Some(Err(evaluator.wrong_form(self.file, &function.span, "`never_grows`", required)));
            }
            _ => {}
        }
        let by = Reduction::named(&function.text);
        let over_time = function.text == "integral";
        if by.is_none() && !over_time {
            return None;
        }
        Some(column_name(evaluator.mistakes, self.file, argument.value).and_then(|name| {
            let dimension = column_dimension(evaluator.mistakes, self.records, self.file, &name)?;
            if over_time
                && !self.records.get(&name.table.text).is_some_and(|columns| columns.contains_key(TIME))
            {
                let message = format!("`{}` has no time to integrate over", name.table.text);
                let span = name.table.span;
                return Err(evaluator.mistakes.report(self.file, Code::WrongForm, span, message, "", None));
            }
            let dimension = if over_time { dimension * Dimension::TIME } else { dimension };
            let (record, column) = (name.table.text, name.column.text);
            let sample = match by {
                Some(by) => Sample::Reduced { by, record, column },
                None => Sample::Integral { record, column },
            };
            Ok(Value::scalar(evaluator.graph.leaf(sample), dimension))
        }))
    }

    fn names(&self) -> Vec<String> {
        self.lets.names().map(|definition| definition.name.text.clone()).collect()
    }

    fn functions(&self) -> Vec<String> {
        let orders = if self.varied.is_empty() { &[][..] } else { &["order", "least_order"] };
        SAMPLES.iter().map(|word| word.word).chain(orders.iter().copied()).map(String::from).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        let record = self.records.iter().find(|(_, columns)| columns.contains_key(name));
        record.map(|(record, _)| format!("write `{record}.{name}`"))
    }
}

impl SampleScope<'_> {
    /// `residual(motion)`: a column of the table a run makes of its exact motion.
    fn residual(&self, evaluator: &mut Evaluator<Sample>, id: ExprId) -> Outcome {
        let is_motion = matches!(&self.file.tree.expr(id).kind, ExprKind::Name(name) if name == "motion");
        let Some(table) = self.records.get("motion").filter(|_| is_motion) else {
            let required = "it is written `residual(motion)`, in a scene that has a `motion`";
            return Err(evaluator.wrong_form(self.file, &self.file.span(id), "`residual`", required));
        };
        let dimension = table.get(RESIDUAL).copied().flatten().ok_or(Reported)?;
        let sample = Sample::Reduced { by: Reduction::Max, record: "motion".into(), column: RESIDUAL.into() };
        Ok(Value::scalar(evaluator.graph.leaf(sample), dimension))
    }

    /// The exponent of a column in the first varied value; a number whatever the column is.
    fn order(&self, evaluator: &mut Evaluator<Sample>, between_neighbours: bool, id: ExprId) -> Outcome {
        let name = column_name(evaluator.mistakes, self.file, id)?;
        column_dimension(evaluator.mistakes, self.records, self.file, &name)?;
        let leaf = evaluator.graph.leaf(Sample::Order {
            record: name.table.text,
            column: name.column.text,
            varied: self.varied.to_vec(),
            between_neighbours,
        });
        Ok(Value::scalar(leaf, Dimension::NUMBER))
    }

    /// What a fit finds under a name as written; of an array its elements.
    fn fitted(&self, evaluator: &mut Evaluator<Sample>, table: &str, written: &str) -> Option<Value> {
        let name: String = written.split_whitespace().collect();
        let mut one = |name: &str| {
            let dimension = *self.fitted.get(name)?;
            let sample = Sample::Reduced { by: Reduction::Final, record: table.into(), column: name.into() };
            Some(Value::scalar(evaluator.graph.leaf(sample), dimension))
        };
        if let Some(value) = one(&name) {
            return Some(value);
        }
        let elements: Vec<Value> = (1..).map_while(|index| one(&format!("{name}[{index}]"))).collect();
        (!elements.is_empty()).then_some(Value::List(elements))
    }

    fn column(&self, evaluator: &mut Evaluator<Sample>, name: &ColumnName) -> Outcome {
        let (table, column) = (name.table.text.clone(), name.column.text.clone());
        if !self.records.contains_key(&table) && self.tables.contains_key(&table) {
            let dimension = table_dimension(evaluator.mistakes, self.tables, self.file, name)?;
            let reference = self.tables[&table].as_ref().ok_or(Reported)?.reference.clone();
            let leaf = evaluator.graph.leaf(Sample::Reference { reference, column });
            return Ok(Value::scalar(leaf, dimension));
        }
        let dimension = column_dimension(evaluator.mistakes, self.records, self.file, name)?;
        Ok(Value::scalar(evaluator.graph.leaf(Sample::Column { record: table, column }), dimension))
    }
}
