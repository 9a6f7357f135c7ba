//! Pressures that follow the deforming face.
//!
//! Owns their forces from current positions. Knows neither materials nor time stepping.

use super::loads::evaluate;
use super::quad::Quad;
use crate::discretisation::{FaceNodes, quad_integrals};
use crate::expression::Tape;
use crate::scene::Coordinate;
use crate::tensor::Vec3;

/// A pressure on one face of a body.
#[derive(Debug, Clone)]
pub struct Follower {
    quads: Vec<[u32; 4]>,
    pressure: Tape<Coordinate>,
    /// Whether the pressure depends on the place.
    varies: bool,
    /// Name of the face.
    pub face: String,
    /// Force on the body at the last evaluation, N.
    pub total: Vec3,
}

impl Follower {
    /// A pressure on a face.
    pub fn new(face: &FaceNodes, pressure: &Tape<Coordinate>) -> Self {
        let varies = pressure.leaves().any(|leaf| matches!(leaf, Coordinate::X(_)));
        let (quads, face) = (face.quads.clone(), face.name.clone());
        Self { quads, pressure: pressure.clone(), varies, face, total: Vec3::zeros() }
    }

    /// Adds the force per reference volume on the nodes of the face.
    ///
    /// ```text
    /// f_a = −p_a/V_a ∫ N_a n da,    n da = cof F N dA of the face's bilinear map
    /// ```
    ///
    /// The integral runs over the current quadrilaterals. Where the motion is affine it is
    /// `H A_a N_a` with `H = cof F`. It is also the gradient of the enclosed volume with respect to
    /// `x_a`, so a uniform pressure on a closed surface has neither a net force nor a moment, and its
    /// work is that of a potential; with `H_a` of the particle in its place the net force would be
    /// `Σ V DIV H`, which vanishes only as the spacing does.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `reference`, `position` | `X` and `x` of all particles of the body | m |
    /// | `inverse_volume` | `1/V_a` | 1/m³ |
    /// | `time` | | s |
    /// | `out` | added to | N/m³ |
    /// | `scratch` | kept between calls | |
    pub fn add(
        &mut self,
        (reference, position): (&[Vec3], &[Quad]),
        inverse_volume: &[f64],
        time: f64,
        out: &mut [Quad],
        scratch: &mut Vec<f64>,
    ) {
        // a pressure that does not vary in space reads no coordinate
        let uniform = if self.varies { 0.0 } else { evaluate(&self.pressure, &Vec3::zeros(), time, scratch) };
        self.total = Vec3::zeros();
        for quad in &self.quads {
            let area = quad_integrals(&quad.map(|a| position[a as usize].vector()));
            for (&a, area) in quad.iter().zip(&area) {
                let a = a as usize;
                let pressure = match self.varies {
                    true => evaluate(&self.pressure, &reference[a], time, scratch),
                    false => uniform,
                };
                self.total -= pressure * area;
                out[a] += Quad::new(area) * (-pressure * inverse_volume[a]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::{Particles, Shape};
    use crate::tensor::cofactor;
    use nalgebra::Matrix3;

    /// A jittered block in the positions a map gives it, under 2 Pa on all faces: force on each node, N.
    fn forces(map: impl Fn(&Vec3) -> Vec3) -> (Particles, Vec<Vec3>, Vec<Vec3>) {
        let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(1.0, 0.8, 0.6) };
        let particles = Particles::lattice(&shape, 0.2, [None; 3], 0.2).expect("the block can be filled");
        let position: Vec<Quad> = particles.position.iter().map(|x| Quad::new(&map(x))).collect();
        let inverse: Vec<f64> = particles.volume.iter().map(|v| 1.0 / v).collect();
        let mut out = vec![Quad::ZERO; particles.len()];
        for face in &particles.faces {
            let mut follower = Follower::new(face, &Tape::constant(2.0));
            follower.add((&particles.position, &position), &inverse, 0.0, &mut out, &mut Vec::new());
        }
        let force = out.iter().zip(&particles.volume).map(|(f, v)| f.vector() * *v).collect();
        (particles, force, position.iter().map(|x| x.vector()).collect())
    }

    // some hundred quadrilaterals of 0.04 m², each rounded to 1e-16 of 2 Pa times its area
    #[test]
    fn on_a_closed_surface_force_and_moment_cancel_whatever_the_motion() {
        let bent =
            |x: &Vec3| Vec3::new(x.x + 0.3 * x.y * x.y, x.y - 0.2 * x.x * x.z, x.z * (1.0 + 0.4 * x.x));
        let (_, force, position) = forces(bent);
        let total: Vec3 = force.iter().sum();
        let moment: Vec3 = force.iter().zip(&position).map(|(f, x)| x.cross(f)).sum();
        let scale: f64 = force.iter().map(|f| f.norm()).sum();
        assert!(total.norm() < 1e-14 * scale, "{total}");
        assert!(moment.norm() < 1e-14 * scale, "{moment}");
    }

    #[test]
    fn in_an_affine_motion_it_is_the_area_map_of_the_reference_area() {
        let f = Matrix3::new(1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.2, 0.1, 1.1);
        let (particles, force, _) = forces(|x| f * x);
        for (force, area) in force.iter().zip(particles.boundary_area()) {
            assert!((force + 2.0 * cofactor(&f) * area).norm() < 1e-15);
        }
    }
}
