//! Every quick claim of this program holds, and the control of each fails.

use std::sync::LazyLock;

use tissue::verify::claim::Fault;
use tissue::verify::{Claim, Report, Verdict, full, quick};

/// Measured once for all tests of this file.
static REPORT: LazyLock<Report> = LazyLock::new(|| Report::of(&quick()));

#[test]
fn every_quick_claim_holds_and_its_control_fails() {
    assert!(REPORT.holds, "\n{}", REPORT.to_text());
}

#[test]
fn every_claim_is_a_sentence_with_a_source_a_reason_and_a_bound() {
    for Claim { claim, source, because, bound, .. } in quick().into_iter().chain(full()) {
        for text in [claim, source, because] {
            assert!(!text.is_empty() && !text.ends_with('.') && text.trim() == text, "`{text}` of `{claim}`");
        }
        assert!(claim.contains(' '), "`{claim}` is no sentence");
        assert!(bound.is_finite() && bound >= 0.0, "`{claim}` has the bound {bound}");
    }
}

#[test]
fn no_two_claims_say_the_same() {
    let mut sentences: Vec<&str> = quick().iter().chain(&full()).map(|claim| claim.claim).collect();
    let all = sentences.len();
    sentences.sort_unstable();
    sentences.dedup();
    assert_eq!(sentences.len(), all);
}

#[test]
fn each_claim_would_fail_with_a_lower_bound_and_with_a_control_that_measures_the_same() {
    for verdict in &REPORT.claims {
        let stricter = Verdict { bound: -1.0, ..verdict.clone() };
        assert_eq!(stricter.fault(), Some(Fault::Exceeded), "{}", verdict.claim);
        let measures_nothing = Verdict { control: verdict.measured, ..verdict.clone() };
        assert_eq!(measures_nothing.fault(), Some(Fault::ControlPasses), "{}", verdict.claim);
    }
}
