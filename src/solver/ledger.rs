//! The energy a run was given, and what became of it.
//!
//! Owns the work of loads and supports and what dissipation and damping took, summed over the steps, and the
//! judgement that an energy has come from nothing. Knows no pass and no stage.

use super::body::{BodyState, CHUNK};
use super::constraint::Support;
use super::diagnosis;
use super::error::SolveError;
use super::hourglass;
use super::quad::Quad;
use crate::energy::Scratch;
use crate::scene::Run;

/// Steps between two looks at the energy: the strain energy costs about a stress pass.
const EVERY: u64 = 100;

/// Energies of all bodies, of the modelled part, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energies {
    /// `Σ V_a ½ ρR |v_a|²`.
    pub kinetic: f64,
    /// `Σ V_a ψ_a`.
    pub strain: f64,
    /// Of the springs against hourglass modes.
    pub springs: f64,
}

impl Energies {
    /// Sums a state, in particle order.
    pub fn of(bodies: &[BodyState], scratch: &mut Scratch) -> Self {
        let mut sums = Self::default();
        let mut density = [0.0; CHUNK];
        for body in bodies {
            sums.springs += hourglass::energy(body);
            for (v, volume) in body.v.iter().zip(&body.particles.volume) {
                sums.kinetic += 0.5 * body.density * volume * v.dot(*v);
            }
            for block in &body.blocks {
                let out = &mut density[..block.f.len()];
                body.law.density(
                    block.maps(),
                    body.directions.slice(block.start, block.f.len()),
                    out,
                    scratch,
                );
                for (psi, volume) in out.iter().zip(&body.particles.volume[block.start..]) {
                    sums.strain += volume * psi;
                }
            }
        }
        sums
    }

    /// Their sum, J.
    pub fn total(&self) -> f64 {
        self.kinetic + self.strain + self.springs
    }
}

/// Balance of energy since the start, of the modelled part.
///
/// ```text
/// E(t) − E(0) = W_loads + W_supports − D_pairs − D_damping + residual
/// ```
///
/// The residual is what the integrator errs by, of second order in the step for velocity Verlet; upwinding between
/// constant states and D(J) are part of it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ledger {
    /// Energies at the start.
    pub start: Energies,
    /// `Σ Δt Σ V_a E_a · v_a`, J.
    pub loads: f64,
    /// `Σ Σ m (v' − v) v'` over what supports impose, J.
    pub supports: f64,
    /// What dashpots took, `Σ Δt Σ d · S d`, J.
    pub dissipated: f64,
    /// What the damping of quasi-static loading took, J.
    pub damped: f64,
    /// Greatest of what had been put in at any time: initial energy and works, J.
    given: f64,
}

impl Ledger {
    /// Opens the ledger on an initial state.
    pub fn new(start: Energies) -> Self {
        Self { start, given: start.total().abs(), ..Self::default() }
    }

    /// Adds the work of the loads on one body over `step`, s, with the velocities that supports have been imposed on.
    pub fn add_loads(&mut self, body: &BodyState, step: f64) {
        for ((force, v), volume) in body.external.iter().zip(&body.v).zip(&body.particles.volume) {
            self.loads += step * volume * force.dot(*v);
        }
    }

    /// Adds the work of a support about to act, with the weight of its stage.
    ///
    /// ```text
    /// W += w Σ m (v_prescribed − v) v_prescribed
    /// ```
    ///
    /// the impulse of the reaction times the velocity it moves with; a node that is held has none.
    pub fn add_support(&mut self, body: &BodyState, support: &Support, step: f64, weight: f64) {
        for (i, &node) in support.nodes.iter().enumerate() {
            let (before, after) = (body.v[node as usize].0[support.axis], support.velocity(i, step));
            let mass = body.density * body.particles.volume[node as usize];
            self.supports += weight * mass * (after - before) * after;
        }
    }

    /// Adds what damping relative to an affine motion takes: `Σ m a_d · v` with its accelerations `a_d`.
    pub fn add_damping(&mut self, power: f64, step: f64) {
        self.damped -= step * power;
    }

    /// What is not accounted for, J.
    pub fn residual(&self, now: &Energies) -> f64 {
        now.total() - self.start.total() - self.loads - self.supports + self.dissipated + self.damped
    }

    /// Whether the energy is to be looked at after so many steps.
    pub fn is_due(steps: u64) -> bool {
        steps.is_multiple_of(EVERY)
    }

    /// Looks at the energy of a state: none may come from nothing.
    ///
    /// ```text
    /// E ≤ g max_t (|E(0)| + W_loads + W_supports + W_damping),    g = max(2, 1/(1 − α²))
    /// ```
    ///
    /// velocity Verlet keeps `½ v² + ½ (1 − z²/4) ω² x²` of every wave, `z = ω Δt ≤ 2 α`, so the energy of the fastest
    /// may stand at up to `g` times its least value. The works count where they are positive (damping relative to an affine
    /// motion drives what lags behind it) and are of first order in the step for Runge–Kutta methods, hence the two: an
    /// instability passes any factor within some steps.
    ///
    /// # Errors
    /// [`SolveError::EnergyFromNothing`], at the particle that moves fastest.
    pub fn judge(
        &mut self,
        bodies: &[BodyState],
        now: &Energies,
        run: &Run,
        step: f64,
        time: f64,
    ) -> Result<(), SolveError> {
        let works = [self.loads, self.supports, -self.damped];
        let works: f64 = works.iter().map(|work| work.max(0.0)).sum();
        self.given = self.given.max(self.start.total().abs() + works);
        let share = (run.cfl / run.courant_limit()).min(1.0);
        let growth = LEAST.max(1.0 / (1.0 - share * share).max(SLACK));
        let energy = now.total();
        if energy <= growth * self.given || self.given == 0.0 && energy <= f64::MIN_POSITIVE {
            return Ok(());
        }
        let fastest = |body: &BodyState| {
            let squares = body.v.iter().map(|v: &Quad| v.dot(*v)).enumerate();
            squares.fold((0, 0.0), |best, (a, square)| if square > best.1 { (a, square) } else { best })
        };
        let (index, (particle, _)) = bodies
            .iter()
            .map(fastest)
            .enumerate()
            .max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1))
            .unwrap_or_default();
        let body = &bodies[index];
        Err(SolveError::EnergyFromNothing {
            cause: Box::new(diagnosis::cause(body, particle, run, step)),
            particle,
            body: body.name.clone(),
            position: body.particles.position[particle],
            time,
            energy,
            given: self.given,
        })
    }
}

/// Least factor between an energy and what was put in.
const LEAST: f64 = 2.0;

/// Least `1 − α²` the bound is formed with: Courant numbers beyond 0.95 of the limit are judged as that.
const SLACK: f64 = 0.1;
