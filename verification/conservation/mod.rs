//! Claims about momentum, angular momentum, energy and volume.

use super::Claim;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[];
