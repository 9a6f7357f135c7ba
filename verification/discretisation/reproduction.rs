//! Constant and linear fields have exact gradients.

use super::worst;
use crate::discretisation::{Consistency, Kernel, Particles, Row, Stencils};
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

const BOTH: &[Consistency] = &[Consistency::Kernel, Consistency::Integration];

/// `Σ_b G_b(X_a) = 0`.
pub(crate) const CONSTANTS: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "gradients of a constant vanish: sum of G_b = 0, jitter 0 and 0.3, every kernel",
    source: "NB25 (26), Bonet & Kulasegaram 2000",
    because: "50 entries of at most 1/dx, each the result of some 10 roundings of 1.1e-16",
    bound: 5e-14,
    measure: || {
        worst(BOTH, |particles, stencils, _, _| {
            largest(particles, |a| {
                stencils.row(a).forward.iter().sum::<Vec3>().norm() / particles.volume[a] * 0.1
            })
        })
    },
    control: || {
        worst(&[Consistency::Kernel], |particles, stencils, kernel, h| {
            largest(particles, |a| {
                uncorrected(particles, stencils, kernel, h, a).iter().sum::<Vec3>().norm() * 0.1
            })
        })
    },
};

/// `Σ_b X_b ⊗ G_b(X_a) = I`.
pub(crate) const COORDINATES: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "gradients of the coordinates are exact: sum of X_b (x) G_b = I, jitter 0 and 0.3, every kernel",
    source: "NB25 (26), Bonet & Kulasegaram 2000",
    because: "as for constants, times coordinates of up to 12 dx",
    bound: 6e-13,
    measure: || {
        worst(BOTH, |particles, stencils, _, _| {
            largest(particles, |a| {
                let row = stencils.row(a);
                let gradient: Mat3 = pairs(particles, row).map(|(x, g)| x * g.transpose()).sum();
                (gradient / particles.volume[a] - Mat3::identity()).norm()
            })
        })
    },
    control: || {
        worst(&[Consistency::Kernel], |particles, stencils, kernel, h| {
            largest(particles, |a| {
                let gradients = uncorrected(particles, stencils, kernel, h, a);
                let neighbours = stencils.row(a).neighbours.iter();
                let gradient: Mat3 = neighbours
                    .zip(&gradients)
                    .map(|(&b, g)| particles.position[b as usize] * g.transpose())
                    .sum();
                (gradient - Mat3::identity()).norm()
            })
        })
    },
};

/// The gradient of `x = F X + c`, formed with differences as the solver forms it, is `F`.
pub(crate) const AFFINE_MAP: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "an affine map has its own gradient, jitter 0 and 0.3, every kernel",
    source: "NB25 (28) with the differences p_b - p_a",
    because: "50 differences of at most 3 dx, rounded at the size of x (20 dx), times entries below 1/dx",
    bound: 2e-13,
    measure: || worst(BOTH, |particles, stencils, _, _| affine_error(particles, stencils, 1.0)),
    control: || {
        worst(&[Consistency::Kernel], |particles, stencils, kernel, h| {
            largest(particles, |a| {
                let gradients = uncorrected(particles, stencils, kernel, h, a);
                let x_a = affine(&particles.position[a]);
                let neighbours = stencils.row(a).neighbours.iter();
                let gradient: Mat3 = neighbours
                    .zip(&gradients)
                    .map(|(&b, g)| (affine(&particles.position[b as usize]) - x_a) * g.transpose())
                    .sum();
                (gradient - MAP).norm()
            })
        })
    },
};

/// A deformation gradient with no symmetry.
const MAP: Mat3 = Mat3::new(1.3, 0.4, -0.1, 0.0, 0.9, 0.2, 0.3, -0.2, 0.8);

/// Largest difference between the discrete gradient of the affine map and `factor` times its own.
pub(super) fn affine_error(particles: &Particles, stencils: &Stencils, factor: f64) -> f64 {
    largest(particles, |a| {
        let row = stencils.row(a);
        let x_a = affine(&particles.position[a]);
        let gradient: Mat3 = pairs(particles, row).map(|(x, g)| (affine(&x) - x_a) * g.transpose()).sum();
        (gradient / particles.volume[a] - factor * MAP).norm()
    })
}

fn affine(x: &Vec3) -> Vec3 {
    MAP * x + Vec3::new(0.5, -0.2, 0.1)
}

fn largest(particles: &Particles, measure: impl Fn(usize) -> f64) -> f64 {
    (0..particles.len()).map(measure).fold(0.0, |worst: f64, x| if x.is_nan() { x } else { worst.max(x) })
}

/// Position of each neighbour and `V_a G_b(X_a)`.
fn pairs<'a>(particles: &'a Particles, row: Row<'a>) -> impl Iterator<Item = (Vec3, Vec3)> + 'a {
    row.neighbours.iter().zip(row.forward).map(|(&b, &g)| (particles.position[b as usize], g))
}

/// `V_b ∇W_b(X_a)`: the gradients as the kernel gives them.
fn uncorrected(particles: &Particles, stencils: &Stencils, kernel: Kernel, h: f64, a: usize) -> Vec<Vec3> {
    let gradient = |&b: &u32| {
        let b = b as usize;
        particles.volume[b] * kernel.gradient(&(particles.position[a] - particles.position[b]), h)
    };
    stencils.row(a).neighbours.iter().map(gradient).collect()
}
