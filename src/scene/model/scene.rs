//! The description of a scene, and of what acts on its bodies.

use super::{
    Body, Bond, Coordinate, Expectation, Frames, Material, Place, Plot, Record, Region, Run, SymmetryPlane,
};
use crate::expression::Tape;

/// A particle scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Materials its bodies use.
    pub materials: Vec<Material>,
    /// Its bodies.
    pub bodies: Vec<Body>,
    /// Planes of symmetry: through the centre of the bodies, normal to x, y, z; the part of greater
    /// coordinates is modelled.
    pub symmetry: [Option<SymmetryPlane>; 3],
    /// Faces of two bodies that move as one.
    pub bonds: Vec<Bond>,
    /// Prescribed motions of faces.
    pub prescribed: Vec<Prescribed>,
    /// Tractions and body forces.
    pub loads: Vec<Load>,
    /// Initial velocity fields.
    pub starts: Vec<Start>,
    /// An exact motion the bodies are to follow.
    pub motion: Option<Motion>,
    /// Numerical choices.
    pub run: Run,
    /// Tables to write.
    pub records: Vec<Record>,
    /// Frames to write.
    pub frames: Vec<Frames>,
    /// Figures to draw.
    pub plots: Vec<Plot>,
    /// What must hold.
    pub expectations: Vec<Expectation>,
}

/// Prescribed displacement of the nodes of a face; a free component is `None`.
#[derive(Debug, Clone, PartialEq)]
pub struct Prescribed {
    /// The word that asked for it: `hold`, `slide`, `pull`, `move`.
    pub word: String,
    /// Where it is declared.
    pub place: Place,
    /// Where it acts.
    pub region: Region,
    /// Displacement of each component over time (and place), m.
    pub displacement: [Option<Tape<Coordinate>>; 3],
}

/// A load.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Load {
    /// Dead traction per reference area, Pa.
    Traction {
        /// Where it is declared.
        place: Place,
        /// Where it acts.
        region: Region,
        /// Its components.
        traction: [Tape<Coordinate>; 3],
    },
    /// Pressure on the deformed face, Pa.
    Pressure {
        /// Where it is declared.
        place: Place,
        /// Where it acts.
        region: Region,
        /// Its value, positive where it pushes.
        pressure: Tape<Coordinate>,
    },
    /// Force per reference volume, N/m³.
    BodyForce {
        /// Where it is declared.
        place: Place,
        /// The body it acts on.
        body: usize,
        /// Its components.
        force: [Tape<Coordinate>; 3],
    },
    /// Acceleration of gravity on all bodies, m/s².
    Gravity {
        /// Where it is declared.
        place: Place,
        /// Its components.
        acceleration: [f64; 3],
    },
}

/// An initial velocity field.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// Where it is declared.
    pub place: Place,
    /// The body it acts on.
    pub body: usize,
    /// Components, m/s.
    pub velocity: [Tape<Coordinate>; 3],
}

/// An exact motion: initial state, body force and boundary data follow from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Where it is declared.
    pub place: Place,
    /// Components of `x(X, t)`, m.
    pub position: [Tape<Coordinate>; 3],
    /// Whether the body force `ρR ∂²x/∂t² − DIV P` acts.
    pub body_force: bool,
    /// Faces that carry the exact traction `P N`; what they are moved by stands among the prescribed.
    pub loaded: Vec<Region>,
}
