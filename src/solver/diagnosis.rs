//! Which particle left the domain of its energy, and what most likely drove it there.
//!
//! Owns the error a failed stress pass becomes, with the guess it ends with. Reads the state, changes
//! nothing.

use super::body::{BodyState, Failure};
use super::error::{Cause, SolveError};
use crate::scene::{Run, VolumeDissipation};
use crate::tensor::{Vec3, cofactor, volume_map};

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
/// number is known, a load faster than sound, one beyond the stiffness at rest and a lost extent can be measured,
/// an overflow shows in the stretch.
pub fn cause(body: &BodyState, particle: usize, run: &Run, step: f64) -> Cause {
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
    let limit = run.courant_limit();
    if run.cfl > limit {
        return Cause::CourantNumber { cfl: run.cfl, limit };
    }
    if let Some(cause) = outgrown(body, run, limit) {
        return cause;
    }
    let driven = body.supports.iter().map(|support| support.velocity(0, step).abs());
    let mach = driven.fold(body.launch_speed, f64::max) / body.rest.pressure;
    if mach > LOUD {
        return Cause::LoadTooFast(mach);
    }
    if let Some(cause) = overload(body).or_else(|| squeezed(body)) {
        return cause;
    }
    let stretch = libm::sqrt((f.transpose() * f).trace().max(0.0));
    if stretch.is_finite() && det > 0.0 && stretch > 1.0 && body.law.directions() > 0 {
        return Cause::FibreOverflow(libm::sqrt((f.transpose() * f).symmetric_eigenvalues().max()));
    }
    Cause::Unknown
}

/// A material that has stiffened beyond the step, where the wave speed at rest is kept.
///
/// Held against the limit is the median of the speeds of all particles, of which a few broken ones decide nothing.
fn outgrown(body: &BodyState, run: &Run, limit: f64) -> Option<Cause> {
    if run.wave_speed_every > 0 {
        return None;
    }
    let speed = |a: usize| {
        let speeds = body.law.wave_speeds(body.f(a), body.directions.of(a), body.density);
        speeds.map_or(f64::INFINITY, |speeds| speeds.pressure)
    };
    let mut speeds: Vec<f64> = (0..body.len()).map(speed).collect();
    speeds.sort_by(f64::total_cmp);
    let ratio = speeds[speeds.len() / 2] / body.rest.pressure;
    (run.cfl * ratio > limit).then_some(Cause::OutgrownStep { ratio })
}

/// A load beyond the stiffness of the material at rest.
///
/// ```text
/// max( |Σ_face V_a E_a| / |Σ_face A_a|,  |Σ V_a E_a| e/V )  >  ρ c²
/// ```
///
/// over the faces, and over the whole body with its extent `e` along the force, for what acts within it. `c` is
/// the speed of shear waves; fibres carry far more than the matrix at rest, so with directions that of pressure
/// waves.
fn overload(body: &BodyState) -> Option<Cause> {
    if body.external.is_empty() {
        return None;
    }
    let particles = &body.particles;
    let force = |a: usize| particles.volume[a] * body.external[a].vector();
    let on_faces = particles.faces.iter().map(|face| {
        let total: Vec3 = face.nodes.iter().map(|&a| force(a as usize)).sum();
        total.norm() / face.area.iter().sum::<Vec3>().norm()
    });
    let total: Vec3 = (0..body.len()).map(force).sum();
    let axis = total.iamax();
    let (low, high) = extent(particles.position.iter().map(|x| x[axis]));
    let within = total.norm() * (high - low) / particles.volume.iter().sum::<f64>();
    // a closed face has no area of its own: no load per area either
    let load = on_faces.chain([within]).filter(|load| load.is_finite()).fold(0.0, f64::max);
    let (speed, of) = match body.law.directions() {
        0 => (body.rest.shear, "shear modulus at rest"),
        _ => (body.rest.pressure, "modulus of pressure waves at rest"),
    };
    let modulus = body.density * speed * speed;
    (load > modulus).then_some(Cause::Overload { load, modulus, of })
}

/// A body whose ends along an axis have come close to one another, and not because it is bent.
///
/// Its ends are the nodes within half a spacing of its extent; bent, they meet while most of the body keeps its
/// least principal stretch.
fn squeezed(body: &BodyState) -> Option<Cause> {
    let particles = &body.particles;
    let share = |axis: usize| {
        let (low, high) = extent(particles.position.iter().map(|x| x[axis]));
        let mean_near = |end: f64| {
            let near = |x: &Vec3| (x[axis] - end).abs() < 0.5 * particles.spacing;
            let nodes = particles.position.iter().zip(&body.x).filter(|(x, _)| near(x));
            let (count, sum) = nodes.fold((0.0, 0.0), |(count, sum), (_, x)| (count + 1.0, sum + x.0[axis]));
            sum / count
        };
        (axis, (mean_near(high) - mean_near(low)) / (high - low))
    };
    let (axis, share) = (0..3).map(share).min_by(|a, b| a.1.total_cmp(&b.1))?;
    let stretches = (0..body.len()).filter_map(|a| {
        let f = body.f(a);
        let is_sound = volume_map(f, &cofactor(f)) > 0.0;
        is_sound.then(|| libm::sqrt((f.transpose() * f).symmetric_eigenvalues().min().max(0.0)))
    });
    let (count, sum) = stretches.fold((0.0, 0.0), |(count, sum), stretch| (count + 1.0, sum + stretch));
    let stretch = sum / count;
    (share < FLAT && stretch < PRESSED).then_some(Cause::Squeezed {
        axis: ['x', 'y', 'z'][axis],
        share,
        stretch,
    })
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// Share of its extent below which a body counts as squeezed flat.
const FLAT: f64 = 1.0 / 3.0;

/// Mean of the least principal stretches above which a body is bent rather than pressed.
const PRESSED: f64 = 0.75;

/// A gap between J and det F that can no longer be a truncation error.
const DRIFT: f64 = 0.1;

/// Mach number above which a load counts as an impact.
const LOUD: f64 = 0.5;
