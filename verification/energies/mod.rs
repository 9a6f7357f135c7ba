//! Claims about strain energies, their stresses, tangents and wave speeds.

use super::Claim;

mod closed_forms;
mod known_values;
pub(crate) mod laws;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] =
    &[closed_forms::NEO_HOOKE, known_values::MATRIX_WAVE_SPEED, known_values::HYDROSTATIC];
