//! What a run will cost, measured on a few of its own steps.
//!
//! Owns the estimate that `tissue plan --cost` prints.

use super::error::RunError;
use crate::plan::Plan;
use crate::scene::Scene;
use crate::solver::Simulation;
use std::fmt;
use std::time::Instant;

/// Cost of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Cost {
    /// Particles of the modelled part.
    pub particles: usize,
    /// Mean neighbours of a particle, itself left out.
    pub neighbours: f64,
    /// Bytes of the arrays of the time loop, for one particle.
    pub bytes_per_particle: f64,
    /// Operations of the stress of one particle, largest over the materials.
    pub stress_operations: usize,
    /// Steps if the stable step stayed what it is at rest.
    pub steps: u64,
    /// Evaluations of the right-hand side a step.
    pub evaluations_per_step: f64,
    /// Time of one step, s, from the first steps of the run itself.
    pub seconds_per_step: f64,
    /// Particle updates a second in those steps.
    pub updates_per_second: f64,
}

/// Steps the estimate is measured on, at most.
const TRIAL_STEPS: u64 = 40;

/// Time given to the trial, s.
const TRIAL_SECONDS: f64 = 1.0;

impl Cost {
    /// Builds the scene and takes its first steps.
    ///
    /// # Errors
    /// If the scene cannot be set up or goes wrong in its first steps.
    pub fn measure(scene: &Scene, plan: &Plan) -> Result<Self, RunError> {
        let mut simulation = Simulation::new(scene, plan)?;
        let particles = simulation.particles();
        let rest = simulation.stable_step();
        let pairs: usize = simulation.bodies().iter().map(|body| body.links.neighbour.len()).sum();
        let bytes: usize = simulation.bodies().iter().map(|body| body.bytes()).sum();
        let stress_operations =
            simulation.bodies().iter().map(|body| body.law.operations()).max().unwrap_or_default();
        let before = simulation.evaluations();
        let clock = Instant::now();
        while simulation.steps() < TRIAL_STEPS && clock.elapsed().as_secs_f64() < TRIAL_SECONDS {
            if simulation.step_towards(scene.run.until)? {
                break;
            }
        }
        let elapsed = clock.elapsed().as_secs_f64();
        let steps = simulation.steps().max(1) as f64;
        let evaluations = (simulation.evaluations() - before) as f64;
        Ok(Self {
            particles,
            neighbours: pairs as f64 / particles as f64,
            bytes_per_particle: bytes as f64 / particles as f64,
            stress_operations,
            steps: libm::ceil(scene.run.until / rest) as u64,
            evaluations_per_step: evaluations / steps,
            seconds_per_step: elapsed / steps,
            updates_per_second: evaluations * particles as f64 / elapsed.max(f64::MIN_POSITIVE),
        })
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = self.seconds_per_step * self.steps as f64;
        let mut line = |what: &str, value: String| writeln!(f, "    {what:<24}{value}");
        line("particles", self.particles.to_string())?;
        line("neighbours", format!("{:.1} a particle", self.neighbours))?;
        line("memory", format!("{:.0} bytes a particle", self.bytes_per_particle))?;
        line("stress", format!("{} operations a particle and stage", self.stress_operations))?;
        line("stages", format!("{:.0} a step", self.evaluations_per_step))?;
        line("steps", format!("{} at the wave speed at rest; more as the material stiffens", self.steps))?;
        line("speed", format!("{:.2e} particle updates a second, measured now", self.updates_per_second))?;
        line("time", format!("{seconds:.1} s at least"))
    }
}
