//! Expressions and units against arithmetic by hand.

use crate::verify::claims::scene::scene;
use crate::verify::{Claim, Topic};

/// Formulas, their values by the rules of the language, and by other rules a reader might expect.
const FORMULAS: &[(&str, f64, f64)] = &[
    ("10 + -2^2", 6.0, 14.0),
    ("2^-1*4", 2.0, 0.0625),
    ("2^3^2", 512.0, 64.0),
    ("16/4/2", 2.0, 8.0),
    ("7 - 4 - 2", 1.0, 5.0),
    ("2 + 3*4", 14.0, 20.0),
];

/// Quantities of time and their value in seconds, and one a wrong prefix would give.
const TIMES: &[(&str, f64, f64)] = &[
    ("1 h", 3600.0, 60.0),
    ("2 min", 120.0, 2.0),
    ("30 ms", 0.03, 30e-6),
    ("1 m/s / (4 mm/s^2)", 250.0, 0.25),
    ("(7.64 kPa / (1000 kg/m^3))^0.5 / (1 m/s^2)", 2.764_054_992_217_050_5, 0.087_407),
];

/// The precedence of the language.
pub(super) const PRECEDENCE: Claim = Claim {
    topic: Topic::Language,
    claim: "formulas group as stated: -x^2 = -(x^2), 2^3^2 = 2^9, a/b/c = (a/b)/c",
    source: "the language's table of operators",
    because: "small whole numbers and halves, on which every operation is exact but powers, two units in the last place",
    bound: 4.5e-16,
    measure: || worst(FORMULAS, |formula| format!("({formula})*1 s"), |row| row.1),
    control: || worst(FORMULAS, |formula| format!("({formula})*1 s"), |row| row.2),
};

/// Units and prefixes.
pub(super) const UNITS: Claim = Claim {
    topic: Topic::Language,
    claim: "quantities arrive in SI, whatever units and products of units they are written in",
    source: "definition of the units",
    because: "at most six operations, each rounded to 1.1e-16, the expected root itself given to 16 digits",
    bound: 1e-15,
    measure: || worst(TIMES, str::to_string, |row| row.1),
    control: || worst(TIMES, str::to_string, |row| row.2),
};

type Row = (&'static str, f64, f64);

/// Largest relative difference of the end times of scenes that state them as `written`.
fn worst(rows: &[Row], written: impl Fn(&str) -> String, expected: impl Fn(&Row) -> f64) -> f64 {
    let error = |row: &Row| {
        let until = scene(&with_end_time(&written(row.0))).run.until;
        (until - expected(row)).abs() / expected(row)
    };
    rows.iter().map(error).fold(0.0, f64::max)
}

fn with_end_time(until: &str) -> String {
    format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }}
scene clock {{
  body cube {{ shape = box(1 mm, 1 mm, 1 mm)  spacing = 0.5 mm  material = gel }}
  run {{ until = {until} }}
}}
"
    )
}
