//! Why a body could not be discretised.
//!
//! Owns the error of this layer. Lengths are SI and places are reference positions: the scene adds the
//! line of the file and the user's units.

use crate::tensor::Vec3;
use std::fmt;

/// Why a body could not be discretised.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DiscretisationError {
    /// The spacing is not a positive, finite length.
    BadSpacing {
        /// The spacing asked for, m.
        spacing: f64,
    },
    /// A dimension of the shape is not a positive, finite length.
    BadDimension {
        /// Which dimension: `x`, `radius`, `gauge width`.
        name: &'static str,
        /// Its value, m.
        value: f64,
    },
    /// The spacing divides the edges so differently that neighbours would differ between them.
    UnevenSpacing {
        /// The spacing asked for, m.
        requested: f64,
        /// Least spacing the nearest whole counts give, m.
        least: f64,
        /// Greatest spacing the nearest whole counts give, m.
        greatest: f64,
        /// The nearest spacing that divides all edges well, m.
        suggestion: f64,
    },
    /// A radius is smaller than the spacing, so the lattice would not see it.
    FeatureTooSmall {
        /// The radius, m.
        radius: f64,
        /// The spacing, m.
        spacing: f64,
    },
    /// Triangles that enclose no volume.
    NoSurface {
        /// How many there are.
        triangles: usize,
    },
    /// A surface with a hole, or triangles that do not agree on what is outside.
    OpenSurface {
        /// How many edges do not join two triangles.
        edges: usize,
        /// The middle of one of them, m.
        position: Vec3,
    },
    /// Hexahedra of a file that do not name points of it.
    BadCell {
        /// Index of the first such cell.
        cell: usize,
        /// Number of points.
        points: usize,
    },
    /// A point without a place or a volume.
    BadPoint {
        /// Its index.
        point: usize,
        /// Its volume, m³.
        volume: f64,
    },
    /// A lattice without a node: nothing is left of the shape, or walls thinner than half of the spacing.
    Empty {
        /// The spacing, m.
        spacing: f64,
    },
    /// Two nodes of a cross-section fall on one place: what is left of the body between two faces is thinner than the
    /// lattice can follow.
    NodesMeet {
        /// Reference position of the place, m.
        position: Vec3,
        /// The spacing, m.
        spacing: f64,
    },
    /// Points without cells cannot be integrated consistently: they have no boundary areas.
    NoAreas,
    /// A union or difference that is not extruded from one plane region.
    NotAPrism,
    /// The random displacement of nodes must lie in [0, 0.5) spacings.
    BadJitter {
        /// The fraction asked for.
        jitter: f64,
    },
    /// A plane of symmetry does not cut the shape.
    PlaneOutside {
        /// Axis of its normal.
        axis: usize,
        /// Its coordinate, m.
        at: f64,
        /// Least and greatest coordinate of the shape along the axis, m.
        extent: (f64, f64),
    },
    /// Hexahedra of a file do not end in the plane of symmetry.
    PlaneNotAnEnd {
        /// Axis of its normal.
        axis: usize,
        /// Its coordinate, m.
        at: f64,
        /// The least coordinate of the file's points, m.
        end: f64,
    },
    /// Points without cells have no volume on either side of a plane.
    PlaneThroughPoints {
        /// Axis of the plane's normal.
        axis: usize,
    },
    /// More nodes than indices and memory allow.
    TooManyParticles {
        /// How many the spacing asks for.
        count: f64,
        /// The most that are accepted.
        limit: u32,
    },
    /// A cell of the background grid is turned inside out.
    InvertedCell {
        /// Its centre, m.
        position: Vec3,
        /// The smallest determinant of its map relative to a regular cell's.
        determinant: f64,
    },
    /// The ratio of smoothing length to spacing is not a positive, finite number.
    BadSmoothing {
        /// The ratio asked for.
        smoothing: f64,
    },
    /// The neighbours of a particle do not span space, so no gradient can be formed.
    SingularMoments {
        /// Index of the particle.
        particle: usize,
        /// Its reference position, m.
        position: Vec3,
        /// How many neighbours it has, itself included.
        neighbours: usize,
    },
    /// The neighbours of a particle do not tell quadratic fields apart.
    SingularQuadratics {
        /// Index of the particle.
        particle: usize,
        /// Its reference position, m.
        position: Vec3,
        /// How many neighbours it has, itself included.
        neighbours: usize,
    },
    /// The integration constraint was not met.
    ConstraintNotMet {
        /// Particle with the largest leftover.
        particle: usize,
        /// Its reference position, m.
        position: Vec3,
        /// The leftover of its boundary area, as a fraction of the squared spacing.
        leftover: f64,
        /// Iterations spent.
        iterations: usize,
        /// Whether the gradients were to be exact for quadratic fields.
        quadratic: bool,
    },
}

impl fmt::Display for DiscretisationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadSpacing { spacing } => {
                write!(f, "spacing {spacing:e} m is not a positive, finite length")
            }
            Self::BadDimension { name, value } => {
                write!(f, "{name} {value:e} m is not a positive, finite length")
            }
            Self::UnevenSpacing { requested, least, greatest, suggestion } => write!(
                f,
                "spacing {requested:.6e} m does not divide the edges: whole counts give {least:.6e} m to \
                 {greatest:.6e} m; {suggestion:.6e} m does"
            ),
            Self::FeatureTooSmall { radius, spacing } => {
                write!(f, "a radius of {radius:.4e} m is below the spacing, {spacing:.4e} m")
            }
            Self::NoSurface { triangles } => {
                write!(f, "{triangles} triangles enclose no volume")
            }
            Self::OpenSurface { edges, position: x } => write!(
                f,
                "the surface is not closed: {edges} edges, one at X = ({:.4e}, {:.4e}, {:.4e}) m, do not join two \
                 triangles that agree on what is outside",
                x.x, x.y, x.z
            ),
            Self::BadPoint { point, volume } => {
                write!(
                    f,
                    "point {point} needs finite coordinates and a positive volume; its volume is {volume:e} m^3"
                )
            }
            Self::Empty { spacing } => write!(
                f,
                "no particle lies in the shape: what is taken away leaves nothing, or nothing thicker than half of the \
                 spacing, {spacing:.4e} m"
            ),
            Self::NodesMeet { position: x, spacing } => write!(
                f,
                "two nodes fall on X = ({:.4e}, {:.4e}, {:.4e}) m, where two faces leave too little of the body between \
                 them for a spacing of {spacing:.4e} m; a finer spacing is required",
                x.x, x.y, x.z
            ),
            Self::NoAreas => write!(
                f,
                "points without cells have no boundary areas; write `integration_consistency = off` or give a file with \
                 hexahedra"
            ),
            Self::BadCell { cell, points } => {
                write!(f, "cell {cell} names a corner that is none of the {points} points")
            }
            Self::NotAPrism => write!(
                f,
                "unions and differences are of bodies along one axis: the parts of a union end together, \
                 and what is taken away reaches through"
            ),
            Self::BadJitter { jitter } => {
                write!(f, "jitter {jitter} is outside [0, 0.5), a fraction of the spacing")
            }
            Self::PlaneOutside { axis, at, extent: (low, high) } => write!(
                f,
                "the plane of symmetry {} = {at:.4e} m does not cut the body, which reaches from {low:.4e} m \
                 to {high:.4e} m",
                ["x", "y", "z"][*axis]
            ),
            Self::PlaneNotAnEnd { axis, at, end } => {
                let axis = ["x", "y", "z"][*axis];
                write!(
                    f,
                    "hexahedra of a file are the part beyond a plane of symmetry: {axis} = {at:.4e} m must be their \
                     end `{axis}min`, a plane face, but they reach down to {end:.4e} m"
                )
            }
            Self::PlaneThroughPoints { axis } => {
                write!(
                    f,
                    "points without cells have no plane of symmetry normal to {}",
                    ["x", "y", "z"][*axis]
                )
            }
            Self::TooManyParticles { count, limit } => {
                write!(f, "the spacing asks for {count:.3e} particles, at most {limit} are accepted")
            }
            Self::InvertedCell { position: x, determinant } => write!(
                f,
                "the cell at X = ({:.4e}, {:.4e}, {:.4e}) m is turned inside out (relative determinant \
                 {determinant:.2e}): less jitter or a finer spacing is required",
                x.x, x.y, x.z
            ),
            Self::BadSmoothing { smoothing } => {
                write!(f, "h/dx = {smoothing} is not a positive, finite number")
            }
            Self::SingularMoments { particle, position: x, neighbours } => write!(
                f,
                "particle {particle}, X = ({:.4e}, {:.4e}, {:.4e}) m, has {neighbours} neighbours, which do not \
                 span space: a greater h/dx or a finer spacing is required",
                x.x, x.y, x.z
            ),
            Self::SingularQuadratics { particle, position: x, neighbours } => write!(
                f,
                "particle {particle}, X = ({:.4e}, {:.4e}, {:.4e}) m, has {neighbours} neighbours, which do not tell \
                 quadratic fields apart: `completeness = quadratic` needs three layers of particles across the \
                 body, so write a finer spacing, a greater smoothing or `completeness = linear`",
                x.x, x.y, x.z
            ),
            Self::ConstraintNotMet { particle, position: x, leftover, iterations, quadratic } => write!(
                f,
                "integration consistency is missed by {leftover:.2e} dx^2 at particle {particle}, X = ({:.4e}, \
                 {:.4e}, {:.4e}) m, after {iterations} iterations: its neighbours hardly tell fields apart; {} is required",
                x.x,
                x.y,
                x.z,
                match quadratic {
                    true => "`completeness = linear`, a finer spacing or less jitter",
                    false => "a smoothing of 1.2, a finer spacing or less jitter",
                }
            ),
        }
    }
}

impl std::error::Error for DiscretisationError {}
