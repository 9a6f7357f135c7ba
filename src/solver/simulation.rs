//! A simulation in time.
//!
//! Owns the clock: the stable step, the integrators and the search for inadmissible states. Knows
//! neither text, units nor files.

use super::affine::{AffineMotion, affine_motions};
use super::assemble::{Assembled, assemble};
use super::body::{Block, BodyState, CHUNK};
use super::bond::Bonds;
use super::diagnosis;
use super::dissipation::Speeds;
use super::error::SolveError;
use super::exact::Target;
use super::hourglass::hourglass;
use super::loads::ExternalForces;
use super::pass::{ForceTerms, Workspaces, advance_maps, forces, maps_and_stress, wave_speeds};
use super::quad::Quad;
use super::time_step::{dissipation_rate, stable_step};
use crate::plan::{Pass, Plan, damping_rate};
use crate::scene::{Integrator, InterfaceStates, Run, Scene};
use rayon::prelude::*;

/// A running simulation.
#[derive(Debug)]
pub struct Simulation {
    bodies: Vec<BodyState>,
    affine: Vec<AffineMotion>,
    external: Vec<ExternalForces>,
    bonds: Bonds,
    run: Run,
    damping: f64,
    time: f64,
    steps: u64,
    evaluations: u64,
    stable_step: f64,
    last_step: f64,
    workspaces: Workspaces,
    scratch: Vec<f64>,
    ends: Vec<(f64, f64)>,
}

impl Simulation {
    /// Assembles a scene as planned, at time zero, with forces evaluated.
    ///
    /// # Errors
    /// If a body cannot be discretised, an energy cannot be compiled, or the initial state is
    /// inadmissible.
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Self, SolveError> {
        let mut simulation = Self {
            bodies: Vec::new(),
            affine: Vec::new(),
            external: Vec::new(),
            bonds: Bonds::default(),
            run: scene.run.clone(),
            damping: damping_rate(scene),
            time: 0.0,
            steps: 0,
            evaluations: 0,
            stable_step: 0.0,
            last_step: 0.0,
            workspaces: Workspaces::new(),
            scratch: Vec::new(),
            ends: Vec::new(),
        };
        if plan.runs(Pass::MomentumDissipation) == (scene.run.momentum_dissipation == InterfaceStates::Off) {
            simulation.run.momentum_dissipation = InterfaceStates::Off;
        }
        for index in 0..scene.bodies.len() {
            let Assembled { state, external } = assemble(scene, plan, index)?;
            simulation.bodies.push(state);
            simulation.external.push(external);
        }
        simulation.bonds = Bonds::new(scene, &mut simulation.bodies)?;
        simulation.affine = affine_motions(scene, plan, &simulation.bodies);
        for index in 0..simulation.bodies.len() {
            let terms = simulation.force_terms(index);
            let rate = dissipation_rate(&mut simulation.bodies[index], terms);
            // D(J) relaxes J at the same rate as D(p) relaxes p: both go with c_p over the spacing
            let share = if terms.volume.is_some() { 2.0 } else { 1.0 };
            simulation.bodies[index].dissipation_rate = share * rate;
        }
        simulation.refresh_stable_step()?;
        simulation.prepare_supports(simulation.stable_step);
        if simulation.damping > 0.0 {
            for (index, affine) in simulation.affine.iter().enumerate() {
                // the scene's own start velocities stand, and bonded bodies start as one
                if simulation.bodies.iter().any(|body| body.launch_speed > 0.0) {
                    continue;
                }
                affine.ends(&simulation.bodies, simulation.stable_step, &mut simulation.ends);
                let body = &mut simulation.bodies[index];
                affine.start(&body.particles.position, &simulation.ends, &mut body.v);
            }
        }
        simulation.last_step = simulation.stable_step;
        simulation.impose(simulation.stable_step);
        simulation.meet_velocities();
        simulation.evaluate(0.0)?;
        simulation.rewind_supports();
        Ok(simulation)
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Evaluations of the right-hand side, one a stage.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Length of the last step, s.
    pub fn last_step(&self) -> f64 {
        self.last_step
    }

    /// Largest step the Courant condition allows now, s.
    pub fn stable_step(&self) -> f64 {
        self.stable_step
    }

    /// The bodies.
    pub fn bodies(&self) -> &[BodyState] {
        &self.bodies
    }

    /// The bodies, for tests that put them into a state of their own.
    #[cfg(test)]
    pub(super) fn bodies_mut(&mut self) -> &mut Vec<BodyState> {
        &mut self.bodies
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.bodies.iter().map(BodyState::len).sum()
    }

    /// Takes one step towards a time, which is met exactly by the last of the equal steps that lead
    /// to it. Returns whether it is reached.
    ///
    /// # Errors
    /// If the state leaves the domain of an energy or the stable step collapses; the state is then
    /// the inadmissible one.
    pub fn step_towards(&mut self, target: f64) -> Result<bool, SolveError> {
        let left = target - self.time;
        if left <= 0.0 {
            return Ok(true);
        }
        if self.run.wave_speed_every > 0 && self.steps.is_multiple_of(u64::from(self.run.wave_speed_every)) {
            self.refresh_stable_step()?;
        }
        let count = libm::ceil(left / self.stable_step).max(1.0);
        let step = left / count;
        let next = if count == 1.0 { target } else { self.time + step };
        self.advance_supports(next);
        match self.run.integrator {
            Integrator::VelocityVerlet => self.velocity_verlet(step, next)?,
            Integrator::TvdRk2 => self.heun(step, next)?,
        }
        self.time = next;
        self.steps += 1;
        self.last_step = step;
        diagnosis::not_finite(&self.bodies, &self.run, step, next).map_or(Ok(()), Err)?;
        Ok(count == 1.0)
    }

    /// Brings stresses and accelerations up to the state, for whoever reads them next.
    ///
    /// Velocity Verlet ends a step with them; Heun's method ends with the mean of two stages, at which
    /// nothing has been evaluated yet.
    ///
    /// # Errors
    /// If the state has left the domain of an energy.
    pub fn synchronise(&mut self) -> Result<(), SolveError> {
        if self.run.integrator == Integrator::TvdRk2 && self.steps > 0 {
            if self.follows() {
                self.evaluate_external(self.time);
            }
            self.evaluate(0.0)?;
        }
        self.meet_velocities();
        Ok(())
    }

    /// Gives what an exact motion moves its velocity of now instead of the mean over the step.
    ///
    /// Nothing but a reader sees the difference: every stage imposes its own.
    fn meet_velocities(&mut self) {
        for body in &mut self.bodies {
            if let Some(exact) = &mut body.exact {
                exact.meet_velocities(&mut body.v, self.time);
            }
        }
    }

    /// Velocity Verlet: half a kick, a drift, forces, half a kick; synchronised at its end.
    fn velocity_verlet(&mut self, step: f64, next: f64) -> Result<(), SolveError> {
        self.kick(0.5 * step);
        self.impose(step);
        self.drift(step);
        self.evaluate_external(next);
        self.last_step = step;
        self.evaluate(step)?;
        self.kick(0.5 * step);
        self.impose(step);
        Ok(())
    }

    /// Two-stage TVD Runge–Kutta, Heun's method.
    ///
    /// ```text
    /// U*   = Uⁿ + Δt U̇(Uⁿ, tⁿ)                         [NB25 (39)]
    /// U**  = U* + Δt U̇(U*, tⁿ⁺¹)                       [NB25 (40)]
    /// Uⁿ⁺¹ = ½ (Uⁿ + U**)                              [NB25 (41)]
    /// ```
    ///
    /// The positions go through the same stages. Prescribed velocities are imposed at both.
    fn heun(&mut self, step: f64, next: f64) -> Result<(), SolveError> {
        for body in &mut self.bodies {
            let BodyState { x, v, saved, blocks, .. } = body;
            saved.0.copy_from_slice(x);
            saved.1.copy_from_slice(v);
            for Block { f, h, j, saved, .. } in blocks {
                saved.0.copy_from_slice(f);
                saved.1.copy_from_slice(h);
                saved.2.copy_from_slice(j);
            }
        }
        self.last_step = step;
        for stage in 0..2 {
            self.impose(step);
            if stage == 1 {
                self.evaluate_external(next);
            } else if self.follows() {
                // what was evaluated last belongs to the second stage's positions
                self.evaluate_external(self.time);
            }
            self.evaluate(0.0)?;
            self.drift(step);
            self.kick(step);
            for body in &mut self.bodies {
                advance_maps(body, step);
            }
        }
        for body in &mut self.bodies {
            average(body);
        }
        self.impose(step);
        Ok(())
    }

    /// One evaluation of the right-hand side; advances the maps by `step` first if it is positive.
    fn evaluate(&mut self, step: f64) -> Result<(), SolveError> {
        self.evaluations += 1;
        for body in &mut self.bodies {
            maps_and_stress(body, step, &self.workspaces);
        }
        let found = diagnosis::failure(&self.bodies, &self.run, self.last_step, self.time);
        found.map_or(Ok(()), Err)?;
        for index in 0..self.bodies.len() {
            let terms = self.force_terms(index);
            hourglass(&mut self.bodies[index]);
            forces(&mut self.bodies[index], terms);
        }
        if self.damping > 0.0 {
            let step = self.last_step;
            for (index, affine) in self.affine.iter().enumerate() {
                affine.ends(&self.bodies, step, &mut self.ends);
                let BodyState { particles, v, acceleration, .. } = &mut self.bodies[index];
                affine.damp(self.damping, &particles.position, &self.ends, v, acceleration);
            }
        }
        self.bonds.share_forces(&mut self.bodies);
        Ok(())
    }

    fn force_terms(&self, index: usize) -> ForceTerms {
        let body = &self.bodies[index];
        ForceTerms {
            states: self.run.momentum_dissipation,
            speeds: Speeds {
                pressure: self.run.pressure_wave_weight * body.rest.pressure,
                shear: self.run.shear_wave_weight * body.rest.shear,
            },
            volume: self.run.volume_dissipation.then_some(body.rest.pressure),
        }
    }

    fn kick(&mut self, step: f64) {
        for body in &mut self.bodies {
            let BodyState { v, acceleration, .. } = body;
            v.par_chunks_mut(LOCAL).zip(acceleration.par_chunks(LOCAL)).for_each(|(v, a)| {
                for (v, a) in v.iter_mut().zip(a) {
                    *v += *a * step;
                }
            });
        }
    }

    fn drift(&mut self, step: f64) {
        for body in &mut self.bodies {
            let BodyState { x, v, .. } = body;
            x.par_chunks_mut(LOCAL).zip(v.par_chunks(LOCAL)).for_each(|(x, v)| {
                for (x, v) in x.iter_mut().zip(v) {
                    *x += *v * step;
                }
            });
        }
    }

    fn impose(&mut self, step: f64) {
        for body in &mut self.bodies {
            for support in &body.supports {
                support.impose(&mut body.v, step);
            }
        }
        self.bonds.follow(&mut self.bodies);
    }

    fn advance_supports(&mut self, time: f64) {
        for body in &mut self.bodies {
            for support in &mut body.supports {
                support.advance(time, &body.particles.position, &mut self.scratch);
            }
        }
    }

    /// Supports as over a first step, so that the initial velocities are the step's own.
    fn prepare_supports(&mut self, step: f64) {
        self.advance_supports(step);
    }

    fn rewind_supports(&mut self) {
        self.advance_supports(0.0);
    }

    /// Whether any external force depends on the positions.
    fn follows(&self) -> bool {
        self.external.iter().any(ExternalForces::follows)
    }

    fn evaluate_external(&mut self, time: f64) {
        for (body, external) in self.bodies.iter_mut().zip(&self.external) {
            if (external.varies_in_time || body.exact.is_some()) && !body.external.is_empty() {
                let BodyState { particles, external: out, exact, law, x, inverse_volume, .. } = body;
                external.evaluate(&particles.position, time, out, &mut self.scratch);
                let positions = (&particles.position[..], &x[..]);
                external.add_followers(positions, inverse_volume, time, out, &mut self.scratch);
                if let Some(exact) = exact {
                    let target = Target { law, reference: &particles.position, external: out };
                    exact.add_forces(target, time, &self.workspaces);
                }
            }
        }
    }

    /// Refreshes the step of the Courant condition, see [`stable_step`]; the wave speed is the
    /// greatest of the acoustic tensors of the current state, or the speed at rest if the scene says so.
    fn refresh_stable_step(&mut self) -> Result<(), SolveError> {
        let mut stable = f64::INFINITY;
        for body in &mut self.bodies {
            if self.run.wave_speed_every > 0 {
                wave_speeds(body, &self.workspaces);
            }
            let (speed, particle) = body.fastest;
            let rate = body.dissipation_rate + self.damping;
            let required = stable_step(self.run.cfl, body.elastic_length, speed, body.hourglass_rate, rate);
            let allowed = SMALLEST_STEP * self.run.until;
            if required.is_nan() || required < allowed {
                let position = body.particles.position[particle];
                let (body, time) = (body.name.clone(), self.time);
                return Err(SolveError::TimeStepTooSmall {
                    particle,
                    body,
                    position,
                    time,
                    required,
                    allowed,
                });
            }
            stable = stable.min(required);
        }
        self.stable_step = stable;
        Ok(())
    }
}

/// Particles of a chunk of the passes that read only the particle itself.
const LOCAL: usize = 16 * CHUNK;

/// Smallest step worth taking, as a share of the end time: above it, 10⁹ steps.
const SMALLEST_STEP: f64 = 1e-9;

/// The last line of Heun's method.
fn average(body: &mut BodyState) {
    fn half_sum(now: &mut [Quad], saved: &[Quad]) {
        for (now, saved) in now.iter_mut().zip(saved) {
            *now = (*saved + *now) * 0.5;
        }
    }
    half_sum(&mut body.x, &body.saved.0);
    half_sum(&mut body.v, &body.saved.1);
    body.blocks.par_iter_mut().for_each(|Block { f, h, j, saved, .. }| {
        for (now, saved) in f.iter_mut().zip(&saved.0).chain(h.iter_mut().zip(&saved.1)) {
            *now = 0.5 * (*saved + *now);
        }
        for (now, saved) in j.iter_mut().zip(&saved.2) {
            *now = 0.5 * (*saved + *now);
        }
    });
}
