//! Values between the rows of a table.
//!
//! Owns the two interpolations expectations use: records are dense and read linearly, references
//! are sparse and read by a spline.

/// Value of `y` where `x` first takes a value, linear between rows; `None` if it never does.
///
/// | argument | meaning |
/// |---|---|
/// | `x`, `y` | columns of one record, in order of time |
/// | `at` | the value of `x` asked for |
///
/// The error is that of linear interpolation, `⅛ (Δx)² y''`, with the record's own spacing.
pub fn crossing(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    if x.first() == Some(&at) {
        return y.first().copied();
    }
    let reaches = |pair: &[f64]| pair[1] == at || (pair[0] - at) * (pair[1] - at) < 0.0;
    let i = x.windows(2).position(reaches)?;
    if x[i + 1] == at {
        return Some(y[i + 1]);
    }
    let share = (at - x[i]) / (x[i + 1] - x[i]);
    Some(y[i] + share * (y[i + 1] - y[i]))
}

/// Value of a reference curve: a cubic spline through its rows.
///
/// Where the abscissa is positive and spans two decades or more, as the force of a stiffening
/// tissue does, the spline runs over its logarithm; rows that are not positive are then left out.
/// An ordinate that does the same, as a stress over a force, is read by its logarithm as well: it is
/// nearly a power of the abscissa, thus nearly a line, while over the logarithm alone it is an
/// exponential. With three of four rows of a finite-element table withheld the first errs by up to
/// 2.4 % of the stress, the second by up to 10 %.
/// `None` outside the rows, for fewer than four of them, or for an abscissa that is not increasing.
pub fn reference_value(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    let largest = x.iter().copied().fold(0.0, f64::max);
    let positive: Vec<usize> = (0..x.len()).filter(|&i| x[i] > ROUND_OFF * largest).collect();
    let smallest = positive.iter().map(|&i| x[i]).fold(f64::INFINITY, f64::min);
    let logarithmic =
        at > 0.0 && largest >= WIDE * smallest && (0..x.len()).all(|i| x[i] >= -ROUND_OFF * largest);
    if logarithmic {
        let log_x: Vec<f64> = positive.iter().map(|&i| libm::log(x[i])).collect();
        let y: Vec<f64> = positive.iter().map(|&i| y[i]).collect();
        let (low, high) = y.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), &y| (l.min(y), h.max(y)));
        if low > 0.0 && high >= WIDE * low {
            let log_y: Vec<f64> = y.iter().map(|&y| libm::log(y)).collect();
            spline(&log_x, &log_y, libm::log(at)).map(libm::exp)
        } else {
            spline(&log_x, &y, libm::log(at))
        }
    } else {
        spline(x, y, at)
    }
}

/// Abscissae below this share of the largest are a zero with round-off.
const ROUND_OFF: f64 = 1e-12;

/// Ratio of the ends of a column from which its logarithm is the better variable.
const WIDE: f64 = 100.0;

/// Cubic spline with not-a-knot ends.
fn spline(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    let n = x.len();
    if n < 4 || x.windows(2).any(|pair| pair[1] <= pair[0]) || at < x[0] || at > x[n - 1] {
        return None;
    }
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slope: Vec<f64> = (0..n - 1).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    // second derivatives m: continuity of the slope inside, of the third derivative at both ends
    let mut matrix = nalgebra::DMatrix::zeros(n, n);
    let mut right = nalgebra::DVector::zeros(n);
    for i in 1..n - 1 {
        matrix[(i, i - 1)] = h[i - 1];
        matrix[(i, i)] = 2.0 * (h[i - 1] + h[i]);
        matrix[(i, i + 1)] = h[i];
        right[i] = 6.0 * (slope[i] - slope[i - 1]);
    }
    for (row, k) in [(0, 0), (n - 1, n - 3)] {
        matrix[(row, k)] = h[k + 1];
        matrix[(row, k + 1)] = -(h[k] + h[k + 1]);
        matrix[(row, k + 2)] = h[k];
    }
    let m = matrix.lu().solve(&right)?;
    let i = (0..n - 1).find(|&i| at <= x[i + 1])?;
    let (left, rest) = (at - x[i], x[i + 1] - at);
    Some(
        (m[i] * rest.powi(3) + m[i + 1] * left.powi(3)) / (6.0 * h[i])
            + (y[i] / h[i] - m[i] * h[i] / 6.0) * rest
            + (y[i + 1] / h[i] - m[i + 1] * h[i] / 6.0) * left,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly() {
        let x = [0.0, 0.5, 1.5, 2.0, 4.0];
        let cubic = |x: f64| 1.0 - 2.0 * x + 0.5 * x.powi(3);
        let y = x.map(cubic);
        for at in [0.1, 0.9, 1.7, 3.3] {
            let value = spline(&x, &y, at).expect("inside");
            // values below 30, some 50 operations
            assert!((value - cubic(at)).abs() <= 30.0 * 50.0 * f64::EPSILON);
        }
    }

    #[test]
    fn a_logarithm_over_three_decades_is_met_exactly() {
        let x = [0.0, 0.01, 0.1, 0.3, 2.0, 10.0];
        let y = x.map(|x: f64| if x > 0.0 { x.ln() } else { -1e9 });
        let value = reference_value(&x, &y, 0.7).expect("inside");
        assert!((value - 0.7_f64.ln()).abs() <= 5.0 * 50.0 * f64::EPSILON);
    }

    #[test]
    fn a_power_over_three_decades_is_met_to_round_off() {
        let x = [0.0, 0.01, 0.1, 0.3, 2.0, 10.0];
        let y = x.map(|x: f64| 3.0 * x.powf(1.1));
        let value = reference_value(&x, &y, 0.7).expect("inside");
        let exact = 3.0 * 0.7_f64.powf(1.1);
        // logarithms below 5, some 50 operations
        assert!((value / exact - 1.0).abs() <= 5.0 * 50.0 * f64::EPSILON);
    }

    /// Force in N and axial Cauchy stress in MPa at the centre, from the rows of
    /// `verification/references/fe_artery_circ_k0_D1e-7_Q2P1_20x6x2.csv`.
    #[test]
    fn withheld_rows_of_a_stress_are_read_to_half_a_per_cent() {
        let text = include_str!("../../verification/references/fe_artery_circ_k0_D1e-7_Q2P1_20x6x2.csv");
        let rows: Vec<Vec<f64>> = text
            .lines()
            .filter(|line| !line.starts_with('#'))
            .skip(1)
            .map(|line| line.split(',').filter_map(|cell| cell.parse().ok()).collect())
            .collect();
        let (force, stress): (Vec<f64>, Vec<f64>) = rows.iter().skip(1).map(|row| (row[1], row[6])).unzip();
        let last = force.len() - 1;
        let kept: Vec<usize> = (0..=last).filter(|i| (last - i) % 3 == 0).collect();
        let of = |column: &[f64]| -> Vec<f64> { kept.iter().map(|&i| column[i]).collect() };
        let (x, y) = (of(&force), of(&stress));
        let worst = |read: &dyn Fn(f64) -> Option<f64>| {
            let error = |i: usize| (read(force[i]).expect("inside") / stress[i] - 1.0).abs();
            let withheld = (0..=last).filter(|i| !kept.contains(i) && force[*i] > 0.08);
            withheld.map(error).fold(0.0, f64::max)
        };
        let log_x: Vec<f64> = x.iter().map(|&x| libm::log(x)).collect();
        // neighbours kept are five times apart: a fourth difference of some hundredths of the logarithm
        assert!(worst(&|at| reference_value(&x, &y, at)) < 0.005);
        // the logarithm of the force alone
        assert!(worst(&|at| spline(&log_x, &y, libm::log(at))) > 0.04);
    }

    #[test]
    fn the_first_crossing_counts_and_outside_there_is_none() {
        let x = [0.0, 1.0, 0.5, 2.0];
        let y = [0.0, 10.0, 20.0, 30.0];
        assert_eq!(crossing(&x, &y, 0.75), Some(7.5));
        // a row that has the value exactly does not win over an earlier crossing
        assert_eq!(crossing(&[0.0, 2.0, 1.0], &[0.0, 10.0, 20.0], 1.0), Some(5.0));
        assert_eq!(crossing(&x, &y, 3.0), None);
        assert_eq!(reference_value(&x, &y, 0.75), None);
    }
}
