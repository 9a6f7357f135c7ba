//! Claims about parameters found from data.

use super::Claim;

mod recovery;
mod response;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] =
    &[response::COMPRESSIBLE, response::INCOMPRESSIBLE, recovery::LINE, recovery::ERRORS];

#[cfg(test)]
mod tests {
    #[test]
    fn every_claim_on_fits_holds() {
        let verdicts: Vec<_> = super::CLAIMS.iter().map(super::Claim::judge).collect();
        for verdict in &verdicts {
            println!(
                "{}: {:.2e} of {:.2e}, control {:.2e}",
                verdict.claim, verdict.measured, verdict.bound, verdict.control
            );
        }
        let failed: Vec<_> = verdicts.iter().filter(|verdict| !verdict.holds).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }
}
