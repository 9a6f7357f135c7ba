//! Runge–Kutta methods made of explicit Euler steps.
//!
//! Owns the stages of the two methods that keep what an Euler step keeps (total variation, positivity)
//! and their walk through the state. What a stage evaluates is the simulation's.

use super::super::body::{Block, BodyState};
use super::super::error::SolveError;
use super::super::pass::advance_maps;
use super::super::quad::Quad;
use super::Simulation;
use rayon::prelude::*;

/// One stage: an Euler step from the stage before, then a mean with the start of the step.
///
/// ```text
/// U ← Uⁿ + share (U + Δt U̇(U, tⁿ + at Δt) − Uⁿ)
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Stage {
    share: f64,
    at: f64,
    /// Weight of the stage's rate in the whole step.
    weight: f64,
}

/// Heun's method, the two-stage TVD method of the paper.
///
/// ```text
/// U*   = Uⁿ + Δt U̇(Uⁿ, tⁿ)                         [NB25 (39)]
/// U**  = U* + Δt U̇(U*, tⁿ⁺¹)                       [NB25 (40)]
/// Uⁿ⁺¹ = ½ (Uⁿ + U**)                              [NB25 (41)]
/// ```
pub(super) const HEUN: [Stage; 2] =
    [Stage { share: 1.0, at: 0.0, weight: 0.5 }, Stage { share: 0.5, at: 1.0, weight: 0.5 }];

/// The three-stage method of third order of Shu & Osher 1988.
///
/// ```text
/// U¹   = Uⁿ + Δt U̇(Uⁿ, tⁿ)
/// U²   = ¾ Uⁿ + ¼ (U¹ + Δt U̇(U¹, tⁿ⁺¹))
/// Uⁿ⁺¹ = ⅓ Uⁿ + ⅔ (U² + Δt U̇(U², tⁿ⁺½))
/// ```
pub(super) const SSP_RK3: [Stage; 3] = [
    Stage { share: 1.0, at: 0.0, weight: 1.0 / 6.0 },
    Stage { share: 0.25, at: 1.0, weight: 1.0 / 6.0 },
    Stage { share: 2.0 / 3.0, at: 0.5, weight: 2.0 / 3.0 },
];

impl Simulation {
    /// One step. The positions go through the same stages; prescribed velocities are imposed at each.
    pub(super) fn runge_kutta(&mut self, stages: &[Stage], step: f64) -> Result<(), SolveError> {
        self.bodies.iter_mut().for_each(save);
        for (projection, body) in self.projection.iter_mut().zip(&self.bodies) {
            if let Some(projection) = projection {
                projection.start(body);
            }
        }
        self.last_step = step;
        for (index, stage) in stages.iter().enumerate() {
            self.impose(step, stage.weight);
            self.evaluate_external(self.time + stage.at * step);
            self.evaluate(0.0, stage.weight)?;
            self.add_loads(stage.weight * step);
            let last = index + 1 == stages.len();
            for (projection, body) in self.projection.iter_mut().zip(&mut self.bodies) {
                let Some(projection) = projection else { continue };
                projection.add_loads(body, stage.weight * step);
                if last {
                    projection.close(body, stage.share, step);
                } else {
                    projection.remove_torque(body);
                }
            }
            self.drift(step);
            self.kick(step);
            for body in &mut self.bodies {
                advance_maps(body, step);
                if stage.share < 1.0 {
                    blend(body, stage.share);
                }
            }
        }
        self.impose(step, 1.0);
        Ok(())
    }
}

/// Notes the start of a step.
fn save(body: &mut BodyState) {
    let BodyState { x, v, saved, blocks, .. } = body;
    saved.0.copy_from_slice(x);
    saved.1.copy_from_slice(v);
    for Block { f, h, j, saved, .. } in blocks {
        saved.0.copy_from_slice(f);
        saved.1.copy_from_slice(h);
        saved.2.copy_from_slice(j);
    }
}

/// The mean of a stage with the start of the step, written so that what did not change stays bit by bit.
fn blend(body: &mut BodyState, share: f64) {
    fn mean(now: &mut [Quad], saved: &[Quad], share: f64) {
        for (now, &saved) in now.iter_mut().zip(saved) {
            *now = saved + (*now - saved) * share;
        }
    }
    mean(&mut body.x, &body.saved.0, share);
    mean(&mut body.v, &body.saved.1, share);
    body.blocks.par_iter_mut().for_each(|Block { f, h, j, saved, .. }| {
        for (now, saved) in f.iter_mut().zip(&saved.0).chain(h.iter_mut().zip(&saved.1)) {
            *now = saved + (*now - saved) * share;
        }
        for (now, saved) in j.iter_mut().zip(&saved.2) {
            *now = saved + share * (*now - saved);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::super::Simulation;
    use crate::plan::Plan;
    use crate::scene::{Memory, resolve};
    use crate::syntax::Source;

    /// Positions and velocities after 20 steps on a number of threads, bit by bit.
    fn bits(run: &str, threads: usize) -> Vec<u64> {
        let text = format!(
            "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3 }}
scene thrown {{
  body cube {{ shape = box(1 m, 1 m, 1 m)  spacing = 0.2 m  jitter = 0.1  material = gel }}
  start cube {{ velocity = [1 s^-1 * Y, 0.3 s^-1 * Z, 0.5 s^-1 * X] }}
  traction cube.zmax {{ value = [0 Pa, 0 Pa, 1 Pa * sin(3 s^-1 * t)] }}
  run {{ until = 100 s  formulation = pFHJ  volume_dissipation = restoring  angular_momentum = projected  {run} }}
}}
"
        );
        let (document, mistakes) = resolve(&Source { name: "text".into(), text }, &Memory::default(), &[]);
        assert!(mistakes.is_empty(), "the scene resolves");
        let scene = &document.scenes[0];
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut simulation = Simulation::new(scene, &Plan::new(scene)).expect("the scene can be set up");
            for _ in 0..20 {
                simulation.step_towards(scene.run.until).expect("the scene runs");
            }
            let body = &simulation.bodies()[0];
            body.x.iter().chain(&body.v).flat_map(|quad| quad.0.map(f64::to_bits)).collect()
        })
    }

    #[test]
    fn every_integrator_gives_the_same_bits_on_any_number_of_threads() {
        let runs = ["integrator = tvd_rk2", "integrator = ssp_rk3", "integrator = velocity_verlet"];
        let results = runs.map(|run| bits(run, 1));
        for (run, one) in runs.iter().zip(&results) {
            assert!(bits(run, 3) == *one, "{run}");
        }
        assert!(results[0] != results[1] && results[1] != results[2], "and each its own");
    }
}
