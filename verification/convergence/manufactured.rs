//! Large motions of nonlinear solids, the body force derived from them.

use super::orders::{Orders, order_claim, orders};
use super::swinging::{SECOND, UNFORCED, least};

use crate::verify::claims::cube::{Case, Cube};
use crate::verify::{Claim, Shared};

/// A cube with gradients exact for quadratic fields.
fn complete(case: Case, jitter: f64) -> impl Fn(u32) -> Cube {
    move |cells| Cube { run: "completeness = quadratic", jitter, ..Cube::new(case, cells) }
}

pub(super) static QUICK: Shared<Orders> =
    Shared::new(|| orders(&[6, 8, 12], complete(Case::MovedFibres, 0.0)));

pub(super) static FULL: Shared<[Orders; 2]> = Shared::new(|| {
    [Case::MovedNeoHooke, Case::MovedFibres].map(|case| orders(&[6, 8, 12, 16], complete(case, 0.0)))
});

/// With particles displaced by a fifth of the spacing.
pub(super) static JITTERED: Shared<[Orders; 2]> = Shared::new(|| {
    [Case::MovedNeoHooke, Case::MovedFibres].map(|case| orders(&[8, 12, 16, 24], complete(case, 0.2)))
});

/// The paper's choices, on the same solids.
pub(super) static SEED: Shared<[Orders; 2]> = Shared::new(|| {
    [Case::MovedNeoHooke, Case::MovedFibres]
        .map(|case| orders(&[6, 8, 12], |cells| Cube { run: "scheme = seed", ..Cube::new(case, cells) }))
});

const SOURCE: &str = "a motion of strains up to a fifth, the residual of which is claimed above";

order_claim!(
    /// Positions where fibres are pulled.
    POSITION, "positions of a moved fibrous cube converge with order 1.9 at least, three spacings", 1.9, SOURCE, SECOND,
    QUICK.rms.position, UNFORCED.rms.position
);
order_claim!(
    /// Stresses likewise.
    STRESS, "stresses of a moved fibrous cube converge with order 1.8 at least, three spacings", 1.8, SOURCE, SECOND,
    QUICK.rms.stress, UNFORCED.rms.stress
);
order_claim!(
    /// Positions of two solids.
    POSITION_FULL,
    "positions of a moved cube converge with order 1.9 at least, neo-Hookean and fibrous, four spacings",
    1.9, SOURCE, SECOND, least(&*FULL, |errors| errors.position), UNFORCED.rms.position
);
order_claim!(
    /// Velocities likewise.
    VELOCITY_FULL,
    "velocities of a moved cube converge with order 1.9 at least, neo-Hookean and fibrous, four spacings",
    1.9, SOURCE, SECOND, least(&*FULL, |errors| errors.velocity), UNFORCED.rms.velocity
);
order_claim!(
    /// Stresses likewise.
    STRESS_FULL,
    "stresses of a moved cube converge with order 1.8 at least, neo-Hookean and fibrous, four spacings",
    1.8, SOURCE, SECOND, least(&*FULL, |errors| errors.stress), UNFORCED.rms.stress
);
order_claim!(
    /// Volumes likewise.
    VOLUME_FULL,
    "volume maps of a moved cube converge with order 1.8 at least, neo-Hookean and fibrous, four spacings",
    1.8, SOURCE, SECOND, least(&*FULL, |errors| errors.volume_map), UNFORCED.rms.volume_map
);
order_claim!(
    /// Positions of two solids on irregular lattices.
    POSITION_JITTERED,
    "positions of a moved cube converge with order 1.9 at least, neo-Hookean and fibrous, jitter 0.2, four spacings",
    1.9, SOURCE, SECOND, least(&*JITTERED, |errors| errors.position), UNFORCED.rms.position
);
order_claim!(
    /// Velocities likewise.
    VELOCITY_JITTERED,
    "velocities of a moved cube converge with order 1.9 at least, neo-Hookean and fibrous, jitter 0.2, four spacings",
    1.9, SOURCE, SECOND, least(&*JITTERED, |errors| errors.velocity), UNFORCED.rms.velocity
);
order_claim!(
    /// Stresses likewise.
    STRESS_JITTERED,
    "stresses of a moved cube converge with order 1.8 at least, neo-Hookean and fibrous, jitter 0.2, four spacings",
    1.8, SOURCE, SECOND, least(&*JITTERED, |errors| errors.stress), UNFORCED.rms.stress
);
order_claim!(
    /// Volumes likewise.
    VOLUME_JITTERED,
    "volume maps of a moved cube converge with order 1.8 at least, neo-Hookean and fibrous, jitter 0.2, four spacings",
    1.8, SOURCE, SECOND, least(&*JITTERED, |errors| errors.volume_map), UNFORCED.rms.volume_map
);
