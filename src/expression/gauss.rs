//! Gauss's rule of quadrature.
//!
//! Owns the nodes and weights of one interval; who integrates what is decided elsewhere.

/// Newton steps after which a root no longer moves; five are the most seen up to 512 points.
const STEPS: usize = 12;

/// Nodes in `(0, 1)`, ascending, and weights of sum 1: exact for polynomials of degree `2 count − 1`.
///
/// ```text
/// P_n(2 x_i − 1) = 0,    w_i = 1/((1 − t_i²) P_n'(t_i)²),   t_i = 2 x_i − 1
/// ```
///
/// Symmetric to the last bit: `x_i = 1 − x_(n+1−i)` up to the rounding of the difference.
pub fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    (1..=count)
        .map(|i| {
            // both halves from the same root, so that the rule is symmetric
            let mirrored = 2 * i > count + 1;
            let place = if mirrored { count + 1 - i } else { i } as f64;
            let mut t = libm::cos(std::f64::consts::PI * (place - 0.25) / (n + 0.5));
            let mut slope = 1.0;
            for _ in 0..STEPS {
                let value;
                (value, slope) = legendre(count, t);
                let step = value / slope;
                t -= step;
                if step.abs() < 1e-17 {
                    break;
                }
            }
            if 2 * i == count + 1 {
                t = 0.0;
                slope = legendre(count, t).1;
            }
            let half = 0.5 * t;
            (if mirrored { 0.5 + half } else { 0.5 - half }, 1.0 / ((1.0 - t * t) * slope * slope))
        })
        .collect()
}

/// `P_n(t)` and `P_n'(t)` by the three-term recurrence.
fn legendre(n: usize, t: f64) -> (f64, f64) {
    let (mut last, mut this) = (1.0, t);
    for k in 2..=n {
        let k = k as f64;
        (last, this) = (this, ((2.0 * k - 1.0) * t * this - (k - 1.0) * last) / k);
    }
    if n == 0 {
        return (1.0, 0.0);
    }
    (this, n as f64 * (t * this - last) / (t * t - 1.0))
}

#[cfg(test)]
mod tests {
    use super::gauss_legendre;

    #[test]
    fn a_rule_of_n_points_integrates_powers_up_to_2n_minus_1_and_no_further() {
        for count in [1, 2, 3, 8, 17, 40, 129] {
            let rule = gauss_legendre(count);
            let error = |power: usize| {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                (sum * (power as f64 + 1.0) - 1.0).abs()
            };
            for power in 0..2 * count {
                // `count` products, each rounded, and a power of nodes rounded to 1e-16
                assert!(error(power) < 1e-14 * (1.0 + power as f64), "{count} {power} {}", error(power));
            }
            if count <= 8 {
                assert!(error(2 * count) > 1e-10, "{count}: a control");
            }
        }
    }
}
