//! Claims about momentum, angular momentum, energy and volume.

use super::Claim;
use crate::verify::claim::Illustration;

mod angular;
mod balance;
mod bonded;
mod energy;
mod momentum;

/// Figures of these claims.
pub(crate) const ILLUSTRATIONS: &[Illustration] = &[
    momentum::FIGURES[0],
    momentum::FIGURES[1],
    momentum::FIGURES[2],
    momentum::FIGURES[3],
    balance::FIGURES[0],
    balance::FIGURES[1],
    balance::FIGURES[2],
    angular::FIGURES[0],
    angular::FIGURES[1],
    angular::FIGURES[2],
    angular::FIGURES[3],
    energy::FIGURES[0],
    energy::FIGURES[1],
    energy::FIGURES[2],
];

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    momentum::FREE_BODY,
    momentum::FREE_BODY_HEUN,
    momentum::FREE_BODY_HOURGLASS,
    bonded::MOMENTUM,
    bonded::ONE_PLACE,
    momentum::LONG_RUN,
    balance::VERLET,
    balance::HEUN,
    balance::SSP_RK3,
    angular::VERLET,
    angular::PROJECTED_HEUN,
    angular::PROJECTED_SSP_RK3,
    angular::HEUN_DRIFT,
    energy::DISSIPATION,
    energy::VARIATIONAL,
    energy::LOSS_PER_TURN,
];
