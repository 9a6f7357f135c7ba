//! Numerical choices of generated scenes.
//!
//! Owns which words of `run { … }` are drawn and how often. Knows no body.

use super::number;
use proptest::prelude::*;

/// How often the default is drawn, for ten of the words, and the words.
pub type Dissipations = (u32, &'static [&'static str]);

/// A word for a key, none for its default.
type Word = Option<&'static str>;

/// What stands in `run { … }` beside the end.
#[derive(Debug, Clone)]
pub struct Run {
    /// Keys and words.
    pub words: Vec<(&'static str, &'static str)>,
    /// `cfl`.
    pub cfl: Option<f64>,
    /// `smoothing`.
    pub smoothing: Option<f64>,
    /// `pressure_wave_weight`, `shear_wave_weight`, `hourglass_stiffness`.
    pub weights: [Option<f64>; 3],
}

/// The default, so many times as often as ten, or one of some words.
fn word(weight: u32, words: &'static [&'static str]) -> BoxedStrategy<Word> {
    let word = prop::sample::select(words).prop_map(Some);
    if weight == 0 { word.boxed() } else { prop_oneof![weight => Just(None), 10 => word].boxed() }
}

fn number_of(weight: u32, values: std::ops::Range<f64>) -> impl Strategy<Value = Option<f64>> {
    prop_oneof![weight => Just(None), 10 => values.prop_map(Some)]
}

/// Choices, the defaults first; `dissipations` are how often the default of `momentum_dissipation` is drawn, of ten, and
/// the words drawn beside it.
pub fn runs((default, dissipations): Dissipations) -> impl Strategy<Value = Run> {
    let words = (
        word(60, &["seed"]),
        word(15, &["velocity_verlet", "ssp_rk3", "tvd_rk2"]),
        word(20, &["quadratic"]),
        word(60, &["cubic_spline", "quintic_spline", "quadratic"]),
        word(default, dissipations),
        word(50, &["pF", "pFJ", "pFHJ"]),
        word(60, &["quasi_static"]),
        word(60, &["projected"]),
        word(80, &["0", "1", "3"]),
        word(80, &["off"]),
    );
    let numbers = (
        number_of(15, 0.1..0.9),
        number_of(30, 0.85..2.0),
        [number_of(30, 0.0..2.0), number_of(60, 0.0..2.0), number_of(30, 0.0..1.0)],
    );
    (words, numbers).prop_map(|(words, (cfl, smoothing, weights))| {
        let (a, b, c, d, e, f, g, h, i, j) = words;
        let keys = [
            "scheme",
            "integrator",
            "completeness",
            "kernel",
            "momentum_dissipation",
            "formulation",
            "loading",
            "angular_momentum",
            "wave_speed_every",
            "integration_consistency",
        ];
        // what the language refuses together is not drawn together
        let c = c.filter(|_| a.is_none());
        let (h, j) = (h.filter(|_| g.is_none()), j.filter(|_| c.is_none()));
        // undamped, Heun's method grows at any step and SSP-RK3 beyond sqrt(3)/2, as theory says
        let cfl = match (b, e) {
            (Some("tvd_rk2"), Some("off")) => cfl.map(|cfl| cfl.min(0.2)),
            (Some("ssp_rk3"), Some("off")) => Some(cfl.unwrap_or(0.8).min(0.8)),
            _ => cfl,
        };
        let f = f.filter(|f| a.is_none() || *f != "pF");
        let chosen = keys.into_iter().zip([a, b, c, d, e, f, g, h, i, j]);
        let words = chosen.filter_map(|(key, word)| Some((key, word?))).collect();
        Run { words, cfl, smoothing, weights }
    })
}

impl Run {
    /// The block.
    pub fn line(&self, end: f64) -> String {
        let mut text = format!("  run {{\n    until = {} s\n", number(end));
        for (key, word) in &self.words {
            text.push_str(&format!("    {key} = {word}\n"));
        }
        let [pressure, shear, penalty] = self.weights;
        let numbers = [
            ("cfl", self.cfl),
            ("smoothing", self.smoothing),
            ("pressure_wave_weight", pressure),
            ("shear_wave_weight", shear),
            ("hourglass_stiffness", penalty),
        ];
        for (key, value) in numbers {
            if let Some(value) = value {
                text.push_str(&format!("    {key} = {value:.2}\n"));
            }
        }
        text + "  }\n"
    }
}
