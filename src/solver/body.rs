//! The state of one body and the constants its passes read.
//!
//! Owns the arrays. Knows nothing of how a step is put together.

use super::constraint::Support;
use super::dissipation::Speeds;
use super::exact::Exact;
use super::hourglass::{Hourglass, Packet};
use super::links::Links;
use super::quad::{Columns, Quad};
use super::time_step::Rates;
use crate::discretisation::Particles;
use crate::energy::{Directions, Law, Maps, Scratch};
use crate::tensor::{Mat3, Vec3};

/// Particles of one unit of parallel work. Fixed, so that no result depends on the thread count.
pub const CHUNK: usize = 64;

/// Maps of the particles of one chunk; nothing but the chunk itself reads them.
#[derive(Debug, Clone, Default)]
pub struct Block {
    /// First particle.
    pub start: usize,
    /// Deformation gradients.
    pub f: Vec<Mat3>,
    /// Area maps, empty where derived.
    pub h: Vec<Mat3>,
    /// Volume maps, empty where derived.
    pub j: Vec<f64>,
    /// D(J) of the last force pass, empty where off, 1/s.
    pub volume_dissipation: Vec<f64>,
    /// Copies of `f`, `h`, `j` at the start of a Runge–Kutta step.
    pub saved: (Vec<Mat3>, Vec<Mat3>, Vec<f64>),
    /// First particle of the chunk whose state is inadmissible.
    pub failure: Option<Failure>,
    /// Greatest `|Grad v|²` of the last evaluation, 1/s².
    pub straining: f64,
    /// Greatest wave speed in the chunk at the last refresh and its particle, m/s.
    pub fastest: (f64, usize),
}

impl Block {
    /// The maps as the energy reads them.
    pub fn maps(&self) -> Maps<'_> {
        Maps {
            f: &self.f,
            h: (!self.h.is_empty()).then_some(&self.h[..]),
            j: (!self.j.is_empty()).then_some(&self.j[..]),
        }
    }
}

/// An inadmissible state found by the stress pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Failure {
    /// `J ≤ 0`, or not a number, at a particle.
    Jacobian {
        /// Index in the body.
        particle: usize,
        /// Its `J`.
        value: f64,
    },
    /// The stress is not finite at a particle.
    Stress {
        /// Index in the body.
        particle: usize,
    },
}

/// Scratch memory of one thread.
#[derive(Debug, Default)]
pub struct Workspace {
    /// The energy's registers.
    pub energy: Scratch,
    /// Stresses of a chunk.
    pub stress: Vec<Mat3>,
    /// Numbers of a chunk.
    pub numbers: Vec<f64>,
    /// Vectors of a chunk.
    pub vectors: Vec<Vec3>,
}

/// Unit directions of a body's material.
#[derive(Debug, Clone)]
pub enum DirectionField {
    /// The same everywhere.
    Uniform(Vec<Vec3>),
    /// A set a particle, `count` each.
    Varying {
        /// Directions a particle.
        count: usize,
        /// All of them, particle by particle.
        values: Vec<Vec3>,
    },
}

impl DirectionField {
    /// The directions of `len` particles from `start` on.
    pub fn slice(&self, start: usize, len: usize) -> Directions<'_> {
        match self {
            Self::Uniform(values) => Directions::Uniform(values),
            Self::Varying { count, values } => Directions::PerParticle {
                count: *count,
                values: &values[start * count..(start + len) * count],
            },
        }
    }

    /// The directions of one particle.
    pub fn of(&self, particle: usize) -> &[Vec3] {
        match self {
            Self::Uniform(values) => values,
            Self::Varying { count, values } => &values[particle * count..(particle + 1) * count],
        }
    }
}

/// Everything a simulation holds of one body.
#[derive(Debug)]
pub struct BodyState {
    /// Its name.
    pub name: String,
    /// Its nodes in the reference configuration.
    pub particles: Particles,
    /// `1/V_a`, 1/m³.
    pub inverse_volume: Vec<f64>,
    /// Its pairs.
    pub links: Links,
    /// `ρR`, kg/m³.
    pub density: f64,
    /// Its constitutive law.
    pub law: Law,
    /// Its directions.
    pub directions: DirectionField,
    /// Current positions, m.
    pub x: Vec<Quad>,
    /// Velocities `p/ρR`, m/s.
    pub v: Vec<Quad>,
    /// Copies of `x` and `v` at the start of a Runge–Kutta step.
    pub saved: (Vec<Quad>, Vec<Quad>),
    /// Maps, chunk by chunk.
    pub blocks: Vec<Block>,
    /// Gradients and spin, what neighbours read of a motion.
    pub packets: Vec<Packet>,
    /// First Piola–Kirchhoff stress of the energy, Pa.
    pub stress: Vec<Columns>,
    /// Area maps as neighbours read them, empty without volume dissipation.
    pub area_map: Vec<Columns>,
    /// Springs and dashpots against what no gradient sees, where the scene has any.
    pub hourglass: Option<Hourglass>,
    /// Square of the fastest frequency the penalty adds, 1/s².
    pub hourglass_rate: f64,
    /// `dp/dt / ρR` of the last evaluation, m/s².
    pub acceleration: Vec<Quad>,
    /// External force per reference volume, empty without loads, N/m³.
    pub external: Vec<Quad>,
    /// The exact motion it is to follow.
    pub exact: Option<Exact>,
    /// Supports and planes of symmetry.
    pub supports: Vec<Support>,
    /// Wave speeds at rest.
    pub rest: Speeds,
    /// Length an elastic wave may travel in a step, m.
    pub elastic_length: f64,
    /// How fast the dissipation changes momentum and volume map.
    pub rates: Rates,
    /// Greatest initial speed, m/s.
    pub launch_speed: f64,
    /// Greatest wave speed now and its particle, m/s.
    pub fastest: (f64, usize),
}

impl BodyState {
    /// Deformation gradient of a particle.
    pub fn f(&self, particle: usize) -> &Mat3 {
        &self.blocks[particle / CHUNK].f[particle % CHUNK]
    }

    /// Area map of a particle if it is evolved.
    pub fn h(&self, particle: usize) -> Option<&Mat3> {
        self.blocks[particle / CHUNK].h.get(particle % CHUNK)
    }

    /// Volume map of a particle if it is evolved.
    pub fn j(&self, particle: usize) -> Option<f64> {
        self.blocks[particle / CHUNK].j.get(particle % CHUNK).copied()
    }

    /// First Piola–Kirchhoff stress of a particle at the last evaluation, that of its energy alone, Pa.
    pub fn stress(&self, particle: usize) -> Mat3 {
        self.stress[particle].matrix()
    }

    /// Greatest `|Grad v|` of the last evaluation, 1/s.
    pub fn straining(&self) -> f64 {
        libm::sqrt(self.blocks.iter().map(|block| block.straining).fold(0.0, f64::max))
    }

    /// The first support that prescribes a component of a particle, by its number.
    pub fn support_of(&self, particle: usize, axis: usize) -> Option<usize> {
        self.supports.iter().position(|s| s.axis == axis && s.nodes.binary_search(&(particle as u32)).is_ok())
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether the body has no particles; never so after assembly.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// Bytes of the arrays of the time loop, the pairs included.
    pub fn bytes(&self) -> usize {
        let maps: usize = self
            .blocks
            .iter()
            .map(|b| {
                (b.f.len() + b.h.len() + b.saved.0.len() + b.saved.1.len()) * size_of::<Mat3>()
                    + (b.j.len() + b.saved.2.len() + b.volume_dissipation.len()) * size_of::<f64>()
            })
            .sum();
        let quads = self.x.len() + self.v.len() + self.saved.0.len() + self.saved.1.len();
        maps + (quads + self.acceleration.len() + self.external.len()) * size_of::<Quad>()
            + self.packets.len() * size_of::<Packet>()
            + (self.stress.len() + self.area_map.len()) * size_of::<Columns>()
            + self.inverse_volume.len() * size_of::<f64>()
            + self.hourglass.as_ref().map_or(0, Hourglass::bytes)
            + self.links.bytes()
    }
}
