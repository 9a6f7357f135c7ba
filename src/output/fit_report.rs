//! What a fit found, as `run.json` and as tables of names and numbers.
//!
//! Owns the fields of the report and their names in JSON. It judges nothing.

use serde::{Deserialize, Serialize};

use super::provenance::Provenance;
use super::report::{ExpectationVerdict, RunStatus};
use super::table::number;

/// Everything about a fit but its tables. Numbers are SI.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FitReport {
    /// Program version, input file, hash and fit.
    #[serde(flatten)]
    pub provenance: Provenance,
    /// How data count against each other.
    pub weights: String,
    /// Data whose differences are added.
    pub data: u64,
    /// The parameters.
    pub parameters: Vec<FittedParameter>,
    /// Correlation of the estimates; absent where one has no standard error.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Largest over smallest eigenvalue of the scaled normal equations; absent if singular.
    pub condition: Option<f64>,
    /// Standard deviation of one weighted difference.
    pub deviation: Option<f64>,
    /// Share of the weighted spread of the data that the fit explains.
    pub r_squared: f64,
    /// Sum of the squared residuals at the start.
    pub first_sum: f64,
    /// Sum of the squared residuals.
    pub sum: f64,
    /// What was measured and how well it is met.
    pub columns: Vec<ColumnFit>,
    /// What is to be told, in sentences.
    pub findings: Vec<String>,
    /// Steps of the minimisation.
    pub steps: u64,
    /// Evaluations of all drives.
    pub evaluations: u64,
    /// Why the minimisation ended.
    pub ending: String,
    /// Wall time, s.
    pub wall_seconds: f64,
    /// The verdict on every `expect` line.
    pub expectations: Vec<ExpectationVerdict>,
    /// Files written, relative to the folder of the report.
    pub files: Vec<String>,
    /// How the fit ended.
    pub status: RunStatus,
}

/// One fitted parameter.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FittedParameter {
    /// Its name as written: `gel.mu`.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// Its standard error; absent where the data do not give one.
    pub standard_error: Option<f64>,
    /// The value it started from.
    pub start: f64,
    /// Lower end of its range.
    pub lower: Option<f64>,
    /// Upper end of its range.
    pub upper: Option<f64>,
    /// Whether it was stopped by an end of its range.
    pub at_bound: bool,
}

/// How well one column of data is met.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ColumnFit {
    /// The drive.
    pub drive: String,
    /// What was measured.
    pub column: String,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// Its data.
    pub data: u64,
    /// Root mean square of the differences, not weighted.
    pub rms_difference: f64,
    /// Share of the column's spread the fit explains.
    pub r_squared: f64,
}

impl FitReport {
    /// The report as indented JSON with a final line break; a number that is none becomes `null`.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("every field has a JSON form");
        text.push('\n');
        text
    }

    /// The parameters as CSV, a row each; an entry that does not exist is empty.
    pub fn parameters_csv(&self) -> String {
        let mut text = self.head();
        text.push_str("parameter,value,unit,standard_error,start,lower,upper,at_bound\n");
        for parameter in &self.parameters {
            let FittedParameter { name, value, unit, standard_error, start, lower, upper, at_bound } =
                parameter;
            let (value, start) = (number(*value), number(*start));
            let [error, lower, upper] = [standard_error, lower, upper].map(|value| optional(*value));
            text.push_str(&format!("{name},{value},{unit},{error},{start},{lower},{upper},{at_bound}\n"));
        }
        text
    }

    /// The correlation matrix as CSV with the parameters as head and first column.
    pub fn correlation_csv(&self) -> String {
        let mut text = self.head();
        let names: Vec<&str> = self.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        text.push_str(&format!("parameter,{}\n", names.join(",")));
        for (name, row) in names.iter().zip(&self.correlation) {
            let row: Vec<String> = row.iter().map(|value| optional(*value)).collect();
            text.push_str(&format!("{name},{}\n", row.join(",")));
        }
        text
    }

    fn head(&self) -> String {
        self.provenance.lines().iter().map(|line| format!("# {line}\n")).collect()
    }
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, number)
}
