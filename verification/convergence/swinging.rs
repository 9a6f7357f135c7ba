//! The swinging cube: a standing shear wave with an exact solution.

use super::orders::{Orders, order_claim, orders, unforced};
use crate::verify::claims::cube::{Case, Cube};
use crate::verify::{Claim, Shared};

/// Three coarse spacings, within two seconds.
pub(super) static QUICK: Shared<Orders> = Shared::new(|| orders(&[6, 8, 12], complete(0.3)));

/// The wrong variant, of another motion.
pub(super) static UNFORCED: Shared<Orders> = Shared::new(|| orders(&[4, 8], unforced));

/// The paper's choices: first-order interface states, areas wrong near the boundary.
pub(super) static SEED: Shared<Orders> =
    Shared::new(|| orders(&[6, 8, 12], |cells| Cube { run: "scheme = seed", ..swing(0.3, cells) }));

/// Four spacings at three ratios of Poisson.
pub(super) static FULL: Shared<[Orders; 3]> =
    Shared::new(|| [0.3, 0.45, 0.495].map(|ratio| orders(&[6, 8, 12, 16], complete(ratio))));

/// Four spacings with gradients exact for linear fields only.
pub(super) static LINEAR: Shared<Orders> = Shared::new(|| orders(&[6, 8, 12, 16], |cells| swing(0.3, cells)));

/// Four spacings with particles displaced by a fifth of the spacing.
pub(super) static JITTERED: Shared<Orders> = Shared::new(|| {
    let run = "completeness = quadratic  smoothing = 1.2";
    orders(&[6, 8, 12, 16], |cells| Cube { jitter: 0.2, run, ..swing(0.3, cells) })
});

/// The cube with every choice left to the improved scheme.
fn swing(ratio: f64, cells: u32) -> Cube {
    Cube::new(Case::Swinging(ratio), cells)
}

/// The same with gradients exact for quadratic fields.
fn complete(ratio: f64) -> impl Fn(u32) -> Cube {
    move |cells| Cube { run: "completeness = quadratic", ..swing(ratio, cells) }
}

const SOURCE: &str = "linear elastodynamics, amplitude 5e-4 of the edge, root mean square over one swing";

const MEAN: &str = "linear elastodynamics, amplitude 5e-4 of the edge, mean over one swing";

pub(super) const SECOND: &str = "differences are of order 2 inside and of order 1 in a layer of one spacing, which weighs as one \
                      spacing: order 2; a tenth less is allowed for the next term";

pub(super) const BOUNDARY: &str = "P and J are of order 1 at the boundary and of order 2 inside: 3/2 of the root mean square where the \
                        layer dominates, 2 of the mean; a tenth below what is claimed is allowed";

const ROUGH: &str = "the force of a smooth stress errs from node to node by the nodes' displacements, so P and J are of \
                     order 1 and positions, two integrations away, of order 2; a tenth below what is claimed is allowed";

/// The least of three orders.
fn least(of: fn(&Orders) -> f64) -> f64 {
    FULL.iter().map(of).fold(f64::INFINITY, |least, order| if order >= least { least } else { order })
}

order_claim!(
    /// Positions.
    POSITION, "positions of the swinging cube converge with order 1.9 at least, three spacings", 1.9, SOURCE, SECOND,
    QUICK.rms.position, SEED.rms.position
);
order_claim!(
    /// Velocities.
    VELOCITY, "velocities of the swinging cube converge with order 1.9 at least, three spacings", 1.9, SOURCE, SECOND,
    QUICK.rms.velocity, SEED.rms.velocity
);
order_claim!(
    /// Stresses.
    STRESS, "stresses of the swinging cube converge with order 1.8 at least in the mean, three spacings", 1.8, MEAN,
    BOUNDARY, QUICK.mean.stress, SEED.mean.stress
);
order_claim!(
    /// Volumes.
    VOLUME, "volume maps of the swinging cube converge with order 1.8 at least in the mean, three spacings", 1.8, MEAN,
    BOUNDARY, QUICK.mean.volume_map, SEED.mean.volume_map
);

order_claim!(
    /// Positions at three ratios of Poisson.
    POSITION_FULL,
    "positions of the swinging cube converge with order 1.9 at least, Poisson's ratio .3, .45 and .495, four spacings",
    1.9, SOURCE, SECOND, least(|orders| orders.rms.position), SEED.rms.position
);
order_claim!(
    /// Velocities likewise.
    VELOCITY_FULL,
    "velocities of the swinging cube converge with order 1.9 at least, Poisson's ratio .3, .45 and .495, four spacings",
    1.9, SOURCE, SECOND, least(|orders| orders.rms.velocity), SEED.rms.velocity
);
order_claim!(
    /// Stresses likewise, in the mean.
    STRESS_FULL,
    "stresses of the swinging cube converge with order 1.8 at least in the mean, Poisson's ratio .3, .45 and .495, \
     four spacings",
    1.8, MEAN, BOUNDARY, least(|orders| orders.mean.stress), SEED.mean.stress
);
order_claim!(
    /// Volumes likewise, in the mean.
    VOLUME_FULL,
    "volume maps of the swinging cube converge with order 1.8 at least in the mean, Poisson's ratio .3, .45 and .495, \
     four spacings",
    1.8, MEAN, BOUNDARY, least(|orders| orders.mean.volume_map), SEED.mean.volume_map
);
order_claim!(
    /// Positions with linearly exact gradients, the default.
    POSITION_LINEAR,
    "positions of the swinging cube converge with order 1.8 at least with gradients exact for linear fields, four \
     spacings",
    1.8, SOURCE, SECOND, LINEAR.rms.position, SEED.rms.position
);
order_claim!(
    /// Velocities likewise.
    VELOCITY_LINEAR,
    "velocities of the swinging cube converge with order 1.9 at least with gradients exact for linear fields, four \
     spacings",
    1.9, SOURCE, SECOND, LINEAR.rms.velocity, SEED.rms.velocity
);
order_claim!(
    /// Positions on an irregular lattice; the control is the seed scheme on a regular one.
    POSITION_JITTERED,
    "positions of the swinging cube converge with order 1.9 at least, jitter 0.2, four spacings",
    1.9, SOURCE, ROUGH, JITTERED.rms.position, SEED.rms.position
);
order_claim!(
    /// Velocities likewise.
    VELOCITY_JITTERED,
    "velocities of the swinging cube converge with order 1.9 at least, jitter 0.2, four spacings",
    1.9, SOURCE, ROUGH, JITTERED.rms.velocity, SEED.rms.velocity
);
order_claim!(
    /// Stresses on an irregular lattice.
    STRESS_JITTERED,
    "stresses of the swinging cube converge with order 1 at least, jitter 0.2, four spacings",
    1.0, SOURCE, ROUGH, JITTERED.rms.stress, UNFORCED.rms.stress
);
