//! The observed order of a convergence study.
//!
//! Owns the exponent of `|y| = c xᵖ` from a few pairs. Knows no tables.

/// Exponent of `|y|` in the first varied column, of several combinations of the others the smallest.
///
/// ```text
/// least squares        p = Σ (ξ − ξ̄)(η − η̄) / Σ (ξ − ξ̄)²,   ξ = ln x, η = ln |y|
/// between neighbours   p = min ln |y₂/y₁| / ln (x₂/x₁),        neighbours in the order of x
/// ```
///
/// | argument | meaning |
/// |---|---|
/// | `varied` | columns of the varied values, the one the order runs over first |
/// | `values` | the column |
/// | `between_neighbours` | the smallest between neighbours instead of least squares over all |
///
/// # Errors
/// What makes an order meaningless: a value that is zero or no number, an abscissa that is not
/// positive, fewer than two points.
pub fn order(varied: &[Vec<f64>], values: &[f64], between_neighbours: bool) -> Result<f64, String> {
    let Some((abscissa, others)) = varied.split_first() else {
        return Err("nothing varies".into());
    };
    if let Some(bad) = abscissa.iter().find(|x| !(x.is_finite() && **x > 0.0)) {
        return Err(format!("an order needs positive abscissae, but one is {bad:e}"));
    }
    if let Some(bad) = values.iter().find(|y| !y.is_finite() || **y == 0.0) {
        return Err(format!("an order needs values that are not zero, but one is {bad:e}"));
    }
    let mut least: Option<f64> = None;
    for group in groups(others, values.len()) {
        let mut points: Vec<(f64, f64)> =
            group.iter().map(|&i| (libm::log(abscissa[i]), libm::log(values[i].abs()))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        if points.len() < 2 {
            return Err("an order needs two points or more".into());
        }
        let found = if between_neighbours { neighbours(&points) } else { slope(&points) };
        least = Some(least.map_or(found, |least| least.min(found)));
    }
    least.ok_or_else(|| "there is no point".into())
}

/// Rows that agree in every other varied value, in the order of their first.
fn groups(others: &[Vec<f64>], rows: usize) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for row in 0..rows {
        let same = |group: &&mut Vec<usize>| others.iter().all(|column| column[group[0]] == column[row]);
        match groups.iter_mut().find(same) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups
}

fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    covariance / variance
}

fn neighbours(points: &[(f64, f64)]) -> f64 {
    points
        .windows(2)
        .map(|pair| (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0))
        .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPACING: [f64; 4] = [0.4, 0.2, 0.1, 0.05];

    #[test]
    fn a_power_is_found_exactly_in_any_order_of_the_points_and_of_either_sign() {
        let error = SPACING.map(|h| -3.0 * h.powi(2));
        for between in [false, true] {
            let found = order(&[SPACING.to_vec()], &error, between).expect("an order");
            // logarithms below 4, each good to a round-off, over a difference of at least ln 2
            assert!((found - 2.0).abs() < 1e-14, "{found}");
            let mut x = SPACING.to_vec();
            let mut y = error.to_vec();
            x.swap(0, 2);
            y.swap(0, 2);
            let found = order(&[x], &y, between).expect("an order");
            assert!((found - 2.0).abs() < 1e-14, "{found}");
        }
    }

    #[test]
    fn a_stalling_error_shows_between_neighbours_and_less_over_all() {
        let error = [0.16, 0.04, 0.01, 0.01];
        let over_all = order(&[SPACING.to_vec()], &error, false).expect("an order");
        assert!(order(&[SPACING.to_vec()], &error, true).expect("an order").abs() < 1e-14);
        // by hand: abscissae -3/2, -1/2, 1/2, 3/2 and ordinates 0, 0, 2, 4 in units of ln 2
        assert!((over_all - (0.5 * 2.0 + 1.5 * 4.0) / 5.0).abs() < 1e-14, "{over_all}");
    }

    #[test]
    fn of_several_combinations_the_worst_counts() {
        let (x, scheme) = (vec![0.2, 0.1, 0.2, 0.1], vec![1.0, 1.0, 2.0, 2.0]);
        let found = order(&[x, scheme], &[4.0, 1.0, 4.0, 2.0], false).expect("an order");
        assert!((found - 1.0).abs() < 1e-14);
    }

    #[test]
    fn what_has_no_order_says_why() {
        let one = |x: &[f64], y: &[f64]| order(&[x.to_vec()], y, false).expect_err("no order");
        assert!(one(&[0.1, 0.2], &[1.0, 0.0]).contains("not zero"));
        assert!(one(&[0.0, 0.2], &[1.0, 2.0]).contains("positive"));
        assert!(one(&[0.1, 0.2], &[1.0, f64::NAN]).contains("NaN"));
        assert!(one(&[0.1], &[1.0]).contains("two points"));
    }
}
