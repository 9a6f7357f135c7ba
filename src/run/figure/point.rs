//! Points of a series, each of two numbers read from the tables of the runs.

use super::super::interpolate::{crossing, reference_value};
use super::results::Results;
use crate::expression::Tape;
use crate::scene::{Shown, ShownPoint};

/// Abscissa and ordinate of a point.
///
/// # Errors
/// What is missing among the results.
pub(super) fn both(point: &ShownPoint, results: &Results) -> Result<(f64, f64), String> {
    Ok((value(&point.x, results)?, value(&point.y, results)?))
}

/// The value of a formula; the first number that cannot be read is the error.
fn value(tape: &Tape<Shown>, results: &Results) -> Result<f64, String> {
    let mut failure = None;
    let value = tape.evaluate(
        |shown| {
            read(shown, results).unwrap_or_else(|reason| {
                failure.get_or_insert(reason);
                f64::NAN
            })
        },
        &mut Vec::new(),
    );
    match failure {
        Some(reason) => Err(reason),
        None if value.is_finite() => Ok(value),
        None => Err(format!("a point of the series has the value {value}")),
    }
}

fn read(shown: &Shown, results: &Results) -> Result<f64, String> {
    let column = |record: &str, column: &str| {
        let found = results.table(record).and_then(|table| table.column(column));
        found.ok_or_else(|| format!("no column `{record}.{column}` was recorded"))
    };
    match shown {
        Shown::Reduced { by, record, column: name } => {
            by.of(column(record, name)?).ok_or_else(|| format!("`{record}` has no rows"))
        }
        Shown::Where { record, column: name, abscissa, value } => {
            let (x, y) = (column(record, abscissa)?, column(record, name)?);
            crossing(&x, &y, *value)
                .ok_or_else(|| format!("`{record}.{abscissa}` never takes the value {value:.6e}"))
        }
        Shown::Reference { reference, column: name, abscissa, value } => {
            let column = |name: &str| {
                let found = reference.columns.iter().find(|(known, _)| known == name);
                let missing = || format!("{} has no column `{name}`", reference.path);
                found.map(|(_, values)| &values[..]).ok_or_else(missing)
            };
            reference_value(column(abscissa)?, column(name)?, *value)
                .ok_or_else(|| format!("{} has no {abscissa} = {value:.6e} between its rows", reference.path))
        }
        Shown::Spacing { source, body } => {
            results.spacing(source, body).ok_or_else(|| format!("the run `{source}` has no body `{body}`"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::results::RunResults;
    use super::*;
    use crate::expression::{Function, Node};
    use crate::output::{Table, TableColumn};
    use crate::scene::{Place, Reduction, Reference};

    fn results() -> Results {
        let column = |name: &str| TableColumn::new(name, "", "");
        let table = Table {
            name: "pull".into(),
            columns: vec![column("t"), column("F"), column("d")],
            rows: vec![vec![0.0, 0.0, 0.0], vec![1.0, 2.0, 10.0], vec![2.0, 6.0, 20.0]],
            provenance: Vec::new(),
        };
        let spacings = vec![("strip".into(), 0.25)];
        let run = RunResults { name: "a".into(), tables: vec![table], spacings, ..RunResults::default() };
        Results { runs: vec![run], short: false }
    }

    fn of(shown: Shown) -> Result<f64, String> {
        value(&Tape::leaf(shown), &results())
    }

    #[test]
    fn a_number_is_read_from_the_table_of_the_run_it_names() {
        let (record, column) = (String::from("a.pull"), String::from("d"));
        let at = |value| Shown::Where {
            record: record.clone(),
            column: column.clone(),
            abscissa: "F".into(),
            value,
        };
        // a quarter of the way from 10 to 20
        assert_eq!(of(at(3.0)), Ok(12.5));
        let most = Shown::Reduced { by: Reduction::Max, record: record.clone(), column: column.clone() };
        assert_eq!(of(most), Ok(20.0));
        assert_eq!(of(Shown::Spacing { source: "a".into(), body: "strip".into() }), Ok(0.25));
        assert!(of(at(7.0)).is_err_and(|reason| reason.contains("never takes the value")));
        assert!(of(Shown::Spacing { source: "b".into(), body: "strip".into() }).is_err());
    }

    #[test]
    fn a_table_from_a_file_is_read_as_an_expectation_does() {
        let x: Vec<f64> = (0..6).map(f64::from).collect();
        let cubes = x.iter().map(|x| x * x * x).collect();
        let columns = vec![("F".into(), x), ("d".into(), cubes)];
        let place = Place { file: "f.tissue".into(), line: 1, column: 1 };
        let reference = Reference { place, path: "fe.csv".into(), columns };
        let at = |value| Shown::Reference {
            reference: reference.clone(),
            column: "d".into(),
            abscissa: "F".into(),
            value,
        };
        // a spline through a cubic is the cubic: some fifty operations on numbers up to 125
        assert!((of(at(2.5)).expect("inside") - 15.625).abs() <= 125.0 * 50.0 * f64::EPSILON);
        assert!(of(at(7.0)).is_err());
    }

    #[test]
    fn a_point_that_is_no_number_is_told() {
        let first = Shown::Reduced { by: Reduction::Initial, record: "a.pull".into(), column: "d".into() };
        let mut logarithm = Tape::leaf(first);
        logarithm.push(Node::Call(Function::Ln, 0));
        assert!(value(&logarithm, &results()).is_err_and(|reason| reason.contains("inf")));
    }
}
