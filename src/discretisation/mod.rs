//! Shapes to nodes, volumes and areas, to neighbours, to corrected gradients.
//!
//! Owns everything that is computed once from the reference configuration. Knows neither materials
//! nor momentum nor time.

mod balance;
mod centroid;
mod coarse;
mod columns;
mod conform;
mod conjugate;
mod correction;
mod error;
mod filled;
mod filling;
mod grid;
mod integration;
mod kernel;
mod lattice;
mod mesh;
mod moments;
mod nearest;
mod neighbour;
mod outline;
mod particles;
mod planar;
mod points;
mod prism;
mod quadratic;
mod quadrature;
mod relation;
mod shape;
mod shaping;
mod silhouette;
mod solid;
mod stability;
mod stencil;

pub use error::DiscretisationError;
pub use grid::quad_integrals;
pub use kernel::Kernel;
pub use mesh::Mesh;
pub use particles::{Bulge, FaceNodes, Particles};
pub use points::Points;
pub use shape::Shape;
pub use solid::Solid;
pub use stencil::{Consistency, Row, Stencils};
