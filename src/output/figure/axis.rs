//! Where an axis begins and ends, where its ticks are and what they say.
//!
//! Owns the map from values to a fraction of the axis. Powers of ten are read from decimal text, so
//! a tick at 0.3 is the number 0.3.

use super::model::{Axis, Scale};
use super::symbol::{Scaled, decimal, power_of_ten, scaled};

/// An axis with its range and ticks settled.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ruler {
    /// Label with the drawn unit.
    pub(super) label: String,
    /// Ticks with a number: value in SI and text.
    pub(super) major: Vec<(f64, String)>,
    /// Ticks without a number.
    pub(super) minor: Vec<f64>,
    scale: Scale,
    /// Value at the start.
    pub(super) low: f64,
    /// Value at the end.
    pub(super) high: f64,
}

impl Ruler {
    /// The ruler of `axis` for values between `low` and `high`, both included.
    ///
    /// The range grows to whole ticks, so nothing is clipped. Preconditions: `low <= high`, both
    /// finite, both positive on a logarithmic axis ([`super::Figure::check`]).
    pub(super) fn new(axis: &Axis, low: f64, high: f64) -> Self {
        let (low, high) = axis.range.unwrap_or((low, high));
        debug_assert!(low <= high && low.is_finite() && high.is_finite());
        let mut ruler = match axis.scale {
            Scale::Linear => Self::linear(axis, low, high),
            Scale::Logarithmic => Self::logarithmic(axis, low, high),
        };
        if axis.range.is_some() {
            // ends where it is asked to, not at the next whole tick
            let slack = 1e-9 * (high - low);
            ruler.major.retain(|(value, _)| (low - slack..=high + slack).contains(value));
            ruler.minor.retain(|value| (low - slack..=high + slack).contains(value));
            (ruler.low, ruler.high) = (low, high);
        }
        ruler
    }

    /// Fraction of the axis at which `value` lies, 0 at its start and 1 at its end.
    pub(super) fn fraction(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Logarithmic => libm::log10(value / self.low) / libm::log10(self.high / self.low),
        }
    }

    fn linear(axis: &Axis, low: f64, high: f64) -> Self {
        let (low, high) = widened(low, high);
        let unit = scaled(&axis.unit, low.abs().max(high.abs()));
        let (factor, power) = step((high - low) / 5.0);
        let size = ten(factor, power);
        // A tick that a value misses by round-off need not be followed by another.
        let first = libm::floor(low / size + 1e-9) as i64;
        let last = libm::ceil(high / size - 1e-9) as i64;
        let decimals = usize::try_from(unit.exponent - power).unwrap_or(0);
        let drawn = |i: i64| decimal(ten(i * factor, power - unit.exponent), decimals);
        let major: Vec<(f64, String)> = (first..=last).map(|i| (ten(i * factor, power), drawn(i))).collect();
        let (low, high) = (low.min(ten(first * factor, power)), high.max(ten(last * factor, power)));
        Self { label: label(axis, &unit), major, minor: Vec::new(), scale: axis.scale, low, high }
    }

    fn logarithmic(axis: &Axis, low: f64, high: f64) -> Self {
        let decade = |value: f64| libm::floor(libm::log10(value)) as i32;
        let (bottom, top) = (decade(low), decade(high));
        // Below two decades the marks 1, 2, 5 carry numbers, above only the decades.
        let short = high / low < 100.0;
        let marks: &[i64] = if short { &[1, 2, 5] } else { &[1] };
        let all = |factors: &[i64]| -> Vec<(i64, i32)> {
            (bottom..=top + 1).flat_map(|e| factors.iter().map(move |&m| (m, e))).collect()
        };
        let candidates = all(marks);
        let value = |&(m, e): &(i64, i32)| ten(m, e);
        let start = candidates.iter().rposition(|c| value(c) <= low).unwrap_or(0);
        let end = candidates.iter().position(|c| value(c) >= high).unwrap_or(candidates.len() - 1);
        let end = if end > start { end } else { start + 1 };
        let range = &candidates[start..=end];
        let (low, high) = (value(&range[0]), value(&range[range.len() - 1]));
        let thin = usize::try_from(top - bottom).unwrap_or(0) / 8 + 1;
        let major: Vec<(f64, String)> = range
            .iter()
            .enumerate()
            .filter(|(i, _)| i % thin == 0)
            .map(|(_, mark)| (value(mark), logarithmic_text(mark)))
            .collect();
        let minor = all(&[1, 2, 3, 4, 5, 6, 7, 8, 9]).iter().map(value).collect::<Vec<_>>();
        let minor = minor.into_iter().filter(|v| (low..=high).contains(v)).collect();
        let unit = Scaled { exponent: 0, ..scaled(&axis.unit, 1.0) };
        Self { label: label(axis, &unit), major, minor, scale: axis.scale, low, high }
    }
}

/// `m · 10^e` as a tick says it.
fn logarithmic_text(&(m, e): &(i64, i32)) -> String {
    match m {
        1 => power_of_ten(e),
        _ => format!("{m}·{}", power_of_ten(e)),
    }
}

/// The range with some width, where a single value has none.
fn widened(low: f64, high: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    if high - low > 1e-12 * size {
        (low, high)
    } else if size == 0.0 {
        (-1.0, 1.0)
    } else {
        (low - 0.1 * size, high + 0.1 * size)
    }
}

/// The least of 1, 2, 5 times a power of ten that is not below `least`, as factor and power.
fn step(least: f64) -> (i64, i32) {
    let power = libm::floor(libm::log10(least)) as i32;
    let enough = [1, 2, 5].into_iter().find(|&factor| ten(factor, power) >= least);
    enough.map_or((1, power + 1), |factor| (factor, power))
}

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
pub(super) fn round_below(most: f64) -> f64 {
    let power = libm::floor(libm::log10(most)) as i32;
    let candidates = [ten(5, power), ten(2, power), ten(1, power), ten(5, power - 1)];
    candidates.into_iter().find(|&length| length <= most).unwrap_or(most)
}

/// `m · 10^e`, correctly rounded because it is read as decimal text.
pub(super) fn ten(m: i64, e: i32) -> f64 {
    format!("{m}e{e}").parse().expect("an integer, `e` and an integer are a number")
}

fn label(axis: &Axis, unit: &Scaled) -> String {
    match unit.text.as_str() {
        "" => axis.label.clone(),
        text => format!("{} [{text}]", axis.label),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn axis(unit: &str, scale: Scale) -> Axis {
        Axis { label: "d".into(), unit: unit.into(), scale, range: None }
    }

    fn texts(ruler: &Ruler) -> String {
        ruler.major.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn linear_ticks_are_round_and_in_the_drawn_unit() {
        let ruler = Ruler::new(&axis("m", Scale::Linear), 0.0, 0.002009);
        assert_eq!((ruler.label.as_str(), texts(&ruler).as_str()), ("d [mm]", "0.0 0.5 1.0 1.5 2.0 2.5"));
        let ruler = Ruler::new(&axis("Pa", Scale::Linear), -2e4, 13.8e6);
        assert_eq!((ruler.label.as_str(), texts(&ruler).as_str()), ("d [MPa]", "−5 0 5 10 15"));
        assert_eq!(ruler.major[2].0, 5e6);
    }

    #[test]
    fn logarithmic_ticks_are_decades_or_one_two_five() {
        let ruler = Ruler::new(&axis("m", Scale::Logarithmic), 2e-5, 0.3);
        assert_eq!((ruler.label.as_str(), texts(&ruler).as_str()), ("d [m]", "10⁻⁵ 10⁻⁴ 10⁻³ 10⁻² 10⁻¹ 10⁰"));
        let ruler = Ruler::new(&axis("", Scale::Logarithmic), 0.11, 0.9);
        assert_eq!(texts(&ruler), "10⁻¹ 2·10⁻¹ 5·10⁻¹ 10⁰");
        assert_eq!(ruler.fraction(0.1), 0.0);
        assert_eq!(ruler.fraction(1.0), 1.0);
    }

    #[test]
    fn a_single_value_gets_a_range_around_it() {
        for value in [0.0, 3.0, -1e-7] {
            let ruler = Ruler::new(&axis("", Scale::Linear), value, value);
            assert!(ruler.fraction(value) > 0.05 && ruler.fraction(value) < 0.95, "{ruler:?}");
        }
        let ruler = Ruler::new(&axis("", Scale::Logarithmic), 10.0, 10.0);
        assert!((0.0..=1.0).contains(&ruler.fraction(10.0)) && ruler.major.len() > 1);
    }

    #[test]
    fn an_axis_of_a_given_range_ends_there_with_the_whole_ticks_inside() {
        let range = Some((0.3e-3, 2.2e-3));
        let ruler = Ruler::new(&Axis { range, ..axis("m", Scale::Linear) }, 0.0, 1.0);
        assert_eq!(texts(&ruler), "0.5 1.0 1.5 2.0");
        assert_eq!((ruler.fraction(0.3e-3), ruler.fraction(2.2e-3)), (0.0, 1.0));
    }

    proptest! {
        #[test]
        fn every_value_lies_on_the_axis_between_two_and_twelve_ticks(
            low in -1e6..1e6f64, width in 1e-5..1e6f64, power in -6..6i32
        ) {
            let (low, high) = (low * ten(1, power), (low + width) * ten(1, power));
            let ruler = Ruler::new(&axis("m", Scale::Linear), low, high);
            prop_assert!(ruler.fraction(low) >= 0.0 && ruler.fraction(high) <= 1.0);
            prop_assert!((2..=12).contains(&ruler.major.len()));
        }

        #[test]
        fn every_positive_value_lies_on_a_logarithmic_axis(low in 1e-12..1e6f64, ratio in 1.0..1e12f64) {
            let ruler = Ruler::new(&axis("", Scale::Logarithmic), low, low * ratio);
            prop_assert!(ruler.fraction(low) >= -1e-12 && ruler.fraction(low * ratio) <= 1.0 + 1e-12);
            prop_assert!((2..=12).contains(&ruler.major.len()));
        }
    }
}
