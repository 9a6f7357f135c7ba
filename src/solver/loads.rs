//! Tractions and body forces.
//!
//! Owns the external force per reference volume of every particle.

use super::quad::Quad;
use crate::discretisation::Particles;
use crate::expression::Tape;
use crate::scene::{Coordinate, Load};
use crate::tensor::Vec3;

/// External forces of one body.
#[derive(Debug, Clone, Default)]
pub struct ExternalForces {
    terms: Vec<Term>,
    /// Whether any force depends on time.
    pub varies_in_time: bool,
}

/// A load and the nodes it acts on, with the weight that makes it a force per volume.
#[derive(Debug, Clone)]
struct Term {
    components: [Tape<Coordinate>; 3],
    /// Node and weight: `A_a/V_a` of a traction (1/m), 1 of a body force.
    nodes: Vec<(u32, f64)>,
}

impl ExternalForces {
    /// Collects the loads that act on body number `body`.
    pub fn new(loads: &[Load], body: usize, particles: &Particles, density: f64) -> Self {
        let everywhere = || (0..particles.position.len() as u32).map(|a| (a, 1.0)).collect();
        let mut terms = Vec::new();
        for load in loads {
            match load {
                Load::Traction { region, traction, .. } if region.body == body => {
                    let Some(face) = particles.face(&region.face) else { continue };
                    let weight = |(&a, area): (&u32, &Vec3)| (a, area.norm() / particles.volume[a as usize]);
                    let nodes = face.nodes.iter().zip(&face.area).map(weight).collect();
                    terms.push(Term { components: traction.clone(), nodes });
                }
                Load::BodyForce { body: on, force, .. } if *on == body => {
                    terms.push(Term { components: force.clone(), nodes: everywhere() });
                }
                Load::Gravity { acceleration, .. } => {
                    let components = acceleration.map(|g| Tape::constant(density * g));
                    terms.push(Term { components, nodes: everywhere() });
                }
                _ => {}
            }
        }
        let varies_in_time = terms.iter().any(|term| {
            term.components.iter().any(|tape| tape.leaves().any(|leaf| matches!(leaf, Coordinate::Time)))
        });
        Self { terms, varies_in_time }
    }

    /// Force per reference volume at a time.
    ///
    /// ```text
    /// E_a = (A_a/V_a) t_B + f0_a                       [NB25 (31)]
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `reference` | reference positions | m |
    /// | `time` | | s |
    /// | `out` | overwritten | N/m³ |
    /// | `scratch` | kept between calls | |
    pub fn evaluate(&self, reference: &[Vec3], time: f64, out: &mut [Quad], scratch: &mut Vec<f64>) {
        out.fill(Quad::ZERO);
        for term in &self.terms {
            for &(node, weight) in &term.nodes {
                let at = &reference[node as usize];
                for (axis, tape) in term.components.iter().enumerate() {
                    let value = evaluate(tape, at, time, scratch);
                    out[node as usize].0[axis] += weight * value;
                }
            }
        }
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
