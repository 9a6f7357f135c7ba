//! The step the Courant condition allows.
//!
//! Owns the two lengths and rates of the discretisation that bound an explicit step: how far an
//! elastic wave may travel, and how fast the dissipation relaxes. Knows no clock.

use super::body::BodyState;
use super::dissipation::Speeds;
use super::force::internal_and_upwinding;
use super::hourglass::dashpot_rate;
use super::pass::ForceTerms;
use super::quad::{Columns, Quad};
use super::spectrum::largest;
use crate::discretisation::Stencils;
use crate::scene::InterfaceStates;
use rayon::prelude::*;

/// Length an elastic wave may travel in a step, m: the node spacing, or less where the stencils are
/// stiffer than a regular lattice.
pub fn elastic_length(stencils: &Stencils, volume: &[f64], spacing: f64) -> f64 {
    spacing.min(stencils.stable_length(volume))
}

/// Step that is stable for elastic waves and dissipation together.
///
/// ```text
/// Δt = α_CFL h_min / c_p,max                       [NB25 (42)]
/// h_min = ℓ' (√(1 + z²) − z),   z = ζ ℓ' / (4 c_p,max)
/// 1/ℓ'² = 1/ℓ² + ω_g² / (2 c_p,max)²
/// ```
///
/// Differs from [NB25 (42)] by the factor behind `ℓ'`: a mode of frequency `ω` and damping rate `ζ`
/// stepped with the velocity of the middle of the step is stable for `ω² Δt² + 2 ζ Δt < 4`, and
/// `ω Δt = 2` where `Δt = ℓ/c`. Measured effect: a block of Poisson's ratio 0.35 under a traction
/// step breaks up at α = 0.9 without it and comes to rest with it.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `cfl` | `α_CFL` | – |
/// | `length` | `ℓ` of [`elastic_length`] | m |
/// | `speed` | `c_p,max` | m/s |
/// | `hourglass` | `ω_g²`, square of the fastest frequency of the hourglass penalty | 1/s² |
/// | `rate` | `ζ` of [`Rates`], any other damping included | 1/s |
///
/// Returns s; not a number if the speed is none.
pub fn stable_step(cfl: f64, length: f64, speed: f64, hourglass: f64, rate: f64) -> f64 {
    let slowness = length / speed;
    let elastic = slowness / libm::sqrt(1.0 + 0.25 * hourglass * slowness * slowness);
    let z = 0.25 * rate * elastic;
    cfl * elastic * (libm::sqrt(1.0 + z * z) - z)
}

/// How fast the dissipation of a body works, for the steps that follow it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rates {
    /// `ζ` of [`stable_step`], on the modes that also swing: D(p) and D(J) as if they were one, 1/s.
    pub shared: f64,
    /// Fastest rate at which D(J) and its restoring term change J on a mode that does not swing, 1/s.
    pub volume: f64,
}

impl Rates {
    /// Of a body and what its forces are made of; `weight` is that of D(J).
    ///
    /// D(J) changes J at most as D(p) changes p, with c_p over the spacing, but whatever the states and
    /// weights of D(p) are. On an alternating J it is faster: a scalar feels every pair as p feels the
    /// pairs along it, so its rate is that of D(p) with constant states and `c_s = c_p`, about twice as much.
    pub fn new(body: &BodyState, terms: ForceTerms, weight: f64) -> Self {
        let momentum = dissipation_rate(body, terms.states, terms.speeds);
        let Some(volume) = terms.volume else {
            return Self { shared: momentum, volume: 0.0 };
        };
        let states = match terms.states {
            InterfaceStates::Off => InterfaceStates::Constant,
            states => states,
        };
        let swinging = if (states, body.rest) == (terms.states, terms.speeds) {
            momentum
        } else {
            dissipation_rate(body, states, body.rest)
        };
        let scalar = Speeds { shear: body.rest.pressure, ..body.rest };
        let alternating = dissipation_rate(body, InterfaceStates::Constant, scalar);
        Self {
            shared: momentum + weight * swinging + volume.relaxation,
            volume: weight * alternating + volume.relaxation,
        }
    }

    /// Longest step of a relaxation at the rate of `volume` that does not overshoot by more than it starts
    /// with, s; infinite without D(J).
    pub fn relaxation_step(&self) -> f64 {
        2.0 / self.volume
    }
}

/// Fastest rate at which the dissipation changes a velocity field, 1/s.
///
/// ```text
/// ζ = largest eigenvalue of v ↦ −D(ρR v)/ρR         [NB25 (33)]
/// ```
///
/// of the undeformed body.
fn dissipation_rate(body: &BodyState, states: InterfaceStates, speeds: Speeds) -> f64 {
    let impedance = Speeds { pressure: body.density * speeds.pressure, shear: body.density * speeds.shear };
    match states {
        InterfaceStates::Off => 0.0,
        InterfaceStates::Variational => dashpot_rate(body, impedance),
        InterfaceStates::Constant => {
            let position: Vec<Quad> = body.particles.position.iter().map(Quad::new).collect();
            let stress = vec![Columns::ZERO; body.len()];
            largest(body.len(), |velocity, out| {
                out.par_iter_mut().enumerate().for_each(|(a, out)| {
                    let inverse = body.inverse_volume[a];
                    *out = internal_and_upwinding(
                        &body.links,
                        a,
                        &stress,
                        &position,
                        velocity,
                        impedance,
                        inverse,
                    ) * (1.0 / body.density);
                });
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_damping_the_step_is_the_length_over_the_speed() {
        assert_eq!(stable_step(0.5, 2.0, 4.0, 0.0, 0.0), 0.25);
    }

    #[test]
    fn the_step_is_where_the_damped_mode_loses_stability() {
        // at α = 1 the condition ω² Δt² + 2 ζ Δt = 4 with ω = 2 c/ℓ is met with equality
        let (length, speed, rate) = (1e-3, 10.0, 3e4);
        let step = stable_step(1.0, length, speed, 0.0, rate);
        let omega = 2.0 * speed / length;
        assert!(((omega * step).powi(2) + 2.0 * rate * step - 4.0).abs() <= 40.0 * f64::EPSILON);
    }

    #[test]
    fn frequencies_of_waves_and_hourglass_modes_add_in_squares() {
        // at α = 1 without damping, ω Δt = 2 with ω² = (2 c/ℓ)² + ω_g²
        let (length, speed, hourglass) = (1e-3, 10.0, 3e8);
        let step = stable_step(1.0, length, speed, hourglass, 0.0);
        let square = (2.0 * speed / length).powi(2) + hourglass;
        assert!((square * step * step - 4.0).abs() <= 40.0 * f64::EPSILON);
    }

    #[test]
    fn a_speed_that_is_no_number_gives_no_step() {
        assert!(stable_step(0.9, 1.0, f64::NAN, 0.0, 1.0).is_nan());
    }
}
