//! Linear momentum against the impulse of loads and supports.
//!
//! Owns the account and the round-off it may show. Knows no text.

use super::watch::{Fault, fault};
use tissue::monitor::totals;
use tissue::scene::{Loading, Scene};
use tissue::solver::Simulation;
use tissue::tensor::Vec3;

/// Linear momentum against the impulse of what acts.
pub struct Momenta {
    start: Vec3,
    /// Largest Σ m |v|, and the sum of magnitudes of what loads and supports gave.
    scale: f64,
    given: f64,
}

impl Momenta {
    /// Opens the accounts.
    pub fn new(scene: &Scene, simulation: &Simulation) -> Self {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        Self { start: sums.momentum, scale: sums.momentum_scale, given: 0.0 }
    }

    /// Notes how large the terms are that cancel.
    pub fn note(&mut self, scene: &Scene, simulation: &Simulation) {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        self.scale = self.scale.max(sums.momentum_scale);
        let step = simulation.last_step();
        for body in simulation.bodies() {
            for (a, volume) in body.particles.volume.iter().enumerate() {
                let mass = body.density * volume;
                self.given += mass * step * body.acceleration[a].vector().norm();
            }
        }
    }

    /// Momentum is what it was and the impulse, but for the rounding of the forces of some hundred neighbours a step.
    pub fn judge(
        &self,
        scene: &Scene,
        simulation: &Simulation,
        column: &dyn Fn(&str) -> f64,
    ) -> Result<(), Fault> {
        let mirrored = scene.symmetry.iter().any(Option::is_some);
        let damped = matches!(scene.run.loading, Loading::QuasiStatic { .. });
        if mirrored || damped {
            return Ok(());
        }
        let now = totals(simulation.bodies(), &scene.symmetry).momentum;
        let mut impulse = Vec3::zeros();
        for body in &scene.bodies {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                impulse[axis] += column(&format!("I{letter}_{}", body.name));
            }
        }
        let found = (now - self.start - impulse).norm();
        let allowed = 100.0 * f64::EPSILON * (self.given + simulation.evaluations() as f64 * self.scale);
        if found <= allowed {
            return Ok(());
        }
        Err(fault("momentum", format!("{found:.2e} kg m/s came from nowhere, {allowed:.2e} from round-off")))
    }
}
