//! Unit symbols: `kPa`, `kg/m^3`, `Pa^-1`, `N*s/mm^2`.
//!
//! A unit is an exact power of ten times, for the few non-decimal units, a factor; the power is kept
//! apart so that `0.125 mm` is the same `f64` as `0.125e-3`.

use super::dimension::{Dimension, Exponent};
use std::fmt;

/// A unit: what one of it is in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its dimension.
    pub dimension: Dimension,
    /// Power of ten.
    ten: i32,
    /// What is not a power of ten: `π/180` for a degree, else 1.
    other: f64,
}

impl Unit {
    /// SI value of one unit.
    pub fn factor(&self) -> f64 {
        self.to_si(1.0)
    }

    /// SI value of `value` units.
    ///
    /// For decimal units the result is what the number would be, written in SI: `0.03 ms` is `3e-5` to the
    /// last bit. The point of the shortest decimal that reads as `value` is moved, which is the decimal
    /// that was written wherever that had at most 15 digits.
    pub fn to_si(&self, value: f64) -> f64 {
        move_point(value * self.other, self.ten)
    }
}

/// `value · 10ⁿ`, rounded once from the shortest decimal that reads as `value`.
fn move_point(value: f64, n: i32) -> f64 {
    if n == 0 {
        return value;
    }
    let shortest = format!("{value:e}");
    let (digits, exponent) = shortest.split_once('e').unwrap_or((&shortest, "0"));
    let moved = exponent.parse::<i32>().unwrap_or(0).saturating_add(n);
    // An infinity or NaN has no exponent and stays what it is.
    format!("{digits}e{moved}").parse().unwrap_or(value)
}

/// Why a text is not a unit.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnitError {
    /// No unit of this symbol.
    Unknown {
        /// The symbol as written.
        symbol: String,
        /// Byte offset of the symbol in the text.
        offset: usize,
        /// The unit most like it, if any is.
        suggestion: Option<&'static str>,
    },
    /// Not of the form `a*b/c^2`.
    Malformed {
        /// Byte offset of the first character that does not fit.
        offset: usize,
    },
    /// An exponent or the factor leaves the representable range.
    OutOfRange,
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { symbol, .. } => write!(f, "there is no unit `{symbol}`"),
            Self::Malformed { .. } => {
                f.write_str("a unit is a product of powers such as `kg/m^3` or `Pa^-1`")
            }
            Self::OutOfRange => f.write_str("the unit is too large or too small for a number"),
        }
    }
}

impl std::error::Error for UnitError {}

const PER_DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Symbol, dimension, power of ten, other factor, prefixes in use.
type Row = (&'static str, Dimension, i32, f64, &'static [&'static str]);

const ROWS: &[Row] = &[
    ("m", Dimension::LENGTH, 0, 1.0, &["k", "c", "m", "u", "µ", "μ", "n"]),
    ("g", Dimension::MASS, -3, 1.0, &["k", "m", "u", "µ", "μ"]),
    ("t", Dimension::MASS, 3, 1.0, &[]),
    ("s", Dimension::TIME, 0, 1.0, &["m", "u", "µ", "μ", "n"]),
    ("min", Dimension::TIME, 0, 60.0, &[]),
    ("h", Dimension::TIME, 0, 3600.0, &[]),
    ("N", Dimension::FORCE, 0, 1.0, &["M", "k", "m", "u", "µ", "μ", "n"]),
    ("dyn", Dimension::FORCE, -5, 1.0, &[]),
    ("Pa", Dimension::PRESSURE, 0, 1.0, &["G", "M", "k", "h", "m", "u", "µ", "μ"]),
    ("bar", Dimension::PRESSURE, 5, 1.0, &["m"]),
    // Conventional millimetre of mercury: 13 595.1 kg/m³ · 9.80665 m/s² · 1 mm.
    ("mmHg", Dimension::PRESSURE, 0, 133.322_387_415, &[]),
    // Pound-force (0.45359237 kg · 9.80665 m/s²) on a square inch (0.0254 m)².
    ("psi", Dimension::PRESSURE, 0, 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254), &[]),
    ("J", Dimension::ENERGY, 0, 1.0, &["M", "k", "m", "u", "µ", "μ", "n"]),
    ("W", Dimension::whole(2, 1, -3), 0, 1.0, &["M", "k", "m", "u", "µ", "μ"]),
    ("Hz", Dimension::FREQUENCY, 0, 1.0, &["M", "k"]),
    ("rad", Dimension::NUMBER, 0, 1.0, &["m"]),
    ("deg", Dimension::NUMBER, 0, PER_DEGREE, &[]),
    ("%", Dimension::NUMBER, -2, 1.0, &[]),
];

const PREFIXES: &[(&str, i32)] = &[
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("µ", -6), // micro sign
    ("μ", -6), // Greek mu
    ("n", -9),
];

/// All symbols with their prefixes, in a fixed order; micro is listed as `u` only.
pub fn unit_symbols() -> &'static [&'static str] {
    &[
        "m", "km", "cm", "mm", "um", "nm", "g", "kg", "mg", "ug", "t", "s", "ms", "us", "ns", "min", "h",
        "N", "MN", "kN", "mN", "uN", "nN", "dyn", "Pa", "GPa", "MPa", "kPa", "hPa", "mPa", "uPa", "bar",
        "mbar", "mmHg", "psi", "J", "MJ", "kJ", "mJ", "uJ", "nJ", "W", "MW", "kW", "mW", "uW", "Hz", "MHz",
        "kHz", "rad", "mrad", "deg", "%",
    ]
}

fn lookup(symbol: &str) -> Option<Unit> {
    let unit = |row: &Row, ten| Unit { dimension: row.1, ten: row.2 + ten, other: row.3 };
    if let Some(row) = ROWS.iter().find(|row| row.0 == symbol) {
        return Some(unit(row, 0));
    }
    ROWS.iter().find_map(|row| {
        let prefix = symbol.strip_suffix(row.0).filter(|p| row.4.contains(p))?;
        let (_, ten) = PREFIXES.iter().find(|(p, _)| *p == prefix)?;
        Some(unit(row, *ten))
    })
}

fn nearest(symbol: &str) -> Option<&'static str> {
    let lower = symbol.to_lowercase();
    if let Some(same) = unit_symbols().iter().find(|u| u.to_lowercase() == lower) {
        return Some(same);
    }
    const WORDS: &[(&str, &str)] = &[
        ("metre", "m"),
        ("meter", "m"),
        ("millimetre", "mm"),
        ("millimeter", "mm"),
        ("second", "s"),
        ("sec", "s"),
        ("newton", "N"),
        ("pascal", "Pa"),
        ("kilopascal", "kPa"),
        ("joule", "J"),
        ("degree", "deg"),
        ("degrees", "deg"),
        ("percent", "%"),
        ("radian", "rad"),
        ("gram", "g"),
        ("tonne", "t"),
        ("hertz", "Hz"),
    ];
    let word = lower.strip_suffix('s').unwrap_or(&lower);
    if let Some((_, unit)) = WORDS.iter().find(|(w, _)| *w == word || *w == lower) {
        return Some(unit);
    }
    unit_symbols()
        .iter()
        .map(|u| (strsim::damerau_levenshtein(u, symbol), *u))
        .filter(|(distance, u)| *distance == 1 && u.len() > 1)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, u)| u)
}

/// Reads a unit: symbols joined by `*`, `·` and `/`, each with an optional power `^2`, `^-1`, `^(1/2)`;
/// a leading `1/` is allowed. Division binds to the next symbol only: `a/b*c` is `(a/b)*c`.
///
/// # Errors
/// [`UnitError`] says what is unknown or where the form breaks.
pub fn parse_unit(text: &str) -> Result<Unit, UnitError> {
    let mut reader = Reader { text, at: 0 };
    let mut unit = Unit { dimension: Dimension::NUMBER, ten: 0, other: 1.0 };
    let mut sign = 1;
    if text.starts_with("1/") {
        reader.at = 2;
        sign = -1;
    }
    loop {
        let (symbol, power) = (reader.symbol()?, reader.power()?);
        unit = times(unit, symbol, sign * i64::from(power.numerator()), i64::from(power.denominator()))?;
        sign = match reader.next() {
            None => break,
            Some('*' | '·') => 1,
            Some('/') => -1,
            Some(c) => return Err(UnitError::Malformed { offset: reader.at - c.len_utf8() }),
        };
    }
    let factor = unit.factor();
    if factor.is_normal() && unit.dimension.is_representable() {
        Ok(unit)
    } else {
        Err(UnitError::OutOfRange)
    }
}

fn times(a: Unit, b: Unit, numerator: i64, denominator: i64) -> Result<Unit, UnitError> {
    let dimension = a.dimension * b.dimension.powr(numerator, denominator);
    let ten = i64::from(b.ten) * numerator;
    let decimal = ten % denominator == 0;
    let ten_whole = i32::try_from(i64::from(a.ten) + if decimal { ten / denominator } else { 0 })
        .map_err(|_| UnitError::OutOfRange)?;
    let mut other = a.other;
    let power = numerator as f64 / denominator as f64;
    if b.other != 1.0 {
        other *= libm::pow(b.other, power);
    }
    if !decimal {
        other *= libm::pow(10.0, f64::from(b.ten) * power);
    }
    Ok(Unit { dimension, ten: ten_whole, other })
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn next(&mut self) -> Option<char> {
        let c = self.rest().chars().next()?;
        self.at += c.len_utf8();
        Some(c)
    }

    fn symbol(&mut self) -> Result<Unit, UnitError> {
        let offset = self.at;
        let end = self.rest().find(|c: char| !(c.is_alphabetic() || c == '_' || c == '%'));
        let symbol = &self.rest()[..end.unwrap_or(self.rest().len())];
        if symbol.is_empty() {
            return Err(UnitError::Malformed { offset });
        }
        let found = lookup(symbol).ok_or_else(|| UnitError::Unknown {
            symbol: symbol.into(),
            offset,
            suggestion: nearest(symbol),
        })?;
        self.at += symbol.len();
        Ok(found)
    }

    fn power(&mut self) -> Result<Exponent, UnitError> {
        let Some(rest) = self.rest().strip_prefix('^') else {
            return Ok(Exponent::whole(1));
        };
        let start = self.at + 1;
        let malformed = UnitError::Malformed { offset: start };
        let (numerator, denominator, length) = if let Some(inner) = rest.strip_prefix('(') {
            let close = inner.find(')').ok_or_else(|| malformed.clone())?;
            let (n, d) = inner[..close].split_once('/').unwrap_or((&inner[..close], "1"));
            (n, d, close + 2)
        } else {
            let digits = rest.strip_prefix(['-', '+']).unwrap_or(rest);
            let sign = rest.len() - digits.len();
            let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
            (&rest[..sign + end], "1", sign + end)
        };
        let whole = |text: &str| text.parse::<i16>().map_err(|_| malformed.clone());
        let exponent = Exponent::new(i64::from(whole(numerator)?), i64::from(whole(denominator)?));
        self.at = start + length;
        if exponent == Exponent::UNREPRESENTABLE { Err(malformed) } else { Ok(exponent) }
    }
}

#[cfg(test)]
mod tests;
