//! Claims about orders of convergence, in the spacing and in the time step.

use super::Claim;

mod cube;
mod integrators;
mod residual;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] =
    &[residual::NEO_HOOKE, residual::FIBRES, integrators::TVD_RK2, integrators::SSP_RK3, integrators::VERLET];
