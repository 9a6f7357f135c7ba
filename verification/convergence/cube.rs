//! The unit cube in which every order is measured, and its motions.

use crate::solver::Simulation;
use crate::verify::claims::scene::{scene, simulation};

/// A compressible neo-Hookean solid, `K/μ = 5`.
pub(super) const NEO_HOOKE: &str = "neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)";

/// Dispersed fibres along a diagonal; the motion pulls them.
pub(super) const FIBRES: &str =
    "goh(C = 10 kPa, k1 = 50 kPa, k2 = 2, kappa = 0.1) + vol_ogden2(D = 1e-5 Pa^-1)";

/// A scene of the cube.
#[derive(Clone, Copy)]
pub(super) struct Cube {
    /// Its energy.
    pub(super) energy: &'static str,
    /// Particles along an edge, less one.
    pub(super) cells: u32,
    /// Share of the spacing inner particles are displaced by.
    pub(super) jitter: f64,
    /// What its `motion` says of the boundary and the body force.
    pub(super) boundary: &'static str,
    /// Further choices of its run.
    pub(super) run: &'static str,
}

impl Cube {
    /// The text of the scene.
    pub(super) fn text(&self) -> String {
        let Self { energy, cells, jitter, boundary, run } = self;
        let fibre = if energy.contains("goh") { "fibre a = unit([1, 1, 0])" } else { "" };
        format!(
            "tissue 1
import std.energies {{ neo_hooke, goh, vol_quadratic, vol_ogden2 }}
material m {{ energy = {energy}  density = 1000 kg/m^3  {fibre} }}
scene cube_motion {{
  body cube {{ shape = box(1 m, 1 m, 1 m)  spacing = 1 m/{cells}  jitter = {jitter}  material = m }}
  let w = 30 s^-1
  let a = 0.1 m * sin(w*t)
  motion {{
    x = [ X + a * sin(pi*X/2 m) * cos(pi*Y/2 m) * cos(pi*Z/2 m),
          Y + a * cos(pi*X/2 m) * sin(pi*Y/2 m) * cos(pi*Z/2 m),
          Z - 2*a * cos(pi*X/2 m) * cos(pi*Y/2 m) * sin(pi*Z/2 m) ]
    {boundary}
  }}
  run {{ until = 0.037 s  {run} }}
}}
"
        )
    }

    /// The cube before its first step.
    pub(super) fn start(&self) -> Simulation {
        simulation(&scene(&self.text()))
    }
}
