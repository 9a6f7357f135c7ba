//! What an expression can be.

use super::super::file::Reported;
use super::super::model::{Coordinate, Probe, Sample};
use crate::energy::Leaf;
use crate::expression::NodeId;
use crate::unit::Dimension;

/// The meaning of an expression, or the word that it has none.
pub(in crate::scene) type Outcome = Result<Value, Reported>;

/// What an expression is.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::scene) enum Value {
    /// A formula with a dimension.
    Scalar(Scalar),
    /// A vector or an array.
    List(Vec<Value>),
    /// A direction of the material, by index.
    Direction(u8),
}

/// A formula, by its last node, and its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::scene) struct Scalar {
    pub(in crate::scene) node: NodeId,
    pub(in crate::scene) dimension: Dimension,
}

impl Value {
    pub(in crate::scene) fn scalar(node: NodeId, dimension: Dimension) -> Self {
        Self::Scalar(Scalar { node, dimension })
    }

    /// What it is in a sentence: `a pressure`, `a list of 3`.
    pub(in crate::scene) fn describe(&self) -> String {
        match self {
            Self::Scalar(scalar) => scalar.dimension.describe(),
            Self::List(values) if values.len() == 3 => "a vector".into(),
            Self::List(values) => format!("a list of {}", values.len()),
            Self::Direction(_) => "a direction".into(),
        }
    }
}

/// A type of leaf.
pub(in crate::scene) trait Leaves: Clone + PartialEq {
    /// The leaf of a material parameter, if formulas over these leaves keep parameters apart.
    fn parameter(_index: u32) -> Option<Self> {
        None
    }

    /// The number a leaf stands for where it is known.
    fn value(&self, _parameters: &[f64]) -> Option<f64> {
        None
    }

    /// The leaf of a reference coordinate, if formulas over these leaves may depend on place.
    fn coordinate(_axis: u8) -> Option<Self> {
        None
    }

    /// The leaf of time, if formulas over these leaves may depend on time.
    fn time() -> Option<Self> {
        None
    }
}

impl Leaves for Leaf {
    fn parameter(index: u32) -> Option<Self> {
        Some(Leaf::Parameter(index))
    }

    fn value(&self, parameters: &[f64]) -> Option<f64> {
        match self {
            Leaf::Parameter(index) => parameters.get(*index as usize).copied(),
            Leaf::Invariant(_) | Leaf::Running(_) => None,
        }
    }
}

impl Leaves for Coordinate {
    fn coordinate(axis: u8) -> Option<Self> {
        Some(Coordinate::X(axis))
    }

    fn time() -> Option<Self> {
        Some(Coordinate::Time)
    }
}

impl Leaves for Probe {}
impl Leaves for Sample {}
