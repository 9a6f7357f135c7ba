//! Plans of what has no particles: drives and fits.

use crate::fit::{Bound, Range};
use crate::scene::{Drive, Fit, VolumeChange, Weighing};
use std::fmt;

/// What a drive computes.
#[derive(Debug, Clone, Copy)]
pub struct DrivePlan<'a>(pub &'a Drive);

/// What a fit computes.
#[derive(Debug, Clone, Copy)]
pub struct FitPlan<'a>(pub &'a Fit);

impl fmt::Display for DrivePlan<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let drive = self.0;
        writeln!(f, "drive {}", drive.name)?;
        line(f, "material", &drive.material.name)?;
        line(f, "path", &drive.written)?;
        let volume = match drive.volume {
            VolumeChange::Compressible => "compressible: J follows from the law",
            VolumeChange::Incompressible => "incompressible: J = 1, a hydrostatic stress as further unknown",
        };
        line(f, "volume", volume)?;
        line(f, "points", &format!("{}, no particles and no time", drive.steps + 1))?;
        let columns: usize = drive.records.iter().map(|record| record.columns.len()).sum();
        line(f, "recorded", &format!("{columns} columns in {} tables", drive.records.len()))
    }
}

impl fmt::Display for FitPlan<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fit = self.0;
        writeln!(f, "fit {}", fit.name)?;
        writeln!(f, "parameters")?;
        for varied in &fit.vary {
            let unit = if varied.unit.is_empty() { String::new() } else { format!(" {}", varied.unit) };
            let range = range(&varied.range);
            line(f, &varied.name, &format!("from {:e}{unit}, {range}", varied.start))?;
        }
        writeln!(f, "data")?;
        for set in &fit.sets {
            let low = set.abscissae.iter().copied().fold(f64::INFINITY, f64::min);
            let high = set.abscissae.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let names: Vec<&str> = set.columns.iter().map(|column| column.name.as_str()).collect();
            let text = format!(
                "{} of {} at {} {low} .. {high}, from {}",
                set.abscissae.len(),
                names.join(", "),
                set.drive.parameter,
                set.source
            );
            line(f, &set.drive.name, &text)?;
        }
        writeln!(f, "sum of squares")?;
        let weights = match fit.weighing {
            Weighing::Column => "column: differences over the root mean square of their column",
            Weighing::Uniform => "uniform: differences as they are",
            Weighing::Relative => "relative: differences over their datum",
        };
        line(f, "weights", weights)?;
        let residuals: usize = fit.sets.iter().map(|set| set.columns.len() * set.abscissae.len()).sum();
        line(f, "residuals", &format!("{residuals} for {} parameters", fit.vary.len()))?;
        line(f, "derivatives", "by num-dual and implicit differentiation of each equilibrium")?;
        line(f, "each step", &format!("drives {} paths once", fit.sets.len()))
    }
}

fn line(f: &mut fmt::Formatter<'_>, what: &str, text: &str) -> fmt::Result {
    writeln!(f, "    {what:<24}{text}")
}

/// `0 <= value < 0.333`
fn range(range: &Range) -> String {
    let sign = |end: &Bound| if end.is_excluded { "<" } else { "<=" };
    match (&range.lower, &range.upper) {
        (None, None) => "any value".into(),
        (Some(low), None) => format!("{:e} {} value", low.value, sign(low)),
        (None, Some(high)) => format!("value {} {:e}", sign(high), high.value),
        (Some(low), Some(high)) => {
            format!("{:e} {} value {} {:e}", low.value, sign(low), sign(high), high.value)
        }
    }
}
