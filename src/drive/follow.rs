//! A path of targets, followed point by point with steps as long as equilibrium allows.
//!
//! Owns the step control and the drive's public face.

use super::control::Target;
use super::error::{Cause, DriveError};
use super::state::Point;
use super::system::{Solved, System};
use crate::energy::{Law, Scratch};
use crate::tensor::{Mat3, Vec3};

/// Shortest step, as a part of the way between two points asked for.
const SHORTEST: f64 = 1e-9;
/// A step that took no more iterations than this is followed by one twice as long.
const EASY: u32 = 6;

/// Whether a law may change its volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Volume {
    /// As the law's volumetric part says.
    Compressible,
    /// `J = 1` exactly, with the hydrostatic stress as a further unknown.
    Incompressible,
}

/// A law at one material point, ready to be driven.
#[derive(Debug, Clone)]
pub struct Drive<'a> {
    /// The law.
    pub law: &'a Law,
    /// Unit vectors the law reads, in the common axes.
    pub directions: &'a [Vec3],
    /// Axes of the controls as columns, from [`super::frame`]; the identity for the common axes.
    pub frame: Mat3,
    /// Whether the volume may change.
    pub volume: Volume,
}

impl<'a> Drive<'a> {
    /// A compressible law controlled in the common axes.
    pub fn new(law: &'a Law, directions: &'a [Vec3]) -> Self {
        Self { law, directions, frame: Mat3::identity(), volume: Volume::Compressible }
    }

    /// Follows `path` and returns the equilibria at `parameters`, in that order.
    ///
    /// The first is approached from rest in proportion, each further one along the path from the one
    /// before. Where Newton's method fails the step is halved, where it is easy doubled, so that a law that
    /// stiffens exponentially is followed through its toe whatever the distance of the points. Tensors of
    /// the result are in the common axes.
    ///
    /// # Errors
    /// [`DriveError::NotFinite`], [`DriveError::PressureUndetermined`], [`DriveError::NoStart`], and
    /// [`DriveError::NoEquilibrium`] with the last equilibrium and the cause.
    ///
    /// # Panics
    /// If there are fewer directions than the law reads.
    pub fn follow(&self, path: impl Fn(f64) -> Target, parameters: &[f64]) -> Result<Vec<Point>, DriveError> {
        let mut points: Vec<Point> = Vec::with_capacity(parameters.len());
        self.visit(path, parameters, |point| points.push(*point))?;
        Ok(points)
    }

    /// [`Drive::follow`] with each equilibrium shown as it is found, so that none is lost to an error
    /// further on.
    ///
    /// # Errors
    /// As [`Drive::follow`].
    ///
    /// # Panics
    /// As [`Drive::follow`].
    pub fn visit(
        &self,
        path: impl Fn(f64) -> Target,
        parameters: &[f64],
        mut found: impl FnMut(&Point),
    ) -> Result<(), DriveError> {
        self.visit_solved(path, parameters, |system, solved, parameter| {
            found(&self.point(system, solved, parameter));
        })
    }

    /// [`Drive::visit`] with the equations each equilibrium solves.
    pub(super) fn visit_solved(
        &self,
        path: impl Fn(f64) -> Target,
        parameters: &[f64],
        mut found: impl FnMut(&mut System<'_>, &Solved, f64),
    ) -> Result<(), DriveError> {
        let mut system = System {
            law: self.law,
            directions: self.directions.iter().map(|a| self.frame.transpose() * a).collect(),
            is_incompressible: self.volume == Volume::Incompressible,
            scratch: Scratch::default(),
        };
        let Some(&first) = parameters.first() else { return Ok(()) };
        let start = path(first);
        let approach = |part: f64| start.scaled(part);
        let start_error =
            |cause| DriveError::NoStart { wanted: first, part: 0.0, f: Mat3::identity(), cause };
        let rest = system.rest().map_err(start_error)?;
        let (mut solved, _) = advance(&mut system, rest, &approach, (0.0, 1.0), 1.0).map_err(|stop| {
            let Stop { part, f, cause, .. } = stop;
            stop.described(first, DriveError::NoStart { wanted: first, part, f, cause })
        })?;
        found(&mut system, &solved, first);
        // The part of the way that went well lately is where the next step begins.
        let mut length = 1.0;
        for pair in parameters.windows(2) {
            let range = (pair[0], pair[1]);
            (solved, length) = advance(&mut system, solved, &path, range, length).map_err(|stop| {
                let Stop { at: reached, f, cause, .. } = stop;
                stop.described(range.1, DriveError::NoEquilibrium { reached, wanted: range.1, f, cause })
            })?;
            found(&mut system, &solved, pair[1]);
        }
        Ok(())
    }

    /// The record of an equilibrium, turned to the common axes.
    pub(super) fn point(&self, system: &mut System<'_>, solved: &Solved, parameter: f64) -> Point {
        let state = &solved.unknowns;
        let stresses = system.stresses(state);
        let turned = |tensor: &Mat3| self.frame * tensor * self.frame.transpose();
        Point {
            parameter,
            f: turned(&state.f),
            j: stresses.j,
            first_piola: turned(&stresses.first_piola),
            cauchy: turned(&stresses.cauchy),
            psi: system.density(&state.f),
            constraint_stress: state.q,
            residual: solved.residual,
            iterations: solved.iterations,
        }
    }
}

/// Where and why a way along a path ended.
#[derive(Debug, Clone, Copy)]
struct Stop {
    /// Part of the way covered.
    part: f64,
    /// Argument of the path there.
    at: f64,
    /// Deformation gradient there, in the axes of control.
    f: Mat3,
    cause: Cause,
}

impl Stop {
    /// The error to report: `without_equilibrium` unless the target itself is at fault.
    fn described(&self, parameter: f64, without_equilibrium: DriveError) -> DriveError {
        match self.cause {
            Cause::TargetNotFinite => DriveError::NotFinite { parameter },
            Cause::NoConditionForPressure => DriveError::PressureUndetermined { parameter },
            _ => without_equilibrium,
        }
    }
}

/// Largest change of F a step may make, relative to the F before.
///
/// Mirroring two axes of stretches `a` and `b` changes F by at least √((1 + a)² + (1 + b)²) > √2, so a step below
/// this stays on its branch; doubling a stretch at constant volume changes it by 1.08.
const LARGEST_CHANGE: f64 = 1.25;

/// The equilibrium a step found, unless it lies so far away that it may be of another branch: mirrored in two
/// axes, which `J > 0` does not tell, or run away where the law carries nothing.
fn near(before: &Solved, found: Solved, target: &Target) -> Result<Solved, Cause> {
    let (old, new) = (&before.unknowns.f, &found.unknowns.f);
    let Some(inverse) = old.try_inverse() else { return Ok(found) };
    let change = ((new - old) * inverse).norm();
    let is_free = target.unknowns().next().is_some();
    if is_free && (change.is_nan() || change > LARGEST_CHANGE) {
        return Err(Cause::Leap { change });
    }
    Ok(found)
}

/// Goes from the equilibrium `start` along `path` over the range of its argument.
///
/// Returns the equilibrium at the end, its iterations summed over the steps, and the length of step,
/// as a part of the range, that went well.
fn advance(
    system: &mut System<'_>,
    start: Solved,
    path: &dyn Fn(f64) -> Target,
    (from, to): (f64, f64),
    length: f64,
) -> Result<(Solved, f64), Stop> {
    let mut solved = Solved { iterations: 0, ..start };
    let (mut part, mut length) = (0.0, length);
    while part < 1.0 {
        let next = (part + length).min(1.0);
        let target = path(if next == 1.0 { to } else { from + next * (to - from) });
        match system.solve(&solved, &target).and_then(|step| near(&solved, step, &target)) {
            Ok(step) => {
                let iterations = solved.iterations + step.iterations;
                if step.iterations <= EASY {
                    length = (2.0 * length).min(1.0);
                }
                solved = Solved { iterations, ..step };
                part = next;
            }
            Err(cause) => {
                length *= 0.5;
                let is_the_targets = matches!(cause, Cause::TargetNotFinite | Cause::NoConditionForPressure);
                if length < SHORTEST || is_the_targets {
                    let at = from + part * (to - from);
                    return Err(Stop { part, at, f: solved.unknowns.f, cause });
                }
            }
        }
    }
    Ok((solved, length))
}
