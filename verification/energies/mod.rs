//! Claims about strain energies, their stresses, tangents and wave speeds.

use super::Claim;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[];
