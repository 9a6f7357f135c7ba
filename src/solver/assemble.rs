//! A plan and its scene made into a simulation.
//!
//! Owns set-up: nodes, pairs, compiled laws, supports, initial state. Runs once.

use super::admissible::{is_symmetric, starts_at_rest};
use super::body::{Block, BodyState, CHUNK, DirectionField};
use super::constraint::Support;
use super::dissipation::Speeds;
use super::error::SolveError;
use super::exact::{Exact, Target};
use super::hourglass::{Hourglass, Packet, stiffest};
use super::links::Links;
use super::loads::{ExternalForces, evaluate};
use super::pass::{Workspaces, gradients_of_positions};
use super::quad::{Columns, Quad};
use super::time_step::{Rates, elastic_length};
use crate::discretisation::{Consistency, Particles, Stencils};
use crate::energy::{Law, MotionState, WaveSpeeds};
use crate::plan::{Field, Pass, Plan};
use crate::scene::{Body, Integrator, InterfaceStates, Material, Scene};
use crate::tensor::{Mat3, Vec3, cofactor, volume_map};

/// A body with what acts on it.
#[derive(Debug)]
pub struct Assembled {
    /// Its state.
    pub state: BodyState,
    /// Its external forces.
    pub external: ExternalForces,
}

/// Assembles body number `index` of a scene from its nodes.
///
/// # Errors
/// If the body's stencils cannot be built or its material's energy cannot be compiled.
pub fn assemble(
    scene: &Scene,
    plan: &Plan,
    index: usize,
    mut particles: Particles,
) -> Result<Assembled, SolveError> {
    let body = &scene.bodies[index];
    let material = &scene.materials[body.material];
    if scene.run.consistency == Consistency::Quadratic {
        particles
            .integrate_quadratics()
            .map_err(|cause| SolveError::Discretisation { body: body.name.clone(), cause })?;
    }
    let law = compile(material)?;
    let stencils = Stencils::build(&particles, scene.run.kernel, scene.run.smoothing, scene.run.consistency)
        .map_err(|cause| SolveError::Discretisation { body: body.name.clone(), cause })?;
    let links = Links::new(&particles, &stencils);
    let count = particles.position.len();
    let mut scratch = Vec::new();
    let directions = directions(material, body, plan, &particles, &mut scratch)?;
    let rest = law
        .wave_speeds(&Mat3::identity(), directions.of(0), material.density)
        .map_err(|cause| SolveError::Energy { material: material.name.clone(), cause })?;
    let supports = supports(scene, plan, index, &particles, &mut scratch);
    let mut external = ExternalForces::new(&scene.loads, index, &particles, material.density);
    let saves = scene.run.integrator != Integrator::VelocityVerlet;
    let has_external = plan.carries(Field::ExternalForce);
    let exact = Exact::new(scene, index, material, &particles, &directions)?;
    let start = exact.as_ref().map(|exact| exact.states(&particles.position, 0.0));
    let velocity = match &start {
        Some(states) => states.iter().map(|state| Quad::new(&state.velocity)).collect(),
        None => initial_velocity(scene, index, &particles, &mut scratch),
    };
    let launch_speed = libm::sqrt(velocity.iter().map(|v| v.dot(*v)).fold(0.0, f64::max));
    let inverse_volume: Vec<f64> = particles.volume.iter().map(|volume| 1.0 / volume).collect();
    let hourglass = hourglass(scene, plan, material.density, &rest, &links, &inverse_volume);
    let rest = Speeds { pressure: rest.pressure, shear: rest.shear };
    let mut state = BodyState {
        hourglass,
        name: body.name.clone(),
        inverse_volume,
        links,
        density: material.density,
        law,
        directions,
        x: particles.position.iter().map(Quad::new).collect(),
        saved: if saves { (vec![Quad::ZERO; count], vec![Quad::ZERO; count]) } else { Default::default() },
        v: velocity,
        blocks: blocks(count, plan, saves),
        packets: vec![Packet::default(); count],
        stress: vec![Columns::ZERO; count],
        area_map: if plan.runs(Pass::VolumeDissipation) { vec![Columns::ZERO; count] } else { Vec::new() },
        hourglass_rate: 0.0,
        acceleration: vec![Quad::ZERO; count],
        external: if has_external { vec![Quad::ZERO; count] } else { Vec::new() },
        exact,
        supports,
        elastic_length: elastic_length(&stencils, &particles.volume, particles.spacing),
        rates: Rates::default(),
        launch_speed,
        rest,
        fastest: (rest.pressure, 0),
        particles,
    };
    state.hourglass_rate = stiffest(&state);
    if let Some(start) = &start {
        deform(&mut state, start);
    }
    if has_external {
        external.evaluate(&state.particles, 0.0, &mut state.external, &mut scratch);
        let BodyState { exact, law, particles, external, .. } = &mut state;
        if let Some(exact) = exact {
            let target = Target { law, reference: &particles.position, external };
            exact.add_forces(target, 0.0, &Workspaces::new());
        }
    }
    starts_at_rest(scene, index, &state)?;
    is_symmetric(scene, &state)?;
    // a face's normal is symmetric by itself; its quadrilaterals' only as the spacing vanishes
    if external.follows() {
        let BodyState { particles, x, inverse_volume, external: out, .. } = &mut state;
        external.add_followers((&particles.position, x), inverse_volume, 0.0, out, &mut scratch);
    }
    Ok(Assembled { state, external })
}

/// Springs and dashpots against what no gradient sees, as far as the plan has them.
fn hourglass(
    scene: &Scene,
    plan: &Plan,
    density: f64,
    rest: &WaveSpeeds,
    links: &Links,
    inverse_volume: &[f64],
) -> Option<Hourglass> {
    let run = &scene.run;
    let sprung = plan.runs(Pass::Hourglass);
    let damped =
        plan.runs(Pass::MomentumDissipation) && run.momentum_dissipation == InterfaceStates::Variational;
    let modulus = if sprung { run.hourglass_stiffness * density * matrix_speed(rest).powi(2) } else { 0.0 };
    let weight = if damped { density } else { 0.0 };
    let impedance = Speeds {
        pressure: weight * run.pressure_wave_weight * rest.pressure,
        shear: weight * run.shear_wave_weight * rest.shear,
    };
    (sprung || damped).then(|| Hourglass::new(links, inverse_volume, modulus, impedance))
}

/// Speed whose modulus the springs are measured in, m/s: shear of the matrix with slack fibres.
///
/// Taut fibres carry a strip and its springs would carry the rest of it: at a hundred times the matrix' modulus, as
/// aligned fibres of an artery have, they cost 2.5 % of its length. A law that has no stiffness of its own at
/// rest against some shear is measured by the fastest shear it has.
fn matrix_speed(rest: &WaveSpeeds) -> f64 {
    if rest.matrix > SLACK * rest.pressure { rest.matrix } else { rest.shear }
}

/// Share of the pressure wave speed below which a matrix counts as having no stiffness: round-off of its tangent.
const SLACK: f64 = 1e-7;

/// Positions of a motion and their maps: `F = Grad_h x`, `H = cof F`, `J = det F`.
///
/// The discrete gradient and not the motion's own, so that F is the gradient of the positions from
/// the first step on.
fn deform(state: &mut BodyState, start: &[MotionState]) {
    for (x, start) in state.x.iter_mut().zip(start) {
        *x = Quad::new(&start.position);
    }
    gradients_of_positions(state);
    for Block { f, h, j, .. } in &mut state.blocks {
        for (h, f) in h.iter_mut().zip(&*f) {
            *h = cofactor(f);
        }
        for (j, f) in j.iter_mut().zip(&*f) {
            *j = volume_map(f, &cofactor(f));
        }
    }
}

/// Nodes of the modelled part of a body.
///
/// # Errors
/// If its shape cannot be filled at its spacing.
pub fn discretise(scene: &Scene, body: &Body) -> Result<Particles, SolveError> {
    let planes = [0, 1, 2].map(|axis| scene.symmetry[axis].as_ref().map(|plane| plane.at));
    Particles::lattice(&body.shape, body.spacing, planes, body.jitter)
        .map_err(|cause| SolveError::Discretisation { body: body.name.clone(), cause })
}

/// The compiled law of a material.
///
/// # Errors
/// If the energy cannot be differentiated.
pub fn compile(material: &Material) -> Result<Law, SolveError> {
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    Law::compile(&material.energy, &values)
        .map_err(|cause| SolveError::Energy { material: material.name.clone(), cause })
}

fn blocks(count: usize, plan: &Plan, saves: bool) -> Vec<Block> {
    (0..count)
        .step_by(CHUNK)
        .map(|start| {
            let len = CHUNK.min(count - start);
            let mut block = Block { start, f: vec![Mat3::identity(); len], ..Block::default() };
            if plan.carries(Field::AreaMap) {
                block.h = vec![Mat3::identity(); len];
            }
            if plan.carries(Field::VolumeMap) {
                block.j = vec![1.0; len];
            }
            if plan.runs(Pass::VolumeDissipation) {
                block.volume_dissipation = vec![0.0; len];
            }
            if saves {
                block.saved = (block.f.clone(), block.h.clone(), block.j.clone());
            }
            block
        })
        .collect()
}

/// Directions of a material at the particles of a body.
fn directions(
    material: &Material,
    body: &Body,
    plan: &Plan,
    particles: &Particles,
    scratch: &mut Vec<f64>,
) -> Result<DirectionField, SolveError> {
    if !plan.carries(Field::FibreDirection) {
        return Ok(DirectionField::Uniform(Vec::new()));
    }
    let mut at = |position: &Vec3, out: &mut Vec<Vec3>| {
        for direction in &material.directions {
            let [x, y, z] = direction.components.each_ref().map(|c| evaluate(c, position, 0.0, scratch));
            let value = Vec3::new(x, y, z);
            let length = value.norm();
            if !length.is_finite() || (length - 1.0).abs() > UNIT_LENGTH {
                return Err(SolveError::DirectionNotUnit {
                    material: material.name.clone(),
                    direction: direction.name.clone(),
                    body: body.name.clone(),
                    position: *position,
                    length,
                });
            }
            out.push(value);
        }
        Ok(())
    };
    let mut values = Vec::new();
    if plan.carries(Field::FibreDirectionField) {
        particles.position.iter().try_for_each(|position| at(position, &mut values))?;
        Ok(DirectionField::Varying { count: material.directions.len(), values })
    } else {
        at(&Vec3::zeros(), &mut values)?;
        Ok(DirectionField::Uniform(values))
    }
}

/// How far the length of a direction may be from 1: six digits, as a direction is typically written.
const UNIT_LENGTH: f64 = 1e-6;

fn supports(
    scene: &Scene,
    plan: &Plan,
    index: usize,
    particles: &Particles,
    scratch: &mut Vec<f64>,
) -> Vec<Support> {
    let mut supports = Vec::new();
    if !plan.runs(Pass::PrescribedMotion) {
        return supports;
    }
    let mut add = |face: &str, axis, displacement| {
        if let Some(found) = particles.face(face) {
            let (name, nodes) = (face.to_string(), found.nodes.clone());
            supports.push(Support::new(name, axis, nodes, displacement, &particles.position, scratch));
        }
    };
    for axis in 0..3 {
        if scene.symmetry[axis].is_some() {
            add(["symmetry_x", "symmetry_y", "symmetry_z"][axis], axis, None);
        }
    }
    for prescribed in scene.prescribed.iter().filter(|prescribed| prescribed.region.body == index) {
        for (axis, displacement) in prescribed.displacement.iter().enumerate() {
            if let Some(tape) = displacement {
                add(&prescribed.region.face, axis, Some(tape.clone()));
            }
        }
    }
    supports
}

fn initial_velocity(scene: &Scene, index: usize, particles: &Particles, scratch: &mut Vec<f64>) -> Vec<Quad> {
    let mut velocity = vec![Quad::ZERO; particles.position.len()];
    for start in scene.starts.iter().filter(|start| start.body == index) {
        for (v, position) in velocity.iter_mut().zip(&particles.position) {
            for (axis, tape) in start.velocity.iter().enumerate() {
                v.0[axis] += evaluate(tape, position, 0.0, scratch);
            }
        }
    }
    velocity
}
