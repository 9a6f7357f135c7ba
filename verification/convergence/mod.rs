//! Claims about orders of convergence, in the spacing and in the time step.

use super::Claim;

mod figures;
mod integrators;
mod manufactured;
mod orders;
mod residual;
mod swinging;

pub(crate) use figures::ILLUSTRATIONS;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    residual::NEO_HOOKE,
    residual::FIBRES,
    residual::STANDING_WAVE,
    swinging::POSITION,
    swinging::VELOCITY,
    swinging::STRESS,
    swinging::VOLUME,
    manufactured::POSITION,
    manufactured::STRESS,
    integrators::TVD_RK2,
    integrators::SSP_RK3,
    integrators::VERLET,
];

/// Claims that take minutes.
pub(crate) const FULL: &[Claim] = &[
    swinging::POSITION_FULL,
    swinging::VELOCITY_FULL,
    swinging::STRESS_FULL,
    swinging::VOLUME_FULL,
    swinging::POSITION_LINEAR,
    swinging::VELOCITY_LINEAR,
    swinging::POSITION_JITTERED,
    swinging::VELOCITY_JITTERED,
    swinging::STRESS_JITTERED,
    swinging::VOLUME_JITTERED,
    manufactured::POSITION_FULL,
    manufactured::VELOCITY_FULL,
    manufactured::STRESS_FULL,
    manufactured::VOLUME_FULL,
    manufactured::POSITION_JITTERED,
    manufactured::VELOCITY_JITTERED,
    manufactured::STRESS_JITTERED,
    manufactured::VOLUME_JITTERED,
];
