//! Tractions, body forces, and the pressures that follow a face.
//!
//! Owns the external force per reference volume of every particle.

use super::follower::Follower;
use super::quad::Quad;
use crate::discretisation::Particles;
use crate::expression::Tape;
use crate::scene::{Coordinate, Load};
use crate::tensor::Vec3;

/// External forces of one body.
#[derive(Debug, Clone, Default)]
pub struct ExternalForces {
    terms: Vec<Term>,
    followers: Vec<Follower>,
    /// Whether any force depends on time, or on positions that do.
    pub varies_in_time: bool,
}

/// A load and the nodes it acts on, with the weight that makes it a force per volume.
#[derive(Debug, Clone)]
struct Term {
    components: [Tape<Coordinate>; 3],
    /// Node and weight: `A_a/V_a` of a traction (1/m), 1 of a body force.
    nodes: Vec<(u32, f64)>,
    /// The face of a traction.
    face: Option<String>,
    /// Force on the body at the last evaluation, N.
    total: Vec3,
}

impl ExternalForces {
    /// Collects the loads that act on body number `body`.
    pub fn new(loads: &[Load], body: usize, particles: &Particles, density: f64) -> Self {
        let everywhere = || (0..particles.position.len() as u32).map(|a| (a, 1.0)).collect();
        let mut terms = Vec::new();
        let mut followers = Vec::new();
        for load in loads {
            match load {
                Load::Traction { region, traction, .. } if region.body == body => {
                    let Some(face) = particles.face(&region.face) else { continue };
                    let weight = |(&a, size): (&u32, f64)| (a, size / particles.volume[a as usize]);
                    let nodes = face.nodes.iter().zip(particles.sizes(face)).map(weight).collect();
                    let (components, face) = (traction.clone(), Some(region.face.clone()));
                    terms.push(Term { components, nodes, face, total: Vec3::zeros() });
                }
                Load::Pressure { region, pressure, .. } if region.body == body => {
                    followers.extend(particles.face(&region.face).map(|face| Follower::new(face, pressure)));
                }
                Load::BodyForce { body: on, force, .. } if *on == body => {
                    let (components, nodes) = (force.clone(), everywhere());
                    terms.push(Term { components, nodes, face: None, total: Vec3::zeros() });
                }
                Load::Gravity { acceleration, .. } => {
                    let components = acceleration.map(|g| Tape::constant(density * g));
                    terms.push(Term { components, nodes: everywhere(), face: None, total: Vec3::zeros() });
                }
                _ => {}
            }
        }
        let timed = terms.iter().any(|term: &Term| {
            term.components.iter().any(|tape| tape.leaves().any(|leaf| matches!(leaf, Coordinate::Time)))
        });
        let varies_in_time = timed || !followers.is_empty();
        Self { terms, followers, varies_in_time }
    }

    /// Whether any force depends on the current positions.
    pub fn follows(&self) -> bool {
        !self.followers.is_empty()
    }

    /// Adds the forces of pressures on the deformed faces, see [`Follower::add`].
    pub fn add_followers(
        &mut self,
        positions: (&[Vec3], &[Quad]),
        inverse_volume: &[f64],
        time: f64,
        out: &mut [Quad],
        scratch: &mut Vec<f64>,
    ) {
        for follower in &mut self.followers {
            follower.add(positions, inverse_volume, time, out, scratch);
        }
    }

    /// Force per reference volume at a time, of everything but pressures.
    ///
    /// ```text
    /// E_a = (A_a/V_a) t_B + f0_a                       [NB25 (31)]
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `particles` | reference positions and volumes | m, m³ |
    /// | `time` | | s |
    /// | `out` | overwritten | N/m³ |
    /// | `scratch` | kept between calls | |
    pub fn evaluate(&mut self, particles: &Particles, time: f64, out: &mut [Quad], scratch: &mut Vec<f64>) {
        out.fill(Quad::ZERO);
        for term in &mut self.terms {
            term.total = Vec3::zeros();
            for &(node, weight) in &term.nodes {
                let at = &particles.position[node as usize];
                for (axis, tape) in term.components.iter().enumerate() {
                    let value = evaluate(tape, at, time, scratch);
                    out[node as usize].0[axis] += weight * value;
                    term.total[axis] += particles.volume[node as usize] * weight * value;
                }
            }
        }
    }

    /// The face of each load, `None` of one that acts on the whole body, and its force at the last
    /// evaluation, N.
    pub fn totals(&self) -> impl Iterator<Item = (Option<&str>, Vec3)> {
        let terms = self.terms.iter().map(|term| (term.face.as_deref(), term.total));
        terms.chain(self.followers.iter().map(|follower| (Some(follower.face.as_str()), follower.total)))
    }
}

/// A field written as text at a reference position and a time.
pub fn evaluate(tape: &Tape<Coordinate>, at: &Vec3, time: f64, scratch: &mut Vec<f64>) -> f64 {
    tape.evaluate(
        |leaf| match leaf {
            Coordinate::X(axis) => at[*axis as usize],
            Coordinate::Time => time,
        },
        scratch,
    )
}
