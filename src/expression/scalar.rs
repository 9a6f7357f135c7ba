//! What a formula can be evaluated in.
//!
//! Owns the arithmetic a tape needs, for plain numbers and for num-dual's duals. A scalar may be a
//! handle of a graph still to be run, so nothing here may ask for a value: comparisons go through
//! [`Scalar::select`], and only [`Scalar::fixed`] may look at a number that cannot vary.

use super::elementary;
use super::tape::Comparison;
use num_dual::{Dual, DualNum};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Integer exponents up to this size are products, larger ones go through `pow`.
const LARGEST_PRODUCT_EXPONENT: f64 = 64.0;

/// A number, a dual number, or a handle of a traced graph.
pub trait Scalar:
    Clone + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// A number that does not vary.
    fn constant(value: f64) -> Self;
    /// The value, if it is known and does not vary.
    fn fixed(&self) -> Option<f64>;
    /// `1/x`
    fn reciprocal(&self) -> Self;
    /// `√x`
    fn sqrt(&self) -> Self;
    /// `x^(1/3)`
    fn cbrt(&self) -> Self;
    /// `x^(-1/3)`; not a number for `x <= 0`, where no isochoric part exists.
    fn reciprocal_cbrt(&self) -> Self;
    /// `e^x`
    fn exp(&self) -> Self;
    /// `e^x - 1` without cancellation near 0.
    fn exp_m1(&self) -> Self;
    /// `ln x`
    fn ln(&self) -> Self;
    /// `sin x`
    fn sin(&self) -> Self;
    /// `cos x`
    fn cos(&self) -> Self;
    /// `tan x`
    fn tan(&self) -> Self;
    /// `tanh x`; finite for every finite `x`.
    fn tanh(&self) -> Self;
    /// `cosh x`
    fn cosh(&self) -> Self;
    /// `sinh x`
    fn sinh(&self) -> Self;
    /// Error function.
    fn erf(&self) -> Self;
    /// Macaulay bracket `max(x, 0)`: value 0 and derivative 0 at 0.
    fn pos(&self) -> Self;
    /// Derivative of [`Scalar::pos`]: 1 for `x > 0`, otherwise 0.
    fn step(&self) -> Self;
    /// `x^e` for an `e` that is neither an integer nor a half; not a number for `x < 0`.
    fn real_power(&self, exponent: f64) -> Self;
    /// `then` where `left <comparison> right` holds, `otherwise` where it does not.
    fn select(left: &Self, comparison: Comparison, right: &Self, then: &Self, otherwise: &Self) -> Self;

    /// `∫ f(n) dS` of `f = self` over the sphere, or its part with `n · S n > above`: `S` as six
    /// components 11, 22, 33, 12, 13, 23, and the bound.
    ///
    /// Only a traced graph can run over directions; the language lets no other formula ask for it.
    fn over_directions(&self, _order: u16, _part: Option<([Self; 6], Self)>) -> Self {
        unreachable!("only energies integrate over directions")
    }

    /// An integral `self` between two limits, each with the integrand there: its slope is
    /// `f(upper) d upper − f(lower) d lower`, whatever rule gave its value.
    fn between(&self, _upper: (&Self, &Self), _lower: (&Self, &Self)) -> Self {
        self.clone()
    }

    /// `|x|`, with derivative 1 at 0.
    fn abs(&self) -> Self {
        Self::select(self, Comparison::GreaterEqual, &Self::constant(0.0), self, &-self.clone())
    }

    /// `min(x, y)`, `x` where they are equal.
    fn min(&self, other: &Self) -> Self {
        Self::select(self, Comparison::LessEqual, other, self, other)
    }

    /// `max(x, y)`, `x` where they are equal.
    fn max(&self, other: &Self) -> Self {
        Self::select(self, Comparison::GreaterEqual, other, self, other)
    }

    /// `x^e` for an exponent that does not vary.
    ///
    /// Integers are products (any sign of `x`), halves a square root and products; the rest needs
    /// `x >= 0` and is not a number elsewhere.
    fn fixed_power(&self, exponent: f64) -> Self {
        let whole = exponent.trunc();
        if exponent == whole && whole.abs() <= LARGEST_PRODUCT_EXPONENT {
            product(self, whole as i32)
        } else if 2.0 * exponent == (2.0 * exponent).trunc() && whole.abs() <= LARGEST_PRODUCT_EXPONENT {
            let root = self.sqrt();
            let odd = if exponent < 0.0 { root.reciprocal() } else { root };
            if whole == 0.0 { odd } else { product(self, whole as i32) * odd }
        } else {
            self.real_power(exponent)
        }
    }

    /// `x^y`
    ///
    /// Where the exponent varies the base must be positive; `0^y` is 0 with slope 0, below that the power
    /// is not a number.
    fn power(&self, exponent: &Self) -> Self {
        if let Some(value) = exponent.fixed() {
            return self.fixed_power(value);
        }
        let (zero, one) = (Self::constant(0.0), Self::constant(1.0));
        // The logarithm of 0 would make the slope of a bracket's power at rest no number.
        let base = Self::select(self, Comparison::Greater, &zero, self, &one);
        let power = (base.ln() * exponent.clone()).exp();
        let none = Self::select(self, Comparison::Less, &zero, &Self::constant(f64::NAN), &zero);
        Self::select(self, Comparison::Greater, &zero, &power, &none)
    }
}

/// `x^n` by repeated squaring; `x^0 = 1` for every `x`.
fn product<T: Scalar>(x: &T, n: i32) -> T {
    let mut square = if n < 0 { x.reciprocal() } else { x.clone() };
    let mut left = n.unsigned_abs();
    let mut result: Option<T> = None;
    while left > 0 {
        if left & 1 == 1 {
            result = Some(result.map_or_else(|| square.clone(), |r| r * square.clone()));
        }
        left >>= 1;
        if left > 0 {
            square = square.clone() * square;
        }
    }
    result.unwrap_or_else(|| T::constant(1.0))
}

impl Comparison {
    /// Whether `left <self> right` holds; never, if either is not a number.
    pub fn holds(self, left: f64, right: f64) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessEqual => left <= right,
            Self::Greater => left > right,
            Self::GreaterEqual => left >= right,
        }
    }
}

impl Scalar for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn fixed(&self) -> Option<f64> {
        Some(*self)
    }
    fn reciprocal(&self) -> Self {
        1.0 / self
    }
    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }
    fn cbrt(&self) -> Self {
        libm::cbrt(*self)
    }
    fn reciprocal_cbrt(&self) -> Self {
        elementary::reciprocal_cbrt(*self)
    }
    fn exp(&self) -> Self {
        elementary::exp(*self)
    }
    fn exp_m1(&self) -> Self {
        libm::expm1(*self)
    }
    fn ln(&self) -> Self {
        libm::log(*self)
    }
    fn sin(&self) -> Self {
        libm::sin(*self)
    }
    fn cos(&self) -> Self {
        libm::cos(*self)
    }
    fn tan(&self) -> Self {
        libm::tan(*self)
    }
    fn tanh(&self) -> Self {
        libm::tanh(*self)
    }
    fn cosh(&self) -> Self {
        libm::cosh(*self)
    }
    fn sinh(&self) -> Self {
        libm::sinh(*self)
    }
    fn erf(&self) -> Self {
        libm::erf(*self)
    }
    fn pos(&self) -> Self {
        // not `max`: that drops a NaN
        if *self <= 0.0 { 0.0 } else { *self }
    }
    fn step(&self) -> Self {
        if *self > 0.0 { 1.0 } else { 0.0 }
    }
    fn real_power(&self, exponent: f64) -> Self {
        libm::pow(*self, exponent)
    }
    fn select(left: &Self, comparison: Comparison, right: &Self, then: &Self, otherwise: &Self) -> Self {
        if comparison.holds(*left, *right) { *then } else { *otherwise }
    }
}

/// A scalar duals may be built of; `f64` is none, its functions would be the platform's.
pub trait Part: Scalar + DualNum<Primitive = f64> {}

impl<T: Part> Part for Dual<T> {}

/// A dual number of value `f0` and slope `f1`, by the chain rule.
fn chain<T: Part>(x: &Dual<T>, f0: T, f1: T) -> Dual<T> {
    Dual::new(f0, x.eps.clone() * f1)
}

impl<T: Part> Scalar for Dual<T> {
    fn constant(value: f64) -> Self {
        Self::new(T::constant(value), T::constant(0.0))
    }
    fn fixed(&self) -> Option<f64> {
        if self.eps.fixed() == Some(0.0) { self.re.fixed() } else { None }
    }
    fn reciprocal(&self) -> Self {
        DualNum::recip(self)
    }
    fn sqrt(&self) -> Self {
        DualNum::sqrt(self)
    }
    fn cbrt(&self) -> Self {
        DualNum::cbrt(self)
    }
    fn reciprocal_cbrt(&self) -> Self {
        let r = self.re.reciprocal_cbrt();
        let r2 = r.clone() * r.clone();
        chain(self, r, r2.clone() * r2 * T::constant(-1.0 / 3.0))
    }
    fn exp(&self) -> Self {
        DualNum::exp(self)
    }
    fn exp_m1(&self) -> Self {
        DualNum::exp_m1(self)
    }
    fn ln(&self) -> Self {
        DualNum::ln(self)
    }
    fn sin(&self) -> Self {
        DualNum::sin(self)
    }
    fn cos(&self) -> Self {
        DualNum::cos(self)
    }
    fn tan(&self) -> Self {
        let f0 = Scalar::tan(&self.re);
        let f1 = T::constant(1.0) + f0.clone() * f0.clone();
        chain(self, f0, f1)
    }
    fn tanh(&self) -> Self {
        // sinh/cosh is not a number beyond 710
        let f0 = Scalar::tanh(&self.re);
        let f1 = T::constant(1.0) - f0.clone() * f0.clone();
        chain(self, f0, f1)
    }
    fn cosh(&self) -> Self {
        DualNum::cosh(self)
    }
    fn sinh(&self) -> Self {
        DualNum::sinh(self)
    }
    fn erf(&self) -> Self {
        let slope = Scalar::exp(&-(self.re.clone() * self.re.clone()));
        chain(self, self.re.erf(), slope * T::constant(std::f64::consts::FRAC_2_SQRT_PI))
    }
    fn pos(&self) -> Self {
        chain(self, self.re.pos(), self.re.step())
    }
    fn step(&self) -> Self {
        Self::new(self.re.step(), T::constant(0.0))
    }
    fn real_power(&self, exponent: f64) -> Self {
        power_chain(self, exponent)
    }
    fn fixed_power(&self, exponent: f64) -> Self {
        // num-dual's powf is not a number at 0, and a square root's slope is none there
        match exponent {
            0.0 => <Self as Scalar>::constant(1.0),
            1.0 => self.clone(),
            2.0 => self.clone() * self.clone(),
            _ => power_chain(self, exponent),
        }
    }
    fn select(left: &Self, comparison: Comparison, right: &Self, then: &Self, otherwise: &Self) -> Self {
        let part = |then: &T, otherwise: &T| T::select(&left.re, comparison, &right.re, then, otherwise);
        Self::new(part(&then.re, &otherwise.re), part(&then.eps, &otherwise.eps))
    }
    fn over_directions(&self, order: u16, part: Option<([Self; 6], Self)>) -> Self {
        // the integrand vanishes where a part of the sphere ends, so its change adds nothing
        let part = part.map(|(shape, above)| (shape.map(|s| s.re), above.re));
        Self::new(self.re.over_directions(order, part.clone()), self.eps.over_directions(order, part))
    }
    fn between(&self, upper: (&Self, &Self), lower: (&Self, &Self)) -> Self {
        let value = self.re.between((&upper.0.re, &upper.1.re), (&lower.0.re, &lower.1.re));
        let slope = |(limit, integrand): (&Self, &Self)| limit.eps.clone() * integrand.re.clone();
        Self::new(value, slope(upper) - slope(lower))
    }
}

fn power_chain<T: Part>(x: &Dual<T>, exponent: f64) -> Dual<T> {
    let slope = x.re.fixed_power(exponent - 1.0) * T::constant(exponent);
    chain(x, x.re.fixed_power(exponent), slope)
}
