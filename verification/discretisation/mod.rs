//! Claims about shapes, stencils and corrected gradients.

use super::Claim;
use crate::discretisation::{Consistency, Kernel, Particles, Shape, Stencils};
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;

mod areas;
mod equilibrium;
mod order;
mod reproduction;
mod shapes;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    areas::VOLUME,
    areas::CLOSED_SURFACE,
    areas::FIRST_MOMENTS,
    reproduction::CONSTANTS,
    reproduction::COORDINATES,
    reproduction::AFFINE_MAP,
    equilibrium::BOUNDARY_AREAS,
    equilibrium::UNIFORM_TRACTION,
    order::INSIDE,
    order::EVERYWHERE,
    order::JITTERED,
    shapes::VOLUME,
    shapes::AFFINE_MAP,
    shapes::UNIFORM_TRACTION,
];

/// Figures of these claims.
pub(crate) const ILLUSTRATIONS: &[Illustration] =
    &[order::FIGURES[0], order::FIGURES[1], order::FIGURES[2], shapes::FIGURE];

/// Kernels every claim is measured for.
const KERNELS: [Kernel; 4] =
    [Kernel::WendlandC2, Kernel::CubicSpline, Kernel::QuinticSpline, Kernel::Quadratic];

/// Jitter and the `h/dx` that goes with it.
const LATTICES: [(f64, f64); 2] = [(0.0, 1.01), (0.3, 1.2)];

/// A block of unequal edges off the origin, cut by one plane of symmetry; edges are 1, 0.8 and 0.4 m.
fn block(spacing: f64, jitter: f64) -> Particles {
    let shape = Shape::Box { min: Vec3::new(-0.3, 0.1, -0.4), max: Vec3::new(0.7, 0.9, 0.4) };
    Particles::lattice(&shape, spacing, [None, None, Some(0.0)], jitter)
        .expect("0.4 m, 0.8 m and 1 m are multiples of 0.1 m and its halves")
}

/// Largest value of a measure over all kernels, both lattices and the consistencies given.
fn worst(consistencies: &[Consistency], measure: impl Fn(&Particles, &Stencils, Kernel, f64) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    for (jitter, smoothing) in LATTICES {
        let particles = block(0.1, jitter);
        for kernel in KERNELS {
            for &consistency in consistencies {
                let stencils = Stencils::build(&particles, kernel, smoothing, consistency)
                    .expect("a lattice of at least five nodes an edge has regular moments");
                let found = measure(&particles, &stencils, kernel, smoothing * particles.spacing);
                worst = if found.is_nan() { found } else { worst.max(found) };
            }
        }
    }
    worst
}
