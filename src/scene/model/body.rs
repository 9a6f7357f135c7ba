//! The description of bodies: shapes, their faces, what joins and mirrors them.

use super::Place;
use crate::discretisation::Shape;

/// A plane of symmetry.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetryPlane {
    /// Its coordinate, m.
    pub at: f64,
    /// Where it is declared.
    pub place: Place,
}

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its shape, the whole body's.
    pub shape: Shape,
    /// Node spacing, m.
    pub spacing: f64,
    /// Random displacement of inner nodes as a fraction of the spacing.
    pub jitter: f64,
    /// Index into the scene's materials.
    pub material: usize,
}

/// A face of a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Index of the body.
    pub body: usize,
    /// Name of the face.
    pub face: String,
}

/// Two faces of different bodies whose nodes are shared.
#[derive(Debug, Clone, PartialEq)]
pub struct Bond {
    /// Where it is declared.
    pub place: Place,
    /// One face.
    pub first: Region,
    /// The other.
    pub second: Region,
}
