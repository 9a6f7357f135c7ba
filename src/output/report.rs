//! What a run did, as `run.json`.
//!
//! Owns the fields of the report and their names in JSON. It judges nothing.

use serde::{Deserialize, Serialize};

use super::provenance::Provenance;

/// Everything about a run but its tables and frames.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RunReport {
    /// Program version, input file, hash and scene.
    #[serde(flatten)]
    pub provenance: Provenance,
    /// The plan, line by line as `tissue plan` prints it.
    pub plan: Vec<String>,
    /// Every numerical choice in force.
    pub choices: Vec<Choice>,
    /// Number of particles.
    pub particles: u64,
    /// Time steps taken.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
    /// End time reached, s.
    pub end_time: f64,
    /// Wall time of the stepping, s.
    pub wall_seconds: f64,
    /// Particles times evaluations of the right-hand side over wall time, 1/s.
    pub updates_per_second: f64,
    /// Conserved totals at start and end.
    pub totals: Vec<TotalChange>,
    /// What became of the energy; absent where nothing was run.
    #[serde(default)]
    pub balance: Balance,
    /// The verdict on every `expect` line.
    pub expectations: Vec<ExpectationVerdict>,
    /// Files written, relative to the folder of the report.
    pub files: Vec<String>,
    /// How the run ended.
    pub status: RunStatus,
}

/// A numerical choice and its reason.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Choice {
    /// The key of the `run` block.
    pub key: String,
    /// The value in force.
    pub value: String,
    /// Why: stated on a line of the scene, or the default of a scheme.
    pub why: String,
}

/// A conserved total, the whole body's.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TotalChange {
    /// Its name: `momentum_x`, `energy`, `volume`.
    pub name: String,
    /// SI unit symbol.
    pub unit: String,
    /// At the start.
    pub start: f64,
    /// At the end.
    pub end: f64,
}

/// Where the energy of a run came from and went, the whole body's.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Balance {
    /// Energy at the start, J.
    pub start: f64,
    /// Kinetic energy at the end, J.
    pub kinetic: f64,
    /// Strain energy at the end, J.
    pub strain: f64,
    /// Energy at the end of the springs against displacements that no gradient sees, J.
    pub springs: f64,
    /// Work of the loads, J.
    pub loads: f64,
    /// Work of the supports, J.
    pub supports: f64,
    /// What the dissipation of momentum took, J.
    pub dissipated: f64,
    /// What the damping of quasi-static loading took, J.
    pub damped: f64,
    /// What is not accounted for, J.
    pub residual: f64,
    /// Smallest volume map at the end.
    pub smallest_j: f64,
}

impl Balance {
    /// Residual over the largest entry of the balance; zero where there is no energy.
    pub fn relative_residual(&self) -> f64 {
        let entries = [self.start, self.kinetic, self.strain, self.loads, self.supports, self.dissipated];
        let largest = entries.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        if largest > 0.0 { self.residual / largest } else { 0.0 }
    }

    /// Kinetic over strain energy; zero where there is no motion.
    pub fn kinetic_over_strain(&self) -> f64 {
        if self.kinetic > 0.0 { self.kinetic / self.strain } else { 0.0 }
    }

    /// Energy of what no gradient sees over strain energy; zero where there is none.
    pub fn unseen_share(&self) -> f64 {
        if self.springs > 0.0 { self.springs / self.strain } else { 0.0 }
    }
}

/// The verdict on one `expect` line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ExpectationVerdict {
    /// The line as written.
    pub text: String,
    /// Where it stands: `file:line`.
    pub place: String,
    /// The measured value, worst of several; absent where nothing could be measured.
    pub measured: Option<f64>,
    /// What it is held against.
    pub bound: f64,
    /// Unit of both, empty for a number.
    pub unit: String,
    /// The expectation holds.
    pub holds: bool,
    /// What was in the way of measuring, or at which sample the worst value was found.
    pub note: String,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum RunStatus {
    /// It did not end; a report with this status was left by an interruption.
    #[default]
    Unfinished,
    /// It reached its end time and every expectation holds.
    Held,
    /// It reached its end time, and an expectation does not hold.
    ExpectationFailed,
    /// The user stopped it before its end time.
    Interrupted,
    /// It stopped before its end time.
    Stopped {
        /// What, where and when.
        cause: String,
    },
}

impl RunReport {
    /// The report as indented JSON with a final line break.
    ///
    /// A number that is not finite becomes `null`, since JSON has no other word for it.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("every field has a JSON form");
        text.push('\n');
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report() -> RunReport {
        RunReport {
            provenance: Provenance {
                version: "0.1.0".into(),
                ..Provenance::new("specs/artery/axial.tissue", "00ff", "axial")
            },
            plan: vec!["+ Momentum            conserved in every scene".into()],
            choices: vec![Choice { key: "cfl".into(), value: "0.9".into(), why: "line 23".into() }],
            particles: 1599,
            totals: vec![TotalChange { name: "energy".into(), unit: "J".into(), start: 0.0, end: 1e-3 }],
            expectations: vec![ExpectationVerdict {
                text: "pull.d == fe.d within 0.5 %".into(),
                place: "specs/artery/axial.tissue:44".into(),
                measured: Some(0.0021),
                bound: 0.005,
                unit: String::new(),
                holds: true,
                note: "at pull.F = 1 N".into(),
            }],
            status: RunStatus::Stopped { cause: "volume map J is not positive".into() },
            ..RunReport::default()
        }
    }

    #[test]
    fn a_report_reads_back_equal_and_a_changed_one_does_not() {
        let text = report().to_json();
        let back: RunReport = serde_json::from_str(&text).expect("our own JSON");
        assert_eq!(back, report());
        let changed = text.replace("1599", "1600");
        assert_ne!(serde_json::from_str::<RunReport>(&changed).expect("JSON"), report());
    }

    #[test]
    fn a_report_names_its_fields_in_words() {
        insta::assert_snapshot!(report().to_json());
    }
}
