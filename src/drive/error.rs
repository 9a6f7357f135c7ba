//! Why a drive stopped.

use std::fmt;

use crate::tensor::{Mat3, Vec3};

/// Why a material point could not be driven to where it should go.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DriveError {
    /// A prescribed value is infinite or not a number.
    NotFinite {
        /// Parameter of the path.
        parameter: f64,
    },
    /// The axes of control are not two unit vectors at a right angle.
    Frame {
        /// The first axis.
        first: Vec3,
        /// The second axis.
        second: Vec3,
    },
    /// The law is incompressible and all of F is prescribed, so the pressure has no condition.
    PressureUndetermined {
        /// Parameter of the path.
        parameter: f64,
    },
    /// The first point of the path was not reached from rest.
    NoStart {
        /// Its parameter.
        wanted: f64,
        /// Part of the way from rest that was covered.
        part: f64,
        /// Deformation gradient there, in the axes of control.
        f: Mat3,
        /// What went wrong in the last attempt.
        cause: Cause,
    },
    /// No equilibrium was found beyond a parameter, however short the step.
    NoEquilibrium {
        /// Last parameter of the path with an equilibrium.
        reached: f64,
        /// Parameter asked for.
        wanted: f64,
        /// Deformation gradient at `reached`, in the axes of control.
        f: Mat3,
        /// What went wrong in the last attempt.
        cause: Cause,
    },
}

/// What went wrong in an attempt at equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// The law gives no finite stress or tangent, or `J <= 0`.
    Inadmissible {
        /// Volume map of the state.
        jacobian: f64,
    },
    /// The equations have no unique solution: a rotation or a limit point.
    Singular,
    /// A prescribed value is infinite or not a number.
    TargetNotFinite,
    /// All of F is prescribed, but the stress of a constraint needs a condition.
    NoConditionForPressure,
    /// The equations are met only far from the state before: on another branch, or by running away.
    Leap {
        /// `|(F − F₀) F₀⁻¹|` from the equilibrium before.
        change: f64,
    },
    /// The iteration stopped short of the tolerance.
    Stalled {
        /// Largest residual, of the largest entry of the tangent.
        residual: f64,
    },
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inadmissible { jacobian } => {
                write!(f, "the law has no finite stress at J = {jacobian:.6e}")
            }
            Self::Singular => write!(f, "the tangent is singular"),
            Self::TargetNotFinite => write!(f, "a prescribed value is not finite"),
            Self::NoConditionForPressure => write!(f, "the pressure has no condition"),
            Self::Leap { change } => {
                write!(
                    f,
                    "the equations are met only by a leap of F by {change:.3e} of itself, so the prescribed \
                     values may contradict one another"
                )
            }
            Self::Stalled { residual } => write!(f, "the residual stays at {residual:.3e}"),
        }
    }
}

/// The last deformation gradient of a drive, for a message.
struct Last<'a>(&'a Mat3);

impl fmt::Display for Last<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = self.0;
        write!(
            f,
            "the last has F = [{:.4}, {:.4}, {:.4}; {:.4}, {:.4}, {:.4}; {:.4}, {:.4}, {:.4}]",
            at.m11, at.m12, at.m13, at.m21, at.m22, at.m23, at.m31, at.m32, at.m33
        )
    }
}

impl fmt::Display for DriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { parameter } => {
                write!(f, "a prescribed value is not finite at parameter {parameter:.6e}")
            }
            Self::Frame { first, second } => write!(
                f,
                "axes ({}, {}, {}) and ({}, {}, {}) are not unit vectors at a right angle",
                first.x, first.y, first.z, second.x, second.y, second.z
            ),
            Self::PressureUndetermined { parameter } => write!(
                f,
                "all of F is prescribed at parameter {parameter:.6e}, so the pressure of an incompressible \
                 law is not determined"
            ),
            Self::NoStart { wanted, part, f: at, cause } => write!(
                f,
                "no equilibrium at parameter {wanted:.6e}: from rest {:.4} % of the way were covered, then \
                 {cause}; {}",
                100.0 * part,
                Last(at)
            ),
            Self::NoEquilibrium { reached, wanted, f: at, cause } => write!(
                f,
                "no equilibrium between parameters {reached:.6e} and {wanted:.6e}: {cause}; {}",
                Last(at)
            ),
        }
    }
}

impl std::error::Error for DriveError {}
