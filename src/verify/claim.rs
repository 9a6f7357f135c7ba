//! A claim about mathematics, the number that supports it and the control that must fail.
//!
//! Owns the rule by which a claim is judged. It knows no claim and prints nothing.

use std::fmt;

use super::caught::caught;
use crate::output::Figure;
use serde::Serialize;

/// How far beyond the bound a control must land: a deliberately wrong variant misses tenfold.
pub const CONTROL_FACTOR: f64 = 10.0;

/// What a claim is about; the report groups by it, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Topic {
    /// Text, units, diagnostics.
    Language,
    /// Strain energies, stresses, tangents, wave speeds.
    Energies,
    /// Shapes, stencils, corrected gradients.
    Discretisation,
    /// Momentum, angular momentum, energy, volume.
    Conservation,
    /// The maps F, H, J against the positions they describe.
    Consistency,
    /// Orders of convergence.
    Convergence,
    /// Cases with an independent reference.
    Benchmarks,
    /// Drawings against the tables they are drawn from.
    Figures,
    /// Where a law or a scheme stops being stable.
    Stability,
}

impl Topic {
    /// Every topic, in the order of the report.
    pub const ALL: [Self; 9] = [
        Self::Language,
        Self::Energies,
        Self::Discretisation,
        Self::Conservation,
        Self::Consistency,
        Self::Convergence,
        Self::Benchmarks,
        Self::Figures,
        Self::Stability,
    ];

    /// The topic in one lower-case word, as `tissue verify --topic` takes it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Language => "language",
            Self::Energies => "energies",
            Self::Discretisation => "discretisation",
            Self::Conservation => "conservation",
            Self::Consistency => "consistency",
            Self::Convergence => "convergence",
            Self::Benchmarks => "benchmarks",
            Self::Figures => "figures",
            Self::Stability => "stability",
        }
    }
}

impl fmt::Display for Topic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// When a claim is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tier {
    /// Always: seconds.
    Quick,
    /// With `--full` only: minutes.
    Full,
}

/// One sentence that is true of this program, with the means to find out.
///
/// The claim holds where `measure() <= bound` and the same measure of a deliberately wrong variant
/// exceeds [`CONTROL_FACTOR`] times the bound. A claim whose control passes measures nothing.
#[derive(Debug, Clone, Copy)]
pub struct Claim {
    /// What the claim is about.
    pub topic: Topic,
    /// The claim, a true sentence without a final stop.
    pub claim: &'static str,
    /// Equation, table or work the expected number comes from, for example `NB25 (44)-(45)`.
    pub source: &'static str,
    /// Why the bound is what it is: a count of round-offs, the next term of an expansion.
    pub because: &'static str,
    /// Largest error the claim allows.
    pub bound: f64,
    /// The error of the program as it is.
    pub measure: fn() -> f64,
    /// The error of a deliberately wrong variant: a factor, a sign, a dropped term.
    pub control: fn() -> f64,
}

impl Claim {
    /// Measures the claim and its control; a panic of either is the cause why the claim fails.
    pub fn judge(&self) -> Verdict {
        let (measured, control) = (caught(self.measure), caught(self.control));
        let of = |name: &str, found: &Result<f64, String>| {
            found.as_ref().err().map(|cause| format!("{name} could not be measured: {cause}"))
        };
        let cause = of("it", &measured).or_else(|| of("its control", &control));
        let (measured, control) = (measured.unwrap_or(f64::NAN), control.unwrap_or(f64::NAN));
        Verdict {
            topic: self.topic,
            claim: self.claim.to_owned(),
            source: self.source.to_owned(),
            because: self.because.to_owned(),
            measured,
            bound: self.bound,
            control,
            cause,
            holds: within(measured, self.bound) && misses(control, self.bound),
        }
    }
}

/// A figure that shows what a claim says: an order over spacing, a history over time.
#[derive(Debug, Clone, Copy)]
pub struct Illustration {
    /// The sentence of the claim.
    pub claim: &'static str,
    /// Measures again what is drawn.
    pub figure: fn() -> Figure,
}

/// What became of a [`Claim`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// What the claim is about.
    pub topic: Topic,
    /// The claim.
    pub claim: String,
    /// Where the expected number comes from.
    pub source: String,
    /// Why the bound is what it is.
    pub because: String,
    /// The measured error.
    pub measured: f64,
    /// The largest error allowed.
    pub bound: f64,
    /// The error of the wrong variant.
    pub control: f64,
    /// Why nothing could be measured, where nothing could.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
    /// The measured error is within the bound and the control misses it tenfold.
    pub holds: bool,
}

impl Verdict {
    /// What is wrong with the claim, or `None` where it holds.
    pub fn fault(&self) -> Option<Fault> {
        if let Some(cause) = &self.cause {
            Some(Fault::NotMeasured(cause.clone()))
        } else if !within(self.measured, self.bound) {
            Some(Fault::Exceeded)
        } else if !misses(self.control, self.bound) {
            Some(Fault::ControlPasses)
        } else {
            None
        }
    }
}

/// The ways in which a claim fails.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// The measured error exceeds the bound, or is not a number.
    Exceeded,
    /// The wrong variant does not miss the bound tenfold, so the measure cannot tell it apart.
    ControlPasses,
    /// What it is about could not be set up or did not run to its end.
    NotMeasured(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exceeded => "the measured error exceeds the bound",
            Self::ControlPasses => "the control does not miss the bound tenfold",
            Self::NotMeasured(cause) => cause,
        })
    }
}

/// An error is within a bound only if it is a number and no larger; errors are never negative.
fn within(measured: f64, bound: f64) -> bool {
    (0.0..=bound).contains(&measured)
}

/// A control counts only where it is a number.
fn misses(control: f64, bound: f64) -> bool {
    control > CONTROL_FACTOR * bound
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(bound: f64, measure: fn() -> f64, control: fn() -> f64) -> Verdict {
        let topic = Topic::Energies;
        Claim { topic, claim: "c", source: "s", because: "b", bound, measure, control }.judge()
    }

    #[test]
    fn a_claim_holds_at_its_bound_and_fails_above_it() {
        assert!(claim(1e-14, || 1e-14, || 1.0).holds);
        assert_eq!(claim(1e-14, || 1.1e-14, || 1.0).fault(), Some(Fault::Exceeded));
    }

    #[test]
    fn a_control_within_ten_bounds_fails_the_claim() {
        assert_eq!(claim(0.5, || 0.1, || 5.0).fault(), Some(Fault::ControlPasses));
        assert!(claim(0.5, || 0.1, || 5.1).holds);
    }

    #[test]
    fn an_error_that_is_no_number_or_negative_holds_nothing() {
        assert!(!claim(1.0, || f64::NAN, || 100.0).holds);
        assert!(!claim(1.0, || -1.0, || 100.0).holds);
        assert!(!claim(1.0, || 0.1, || f64::NAN).holds);
    }

    #[test]
    fn a_claim_that_cannot_be_measured_fails_and_says_why() {
        let measured = claim(1.0, || panic!("the cube\n  stopped"), || 100.0);
        assert!(!measured.holds && measured.measured.is_nan() && measured.control == 100.0);
        let told = measured.fault().map(|fault| fault.to_string());
        assert_eq!(told.as_deref(), Some("it could not be measured: the cube stopped"));
        let control = claim(1.0, || 0.5, || panic!("the cube stopped"));
        assert!(!control.holds && control.measured == 0.5);
        let told = control.fault().map(|fault| fault.to_string());
        assert_eq!(told.as_deref(), Some("its control could not be measured: the cube stopped"));
    }

    #[test]
    fn an_exact_claim_has_bound_zero_and_any_error_as_control() {
        assert!(claim(0.0, || 0.0, || 1e-300).holds);
        assert_eq!(claim(0.0, || 0.0, || 0.0).fault(), Some(Fault::ControlPasses));
    }
}
