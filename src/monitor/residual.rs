//! The momentum balance of an exact motion by finite differences.
//!
//! Owns a route to the body force that shares nothing with the derived one: no dual number, but
//! differences of the positions as written and of the stresses of the law.

use crate::energy::{Directions, Maps, Scratch};
use crate::expression::Tape;
use crate::scene::Coordinate;
use crate::solver::BodyState;
use crate::tensor::{Mat3, Vec3};
use nalgebra::SMatrix;

/// Where in the box around a body its motion is tested: no symmetry's place.
const PLACE: [f64; 3] = [0.43, 0.57, 0.38];

/// When a motion is tested, as a share of the run: no symmetry's time.
pub const RESIDUAL_MOMENT: f64 = 0.71;

/// What the exact motion of a body leaves of the momentum balance.
///
/// ```text
/// |ρR ∂²x/∂t² − DIV P − f0| / (|ρR ∂²x/∂t²| + |DIV P| + |f0| + |P|/L)
/// ```
///
/// with `∂²x/∂t²`, `F` and `DIV P` by differences extrapolated to a step of zero and `f0` as the solver
/// has it, at one place and time; `L` is the extent of the body.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `body` | follows a motion | |
/// | `until` | end of the run | s |
///
/// Returns a number; zero where the body follows no motion.
pub fn residual(body: &BodyState, until: f64) -> f64 {
    let Some(exact) = &body.exact else { return 0.0 };
    let start = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
    let (low, high) = body.particles.position.iter().fold(start, |(low, high), x| (low.inf(x), high.sup(x)));
    let extent = high - low;
    let place = low + extent.component_mul(&Vec3::from(PLACE));
    let time = RESIDUAL_MOMENT * until;
    let probe = Probe { body, position: &exact.position, extent };
    let inertia = body.density * probe.acceleration(&place, time, 0.2 * until);
    let divergence = probe.divergence(&place, time);
    let force = exact.body_force(&place, time);
    let stress = probe.stress(&place, time).norm() / extent.min();
    let scale = inertia.norm() + divergence.norm() + force.norm() + stress;
    let left = (inertia - divergence - force).norm();
    if left == 0.0 { 0.0 } else { left / scale }
}

/// Largest residual of the bodies.
pub fn largest_residual(bodies: &[BodyState], until: f64) -> f64 {
    let larger = |a: f64, b: f64| if b <= a { a } else { b };
    bodies.iter().map(|body| residual(body, until)).fold(0.0, larger)
}

struct Probe<'a> {
    body: &'a BodyState,
    position: &'a [Tape<Coordinate>; 3],
    extent: Vec3,
}

impl Probe<'_> {
    fn displacement(&self, at: &Vec3, time: f64) -> Vec3 {
        let leaf = |leaf: &Coordinate| match leaf {
            Coordinate::X(axis) => at[usize::from(*axis)],
            Coordinate::Time => time,
        };
        Vec3::from_fn(|axis, _| self.position[axis].evaluate(leaf, &mut Vec::new()) - at[axis])
    }

    fn acceleration(&self, at: &Vec3, time: f64, step: f64) -> Vec3 {
        let now = self.displacement(at, time);
        extrapolated(step, |h| {
            (self.displacement(at, time + h) - 2.0 * now + self.displacement(at, time - h)) / (h * h)
        })
    }

    fn gradient(&self, at: &Vec3, time: f64) -> Mat3 {
        let columns = [0, 1, 2].map(|axis| {
            let along = |h: f64| {
                let mut moved = *at;
                moved[axis] += h;
                self.displacement(&moved, time)
            };
            extrapolated(STEP * self.extent[axis], |h| (along(h) - along(-h)) / (2.0 * h))
        });
        Mat3::identity() + Mat3::from_columns(&columns)
    }

    fn stress(&self, at: &Vec3, time: f64) -> Mat3 {
        let mut stress = [Mat3::zeros()];
        let f = [self.gradient(at, time)];
        let maps = Maps { f: &f, h: None, j: None };
        let directions = self.body.exact.as_ref().map_or_else(Vec::new, |exact| exact.directions(at));
        self.body.law.stress(maps, Directions::Uniform(&directions), &mut stress, &mut Scratch::default());
        stress[0]
    }

    fn divergence(&self, at: &Vec3, time: f64) -> Vec3 {
        let along = |axis: usize, h: f64| {
            let mut moved = *at;
            moved[axis] += h;
            Vec3::from(self.stress(&moved, time).column(axis))
        };
        let slope = |axis: usize| {
            extrapolated(STEP * self.extent[axis], |h| (along(axis, h) - along(axis, -h)) / (2.0 * h))
        };
        slope(0) + slope(1) + slope(2)
    }
}

/// First step of the differences in place, as a share of the extent.
const STEP: f64 = 0.1;

/// Factor between two steps, and how many are tried.
const FACTOR: f64 = 1.4;
const TRIES: usize = 12;

/// A difference quotient with an even error, extrapolated to a step of zero (Ridders 1982): the entry of
/// the scheme that differs least from those it was made of.
fn extrapolated<const R: usize, const C: usize>(
    first: f64,
    quotient: impl Fn(f64) -> SMatrix<f64, R, C>,
) -> SMatrix<f64, R, C> {
    let mut last = vec![quotient(first)];
    let (mut best, mut gap) = (last[0], f64::INFINITY);
    let mut step = first;
    for _ in 1..TRIES {
        step /= FACTOR;
        let mut row = vec![quotient(step)];
        let mut factor = FACTOR * FACTOR;
        for (place, above) in last.iter().enumerate() {
            let next = (row[place] * factor - above) / (factor - 1.0);
            let differs = (next - row[place]).norm().max((next - above).norm());
            if differs <= gap {
                (best, gap) = (next, differs);
            }
            row.push(next);
            factor *= FACTOR * FACTOR;
        }
        last = row;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_is_found_to_round_off() {
        let found = extrapolated(0.3, |h| {
            SMatrix::<f64, 1, 1>::new((libm::exp(1.0 + h) - libm::exp(1.0 - h)) / (2.0 * h))
        });
        assert!((found[0] - libm::exp(1.0)).abs() <= 1e-13);
    }
}
