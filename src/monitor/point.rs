//! Values of particle fields at a point of the reference configuration.
//!
//! Owns the interpolation weights of a point: linear fields are met exactly.

use crate::discretisation::Particles;
use crate::tensor::Vec3;
use nalgebra::{Matrix4, Vector4};

/// Weights of the particles around a point; they add up to one.
#[derive(Debug, Clone, PartialEq)]
pub struct Interpolation {
    /// Particle and weight.
    pub weights: Vec<(usize, f64)>,
}

impl Interpolation {
    /// Moving least squares of degree one around a point.
    ///
    /// ```text
    /// w_a = W(|X_a − X|) · q(0)ᵀ M⁻¹ q(X_a − X),   M = Σ W q qᵀ,   q(r) = (1, r)
    /// ```
    ///
    /// A point on a node, to a millionth of the spacing, is that node. `None` where the particles do
    /// not surround the point well enough, which means that it lies outside the body.
    pub fn new(particles: &Particles, point: &Vec3) -> Option<Self> {
        let spacing = particles.spacing;
        let near = |x: &Vec3| (x - point).norm();
        let nearest = (0..particles.position.len())
            .min_by(|&a, &b| near(&particles.position[a]).total_cmp(&near(&particles.position[b])))?;
        let distance = near(&particles.position[nearest]);
        if distance <= ON_NODE * spacing {
            return Some(Self { weights: vec![(nearest, 1.0)] });
        }
        if distance > spacing {
            return None;
        }
        let basis = |x: &Vec3| {
            let r = (x - point) / spacing;
            Vector4::new(1.0, r.x, r.y, r.z)
        };
        let around: Vec<(usize, f64)> = particles
            .position
            .iter()
            .enumerate()
            .map(|(a, x)| (a, 1.0 - near(x) / (SUPPORT * spacing)))
            .filter(|(_, w)| *w > 0.0)
            .map(|(a, w)| (a, w * w))
            .collect();
        let mut moment = Matrix4::zeros();
        for &(a, w) in &around {
            let q = basis(&particles.position[a]);
            moment += w * q * q.transpose();
        }
        let first = moment.lu().solve(&Vector4::new(1.0, 0.0, 0.0, 0.0))?;
        let weights =
            around.iter().map(|&(a, w)| (a, w * first.dot(&basis(&particles.position[a])))).collect();
        Some(Self { weights })
    }

    /// The interpolated value of a field.
    pub fn value(&self, field: impl Fn(usize) -> f64) -> f64 {
        self.weights.iter().map(|&(a, w)| w * field(a)).sum()
    }
}

/// Distance from a node, in spacings, below which a point is the node.
const ON_NODE: f64 = 1e-6;

/// Radius of the weight, in spacings.
const SUPPORT: f64 = 2.1;
