//! The step the Courant condition allows.
//!
//! Owns the two lengths and rates of the discretisation that bound an explicit step: how far an
//! elastic wave may travel, and how fast the dissipation relaxes. Knows no clock.

use super::body::BodyState;
use super::dissipation::Speeds;
use super::pass::{ForceTerms, forces, velocity_gradients_of_body};
use super::quad::Quad;
use crate::discretisation::Stencils;
use crate::scene::InterfaceStates;

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
    pub fn new(body: &mut BodyState, terms: ForceTerms, weight: f64) -> Self {
        let momentum = dissipation_rate(body, terms);
        let Some(volume) = terms.volume else {
            return Self { shared: momentum, volume: 0.0 };
        };
        let Speeds { pressure, shear } = body.rest;
        let states = match terms.states {
            InterfaceStates::Off => InterfaceStates::Constant,
            states => states,
        };
        let whole = ForceTerms { states, speeds: Speeds { pressure, shear }, ..terms };
        let swinging = if whole == terms { momentum } else { dissipation_rate(body, whole) };
        let scalar = Speeds { pressure, shear: pressure };
        let alternating =
            dissipation_rate(body, ForceTerms { states: InterfaceStates::Constant, speeds: scalar, ..terms });
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

/// Power iterations; the largest rates of a lattice lie close together, and any of them will do.
const ITERATIONS: usize = 40;

/// What the power iterations may fall short by.
const MARGIN: f64 = 1.05;

/// Fastest rate at which the dissipation changes a velocity field, 1/s.
///
/// ```text
/// ζ = largest eigenvalue of v ↦ −D(ρR v)/ρR         [NB25 (33)]
/// ```
///
/// by power iteration from a fixed field without symmetry. The body must be unstressed and at rest
/// in its packets; its velocities and forces are left as they were. Limited states take the rate of linear ones,
/// of whose dissipation they are a part.
fn dissipation_rate(body: &mut BodyState, terms: ForceTerms) -> f64 {
    let states = match terms.states {
        InterfaceStates::Limited => InterfaceStates::Linear,
        states => states,
    };
    let velocity = body.v.clone();
    let acceleration = body.acceleration.clone();
    let external = std::mem::take(&mut body.external);
    let mut rate = 0.0;
    for (a, v) in body.v.iter_mut().enumerate() {
        let seed = (a as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let number =
            |shift: u32| f64::from((seed.rotate_left(shift) >> 40) as u32) / f64::from(1_u32 << 24) - 0.5;
        *v = Quad([number(0), number(17), number(31), 0.0]);
    }
    for _ in 0..ITERATIONS {
        let scale = 1.0 / norm(&body.v);
        body.v.iter_mut().for_each(|v| *v = *v * scale);
        velocity_gradients_of_body(body);
        forces(body, ForceTerms { states, volume: None, ..terms });
        rate = norm(&body.acceleration);
        if rate == 0.0 {
            break;
        }
        body.v.copy_from_slice(&body.acceleration);
    }
    body.v = velocity;
    body.acceleration = acceleration;
    body.external = external;
    body.packets.fill(Default::default());
    MARGIN * rate
}

fn norm(field: &[Quad]) -> f64 {
    libm::sqrt(field.iter().map(|v| v.dot(*v)).sum())
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
