//! Error against cost: which settings no other beats.

use crate::output::Table;
use crate::scene::Sweep;

/// One setting of a trade.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// The varied values as written, by path.
    pub values: Vec<String>,
    /// Magnitude of the error, SI.
    pub error: f64,
    /// What it costs.
    pub cost: f64,
    /// Whether no other is at least as good in both and better in one.
    pub on_front: bool,
    /// Whether the error is within the tolerance.
    pub allowed: bool,
}

/// The settings of a trade from its table, whose last two columns are error and cost.
pub fn settings(sweep: &Sweep, table: &Table) -> Vec<Setting> {
    let tolerance = sweep.trade.as_ref().and_then(|trade| trade.tolerance);
    let named = |row: &[f64]| {
        let varied = sweep.varied.iter().zip(row);
        varied
            .map(|(varied, value)| {
                let found = varied.values.iter().find(|known| known.value == *value);
                format!("{} = {}", varied.path, found.map_or("", |known| known.text.as_str()))
            })
            .collect()
    };
    let pairs: Vec<(f64, f64)> =
        table.rows.iter().map(|row| (row[row.len() - 2], row[row.len() - 1])).collect();
    let on_front = front(&pairs);
    table
        .rows
        .iter()
        .zip(pairs.iter().zip(on_front))
        .map(|(row, (&(error, cost), on_front))| Setting {
            values: named(row),
            error,
            cost,
            on_front,
            allowed: tolerance.is_some_and(|tolerance| error <= tolerance),
        })
        .collect()
}

/// Which pairs no other is at least as small in both and smaller in one.
pub fn front(pairs: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    pairs.iter().map(|pair| !pairs.iter().any(|other| beats(other, pair))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_no_other_beats_in_both() {
        let pairs = [(1.0, 4.0), (2.0, 2.0), (2.0, 3.0), (4.0, 1.0), (3.0, 2.0), (1.0, 4.0)];
        assert_eq!(front(&pairs), [true, true, false, true, false, true]);
    }
}
