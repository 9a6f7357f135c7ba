//! Expressions to formulas, with their dimensions proved.
//!
//! Owns what every expression has in common whatever its names mean: numbers with units, operators,
//! vectors, functions, sums. The meaning of names is a [`Scope`]'s.

mod arithmetic;
mod call;
mod evaluator;
mod place;
mod read;
mod scope;
mod value;

pub(super) use arithmetic::symbol;
pub(super) use evaluator::Evaluator;
pub(super) use place::place_word;
pub(super) use read::{Required, dimension, example_with_unit};
pub(super) use scope::{Elsewhere, Let, Lets, Local, Scope};
pub(super) use value::{Leaves, Outcome, Scalar, Value};
