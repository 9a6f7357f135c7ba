//! Numbers by which a law is judged before any particle moves.
//!
//! Owns the measurements `check` reports, each a pure function of a law, its directions and a state
//! or range. What is good enough is not decided here. A [`Subject`] is a law with its directions.

mod growth;
mod identity;
mod moduli;
mod stability;

pub use growth::{VolumetricGrowth, overflow_stretch, volumetric_growth};
pub use identity::{
    asymmetry_of_tangent, derivative_error, derivative_order, deviator_under_dilation,
    material_symmetry_error, objectivity_error, stress_at_rest,
};
pub use moduli::{Moduli, Uniaxial, moduli, one_sided, uniaxial};
pub use stability::{
    BakerEricksen, Ellipticity, baker_ericksen, ellipticity, ellipticity_along, smallest_volumetric_stiffness,
};

use super::law::{Directions, Law, Maps, Scratch};
use crate::tensor::{Mat3, Vec3};

/// A law and the directions it is judged with.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The law.
    pub law: &'a Law,
    /// Unit vectors, at least as many as the law reads.
    pub directions: &'a [Vec3],
}

impl Subject<'_> {
    /// First Piola–Kirchhoff stress at one state, Pa.
    pub fn stress(&self, f: &Mat3) -> Mat3 {
        let mut out = [Mat3::zeros()];
        let maps = Maps { f: &[*f], h: None, j: None };
        self.law.stress(maps, Directions::Uniform(self.directions), &mut out, &mut Scratch::default());
        out[0]
    }

    /// Strain energy at one state, Pa.
    pub fn density(&self, f: &Mat3) -> f64 {
        let mut out = [0.0];
        let maps = Maps { f: &[*f], h: None, j: None };
        self.law.density(maps, Directions::Uniform(self.directions), &mut out, &mut Scratch::default());
        out[0]
    }
}
