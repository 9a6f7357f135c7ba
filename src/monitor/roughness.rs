//! How much a field alternates from particle to particle: the checkerboard indicator.
//!
//! Owns the comparison of each particle with its neighbours.

use super::field::field_value;
use crate::discretisation::Particles;
use crate::scene::Field;
use crate::solver::{BodyState, Links};
use nalgebra::{Matrix4, Vector4};

/// Share of a field's variation that its neighbourhood does not explain.
///
/// ```text
/// χ = √( Σ_a V_a (f_a − f̂_a)² / Σ_a V_a (f_a − f̄)² ),   f̄ = Σ_a V_a f_a / Σ_a V_a
/// ```
///
/// with `f̂_a` the value at `X_a` of the linear function that fits the neighbours of `a`, itself left
/// out, by least squares. A linear field has 0, a smooth one `O(dx²)`, values without any order about
/// 1, a checkerboard of a cubic lattice with neighbours up to twice the spacing 7/8. A field that is
/// the same everywhere has 0.
pub fn roughness(bodies: &[BodyState], field: Field) -> f64 {
    let values: Vec<Vec<f64>> =
        bodies.iter().map(|body| (0..body.len()).map(|a| field_value(body, a, field)).collect()).collect();
    let parts: Vec<Part<'_>> = bodies
        .iter()
        .zip(&values)
        .map(|(body, values)| Part { particles: &body.particles, links: &body.links, values })
        .collect();
    indicator(&parts)
}

/// A body and a field on it.
struct Part<'a> {
    particles: &'a Particles,
    links: &'a Links,
    values: &'a [f64],
}

fn indicator(parts: &[Part<'_>]) -> f64 {
    let each = || parts.iter().flat_map(|part| part.particles.volume.iter().zip(part.values));
    let (volume, sum) = each().fold((0.0, 0.0), |(volume, sum), (v, f)| (volume + v, sum + v * f));
    let mean = sum / volume;
    let all: f64 = each().map(|(v, f)| v * (f - mean) * (f - mean)).sum();
    let mut unexplained = 0.0;
    for part in parts {
        for (a, value) in part.values.iter().enumerate() {
            let away = value - part.neighbourhood(a);
            unexplained += part.particles.volume[a] * away * away;
        }
    }
    // 0/0 of a field that is the same everywhere is no roughness; not a number stays so
    if all > 0.0 || all.is_nan() { libm::sqrt(unexplained / all) } else { 0.0 }
}

impl Part<'_> {
    /// Value at a particle of the linear function through its neighbours; their mean where they lie in a
    /// plane and fix none.
    fn neighbourhood(&self, a: usize) -> f64 {
        let (mut moment, mut right) = (Matrix4::zeros(), Vector4::zeros());
        let position = &self.particles.position;
        let row = self.links.row(a);
        let count = row.len() as f64;
        for entry in row {
            let b = self.links.neighbour[entry] as usize;
            let r = (position[b] - position[a]) / self.particles.spacing;
            let q = Vector4::new(1.0, r.x, r.y, r.z);
            moment += q * q.transpose();
            right += self.values[b] * q;
        }
        match moment.cholesky() {
            Some(factor) => factor.solve(&right).x,
            None => right.x / count.max(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::{Consistency, Kernel, Shape, Stencils};
    use crate::tensor::Vec3;

    fn measured(cells: f64, value: impl Fn(&Vec3) -> f64) -> f64 {
        let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::repeat(1.0) };
        let particles = Particles::lattice(&shape, 1.0 / cells, [None; 3], 0.0).expect("a box");
        let stencils = Stencils::build(&particles, Kernel::WendlandC2, 1.01, Consistency::Integration);
        let links = Links::new(&particles, &stencils.expect("a lattice has stencils"));
        let values: Vec<f64> = particles.position.iter().map(value).collect();
        indicator(&[Part { particles: &particles, links: &links, values: &values }])
    }

    #[test]
    fn a_linear_field_is_smooth_and_a_constant_one_as_well() {
        assert!(measured(6.0, |x| 1.0 + 2.0 * x.x - 3.0 * x.y + x.z) < 1e-13);
        assert_eq!(measured(4.0, |_| 2.0), 0.0);
    }

    #[test]
    fn a_checkerboard_is_not_explained_by_its_neighbours() {
        // 7/8 inside, more where neighbours lie on one side only
        let board = |x: &Vec3| f64::from(libm::round(8.0 * (x.x + x.y + x.z)) as i32 % 2);
        let found = measured(8.0, board);
        assert!((0.875..1.2).contains(&found), "{found}");
    }

    #[test]
    fn of_a_smooth_field_it_falls_with_the_square_of_the_spacing() {
        let wave = |x: &Vec3| libm::sin(2.0 * x.x) * libm::cos(x.y) + x.z * x.z;
        let (coarse, fine) = (measured(6.0, wave), measured(12.0, wave));
        let order = libm::log2(coarse / fine);
        assert!((1.5..2.5).contains(&order), "{coarse} {fine}");
    }
}
