//! Exact angular momentum of bodies that nothing holds.
//!
//! Owns the least correction of the accelerations that gives the internal forces no torque. Knows no
//! stage; the integrator says where the torque is to vanish.

use super::body::{BodyState, CHUNK};
use super::quad::Quad;
use crate::scene::SymmetryPlane;
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;

/// The correction of one body.
///
/// ```text
/// min ½ Σ m_a |δ_a|²   with   Σ m_a δ_a = 0   and   Σ m_a y_a × (a_a + δ_a) = τ
/// δ_a = λ × (y_a − ȳ),   I λ = τ − Σ m_a (y_a − ȳ) × a_a,   I = Σ m_a (|r_a|² 1 − r_a ⊗ r_a),  r_a = y_a − ȳ
/// ```
///
/// The multiplier of the linear momentum is spent on `ȳ`, the mass centre of the points `y`. A plane of
/// symmetry leaves one component, that along its normal.
#[derive(Debug, Clone)]
pub struct Projection {
    /// The only component that is not zero by symmetry.
    only: Option<usize>,
    /// Point the moments of a step are taken about, m.
    pivot: Vec3,
    /// Angular momentum at the start of the step and what the loads have added since, kg m²/s.
    target: Vec3,
    /// One entry a chunk.
    partial: Vec<Moments>,
}

/// Sums over the particles of a body or of a chunk, about the pivot.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    mass: f64,
    first: Vec3,
    /// `Σ m r ⊗ r`.
    second: Mat3,
    /// `Σ m r × a` of what is to be corrected.
    moment: Vec3,
    /// `Σ m r × e` of the external accelerations.
    external: Vec3,
}

impl Moments {
    fn add(&mut self, mass: f64, r: &Vec3, a: &Vec3, external: &Vec3) {
        self.mass += mass;
        self.first += mass * r;
        self.second += mass * r * r.transpose();
        self.moment += mass * r.cross(a);
        self.external += mass * r.cross(external);
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first: self.first + other.first,
            second: self.second + other.second,
            moment: self.moment + other.moment,
            external: self.external + other.external,
        }
    }
}

impl Projection {
    /// The projection of a body, `None` where a support takes up angular momentum or symmetry makes
    /// it zero.
    pub fn new(body: &BodyState, symmetry: &[Option<SymmetryPlane>; 3]) -> Option<Self> {
        let mut planes = (0..3).filter(|&axis| symmetry[axis].is_some());
        let only = planes.next();
        let held = body.supports.iter().any(|support| support.displacement.is_some());
        if held || body.exact.is_some() || planes.next().is_some() {
            return None;
        }
        let partial = vec![Moments::default(); body.len().div_ceil(CHUNK)];
        Some(Self { only, pivot: Vec3::zeros(), target: Vec3::zeros(), partial })
    }

    /// Starts a step: notes its angular momentum.
    pub fn start(&mut self, body: &BodyState) {
        self.pivot = Vec3::zeros();
        let centre = self.sum(body, |a| (body.x[a].vector(), Vec3::zeros()));
        self.pivot = centre.first / centre.mass;
        self.target = self.sum(body, |a| (body.x[a].vector(), body.v[a].vector())).moment;
    }

    /// Counts the torque of the loads of the last evaluation over a time `step`, s.
    pub fn add_loads(&mut self, body: &BodyState, step: f64) {
        if !body.external.is_empty() {
            let torque = self.sum(body, |a| (body.x[a].vector(), Vec3::zeros())).external;
            self.target += torque * step;
        }
    }

    /// Takes the torque of the internal forces about the current positions out of the accelerations.
    pub fn remove_torque(&mut self, body: &mut BodyState) {
        let state = &*body;
        let inverse = 1.0 / state.density;
        let internal = |a: usize| {
            let external = state.external.get(a).map_or(Quad::ZERO, |&force| force * inverse);
            (state.x[a].vector(), (state.acceleration[a] - external).vector())
        };
        let sums = self.sum(state, internal);
        let (multiplier, centre) = self.multiplier(&sums, -sums.moment);
        let BodyState { x, acceleration, .. } = body;
        correct(acceleration, &multiplier, |a| x[a].vector() - centre);
    }

    /// Corrects the last accelerations of a step so that it ends with the angular momentum it is to have.
    ///
    /// ```text
    /// x' = xⁿ + s (x + Δt v − xⁿ),   v' = vⁿ + s (v + Δt a − vⁿ),   Σ m x' × v' = Lⁿ + Δt Σ b_s τ_s
    /// ```
    ///
    /// `x'` does not depend on `a`, so one linear solve meets it. For Heun's method `s = ½` and
    /// `x' = x* + ½ Δt² aⁿ`: the torque of the second stage must vanish about the positions the step ends
    /// at, not about those it was evaluated at.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `body` | at its last stage, the step's start in `saved` | |
    /// | `share` | `s` | – |
    /// | `step` | `Δt` | s |
    pub fn close(&mut self, body: &mut BodyState, share: f64, step: f64) {
        let state = &*body;
        let end = |a: usize| state.saved.0[a] + (state.x[a] + state.v[a] * step - state.saved.0[a]) * share;
        let velocity = |a: usize| {
            let full = state.v[a] + state.acceleration[a] * step - state.saved.1[a];
            (state.saved.1[a] + full * share).vector()
        };
        let sums = self.sum(state, |a| (end(a).vector(), velocity(a)));
        let (multiplier, centre) = self.multiplier(&sums, (self.target - sums.moment) / (share * step));
        let BodyState { x, v, saved, acceleration, .. } = body;
        correct(acceleration, &multiplier, |a| {
            (saved.0[a] + (x[a] + v[a] * step - saved.0[a]) * share).vector() - centre
        });
    }

    /// Sums of points and vectors, chunk by chunk in order.
    fn sum(&mut self, body: &BodyState, of: impl Fn(usize) -> (Vec3, Vec3) + Sync) -> Moments {
        let (pivot, inverse) = (self.pivot, 1.0 / body.density);
        self.partial.par_iter_mut().enumerate().for_each(|(index, partial)| {
            *partial = Moments::default();
            for a in index * CHUNK..((index + 1) * CHUNK).min(body.len()) {
                let (point, vector) = of(a);
                let external = body.external.get(a).map_or(Vec3::zeros(), |force| force.vector() * inverse);
                partial.add(body.density * body.particles.volume[a], &(point - pivot), &vector, &external);
            }
        });
        self.partial.iter().fold(Moments::default(), |sum, partial| sum.plus(partial))
    }

    /// `λ` for a wanted torque, N m, and the mass centre, m.
    fn multiplier(&self, sums: &Moments, torque: Vec3) -> (Vec3, Vec3) {
        let centre = sums.first / sums.mass;
        let second = sums.second - sums.mass * centre * centre.transpose();
        let inertia = Mat3::identity() * second.trace() - second;
        let multiplier = match self.only {
            None => inertia.cholesky().map_or(Vec3::zeros(), |factors| factors.solve(&torque)),
            Some(axis) => {
                let mut along = Vec3::zeros();
                along[axis] = torque[axis] / inertia[(axis, axis)];
                along
            }
        };
        (multiplier, centre + self.pivot)
    }
}

/// Adds `λ × r` to the accelerations.
fn correct(acceleration: &mut [Quad], multiplier: &Vec3, arm: impl Fn(usize) -> Vec3 + Sync) {
    acceleration.par_chunks_mut(CHUNK).enumerate().for_each(|(index, chunk)| {
        for (i, a) in chunk.iter_mut().enumerate() {
            *a += Quad::new(&multiplier.cross(&arm(index * CHUNK + i)));
        }
    });
}
