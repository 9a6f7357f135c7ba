//! Claims about the maps F, H and J against the positions they describe.

use super::Claim;

mod gradient;
mod traction;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    gradient::VERLET,
    gradient::HEUN,
    gradient::TRANSLATION,
    gradient::ROTATION,
    traction::PATCH,
    traction::PATCH_HOURGLASS,
];
