//! How far a state is from the exact motion of its scene.
//!
//! Owns the norm. The motion itself is the solver's, differentiated from its text.

use crate::energy::{Maps, Scratch};
use crate::scene::{MotionField, Norm};
use crate::solver::BodyState;
use crate::tensor::{Mat3, cofactor, volume_map};

/// Differences from the exact motion over all particles of all bodies, one number a field.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FieldErrors {
    /// Of `x`, m.
    pub position: f64,
    /// Of `v`, m/s.
    pub velocity: f64,
    /// Of `F`.
    pub gradient: f64,
    /// Of `H`, evolved or derived.
    pub area_map: f64,
    /// Of `J`, evolved or derived.
    pub volume_map: f64,
    /// Of `P`, Pa.
    pub stress: f64,
}

/// The differences in two norms, neither relative to anything.
///
/// ```text
/// rms = √( Σ_a V_a |e_a|² / Σ_a V_a ),   mean = Σ_a V_a |e_a| / Σ_a V_a
/// ```
///
/// with the Euclidean or Frobenius norm of `e_a`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionErrors {
    /// Root mean squares.
    pub rms: FieldErrors,
    /// Means.
    pub mean: FieldErrors,
}

impl FieldErrors {
    pub(crate) fn map2(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            position: of(self.position, other.position),
            velocity: of(self.velocity, other.velocity),
            gradient: of(self.gradient, other.gradient),
            area_map: of(self.area_map, other.area_map),
            volume_map: of(self.volume_map, other.volume_map),
            stress: of(self.stress, other.stress),
        }
    }
}

impl MotionErrors {
    /// The error of one field.
    pub fn of(&self, field: MotionField, norm: Norm) -> f64 {
        let errors = match norm {
            Norm::RootMeanSquare => &self.rms,
            Norm::Mean => &self.mean,
        };
        match field {
            MotionField::Position => errors.position,
            MotionField::Velocity => errors.velocity,
            MotionField::Gradient => errors.gradient,
            MotionField::AreaMap => errors.area_map,
            MotionField::VolumeMap => errors.volume_map,
            MotionField::Stress => errors.stress,
        }
    }
}

/// Measures a state against the exact motion at a time; zero where no body follows one.
///
/// `H`, `J` and `P` of the motion follow from its `F` by the law of the body.
pub fn motion_errors(bodies: &[BodyState], time: f64) -> MotionErrors {
    let mut sum = MotionErrors::default();
    let mut volume = 0.0;
    for body in bodies {
        let Some(exact) = &body.exact else { continue };
        let states = exact.states(&body.particles.position, time);
        let gradient: Vec<Mat3> = states.iter().map(|state| state.gradient).collect();
        let mut stress = vec![Mat3::zeros(); states.len()];
        let maps = Maps { f: &gradient, h: None, j: None };
        body.law.stress(maps, body.directions.slice(0, states.len()), &mut stress, &mut Scratch::default());
        for (a, state) in states.iter().enumerate() {
            let weight = body.particles.volume[a];
            let (f, cof) = (body.f(a), cofactor(body.f(a)));
            let (h, j) = (body.h(a).copied().unwrap_or(cof), body.j(a).unwrap_or(volume_map(f, &cof)));
            let area_map = cofactor(&state.gradient);
            let error = FieldErrors {
                position: (body.x[a].vector() - state.position).norm(),
                velocity: (body.v[a].vector() - state.velocity).norm(),
                gradient: (f - state.gradient).norm(),
                area_map: (h - area_map).norm(),
                volume_map: (j - volume_map(&state.gradient, &area_map)).abs(),
                stress: (body.stress(a) - stress[a]).norm(),
            };
            volume += weight;
            sum.rms = sum.rms.map2(error, |sum, error| sum + weight * error * error);
            sum.mean = sum.mean.map2(error, |sum, error| sum + weight * error);
        }
    }
    if volume == 0.0 {
        return MotionErrors::default();
    }
    let unit = FieldErrors::default();
    MotionErrors {
        rms: sum.rms.map2(unit, |sum, _| libm::sqrt(sum / volume)),
        mean: sum.mean.map2(unit, |sum, _| sum / volume),
    }
}
