//! Claims about momentum, angular momentum, energy and volume.

use super::Claim;

mod bonded;
mod momentum;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    momentum::FREE_BODY,
    momentum::FREE_BODY_HEUN,
    momentum::FREE_BODY_HOURGLASS,
    bonded::MOMENTUM,
    bonded::ONE_PLACE,
];
