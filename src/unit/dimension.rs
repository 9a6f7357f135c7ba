//! Dimensions: rational powers of length, mass and time.
//!
//! Owns their algebra. Their names are in `known`, the symbols of units in `symbol`.

use std::fmt;
use std::ops::{Div, Mul};

/// A rational exponent in lowest terms, with a positive denominator.
///
/// An exponent that leaves the range of `i16` becomes [`Exponent::UNREPRESENTABLE`], which absorbs
/// whatever it is combined with: like NaN it can never turn into a right answer again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Exponent {
    numerator: i16,
    denominator: i16,
}

impl Exponent {
    /// The exponent 0.
    pub const ZERO: Self = Self { numerator: 0, denominator: 1 };
    /// The result of an operation whose true value does not fit.
    pub const UNREPRESENTABLE: Self = Self { numerator: 0, denominator: 0 };

    /// A whole exponent.
    pub const fn whole(numerator: i16) -> Self {
        Self { numerator, denominator: 1 }
    }

    /// The exponent `numerator/denominator`; unrepresentable if the denominator is 0 or the fraction
    /// in lowest terms leaves the range of `i16`.
    pub fn new(numerator: i64, denominator: i64) -> Self {
        if denominator == 0 {
            return Self::UNREPRESENTABLE;
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        // i128: the magnitude of i64::MIN has no i64.
        let reduce = |value: i64| i128::from(value) * i128::from(denominator.signum()) / i128::from(divisor);
        match (i16::try_from(reduce(numerator)), i16::try_from(reduce(denominator))) {
            (Ok(numerator), Ok(denominator)) => Self { numerator, denominator },
            _ => Self::UNREPRESENTABLE,
        }
    }

    /// Numerator.
    pub fn numerator(self) -> i16 {
        self.numerator
    }

    /// Denominator, 0 if unrepresentable.
    pub fn denominator(self) -> i16 {
        self.denominator
    }

    fn parts(self) -> (i64, i64) {
        (i64::from(self.numerator), i64::from(self.denominator))
    }

    fn plus(self, other: Self) -> Self {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        Self::new(a * d + c * b, b * d)
    }

    fn times(self, other: Self) -> Self {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        Self::new(a * c, b * d)
    }

    fn negated(self) -> Self {
        let (a, b) = self.parts();
        Self::new(-a, b)
    }
}

fn gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// Powers of length, mass and time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Dimension {
    length: Exponent,
    mass: Exponent,
    time: Exponent,
}

impl Dimension {
    /// A pure number, angles included.
    pub const NUMBER: Self = Self::whole(0, 0, 0);
    /// m
    pub const LENGTH: Self = Self::whole(1, 0, 0);
    /// m²
    pub const AREA: Self = Self::whole(2, 0, 0);
    /// m³
    pub const VOLUME: Self = Self::whole(3, 0, 0);
    /// kg
    pub const MASS: Self = Self::whole(0, 1, 0);
    /// s
    pub const TIME: Self = Self::whole(0, 0, 1);
    /// Hz
    pub const FREQUENCY: Self = Self::whole(0, 0, -1);
    /// m/s
    pub const VELOCITY: Self = Self::whole(1, 0, -1);
    /// m/s²
    pub const ACCELERATION: Self = Self::whole(1, 0, -2);
    /// N
    pub const FORCE: Self = Self::whole(1, 1, -2);
    /// Pa, also an energy per volume
    pub const PRESSURE: Self = Self::whole(-1, 1, -2);
    /// kg/m³
    pub const DENSITY: Self = Self::whole(-3, 1, 0);
    /// J
    pub const ENERGY: Self = Self::whole(2, 1, -2);
    /// kg m/s
    pub const MOMENTUM: Self = Self::whole(1, 1, -1);
    /// kg m²/s
    pub const ANGULAR_MOMENTUM: Self = Self::whole(2, 1, -1);

    /// Whole powers of length, mass and time.
    pub const fn whole(length: i16, mass: i16, time: i16) -> Self {
        Self { length: Exponent::whole(length), mass: Exponent::whole(mass), time: Exponent::whole(time) }
    }

    /// Powers of length, mass and time.
    pub fn exponents(self) -> [Exponent; 3] {
        [self.length, self.mass, self.time]
    }

    fn map(self, f: impl Fn(Exponent) -> Exponent) -> Self {
        Self { length: f(self.length), mass: f(self.mass), time: f(self.time) }
    }

    /// Whether it is a pure number.
    pub fn is_number(self) -> bool {
        self == Self::NUMBER
    }

    /// Whether every exponent fits; what is not representable equals no dimension worth comparing with.
    pub fn is_representable(self) -> bool {
        self.exponents().iter().all(|e| *e != Exponent::UNREPRESENTABLE)
    }

    /// The dimension to the power `numerator/denominator`.
    pub fn powr(self, numerator: i64, denominator: i64) -> Self {
        // 0 times an unrepresentable power is 0: a number stays a number whatever its exponent.
        let power = Exponent::new(numerator, denominator);
        self.map(|e| if e == Exponent::ZERO { e } else { e.times(power) })
    }

    /// The dimension to a whole power.
    pub fn powi(self, power: i64) -> Self {
        self.powr(power, 1)
    }

    /// The dimension of a square root.
    pub fn sqrt(self) -> Self {
        self.powr(1, 2)
    }

    /// The dimension of a cube root.
    pub fn cbrt(self) -> Self {
        self.powr(1, 3)
    }

    /// The dimension of the reciprocal.
    pub fn recip(self) -> Self {
        self.map(Exponent::negated)
    }

    /// Base units with powers, as `kg m^-1 s^-2`; `1` for a number.
    pub fn base_symbol(self) -> String {
        if !self.is_representable() {
            return "a power too large to write".into();
        }
        let parts: Vec<String> = [("kg", self.mass), ("m", self.length), ("s", self.time)]
            .into_iter()
            .filter(|(_, e)| *e != Exponent::ZERO)
            .map(|(symbol, e)| match (e.numerator, e.denominator) {
                (1, 1) => symbol.to_string(),
                (n, 1) => format!("{symbol}^{n}"),
                (n, d) => format!("{symbol}^({n}/{d})"),
            })
            .collect();
        if parts.is_empty() { "1".into() } else { parts.join(" ") }
    }
}

impl Mul for Dimension {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            length: self.length.plus(other.length),
            mass: self.mass.plus(other.mass),
            time: self.time.plus(other.time),
        }
    }
}

impl Div for Dimension {
    type Output = Self;

    #[allow(clippy::suspicious_arithmetic_impl)] // a quotient is a product with the reciprocal
    fn div(self, other: Self) -> Self {
        self * other.recip()
    }
}

impl fmt::Display for Dimension {
    /// Its name if it has one (`pressure`), else base units with powers (`kg^2 m^-2 s^-4`).
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            Some(name) => f.write_str(name),
            None => f.write_str(&self.base_symbol()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn dimension() -> impl Strategy<Value = Dimension> {
        (-9i16..9, -9i16..9, -9i16..9).prop_map(|(l, m, t)| Dimension::whole(l, m, t))
    }

    proptest! {
        #[test]
        fn a_quotient_undoes_a_product(a in dimension(), b in dimension()) {
            prop_assert_eq!(a * b / b, a);
            prop_assert_eq!(a * b, b * a);
        }

        #[test]
        fn a_power_undoes_a_root(a in dimension(), n in 1i64..7) {
            prop_assert_eq!(a.powr(1, n).powi(n), a);
            prop_assert_eq!(a.sqrt() * a.sqrt(), a);
            prop_assert_eq!(a.cbrt() * a.cbrt() * a.cbrt(), a);
        }
    }

    #[test]
    fn a_stress_is_a_force_on_an_area_and_an_energy_in_a_volume() {
        assert_eq!(Dimension::FORCE / Dimension::AREA, Dimension::PRESSURE);
        assert_eq!(Dimension::ENERGY / Dimension::VOLUME, Dimension::PRESSURE);
        assert_ne!(Dimension::ENERGY / Dimension::AREA, Dimension::PRESSURE);
    }

    #[test]
    fn a_power_that_does_not_fit_never_becomes_right_again() {
        let huge = Dimension::LENGTH.powi(30_000) * Dimension::LENGTH.powi(30_000);
        assert!(!huge.is_representable());
        assert!(!(huge / huge).is_representable());
        assert!(!Dimension::LENGTH.powi(i64::MIN).is_representable());
        assert!(!Dimension::LENGTH.powr(1, 0).is_representable());
        assert_eq!(Dimension::NUMBER.powr(i64::MAX, 3), Dimension::NUMBER);
    }

    #[test]
    fn base_units_are_written_with_their_powers() {
        assert_eq!(Dimension::PRESSURE.powi(2).base_symbol(), "kg^2 m^-2 s^-4");
        assert_eq!(Dimension::LENGTH.sqrt().base_symbol(), "m^(1/2)");
        assert_eq!(Dimension::NUMBER.base_symbol(), "1");
    }
}
