//! What the data say of the parameters at a minimum.
//!
//! Owns standard errors, correlations and findings. Linear theory: what it says is as good as the model is
//! linear over one standard error.

use super::decomposition::Decomposition;
use super::minimise::{Ending, Minimum};
use super::range::Range;
use nalgebra::DMatrix;

/// What the residuals and their derivatives at a minimum say.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// `s = √(Σ r²/(N − p))`, the deviation of one weighted residual; not a number if `N = p`.
    pub deviation: f64,
    /// Standard error of each parameter, in its unit; none for one on its bound or not determined.
    pub standard_errors: Vec<Option<f64>>,
    /// Correlation of the estimates; not a number where one has no standard error.
    pub correlation: DMatrix<f64>,
    /// Largest over smallest eigenvalue of `JᵀJ`, its columns scaled to length 1; infinite if singular.
    pub condition: f64,
    /// What is to be told.
    pub findings: Vec<Finding>,
}

/// A sign that a fitted value is not what it seems.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Finding {
    /// The minimisation did not arrive.
    NotArrived(Ending),
    /// The parameter changes nothing that was measured.
    NoInfluence {
        /// Its index.
        parameter: usize,
    },
    /// The parameter was stopped by the bound of its range: the best value may lie beyond.
    AtBound {
        /// Its index.
        parameter: usize,
        /// The bound.
        bound: f64,
    },
    /// A change of several parameters together that the data cannot see.
    Undetermined {
        /// Relative change of each parameter that takes part, the largest 1.
        combination: Vec<(usize, f64)>,
    },
    /// Two estimates move together: the data fix a combination much better than either.
    Correlated {
        /// The two.
        pair: (usize, usize),
        /// Their correlation.
        correlation: f64,
    },
    /// The standard error exceeds the value.
    Loose {
        /// Its index.
        parameter: usize,
        /// Standard error over value.
        relative: f64,
    },
}

/// Singular value, of the largest, below which a combination is not determined: the derivatives are good
/// to some 1e-12.
const NOT_DETERMINED: f64 = 1e-9;
/// Share of a combination that counts.
const TAKES_PART: f64 = 1e-3;
/// Correlation from which two estimates are told of.
const CORRELATED: f64 = 0.99;

impl Statistics {
    /// Statistics of a minimum.
    ///
    /// ```text
    /// Cov θ = s² (JᵀJ)⁻¹
    /// ```
    ///
    /// Parameters on a bound are held there: the others' errors are those with it fixed.
    pub fn of(minimum: &Minimum, ranges: &[Range]) -> Self {
        let jacobian = &minimum.linear.jacobian;
        let (rows, count) = jacobian.shape();
        let mut findings = Vec::new();
        if matches!(minimum.ending, Ending::Stalled | Ending::OutOfSteps) {
            findings.push(Finding::NotArrived(minimum.ending));
        }
        let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
        let influences = minimum.influences();
        let mut free = Vec::new();
        for j in 0..count {
            let value = minimum.parameters[j];
            if !influences[j] {
                findings.push(Finding::NoInfluence { parameter: j });
            } else if ranges[j].side(value) != 0 {
                findings.push(Finding::AtBound { parameter: j, bound: value });
            } else {
                free.push(j);
            }
        }
        let scaled = DMatrix::from_fn(rows, free.len(), |row, k| jacobian[(row, free[k])] / norms[free[k]]);
        let decomposition = Decomposition::of(scaled);
        let largest = decomposition.values.iter().copied().fold(0.0, f64::max);
        let smallest = decomposition.values.iter().copied().fold(f64::INFINITY, f64::min);
        let condition = if smallest <= NOT_DETERMINED * largest {
            f64::INFINITY
        } else {
            (largest / smallest) * (largest / smallest)
        };
        let spare = rows.saturating_sub(count);
        let deviation = (minimum.sum / spare as f64).sqrt();
        let mut covariance = DMatrix::<f64>::zeros(free.len(), free.len());
        let mut hidden = vec![false; free.len()];
        for (i, &value) in decomposition.values.iter().enumerate() {
            let direction = decomposition.right.column(i);
            if value > NOT_DETERMINED * largest {
                covariance += direction * direction.transpose() / (value * value);
                continue;
            }
            // from scaled parameters to relative changes
            let change =
                |k: usize| direction[k] / (norms[free[k]] * minimum.parameters[free[k]].abs().max(1e-300));
            let most = (0..free.len()).map(|k| change(k).abs()).fold(0.0, f64::max);
            let mut combination = Vec::new();
            for k in 0..free.len() {
                hidden[k] |= direction[k].abs() > TAKES_PART;
                if change(k).abs() > TAKES_PART * most {
                    combination.push((free[k], change(k) / most));
                }
            }
            findings.push(Finding::Undetermined { combination });
        }
        let mut standard_errors = vec![None; count];
        let mut correlation = DMatrix::from_element(count, count, f64::NAN);
        for (k, &j) in free.iter().enumerate().filter(|(k, _)| !hidden[*k]) {
            standard_errors[j] = Some(deviation * covariance[(k, k)].sqrt() / norms[j]);
            for (l, &i) in free.iter().enumerate().filter(|(l, _)| !hidden[*l]) {
                let both = (covariance[(k, k)] * covariance[(l, l)]).sqrt();
                correlation[(j, i)] = if j == i { 1.0 } else { covariance[(k, l)] / both };
            }
        }
        for j in 0..count {
            for i in 0..j {
                if correlation[(i, j)].abs() > CORRELATED {
                    findings.push(Finding::Correlated { pair: (i, j), correlation: correlation[(i, j)] });
                }
            }
        }
        for (parameter, error) in standard_errors.iter().enumerate() {
            let relative = error.unwrap_or(0.0) / minimum.parameters[parameter].abs();
            if relative > 1.0 {
                findings.push(Finding::Loose { parameter, relative });
            }
        }
        Self { deviation, standard_errors, correlation, condition, findings }
    }
}
