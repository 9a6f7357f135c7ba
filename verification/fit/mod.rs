//! Claims about parameters found from data.

use super::Claim;

mod recovery;
mod response;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] =
    &[response::COMPRESSIBLE, response::INCOMPRESSIBLE, recovery::LINE, recovery::ERRORS];
