//! Verdicts as a table for the terminal and as JSON.
//!
//! Owns the two forms. It judges nothing and prints nothing.

use serde::Serialize;

use super::claim::{Claim, Topic, Verdict};
use crate::output::provenance::VERSION;

/// The verdicts on a list of claims.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// Version of the program that was measured.
    pub version: String,
    /// Every claim holds, and there is one.
    pub holds: bool,
    /// The verdicts, by topic and within a topic in the order of the list.
    pub claims: Vec<Verdict>,
}

impl Report {
    /// Measures every claim of `claims` and its control.
    pub fn of(claims: &[Claim]) -> Self {
        Self::from_verdicts(claims.iter().map(Claim::judge).collect())
    }

    /// The report on verdicts that exist already, such as those of `expect` lines.
    pub fn from_verdicts(mut claims: Vec<Verdict>) -> Self {
        claims.sort_by_key(|verdict| verdict.topic);
        let holds = !claims.is_empty() && claims.iter().all(|verdict| verdict.holds);
        Self { version: VERSION.into(), holds, claims }
    }

    /// The report as indented JSON with a final line break; a number that is none becomes `null`.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("every field has a JSON form");
        text.push('\n');
        text
    }

    /// The report as a table for the terminal, a block a topic, faults spelled out.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for topic in Topic::ALL {
            let claims: Vec<&Verdict> = self.claims.iter().filter(|v| v.topic == topic).collect();
            if claims.is_empty() {
                continue;
            }
            text.push_str(&format!("{topic}\n"));
            for verdict in claims {
                text.push_str(&lines(verdict));
            }
            text.push('\n');
        }
        let held = self.claims.iter().filter(|verdict| verdict.holds).count();
        text.push_str(&format!("{held} of {} claims hold\n", self.claims.len()));
        text
    }
}

/// A claim's sentence and numbers, and its fault where it has one.
fn lines(verdict: &Verdict) -> String {
    let mark = if verdict.holds { "holds" } else { "FAILS" };
    let Verdict { claim, source, because, measured, bound, control, .. } = verdict;
    let mut text = format!(
        "  {mark}  {claim}  [{source}]\n         measured {measured:.2e}  bound {bound:.2e}  control {control:.2e}\n"
    );
    if verdict.cause.is_some() {
        text.push_str(&verdict.fault().map_or_else(String::new, |fault| format!("         {fault}\n")));
    } else if let Some(fault) = verdict.fault() {
        text.push_str(&format!("         {fault}; the bound is {because}\n"));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIMS: [Claim; 2] = [
        Claim {
            topic: Topic::Conservation,
            claim: "total momentum stays zero",
            source: "NB25 (32)",
            because: "10^4 additions, each rounded to 1.1e-16 of the largest term",
            bound: 1e-12,
            measure: || 3e-15,
            control: || 0.25,
        },
        Claim {
            topic: Topic::Energies,
            claim: "derived stresses equal the closed form",
            source: "NB25 (44)-(45)",
            because: "50 operations, each rounded to 1.1e-16",
            bound: 1e-14,
            measure: || 2.48e-16,
            control: || 9.99e-4,
        },
    ];

    #[test]
    fn a_report_groups_claims_by_topic_with_their_numbers() {
        let report = Report { version: "0.1.0".into(), ..Report::of(&CLAIMS) };
        assert!(report.holds);
        insta::assert_snapshot!("text", report.to_text());
        insta::assert_snapshot!("json", report.to_json());
    }

    #[test]
    fn one_broken_claim_or_none_at_all_makes_a_report_that_does_not_hold() {
        let mut claims = CLAIMS;
        claims[1].bound = 1e-16;
        let report = Report::of(&claims);
        assert!(!report.holds);
        insta::assert_snapshot!("broken", report.to_text());
        claims[1] = Claim { control: || 2e-14, ..CLAIMS[1] };
        let report = Report::of(&claims);
        assert!(!report.holds);
        assert!(report.to_text().contains("the control does not miss the bound tenfold"));
        assert!(!Report::of(&[]).holds);
    }

    #[test]
    fn a_claim_that_panics_is_named_with_its_cause_and_the_others_are_measured() {
        let stopped =
            Claim { claim: "one that stops", measure: || panic!("J <= 0 at particle 3"), ..CLAIMS[0] };
        let report = Report { version: "0.1.0".into(), ..Report::of(&[stopped, CLAIMS[0], CLAIMS[1]]) };
        assert!(!report.holds);
        insta::assert_snapshot!("stopped", report.to_text());
        insta::assert_snapshot!("stopped_json", report.to_json());
    }

    #[test]
    fn an_error_that_is_no_number_is_null_in_json_and_holds_nothing() {
        let report = Report::of(&[Claim { measure: || f64::NAN, ..CLAIMS[0] }]);
        assert!(!report.holds);
        assert!(report.to_json().contains("\"measured\": null"));
    }
}
