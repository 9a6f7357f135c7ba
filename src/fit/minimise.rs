//! A sum of squares made smallest within bounds: Levenberg and Marquardt, projected.
//!
//! Owns the choice of steps and when to stop.

use super::decomposition::Decomposition;
use super::range::Range;
use nalgebra::{DMatrix, DVector};

/// Residuals at a set of parameters and their derivatives by each, a column each.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// Weighted differences between model and data.
    pub residuals: DVector<f64>,
    /// Their derivatives.
    pub jacobian: DMatrix<f64>,
}

/// Why the minimisation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ending {
    /// The residuals are orthogonal to what the parameters can change, or zero.
    Stationary,
    /// Steps no longer change a digit of the parameters or of the sum.
    Settled,
    /// No step, however short, makes the sum smaller.
    Stalled,
    /// The number of steps was used up.
    OutOfSteps,
}

/// Where the minimisation ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimum {
    /// Parameters.
    pub parameters: Vec<f64>,
    /// Residuals and derivatives there.
    pub linear: Linear,
    /// Sum of the squared residuals at the start.
    pub first_sum: f64,
    /// Sum of the squared residuals.
    pub sum: f64,
    /// Steps taken.
    pub steps: u32,
    /// Evaluations of the model.
    pub evaluations: u32,
    /// Why it ended.
    pub ending: Ending,
}

/// Cosine between residuals and each column of the Jacobian that counts as a right angle: round-off of
/// sums of some hundred products.
const RIGHT_ANGLE: f64 = 1e-14;
/// The same where no step makes the sum smaller: the square root of round-off, below which a fall of the
/// sum is lost in its digits.
const NEARLY_RIGHT_ANGLE: f64 = 1e-7;
/// Relative change of every parameter that is no change.
const NO_CHANGE: f64 = 1e-15;
/// Residuals of this size relative to the largest derivative times its parameter are round-off.
const EXACT: f64 = 1e-15;
/// Fall of the sum, relative to it, that is lost in its digits.
const LOST: f64 = 1e-11;
/// Change of the residuals by a whole parameter, of the largest such change, that is round-off of the model.
const UNFELT: f64 = 1e-11;
const MOST_STEPS: u32 = 500;
const FIRST_DAMPING: f64 = 1e-3;
const LARGEST_DAMPING: f64 = 1e16;

/// Makes the sum of squares smallest from `start`, which must lie in `ranges`.
///
/// `model` gives the residuals at a set of parameters, `None` where the model does not exist; a step there
/// is shortened like one that makes the sum larger. The damping follows Nielsen (1999), the scale of each
/// parameter is the largest column norm seen (Moré 1978), steps end on the bounds they would cross, and a
/// parameter on its bound is held there while the sum falls outwards.
///
/// Returns `None` where the model does not exist at `start`.
pub fn minimise(
    start: &[f64],
    ranges: &[Range],
    mut model: impl FnMut(&[f64]) -> Option<Linear>,
) -> Option<Minimum> {
    let mut evaluate = |parameters: &[f64]| {
        let linear = model(parameters)?;
        let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        (is_finite(linear.residuals.as_slice()) && is_finite(linear.jacobian.as_slice())).then_some(linear)
    };
    let linear = evaluate(start)?;
    let sum = linear.residuals.norm_squared();
    let mut at = Minimum {
        parameters: start.to_vec(),
        linear,
        first_sum: sum,
        sum,
        steps: 0,
        evaluations: 1,
        ending: Ending::OutOfSteps,
    };
    let mut scales = vec![0.0_f64; start.len()];
    let (mut damping, mut growth) = (FIRST_DAMPING, 2.0);
    while at.steps < MOST_STEPS {
        for (scale, column) in scales.iter_mut().zip(at.linear.jacobian.column_iter()) {
            *scale = scale.max(column.norm());
        }
        let free = free(&at, ranges);
        if is_stationary(&at, &free, RIGHT_ANGLE) {
            at.ending = Ending::Stationary;
            break;
        }
        let scaled = DMatrix::from_fn(at.linear.residuals.len(), free.len(), |row, k| {
            at.linear.jacobian[(row, free[k])] / scales[free[k]]
        });
        let decomposition = Decomposition::of(scaled);
        let ending = loop {
            let mut next = at.parameters.clone();
            let step = decomposition.damped_step(&at.linear.residuals, damping);
            for (k, &j) in free.iter().enumerate() {
                next[j] = ranges[j].restrict(at.parameters[j], at.parameters[j] + step[k] / scales[j]);
            }
            let is_same =
                |(new, old): (&f64, &f64)| (new - old).abs() <= NO_CHANGE * new.abs().max(old.abs());
            if next.iter().zip(&at.parameters).all(is_same) {
                break Some(ended(&at, &free));
            }
            at.evaluations += 1;
            let found = evaluate(&next).map(|linear| (linear.residuals.norm_squared(), linear));
            if let Some((sum, linear)) = found {
                let expected = predicted(&at, &next);
                let trial = Minimum { parameters: next, linear, sum, steps: at.steps + 1, ..at.clone() };
                // Where the fall is lost in the digits of the sum, the angle still tells.
                let is_lost = expected.abs() <= LOST * at.sum;
                let is_better = if is_lost {
                    largest_cosine(&trial, &free) < largest_cosine(&at, &free)
                } else {
                    sum < at.sum
                };
                if !is_better {
                    (damping, growth) = (damping * growth, 2.0 * growth);
                    if damping > LARGEST_DAMPING {
                        break Some(ended(&at, &free));
                    }
                    continue;
                }
                let ratio = if is_lost { 1.0 } else { (at.sum - sum) / expected };
                at = Minimum { evaluations: at.evaluations, ..trial };
                let eased = 1.0 - (2.0 * ratio - 1.0) * (2.0 * ratio - 1.0) * (2.0 * ratio - 1.0);
                (damping, growth) = (damping * eased.clamp(1.0 / 3.0, 2.0), 2.0);
                break None;
            }
            (damping, growth) = (damping * growth, 2.0 * growth);
            if damping > LARGEST_DAMPING {
                break Some(ended(&at, &free));
            }
        };
        if let Some(ending) = ending {
            at.ending = ending;
            break;
        }
    }
    Some(at)
}

/// Parameters that may move: those with influence and not held on their bound.
fn free(at: &Minimum, ranges: &[Range]) -> Vec<usize> {
    let influences = at.influences();
    let moves = |&j: &usize| {
        let slope = at.linear.jacobian.column(j).dot(&at.linear.residuals);
        // the sum falls towards −slope
        let outwards = f64::from(ranges[j].side(at.parameters[j])) * -slope > 0.0;
        influences[j] && !outwards
    };
    (0..at.parameters.len()).filter(moves).collect()
}

impl Minimum {
    /// Whether each parameter changes the residuals by more than round-off.
    pub(super) fn influences(&self) -> Vec<bool> {
        let sizes: Vec<(f64, f64)> = self
            .linear
            .jacobian
            .column_iter()
            .zip(&self.parameters)
            .map(|(column, parameter)| (column.norm(), parameter.abs()))
            .collect();
        let largest = sizes.iter().map(|(norm, value)| norm * value).fold(0.0, f64::max);
        // A parameter that is 0 has no size to be judged by.
        let is_felt =
            |&(norm, value): &(f64, f64)| norm > 0.0 && (value == 0.0 || norm * value > UNFELT * largest);
        sizes.iter().map(is_felt).collect()
    }
}

/// What it means that no step is left to take.
fn ended(at: &Minimum, free: &[usize]) -> Ending {
    // of data without noise all that is left is the round-off of the model, which has any angle
    let size = |&j: &usize| at.linear.jacobian.column(j).norm() * at.parameters[j].abs();
    let is_exact = at.linear.residuals.norm() <= UNFELT * free.iter().map(size).fold(0.0, f64::max);
    if is_exact || is_stationary(at, free, NEARLY_RIGHT_ANGLE) { Ending::Settled } else { Ending::Stalled }
}

fn is_stationary(at: &Minimum, free: &[usize], right_angle: f64) -> bool {
    largest_cosine(at, free) <= right_angle
}

/// Largest cosine between the residuals and what a free parameter can change; 0 where they are round-off.
fn largest_cosine(at: &Minimum, free: &[usize]) -> f64 {
    let size = at.linear.residuals.norm();
    let cosine = |&j: &usize| {
        let column = at.linear.jacobian.column(j);
        let length = column.norm();
        let is_exact = size <= EXACT * length * at.parameters[j].abs();
        if is_exact { 0.0 } else { column.dot(&at.linear.residuals).abs() / (length * size) }
    };
    free.iter().map(cosine).fold(0.0, f64::max)
}

/// By how much the sum would fall if the residuals were linear.
fn predicted(at: &Minimum, next: &[f64]) -> f64 {
    let change =
        DVector::from_iterator(next.len(), next.iter().zip(&at.parameters).map(|(new, old)| new - old));
    let linear = &at.linear.residuals + &at.linear.jacobian * change;
    at.sum - linear.norm_squared()
}
