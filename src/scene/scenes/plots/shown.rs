//! `points` of a series: pairs of numbers, each read from the tables of a run.
//!
//! Owns the names and functions of these numbers.

use super::super::super::evaluate::{Evaluator, Leaves, Lets, Outcome, Scope, Value};
use super::super::super::file::{File, Reported};
use super::super::super::members::Site;
use super::super::super::model::{Reduction, Shown, ShownPoint};
use super::super::super::words::SERIES_WORDS;
use super::super::stage::{Records, Stage};
use super::super::tables::Tables;
use super::super::values::place_of_value;
use super::{Axes, column_dimension, column_name, dotted, table_dimension};
use crate::schema::nearest;
use crate::syntax::{Argument, Code, ExprId, ExprKind, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

impl Leaves for Shown {}

impl Stage<'_> {
    /// The pairs `[[x, y], …]` of a series, and the SI units of both.
    pub(super) fn shown(
        &mut self,
        site: &Site,
        axes: &mut Axes,
    ) -> Result<(Vec<ShownPoint>, [String; 2]), Reported> {
        let file = Rc::clone(&site.file);
        let ids = match &file.tree.expr(site.id).kind {
            ExprKind::List(ids) if !ids.is_empty() => ids.clone(),
            _ => return Err(self.not_points(&file, site.id)),
        };
        let mut points = Vec::new();
        let mut units = None;
        for id in ids {
            let pair = match &file.tree.expr(id).kind {
                ExprKind::List(pair) => <[ExprId; 2]>::try_from(pair.as_slice()).ok(),
                _ => None,
            };
            let Some(pair) = pair else { return Err(self.not_points(&file, id)) };
            let bodies = self.sources.iter().flat_map(|(source, scene)| {
                scene.bodies.iter().map(move |body| (format!("{source}.{}", body.name), source.clone()))
            });
            let scope = ShownScope {
                file: &file,
                lets: self.lets.fresh(),
                records: &self.columns,
                tables: &self.tables,
                bodies: bodies.collect(),
            };
            let mut evaluator = Evaluator::<Shown>::new(self.mistakes);
            let [x, y] = pair.map(|id| evaluator.scalar(&scope, id));
            let (x, y) = (x?, y?);
            points.push(ShownPoint { x: evaluator.tape(x), y: evaluator.tape(y) });
            self.same_axes(&file, id, (y.dimension, x.dimension), axes)?;
            units.get_or_insert([x.dimension.si_symbol(), y.dimension.si_symbol()]);
        }
        Ok((points, units.unwrap_or_default()))
    }

    fn not_points(&mut self, file: &File, id: ExprId) -> Reported {
        let message = "`points` is a list of pairs, abscissa and ordinate";
        let help = Some("write `points = [[0 mm, final(record.column)]]`".into());
        self.mistakes.report(file, Code::WrongForm, file.span(id), message, "", help)
    }
}

/// The names in a point.
struct ShownScope<'a> {
    file: &'a Rc<File>,
    lets: Lets,
    records: &'a Records,
    tables: &'a Tables,
    /// `source.body`, and the source.
    bodies: BTreeMap<String, String>,
}

impl Scope<Shown> for ShownScope<'_> {
    fn file(&self) -> &Rc<File> {
        self.file
    }

    fn name(&self, evaluator: &mut Evaluator<Shown>, name: &Name) -> Option<Outcome> {
        self.lets.name(evaluator, self, name)
    }

    fn member(
        &self,
        evaluator: &mut Evaluator<Shown>,
        base: ExprId,
        name: &Name,
        span: &Span,
    ) -> Option<Outcome> {
        let table = dotted(self.file, base)?.text;
        if !self.records.contains_key(&table) && !self.tables.contains_key(&table) {
            return None;
        }
        let column = format!("{table}.{}", name.text);
        let message = format!("`{column}` holds many values, but a point has one");
        let help = Some(if self.records.contains_key(&table) {
            format!("write `final({column})`, or max, min, initial or value of it")
        } else {
            format!(
                "write `value({column}, other = 1 N)` with another column of the table and where it is read"
            )
        });
        let file = self.file;
        Some(Err(evaluator.mistakes.report(file, Code::WrongForm, span.clone(), message, "", help)))
    }

    fn call(
        &self,
        evaluator: &mut Evaluator<Shown>,
        outer: &dyn Scope<Shown>,
        function: &Name,
        arguments: &[Argument],
    ) -> Option<Outcome> {
        if let Some(outcome) = self.lets.call(evaluator, self, outer, function, arguments) {
            return Some(outcome);
        }
        if function.text == "value" {
            return Some(self.value(evaluator, outer, function, arguments));
        }
        let [Argument { name: None, value }] = arguments else { return None };
        if function.text == "spacing" {
            return Some(self.spacing(evaluator, *value));
        }
        let by = Reduction::named(&function.text)?;
        Some(column_name(evaluator.mistakes, self.file, *value).and_then(|name| {
            let dimension = column_dimension(evaluator.mistakes, self.records, self.file, &name)?;
            let leaf = Shown::Reduced { by, record: name.table.text, column: name.column.text };
            Ok(Value::scalar(evaluator.graph.leaf(leaf), dimension))
        }))
    }

    fn names(&self) -> Vec<String> {
        self.lets.names().map(|definition| definition.name.text.clone()).collect()
    }

    fn functions(&self) -> Vec<String> {
        SERIES_WORDS.iter().map(|word| word.word.into()).collect()
    }

    fn hint(&self, name: &str) -> Option<String> {
        let record = self.records.iter().find(|(_, columns)| columns.contains_key(name));
        record.map(|(record, _)| format!("write `final({record}.{name})`"))
    }
}

impl ShownScope<'_> {
    /// `value(record.column, other = quantity)`, of a table from a file as well.
    fn value(
        &self,
        evaluator: &mut Evaluator<Shown>,
        outer: &dyn Scope<Shown>,
        function: &Name,
        arguments: &[Argument],
    ) -> Outcome {
        let name = match arguments.first() {
            Some(Argument { name: None, value }) => dotted_table(self.file, *value),
            _ => None,
        };
        let table =
            name.filter(|name| !self.records.contains_key(name)).and_then(|name| self.tables.get(&name));
        let Some(table) = table else {
            let of = |mistakes: &mut _, name: &_| column_dimension(mistakes, self.records, self.file, name);
            let found = place_of_value(evaluator, outer, function, arguments, &of)?;
            let leaf = Shown::Where {
                record: found.record,
                column: found.column,
                abscissa: found.abscissa,
                value: found.value,
            };
            return Ok(Value::scalar(evaluator.graph.leaf(leaf), found.dimension));
        };
        let of = |mistakes: &mut _, name: &_| table_dimension(mistakes, self.tables, self.file, name);
        let found = place_of_value(evaluator, outer, function, arguments, &of)?;
        let reference = table.as_ref().ok_or(Reported)?.reference.clone();
        let leaf = Shown::Reference {
            reference,
            column: found.column,
            abscissa: found.abscissa,
            value: found.value,
        };
        Ok(Value::scalar(evaluator.graph.leaf(leaf), found.dimension))
    }

    /// `spacing(source.body)`.
    fn spacing(&self, evaluator: &mut Evaluator<Shown>, id: ExprId) -> Outcome {
        let written = dotted(self.file, id).map(|name| name.text).unwrap_or_default();
        if let Some((name, source)) = self.bodies.get_key_value(&written) {
            let body = name[source.len() + 1..].to_string();
            let leaf = Shown::Spacing { source: source.clone(), body };
            return Ok(Value::scalar(evaluator.graph.leaf(leaf), Dimension::LENGTH));
        }
        let known: Vec<&str> = self.bodies.keys().map(String::as_str).collect();
        let help = match nearest(&written, known.iter().copied()) {
            Some(meant) => Some(format!("write `spacing({meant})`")),
            None if known.is_empty() => None,
            None => Some(format!("the bodies are {}", known.join(", "))),
        };
        let message = "`spacing` takes a body of a source, `source.body`";
        let span = self.file.span(id);
        Err(evaluator.mistakes.report(self.file, Code::UnknownName, span, message, "", help))
    }
}

/// The table of a column as written.
fn dotted_table(file: &File, id: ExprId) -> Option<String> {
    match &file.tree.expr(id).kind {
        ExprKind::Member { base, .. } => dotted(file, *base).map(|name| name.text),
        _ => None,
    }
}
