//! `table(times, values)`: straight lines in time.

use super::super::evaluate::{Evaluator, Outcome, Required, Scalar, Scope, Value};
use super::super::file::Reported;
use super::super::model::Coordinate;
use super::tables::Tables;
use crate::expression::{Comparison, NodeId};
use crate::schema::nearest;
use crate::syntax::{Argument, Code, ExprId, ExprKind, Name};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// Most rows of a table in time: a formula evaluates all of them.
const MOST: usize = 10_000;

/// What the two arguments of one table need.
struct Reading<'e, 'm, 's> {
    evaluator: &'e mut Evaluator<'m, Coordinate>,
    scope: &'s dyn Scope<Coordinate>,
    tables: &'s Tables,
}

/// `table([t1, t2, …], [v1, v2, …])`, each a list or a column of a `csv(…)`.
///
/// ```text
/// v1 for t < t1,   v_k + (v_k+1 − v_k)(t − t_k)/(t_k+1 − t_k) for t_k ≤ t < t_k+1,   v_n from t_n on
/// ```
pub(super) fn table(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    tables: &Tables,
    function: &Name,
    arguments: &[Argument],
) -> Outcome {
    let file = Rc::clone(scope.file());
    let form = "`table` is written `table([0 ms, 1 ms], [0 mm, 1 mm])`";
    let [Argument { name: None, value: times, .. }, Argument { name: None, value: values, .. }] = arguments
    else {
        let span = function.span.clone();
        return Err(evaluator.mistakes.report(&file, Code::WrongForm, span, form, "", None));
    };
    let mut reading = Reading { evaluator, scope, tables };
    let (t, v) = (reading.times(*times), reading.values(*values));
    let (t, v) = (t?, v?);
    let evaluator = reading.evaluator;
    if t.len() != v.len() || t.len() < 2 || t.len() > MOST {
        let message = if t.len() != v.len() {
            format!("`table` has {} times, but {} values", t.len(), v.len())
        } else {
            format!("`table` takes 2 to {MOST} times, but has {}", t.len())
        };
        let span = function.span.clone();
        return Err(evaluator.mistakes.report(&file, Code::WrongForm, span, message, "", None));
    }
    if let Some(k) =
        t.windows(2).position(|pair| pair[1].partial_cmp(&pair[0]) != Some(std::cmp::Ordering::Greater))
    {
        let time = |value| Quantity::new(value, Dimension::TIME);
        let message = format!(
            "the times of a `table` must ascend, but {} is followed by {}",
            time(t[k]),
            time(t[k + 1])
        );
        let span = file.span(*times);
        return Err(evaluator.mistakes.report(&file, Code::WrongForm, span, message, "", None));
    }
    let dimension = v[0].dimension;
    let nodes: Vec<NodeId> = v.iter().map(|value| value.node).collect();
    let time = evaluator.graph.leaf(Coordinate::Time);
    let inner = between(evaluator, time, &t, &nodes);
    let (first, last) = (evaluator.graph.constant(t[0]), evaluator.graph.constant(t[t.len() - 1]));
    let until_last = evaluator.graph.select((time, Comparison::Less, last), inner, nodes[nodes.len() - 1]);
    let node = evaluator.graph.select((time, Comparison::Less, first), nodes[0], until_last);
    Ok(Value::Scalar(Scalar { node, dimension }))
}

/// The line of the interval that holds the time, found by halving.
fn between(evaluator: &mut Evaluator<Coordinate>, time: NodeId, t: &[f64], v: &[NodeId]) -> NodeId {
    if let ([from, to], &[start, end]) = (t, v) {
        let graph = &mut evaluator.graph;
        let (from, length) = (graph.constant(*from), graph.constant(to - from));
        let passed = graph.subtract(time, from);
        let share = graph.divide(passed, length);
        let way = graph.subtract(end, start);
        let moved = graph.multiply(way, share);
        return graph.add(start, moved);
    }
    let middle = t.len() / 2;
    let before = between(evaluator, time, &t[..=middle], &v[..=middle]);
    let after = between(evaluator, time, &t[middle..], &v[middle..]);
    let at = evaluator.graph.constant(t[middle]);
    evaluator.graph.select((time, Comparison::Less, at), before, after)
}

impl Reading<'_, '_, '_> {
    fn times(&mut self, id: ExprId) -> Result<Vec<f64>, Reported> {
        let required = Required { name: "time", dimension: Dimension::TIME };
        let file = Rc::clone(self.scope.file());
        if let Some((numbers, dimension)) = self.column(id)? {
            let node = self.evaluator.graph.constant(0.0);
            self.evaluator.require(&file, id, Scalar { node, dimension }, required)?;
            return Ok(numbers);
        }
        let ids = self.list(id)?;
        let times: Vec<_> =
            ids.into_iter().map(|id| self.evaluator.constant(self.scope, id, required)).collect();
        times.into_iter().collect()
    }

    /// Values of one dimension, the first one's.
    fn values(&mut self, id: ExprId) -> Result<Vec<Scalar>, Reported> {
        if let Some((numbers, dimension)) = self.column(id)? {
            let mut value = |x: f64| Scalar { node: self.evaluator.graph.constant(x), dimension };
            return Ok(numbers.into_iter().map(&mut value).collect());
        }
        let file = Rc::clone(self.scope.file());
        let mut values: Vec<Scalar> = Vec::new();
        for id in self.list(id)? {
            let value = self.evaluator.scalar(self.scope, id)?;
            let dimension = values.first().map_or(value.dimension, |first| first.dimension);
            let required = Required { name: "value", dimension };
            values.push(self.evaluator.require(&file, id, value, required)?);
        }
        Ok(values)
    }

    fn list(&mut self, id: ExprId) -> Result<Vec<ExprId>, Reported> {
        let file = Rc::clone(self.scope.file());
        if let ExprKind::List(ids) = &file.tree.expr(id).kind {
            return Ok(ids.clone());
        }
        let required = "`table` takes lists or columns of a `csv(…)`";
        Err(self.evaluator.wrong_form(&file, &file.span(id), "this", required))
    }

    /// The column of a table `data.u`, or `None` if the expression names no table.
    fn column(&mut self, id: ExprId) -> Result<Option<(Vec<f64>, Dimension)>, Reported> {
        let file = Rc::clone(self.scope.file());
        let ExprKind::Member { base, name } = &file.tree.expr(id).kind else { return Ok(None) };
        let ExprKind::Name(table) = &file.tree.expr(*base).kind else { return Ok(None) };
        let Some(known) = self.tables.get(table) else { return Ok(None) };
        // what is wrong with the file has been reported there
        let known = known.as_ref().ok_or(Reported)?;
        let column = known.reference.columns.iter().find(|(column, _)| *column == name.text);
        match (column, known.dimension(&name.text)) {
            (Some((_, numbers)), Some(dimension)) => Ok(Some((numbers.clone(), dimension))),
            _ => {
                let message = format!("`{table}` has no column `{}`", name.text);
                let names: Vec<&str> = known.names().collect();
                let help = match nearest(&name.text, names.iter().copied()) {
                    Some(meant) => format!("write `{table}.{meant}`"),
                    None => format!("its columns are {}", names.join(", ")),
                };
                let span = name.span.clone();
                let code = Code::UnknownName;
                Err(self.evaluator.mistakes.report(&file, code, span, message, "", Some(help)))
            }
        }
    }
}
