//! The traits num-dual asks of the parts of its duals, from [`Scalar`](super::Scalar) alone.

/// Implements `DualNum` and all it builds on for a type that is a [`Scalar`](super::Scalar).
///
/// The type must have `Neg` and the four operators by value, `PartialEq`, `Debug`, and a function
/// `real(&self) -> f64`, which may panic where no number is known yet. Functions of the trait that
/// no formula can name panic.
macro_rules! implement_dual_num {
    ($t:ty) => {
        mod dual_num_of_part {
            use super::*;
            use $crate::expression::Scalar as S;
            use num_dual::{DualNum, DualStruct, Mappable};
            use num_traits::{FromPrimitive, Inv, Num, One, Signed, Zero};
            use std::cmp::Ordering;
            use std::fmt;
            use std::iter::{Product, Sum};
            use std::ops::{
                Add, AddAssign, Div, DivAssign, Mul, MulAssign, Rem, RemAssign, Sub, SubAssign,
            };

            implement_dual_num!(@operator $t, Add, add, AddAssign, add_assign);
            implement_dual_num!(@operator $t, Sub, sub, SubAssign, sub_assign);
            implement_dual_num!(@operator $t, Mul, mul, MulAssign, mul_assign);
            implement_dual_num!(@operator $t, Div, div, DivAssign, div_assign);
            implement_dual_num!(@operator $t, Rem, rem, RemAssign, rem_assign);

            impl Rem for $t {
                type Output = $t;
                fn rem(self, _: $t) -> $t {
                    unreachable!("no formula takes a remainder")
                }
            }
            impl Zero for $t {
                fn zero() -> Self {
                    S::constant(0.0)
                }
                fn is_zero(&self) -> bool {
                    S::fixed(self) == Some(0.0)
                }
            }
            impl One for $t {
                fn one() -> Self {
                    S::constant(1.0)
                }
            }
            impl Num for $t {
                type FromStrRadixErr = std::num::ParseFloatError;
                fn from_str_radix(text: &str, _: u32) -> Result<Self, Self::FromStrRadixErr> {
                    text.parse().map(S::constant)
                }
            }
            impl Signed for $t {
                fn abs(&self) -> Self {
                    S::abs(self)
                }
                fn abs_sub(&self, other: &Self) -> Self {
                    S::pos(&(self.clone() - other.clone()))
                }
                fn signum(&self) -> Self {
                    self.real().signum().into()
                }
                fn is_positive(&self) -> bool {
                    self.real() > 0.0
                }
                fn is_negative(&self) -> bool {
                    self.real() < 0.0
                }
            }
            impl Inv for $t {
                type Output = Self;
                fn inv(self) -> Self {
                    S::reciprocal(&self)
                }
            }
            impl Sum for $t {
                fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
                    terms.fold(Self::zero(), |sum, term| sum + term)
                }
            }
            impl Product for $t {
                fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
                    factors.fold(Self::one(), |product, factor| product * factor)
                }
            }
            impl FromPrimitive for $t {
                fn from_i64(value: i64) -> Option<Self> {
                    Some(S::constant(value as f64))
                }
                fn from_u64(value: u64) -> Option<Self> {
                    Some(S::constant(value as f64))
                }
                fn from_f64(value: f64) -> Option<Self> {
                    Some(S::constant(value))
                }
            }
            impl From<f64> for $t {
                fn from(value: f64) -> Self {
                    S::constant(value)
                }
            }
            impl DualStruct for $t {
                type Real = f64;
                type Inner = f64;
                fn re(&self) -> f64 {
                    self.real()
                }
                fn from_inner(inner: &f64) -> Self {
                    S::constant(*inner)
                }
            }
            impl Mappable<$t> for $t {
                type Output<O> = O;
                fn map_dual<M: Fn($t) -> O, O>(self, map: M) -> O {
                    map(self)
                }
            }
            impl fmt::Display for $t {
                fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
                    fmt::Debug::fmt(self, f)
                }
            }
            impl PartialOrd for $t {
                fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                    self.real().partial_cmp(&other.real())
                }
            }
            impl PartialEq<f64> for $t {
                fn eq(&self, other: &f64) -> bool {
                    self.real() == *other
                }
            }
            impl PartialOrd<f64> for $t {
                fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
                    self.real().partial_cmp(other)
                }
            }
            impl DualNum for $t {
                type Primitive = f64;
                const NDERIV: usize = 0;
                type InnerDual = Self;
                fn from_re(re: Self) -> Self {
                    re
                }
                fn scale(self, factor: &Self) -> Self {
                    self * factor.clone()
                }
                fn recip(&self) -> Self {
                    S::reciprocal(self)
                }
                fn powi(&self, n: i32) -> Self {
                    S::fixed_power(self, f64::from(n))
                }
                fn powf(&self, n: f64) -> Self {
                    S::fixed_power(self, n)
                }
                fn log(&self, base: f64) -> Self {
                    S::ln(self) / S::ln(&Self::from(base))
                }
                fn sin_cos(&self) -> (Self, Self) {
                    (S::sin(self), S::cos(self))
                }
                fn atan2(&self, _: Self) -> Self {
                    unreachable!("no formula names atan2")
                }
                implement_dual_num!(@same sqrt, cbrt, exp, exp_m1, ln, sin, cos, tan, sinh, cosh, tanh);
                implement_dual_num!(@absent exp2, log2, log10, ln_1p, asin, acos, atan, asinh, acosh, atanh,
                    sph_j0, sph_j1, sph_j2);
            }
        }
    };
    (@operator $t:ty, $trait:ident, $function:ident, $assign:ident, $assign_function:ident) => {
        impl $trait<&$t> for $t {
            type Output = $t;
            fn $function(self, other: &$t) -> $t {
                $trait::$function(self, other.clone())
            }
        }
        impl $trait<f64> for $t {
            type Output = $t;
            fn $function(self, other: f64) -> $t {
                $trait::$function(self, <$t as S>::constant(other))
            }
        }
        impl $assign for $t {
            fn $assign_function(&mut self, other: $t) {
                *self = $trait::$function(self.clone(), other);
            }
        }
        impl $assign<f64> for $t {
            fn $assign_function(&mut self, other: f64) {
                *self = $trait::$function(self.clone(), <$t as S>::constant(other));
            }
        }
    };
    (@same $($function:ident),*) => {
        $(fn $function(&self) -> Self { S::$function(self) })*
    };
    (@absent $($function:ident),*) => {
        $(fn $function(&self) -> Self { unreachable!(concat!("no formula names ", stringify!($function))) })*
    };
}

pub(crate) use implement_dual_num;
