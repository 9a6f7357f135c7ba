//! A homogeneous state and what is recorded of it.

use crate::tensor::Mat3;

/// A material point in equilibrium with its controls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Parameter of the path.
    pub parameter: f64,
    /// Deformation gradient.
    pub f: Mat3,
    /// Volume map `det F`.
    pub j: f64,
    /// First Piola–Kirchhoff stress, Pa.
    pub first_piola: Mat3,
    /// Cauchy stress, Pa.
    pub cauchy: Mat3,
    /// Strain energy per reference volume, Pa.
    pub psi: f64,
    /// Hydrostatic stress added by the constraint `J = 1`, Pa; zero for a compressible law.
    pub constraint_stress: f64,
    /// Largest difference between a stress and its prescribed value, Pa.
    pub residual: f64,
    /// Iterations since the point before.
    pub iterations: u32,
}

/// The unknowns of a state: F in the axes of control, and the stress of the constraint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unknowns {
    pub(super) f: Mat3,
    /// Hydrostatic stress `q` of `P = ∂ψ/∂F + q H`, Pa.
    pub(super) q: f64,
}
