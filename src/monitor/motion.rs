//! How far a state is from the exact motion of its scene.
//!
//! Owns the norm. The motion itself is the solver's, differentiated from its text.

use crate::energy::{Maps, Scratch};
use crate::scene::MotionField;
use crate::solver::BodyState;
use crate::tensor::{Mat3, cofactor, volume_map};

/// Differences from the exact motion over all particles of all bodies.
///
/// ```text
/// ‖e‖ = √( Σ_a V_a |e_a|² / Σ_a V_a )
/// ```
///
/// with the Euclidean or Frobenius norm of `e_a`; not relative to anything.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionErrors {
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

impl MotionErrors {
    /// The error of one field.
    pub fn of(&self, field: MotionField) -> f64 {
        match field {
            MotionField::Position => self.position,
            MotionField::Velocity => self.velocity,
            MotionField::Gradient => self.gradient,
            MotionField::AreaMap => self.area_map,
            MotionField::VolumeMap => self.volume_map,
            MotionField::Stress => self.stress,
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
            volume += weight;
            sum.position += weight * (body.x[a].vector() - state.position).norm_squared();
            sum.velocity += weight * (body.v[a].vector() - state.velocity).norm_squared();
            sum.gradient += weight * (f - state.gradient).norm_squared();
            sum.area_map += weight * (h - area_map).norm_squared();
            sum.volume_map += weight * (j - volume_map(&state.gradient, &area_map)).powi(2);
            sum.stress += weight * (body.stress(a) - stress[a]).norm_squared();
        }
    }
    let root = |sum: f64| if volume > 0.0 { libm::sqrt(sum / volume) } else { 0.0 };
    MotionErrors {
        position: root(sum.position),
        velocity: root(sum.velocity),
        gradient: root(sum.gradient),
        area_map: root(sum.area_map),
        volume_map: root(sum.volume_map),
        stress: root(sum.stress),
    }
}
