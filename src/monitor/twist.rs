//! How far one end of a body is turned against the other.
//!
//! Owns the sum of the turns from layer to layer, which needs no history.

use crate::discretisation::Particles;
use crate::solver::BodyState;
use crate::tensor::Vec3;

/// The particles of a body in layers across an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layers {
    axis: usize,
    /// Particles of each layer with their volumes, the last layer at the face asked for.
    layer: Vec<Vec<(usize, f64)>>,
}

impl Layers {
    /// Layers one spacing apart, from the opposite face to the face of this outward normal.
    pub fn new(particles: &Particles, normal: &Vec3) -> Self {
        let axis = normal.iamax();
        let sign = normal[axis].signum();
        let along = |x: &Vec3| sign * x[axis];
        let low = particles.position.iter().map(along).fold(f64::INFINITY, f64::min);
        let high = particles.position.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        let count = libm::round((high - low) / particles.spacing).max(1.0);
        let mut layer = vec![Vec::new(); count as usize + 1];
        for (a, (x, volume)) in particles.position.iter().zip(&particles.volume).enumerate() {
            let share = (along(x) - low) / (high - low);
            layer[libm::round(share * count) as usize].push((a, *volume));
        }
        layer.retain(|members| !members.is_empty());
        Self { axis, layer }
    }

    /// Angle of the last layer relative to the first about the coordinate axis, rad.
    ///
    /// ```text
    /// θ_k = atan2( Σ V (Y z − Z y), Σ V (Y y + Z z) ),   θ = Σ_k wrap(θ_k − θ_k−1)
    /// ```
    ///
    /// with reference (Y, Z) and current (y, z) coordinates across the axis relative to their means:
    /// the turn that fits the layer best by least squares. Neighbouring layers may differ by less
    /// than half a turn.
    pub fn twist(&self, body: &BodyState) -> f64 {
        self.total(&body.particles.position, &|a| body.x[a].vector())
    }

    fn total(&self, reference: &[Vec3], position: &dyn Fn(usize) -> Vec3) -> f64 {
        let mut last = None;
        let mut total = 0.0;
        for members in &self.layer {
            let angle = self.turn(members, reference, position);
            total += last.map_or(0.0, |last: f64| wrapped(angle - last));
            last = Some(angle);
        }
        total
    }

    fn turn(&self, members: &[(usize, f64)], reference: &[Vec3], position: &dyn Fn(usize) -> Vec3) -> f64 {
        let (first, second) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let volume: f64 = members.iter().map(|(_, v)| v).sum();
        let mean = |at: &dyn Fn(usize) -> Vec3| -> Vec3 {
            members.iter().map(|&(a, v)| at(a) * v).sum::<Vec3>() / volume
        };
        let (from, to) = (mean(&|a| reference[a]), mean(position));
        let (mut sine, mut cosine) = (0.0, 0.0);
        for &(a, v) in members {
            let (x, y) = (reference[a] - from, position(a) - to);
            sine += v * (x[first] * y[second] - x[second] * y[first]);
            cosine += v * (x[first] * y[first] + x[second] * y[second]);
        }
        libm::atan2(sine, cosine)
    }
}

/// An angle less whole turns, in [−π, π].
fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * libm::round(angle / std::f64::consts::TAU)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::Shape;

    // each layer's angle is rounded to 1e-16 of π, and there are 13
    #[test]
    fn a_column_wound_up_twice_is_told_so() {
        let shape = Shape::Box { min: Vec3::new(-0.5, 0.0, -0.5), max: Vec3::new(0.5, 6.0, 0.5) };
        let particles = Particles::lattice(&shape, 0.5, [None; 3], 0.1).expect("the column can be filled");
        for (normal, winding, expected) in
            [(Vec3::y(), 2.0, 12.0), (-Vec3::y(), 2.0, -12.0), (Vec3::y(), -1.0, -6.0)]
        {
            let layers = Layers::new(&particles, &normal);
            let wound = |a: usize| {
                let x = particles.position[a];
                // by the layer's own height, so that the layer turns as one
                let angle = winding * 0.5 * libm::round(x.y / 0.5);
                let turn = nalgebra::Rotation3::from_axis_angle(&Vec3::y_axis(), angle);
                turn * x + Vec3::new(0.3, 0.0, -2.0)
            };
            let total = layers.total(&particles.position, &wound);
            assert!((total - expected).abs() < 1e-13, "{total} {expected}");
        }
    }
}
