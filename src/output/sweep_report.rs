//! What a sweep did, as `run.json`.
//!
//! Owns the fields of the report and their names in JSON. It judges nothing.

use serde::{Deserialize, Serialize};

use super::provenance::Provenance;
use super::report::{ExpectationVerdict, RunStatus};

/// Everything about a sweep but its tables.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweepReport {
    /// Program version, input file, hash and sweep.
    #[serde(flatten)]
    pub provenance: Provenance,
    /// The scene or drive.
    pub of: String,
    /// The paths that vary.
    pub varied: Vec<String>,
    /// What each point was and did.
    pub points: Vec<PointReport>,
    /// Wall time of all points, s.
    pub wall_seconds: f64,
    /// The verdict on every `expect` line of the sweep.
    pub expectations: Vec<ExpectationVerdict>,
    /// Files written, relative to the folder of the report.
    pub files: Vec<String>,
    /// How the sweep ended.
    pub status: RunStatus,
}

/// One point of a sweep.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PointReport {
    /// The varied values as written: `strip.spacing = 0.5 mm`.
    pub values: Vec<String>,
    /// Particles, of a scene.
    pub particles: u64,
    /// Time steps, of a scene.
    pub steps: u64,
    /// Evaluations of the right-hand side, of a scene.
    pub evaluations: u64,
    /// The verdict on the `expect` lines of the scene or drive itself; they do not decide the sweep.
    pub expectations: Vec<ExpectationVerdict>,
    /// Why it stopped early, if it did.
    pub stopped: Option<String>,
}

impl SweepReport {
    /// The report as indented JSON with a final line break.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("every field has a JSON form");
        text.push('\n');
        text
    }
}
