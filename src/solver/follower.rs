//! Pressures that follow the deforming face.
//!
//! Owns their forces from current positions. Knows neither materials nor time stepping.

use super::loads::evaluate;
use super::quad::Quad;
use crate::discretisation::{Bulge, FaceNodes, quad_integrals};
use crate::expression::Tape;
use crate::scene::Coordinate;
use crate::tensor::Vec3;

/// A pressure on one face of a body.
#[derive(Debug, Clone)]
pub struct Follower {
    quads: Vec<[u32; 4]>,
    bulges: Vec<Bulge>,
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
        let (quads, bulges, face) = (face.quads.clone(), face.bulges.clone(), face.name.clone());
        Self { quads, bulges, pressure: pressure.clone(), varies, face, total: Vec3::zeros() }
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
    /// Where nodal areas integrate quadratic fields each quadrilateral `q` hands on `c_qa n_q` to the nodes round it,
    ///
    /// ```text
    /// f_a += p_a/V_a Σ_q c_qa n_q,    n_q = ½ (x_3 − x_1) × (x_4 − x_2),    Σ_a c_qa = 0,
    /// ```
    ///
    /// so that where the motion is affine it is `H A_a N_a` of those areas. The net force stays zero; the moment is
    /// `p Σ_q m_q × n_q` of the bulges `m_q = Σ_a c_qa x_a`, which are nearly normal to the face and fall with the
    /// square of the spacing. The gradient of `Σ_q m_q · n_q`, the volume of the bulges, would have none, but has
    /// a part with `∂n_q/∂x_a` that destabilises the nodes of a face: a block squeezed to `p = 1.25 μ` broke up.
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
        for Bulge { quad, shares } in &self.bulges {
            let [first, second, third, fourth] = quad.map(|a| position[a as usize].vector());
            let normal = 0.5 * (third - first).cross(&(fourth - second));
            for &(a, c) in shares {
                let area = c * normal;
                let a = a as usize;
                let pressure = match self.varies {
                    true => evaluate(&self.pressure, &reference[a], time, scratch),
                    false => uniform,
                };
                self.total += pressure * area;
                out[a] += Quad::new(&area) * (pressure * inverse_volume[a]);
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
    fn forces(
        spacing: f64,
        quadratic: bool,
        map: impl Fn(&Vec3) -> Vec3,
    ) -> (Particles, Vec<Vec3>, Vec<Vec3>) {
        let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(1.0, 0.8, 0.6) };
        let mut particles =
            Particles::lattice(&shape, spacing, [None; 3], 0.2).expect("the block can be filled");
        if quadratic {
            particles.integrate_quadratics().expect("five layers tell quadratic fields apart");
        }
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

    fn bent(x: &Vec3) -> Vec3 {
        Vec3::new(x.x + 0.3 * x.y * x.y, x.y - 0.2 * x.x * x.z, x.z * (1.0 + 0.4 * x.x))
    }

    /// Net force, moment, and the sum of magnitudes.
    fn totals(spacing: f64, quadratic: bool) -> (Vec3, Vec3, f64) {
        let (_, force, position) = forces(spacing, quadratic, bent);
        let moment = force.iter().zip(&position).map(|(f, x)| x.cross(f)).sum();
        (force.iter().sum(), moment, force.iter().map(|f| f.norm()).sum())
    }

    // some hundred quadrilaterals of 0.04 m², each rounded to 1e-16 of 2 Pa times its area
    #[test]
    fn on_a_closed_surface_force_and_moment_cancel_whatever_the_motion() {
        let (total, moment, scale) = totals(0.2, false);
        assert!(total.norm() < 1e-14 * scale, "{total}");
        assert!(moment.norm() < 1e-14 * scale, "{moment}");
    }

    #[test]
    fn with_areas_of_second_order_the_force_cancels_and_the_moment_falls_with_the_square_of_the_spacing() {
        let [coarse, fine] = [0.2, 0.1].map(|spacing| {
            let (total, moment, scale) = totals(spacing, true);
            // shares of systems of condition 1e3
            assert!(total.norm() < 1e-12 * scale, "{total}");
            moment.norm() / scale
        });
        assert!(coarse < 1e-2 && fine < coarse / 3.0, "{coarse:e} {fine:e}");
    }

    #[test]
    fn in_an_affine_motion_it_is_the_area_map_of_the_reference_area() {
        let f = Matrix3::new(1.2, 0.3, -0.1, 0.05, 0.9, 0.2, -0.2, 0.1, 1.1);
        for quadratic in [false, true] {
            let (particles, force, _) = forces(0.2, quadratic, |x| f * x);
            for (force, area) in force.iter().zip(particles.boundary_area()) {
                // areas that integrate quadratic fields are solutions of systems of condition 1e3
                let bound = if quadratic { 1e-13 } else { 1e-15 };
                assert!((force + 2.0 * cofactor(&f) * area).norm() < bound);
            }
        }
    }
}
