//! Large motions of nonlinear solids, the body force derived from them.

use super::orders::{Orders, order_claim, orders};
use super::swinging::{BOUNDARY, SECOND, UNFORCED};
use crate::verify::claims::cube::{Case, Cube};
use crate::verify::{Claim, Shared};

/// A cube without dissipation, which a motion without zero-energy modes does not need.
fn undamped(case: Case) -> impl Fn(u32) -> Cube {
    move |cells| Cube { run: "momentum_dissipation = off", ..Cube::new(case, cells) }
}

pub(super) static QUICK: Shared<Orders> = Shared::new(|| orders(&[6, 8, 12], undamped(Case::MovedFibres)));

pub(super) static FULL: Shared<[Orders; 2]> = Shared::new(|| {
    [Case::MovedNeoHooke, Case::MovedFibres].map(|case| orders(&[8, 12, 16, 24], undamped(case)))
});

/// The paper's choices, on the same solids.
pub(super) static SEED: Shared<[Orders; 2]> = Shared::new(|| {
    [Case::MovedNeoHooke, Case::MovedFibres]
        .map(|case| orders(&[6, 8, 12], |cells| Cube { run: "scheme = seed", ..Cube::new(case, cells) }))
});

/// The lesser of two orders.
fn least(of: fn(&Orders) -> f64) -> f64 {
    FULL.iter().map(of).fold(f64::INFINITY, |least, order| if order >= least { least } else { order })
}

const SOURCE: &str = "a motion of strains up to a fifth, the residual of which is claimed above";

order_claim!(
    /// Positions where fibres are pulled.
    POSITION, "positions of a moved fibrous cube converge with order 1.8 at least, three spacings", 1.8, SOURCE, SECOND,
    QUICK.rms.position, UNFORCED.rms.position
);
order_claim!(
    /// Stresses likewise, in the mean.
    STRESS, "stresses of a moved fibrous cube converge with order 1.8 at least in the mean, three spacings", 1.8,
    SOURCE, BOUNDARY, QUICK.mean.stress, UNFORCED.mean.stress
);
order_claim!(
    /// Positions of two solids.
    POSITION_FULL, "positions of a moved cube converge with order 1.8 at least, neo-Hookean and fibrous, four spacings",
    1.8, SOURCE, SECOND, least(|orders| orders.rms.position), UNFORCED.rms.position
);
order_claim!(
    /// Velocities of two solids.
    VELOCITY_FULL, "velocities of a moved cube converge with order 1.7 at least, neo-Hookean and fibrous, four spacings",
    1.7, SOURCE, SECOND, least(|orders| orders.rms.velocity), UNFORCED.rms.velocity
);
order_claim!(
    /// Stresses of two solids, in the mean.
    STRESS_FULL, "stresses of a moved cube converge with order 1.8 at least in the mean, neo-Hookean and fibrous",
    1.8, SOURCE, BOUNDARY, least(|orders| orders.mean.stress), UNFORCED.mean.stress
);
order_claim!(
    /// Volumes of two solids, in the mean.
    VOLUME_FULL, "volume maps of a moved cube converge with order 1.8 at least in the mean, neo-Hookean and fibrous",
    1.8, SOURCE, BOUNDARY, least(|orders| orders.mean.volume_map), UNFORCED.mean.volume_map
);
