//! A body that is to follow an exact motion.
//!
//! Owns the initial state, the body force, the tractions and the boundary velocities of the motion at
//! the particles of one body, with the memory they are computed in. Knows no clock.

use super::body::{CHUNK, DirectionField};
use super::error::SolveError;
use super::loads::evaluate;
use super::pass::Workspaces;
use super::quad::Quad;
use crate::discretisation::Particles;
use crate::energy::{ExactMotion, Law, Maps, MotionSource, MotionState, Scratch};
use crate::expression::Tape;
use crate::scene::{Coordinate, Material, Scene};
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;

/// The exact motion of a body.
#[derive(Debug)]
pub struct Exact {
    motion: ExactMotion,
    /// Components of `x(X, t)` as written, m.
    pub position: [Tape<Coordinate>; 3],
    directions: Vec<[Tape<Coordinate>; 3]>,
    body_force: bool,
    loaded: Loaded,
    moved: Moved,
}

/// Particles of the faces that carry the exact traction.
#[derive(Debug, Default)]
struct Loaded {
    nodes: Vec<u32>,
    reference: Vec<Vec3>,
    /// `A_a N_a / V_a`, 1/m.
    area: Vec<Vec3>,
    directions: Option<DirectionField>,
    states: Vec<MotionState>,
    gradient: Vec<Mat3>,
    stress: Vec<Mat3>,
    scratch: Scratch,
}

/// Particles of the faces that are moved, with the components that are.
#[derive(Debug, Default)]
struct Moved {
    nodes: Vec<(u32, [bool; 3])>,
    reference: Vec<Vec3>,
    states: Vec<MotionState>,
    scratch: Scratch,
}

/// What the forces of a motion are added to.
pub struct Target<'a> {
    /// The law of the body.
    pub law: &'a Law,
    /// Its reference positions, m.
    pub reference: &'a [Vec3],
    /// Force per reference volume, N/m³.
    pub external: &'a mut [Quad],
}

impl Exact {
    /// Traces the motion of a scene for one of its bodies; `None` where the scene has none.
    ///
    /// # Errors
    /// If the energy is one of principal stretches.
    pub fn new(
        scene: &Scene,
        index: usize,
        material: &Material,
        particles: &Particles,
        directions: &DirectionField,
    ) -> Result<Option<Self>, SolveError> {
        let Some(declared) = &scene.motion else { return Ok(None) };
        let parameters: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
        let formulas: Vec<[Tape<Coordinate>; 3]> =
            material.directions.iter().map(|direction| direction.components.clone()).collect();
        let source = MotionSource {
            position: &declared.position,
            energy: &material.energy,
            parameters: &parameters,
            directions: &formulas,
            density: material.density,
            input: |leaf| match leaf {
                Coordinate::X(axis) => usize::from(*axis),
                Coordinate::Time => 3,
            },
        };
        let motion = ExactMotion::compile(&source)
            .map_err(|cause| SolveError::Energy { material: material.name.clone(), cause })?;
        let mut exact = Self {
            motion,
            position: declared.position.clone(),
            directions: formulas,
            body_force: declared.body_force,
            loaded: Loaded::default(),
            moved: Moved::default(),
        };
        for region in declared.loaded.iter().filter(|region| region.body == index) {
            let Some(face) = particles.face(&region.face) else { continue };
            for (&node, area) in face.nodes.iter().zip(&face.area) {
                exact.loaded.add(node, area / particles.volume[node as usize], particles);
            }
        }
        exact.loaded.prepare(directions);
        for prescribed in scene.prescribed.iter().filter(|p| p.word == WORD && p.region.body == index) {
            let Some(face) = particles.face(&prescribed.region.face) else { continue };
            let components = prescribed.displacement.each_ref().map(Option::is_some);
            for &node in &face.nodes {
                exact.moved.add(node, components, particles);
            }
        }
        exact.moved.states = vec![MotionState::default(); exact.moved.nodes.len()];
        Ok(Some(exact))
    }

    /// Position, velocity and deformation gradient of the motion at reference positions.
    pub fn states(&self, reference: &[Vec3], time: f64) -> Vec<MotionState> {
        let mut states = vec![MotionState::default(); reference.len()];
        self.motion.states(reference, time, &mut states, &mut Scratch::default());
        states
    }

    /// The body force of the motion at one reference position, N/m³.
    pub fn body_force(&self, reference: &Vec3, time: f64) -> Vec3 {
        let mut force = [Vec3::zeros()];
        if self.body_force {
            self.motion.body_forces(&[*reference], time, &mut force, &mut Scratch::default());
        }
        force[0]
    }

    /// The material's directions at a reference position.
    pub fn directions(&self, at: &Vec3) -> Vec<Vec3> {
        let mut scratch = Vec::new();
        let mut component = |tape: &Tape<Coordinate>| evaluate(tape, at, 0.0, &mut scratch);
        self.directions.iter().map(|direction| direction.each_ref().map(&mut component).into()).collect()
    }

    /// Operations a particle's body force costs.
    pub fn operations(&self) -> usize {
        if self.body_force { self.motion.operations() } else { 0 }
    }

    /// Adds body force and tractions at a time.
    ///
    /// ```text
    /// E_a = P(F(X_a, t)) A_a N_a / V_a + f0(X_a, t)    [NB25 (31)]
    /// ```
    ///
    /// Allocates nothing after the first call.
    pub fn add_forces(&mut self, target: Target<'_>, time: f64, workspaces: &Workspaces) {
        let Target { law, reference, external } = target;
        if self.body_force {
            let motion = &self.motion;
            let chunks = external.par_chunks_mut(CHUNK).zip(reference.par_chunks(CHUNK));
            chunks.for_each(|(external, reference)| {
                let workspace = &mut *workspaces.get();
                workspace.vectors.resize(CHUNK, Vec3::zeros());
                let forces = &mut workspace.vectors[..reference.len()];
                motion.body_forces(reference, time, forces, &mut workspace.energy);
                for (external, force) in external.iter_mut().zip(forces) {
                    *external += Quad::new(force);
                }
            });
        }
        self.loaded.add_tractions(&self.motion, law, external, time);
    }

    /// Gives the moved particles the velocity the motion has at a time; over a step they have its mean.
    pub fn meet_velocities(&mut self, velocity: &mut [Quad], time: f64) {
        let Moved { nodes, reference, states, scratch } = &mut self.moved;
        self.motion.states(reference, time, states, scratch);
        for (&(node, components), state) in nodes.iter().zip(states) {
            for axis in (0..3).filter(|&axis| components[axis]) {
                velocity[node as usize].0[axis] = state.velocity[axis];
            }
        }
    }
}

/// The word of a scene that prescribes what a motion moves.
pub const WORD: &str = "motion";

impl Loaded {
    fn add(&mut self, node: u32, area: Vec3, particles: &Particles) {
        match self.nodes.iter().position(|&known| known == node) {
            Some(place) => self.area[place] += area,
            None => {
                self.nodes.push(node);
                self.reference.push(particles.position[node as usize]);
                self.area.push(area);
            }
        }
    }

    fn prepare(&mut self, directions: &DirectionField) {
        let count = self.nodes.len();
        self.states = vec![MotionState::default(); count];
        self.gradient = vec![Mat3::identity(); count];
        self.stress = vec![Mat3::zeros(); count];
        self.directions = Some(match directions {
            DirectionField::Uniform(_) => directions.clone(),
            DirectionField::Varying { count, .. } => DirectionField::Varying {
                count: *count,
                values: self.nodes.iter().flat_map(|&node| directions.of(node as usize)).copied().collect(),
            },
        });
    }

    fn add_tractions(&mut self, motion: &ExactMotion, law: &Law, external: &mut [Quad], time: f64) {
        let Some(directions) = self.directions.as_ref().filter(|_| !self.nodes.is_empty()) else { return };
        motion.states(&self.reference, time, &mut self.states, &mut self.scratch);
        for (gradient, state) in self.gradient.iter_mut().zip(&self.states) {
            *gradient = state.gradient;
        }
        let maps = Maps { f: &self.gradient, h: None, j: None };
        law.stress(maps, directions.slice(0, self.nodes.len()), &mut self.stress, &mut self.scratch);
        for ((&node, area), stress) in self.nodes.iter().zip(&self.area).zip(&self.stress) {
            external[node as usize] += Quad::new(&(stress * area));
        }
    }
}

impl Moved {
    fn add(&mut self, node: u32, components: [bool; 3], particles: &Particles) {
        match self.nodes.iter_mut().find(|(known, _)| *known == node) {
            Some((_, known)) => {
                for (known, component) in known.iter_mut().zip(components) {
                    *known |= component;
                }
            }
            None => {
                self.nodes.push((node, components));
                self.reference.push(particles.position[node as usize]);
            }
        }
    }
}
