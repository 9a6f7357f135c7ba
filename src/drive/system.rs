//! Equilibrium of one material point: residual, Jacobian, Newton's method.
//!
//! Owns the equations at one target. The path and its steps are in the neighbouring file.

use nalgebra::{SMatrix, SVector};

use super::control::{Control, Target};
use super::error::Cause;
use super::solution::Factors;
use super::state::Unknowns;
use crate::energy::{Directions, Kink, Law, Maps, Scratch, Tangent};
use crate::tensor::{Mat3, Vec3, cofactor, contract, cross, volume_map};

/// Nine components of F and one stress of the constraint; unused rows are those of the identity.
pub(super) const SIZE: usize = 10;
pub(super) type Matrix = SMatrix<f64, SIZE, SIZE>;
pub(super) type Column = SVector<f64, SIZE>;

/// Row and column of the constraint `J = 1` and its stress.
pub(super) const CONSTRAINT: usize = 9;

/// Residual over the largest entry of the tangent, so a strain, that an equilibrium may keep.
///
/// Newton's method goes on until the residual no longer halves, which is near round-off (1e-16 of the
/// largest term); this only tells a solution from a stall.
const TOLERANCE: f64 = 1e-12;
const MOST_ITERATIONS: u32 = 30;
const MOST_HALVINGS: u32 = 8;

/// A law at a material point whose directions are given in the axes of control.
pub(super) struct System<'a> {
    pub(super) law: &'a Law,
    pub(super) directions: Vec<Vec3>,
    pub(super) is_incompressible: bool,
    pub(super) scratch: Scratch,
}

/// Stresses at a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stresses {
    pub(super) first_piola: Mat3,
    pub(super) cauchy: Mat3,
    pub(super) h: Mat3,
    pub(super) j: f64,
}

/// A state in equilibrium.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub(super) unknowns: Unknowns,
    pub(super) iterations: u32,
    /// Largest stress residual, Pa.
    pub(super) residual: f64,
    /// Tangent of the last iteration, where the next step begins.
    pub(super) tangent: Tangent,
}

impl System<'_> {
    /// Stresses of the law and the constraint.
    ///
    /// ```text
    /// P = ∂ψ/∂F + q H,    σ = P Fᵀ / J
    /// ```
    pub(super) fn stresses(&mut self, state: &Unknowns) -> Stresses {
        let h = cofactor(&state.f);
        let j = volume_map(&state.f, &h);
        let mut first_piola = [Mat3::zeros()];
        let maps = Maps { f: &[state.f], h: None, j: None };
        self.law.stress(maps, Directions::Uniform(&self.directions), &mut first_piola, &mut self.scratch);
        let first_piola = first_piola[0] + state.q * h;
        Stresses { first_piola, cauchy: first_piola * state.f.transpose() / j, h, j }
    }

    /// Strain energy per reference volume, Pa.
    pub(super) fn density(&mut self, f: &Mat3) -> f64 {
        let mut psi = [0.0];
        let maps = Maps { f: &[*f], h: None, j: None };
        self.law.density(maps, Directions::Uniform(&self.directions), &mut psi, &mut self.scratch);
        psi[0]
    }

    /// The state of rest.
    ///
    /// # Errors
    /// Where the law is not defined there.
    pub(super) fn rest(&mut self) -> Result<Solved, Cause> {
        let unknowns = Unknowns { f: Mat3::identity(), q: 0.0 };
        Ok(Solved { unknowns, iterations: 0, residual: 0.0, tangent: self.tangent(&unknowns)? })
    }

    /// Moves from the equilibrium `from` to one with `target`.
    ///
    /// The prescribed components change first, the free ones along the last tangent of `from`; Newton's
    /// method with step halving does the rest.
    ///
    /// # Errors
    /// Why no equilibrium was reached.
    pub(super) fn solve(&mut self, from: &Solved, target: &Target) -> Result<Solved, Cause> {
        if !target.is_finite() {
            return Err(Cause::TargetNotFinite);
        }
        if self.is_incompressible && target.unknowns().next().is_none() {
            return Err(Cause::NoConditionForPressure);
        }
        let (before, tangent) = (&from.unknowns, &from.tangent);
        let stresses = self.admissible(before)?;
        let scale = tangent.amax();
        let change = target.imposed(&before.f) - before.f;
        let start = Unknowns { f: before.f + change, q: before.q };
        // What the prescribed change does to the stresses enters the first step's right-hand side.
        let right = self.residual(&stresses, target, scale)
            + self.rates(before, &stresses, tangent, &change, target, scale);
        let matrix = self.jacobian(before, &stresses, tangent, target, scale);
        let step = Factors::of(matrix).solve(&right).ok_or(Cause::Singular)?;
        let predicted = moved(&start, &step, -1.0, target, scale);
        // Where the tangent leads out of the law's domain only the prescribed part moves.
        let start = if self.admissible(&predicted).is_ok() { predicted } else { start };
        self.newton(start, target)
    }

    fn newton(&mut self, start: Unknowns, target: &Target) -> Result<Solved, Cause> {
        let mut state = start;
        let mut stresses = self.admissible(&state)?;
        let mut last = f64::INFINITY;
        for iterations in 1..=MOST_ITERATIONS {
            let tangent = self.tangent(&state)?;
            let scale = tangent.amax();
            let mut right = self.residual(&stresses, target, scale);
            let size = right.amax();
            let factors = Factors::of(self.jacobian(&state, &stresses, &tangent, target, scale));
            if size > TOLERANCE {
                let step = factors.solve(&right).ok_or(Cause::Singular)?;
                let stalled =
                    if factors.is_singular() { Cause::Singular } else { Cause::Stalled { residual: size } };
                let better = (0..=MOST_HALVINGS).find_map(|halving| {
                    let part = 1.0 / f64::from(1_u32 << halving);
                    let trial = moved(&state, &step, -part, target, scale);
                    let stresses = self.admissible(&trial).ok()?;
                    let residual = self.residual(&stresses, target, scale);
                    (residual.amax() < size * (1.0 - 1e-4 * part)).then_some((trial, stresses, residual))
                });
                (state, stresses, right) = better.ok_or(stalled)?;
            }
            last = right.amax();
            // Solved: what is left falls to round-off along the tangent at hand.
            while last <= TOLERANCE {
                let trial = factors.solve(&right).map(|step| moved(&state, &step, -1.0, target, scale));
                let next = trial.and_then(|trial| {
                    let stresses = self.admissible(&trial).ok()?;
                    let residual = self.residual(&stresses, target, scale);
                    (residual.amax() < 0.5 * last).then_some((trial, residual))
                });
                match next {
                    Some(better) => (state, right) = better,
                    None => {
                        return Ok(Solved { unknowns: state, iterations, residual: last * scale, tangent });
                    }
                }
                last = right.amax();
            }
        }
        Err(Cause::Stalled { residual: last })
    }

    /// The stresses, where the law is defined.
    fn admissible(&mut self, state: &Unknowns) -> Result<Stresses, Cause> {
        let stresses = self.stresses(state);
        let is_finite = stresses.cauchy.iter().all(|value| value.is_finite());
        if stresses.j > 0.0 && is_finite {
            Ok(stresses)
        } else {
            Err(Cause::Inadmissible { jacobian: stresses.j })
        }
    }

    /// `∂P/∂F` of the law and the constraint, Pa.
    ///
    /// ```text
    /// ∂P/∂F : A = ∂²ψ/∂F∂F : A + q F ⨯ A
    /// ```
    pub(super) fn tangent(&self, state: &Unknowns) -> Result<Tangent, Cause> {
        let mut tangent = self.law.tangent(&state.f, &self.directions, Kink::Slack);
        if self.is_incompressible {
            for place in 0..9 {
                let mut unit = Mat3::zeros();
                unit.as_mut_slice()[place] = 1.0;
                let change = state.q * cross(&state.f, &unit);
                for (row, value) in change.iter().enumerate() {
                    tangent[(row, place)] += value;
                }
            }
        }
        let is_usable = tangent.iter().all(|value| value.is_finite()) && tangent.amax() > 0.0;
        let jacobian = state.f.determinant();
        if is_usable { Ok(tangent) } else { Err(Cause::Inadmissible { jacobian }) }
    }

    /// Stresses less their prescribed values over `scale`, and `J − 1`.
    fn residual(&self, stresses: &Stresses, target: &Target, scale: f64) -> Column {
        let mut residual = Column::zeros();
        for (i, j) in target.unknowns() {
            residual[i + 3 * j] = match target.components[i][j] {
                Control::FirstPiola(wanted) => (stresses.first_piola[(i, j)] - wanted) / scale,
                Control::Cauchy(wanted) => (stresses.cauchy[(i, j)] - wanted) / scale,
                Control::Deformation(_) => 0.0,
            };
        }
        if self.is_incompressible {
            residual[CONSTRAINT] = stresses.j - 1.0;
        }
        residual
    }

    /// Change of the residual when F changes by `change`.
    ///
    /// ```text
    /// δP = ∂P/∂F : δF,    δσ = (δP Fᵀ + P δFᵀ − σ δJ) / J,    δJ = H : δF
    /// ```
    fn rates(
        &self,
        state: &Unknowns,
        stresses: &Stresses,
        tangent: &Tangent,
        change: &Mat3,
        target: &Target,
        scale: f64,
    ) -> Column {
        let column = tangent * SVector::<f64, 9>::from_column_slice(change.as_slice());
        let first_piola = Mat3::from_column_slice(column.as_slice());
        let volume = contract(&stresses.h, change);
        let cauchy = (first_piola * state.f.transpose() + stresses.first_piola * change.transpose()
            - stresses.cauchy * volume)
            / stresses.j;
        let mut rates = Column::zeros();
        for (i, j) in target.unknowns() {
            let rate = match target.components[i][j] {
                Control::FirstPiola(_) => first_piola[(i, j)],
                Control::Cauchy(_) => cauchy[(i, j)],
                Control::Deformation(_) => 0.0,
            };
            rates[i + 3 * j] = rate / scale;
        }
        if self.is_incompressible {
            rates[CONSTRAINT] = volume;
        }
        rates
    }

    /// Derivative of the residual by the free components of F and by `q / scale`.
    pub(super) fn jacobian(
        &self,
        state: &Unknowns,
        stresses: &Stresses,
        tangent: &Tangent,
        target: &Target,
        scale: f64,
    ) -> Matrix {
        let mut matrix = Matrix::identity();
        for (i, j) in target.unknowns() {
            let mut unit = Mat3::zeros();
            unit[(i, j)] = 1.0;
            let rates = self.rates(state, stresses, tangent, &unit, target, scale);
            matrix.set_column(i + 3 * j, &rates);
        }
        if self.is_incompressible {
            let mut column = Column::zeros();
            for (i, j) in target.unknowns() {
                column[i + 3 * j] = match target.components[i][j] {
                    Control::FirstPiola(_) => stresses.h[(i, j)],
                    // q H Fᵀ / J = q I
                    Control::Cauchy(_) => f64::from(u8::from(i == j)),
                    Control::Deformation(_) => 0.0,
                };
            }
            matrix.set_column(CONSTRAINT, &column);
        }
        matrix
    }
}

/// `state` moved by `part` of `step` in its free components.
fn moved(state: &Unknowns, step: &Column, part: f64, target: &Target, scale: f64) -> Unknowns {
    let mut next = *state;
    for (i, j) in target.unknowns() {
        next.f[(i, j)] += part * step[i + 3 * j];
    }
    next.q += part * step[CONSTRAINT] * scale;
    next
}
