//! What a drive did, as `run.json`.
//!
//! Owns the fields of the report and their names in JSON. It judges nothing.

use serde::{Deserialize, Serialize};

use super::provenance::Provenance;
use super::report::{ExpectationVerdict, RunStatus};

/// Everything about a drive but its tables.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DriveReport {
    /// Program version, input file, hash and drive.
    #[serde(flatten)]
    pub provenance: Provenance,
    /// The material.
    pub material: String,
    /// The path as written.
    pub path: String,
    /// Whether `J = 1` was held exactly.
    pub incompressible: bool,
    /// Points reached, the first included.
    pub points: u64,
    /// Newton iterations over all points.
    pub iterations: u64,
    /// Largest difference between a stress and its prescribed value over all points, Pa.
    pub largest_residual: f64,
    /// Wall time of law, path and tables, s.
    pub wall_seconds: f64,
    /// The verdict on every `expect` line.
    pub expectations: Vec<ExpectationVerdict>,
    /// Files written, relative to the folder of the report.
    pub files: Vec<String>,
    /// How the drive ended.
    pub status: RunStatus,
}

impl DriveReport {
    /// The report as indented JSON with a final line break.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("every field has a JSON form");
        text.push('\n');
        text
    }
}
