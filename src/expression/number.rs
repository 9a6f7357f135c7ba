//! A plain number as a part of duals, its functions those of the project on every machine.

use super::dual_parts::implement_dual_num;
use super::scalar::{Part, Scalar};
use super::tape::Comparison;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number whose elementary functions are the same bits on every machine.
///
/// `Dual<Number>` gives first derivatives, `Dual<Dual<Number>>` second ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number(
    /// The value.
    pub f64,
);

impl Number {
    fn real(&self) -> f64 {
        self.0
    }
}

impl Part for Number {}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! operators {
    ($($trait:ident $function:ident),*) => {$(
        impl $trait for Number {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                Self($trait::$function(self.0, other.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

macro_rules! delegate {
    ($($function:ident),*) => {
        $(fn $function(&self) -> Self { Self(Scalar::$function(&self.0)) })*
    };
}

impl Scalar for Number {
    fn constant(value: f64) -> Self {
        Self(value)
    }
    fn fixed(&self) -> Option<f64> {
        Some(self.0)
    }
    fn real_power(&self, exponent: f64) -> Self {
        Self(self.0.real_power(exponent))
    }
    fn select(left: &Self, comparison: Comparison, right: &Self, then: &Self, otherwise: &Self) -> Self {
        if comparison.holds(left.0, right.0) { *then } else { *otherwise }
    }
    delegate!(
        reciprocal,
        sqrt,
        cbrt,
        reciprocal_cbrt,
        exp,
        exp_m1,
        ln,
        sin,
        cos,
        tan,
        tanh,
        cosh,
        sinh,
        erf,
        pos,
        step
    );
}

implement_dual_num!(Number);
