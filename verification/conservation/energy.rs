//! Energy of a body that nothing holds.

use crate::monitor::totals;
use crate::output::Figure;
use crate::solver::Simulation;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{bounded, course, history};
use crate::verify::claims::scene::{scene, simulation, small_cube, spinning_cube, stepped};
use crate::verify::{Claim, Topic};

/// Dissipation takes energy and never gives any, and the three-stage method damps what it errs by.
pub(super) const DISSIPATION: Claim = Claim {
    topic: Topic::Conservation,
    claim: "with constant interface states no step of three-stage Runge-Kutta raises the energy of a free body",
    source: "NB25 (33), (35), (37): S_p is positive; |R(i z)|^2 = 1 - z^4/12 + ... for the three-stage method",
    because: "every pair's interface traction works against its jump and the method takes (omega dt)^4/12 a step from \
              a mode, so what may be left is the rounding of the sums over 64 particles: 64 * 1.1e-16",
    bound: 7e-15,
    measure: || largest_rise("integrator = ssp_rk3  cfl = 0.3  momentum_dissipation = constant"),
    control: || largest_rise("integrator = tvd_rk2  momentum_dissipation = off"),
};

/// The same where the states are carried to mid-pair, for nodes displaced by a fifth of the spacing.
pub(super) const VARIATIONAL: Claim = Claim {
    claim: "with variational dissipation no step of three-stage Runge-Kutta raises the energy of a free body",
    source: "power -sum d.S d of the adjoint pair, S positive; the control takes no dissipation by Heun's method",
    because: "the dashpots' power is a sum of squares with a minus sign, so what may be left is the rounding of the \
              sums over 64 particles, as with constant states: 64 * 1.1e-16",
    measure: || largest_rise("integrator = ssp_rk3  cfl = 0.3"),
    ..DISSIPATION
};

/// Variational dissipation leaves a spinning body its energy, but for what its first stretch sets free.
pub(super) const LOSS_PER_TURN: Claim = Claim {
    topic: Topic::Conservation,
    claim: "a cube set spinning loses no more in a turn than the vibration its stretch sets free, by variational dissipation",
    source: "a rotation of the whole has no rate in a frame that turns with the pair; omega = 105 rad/s about (1, 1, 1)",
    because: "a uniform stretch e across the axis costs V E e^2/(1 - nu) and takes 2 e of the spin's energy, so the \
              cube comes to rest at e = rho omega^2 L^2 (1 - nu)/(12 E) = 0.042 with that share of its energy \
              in vibration; twice that for what is not uniform and not small",
    bound: 0.083,
    measure: || loss_of_a_turn(""),
    control: || loss_of_a_turn("momentum_dissipation = constant"),
};

/// Energies over time.
pub(super) const FIGURES: [Illustration; 3] = [
    Illustration { claim: DISSIPATION.claim, figure: rises },
    Illustration { claim: VARIATIONAL.claim, figure: courses },
    Illustration { claim: LOSS_PER_TURN.claim, figure: turns },
];

/// The largest rise in a step so far.
fn rises() -> Figure {
    let rise = |run: &str| {
        let energies = energies(&small_cube(run, ""), 400);
        let initial = energies[0].1;
        let mut largest = 0.0_f64;
        let rise = |pair: &[(f64, f64)]| {
            largest = largest.max((pair[1].1 - pair[0].1) / initial);
            (pair[1].0, largest)
        };
        energies.windows(2).map(rise).collect::<Vec<_>>()
    };
    let lines = STATES.map(|(label, run)| (label, rise(run)));
    let title = "A free fibrous cube: largest rise of the energy in a step so far";
    bounded(history(title, "rise over initial energy", &lines, 1e-18), DISSIPATION.bound)
}

fn courses() -> Figure {
    let damped = STATES.iter().take(2);
    let lines: Vec<_> =
        damped.map(|(label, run)| (*label, over_first(&energies(&small_cube(run, ""), 400)))).collect();
    course("A free fibrous cube: energy", "energy over initial energy", &lines)
}

fn turns() -> Figure {
    let of = |run: &str| over_first(&energies(&spinning_cube(run, 5.0), u64::MAX));
    let lines = [("variational", of("")), ("constant (control)", of("momentum_dissipation = constant"))];
    course("A spinning cube over five turns: energy", "energy over initial energy", &lines)
}

/// Interface states by three-stage Runge-Kutta; none by Heun's method, which grows.
const STATES: [(&str, &str); 3] = [
    ("constant", "integrator = ssp_rk3  cfl = 0.3  momentum_dissipation = constant"),
    ("variational", "integrator = ssp_rk3  cfl = 0.3"),
    ("none, Heun", "integrator = tvd_rk2  momentum_dissipation = off"),
];

fn over_first(energies: &[(f64, f64)]) -> Vec<(f64, f64)> {
    energies.iter().map(|&(time, energy)| (time, energy / energies[0].1)).collect()
}

/// Largest rise of the total energy in a step, over the initial energy.
fn largest_rise(run: &str) -> f64 {
    let energies = energies(&small_cube(run, ""), 400);
    let rises = energies.windows(2).map(|pair| (pair[1].1 - pair[0].1) / energies[0].1);
    rises.fold(0.0, f64::max)
}

/// Share of the energy lost in the first turn.
fn loss_of_a_turn(run: &str) -> f64 {
    let energies = energies(&spinning_cube(run, 1.0), u64::MAX);
    1.0 - energies[energies.len() - 1].1 / energies[0].1
}

/// Time and total energy before the first step and after each, so many or to the end.
fn energies(text: &str, steps: u64) -> Vec<(f64, f64)> {
    let scene = scene(text);
    let mut simulation = simulation(&scene);
    let sample = |simulation: &Simulation| {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        (simulation.time(), sums.kinetic_energy + sums.strain_energy)
    };
    let mut samples = vec![sample(&simulation)];
    while simulation.steps() < steps {
        let reached = stepped(&mut simulation, scene.run.until);
        samples.push(sample(&simulation));
        if reached {
            break;
        }
    }
    samples
}
