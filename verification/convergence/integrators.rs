//! The order of each integrator in the time step, on a fixed lattice.

use crate::output::Figure;
use crate::tensor::Vec3;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{orders, slope};
use crate::verify::claims::scene::{advance, scene, simulation};
use crate::verify::{Claim, Topic};

/// All four fields evolved, with dissipation.
pub(super) const TVD_RK2: Claim = Claim {
    topic: Topic::Convergence,
    claim: "two-stage Runge-Kutta is of second order in the time step, all fields evolved, with dissipation",
    source: "NB25 (39)-(41)",
    because: "at the steps used the fastest mode turns by omega dt = 0.1 to 0.2 a step, and the next term of the \
              expansion shifts the measured order by some half of it; a method of another order lies one off",
    bound: 0.09,
    measure: || off(HEUN_DAMPED, 2.0),
    control: || off(RK3_DAMPED, 2.0),
};

/// The same for the method of third order.
pub(super) const SSP_RK3: Claim = Claim {
    claim: "three-stage Runge-Kutta is of third order in the time step, all fields evolved, with dissipation",
    source: "Shu & Osher 1988",
    measure: || off(RK3_DAMPED, 3.0),
    control: || off(HEUN_DAMPED, 3.0),
    ..TVD_RK2
};

/// Dissipation is evaluated with the velocity of mid-step, which costs an order.
pub(super) const VERLET: Claim = Claim {
    claim: "velocity Verlet without dissipation is of second order in the time step, all fields evolved",
    source: "leapfrog is symmetric in time; the control is dissipation, taken with the mid-step velocity",
    because: "the method is symmetric in time, so only even powers follow: (omega dt)^2 = 0.04 at the steps used, \
              and as much again for what the fine step errs by",
    bound: 0.08,
    measure: || off(VERLET_FREE, 2.0),
    control: || off(VERLET_DAMPED, 2.0),
    ..TVD_RK2
};

/// Courant numbers of the two steps compared and of the one that stands for the exact answer.
const COARSE: f64 = 0.1;
const FINE: f64 = 0.05;
const EXACT: f64 = 0.005;

/// How far the measured order is from the one expected.
fn off(run: &str, order: f64) -> f64 {
    let errors: Vec<_> = errors(run, &[COARSE, FINE])
        .iter()
        .map(|&(step, error)| (libm::log(step), libm::log(error)))
        .collect();
    (slope(&errors) - order).abs()
}

/// Mean step, s, and distance from the end of a very small step, at some Courant numbers.
fn errors(run: &str, courant_numbers: &[f64]) -> Vec<(f64, f64)> {
    let (exact, _) = end(run, EXACT);
    let error = |cfl: &f64| {
        let (state, steps) = end(run, *cfl);
        let squares = state.iter().zip(&exact).map(|(a, b)| (a - b).norm_squared());
        (UNTIL / steps, libm::sqrt(squares.sum()))
    };
    courant_numbers.iter().map(error).collect()
}

/// Errors over the step.
pub(super) const FIGURES: [Illustration; 3] = [
    Illustration {
        claim: TVD_RK2.claim,
        figure: || figure(&[("Heun, with D(p)", HEUN_DAMPED), ("SSP-RK3, with D(p)", RK3_DAMPED)], 2.0),
    },
    Illustration {
        claim: SSP_RK3.claim,
        figure: || figure(&[("SSP-RK3, with D(p)", RK3_DAMPED), ("Heun, with D(p)", HEUN_DAMPED)], 3.0),
    },
    Illustration {
        claim: VERLET.claim,
        figure: || {
            figure(&[("Verlet, without D(p)", VERLET_FREE), ("Verlet, with D(p)", VERLET_DAMPED)], 2.0)
        },
    },
];

fn figure(runs: &[(&'static str, &str)], order: f64) -> Figure {
    let lines: Vec<_> =
        runs.iter().map(|&(label, run)| (label, errors(run, &[0.2, COARSE, FINE, 0.025]))).collect();
    let title = "Error of positions and velocities after 8 ms";
    orders(title, ("time step", "s"), ("error", "m"), &lines, order)
}

const HEUN_DAMPED: &str = "integrator = tvd_rk2  formulation = pFHJ";
const RK3_DAMPED: &str = "integrator = ssp_rk3  formulation = pFHJ";
const VERLET_FREE: &str = "momentum_dissipation = off  formulation = pFHJ";
const VERLET_DAMPED: &str = "momentum_dissipation = variational  formulation = pFHJ";

/// End of the runs, s.
const UNTIL: f64 = 8e-3;

/// Positions and velocities at the end, both in the units of a wave across the body, and the steps taken.
fn end(run: &str, cfl: f64) -> (Vec<Vec3>, f64) {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material rubber {{ energy = neo_hooke(mu = 6.5 MPa) + vol_quadratic(K = 14 MPa)  density = 1100 kg/m^3 }}
scene spin {{
  body cube {{ shape = box(1 m, 1 m, 1 m, centre = [0 m, 0 m, 0 m])  spacing = 0.334 m  jitter = 0.1  material = rubber }}
  start cube {{
    velocity = [40 s^-1 * (Z - Y) + 10 s^-1 * X, 30 s^-1 * (X - Z), 50 s^-1 * (Y - X) - 5 s^-1 * Y]
  }}
  run {{ until = {UNTIL} s  {run}  cfl = {cfl}  wave_speed_every = 0 }}
}}
"
    );
    let scene = scene(&text);
    let mut simulation = simulation(&scene);
    advance(&mut simulation, scene.run.until);
    let body = &simulation.bodies()[0];
    let time = 1.0 / body.rest.pressure;
    let positions = body.x.iter().map(|x| x.vector());
    let velocities = body.v.iter().map(|v| v.vector() * time);
    (positions.chain(velocities).collect(), simulation.steps() as f64)
}
