//! Claims about orders of convergence, against exact motions and standing waves.

use super::Claim;

mod cube;
mod residual;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[residual::NEO_HOOKE, residual::FIBRES];
