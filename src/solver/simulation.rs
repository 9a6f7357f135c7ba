//! A simulation in time.
//!
//! Owns the clock: the stable step, velocity Verlet and the search for inadmissible states. Knows
//! neither text, units nor files.

mod runge_kutta;
mod start;

use self::runge_kutta::{HEUN, SSP_RK3};
use super::affine::AffineMotion;
use super::body::{BodyState, CHUNK};
use super::bond::Bonds;
use super::diagnosis;
use super::dissipation::Speeds;
use super::error::SolveError;
use super::exact::Target;
use super::hourglass::hourglass;
use super::impulse::Impulses;
use super::ledger::{Energies, Ledger};
use super::loads::ExternalForces;
use super::pace::Pace;
use super::pass::{
    ForceTerms, VolumeTerms, Workspaces, forces, gradients_of_positions, maps_and_stress, wave_speeds,
};
use super::projection::Projection;
use super::time_step::stable_step;
use crate::energy::Scratch;
use crate::plan::RELAXATION_OF_J;
use crate::scene::{Integrator, Run, VolumeDissipation};
use rayon::prelude::*;

/// A running simulation.
#[derive(Debug)]
pub struct Simulation {
    bodies: Vec<BodyState>,
    affine: Vec<AffineMotion>,
    external: Vec<ExternalForces>,
    bonds: Bonds,
    projection: Vec<Option<Projection>>,
    impulses: Vec<Impulses>,
    run: Run,
    damping: f64,
    time: f64,
    steps: u64,
    evaluations: u64,
    pace: Pace,
    ledger: Ledger,
    energy: Scratch,
    judged: bool,
    last_step: f64,
    workspaces: Workspaces,
    scratch: Vec<f64>,
    ends: Vec<(f64, f64)>,
}

impl Simulation {
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

    /// The step held, at most what the Courant condition allowed when it was last asked and 8 %, s.
    pub fn stable_step(&self) -> f64 {
        self.pace.step()
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

    /// What supports and loads gave to the momentum of each body, for records that ask.
    pub fn impulses(&self) -> &[Impulses] {
        &self.impulses
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
        let every = self.run.wave_speed_every;
        if every > 0 && (self.steps == 0 || self.pace.is_due(every)) {
            self.refresh_stable_step()?;
        }
        let mut longest = self.pace.step();
        if every > 0 {
            longest = longest.min(LARGEST_STRAIN / self.straining());
        }
        let count = libm::ceil(left / longest).max(1.0);
        let step = left / count;
        let next = if count == 1.0 { target } else { self.time + step };
        self.advance_supports(next);
        match self.run.integrator {
            Integrator::VelocityVerlet => self.velocity_verlet(step, next)?,
            Integrator::TvdRk2 => self.runge_kutta(&HEUN, step)?,
            Integrator::SspRk3 => self.runge_kutta(&SSP_RK3, step)?,
        }
        self.time = next;
        self.steps += 1;
        self.last_step = step;
        self.pace.moved(step * self.straining());
        if self.steps.is_multiple_of(REDERIVE) {
            self.bodies.iter_mut().for_each(gradients_of_positions);
        }
        diagnosis::not_finite(&self.bodies, &self.run, step, next).map_or(Ok(()), Err)?;
        if Ledger::is_due(self.steps) {
            self.judge_energy()?;
        }
        Ok(count == 1.0)
    }

    /// Energies of the state now, of the modelled part.
    pub fn energies(&mut self) -> Energies {
        Energies::of(&self.bodies, &mut self.energy)
    }

    /// Works and losses since the start.
    pub fn ledger(&self) -> &Ledger {
        &self.ledger
    }

    /// Looks at whether energy has come from nothing.
    ///
    /// Not where an exact motion moves bodies, whose work nobody counts, nor with D(J): off J = det F the energy
    /// is no bound on anything.
    ///
    /// # Errors
    /// [`SolveError::EnergyFromNothing`].
    pub fn judge_energy(&mut self) -> Result<(), SolveError> {
        if !self.judged {
            return Ok(());
        }
        let now = self.energies();
        self.ledger.judge(&self.bodies, &now, &self.run, self.last_step, self.time)
    }

    /// Greatest `|Grad v|` of all bodies, 1/s.
    fn straining(&self) -> f64 {
        self.bodies.iter().map(BodyState::straining).fold(0.0, f64::max)
    }

    /// Brings stresses and accelerations up to the state, for whoever reads them next.
    ///
    /// Velocity Verlet ends a step with them; Runge–Kutta methods end with a mean of stages, at which
    /// nothing has been evaluated yet.
    ///
    /// # Errors
    /// If the state has left the domain of an energy.
    pub fn synchronise(&mut self) -> Result<(), SolveError> {
        if self.run.integrator != Integrator::VelocityVerlet && self.steps > 0 {
            self.evaluate_external(self.time);
            self.evaluate(0.0, 0.0)?;
            self.project_accelerations();
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
        self.impose(step, 1.0);
        self.add_loads(0.5 * step);
        self.drift(step);
        self.evaluate_external(next);
        self.last_step = step;
        self.evaluate(step, 1.0)?;
        self.project_accelerations();
        self.kick(0.5 * step);
        self.impose(step, 1.0);
        self.add_loads(0.5 * step);
        Ok(())
    }

    /// One evaluation of the right-hand side; advances the maps by `step` first if it is positive.
    ///
    /// `weight` is the share of the step that its rates count for.
    fn evaluate(&mut self, step: f64, weight: f64) -> Result<(), SolveError> {
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
            if let Some(hourglass) = &self.bodies[index].hourglass {
                self.ledger.dissipated += self.last_step * weight * hourglass.dissipated_power();
            }
        }
        if self.damping > 0.0 {
            let step = self.last_step;
            for (index, affine) in self.affine.iter().enumerate() {
                affine.ends(&self.bodies, step, &mut self.ends);
                let BodyState { particles, v, acceleration, .. } = &mut self.bodies[index];
                affine.damp(self.damping, &particles.position, &self.ends, v, acceleration);
                let BodyState { particles, v, density, .. } = &self.bodies[index];
                let power = affine.power(self.damping, particles, *density, &self.ends, v);
                self.ledger.add_damping(power, step * weight);
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
            volume: self.volume_terms(body),
        }
    }

    fn volume_terms(&self, body: &BodyState) -> Option<VolumeTerms> {
        let speed = body.rest.pressure;
        let relaxation = match self.run.volume_dissipation {
            VolumeDissipation::Off => return None,
            VolumeDissipation::On => 0.0,
            VolumeDissipation::Restoring { rate } => {
                rate.unwrap_or(RELAXATION_OF_J * speed / body.particles.spacing)
            }
        };
        Some(VolumeTerms { speed: speed / self.run.volume_wave_weight, relaxation })
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

    /// Imposes prescribed velocities; what they change counts as impulse with a weight.
    fn impose(&mut self, step: f64, weight: f64) {
        for (body, impulses) in self.bodies.iter_mut().zip(&mut self.impulses) {
            for (index, support) in body.supports.iter().enumerate() {
                impulses.add_reaction(
                    index,
                    weight,
                    body.density,
                    &body.particles.volume,
                    &body.v,
                    step,
                    support,
                );
                self.ledger.add_support(body, support, step, weight);
                support.impose(&mut body.v, step);
            }
        }
        let Self { bonds, bodies, impulses, .. } = self;
        bonds.follow(bodies, &mut |body, support, momentum| {
            impulses[body].add_carried(support, weight * momentum);
        });
    }

    /// Counts the loads of the last evaluation over a time `step`.
    fn add_loads(&mut self, step: f64) {
        for ((impulses, external), body) in self.impulses.iter_mut().zip(&self.external).zip(&self.bodies) {
            impulses.add_loads(step, body, external);
            self.ledger.add_loads(body, step);
        }
    }

    /// Takes the torque of the internal forces out of the accelerations of free bodies.
    fn project_accelerations(&mut self) {
        for (body, projection) in self.bodies.iter_mut().zip(&mut self.projection) {
            if let Some(projection) = projection {
                projection.remove_torque(body);
            }
        }
    }

    fn advance_supports(&mut self, time: f64) {
        for body in &mut self.bodies {
            for support in &mut body.supports {
                support.advance(time, &body.particles.position, &mut self.scratch);
            }
        }
    }

    fn evaluate_external(&mut self, time: f64) {
        for (body, external) in self.bodies.iter_mut().zip(&mut self.external) {
            if (external.varies_in_time || body.exact.is_some()) && !body.external.is_empty() {
                let BodyState { particles, external: out, exact, law, x, inverse_volume, .. } = body;
                external.evaluate(particles, time, out, &mut self.scratch);
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
            let rate = body.rates.shared + self.damping;
            let elastic = stable_step(self.run.cfl, body.elastic_length, speed, body.hourglass_rate, rate);
            let relaxed = self.run.cfl * body.rates.relaxation_step();
            // `f64::min` alone would drop a NaN
            let is_number = !elastic.is_nan() && !relaxed.is_nan();
            let required = if is_number { elastic.min(relaxed) } else { f64::NAN };
            let allowed = SMALLEST_STEP * self.run.until;
            if required.is_nan() || required < allowed {
                return Err(SolveError::TimeStepTooSmall {
                    particle,
                    body: body.name.clone(),
                    position: body.particles.position[particle],
                    time: self.time,
                    required,
                    allowed,
                    cause: Box::new(diagnosis::cause(body, particle, &self.run, self.last_step)),
                });
            }
            stable = stable.min(required);
        }
        self.pace.refresh(stable, self.run.courant_limit() / self.run.cfl);
        Ok(())
    }
}

/// Particles of a chunk of the passes that read only the particle itself.
const LOCAL: usize = 16 * CHUNK;

/// Steps after which F is derived anew from the positions.
///
/// Both add up the same velocities, so nothing changes but round-off, which would otherwise go on growing:
/// |F − Grad_h x| was 7.9e-13 after 18 000 steps and stays near 1e-13 now. One more walk over the pairs in
/// a thousand steps.
const REDERIVE: u64 = 1000;

/// Strain a step may bring at most.
///
/// Waves bound the step only if nothing moves faster than they: at an impact of three times their speed a node
/// overtakes its neighbour within one. With a quarter, compression is met by three steps of stress before it is
/// complete.
const LARGEST_STRAIN: f64 = 0.25;

/// Smallest step worth taking, as a share of the end time: above it, 10⁹ steps.
const SMALLEST_STEP: f64 = 1e-9;
