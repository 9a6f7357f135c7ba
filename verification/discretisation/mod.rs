//! Claims about shapes, stencils and corrected gradients.

use super::Claim;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[];
