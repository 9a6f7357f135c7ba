//! The unit cube with an exact motion: what orders are measured on.

use crate::monitor::{MotionErrors, motion_errors};
use crate::solver::Simulation;
use crate::verify::claims::scene::{advance, scene, simulation, synchronised};

/// What moves and how.
#[derive(Clone, Copy)]
pub(super) enum Case {
    /// A compressible neo-Hookean solid, strains up to a third.
    NeoHooke,
    /// Dispersed fibres along a diagonal, which the same motion pulls.
    Fibres,
    /// The neo-Hookean solid with a smooth bulge on a growing affine motion, every face moved.
    MovedNeoHooke,
    /// The fibrous solid, moved likewise.
    MovedFibres,
    /// The swinging cube: a standing shear wave of small amplitude, with Poisson's ratio.
    Swinging(f64),
}

/// A scene of the cube.
#[derive(Clone, Copy)]
pub(super) struct Cube {
    /// What moves and how.
    pub(super) case: Case,
    /// Particles along an edge, less one.
    pub(super) cells: u32,
    /// Share of the spacing inner particles are displaced by.
    pub(super) jitter: f64,
    /// What its `motion` says beside `x`.
    pub(super) motion: &'static str,
    /// Further choices of its run.
    pub(super) run: &'static str,
}

/// Rollers on the faces through the origin, the others held in their plane and loaded along the normal.
pub(super) const ROLLERS: &str =
    "normal = [cube.xmin, cube.ymin, cube.zmin]  tangential = [cube.xmax, cube.ymax, cube.zmax]";

impl Cube {
    /// A regular cube, on rollers or moved as the case says, with every choice left to the scheme.
    pub(super) fn new(case: Case, cells: u32) -> Self {
        let motion = if matches!(case, Case::MovedNeoHooke | Case::MovedFibres) { "" } else { ROLLERS };
        Self { case, cells, jitter: 0.0, motion, run: "" }
    }

    /// Amplitude over the edge, frequency (1/s) and end time (s): a whole swing of the standing wave; 18 % of a
    /// period for the others, which end while they still grow.
    fn swing(case: Case) -> (f64, f64, f64) {
        match case {
            Case::Swinging(ratio) => {
                let (shear, _) = moduli(ratio);
                // √3/2 π c with c = √(μ/ρ)
                let frequency = 0.5 * libm::sqrt(3.0 * shear / SWINGING_DENSITY) * std::f64::consts::PI;
                (5e-4, frequency, std::f64::consts::TAU / frequency)
            }
            _ => (0.1, 30.0, 0.037),
        }
    }

    /// End of the run, s.
    pub(super) fn until(&self) -> f64 {
        Self::swing(self.case).2
    }

    /// The text of the scene.
    pub(super) fn text(&self) -> String {
        let Self { case, cells, jitter, motion, run } = self;
        let (strain, frequency, until) = Self::swing(*case);
        let material = match case {
            Case::NeoHooke | Case::MovedNeoHooke => {
                "energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = 1000 kg/m^3".into()
            }
            Case::Fibres | Case::MovedFibres => {
                "energy = goh(C = 10 kPa, k1 = 50 kPa, k2 = 2, kappa = 0.1) + vol_ogden2(D = 1e-5 Pa^-1)
  density = 1000 kg/m^3  fibre a = unit([1, 1, 0])"
                    .into()
            }
            Case::Swinging(ratio) => {
                let (shear, bulk) = moduli(*ratio);
                format!(
                    "energy = neo_hooke(mu = {shear} Pa) + vol_quadratic(K = {bulk} Pa)
  density = {SWINGING_DENSITY} kg/m^3"
                )
            }
        };
        let position = match case {
            Case::MovedNeoHooke | Case::MovedFibres => {
                "[ X + e*(X + 0.5*Y) + 0.5*b, Y + e*(0.8*Y + 0.3*X) - 0.3*b, Z - 0.7*e*Z + 0.4*b ]"
            }
            _ => {
                "[ X + a * sin(pi*X/2 m) * cos(pi*Y/2 m) * cos(pi*Z/2 m),
          Y + a * cos(pi*X/2 m) * sin(pi*Y/2 m) * cos(pi*Z/2 m),
          Z - 2*a * cos(pi*X/2 m) * cos(pi*Y/2 m) * sin(pi*Z/2 m) ]"
            }
        };
        format!(
            "tissue 1
import std.energies {{ neo_hooke, goh, vol_quadratic, vol_ogden2 }}
material m {{ {material} }}
scene cube_motion {{
  body cube {{ shape = box(1 m, 1 m, 1 m)  spacing = 1 m/{cells}  jitter = {jitter}  material = m }}
  let e = {strain} * sin({frequency} s^-1 * t)
  let a = 1 m * e
  let b = a * sin(pi*X/1 m) * sin(pi*Y/1 m) * sin(pi*Z/1 m)
  motion {{
    x = {position}
    {motion}
  }}
  run {{ until = {until} s  {run} }}
}}
"
        )
    }

    /// The cube before its first step.
    pub(super) fn start(&self) -> Simulation {
        simulation(&scene(&self.text()))
    }

    /// The cube at the end.
    pub(super) fn end(&self) -> Simulation {
        let scene = scene(&self.text());
        let mut simulation = simulation(&scene);
        advance(&mut simulation, scene.run.until);
        synchronised(&mut simulation);
        simulation
    }

    /// The errors, of a swing over all of it and of other motions at the end: at one time of a swing an error of its
    /// phase and one of its amplitude may cancel, and their orders differ.
    pub(super) fn errors(&self) -> MotionErrors {
        if matches!(self.case, Case::Swinging(_)) {
            return self.errors_over_time();
        }
        let simulation = self.end();
        motion_errors(simulation.bodies(), simulation.time())
    }

    /// The errors over the whole motion, in space and at twenty times.
    fn errors_over_time(&self) -> MotionErrors {
        const TIMES: u32 = 20;
        let scene = scene(&self.text());
        let mut simulation = simulation(&scene);
        let mut sum = MotionErrors::default();
        for i in 1..=TIMES {
            let time = scene.run.until * f64::from(i) / f64::from(TIMES);
            advance(&mut simulation, time);
            synchronised(&mut simulation);
            let errors = motion_errors(simulation.bodies(), simulation.time());
            sum.rms = sum.rms.map2(errors.rms, |sum, error| sum + error * error / f64::from(TIMES));
        }
        sum.rms = sum.rms.map2(sum.rms, |sum, _| libm::sqrt(sum));
        sum
    }
}

/// Density of the swinging cube, kg/m³.
const SWINGING_DENSITY: f64 = 1100.0;

/// Shear and bulk modulus of the swinging cube, Young's modulus 17 MPa, Pa.
fn moduli(ratio: f64) -> (f64, f64) {
    let young = 17e6;
    (young / (2.0 * (1.0 + ratio)), young / (3.0 * (1.0 - 2.0 * ratio)))
}
