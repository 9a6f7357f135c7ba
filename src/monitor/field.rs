//! Scalar fields of the particles.
//!
//! Owns the reading of stresses and maps at one particle.

use crate::scene::Field;
use crate::solver::BodyState;
use crate::tensor::{Mat3, cofactor, volume_map};

/// Cauchy stress of a particle.
///
/// ```text
/// σ = P Fᵀ / J
/// ```
///
/// with the evolved `J` where there is one. Returns Pa.
pub fn cauchy_stress(body: &BodyState, particle: usize) -> Mat3 {
    let f = body.f(particle);
    body.stress(particle) * f.transpose() / jacobian(body, particle)
}

fn jacobian(body: &BodyState, particle: usize) -> f64 {
    let f = body.f(particle);
    body.j(particle).unwrap_or_else(|| volume_map(f, &cofactor(f)))
}

/// Von Mises stress, the paper's effective stress.
///
/// ```text
/// σ_v = √(3/2 dev σ : dev σ)
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `sigma` | Cauchy stress | Pa |
///
/// Returns Pa.
pub fn von_mises(sigma: &Mat3) -> f64 {
    let mean = sigma.trace() / 3.0;
    let deviator = sigma - Mat3::identity() * mean;
    libm::sqrt(1.5 * deviator.norm_squared())
}

/// Value of a field at a particle, SI.
pub fn field_value(body: &BodyState, particle: usize, field: Field) -> f64 {
    let at = |axis: u8| axis as usize;
    match field {
        Field::Displacement(axis) => {
            body.x[particle].0[at(axis)] - body.particles.position[particle][at(axis)]
        }
        Field::Velocity(axis) => body.v[particle].0[at(axis)],
        Field::Sigma(i, j) => cauchy_stress(body, particle)[(at(i), at(j))],
        Field::P(i, j) => body.stress(particle)[(at(i), at(j))],
        Field::F(i, j) => body.f(particle)[(at(i), at(j))],
        Field::VonMises => von_mises(&cauchy_stress(body, particle)),
        Field::Pressure => cauchy_stress(body, particle).trace() / 3.0,
        Field::J => jacobian(body, particle),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn von_mises_of_uniaxial_tension_is_the_tension() {
        let sigma = Mat3::from_diagonal(&crate::tensor::Vec3::new(3.0, 0.0, 0.0));
        assert!((von_mises(&sigma) - 3.0).abs() <= 8.0 * f64::EPSILON);
    }

    #[test]
    fn von_mises_of_pressure_is_zero() {
        assert_eq!(von_mises(&(Mat3::identity() * -5.0)), 0.0);
    }
}
