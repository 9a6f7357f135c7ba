//! Orders at which the gradients of a smooth field converge.

use super::super::picture::orders;
use super::block;
use crate::discretisation::{Consistency, Kernel, Particles, Stencils};
use crate::output::Figure;
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;
use crate::verify::{Claim, Topic};

/// Where the stencil is symmetric the second derivatives cancel: order 2.
pub(crate) const INSIDE: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "gradients of a smooth field converge with order 2 inside a regular lattice",
    source: "Taylor expansion, second-order terms cancel in a stencil symmetric about its particle",
    because: "next term of the expansion, relative (dx k)^2 / 12 at dx = 0.1 m, k = 3/m, moves the order by 0.02",
    bound: 0.05,
    measure: || (order(0.0, inner, Rule::Corrected) - 2.0).abs(),
    control: || (order(0.0, inner, Rule::Uncorrected) - 2.0).abs(),
};

/// One-sided stencils keep the second derivatives: order 1.
pub(crate) const EVERYWHERE: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "the largest error of a smooth field's gradients converges with order 1, boundary included",
    source: "Taylor expansion, linear exactness leaves the second-order term",
    because: "where the second derivative is largest the third vanishes; the fourth, relative (dx k)^2 / 12, \
              moves the order by 0.02",
    bound: 0.05,
    measure: || (order(0.0, |_| true, Rule::Corrected) - 1.0).abs(),
    control: || (order(0.0, |_| true, Rule::Uncorrected) - 1.0).abs(),
};

/// Irregular stencils keep the second derivatives everywhere: order 1.
pub(crate) const JITTERED: Claim = Claim {
    topic: Topic::Discretisation,
    claim: "the root mean square error of a smooth field's gradients converges with order 1 or more at jitter 0.3",
    source: "Taylor expansion, linear exactness leaves the second-order term",
    because: "1 inside, 3/2 from a boundary layer whose share shrinks with dx: their mixture is never below 1",
    bound: 0.05,
    measure: || (1.0 - order(0.3, |_| true, Rule::Corrected)).max(0.0),
    control: || (1.0 - order(0.3, |_| true, Rule::Uncorrected)).max(0.0),
};

/// Errors over spacing.
pub(super) const FIGURES: [Illustration; 3] = [
    Illustration { claim: INSIDE.claim, figure: || figure("largest error inside", 0.0, inner, 2.0) },
    Illustration {
        claim: EVERYWHERE.claim,
        figure: || figure("largest error, boundary included", 0.0, |_| true, 1.0),
    },
    Illustration {
        claim: JITTERED.claim,
        figure: || figure("root mean square error, jitter 0.3", 0.3, |_| true, 1.0),
    },
];

fn figure(title: &str, jitter: f64, which: fn(&Vec3) -> bool, order: f64) -> Figure {
    let errors = |rule: Rule| {
        [0.1, 0.05, 0.025]
            .map(|spacing| (spacing, error(&block(spacing, jitter), jitter, which, rule)))
            .to_vec()
    };
    let lines = [("corrected", errors(Rule::Corrected)), ("not corrected", errors(Rule::Uncorrected))];
    orders(title, ("spacing", "m"), ("error of the gradient", "1/m"), &lines, order)
}

/// With which gradients.
#[derive(Clone, Copy)]
enum Rule {
    Corrected,
    Uncorrected,
}

/// Observed order between spacings of 0.1 and 0.05 m; regular lattices by the largest error, others by the
/// root mean square, over the particles `which` selects.
fn order(jitter: f64, which: fn(&Vec3) -> bool, rule: Rule) -> f64 {
    let error = |spacing: f64| error(&block(spacing, jitter), jitter, which, rule);
    libm::log2(error(0.1) / error(0.05))
}

/// At least two of the coarser spacings away from every face of the block.
fn inner(x: &Vec3) -> bool {
    let margin = 0.199;
    (x.x - 0.2).abs() < 0.5 - margin
        && (x.y - 0.5).abs() < 0.4 - margin
        && (x.z - 0.2).abs() < 0.2 - margin + 1e-9
}

fn field(x: &Vec3) -> f64 {
    libm::sin(1.0 + 2.0 * x.x - x.y + 2.0 * x.z)
}

fn exact(x: &Vec3) -> Vec3 {
    libm::cos(1.0 + 2.0 * x.x - x.y + 2.0 * x.z) * Vec3::new(2.0, -1.0, 2.0)
}

fn error(particles: &Particles, jitter: f64, which: fn(&Vec3) -> bool, rule: Rule) -> f64 {
    let smoothing = if jitter > 0.0 { 1.2 } else { 1.01 };
    let kernel = Kernel::WendlandC2;
    let stencils = Stencils::build(particles, kernel, smoothing, Consistency::Integration)
        .expect("a lattice of at least five nodes an edge has regular moments");
    let gradient = |a: usize| -> Vec3 {
        let row = stencils.row(a);
        let x_a = &particles.position[a];
        row.neighbours.iter().zip(row.forward).fold(Vec3::zeros(), |sum, (&b, g)| {
            let b = b as usize;
            let x_b = &particles.position[b];
            let g = match rule {
                Rule::Corrected => g / particles.volume[a],
                Rule::Uncorrected => {
                    particles.volume[b] * kernel.gradient(&(x_a - x_b), smoothing * particles.spacing)
                }
            };
            sum + (field(x_b) - field(x_a)) * g
        })
    };
    let selected: Vec<usize> = (0..particles.len()).filter(|&a| which(&particles.position[a])).collect();
    let squares = selected.iter().map(|&a| (gradient(a) - exact(&particles.position[a])).norm_squared());
    if jitter > 0.0 {
        (squares.sum::<f64>() / selected.len() as f64).sqrt()
    } else {
        squares.fold(0.0, f64::max).sqrt()
    }
}
