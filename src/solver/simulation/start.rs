//! Set-up of a simulation: bodies assembled, forces of the first state evaluated.
//!
//! Owns the order in which a scene becomes a running simulation. Knows neither text, units nor files.

use super::Simulation;
use crate::energy::Scratch;
use crate::plan::{Pass, Plan, damping_rate};
use crate::scene::{InterfaceStates, Scene, VolumeDissipation};
use crate::solver::affine::affine_motions;
use crate::solver::assemble::{Assembled, assemble, discretise};
use crate::solver::bond::Bonds;
use crate::solver::diagnosis;
use crate::solver::error::SolveError;
use crate::solver::impulse::Impulses;
use crate::solver::ledger::Ledger;
use crate::solver::pace::Pace;
use crate::solver::pass::{Workspaces, maps_and_stress};
use crate::solver::projection::Projection;
use crate::solver::time_step::Rates;

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
            projection: Vec::new(),
            impulses: Vec::new(),
            run: scene.run.clone(),
            damping: damping_rate(scene),
            time: 0.0,
            steps: 0,
            evaluations: 0,
            pace: Pace::new(),
            ledger: Ledger::default(),
            energy: Scratch::default(),
            judged: scene.motion.is_none() && scene.run.volume_dissipation == VolumeDissipation::Off,
            last_step: 0.0,
            workspaces: Workspaces::new(),
            scratch: Vec::new(),
            ends: Vec::new(),
        };
        if plan.runs(Pass::MomentumDissipation) == (scene.run.momentum_dissipation == InterfaceStates::Off) {
            simulation.run.momentum_dissipation = InterfaceStates::Off;
        }
        let nodes = scene.bodies.iter().map(|body| discretise(scene, body));
        let mut nodes = nodes.collect::<Result<Vec<_>, SolveError>>()?;
        let ties = Bonds::ties(scene, &mut nodes);
        for (index, particles) in nodes.into_iter().enumerate() {
            let Assembled { state, external } = assemble(scene, plan, index, particles)?;
            let projected = plan.runs(Pass::TorqueProjection);
            let projection = if projected { Projection::new(&state, &scene.symmetry) } else { None };
            simulation.projection.push(projection);
            simulation.impulses.push(Impulses::new(plan.runs(Pass::Impulse), &state, &external));
            simulation.bodies.push(state);
            simulation.external.push(external);
        }
        simulation.bonds = Bonds::new(scene, &mut simulation.bodies, ties)?;
        simulation.affine = affine_motions(scene, plan, &simulation.bodies);
        for index in 0..simulation.bodies.len() {
            let terms = simulation.force_terms(index);
            let weight = simulation.run.volume_wave_weight;
            let body = &mut simulation.bodies[index];
            body.rates = Rates::new(body, terms, weight);
        }
        // an initial state outside the energy's domain is told as that, not by the step it would ask for
        for body in &mut simulation.bodies {
            maps_and_stress(body, 0.0, &simulation.workspaces);
        }
        let found = diagnosis::failure(&simulation.bodies, &simulation.run, 0.0, 0.0);
        found.map_or(Ok(()), Err)?;
        simulation.refresh_stable_step()?;
        simulation.prepare_supports(simulation.pace.step());
        if simulation.damping > 0.0 {
            for (index, affine) in simulation.affine.iter().enumerate() {
                // the scene's own start velocities stand, and bonded bodies start as one
                if simulation.bodies.iter().any(|body| body.launch_speed > 0.0) {
                    continue;
                }
                affine.ends(&simulation.bodies, simulation.pace.step(), &mut simulation.ends);
                let body = &mut simulation.bodies[index];
                affine.start(&body.particles.position, &simulation.ends, &mut body.v);
            }
        }
        simulation.last_step = simulation.pace.step();
        simulation.impose(simulation.pace.step(), 0.0);
        simulation.meet_velocities();
        simulation.evaluate(0.0, 0.0)?;
        simulation.project_accelerations();
        simulation.rewind_supports();
        simulation.ledger = Ledger::new(simulation.energies());
        Ok(simulation)
    }

    /// Supports as over a first step, so that the initial velocities are the step's own.
    fn prepare_supports(&mut self, step: f64) {
        self.advance_supports(step);
    }

    fn rewind_supports(&mut self) {
        self.advance_supports(0.0);
    }
}
