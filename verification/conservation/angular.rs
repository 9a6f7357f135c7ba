//! Angular momentum of a body that nothing holds.

use crate::monitor::totals;
use crate::output::Figure;
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{bounded, history, orders};
use crate::verify::claims::scene::{advance, scene, simulation, small_cube, step};
use crate::verify::{Claim, Topic};

/// Steps each measure takes.
const STEPS: u64 = 400;

/// F is the discrete gradient of x, so the internal forces have no torque; the dashpots turn with the pair and the
/// whole of their adjoint is in the balance, so they have none either.
pub(super) const VERLET: Claim = Claim {
    topic: Topic::Conservation,
    claim: "velocity Verlet keeps the angular momentum of a free body by default",
    source: "NB25 (28), (32); variational dissipation with the corotational rate of the mismatch",
    because: "no force has a torque, so what is left is the rounding of each particle's momentum in two kicks a \
              step, 400 steps, errors adding up without cancelling: 800 * 1.1e-16",
    bound: 8.8e-14,
    measure: || drift(""),
    control: || drift("momentum_dissipation = constant"),
};

/// The projection makes up for the tangential dissipation and for Heun's error in one.
pub(super) const PROJECTED_HEUN: Claim = Claim {
    topic: Topic::Conservation,
    claim: "two-stage Runge-Kutta with projected accelerations keeps the angular momentum",
    source: "NB25 (39)-(41); least correction with multipliers, second stage about x* + dt^2/2 a",
    because: "the step ends with the angular momentum it began with but for the rounding of three sums over the \
              particles' momenta, 400 steps, errors adding up without cancelling: 3 * 400 * 1.1e-16 = 1.3e-13 at \
              worst, and 1e-13 is what is asked for",
    bound: 1e-13,
    measure: || drift("integrator = tvd_rk2  angular_momentum = projected"),
    control: || drift("integrator = tvd_rk2"),
};

/// The same with three stages.
pub(super) const PROJECTED_SSP_RK3: Claim = Claim {
    topic: Topic::Conservation,
    claim: "three-stage Runge-Kutta with projected accelerations keeps the angular momentum",
    source: "Shu & Osher 1988; least correction with multipliers about the positions the step ends at",
    because: PROJECTED_HEUN.because,
    bound: 1e-13,
    measure: || drift("integrator = ssp_rk3  angular_momentum = projected"),
    control: || drift("integrator = ssp_rk3"),
};

/// Heun's own error, no dissipation: the positions of the second stage lack `½ dt² a`.
///
/// A half step with four times the bound of the ratio would be no third order.
pub(super) const HEUN_DRIFT: Claim = Claim {
    topic: Topic::Conservation,
    claim: "without projection and dissipation, two-stage Runge-Kutta loses angular momentum with the third power of the step",
    source: "Taylor expansion: the step ends at x* + dt^2/2 a, its forces act at x*",
    because: "torque-free forces leave an error of dt^4 a step, dt^3 in all; the next term shifts the measured \
              order by some omega dt = 0.1 at the steps used, and a control of order 2 lies one order off",
    bound: 0.1,
    measure: || (drift_order("momentum_dissipation = off") - 3.0).abs(),
    control: || (drift_order("momentum_dissipation = constant") - 3.0).abs(),
};

/// Angular momentum over time, and Heun's drift over the step.
pub(super) const FIGURES: [Illustration; 4] = [
    Illustration {
        claim: VERLET.claim,
        figure: || {
            let constant = "momentum_dissipation = constant";
            figure(&[("variational", ""), ("constant (control)", constant)], VERLET.bound)
        },
    },
    Illustration {
        claim: PROJECTED_HEUN.claim,
        figure: || {
            let free = "integrator = tvd_rk2";
            let projected = "integrator = tvd_rk2  angular_momentum = projected";
            figure(&[("projected", projected), ("free (control)", free)], PROJECTED_HEUN.bound)
        },
    },
    Illustration {
        claim: PROJECTED_SSP_RK3.claim,
        figure: || {
            let free = "integrator = ssp_rk3";
            let projected = "integrator = ssp_rk3  angular_momentum = projected";
            figure(&[("projected", projected), ("free (control)", free)], PROJECTED_SSP_RK3.bound)
        },
    },
    Illustration {
        claim: HEUN_DRIFT.claim,
        figure: || {
            let drifts = |run: &str| [0.2, 0.1, 0.05, 0.025].map(|cfl| drift_of_step(run, cfl)).to_vec();
            let lines = [
                ("without D(p)", drifts("momentum_dissipation = off")),
                ("with D(p) (control)", drifts("momentum_dissipation = constant")),
            ];
            let title = "Heun: change of angular momentum in 2 ms";
            orders(title, ("time step", "s"), ("change", "kg m²/s"), &lines, 3.0)
        },
    },
];

fn figure(runs: &[(&'static str, &str)], bound: f64) -> Figure {
    let lines: Vec<_> = runs.iter().map(|&(label, run)| (label, drifts(run, 40))).collect();
    let title = "A free fibrous cube: angular momentum";
    bounded(history(title, "change over sum of m |x × v|", &lines, 1e-18), bound)
}

fn drift(run: &str) -> f64 {
    drifts(run, 1).last().map_or(f64::NAN, |sample| sample.1)
}

/// Change over the sum of the parts' magnitudes, at so many times.
fn drifts(run: &str, samples: u64) -> Vec<(f64, f64)> {
    let scene = scene(&small_cube(run, ""));
    let mut simulation = simulation(&scene);
    let (before, scale) = state(&simulation, &scene);
    let sample = |_| {
        step(&mut simulation, &scene, STEPS / samples);
        (simulation.time(), (state(&simulation, &scene).0 - before).norm() / scale)
    };
    (0..samples).map(sample).collect()
}

/// Angular momentum and the sum of its parts' magnitudes.
fn state(simulation: &crate::solver::Simulation, scene: &crate::scene::Scene) -> (Vec3, f64) {
    let scale = simulation.bodies().iter().flat_map(|body| {
        let parts = body.x.iter().zip(&body.v).zip(&body.particles.volume);
        parts.map(|((x, v), volume)| body.density * volume * x.vector().cross(&v.vector()).norm())
    });
    (totals(simulation.bodies(), &scene.symmetry).angular_momentum, scale.sum())
}

/// Order in the step of the drift over a fixed time, by Heun's method.
fn drift_order(run: &str) -> f64 {
    let ((long, coarse), (short, fine)) = (drift_of_step(run, 0.1), drift_of_step(run, 0.05));
    libm::log(coarse / fine) / libm::log(long / short)
}

/// Mean step, s, and the drift over a fixed time, kg m²/s.
fn drift_of_step(run: &str, cfl: f64) -> (f64, f64) {
    let text = small_cube(&format!("integrator = tvd_rk2  cfl = {cfl}  wave_speed_every = 0  {run}"), "");
    let scene = scene(&text.replace("until = 1 s", "until = 2 ms"));
    let mut simulation = simulation(&scene);
    let before = state(&simulation, &scene).0;
    advance(&mut simulation, scene.run.until);
    let drift = (state(&simulation, &scene).0 - before).norm();
    (scene.run.until / simulation.steps() as f64, drift)
}
