//! Lattice lines: how many between given marks, and by how much nodes are displaced at random.
//!
//! Owns the division of lengths by a spacing and the random numbers of jitter. Knows no shape.

use super::error::DiscretisationError;

/// Most nodes a body may have.
pub(super) const LIMIT: u32 = 100_000_000;

/// Seed of the random displacement; part of the definition of a jittered lattice.
const SEED: u64 = 0x7469_7373_7565;

/// Lines along one axis: the marks, and what divides the intervals between them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    /// Marks every line through which is wanted, ascending, m.
    pub marks: Vec<f64>,
}

impl Axis {
    /// Lengths between the marks, m.
    pub fn lengths(&self) -> impl Iterator<Item = f64> + '_ {
        self.marks.windows(2).map(|w| w[1] - w[0])
    }

    /// All lines, the marks exactly among them; `count` has the cells of each interval.
    pub fn lines(&self, count: &[usize]) -> Vec<f64> {
        let mut lines = vec![self.marks[0]];
        for (interval, &n) in self.marks.windows(2).zip(count) {
            let at = |i: usize| interval[0] + (interval[1] - interval[0]) * (i as f64 / n as f64);
            lines.extend((1..n).map(at));
            lines.push(interval[1]);
        }
        lines
    }
}

/// Refuses a spacing or a jitter no lattice can have.
pub(super) fn checked(spacing: f64, jitter: f64) -> Result<(), DiscretisationError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(DiscretisationError::BadSpacing { spacing });
    }
    if !(0.0..0.5).contains(&jitter) {
        return Err(DiscretisationError::BadJitter { jitter });
    }
    Ok(())
}

/// Cells of each length: the whole number nearest to length over spacing, at least one.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `lengths` | positive lengths | m |
/// | `spacing` | spacing asked for | m |
/// | `evenness` | greatest ratio of two spacings that come out | – |
pub(super) fn divide(
    lengths: &[f64],
    spacing: f64,
    evenness: f64,
) -> Result<Vec<usize>, DiscretisationError> {
    let (least, greatest) = outcome(lengths, spacing);
    if greatest > evenness * least {
        let suggestion = suggestion(lengths, spacing, evenness);
        return Err(DiscretisationError::UnevenSpacing { requested: spacing, least, greatest, suggestion });
    }
    Ok(lengths.iter().map(|l| cells(*l, spacing) as usize).collect())
}

fn cells(length: f64, spacing: f64) -> f64 {
    (length / spacing).round().max(1.0)
}

/// Least and greatest spacing that come out.
fn outcome(lengths: &[f64], spacing: f64) -> (f64, f64) {
    let actual = lengths.iter().map(|l| l / cells(*l, spacing));
    actual.fold((f64::INFINITY, 0.0), |(least, greatest), d| (d.min(least), d.max(greatest)))
}

/// The spacing nearest to the one asked for that divides the shortest length and all others evenly enough.
fn suggestion(lengths: &[f64], spacing: f64, evenness: f64) -> f64 {
    let shortest = lengths.iter().fold(f64::INFINITY, |s, &l| l.min(s));
    let most = (4.0 * shortest / spacing).ceil().clamp(60.0, 1e5) as usize;
    let even = |d: f64| {
        let (least, greatest) = outcome(lengths, d);
        greatest <= evenness * least
    };
    let distance = |d: f64| if d > spacing { d / spacing } else { spacing / d };
    (1..=most)
        .map(|n| shortest / n as f64)
        .filter(|&d| even(d))
        .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
        // 60 cells along the shortest length leave every other within 1/120 of it
        .expect("a fine enough spacing is even")
}

/// A number in [−1, 1) that depends on `n` alone: the 53 leading bits of SplitMix64.
pub(super) fn random(n: usize) -> f64 {
    let mut z = SEED.wrapping_add((n as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 * (2.0 / (1u64 << 53) as f64) - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_uneven_division_is_refused_and_the_suggestion_is_accepted() {
        for (lengths, spacing) in
            [([1.0, 0.33, 0.09], 0.06), ([10.0, 3.0, 0.5], 0.4), ([1.0, 1.0, 1e-3], 0.1)]
        {
            let error = divide(&lengths, spacing, 1.05).unwrap_err();
            let DiscretisationError::UnevenSpacing { suggestion, least, greatest, .. } = error else {
                panic!("{error}")
            };
            assert!(greatest > 1.05 * least);
            let count = divide(&lengths, suggestion, 1.05).unwrap();
            for (l, n) in lengths.iter().zip(count) {
                assert!((l / n as f64 / suggestion - 1.0).abs() < 0.05);
            }
        }
    }

    #[test]
    fn lines_take_every_mark_to_the_last_bit() {
        let axis = Axis { marks: vec![-0.1, 0.2, 0.7] };
        let lines = axis.lines(&[3, 5]);
        assert_eq!((lines[0], lines[3], lines[8], lines.len()), (-0.1, 0.2, 0.7, 9));
        assert!(lines.is_sorted());
    }

    #[test]
    fn random_numbers_fill_their_range_evenly() {
        let numbers: Vec<f64> = (0..10_000).map(random).collect();
        assert!(numbers.iter().all(|x| (-1.0..1.0).contains(x)));
        let mean = numbers.iter().sum::<f64>() / 1e4;
        let square = numbers.iter().map(|x| x * x).sum::<f64>() / 1e4;
        // four standard deviations: 4 (1/3)^½ / 100 and 4 (4/45)^½ / 100
        assert!(mean.abs() < 0.023 && (square - 1.0 / 3.0).abs() < 0.012, "{mean} {square}");
    }
}
