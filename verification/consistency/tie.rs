//! Bodies bonded at faces whose nodes do not meet.

use crate::tensor::{Mat3, Vec3};
use crate::verify::claims::scene::ended;
use crate::verify::{Claim, Topic};

/// A uniform traction passes from one spacing to another.
pub(super) const PATCH: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a uniform stress passes a bond between spacings of 1 and 0.75 mm, whose nodes do not meet",
    source: "uniform stress P on both sides; areas A_m = -sum of w_sm A_s of the coarser face, sums and first moments equal",
    because: "the integration constraint holds to 1e-12 dx^2 beside areas of 1/100 dx^2: 1e-10; transients have lost \
              exp(-300/s * 76 ms) = 1e-10 of a few percent; ten times that for their sum over neighbours",
    bound: 1e-9,
    measure: || patch("on"),
    control: || patch("off"),
};

/// Largest difference of the stress of two layers from the traction, over that.
fn patch(consistency: &str) -> f64 {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = 1800 kg/m^3 }}
scene tied {{
  body inner {{ shape = box(3 mm, 3 mm, 2 mm)  spacing = 1 mm  material = gel }}
  body outer {{ shape = box(3 mm, 3 mm, 2.25 mm, centre = [1.5 mm, 1.5 mm, 3.125 mm])  spacing = 0.75 mm  material = gel }}
  bond inner.zmax {{ to = outer.zmin }}
  slide inner.xmin
  slide outer.xmin
  slide inner.ymin
  slide outer.ymin
  slide inner.zmin
  traction outer.zmax {{ value = [0 Pa, 0 Pa, ramp(0 Pa -> 300 Pa, over = 4 ms)] }}
  run {{
    until = 80 ms  loading = quasi_static  damping = 600 s^-1  momentum_dissipation = off
    integration_consistency = {consistency}
  }}
}}
"
    );
    let simulation = ended(&text);
    let traction = Mat3::from_diagonal(&Vec3::new(0.0, 0.0, 300.0));
    let bodies = simulation.bodies().iter();
    let errors = bodies.flat_map(|body| (0..body.len()).map(move |a| (body.stress(a) - traction).norm()));
    errors.fold(0.0, f64::max) / 300.0
}
