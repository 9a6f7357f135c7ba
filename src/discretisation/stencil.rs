//! Neighbour lists and corrected gradients.

use crate::tensor::Vec3;

/// Smoothing kernels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kernel {
    /// Wendland's C2 function of support 2 h.
    WendlandC2,
    /// The cubic B-spline of support 2 h.
    CubicSpline,
}

/// What the corrected gradients are made to satisfy beyond linear exactness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Consistency {
    /// Nothing: the Bonet–Kulasegaram correction alone, as the paper has it.
    Kernel,
    /// `Σ_b V_b G_a(X_b) = A_a N_a` as well, the integration constraint.
    Integration,
}

/// Neighbours and corrected gradients of every particle, in compressed rows.
///
/// Row `a` holds its neighbours `b` in ascending order, `a` itself included. With
/// `G_b(X_a) = V_b ∇̃W̃_b(X_a)` the gradient of a field is `Σ_b f_b ⊗ G_b(X_a)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Stencils {
    /// Row `a` is `start[a] .. start[a + 1]`.
    pub start: Vec<u32>,
    /// Neighbour `b` of each entry.
    pub neighbour: Vec<u32>,
    /// `V_a G_b(X_a)` of each entry, m².
    pub forward: Vec<Vec3>,
    /// `V_b G_a(X_b)` of each entry, the entry `(b, a)` of `forward`, m².
    pub backward: Vec<Vec3>,
}
