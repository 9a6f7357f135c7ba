//! Sums over all particles: momentum, energy, volume.
//!
//! Owns the totals of the whole bodies; a part modelled behind planes of symmetry counts with its
//! mirror images. All sums run in particle order.

use crate::energy::Scratch;
use crate::scene::SymmetryPlane;
use crate::solver::{BodyState, CHUNK, hourglass};
use crate::tensor::Vec3;

/// Totals of all bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Totals {
    /// `Σ V_a p_a`, kg m/s.
    pub momentum: Vec3,
    /// `Σ V_a |p_a|`, kg m/s, the scale of the momentum's round-off.
    pub momentum_scale: f64,
    /// `Σ V_a x_a × p_a` about the origin, kg m²/s.
    pub angular_momentum: Vec3,
    /// `Σ V_a ½ |p_a|²/ρR`, J.
    pub kinetic_energy: f64,
    /// `Σ V_a ψ_a`, and the energy of the hourglass stiffness where there is one, J.
    pub strain_energy: f64,
    /// `Σ V_a J_a`, m³.
    pub volume: f64,
}

/// Sums a state.
pub fn totals(bodies: &[BodyState], symmetry: &[Option<SymmetryPlane>; 3]) -> Totals {
    let mut part = Totals::default();
    let mut scratch = Scratch::default();
    let mut density = vec![0.0; CHUNK];
    let centre = Vec3::from_fn(|axis, _| symmetry[axis].as_ref().map_or(0.0, |plane| plane.at));
    for body in bodies {
        part.strain_energy += hourglass::energy(body);
        for (a, (v, x)) in body.v.iter().zip(&body.x).enumerate() {
            let mass = body.density * body.particles.volume[a];
            let (velocity, position) = (v.vector(), x.vector());
            part.momentum += mass * velocity;
            part.momentum_scale += mass * velocity.norm();
            part.angular_momentum += mass * (position - centre).cross(&velocity);
            part.kinetic_energy += 0.5 * mass * velocity.norm_squared();
        }
        for block in &body.blocks {
            let out = &mut density[..block.f.len()];
            let directions = body.directions.slice(block.start, block.f.len());
            body.law.density(block.maps(), directions, out, &mut scratch);
            for (i, psi) in out.iter().enumerate() {
                let a = block.start + i;
                let jacobian = super::field_value(body, a, crate::scene::Field::J);
                part.strain_energy += body.particles.volume[a] * psi;
                part.volume += body.particles.volume[a] * jacobian;
            }
        }
    }
    whole(part, symmetry, &centre)
}

/// The whole body's totals from those of the modelled part.
///
/// A mirror image normal to `n` flips `p_n` and keeps `L_n`, about a point of the plane.
fn whole(part: Totals, symmetry: &[Option<SymmetryPlane>; 3], centre: &Vec3) -> Totals {
    let planes = symmetry.iter().flatten().count() as u32;
    let images = f64::from(2_u32.pow(planes));
    let mut momentum = part.momentum * images;
    let mut angular_momentum = part.angular_momentum * images;
    for normal in 0..3 {
        if symmetry[normal].is_some() {
            momentum[normal] = 0.0;
            for axis in (0..3).filter(|axis| *axis != normal) {
                angular_momentum[axis] = 0.0;
            }
        }
    }
    Totals {
        momentum,
        momentum_scale: part.momentum_scale * images,
        angular_momentum: angular_momentum + centre.cross(&momentum),
        kinetic_energy: part.kinetic_energy * images,
        strain_energy: part.strain_energy * images,
        volume: part.volume * images,
    }
}
