//! Prescribed motion: grips, supports and planes of symmetry.
//!
//! Owns which components of which particles are given, and their velocity over a step. Knows
//! nothing of what the particles are made of.

use super::loads::evaluate;
use super::quad::Quad;
use crate::expression::Tape;
use crate::scene::Coordinate;
use crate::tensor::Vec3;

/// A prescribed displacement component of a set of particles.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// Body and face it stands for; the key reactions are asked by. A plane of symmetry has a face too.
    pub face: String,
    /// Component prescribed.
    pub axis: usize,
    /// Particles of the body, ascending.
    pub nodes: Vec<u32>,
    /// The displacement, m; `None` is zero at all times.
    pub displacement: Option<Tape<Coordinate>>,
    /// Whether the displacement depends on the place.
    varies: bool,
    /// Displacement at the end of the step before, one number a node if it varies, m.
    last: Vec<f64>,
    /// Displacement at the end of the step under way.
    next: Vec<f64>,
}

impl Support {
    /// A support starting from the displacement its tape has at time zero.
    pub fn new(
        face: String,
        axis: usize,
        nodes: Vec<u32>,
        displacement: Option<Tape<Coordinate>>,
        reference: &[Vec3],
        scratch: &mut Vec<f64>,
    ) -> Self {
        let varies = displacement
            .as_ref()
            .is_some_and(|tape| tape.leaves().any(|leaf| matches!(leaf, Coordinate::X(_))));
        let count = match (&displacement, varies) {
            (None, _) => 0,
            (_, true) => nodes.len(),
            (_, false) => 1,
        };
        let (last, next) = (vec![0.0; count], vec![0.0; count]);
        let mut support = Self { face, axis, nodes, displacement, varies, last, next };
        support.evaluate(0.0, reference, scratch);
        support.last.clone_from(&support.next);
        support
    }

    /// Moves on to the displacement at the end of the next step.
    pub fn advance(&mut self, time: f64, reference: &[Vec3], scratch: &mut Vec<f64>) {
        std::mem::swap(&mut self.last, &mut self.next);
        self.evaluate(time, reference, scratch);
    }

    fn evaluate(&mut self, time: f64, reference: &[Vec3], scratch: &mut Vec<f64>) {
        let Some(tape) = &self.displacement else { return };
        for (value, &node) in self.next.iter_mut().zip(&self.nodes) {
            *value = evaluate(tape, &reference[node as usize], time, scratch);
        }
    }

    /// Imposes the velocity that carries the particles over a step of length `step`, exactly.
    pub fn impose(&self, velocity: &mut [Quad], step: f64) {
        for (i, &node) in self.nodes.iter().enumerate() {
            velocity[node as usize].0[self.axis] = self.velocity(i, step);
        }
    }

    /// Velocity of the `i`-th node over the step under way, m/s.
    pub fn velocity(&self, i: usize, step: f64) -> f64 {
        match (&self.displacement, self.varies) {
            (None, _) => 0.0,
            (_, true) => (self.next[i] - self.last[i]) / step,
            (_, false) => (self.next[0] - self.last[0]) / step,
        }
    }
}
