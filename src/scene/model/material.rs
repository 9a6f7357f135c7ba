//! The description of a material: its energy, numbers and directions.

use super::Place;
use crate::energy::Leaf;
use crate::expression::Tape;
use crate::fit::Range;

/// A hyperelastic material.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Reference density ρR, kg/m³.
    pub density: f64,
    /// Strain energy per reference volume, Pa.
    pub energy: Tape<Leaf>,
    /// Values of the energy's parameter leaves, SI.
    pub parameters: Vec<MaterialParameter>,
    /// Formulas given in place of numbers.
    pub constraints: Vec<Constraint>,
    /// Names of the energies summed, as written, with where each was declared.
    pub terms: Vec<(String, Place)>,
    /// Named directions, the indices of the invariants.
    pub directions: Vec<Direction>,
    /// Directions of its frame, known by name to a drive.
    pub frame: Vec<Direction>,
}

/// One parameter of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialParameter {
    /// Its name, qualified by the energy if need be: `goh.kappa`.
    pub name: String,
    /// SI value.
    pub value: f64,
    /// Unit symbol of the SI value.
    pub unit: String,
    /// Where it may lie, as declared; SI.
    pub range: Range,
    /// Whether a direction of the material depends on it.
    pub turns_direction: bool,
}

/// A formula given to a parameter of an energy, which must stay in the parameter's range.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// Name of the parameter: `goh.C`.
    pub name: String,
    /// Its value; the leaves are parameters of the material.
    pub value: Tape<Leaf>,
    /// Where it may lie; SI.
    pub range: Range,
}

/// A unit direction, possibly a function of the reference position.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its components.
    pub components: [Tape<Coordinate>; 3],
}

/// Leaves of fields written as text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// Reference coordinate 0, 1 or 2, m.
    X(u8),
    /// Time, s.
    Time,
}
