//! How an equilibrium answers to the parameters of its law: implicit differentiation.
//!
//! Owns the derivatives of F and the stresses along a drive. Nothing here takes a difference: the law's
//! own derivatives are exact, and the equations of equilibrium, linear in what is sought, are solved once
//! more with their last Jacobian.

use super::control::{Control, Target};
use super::error::DriveError;
use super::follow::Drive;
use super::solution::Factors;
use super::state::Point;
use super::system::{CONSTRAINT, Column, Solved, System};
use crate::energy::{ParameterSlope, ParameterSlopes, Scratch};
use crate::tensor::{Mat3, contract};
use nalgebra::SVector;

/// Derivatives of a [`Point`] by one parameter `θ` of its law; tensors in the common axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointSlope {
    /// `dF/dθ`
    pub f: Mat3,
    /// `dJ/dθ`
    pub j: f64,
    /// `dP/dθ`
    pub first_piola: Mat3,
    /// `dσ/dθ`
    pub cauchy: Mat3,
    /// `dψ/dθ`
    pub psi: f64,
    /// Of the hydrostatic stress of the constraint.
    pub constraint_stress: f64,
}

impl Drive<'_> {
    /// [`Drive::visit`] with the derivatives of each equilibrium by the parameters of `slopes`, whose law
    /// must be the drive's.
    ///
    /// ```text
    /// R(u, θ) = 0   ⇒   du/dθ = −(∂R/∂u)⁻¹ ∂R/∂θ,    u = free components of F, and q
    /// ```
    ///
    /// A derivative that does not exist is not finite.
    ///
    /// # Errors
    /// As [`Drive::follow`].
    ///
    /// # Panics
    /// As [`Drive::follow`].
    pub fn visit_with_slopes(
        &self,
        path: impl Fn(f64) -> Target,
        parameters: &[f64],
        slopes: &ParameterSlopes,
        mut found: impl FnMut(&Point, &[PointSlope]),
    ) -> Result<(), DriveError> {
        let mut scratch = Scratch::default();
        self.visit_solved(&path, parameters, |system, solved, parameter| {
            let point = self.point(system, solved, parameter);
            let partial = slopes.at(&solved.unknowns.f, &system.directions, &mut scratch);
            let total = self.slopes(system, solved, &path(parameter), &partial);
            found(&point, &total);
        })
    }

    fn slopes(
        &self,
        system: &mut System<'_>,
        solved: &Solved,
        target: &Target,
        partial: &[ParameterSlope],
    ) -> Vec<PointSlope> {
        let state = &solved.unknowns;
        let stresses = system.stresses(state);
        let turned = |tensor: &Mat3| self.frame * tensor * self.frame.transpose();
        let Ok(tangent) = system.tangent(state) else { return vec![NONE; partial.len()] };
        let scale = tangent.amax();
        let factors = Factors::of(system.jacobian(state, &stresses, &tangent, target, scale));
        let law_stress = stresses.first_piola - state.q * stresses.h;
        let one = |partial: &ParameterSlope| {
            let at_fixed_f = partial.first_piola;
            let mut right = Column::zeros();
            for (i, j) in target.unknowns() {
                right[i + 3 * j] = match target.components[i][j] {
                    Control::FirstPiola(_) => at_fixed_f[(i, j)] / scale,
                    Control::Cauchy(_) => (at_fixed_f * state.f.transpose())[(i, j)] / stresses.j / scale,
                    Control::Deformation(_) => 0.0,
                };
            }
            let Some(change) = factors.solve(&right) else { return NONE };
            let mut f = Mat3::zeros();
            for (i, j) in target.unknowns() {
                f[(i, j)] = -change[i + 3 * j];
            }
            let q = if system.is_incompressible { -change[CONSTRAINT] * scale } else { 0.0 };
            let along = tangent * SVector::<f64, 9>::from_column_slice(f.as_slice());
            let first_piola = Mat3::from_column_slice(along.as_slice()) + at_fixed_f + q * stresses.h;
            let j = contract(&stresses.h, &f);
            let cauchy = (first_piola * state.f.transpose() + stresses.first_piola * f.transpose()
                - stresses.cauchy * j)
                / stresses.j;
            PointSlope {
                f: turned(&f),
                j,
                first_piola: turned(&first_piola),
                cauchy: turned(&cauchy),
                psi: partial.psi + contract(&law_stress, &f),
                constraint_stress: q,
            }
        };
        partial.iter().map(one).collect()
    }
}

/// Where no derivative exists.
const NONE: PointSlope = {
    let none =
        Mat3::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN, f64::NAN);
    PointSlope {
        f: none,
        j: f64::NAN,
        first_piola: none,
        cauchy: none,
        psi: f64::NAN,
        constraint_stress: f64::NAN,
    }
};
