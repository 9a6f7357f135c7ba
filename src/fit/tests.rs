//! Fits against closed forms.

use super::*;
use nalgebra::{DMatrix, DVector};

/// `y = a e^(b x)` on `x = 0, 0.1 … 1`.
fn exponential(data: &[f64]) -> impl FnMut(&[f64]) -> Option<Linear> + use<> {
    let data = data.to_vec();
    move |at: &[f64]| {
        let x = |row: usize| 0.1 * row as f64;
        let residuals = DVector::from_fn(data.len(), |row, _| at[0] * libm::exp(at[1] * x(row)) - data[row]);
        let jacobian = DMatrix::from_fn(data.len(), 2, |row, j| {
            let e = libm::exp(at[1] * x(row));
            if j == 0 { e } else { at[0] * x(row) * e }
        });
        Some(Linear { residuals, jacobian })
    }
}

fn data(a: f64, b: f64) -> Vec<f64> {
    (0..=10).map(|row| a * libm::exp(b * 0.1 * f64::from(row))).collect()
}

const ANY: [Range; 2] = [Range { lower: None, upper: None }; 2];

fn at_least(value: f64, is_excluded: bool) -> Range {
    Range { lower: Some(Bound { value, is_excluded }), upper: None }
}

#[test]
fn exact_data_return_their_parameters() {
    let found = minimise(&[1.0, 0.5], &ANY, exponential(&data(2.5, 3.0))).expect("a model");
    // the sum falls to round-off: parameters to some ten round-offs
    assert!((found.parameters[0] - 2.5).abs() < 1e-12 && (found.parameters[1] - 3.0).abs() < 1e-12);
    assert!(matches!(found.ending, Ending::Stationary | Ending::Settled), "{:?}", found.ending);
}

#[test]
fn a_line_has_the_errors_of_the_text_books() {
    // y = p + q x with residuals ±e alternating: normal equations by hand
    let (x, y) = ([0.0, 1.0, 2.0, 3.0], [1.1, 2.9, 5.1, 6.9]);
    let model = |at: &[f64]| {
        Some(Linear {
            residuals: DVector::from_fn(4, |row, _| at[0] + at[1] * x[row] - y[row]),
            jacobian: DMatrix::from_fn(4, 2, |row, j| if j == 0 { 1.0 } else { x[row] }),
        })
    };
    let found = minimise(&[0.0, 0.0], &ANY, model).expect("a model");
    let statistics = Statistics::of(&found, &ANY);
    // Sxx = 5, mean x = 1.5, slope = Σ (x − 1.5)(y − 4)/5 = 1.96, intercept 1.06
    let (slope, intercept) = (1.96, 1.06);
    assert!((found.parameters[1] - slope).abs() < 1e-12 && (found.parameters[0] - intercept).abs() < 1e-12);
    let sum: f64 = (0..4).map(|row| (intercept + slope * x[row] - y[row]).powi(2)).sum();
    let s2 = sum / 2.0;
    let errors = [(s2 * (0.25 + 1.5 * 1.5 / 5.0)).sqrt(), (s2 / 5.0).sqrt()];
    for (found, exact) in statistics.standard_errors.iter().zip(errors) {
        assert!((found.expect("determined") / exact - 1.0).abs() < 1e-12);
    }
    // correlation −x̄/√(x̄² + Sxx/n)
    let correlation = -1.5 / (1.5_f64 * 1.5 + 1.25).sqrt();
    assert!((statistics.correlation[(0, 1)] - correlation).abs() < 1e-12);
    assert!(statistics.findings.is_empty(), "{:?}", statistics.findings);
}

#[test]
fn a_parameter_stops_at_its_bound_and_says_so() {
    let ranges = [at_least(3.0, false), ANY[0]];
    let found = minimise(&[4.0, 0.5], &ranges, exponential(&data(2.5, 3.0))).expect("a model");
    assert_eq!(found.parameters[0], 3.0);
    // with a = 3 held the best b makes the derivative by b vanish
    let slope = found.linear.jacobian.column(1).dot(&found.linear.residuals);
    assert!(slope.abs() < 1e-9 * found.linear.jacobian.column(1).norm() * found.linear.residuals.norm());
    let statistics = Statistics::of(&found, &ranges);
    assert!(statistics.findings.contains(&Finding::AtBound { parameter: 0, bound: 3.0 }));
    assert_eq!(statistics.standard_errors[0], None);
    let inside = [at_least(2.0, false), ANY[0]];
    let found = minimise(&[4.0, 0.5], &inside, exponential(&data(2.5, 3.0))).expect("a model");
    assert!((found.parameters[0] - 2.5).abs() < 1e-12, "a bound that is not needed changes nothing");
}

#[test]
fn an_excluded_bound_is_never_reached() {
    let ranges = [at_least(0.0, true), ANY[0]];
    let mut seen = f64::INFINITY;
    let mut inner = exponential(&data(-1.0, 0.1));
    let found = minimise(&[1.0, 0.1], &ranges, |at| {
        seen = seen.min(at[0]);
        inner(at)
    });
    assert!(found.is_some() && seen > 0.0, "{seen}");
}

#[test]
fn what_the_data_cannot_see_is_named() {
    // y = (a + 2 b) x, and c without influence
    let model = |at: &[f64]| {
        Some(Linear {
            residuals: DVector::from_fn(4, |row, _| (at[0] + 2.0 * at[1] - 5.0) * row as f64 + 0.1),
            jacobian: DMatrix::from_fn(4, 3, |row, j| row as f64 * [1.0, 2.0, 0.0][j]),
        })
    };
    let ranges = [ANY[0]; 3];
    let found = minimise(&[1.0, 1.0, 1.0], &ranges, model).expect("a model");
    let statistics = Statistics::of(&found, &ranges);
    assert_eq!(statistics.condition, f64::INFINITY);
    assert_eq!(statistics.standard_errors, [None, None, None]);
    assert!(statistics.findings.contains(&Finding::NoInfluence { parameter: 2 }));
    let combination = statistics.findings.iter().find_map(|finding| match finding {
        Finding::Undetermined { combination } => Some(combination.clone()),
        _ => None,
    });
    let combination = combination.expect("found");
    // da + 2 db = 0: relative changes in the ratio −2 b/a
    let ratio = combination[0].1 / combination[1].1;
    let exact = -2.0 * found.parameters[1] / found.parameters[0];
    assert!((ratio / exact - 1.0).abs() < 1e-6, "{ratio} {exact}");
}

#[test]
fn a_model_that_does_not_exist_everywhere_is_approached_from_where_it_does() {
    let mut inner = exponential(&data(2.5, 3.0));
    let model = |at: &[f64]| if at[1] > 5.0 { None } else { inner(at) };
    let found = minimise(&[0.1, 0.5], &ANY, model).expect("it exists at the start");
    assert!((found.parameters[1] - 3.0).abs() < 1e-10, "{:?}", found.parameters);
    assert!(minimise(&[1.0, 1.0], &ANY, |_| None).is_none());
}
