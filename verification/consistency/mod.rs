//! Claims about the maps F, H and J against the positions they describe.

use super::Claim;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[];
