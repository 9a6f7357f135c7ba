//! The affine motion that the supports of a body imply on average, and damping relative to it.
//!
//! Owns quasi-static loading: explicit steps need a motion to start from and to relax towards, and
//! the affine one is the equilibrium motion of a homogeneous body far from its grips.

use super::constraint::Support;
use super::quad::Quad;
use crate::tensor::Vec3;
use rayon::prelude::*;

use super::body::CHUNK;

/// One affine term: a velocity component linear between two opposite faces.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Term {
    /// Component of the velocity.
    component: usize,
    /// Axis along which it varies.
    axis: usize,
    /// Coordinates of the two faces, m.
    between: (f64, f64),
    /// Indices of the supports of the two faces.
    supports: (usize, usize),
}

/// The affine velocity field of a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AffineMotion {
    terms: Vec<Term>,
}

impl AffineMotion {
    /// Finds the components prescribed on both of two opposite faces or planes of symmetry.
    ///
    /// `bounds` are the least and greatest reference coordinates of the body's particles.
    pub fn new(supports: &[Support], bounds: (Vec3, Vec3)) -> Self {
        let find = |names: [String; 2], component: usize| {
            supports.iter().position(|s| s.axis == component && names.contains(&s.face))
        };
        let mut terms = Vec::new();
        for axis in 0..3 {
            let letter = ["x", "y", "z"][axis];
            for component in 0..3 {
                let low = find([format!("{letter}min"), format!("symmetry_{letter}")], component);
                let high = find([format!("{letter}max"), format!("{letter}max")], component);
                if let (Some(low), Some(high)) = (low, high) {
                    let between = (bounds.0[axis], bounds.1[axis]);
                    terms.push(Term { component, axis, between, supports: (low, high) });
                }
            }
        }
        Self { terms }
    }

    /// Velocity at a reference position over a step, m/s.
    fn velocity(&self, reference: &Vec3, ends: &[(f64, f64)]) -> Quad {
        let mut velocity = Quad::ZERO;
        for (term, &(low, high)) in self.terms.iter().zip(ends) {
            let (from, to) = term.between;
            let share = (reference[term.axis] - from) / (to - from);
            velocity.0[term.component] += low + (high - low) * share;
        }
        velocity
    }

    /// Velocities of the faces of each term over a step of length `step`, into `ends`.
    fn ends(&self, supports: &[Support], step: f64, ends: &mut Vec<(f64, f64)>) {
        ends.clear();
        ends.extend(self.terms.iter().map(|term| {
            let (low, high) = term.supports;
            (supports[low].velocity(0, step), supports[high].velocity(0, step))
        }));
    }

    /// Sets velocities to the affine field.
    pub fn start(&self, reference: &[Vec3], supports: &[Support], step: f64, velocity: &mut [Quad]) {
        let mut ends = Vec::with_capacity(self.terms.len());
        self.ends(supports, step, &mut ends);
        for (v, reference) in velocity.iter_mut().zip(reference) {
            *v = self.velocity(reference, &ends);
        }
    }

    /// Adds the damping `−η (v − v_affine)` to the accelerations.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `rate` | `η` | 1/s |
    /// | `reference` | reference positions | m |
    /// | `supports`, `step` | what moves the faces, and the step under way | s |
    /// | `velocity` | velocities | m/s |
    /// | `acceleration` | added to | m/s² |
    /// | `ends` | scratch, kept between calls | |
    #[expect(clippy::too_many_arguments, reason = "a pass takes the arrays it reads and writes")]
    pub fn damp(
        &self,
        rate: f64,
        reference: &[Vec3],
        supports: &[Support],
        step: f64,
        velocity: &[Quad],
        acceleration: &mut [Quad],
        ends: &mut Vec<(f64, f64)>,
    ) {
        self.ends(supports, step, ends);
        let ends = &*ends;
        acceleration.par_chunks_mut(CHUNK).enumerate().for_each(|(index, chunk)| {
            for (i, out) in chunk.iter_mut().enumerate() {
                let a = index * CHUNK + i;
                *out += (self.velocity(&reference[a], ends) - velocity[a]) * rate;
            }
        });
    }
}
