//! Claims about strain energies, their stresses, tangents and wave speeds.

use super::Claim;
use crate::verify::claim::Illustration;

mod audits;
mod closed_forms;
mod derivatives;
mod integrals;
mod known_values;
pub(crate) mod laws;
mod stretches;

/// Figures of these claims.
pub(crate) const ILLUSTRATIONS: &[Illustration] = &[derivatives::ORDER_FIGURE];

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    closed_forms::NEO_HOOKE,
    derivatives::BY_HAND,
    derivatives::DIRECT,
    derivatives::ORDER,
    derivatives::SYMMETRY,
    derivatives::OBJECTIVITY,
    derivatives::STRESS_FREE,
    known_values::MATRIX_WAVE_SPEED,
    known_values::HYDROSTATIC,
    known_values::BLIND_FIBRE,
    known_values::COMPRESSED_FIBRE,
    known_values::WAVE_SPEEDS,
    known_values::FASTEST_WAVE,
    known_values::WAVE_ESTIMATE,
    known_values::PULLED_STRIP,
    audits::OBLIQUE,
    stretches::EQUAL_STRETCHES,
    stretches::EQUAL_STRETCHES_TANGENT,
    stretches::REAL_EXPONENTS,
    integrals::SPHERE,
    integrals::STRETCHED,
    integrals::STRETCHED_STRESS,
    integrals::SLOPE,
    integrals::SLOPE_STRESS,
    audits::MODULI,
    audits::ONE_SIDED,
    audits::GROWTH,
    audits::CONVEXITY,
    audits::BAKER_ERICKSEN,
    audits::ELLIPTICITY,
    audits::MATRIX_CARRIES,
    audits::OVERFLOW,
];

#[cfg(test)]
mod tests {
    #[test]
    fn every_claim_on_energies_holds() {
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
