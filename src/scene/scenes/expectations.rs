//! `expect`: what must hold of the tables.

use super::super::evaluate::{Evaluator, Required, Scalar, symbol};
use super::super::file::{File, Reported};
use super::super::members::ExpectEntry;
use super::super::model::{Expectation, Judgement, Relation, Sample, Tolerance};
use super::plots::{ColumnName, column_dimension, column_name};
use super::records::TIME;
use super::samples::SampleScope;
use super::stage::Stage;
use crate::expression::Tape;
use crate::syntax::{Argument, At, BinaryOperator, Code, Diagnostic, ExprId, ExprKind, Name, Span};
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// Both sides of a comparison.
struct Sides {
    left: Tape<Sample>,
    right: Tape<Sample>,
    dimension: Dimension,
}

impl Stage<'_> {
    pub(in crate::scene) fn expectation(&mut self, entry: &ExpectEntry) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let judgement = match &file.tree.expr(entry.claim).kind {
            ExprKind::Call { function, arguments } if function.text == "never_grows" => {
                self.never_grows(&file, entry, function, arguments)?
            }
            ExprKind::Binary { operator, at, left, right } => match relation(*operator) {
                Some(relation) => self.comparison(&file, entry, (relation, *operator, at), *left, *right)?,
                None => return Err(self.not_a_claim(&file, entry.claim)),
            },
            _ => return Err(self.not_a_claim(&file, entry.claim)),
        };
        let text = file.text(&entry.span).split_whitespace().collect::<Vec<_>>().join(" ");
        self.scene.expectations.push(Expectation { place: file.place(&entry.span), text, judgement });
        Ok(())
    }

    fn not_a_claim(&mut self, file: &File, id: ExprId) -> Reported {
        let message = "`expect` needs a comparison or `never_grows(record.column)`";
        let help = Some("write `expect a == b within 1 %` or `expect a < b`".into());
        self.mistakes.report(file, Code::WrongForm, file.span(id), message, "", help)
    }

    fn never_grows(
        &mut self,
        file: &Rc<File>,
        entry: &ExpectEntry,
        function: &Name,
        arguments: &[Argument],
    ) -> Result<Judgement, Reported> {
        let [argument] = arguments else {
            let message = "`never_grows` is written `never_grows(record.column)`";
            return Err(self.mistakes.report(
                file,
                Code::WrongForm,
                function.span.clone(),
                message,
                "",
                None,
            ));
        };
        let name = column_name(self.mistakes, file, argument.value)?;
        column_dimension(self.mistakes, &self.columns, file, &name)?;
        if entry.within.is_some() || entry.at.is_some() {
            let message = "`never_grows` holds at all times to round-off: it takes no `within` and no `at`";
            return Err(self.mistakes.report(file, Code::WrongForm, entry.span.clone(), message, "", None));
        }
        Ok(Judgement::NeverGrows { record: name.table.text, column: name.column.text })
    }

    fn comparison(
        &mut self,
        file: &Rc<File>,
        entry: &ExpectEntry,
        (relation, operator, sign): (Relation, BinaryOperator, &Span),
        left: ExprId,
        right: ExprId,
    ) -> Result<Judgement, Reported> {
        let sides = self.sides(file, (operator, sign), left, right)?;
        let tolerance = self.tolerance(file, entry, relation, &sides);
        let at = self.abscissa(file, entry, &sides);
        Ok(Judgement::Compare {
            left: sides.left,
            relation,
            right: sides.right,
            tolerance: tolerance?,
            at: at?,
            unit: sides.dimension.si_symbol(),
        })
    }

    fn sides(
        &mut self,
        file: &Rc<File>,
        (operator, sign): (BinaryOperator, &Span),
        left: ExprId,
        right: ExprId,
    ) -> Result<Sides, Reported> {
        let scope = SampleScope {
            file,
            lets: self.lets.fresh(),
            records: &self.columns,
            tables: &self.tables,
            varied: &self.varied,
            fitted: &self.fitted,
        };
        let mut evaluator = Evaluator::<Sample>::new(self.mistakes);
        let (a, b): (Result<Scalar, _>, Result<Scalar, _>) =
            (evaluator.scalar(&scope, left), evaluator.scalar(&scope, right));
        let (a, b) = (a?, b?);
        if a.dimension != b.dimension {
            let (l, r) = (a.dimension.describe(), b.dimension.describe());
            let message = format!("`{}` compares {l} with {r}", symbol(operator));
            let diagnostic = Diagnostic::new(Code::MixedDimensions, message, sign.clone(), "")
                .with_label(file.span(left), l)
                .with_label(file.span(right), r);
            return Err(self.mistakes.push(file, diagnostic));
        }
        Ok(Sides { left: evaluator.tape(a), right: evaluator.tape(b), dimension: a.dimension })
    }

    /// `within 0.5 %` or `within 1e-10 m`.
    fn tolerance(
        &mut self,
        file: &Rc<File>,
        entry: &ExpectEntry,
        relation: Relation,
        sides: &Sides,
    ) -> Result<Option<Tolerance>, Reported> {
        let equality = relation == Relation::Equal;
        let Some(id) = entry.within else {
            if !equality {
                return Ok(None);
            }
            let message = "an equality of computed numbers needs a tolerance";
            let help = Some("write `within 1 %` behind it, with the tolerance that is meant".into());
            let span = file.span(entry.claim);
            return Err(self.mistakes.report(file, Code::MissingArgument, span, message, "", help));
        };
        if !equality {
            let message = "`within` belongs to an equality";
            return Err(self.mistakes.report(file, Code::WrongForm, file.span(id), message, "", None));
        }
        let site = super::super::members::Site { file: Rc::clone(file), id };
        let relative =
            matches!(&file.tree.expr(id).kind, ExprKind::Number { unit: Some(unit), .. } if unit.text == "%");
        let dimension = if relative { Dimension::NUMBER } else { sides.dimension };
        let value = self.constant(&site, "within", dimension)?;
        if value < 0.0 {
            let message = "a tolerance must be >= 0";
            return Err(self.mistakes.report(
                file,
                Code::ParameterOutOfRange,
                file.span(id),
                message,
                "",
                None,
            ));
        }
        Ok(Some(if relative { Tolerance::Relative(value) } else { Tolerance::Absolute(value) }))
    }

    /// `at record.column = [values]`; `at t = …` means the time of the record first named.
    fn abscissa(
        &mut self,
        file: &Rc<File>,
        entry: &ExpectEntry,
        sides: &Sides,
    ) -> Result<Option<(String, String, Vec<f64>)>, Reported> {
        let leaves = || sides.left.leaves().chain(sides.right.leaves());
        let curve = leaves().any(|leaf| matches!(leaf, Sample::Column { .. } | Sample::Reference { .. }));
        let Some(at) = &entry.at else {
            if !curve {
                return Ok(None);
            }
            let message = "a column holds many values: it must be said where the claim holds";
            let place = if self.abscissa == TIME { "t = 1 ms" } else { &format!("{} = …", self.abscissa) };
            let help = Some(format!("write `at {place}` behind it, or `max(record.column) < …`"));
            let span = file.span(entry.claim);
            return Err(self.mistakes.report(file, Code::MissingArgument, span, message, "", help));
        };
        if !curve {
            let message = "`at` belongs to a column, but neither side holds one";
            return Err(self.mistakes.report(file, Code::WrongForm, file.span(at.key), message, "", None));
        }
        let first = leaves().find_map(|leaf| match leaf {
            Sample::Column { record, .. } => Some(record.clone()),
            _ => None,
        });
        let name = self.abscissa_name(file, at, first)?;
        let dimension = column_dimension(self.mistakes, &self.columns, file, &name)?;
        for leaf in leaves() {
            if let Sample::Reference { reference, .. } = leaf
                && !reference.columns.iter().any(|(column, _)| *column == name.column.text)
            {
                let message = format!(
                    "`{}` has no column `{}` in which it could be read off",
                    reference.path, name.column.text
                );
                let help =
                    Some(format!("write `{} = \"…\"` among the columns of its `csv`", name.column.text));
                return Err(self.mistakes.report(
                    file,
                    Code::UnknownName,
                    file.span(at.key),
                    message,
                    "",
                    help,
                ));
            }
        }
        let values = self.abscissa_values(file, at, &name.column.text, dimension)?;
        let until = self.run.as_ref().map_or(f64::INFINITY, |run| run.until);
        if let Some(late) =
            values.iter().find(|value| name.column.text == TIME && **value > until * (1.0 + 1e-12))
        {
            let time = |value| Quantity::new(value, Dimension::TIME);
            let message = format!("the run ends at {}, before {}", time(until), time(*late));
            return Err(self.mistakes.report(
                file,
                Code::AfterEnd,
                file.span(at.value),
                message,
                "too late",
                None,
            ));
        }
        Ok(Some((name.table.text, name.column.text, values)))
    }

    fn abscissa_name(&mut self, file: &File, at: &At, first: Option<String>) -> Result<ColumnName, Reported> {
        match (&file.tree.expr(at.key).kind, first) {
            (ExprKind::Name(name), Some(record)) if *name == self.abscissa => {
                let span = file.span(at.key);
                let column = Name { text: self.abscissa.clone(), span: span.clone() };
                Ok(ColumnName { table: Name { text: record, span }, column })
            }
            _ => column_name(self.mistakes, file, at.key),
        }
    }

    fn abscissa_values(
        &mut self,
        file: &Rc<File>,
        at: &At,
        name: &str,
        dimension: Dimension,
    ) -> Result<Vec<f64>, Reported> {
        let site = super::super::members::Site { file: Rc::clone(file), id: at.value };
        self.evaluate(&site, (false, false), |evaluator, scope, id| {
            let required = Required { name, dimension };
            let ids = match &scope.file().tree.expr(id).kind {
                ExprKind::List(ids) => ids.clone(),
                _ => vec![id],
            };
            let values: Vec<Result<f64, Reported>> =
                ids.iter().map(|id| evaluator.constant(scope, *id, required)).collect();
            values.into_iter().collect()
        })
    }
}

fn relation(operator: BinaryOperator) -> Option<Relation> {
    Some(match operator {
        BinaryOperator::Equal => Relation::Equal,
        BinaryOperator::Less => Relation::Less,
        BinaryOperator::LessEqual => Relation::LessEqual,
        BinaryOperator::Greater => Relation::Greater,
        BinaryOperator::GreaterEqual => Relation::GreaterEqual,
        _ => return None,
    })
}
