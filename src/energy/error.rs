//! What can be wrong with a law or a state of it.

use std::fmt;

/// Why a law could not be compiled, or a quantity of it not be computed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum EnergyError {
    /// The energy's tape has no node.
    Empty,
    /// The energy reads a parameter that was not supplied.
    MissingParameter {
        /// Index the energy reads.
        index: u32,
        /// Number of parameters supplied.
        supplied: usize,
    },
    /// The energy reads a principal stretch that does not exist.
    NoSuchStretch {
        /// Index the energy reads; 0, 1 and 2 exist.
        index: u8,
    },
    /// An exact motion is asked of an energy of principal stretches.
    StretchOfMotion,
    /// An exact motion is asked of an energy that integrates over directions.
    IntegralOfMotion,
    /// The tangent is not finite at this state, so no wave speed exists.
    NonFiniteTangent {
        /// Volume map of the state.
        jacobian: f64,
    },
    /// The acoustic tensor has no positive eigenvalue in any direction: no wave travels.
    NoWave {
        /// Largest eigenvalue found, Pa.
        largest: f64,
    },
}

impl fmt::Display for EnergyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "the energy is empty"),
            Self::MissingParameter { index, supplied } => {
                write!(f, "the energy reads parameter {index}, but {supplied} are supplied")
            }
            Self::NoSuchStretch { index } => {
                write!(f, "the energy reads principal stretch {index}; 0, 1 and 2 exist")
            }
            Self::IntegralOfMotion => write!(
                f,
                "the body force of an exact motion cannot be derived from an integral over directions; \
                 sum over a few fibres instead"
            ),
            Self::StretchOfMotion => write!(
                f,
                "the body force of an exact motion cannot be derived from principal stretches; \
                 write the energy in I1, I2, J and the invariants of directions"
            ),
            Self::NonFiniteTangent { jacobian } => {
                write!(f, "the tangent of the energy is not finite at J = {jacobian:.6e}")
            }
            Self::NoWave { largest } => {
                write!(f, "no wave travels: the largest acoustic eigenvalue is {largest:.6e} Pa")
            }
        }
    }
}

impl std::error::Error for EnergyError {}
