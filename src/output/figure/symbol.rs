//! Units and numbers as a reader expects them: prefixes, superscripts, a true minus sign.
//!
//! Owns typography only; values stay in SI.

/// A unit to draw and how many SI units it is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scaled {
    /// What stands in the brackets of the label, empty for a bare number.
    pub(super) text: String,
    /// Power of ten of the drawn unit, in SI units.
    pub(super) exponent: i32,
}

/// Units that take a prefix as they stand.
const PREFIXED: [&str; 7] = ["m", "s", "Pa", "N", "J", "W", "Hz"];
const PREFIXES: [(i32, &str); 8] =
    [(-12, "p"), (-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G")];

/// The drawn unit for values up to `largest` in size: 0.002 m is 2 mm, 0.2 N stays.
///
/// The drawn values lie within [0.1, 100) where a prefix exists; units that take none get a power of
/// ten outside [0.01, 10 000).
pub(super) fn scaled(unit: &str, largest: f64) -> Scaled {
    let plain = Scaled { text: superscript_unit(unit), exponent: 0 };
    if largest <= 0.0 || unit == "rad" || unit == "deg" {
        return plain;
    }
    let exponent = 3 * (libm::floor((libm::log10(largest) + 1.0) / 3.0) as i32);
    if PREFIXED.contains(&unit) {
        let prefix = PREFIXES.iter().find(|(power, _)| *power == exponent);
        if let Some((_, prefix)) = prefix {
            return Scaled { text: format!("{prefix}{unit}"), exponent };
        }
    } else if (0.01..1e4).contains(&largest) {
        return plain;
    }
    if exponent == 0 {
        return plain;
    }
    Scaled { text: format!("{} {}", power_of_ten(exponent), plain.text).trim_end().into(), exponent }
}

/// `kg m^-3` with its exponents raised.
fn superscript_unit(unit: &str) -> String {
    let mut text = String::new();
    let mut raised = false;
    for c in unit.chars() {
        raised = (raised && (c.is_ascii_digit() || c == '-')) || c == '^';
        match (c, raised) {
            ('^', _) => {}
            (c, true) => text.push(superscript(c)),
            (c, false) => text.push(c),
        }
    }
    text
}

/// `10` with a raised exponent.
pub(super) fn power_of_ten(exponent: i32) -> String {
    let raised: String = exponent.to_string().chars().map(superscript).collect();
    format!("10{raised}")
}

fn superscript(c: char) -> char {
    match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        '4'..='9' => char::from_u32('⁴' as u32 + (c as u32 - '4' as u32)).unwrap_or(c),
        other => other,
    }
}

/// `value` with `decimals` places and a true minus sign; zero has no sign.
pub(super) fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{:.*}", decimals, value.abs());
    let is_zero = text.bytes().all(|b| b == b'0' || b == b'.');
    if value < 0.0 && !is_zero { format!("−{text}") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_take_the_prefix_that_leaves_short_numbers() {
        let drawn = |unit, largest| scaled(unit, largest);
        assert_eq!(drawn("m", 0.002), Scaled { text: "mm".into(), exponent: -3 });
        assert_eq!(drawn("N", 1.94), Scaled { text: "N".into(), exponent: 0 });
        assert_eq!(drawn("N", 0.2), Scaled { text: "N".into(), exponent: 0 });
        assert_eq!(drawn("Pa", 13.8e6), Scaled { text: "MPa".into(), exponent: 6 });
        assert_eq!(drawn("", 1.5), Scaled { text: String::new(), exponent: 0 });
        assert_eq!(drawn("", 8e-6), Scaled { text: "10⁻⁶".into(), exponent: -6 });
        assert_eq!(drawn("kg m^-2 s^-1", 2e5), Scaled { text: "10⁶ kg m⁻² s⁻¹".into(), exponent: 6 });
        assert_eq!(drawn("m", 0.0), Scaled { text: "m".into(), exponent: 0 });
    }

    #[test]
    fn numbers_have_a_true_minus_sign_and_no_negative_zero() {
        assert_eq!(decimal(-0.25, 2), "−0.25");
        assert_eq!(decimal(-0.001, 2), "0.00");
        assert_eq!(decimal(-0.0, 1), "0.0");
        assert_eq!(power_of_ten(-14), "10⁻¹⁴");
        assert_eq!(power_of_ten(56), "10⁵⁶");
    }
}
