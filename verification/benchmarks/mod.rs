//! Claims about cases with an independent reference.

use super::Claim;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[];
