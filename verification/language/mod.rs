//! Claims about what a text means as numbers.

use super::Claim;

mod numbers;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[numbers::PRECEDENCE, numbers::UNITS];
