//! A pressure that follows the faces.

use super::super::scene::ended;
use crate::monitor::cauchy_stress;
use crate::tensor::Mat3;
use crate::verify::{Claim, Topic};

/// A block under pressure from all sides reaches the hydrostatic state.
pub(super) const HYDROSTATIC: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a pressure on all faces of a jittered block is the pressure inside it, with either completeness",
    source: "sigma = -p I solves equilibrium with the traction -p n on every deformed face; NB25 (31)",
    because: "the areas of deformed faces are those of the stencils to the 1e-12 dx^2 of the set-up, so what is left \
              is the transient of rate 1000/s over 20 ms: exp(-20) = 2e-9 of a first swing of the order of the \
              pressure, with a factor of 10 for the sum of several modes",
    bound: 2e-8,
    measure: || {
        let loads = ["xmax", "ymax", "zmax"].map(|face| format!("pressure block.{face} {{ value = 6 kPa }}"));
        spread(&loads, "linear").max(spread(&loads, "quadratic"))
    },
    // dead forces of the same size: they keep the reference area and are too large on the shrunken faces
    control: || {
        let loads = [
            "traction block.xmax { value = [-6 kPa, 0 Pa, 0 Pa] }".into(),
            "traction block.ymax { value = [0 Pa, -6 kPa, 0 Pa] }".into(),
            "traction block.zmax { value = [0 Pa, 0 Pa, -6 kPa] }".into(),
        ];
        spread(&loads, "linear")
    },
};

/// Largest difference of a particle's Cauchy stress from `−p I`, over `p = 6 kPa`.
fn spread(loads: &[String; 3], completeness: &str) -> f64 {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }}
scene squeezed {{
  body block {{ shape = box(5 mm, 4 mm, 4 mm)  spacing = 1 mm  jitter = 0.1  material = gel }}
  slide block.xmin
  slide block.ymin
  slide block.zmin
  {}
  run {{ until = 20 ms  loading = quasi_static  damping = 2000 s^-1  momentum_dissipation = off  completeness = {completeness} }}
}}
",
        loads.join("\n  ")
    );
    let simulation = ended(&text);
    let body = &simulation.bodies()[0];
    let inside = Mat3::identity() * -6e3;
    (0..body.len()).map(|a| (cauchy_stress(body, a) - inside).norm()).fold(0.0, f64::max) / 6e3
}
