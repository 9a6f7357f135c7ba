//! Which particle left the domain of its energy, and what most likely drove it there.
//!
//! Owns the error a failed stress pass becomes, with the guess it ends with. Reads the state, changes
//! nothing.

use super::body::{BodyState, Failure};
use super::error::{Cause, SolveError};
use crate::scene::{Integrator, Run, VolumeDissipation};
use crate::tensor::{cofactor, volume_map};

/// The first particle the last stress pass found inadmissible, as an error.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `bodies` | after a stress pass | |
/// | `run` | the scene's choices | |
/// | `step` | the step under way | s |
/// | `time` | at its start | s |
pub fn failure(bodies: &[BodyState], run: &Run, step: f64, time: f64) -> Option<SolveError> {
    let first = |body: &BodyState| body.blocks.iter().find_map(|block| block.failure);
    let (body, found) = bodies.iter().find_map(|body| first(body).map(|found| (body, found)))?;
    let (Failure::Jacobian { particle, .. } | Failure::Stress { particle }) = found;
    let starts = time == 0.0 && body.exact.is_some();
    let cause = if starts { Cause::ImproperMotion } else { cause(body, particle, run, step) };
    let position = body.particles.position[particle];
    let name = body.name.clone();
    let not_finite =
        |quantity| SolveError::NotFinite { quantity, particle, body: name.clone(), position, time, cause };
    Some(match found {
        Failure::Jacobian { value: jacobian, .. } if jacobian.is_finite() => {
            SolveError::NonPositiveJacobian { particle, body: name, position, time, jacobian, cause }
        }
        Failure::Jacobian { .. } => not_finite("deformation gradient"),
        Failure::Stress { .. } => not_finite("stress"),
    })
}

/// The first particle whose velocity is no number after a step, as an error.
pub fn not_finite(bodies: &[BodyState], run: &Run, step: f64, time: f64) -> Option<SolveError> {
    bodies.iter().find_map(|body| {
        let particle = body.v.iter().position(|v| !v.dot(*v).is_finite())?;
        Some(SolveError::NotFinite {
            quantity: "velocity",
            particle,
            body: body.name.clone(),
            position: body.particles.position[particle],
            time,
            cause: cause(body, particle, run, step),
        })
    })
}

/// The likely cause of an inadmissible state at a particle.
///
/// Tested in the order of how certain each is: a drifted volume map can be measured, a Courant
/// number is known, a load faster than sound can be measured, an overflow shows in the stretch.
fn cause(body: &BodyState, particle: usize, run: &Run, step: f64) -> Cause {
    let f = body.f(particle);
    let det = volume_map(f, &cofactor(f));
    if run.volume_dissipation != VolumeDissipation::Off
        && let Some(j) = body.j(particle)
        && (j - det).abs().partial_cmp(&DRIFT).is_none_or(std::cmp::Ordering::is_gt)
    {
        return Cause::VolumeDissipationDrift(j - det);
    }
    if let Some(support) = body.supports.iter().find(|support| !support.velocity(0, step).is_finite()) {
        return Cause::UndefinedMotion(['x', 'y', 'z'][support.axis]);
    }
    if body.external.iter().any(|force| !force.dot(*force).is_finite()) {
        return Cause::UndefinedLoad;
    }
    let limit = match run.integrator {
        Integrator::TvdRk2 => TVD_RK2_LIMIT,
        Integrator::SspRk3 => SSP_RK3_LIMIT,
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

/// Courant numbers up to which each integrator was measured stable, docs/seed_and_improved.md.
const TVD_RK2_LIMIT: f64 = 1.0;
const SSP_RK3_LIMIT: f64 = 1.0;
const VERLET_LIMIT: f64 = 1.0;

/// Mach number above which a load counts as an impact.
const LOUD: f64 = 0.5;
