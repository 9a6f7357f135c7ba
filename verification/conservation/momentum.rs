//! Linear momentum of a body that nothing holds.

use crate::monitor::totals;
use crate::output::Figure;
use crate::solver::Simulation;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{bounded, history};
use crate::verify::claims::scene::{scene, simulation, small_cube, step, thrown_cube};
use crate::verify::{Claim, Topic};

/// Steps each measure takes.
const STEPS: u64 = 200;

/// The pair forces of (32) and (33) cancel bit by bit, so what is left is the rounding of the sums.
pub(super) const FREE_BODY: Claim = Claim {
    topic: Topic::Conservation,
    claim: "the linear momentum of a free body stays what it was, by velocity Verlet",
    source: "NB25 (32), (33): pair terms antisymmetric",
    because: "pair forces cancel bit by bit, so what is left is the rounding of each particle's momentum in two \
              kicks a step, 200 steps, errors adding up without cancelling: 400 * 1.1e-16",
    bound: 4.4e-14,
    measure: || drift(&thrown_cube("", "")),
    control: || drift(&thrown_cube("", HELD)),
};

/// The same for the paper's integrator.
pub(super) const FREE_BODY_HEUN: Claim = Claim {
    topic: Topic::Conservation,
    claim: "the linear momentum of a free body stays what it was, by two-stage Runge-Kutta",
    source: "NB25 (32), (33), (39)-(41)",
    because: "as for velocity Verlet, a kick in each of two stages and their average: 600 * 1.1e-16",
    bound: 6.6e-14,
    measure: || drift(&thrown_cube("integrator = tvd_rk2", "")),
    control: || drift(&thrown_cube("integrator = tvd_rk2", HELD)),
};

/// The same with the hourglass stiffness, whose pair forces must cancel as well.
pub(super) const FREE_BODY_HOURGLASS: Claim = Claim {
    topic: Topic::Conservation,
    claim: "the linear momentum of a free body stays what it was, with hourglass stiffness",
    source: "the penalty does not change under translation, and its pair terms are antisymmetric",
    because: "as for velocity Verlet: 400 * 1.1e-16",
    bound: 4.4e-14,
    measure: || drift(&thrown_cube("hourglass_stiffness = 5", "")),
    control: || drift(&thrown_cube("hourglass_stiffness = 5", HELD)),
};

/// Ten thousand steps of a small body.
pub(super) const LONG_RUN: Claim = Claim {
    topic: Topic::Conservation,
    claim: "the linear momentum of a free body stays what it was over 10 000 steps",
    source: "NB25 (32), (33): pair terms antisymmetric",
    because: "two kicks a step round each particle's momentum to 1.1e-16 without preference: a random walk of \
              sqrt(20 000) * 1.1e-16 = 1.6e-14 a particle, sqrt(64) times less in the sum of 64, times 5",
    bound: 1e-14,
    measure: || drift_over(&small_cube("", ""), LONG),
    control: || drift_over(&small_cube("", HELD), LONG),
};

/// Steps of the long run.
const LONG: u64 = 10_000;

/// Momentum and energy over time.
pub(super) const FIGURES: [Illustration; 4] = [
    Illustration { claim: FREE_BODY.claim, figure: || histories("", FREE_BODY.bound) },
    Illustration {
        claim: FREE_BODY_HEUN.claim,
        figure: || histories("integrator = tvd_rk2", FREE_BODY_HEUN.bound),
    },
    Illustration {
        claim: FREE_BODY_HOURGLASS.claim,
        figure: || histories("hourglass_stiffness = 5", FREE_BODY_HOURGLASS.bound),
    },
    Illustration { claim: LONG_RUN.claim, figure: long_history },
];

/// The claim, the energy the dissipation takes meanwhile, and the wrong variant.
fn histories(run: &str, bound: f64) -> Figure {
    let (free, held) = (history_of(&thrown_cube(run, ""), 10), history_of(&thrown_cube(run, HELD), 10));
    let line = |points: &[[f64; 3]], k: usize| points.iter().map(|row| (row[0], row[k])).collect::<Vec<_>>();
    let lines = [
        ("sum of V p", line(&free, 1)),
        ("energy lost", line(&free, 2)),
        ("sum of V p, one face held (control)", line(&held, 1)),
    ];
    bounded(history("A free body: what changes", "change over first value", &lines, 1e-18), bound)
}

fn long_history() -> Figure {
    let free = history_of(&small_cube("", ""), LONG / 20);
    let line = free.iter().map(|row| (row[0], row[1])).collect();
    let title = "A free body: momentum over 10 000 steps";
    bounded(history(title, "change over first value", &[("momentum", line)], 1e-18), LONG_RUN.bound)
}

/// Time, change of momentum over `Σ V |p|`, fall of the total energy over the first; twenty samples.
fn history_of(text: &str, every: u64) -> Vec<[f64; 3]> {
    let scene = scene(text);
    let mut simulation = simulation(&scene);
    let before = totals(simulation.bodies(), &scene.symmetry);
    let energy = before.kinetic_energy + before.strain_energy;
    let sample = |simulation: &Simulation| {
        let now = totals(simulation.bodies(), &scene.symmetry);
        let lost = energy - now.kinetic_energy - now.strain_energy;
        let drift = (now.momentum - before.momentum).norm() / before.momentum_scale;
        [simulation.time(), drift, lost.abs() / energy]
    };
    (0..20)
        .map(|_| {
            step(&mut simulation, &scene, every);
            sample(&simulation)
        })
        .collect()
}

/// The wrong variant: a support that takes up momentum.
const HELD: &str = "hold cube.xmin";

/// Change of the total momentum over `Σ V |p|`.
fn drift(text: &str) -> f64 {
    drift_over(text, STEPS)
}

fn drift_over(text: &str, steps: u64) -> f64 {
    let scene = scene(text);
    let mut simulation = simulation(&scene);
    let before = totals(simulation.bodies(), &scene.symmetry);
    step(&mut simulation, &scene, steps);
    let after = totals(simulation.bodies(), &scene.symmetry);
    (after.momentum - before.momentum).norm() / before.momentum_scale
}
