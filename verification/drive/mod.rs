//! Claims about one material point under mixed control.

use super::Claim;

mod homogeneous;
mod invariance;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    homogeneous::ARTERY,
    homogeneous::SKIN,
    homogeneous::INCOMPRESSIBLE_SKIN,
    homogeneous::EQUILIBRIUM,
    invariance::STEPS,
    invariance::AXES,
];
