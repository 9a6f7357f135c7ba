//! The uniform-traction patch test.

use crate::solver::BodyState;
use crate::tensor::{Mat3, Vec3};
use crate::verify::claims::scene::ended;
use crate::verify::{Claim, Topic};

/// A bar pulled by a uniform traction reaches the homogeneous state.
///
/// Without integration consistency the boundary areas of the stencils are wrong and it does not.
pub(super) const PATCH: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a uniform traction leaves a jittered block in the homogeneous state",
    source: "NB25 (31), (32) with the integration constraint of Chen, Hillman & Rueter 2013",
    because: "the discrete areas balance to 1e-11 and F is affine to 1e-12, so what is left is the transient \
              of rate 1000/s (half the damping, all modes being faster) over 20 ms: exp(-20) = 2e-9 of the first \
              swing, which is of the order of the traction, with a factor of 10 for the sum of several modes",
    bound: 2e-8,
    measure: || spread("on", "0"),
    control: || spread("off", "0"),
};

/// The hourglass stiffness sees nothing of an affine motion, so it leaves the patch test as it was.
pub(super) const PATCH_HOURGLASS: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a uniform traction leaves a jittered block in the homogeneous state, with hourglass stiffness",
    source: "the penalty vanishes for affine motions",
    because: "as without it: the transient of rate 1000/s over 20 ms, with a factor of 10 for several modes",
    bound: 2e-8,
    measure: || spread("on", "5"),
    control: || spread("off", "5"),
};

/// Gradients exact for quadratic fields, on areas balanced to second degree, keep the patch test.
pub(super) const PATCH_QUADRATIC: Claim = Claim {
    claim: "a uniform traction leaves a jittered block in the homogeneous state, gradients exact for quadratic fields",
    source: "NB25 (31), (32) with columns that sum to the areas the traction acts on",
    measure: || spread("on  completeness = quadratic  smoothing = 1.2", "0"),
    ..PATCH
};

/// Largest difference of a particle's stress from the traction, over the traction.
fn spread(consistency: &str, hourglass: &str) -> f64 {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }}
scene patch {{
  body block {{ shape = box(5 mm, 4 mm, 4 mm)  spacing = 1 mm  jitter = 0.1  material = gel }}
  slide block.xmin {{ normal = 0 m }}
  slide block.ymin {{ normal = 0 m }}
  slide block.zmin {{ normal = 0 m }}
  traction block.xmax {{ value = [300 Pa, 0 Pa, 0 Pa] }}
  run {{ until = 20 ms  loading = quasi_static  damping = 2000 s^-1  integration_consistency = {consistency}
        momentum_dissipation = off  hourglass_stiffness = {hourglass} }}
}}
"
    );
    let simulation = ended(&text);
    let body: &BodyState = &simulation.bodies()[0];
    let traction = Mat3::from_diagonal(&Vec3::new(300.0, 0.0, 0.0));
    (0..body.len()).map(|a| (body.stress(a) - traction).norm()).fold(0.0, f64::max) / 300.0
}
