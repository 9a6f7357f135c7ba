//! Energy of a body that nothing holds.

use crate::monitor::totals;
use crate::solver::Simulation;
use crate::verify::claims::scene::{scene, simulation, small_cube, spinning_cube, step};
use crate::verify::{Claim, Topic};

/// Dissipation takes energy and never gives any, and the three-stage method damps what it errs by. With
/// linear states the traction works against the jump but the power is that of the whole difference, and single
/// steps rise by up to a millionth of the energy.
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

/// What linear states lack: parts of a jump that would give a pair energy are left out.
pub(super) const LIMITED: Claim = Claim {
    claim: "with limited interface states no step of three-stage Runge-Kutta raises the energy of a free body",
    source: "NB25 (33), (35), (37), the jump limited by its ratio to v_b - v_a (minmod), normal and tangential \
             part each; the control is the jump as it is",
    because: "every pair's interface traction works against the whole difference, so what may be left is the \
              rounding of the sums over 64 particles, as with constant states: 64 * 1.1e-16",
    measure: || largest_rise("integrator = ssp_rk3  cfl = 0.3  momentum_dissipation = limited"),
    control: || largest_rise("integrator = ssp_rk3  cfl = 0.3  momentum_dissipation = linear"),
    ..DISSIPATION
};

/// Linear interface states leave a spinning body its energy, but for what its first stretch sets free.
pub(super) const LOSS_PER_TURN: Claim = Claim {
    topic: Topic::Conservation,
    claim: "a cube set spinning loses no more in a turn than the vibration its stretch sets free, by linear interface states",
    source: "rigid rotation is linear in X, so its jumps vanish; omega = 105 rad/s about (1, 1, 1)",
    because: "a uniform stretch e across the axis costs V E e^2/(1 - nu) and takes 2 e of the spin's energy, so the \
              cube comes to rest at e = rho omega^2 L^2 (1 - nu)/(12 E) = 0.042 with that share of its energy \
              in vibration; twice that for what is not uniform and not small",
    bound: 0.083,
    measure: || loss_of_a_turn("angular_momentum = projected"),
    control: || loss_of_a_turn("momentum_dissipation = constant"),
};

/// Largest rise of the total energy in a step, over the initial energy.
fn largest_rise(run: &str) -> f64 {
    let scene = scene(&small_cube(run, ""));
    let mut simulation = simulation(&scene);
    let energy = |simulation: &Simulation| {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        sums.kinetic_energy + sums.strain_energy
    };
    let initial = energy(&simulation);
    let (mut last, mut rise) = (initial, 0.0_f64);
    for _ in 0..400 {
        step(&mut simulation, &scene, 1);
        let now = energy(&simulation);
        rise = rise.max((now - last) / initial);
        last = now;
    }
    rise
}

/// Share of the energy lost in the first turn.
fn loss_of_a_turn(run: &str) -> f64 {
    let scene = scene(&spinning_cube(run, 1.0));
    let mut simulation = simulation(&scene);
    let energy = |simulation: &Simulation| {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        sums.kinetic_energy + sums.strain_energy
    };
    let initial = energy(&simulation);
    while !simulation.step_towards(scene.run.until).expect("the cube spins") {}
    1.0 - energy(&simulation) / initial
}
