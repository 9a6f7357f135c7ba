//! The affine motion that the supports of a body imply on average, and damping relative to it.
//!
//! Owns quasi-static loading: explicit steps need a motion to start from and to relax towards, and
//! the affine one is the equilibrium motion of a homogeneous body far from its grips.

use super::body::{BodyState, CHUNK};
use super::bond::Bonds;
use super::quad::Quad;
use crate::discretisation::Particles;
use crate::plan::{Pass, Plan};
use crate::scene::Scene;
use crate::tensor::Vec3;
use rayon::prelude::*;

/// One affine term: a velocity component linear between two opposite faces.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Term {
    /// Component of the velocity.
    component: usize,
    /// Axis along which it varies.
    axis: usize,
    /// Coordinates of the two faces, m.
    between: (f64, f64),
    /// Body and index of the supports of the two faces.
    supports: [(usize, usize); 2],
}

/// The affine velocity field of a body, or of all bodies bonded to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AffineMotion {
    terms: Vec<Term>,
}

/// Share of the extent within which a face is an outermost one.
const OUTERMOST: f64 = 1e-9;

/// The affine motion of each body of a scene; none unless loading is quasi-static.
pub fn affine_motions(scene: &Scene, plan: &Plan, bodies: &[BodyState]) -> Vec<AffineMotion> {
    if !plan.runs(Pass::AffineDamping) {
        return vec![AffineMotion::default(); bodies.len()];
    }
    let group = Bonds::groups(scene);
    let motion = |own: usize| {
        let members = (0..bodies.len()).filter(|&body| group[body] == group[own]).collect::<Vec<_>>();
        AffineMotion::new(bodies, &members)
    };
    (0..bodies.len()).map(motion).collect()
}

impl AffineMotion {
    /// Finds the components prescribed on both of two opposite outermost faces or planes of symmetry.
    fn new(bodies: &[BodyState], members: &[usize]) -> Self {
        let positions = members.iter().flat_map(|&body| &bodies[body].particles.position);
        let start = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
        let bounds = positions.fold(start, |(low, high), x| (low.inf(x), high.sup(x)));
        let find = |names: [String; 2], axis: usize, component: usize, at: f64| {
            let outermost = |body: usize, node: u32| {
                let x = bodies[body].particles.position[node as usize][axis];
                (x - at).abs() <= OUTERMOST * (bounds.1[axis] - bounds.0[axis])
            };
            members.iter().find_map(|&body| {
                let fits = bodies[body].supports.iter().position(|s| {
                    let first = s.nodes.first().is_some_and(|&node| outermost(body, node));
                    s.axis == component && names.contains(&s.face) && first
                });
                fits.map(|support| (body, support))
            })
        };
        let mut terms = Vec::new();
        for axis in 0..3 {
            let letter = ["x", "y", "z"][axis];
            let between = (bounds.0[axis], bounds.1[axis]);
            for component in 0..3 {
                let low =
                    find([format!("{letter}min"), format!("symmetry_{letter}")], axis, component, between.0);
                let high = find([format!("{letter}max"), format!("{letter}max")], axis, component, between.1);
                if let (Some(low), Some(high)) = (low, high) {
                    terms.push(Term { component, axis, between, supports: [low, high] });
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
    pub fn ends(&self, bodies: &[BodyState], step: f64, ends: &mut Vec<(f64, f64)>) {
        ends.clear();
        ends.extend(self.terms.iter().map(|term| {
            let [low, high] = term.supports.map(|(body, s)| bodies[body].supports[s].velocity(0, step));
            (low, high)
        }));
    }

    /// Sets velocities to the affine field of these velocities of its faces.
    pub fn start(&self, reference: &[Vec3], ends: &[(f64, f64)], velocity: &mut [Quad]) {
        for (v, reference) in velocity.iter_mut().zip(reference) {
            *v = self.velocity(reference, ends);
        }
    }

    /// Power of the damping, `Σ m η (v_affine − v) · v`, W; arguments as [`AffineMotion::damp`].
    pub fn power(
        &self,
        rate: f64,
        particles: &Particles,
        density: f64,
        ends: &[(f64, f64)],
        velocity: &[Quad],
    ) -> f64 {
        let each = particles.position.iter().zip(&particles.volume).zip(velocity);
        each.map(|((x, volume), v)| density * volume * rate * (self.velocity(x, ends) - *v).dot(*v)).sum()
    }

    /// Adds the damping `−η (v − v_affine)` to the accelerations.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `rate` | `η` | 1/s |
    /// | `reference` | reference positions | m |
    /// | `ends` | velocities of the faces over the step under way | m/s |
    /// | `velocity` | velocities | m/s |
    /// | `acceleration` | added to | m/s² |
    pub fn damp(
        &self,
        rate: f64,
        reference: &[Vec3],
        ends: &[(f64, f64)],
        velocity: &[Quad],
        acceleration: &mut [Quad],
    ) {
        acceleration.par_chunks_mut(CHUNK).enumerate().for_each(|(index, chunk)| {
            for (i, out) in chunk.iter_mut().enumerate() {
                let a = index * CHUNK + i;
                *out += (self.velocity(&reference[a], ends) - velocity[a]) * rate;
            }
        });
    }
}
