//! The affine patch test: a body that is to deform homogeneously does.

use crate::monitor::motion_errors;
use crate::verify::claims::scene::{advance, scene, simulation};
use crate::verify::{Claim, Topic};

/// A free surface that carries the traction of a homogeneous state, inertia included.
pub(super) const AFFINE: Claim = Claim {
    topic: Topic::Consistency,
    claim: "an affine motion is followed exactly under its own tractions, jitter 0 and 0.3, fibres pulled",
    source: "NB25 (28), (31), (32) with the integration constraint of Chen, Hillman & Rueter 2013",
    because: "F is affine and P uniform, so the discrete areas balance to 1e-12 and Verlet meets a motion of \
              constant acceleration exactly: what is left are 40 steps of some 30 products of a weight (below 1/dx) \
              and a position (below 6 dx), rounded to 1.1e-16 and adding up without cancelling: 8e-13",
    bound: 8e-13,
    measure: || worst("on"),
    control: || worst("off"),
};

/// The same with gradients exact for quadratic fields.
pub(super) const AFFINE_QUADRATIC: Claim = Claim {
    claim: "an affine motion is followed exactly under its own tractions, gradients exact for quadratic fields",
    measure: || worst("on  completeness = quadratic"),
    ..AFFINE
};

/// The larger error of `F` without and with jitter.
fn worst(consistency: &str) -> f64 {
    error(0.0, 1.01, consistency).max(error(0.3, 1.2, consistency))
}

/// Root mean square error of `F` at the end.
fn error(jitter: f64, smoothing: f64, consistency: &str) -> f64 {
    let scene = scene(&format!(
        "tissue 1
import std.energies {{ goh, vol_ogden2 }}
material m {{
  energy = goh(C = 10 kPa, k1 = 50 kPa, k2 = 2, kappa = 0.1) + vol_ogden2(D = 1e-5 Pa^-1)
  density = 1000 kg/m^3
  fibre a = unit([1, 1, 0])
}}
scene patch {{
  body block {{ shape = box(5 mm, 4 mm, 4 mm)  spacing = 1 mm  jitter = {jitter}  material = m }}
  let s = 1e6 s^-2 * t^2 / 2
  motion {{
    x = [ X + s*(0.3*X + 0.2*Y - 0.1*Z), Y + s*(0.1*X + 0.2*Y), Z - s*(0.25*Z + 0.1*Y) ]
    boundary = traction
  }}
  run {{ until = 1 ms  smoothing = {smoothing}  integration_consistency = {consistency} }}
}}
"
    ));
    let mut simulation = simulation(&scene);
    advance(&mut simulation, scene.run.until);
    motion_errors(simulation.bodies(), simulation.time()).rms.gradient
}
