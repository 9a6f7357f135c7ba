//! Figures of the orders claimed here: errors over the spacing beside those of the seed scheme, and over the step.

use super::orders::Orders;
use super::{integrators, manufactured, swinging};
use crate::output::Figure;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture;

/// Errors of some families of cubes by what they are called, the paper's scheme last.
type Families = fn() -> Vec<(&'static str, &'static Orders)>;

/// A figure of a claim on an order of one error, as `rms.position`: one line a claim.
macro_rules! figure {
    ($claim:expr, $families:expr, $norm:ident.$field:ident, $least:literal) => {
        Illustration {
            claim: $claim.claim,
            figure: || {
                let of = |orders: &Orders| {
                    let point = |(cells, errors): &(f64, crate::monitor::MotionErrors)| {
                        (1.0 / cells, errors.$norm.$field)
                    };
                    orders.errors.iter().map(point).collect::<Vec<_>>()
                };
                let lines: Vec<_> =
                    $families().into_iter().map(|(label, orders)| (label, of(orders))).collect();
                spacings(stringify!($norm), stringify!($field), &lines, $least)
            },
        }
    };
}

/// The figures of this directory.
pub(crate) const ILLUSTRATIONS: &[Illustration] = &[
    figure!(swinging::POSITION, COARSE, rms.position, 1.9),
    figure!(swinging::VELOCITY, COARSE, rms.velocity, 1.9),
    figure!(swinging::STRESS, COARSE, mean.stress, 1.8),
    figure!(swinging::VOLUME, COARSE, mean.volume_map, 1.8),
    figure!(manufactured::POSITION, MOVED_FIBRES, rms.position, 1.8),
    figure!(manufactured::STRESS, MOVED_FIBRES, mean.stress, 1.8),
    integrators::FIGURES[0],
    integrators::FIGURES[1],
    integrators::FIGURES[2],
    figure!(swinging::POSITION_FULL, RATIOS, rms.position, 1.9),
    figure!(swinging::VELOCITY_FULL, RATIOS, rms.velocity, 1.9),
    figure!(swinging::STRESS_FULL, RATIOS, mean.stress, 1.8),
    figure!(swinging::VOLUME_FULL, RATIOS, mean.volume_map, 1.8),
    figure!(swinging::POSITION_LINEAR, LINEAR, rms.position, 1.8),
    figure!(swinging::VELOCITY_LINEAR, LINEAR, rms.velocity, 1.9),
    figure!(swinging::POSITION_JITTERED, JITTERED, rms.position, 1.9),
    figure!(swinging::VELOCITY_JITTERED, JITTERED, rms.velocity, 1.9),
    figure!(swinging::STRESS_JITTERED, JITTERED, rms.stress, 1.0),
    figure!(manufactured::POSITION_FULL, MOVED, rms.position, 1.8),
    figure!(manufactured::VELOCITY_FULL, MOVED, rms.velocity, 1.7),
    figure!(manufactured::STRESS_FULL, MOVED, mean.stress, 1.8),
    figure!(manufactured::VOLUME_FULL, MOVED, mean.volume_map, 1.8),
];

const COARSE: Families = || vec![("improved, quadratic", &swinging::QUICK), ("seed", &swinging::SEED)];

const LINEAR: Families = || {
    vec![
        ("improved, quadratic", &swinging::FULL[0]),
        ("improved, linear", &swinging::LINEAR),
        ("seed", &swinging::SEED),
    ]
};

const JITTERED: Families =
    || vec![("quadratic, jitter 0.2", &swinging::JITTERED), ("seed, no jitter", &swinging::SEED)];

const RATIOS: Families = || {
    let [compressible, between, stiff] = &*swinging::FULL;
    vec![
        ("improved, ν = .3", compressible),
        ("improved, ν = .45", between),
        ("improved, ν = .495", stiff),
        ("seed, ν = .3", &swinging::SEED),
    ]
};

const MOVED_FIBRES: Families = || vec![("improved", &manufactured::QUICK), ("seed", &manufactured::SEED[1])];

const MOVED: Families = || {
    let ([matrix, fibres], [seed_matrix, seed_fibres]) = (&*manufactured::FULL, &*manufactured::SEED);
    vec![
        ("improved, neo-Hookean", matrix),
        ("improved, fibrous", fibres),
        ("seed, neo-Hookean", seed_matrix),
        ("seed, fibrous", seed_fibres),
    ]
};

/// Errors over the spacing with the order claimed.
fn spacings(norm: &str, field: &str, lines: &[(&str, Vec<(f64, f64)>)], least: f64) -> Figure {
    let (words, unit) = match field {
        "position" => ("positions", "m"),
        "velocity" => ("velocities", "m/s"),
        "stress" => ("P", "Pa"),
        "volume_map" => ("J", ""),
        "gradient" => ("F", ""),
        _ => (field, ""),
    };
    let norm = if norm == "rms" { "rms error" } else { "mean error" };
    let title = format!("{norm} of {words}; the triangle has the order claimed");
    picture::orders(&title, ("spacing", "m"), (&format!("{norm} of {words}"), unit), lines, least)
}
