//! What most likely drove a state out of its domain.
//!
//! Owns the guess that an error message ends with. Reads the state, changes nothing.

use super::body::BodyState;
use super::error::Cause;
use crate::scene::{Integrator, Run};
use crate::tensor::{cofactor, volume_map};

/// The likely cause of an inadmissible state at a particle.
///
/// Tested in the order of how certain each is: a drifted volume map can be measured, a Courant
/// number is known, a load faster than sound can be measured, an overflow shows in the stretch.
pub fn cause(body: &BodyState, particle: usize, run: &Run, step: f64) -> Cause {
    let f = body.f(particle);
    let det = volume_map(f, &cofactor(f));
    if run.volume_dissipation
        && let Some(j) = body.j(particle)
        && det.is_finite()
        && det > 0.0
        && (j - det).abs() > DRIFT
    {
        return Cause::VolumeDissipationDrift(j - det);
    }
    let limit = match run.integrator {
        Integrator::TvdRk2 => TVD_RK2_LIMIT,
        Integrator::VelocityVerlet => VERLET_LIMIT,
    };
    if run.cfl > limit {
        return Cause::CourantNumber(run.cfl);
    }
    let driven = body.supports.iter().map(|support| support.velocity(0, step).abs());
    let mach = driven.fold(body.launch_speed, f64::max) / body.rest.pressure;
    if mach > LOUD {
        return Cause::LoadTooFast(mach);
    }
    let stretch = libm::sqrt((f.transpose() * f).trace().max(0.0));
    if stretch.is_finite() && det > 0.0 && stretch > 1.0 && body.law.directions() > 0 {
        return Cause::FibreOverflow(libm::sqrt((f.transpose() * f).symmetric_eigenvalues().max()));
    }
    Cause::Unknown
}

/// A gap between J and det F that can no longer be a truncation error.
const DRIFT: f64 = 0.1;

/// Courant numbers up to which each integrator was measured stable (METHOD: trial, item 8).
const TVD_RK2_LIMIT: f64 = 1.0;
const VERLET_LIMIT: f64 = 1.0;

/// Mach number above which a load counts as an impact.
const LOUD: f64 = 0.5;
