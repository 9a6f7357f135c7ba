//! Momentum against the impulse of supports and loads.

use crate::monitor::totals;
use crate::output::Figure;
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{bounded, history};
use crate::verify::claims::scene::{scene, simulation, small_cube, step};
use crate::verify::{Claim, Topic};

/// Steps each measure takes.
const STEPS: u64 = 200;

/// Every change of momentum is somebody's impulse.
pub(super) const VERLET: Claim = Claim {
    topic: Topic::Conservation,
    claim: "the momentum changes by the impulses of supports and loads, by velocity Verlet",
    source: "NB25 (5) over the whole body; impulses summed with the integrator's own weights",
    because: "200 steps of two kicks or stages with five sums each (stresses, pairs, loads, density, velocity), rounded to \
              1.1e-16 of the momenta without preference: three times the spread of a random walk, 3 * sqrt(2000) * 1.1e-16",
    bound: 1.5e-14,
    measure: || gap("", true),
    control: || gap("", false),
};

/// The same for the paper's integrator.
pub(super) const HEUN: Claim = Claim {
    claim: "the momentum changes by the impulses of supports and loads, by two-stage Runge-Kutta",
    measure: || gap("integrator = tvd_rk2", true),
    control: || gap("integrator = tvd_rk2", false),
    ..VERLET
};

/// The same with three stages.
pub(super) const SSP_RK3: Claim = Claim {
    claim: "the momentum changes by the impulses of supports and loads, by three-stage Runge-Kutta",
    because: "as for velocity Verlet, in three stages: 3 * sqrt(3000) * 1.1e-16",
    bound: 1.8e-14,
    measure: || gap("integrator = ssp_rk3", true),
    control: || gap("integrator = ssp_rk3", false),
    ..VERLET
};

/// What is left of the balance over time.
pub(super) const FIGURES: [Illustration; 3] = [
    Illustration { claim: VERLET.claim, figure: || figure("", VERLET.bound) },
    Illustration { claim: HEUN.claim, figure: || figure("integrator = tvd_rk2", HEUN.bound) },
    Illustration { claim: SSP_RK3.claim, figure: || figure("integrator = ssp_rk3", SSP_RK3.bound) },
];

fn figure(run: &str, bound: f64) -> Figure {
    let lines =
        [("all impulses", gaps(run, true, 20)), ("less the traction's (control)", gaps(run, false, 20))];
    let title = "Momentum less impulses of a loaded body";
    bounded(history(title, "change over scale of momentum", &lines, 1e-18), bound)
}

/// A support that moves, a traction that grows and a weight.
const ACTIONS: &str = "pull cube.xmin { displacement = ramp(0 mm -> 0.2 mm, over = 1 ms)  grip = sliding }
  traction cube.ymax { value = [100 Pa * sin(700 s^-1 * t), 200 Pa, 0 Pa] }
  gravity { acceleration = [0 m/s^2, 0 m/s^2, -50 m/s^2] }";

/// What the momentum changed by beside the impulses, over the scale of the momentum; the wrong variant
/// leaves out the traction's.
fn gap(run: &str, all: bool) -> f64 {
    gaps(run, all, 1).last().map_or(f64::NAN, |sample| sample.1)
}

/// The same at so many times.
fn gaps(run: &str, all: bool, samples: u64) -> Vec<(f64, f64)> {
    let more = format!(
        "{ACTIONS}
  record impulses {{ all = impulse(cube).x  top = impulse(cube.ymax).x  every = 1 s }}"
    );
    let scene = scene(&small_cube(run, &more));
    let mut simulation = simulation(&scene);
    let before = totals(simulation.bodies(), &scene.symmetry);
    let sample = |_| {
        step(&mut simulation, &scene, STEPS / samples);
        let after = totals(simulation.bodies(), &scene.symmetry);
        let impulse = |face: Option<&str>| Vec3::from_fn(|axis, _| simulation.impulses()[0].of(face, axis));
        let left_out = if all { Vec3::zeros() } else { impulse(Some("ymax")) };
        let gap = (after.momentum - before.momentum - impulse(None) + left_out).norm();
        (simulation.time(), gap / before.momentum_scale)
    };
    (0..samples).map(sample).collect()
}
