//! What can be asked of a state: numbers and fields.

use super::{Coordinate, Region};
use crate::expression::Tape;

/// What a record can ask of the state; always the whole body's, symmetry accounted for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Probe {
    /// Time, s.
    Time,
    /// Mean displacement of a face, m.
    Displacement {
        /// The face.
        region: Region,
        /// Component.
        axis: u8,
    },
    /// Displacement at a reference point, m.
    DisplacementAt {
        /// The body.
        body: usize,
        /// The point, m.
        point: [f64; 3],
        /// Component.
        axis: u8,
    },
    /// Angle a plane face has turned about its axis relative to the opposite one, rad.
    Twist {
        /// The face.
        region: Region,
    },
    /// Force the support of a face exerts on the body, N.
    Reaction {
        /// The face.
        region: Region,
        /// Component.
        axis: u8,
    },
    /// Force carried through the plane `X_normal = at`, N.
    SectionForce {
        /// The body.
        body: usize,
        /// Axis of the plane's normal.
        normal: u8,
        /// Coordinate of the plane, m.
        at: f64,
        /// Component.
        axis: u8,
    },
    /// A field at a reference point.
    FieldAt {
        /// The body.
        body: usize,
        /// The point, m.
        point: [f64; 3],
        /// The field.
        field: Field,
    },
    /// Mean of a field over a body, weighted by place.
    Mean {
        /// The body.
        body: usize,
        /// The field.
        field: Field,
        /// The weight, a number.
        weight: Tape<Coordinate>,
    },
    /// How much a field alternates from particle to particle.
    Roughness(Field),
    /// Largest value of a field over all particles.
    FieldMax(Field),
    /// Smallest value of a field over all particles.
    FieldMin(Field),
    /// `Σ V_a ½ |p|²/ρR`, J.
    KineticEnergy,
    /// `Σ V_a ψ_a`, J.
    StrainEnergy,
    /// Kinetic and strain energy, J.
    TotalEnergy,
    /// `Σ V_a p_a`, kg m/s.
    Momentum(u8),
    /// `Σ V_a x_a × p_a`, kg m²/s.
    AngularMomentum(u8),
    /// Impulse since the start of what acts on a face or on a whole body, N s.
    Impulse {
        /// Index of the body.
        body: usize,
        /// The face; `None` is all that acts on the body.
        face: Option<String>,
        /// Component.
        axis: u8,
    },
    /// `Σ V_a J_a`, m³.
    Volume,
    /// Difference from the exact motion, weighted by volume, SI.
    MotionError(MotionField, Norm),
    /// `max |F_a − Grad_h x|`.
    GradientError,
    /// `max |H_a − cof F_a|`.
    AreaMapError,
    /// `max |J_a − det F_a|`.
    VolumeMapError,
    /// `max |CURL_h F|·dx`.
    CurlF,
    /// `max |DIV_h H|·dx`.
    DivH,
}

/// How differences at the particles become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Norm {
    /// Root of the volume-weighted mean of the squares.
    RootMeanSquare,
    /// Volume-weighted mean of the magnitudes.
    Mean,
}

/// What of a state is compared with the exact motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MotionField {
    /// Position, m.
    Position,
    /// Velocity, m/s.
    Velocity,
    /// Deformation gradient.
    Gradient,
    /// Area map, evolved or derived.
    AreaMap,
    /// Volume map, evolved or derived.
    VolumeMap,
    /// First Piola–Kirchhoff stress, Pa.
    Stress,
}

/// A scalar field of the particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// Component of the displacement, m.
    Displacement(u8),
    /// Component of the velocity, m/s.
    Velocity(u8),
    /// Component of the Cauchy stress, Pa.
    Sigma(u8, u8),
    /// Component of the first Piola–Kirchhoff stress, Pa.
    P(u8, u8),
    /// Component of the deformation gradient.
    F(u8, u8),
    /// Von Mises stress, Pa.
    VonMises,
    /// Pressure `tr σ/3` (positive in tension, as the paper plots it), Pa.
    Pressure,
    /// `J`.
    J,
}
