//! Expectations judged on the tables of a run.
//!
//! Owns the reading of an `expect` line; it sees tables only, never the state they came from.

use super::interpolate::{crossing, reference_value};
use super::order::order;
use crate::expression::Tape;
use crate::output::Table;
use crate::output::report::ExpectationVerdict;
use crate::scene::{Expectation, Judgement, Reference, Relation, Sample, Tolerance};

/// Judges every expectation.
pub fn judge_all(expectations: &[Expectation], tables: &[Table]) -> Vec<ExpectationVerdict> {
    expectations.iter().map(|expectation| judge(expectation, tables)).collect()
}

/// Judges one expectation.
///
/// For an equality the measured value is the distance of the two sides and the bound the tolerance;
/// for an inequality the measured value is the left side and the bound the right. Of several
/// abscissae the worst is reported.
pub fn judge(expectation: &Expectation, tables: &[Table]) -> ExpectationVerdict {
    let mut verdict = ExpectationVerdict {
        text: expectation.text.clone(),
        place: format!("{}:{}", expectation.place.file, expectation.place.line),
        measured: None,
        bound: 0.0,
        unit: String::new(),
        holds: false,
        note: String::new(),
    };
    match &expectation.judgement {
        Judgement::Compare { left, relation, right, tolerance, at, unit } => {
            verdict.unit.clone_from(unit);
            let places: Vec<Option<At<'_>>> = match at {
                None => vec![None],
                Some((record, column, values)) => {
                    values.iter().map(|&value| Some(At { record, column, value })).collect()
                }
            };
            let mut worst: Option<Measured> = None;
            for place in places {
                match measure(left, *relation, right, *tolerance, place.as_ref(), tables) {
                    Ok(measured) => {
                        if worst
                            .as_ref()
                            .is_none_or(|w| measured.excess.is_nan() || measured.excess > w.excess)
                        {
                            worst = Some(measured);
                        }
                    }
                    Err(reason) => {
                        verdict.note = reason;
                        return verdict;
                    }
                }
            }
            if let Some(worst) = worst {
                if matches!(tolerance, Some(Tolerance::Relative(_))) {
                    verdict.unit.clear();
                }
                verdict.measured = Some(worst.value);
                verdict.bound = worst.bound;
                verdict.holds = worst.holds;
                verdict.note = worst.note;
            }
        }
        Judgement::NeverGrows { record, column } => match column_of(tables, record, column) {
            Err(reason) => verdict.note = reason,
            Ok(values) => {
                let (growth, scale, row) = growth(&values);
                verdict.measured = Some(growth);
                verdict.bound = values.len() as f64 * f64::EPSILON * scale;
                verdict.holds = growth <= verdict.bound;
                verdict.note = format!("largest rise above the running minimum in row {row}");
            }
        },
    }
    verdict
}

/// What an expectation measures on tables that are wrong, for a report that shows it can fail.
///
/// Of an equality the left side's records are off by twenty tolerances (of a number of that size),
/// of a comparison the left side is twenty times beyond the right, of a decrease time runs backwards.
/// `None` where nothing could be measured in the first place.
pub fn control(expectation: &Expectation, tables: &[Table]) -> Option<f64> {
    match &expectation.judgement {
        Judgement::NeverGrows { record, column } => {
            let mut values = column_of(tables, record, column).ok()?;
            values.reverse();
            Some(growth(&values).0)
        }
        Judgement::Compare { left, right, relation: Relation::Equal, tolerance, at, .. } => {
            let first = at.as_ref().map(|(record, column, values)| At { record, column, value: values[0] });
            let (left, right) =
                (side(left, first.as_ref(), tables).ok()?, side(right, first.as_ref(), tables).ok()?);
            let displaced = |by: f64| (left + by - right).abs();
            Some(match tolerance {
                Some(Tolerance::Relative(share)) => displaced(WRONG * share * right) / right.abs(),
                Some(Tolerance::Absolute(bound)) => displaced(WRONG * bound),
                None => displaced(right.abs().max(1.0)),
            })
        }
        Judgement::Compare { right, at, .. } => {
            let first = at.as_ref().map(|(record, column, values)| At { record, column, value: values[0] });
            Some(WRONG * side(right, first.as_ref(), tables).ok()?)
        }
    }
}

/// By how many tolerances a control is off.
const WRONG: f64 = 20.0;

/// Largest rise above the running minimum, the largest magnitude, and the row of the rise.
fn growth(values: &[f64]) -> (f64, f64, usize) {
    let (mut least, mut worst, mut scale, mut at) = (f64::INFINITY, 0.0, 0.0_f64, 0);
    for (row, &value) in values.iter().enumerate() {
        if value.is_nan() {
            return (f64::NAN, scale, row);
        }
        scale = scale.max(value.abs());
        if value - least > worst {
            worst = value - least;
            at = row;
        }
        least = least.min(value);
    }
    (worst, scale, at)
}

/// Where both sides are read.
struct At<'a> {
    record: &'a str,
    column: &'a str,
    value: f64,
}

/// One comparison.
struct Measured {
    value: f64,
    bound: f64,
    holds: bool,
    /// By how much the bound is missed, negative where it holds; orders several places.
    excess: f64,
    note: String,
}

fn measure(
    left: &Tape<Sample>,
    relation: Relation,
    right: &Tape<Sample>,
    tolerance: Option<Tolerance>,
    at: Option<&At<'_>>,
    tables: &[Table],
) -> Result<Measured, String> {
    let left = side(left, at, tables)?;
    let right = side(right, at, tables)?;
    let place =
        at.map_or_else(String::new, |at| format!(" at {}.{} = {:.6e}", at.record, at.column, at.value));
    let note = format!("{left:.6e} against {right:.6e}{place}");
    let compare =
        |holds: bool, excess: f64| Measured { value: left, bound: right, holds, excess, note: note.clone() };
    Ok(match relation {
        Relation::Less => compare(left < right, left - right),
        Relation::LessEqual => compare(left <= right, left - right),
        Relation::Greater => compare(left > right, right - left),
        Relation::GreaterEqual => compare(left >= right, right - left),
        Relation::Equal => {
            let (value, bound) = match tolerance {
                Some(Tolerance::Relative(share)) => ((left - right).abs() / right.abs(), share),
                Some(Tolerance::Absolute(bound)) => ((left - right).abs(), bound),
                None => ((left - right).abs(), 0.0),
            };
            Measured { value, bound, holds: value <= bound, excess: value - bound, note }
        }
    })
}

/// Value of one side; the first sample that cannot be read is the error.
fn side(tape: &Tape<Sample>, at: Option<&At<'_>>, tables: &[Table]) -> Result<f64, String> {
    let mut failure = None;
    let value = tape.evaluate(
        |sample| {
            read(sample, at, tables).unwrap_or_else(|reason| {
                failure.get_or_insert(reason);
                f64::NAN
            })
        },
        &mut Vec::new(),
    );
    failure.map_or(Ok(value), Err)
}

fn read(sample: &Sample, at: Option<&At<'_>>, tables: &[Table]) -> Result<f64, String> {
    match sample {
        Sample::Reduced { by, record, column } => {
            let values = column_of(tables, record, column)?;
            by.of(values).ok_or_else(|| format!("`{record}` has no rows"))
        }
        Sample::Order { record, column, varied, between_neighbours } => {
            let values = column_of(tables, record, column)?;
            let varied: Vec<Vec<f64>> =
                varied.iter().map(|name| column_of(tables, record, name)).collect::<Result<_, _>>()?;
            order(&varied, &values, *between_neighbours).map_err(|reason| format!("{reason} in `{column}`"))
        }
        Sample::Integral { record, column } => {
            let (x, y) = (order_of(tables, record)?, column_of(tables, record, column)?);
            let strips = x.windows(2).zip(y.windows(2));
            Ok(strips.map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1])).sum())
        }
        Sample::Column { record, column } => {
            let at = at.ok_or_else(|| format!("`{record}.{column}` needs an `at`"))?;
            let y = column_of(tables, record, column)?;
            // a column of another record is read where time (or the parameter) has the value it has there
            let x = column_of(tables, at.record, at.column)?;
            let value = if record == at.record {
                crossing(&x, &y, at.value)
            } else {
                let there = order_of(tables, at.record)?;
                let own = order_of(tables, record)?;
                crossing(&x, &there, at.value).and_then(|there| crossing(&own, &y, there))
            };
            value.ok_or_else(|| {
                format!("`{}.{}` never takes the value {:.6e}", at.record, at.column, at.value)
            })
        }
        Sample::Reference { reference, column } => {
            let at = at.ok_or_else(|| format!("`{column}` of {} needs an `at`", reference.path))?;
            let x = reference_column(reference, at.column)?;
            let y = reference_column(reference, column)?;
            reference_value(x, y, at.value).ok_or_else(|| {
                format!("{} has no {} = {:.6e} between its rows", reference.path, at.column, at.value)
            })
        }
    }
}

pub(super) fn column_of(tables: &[Table], record: &str, column: &str) -> Result<Vec<f64>, String> {
    tables
        .iter()
        .find(|table| table.name == record)
        .and_then(|table| table.column(column))
        .ok_or_else(|| format!("no column `{record}.{column}` was recorded"))
}

/// The column a record's rows are ordered by: time, or the parameter of a path.
fn order_of(tables: &[Table], record: &str) -> Result<Vec<f64>, String> {
    let table = tables.iter().find(|table| table.name == record);
    let first = table.and_then(|table| table.column(&table.columns.first()?.name));
    first.ok_or_else(|| format!("no table `{record}` was recorded"))
}

fn reference_column<'a>(reference: &'a Reference, column: &str) -> Result<&'a [f64], String> {
    let found = reference.columns.iter().find(|(name, _)| name == column);
    found.map(|(_, values)| &values[..]).ok_or_else(|| format!("{} has no column `{column}`", reference.path))
}
