//! Claims about drawings against the tables they are drawn from.

use super::Claim;

mod curves;
mod dimensions;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[curves::DRAWN_AS_TABULATED, dimensions::DRAWN_TO_SCALE];
