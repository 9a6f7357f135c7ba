//! Curved bodies: what holds for a lattice holds for them.

use crate::discretisation::{Consistency, Kernel, Particles, Shape, Stencils};
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::orders;
use crate::verify::{Claim, Topic};

use super::equilibrium::imbalance;
use super::reproduction::affine_error;

/// The volume of a cylinder converges with the square of the spacing.
pub(crate) const VOLUME: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "the volume of a cylinder converges with order 2",
    source: "nodes on the surface, chords between them: 2/3 of a sagitta",
    because: "next term of the chord's expansion (1.4 dx / r)^2 / 20 = 0.004 at dx = 0.2 r, \
              and the count of chords, a whole number near 2 pi r / 1.2 dx = 26, to within two",
    bound: 0.12,
    measure: || (volume_order(1.0) - 2.0).abs(),
    control: || (volume_order(1.02) - 2.0).abs(),
};

/// Uniform traction on curved boundaries, with holes, arcs and re-entrant edges.
pub(crate) const UNIFORM_TRACTION: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "a uniform stress is in equilibrium with its traction on a cylinder, a plate with four holes, \
            a dumbbell and an L-block",
    source: "NB25 (31)-(32) with P_a = P and t_B = P N",
    because: "conjugate gradients stop at a leftover of 1e-12 dx^2, summed over particles",
    bound: 1e-12,
    measure: || worst(Consistency::Integration, imbalance),
    control: || worst(Consistency::Kernel, imbalance),
};

/// An affine map on the same bodies.
pub(crate) const AFFINE_MAP: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "an affine map has its own gradient on a cylinder, a plate with four holes, a dumbbell and an L-block",
    source: "NB25 (28) with the differences p_b - p_a",
    because: "50 differences of at most 3 dx, rounded at the size of x (40 dx), times entries below 1/dx",
    bound: 4e-13,
    measure: || worst(Consistency::Integration, |particles, stencils| affine_error(particles, stencils, 1.0)),
    control: || {
        worst(Consistency::Integration, |particles, stencils| affine_error(particles, stencils, 1.001))
    },
};

/// Errors of the volume over the spacing.
pub(super) const FIGURE: Illustration = Illustration {
    claim: VOLUME.claim,
    figure: || {
        let errors =
            |factor: f64| [0.2, 0.1, 0.05].map(|spacing| (spacing, volume_error(spacing, factor))).to_vec();
        let lines = [("exact", errors(1.0)), ("2 % more (control)", errors(1.02))];
        orders("Volume of a cylinder", ("spacing", "m"), ("error of the volume", ""), &lines, 2.0)
    },
};

/// Observed order of the error against `factor` times the exact volume, radius 1 m, 0.2 and 0.1 m.
fn volume_order(factor: f64) -> f64 {
    libm::log2(volume_error(0.2, factor) / volume_error(0.1, factor))
}

fn volume_error(spacing: f64, factor: f64) -> f64 {
    let shape = Shape::Cylinder { centre: Vec3::zeros(), axis: 2, radius: 1.0, height: 1.0 };
    let volume: f64 = lattice(&shape, spacing, [None; 3]).volume.iter().sum();
    (volume - factor * std::f64::consts::PI).abs()
}

/// Largest value of a measure over the bodies; lengths are scaled to 1 m or so.
fn worst(consistency: Consistency, measure: impl Fn(&Particles, &Stencils) -> f64) -> f64 {
    let block = |min: [f64; 3], max: [f64; 3]| Shape::Box { min: min.into(), max: max.into() };
    let centre = Vec3::zeros();
    let plate = Shape::ring_of_holes(centre, 2, 1.0, 0.5, 0.15, 0.65, 4, std::f64::consts::FRAC_PI_4);
    let bodies = [
        (Shape::Cylinder { centre, axis: 1, radius: 0.5, height: 0.6 }, 0.1, [None; 3]),
        (plate, 0.09, [Some(0.0), Some(0.0), None]),
        (Shape::astm_d412_die_c(centre, 2.25e-3), 1e-3, [Some(0.0); 3]),
        (
            Shape::Union(vec![block([0.3, 0.0, 0.0], [0.6, 0.3, 0.3]), block([0.0; 3], [0.3, 1.0, 0.3])]),
            0.1,
            [None; 3],
        ),
    ];
    let mut worst = 0.0_f64;
    for (shape, spacing, symmetry) in bodies {
        let particles = lattice(&shape, spacing, symmetry);
        let stencils = Stencils::build(&particles, Kernel::WendlandC2, 1.2, consistency)
            .expect("bodies of two layers and more have regular moments");
        let found = measure(&particles, &stencils);
        worst = if found.is_nan() { found } else { worst.max(found) };
    }
    worst
}

fn lattice(shape: &Shape, spacing: f64, symmetry: [Option<f64>; 3]) -> Particles {
    Particles::lattice(shape, spacing, symmetry, 0.0).expect("the spacing resolves every radius")
}
