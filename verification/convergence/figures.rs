//! Figures of the orders claimed here: errors over the spacing beside those of the seed scheme, and over the step.

use super::orders::Orders;
use super::{integrators, manufactured, swinging};
use crate::output::Figure;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture;

/// Errors of some families of cubes by what they are called, the paper's scheme last.
type Families = fn() -> Vec<(&'static str, &'static Orders)>;

/// A figure of a claim on the order of one error, as `position`: one line a claim.
macro_rules! figure {
    ($claim:expr, $families:expr, $field:ident, $least:literal) => {
        Illustration {
            claim: $claim.claim,
            figure: || {
                let of = |orders: &Orders| {
                    let point = |(cells, errors): &(f64, crate::monitor::MotionErrors)| {
                        (1.0 / cells, errors.rms.$field)
                    };
                    orders.errors.iter().map(point).collect::<Vec<_>>()
                };
                let lines: Vec<_> =
                    $families().into_iter().map(|(label, orders)| (label, of(orders))).collect();
                spacings(stringify!($field), &lines, $least)
            },
        }
    };
}

/// The figures of this directory.
pub(crate) const ILLUSTRATIONS: &[Illustration] = &[
    figure!(swinging::POSITION, COARSE, position, 1.9),
    figure!(swinging::VELOCITY, COARSE, velocity, 1.9),
    figure!(swinging::STRESS, COARSE, stress, 1.8),
    figure!(swinging::VOLUME, COARSE, volume_map, 1.8),
    figure!(manufactured::POSITION, MOVED_FIBRES, position, 1.9),
    figure!(manufactured::STRESS, MOVED_FIBRES, stress, 1.8),
    integrators::FIGURES[0],
    integrators::FIGURES[1],
    integrators::FIGURES[2],
    figure!(swinging::POSITION_FULL, RATIOS, position, 1.9),
    figure!(swinging::VELOCITY_FULL, RATIOS, velocity, 1.9),
    figure!(swinging::STRESS_FULL, RATIOS, stress, 1.8),
    figure!(swinging::VOLUME_FULL, RATIOS, volume_map, 1.8),
    figure!(swinging::POSITION_JITTERED, JITTERED, position, 1.9),
    figure!(swinging::VELOCITY_JITTERED, JITTERED, velocity, 1.9),
    figure!(swinging::STRESS_JITTERED, JITTERED, stress, 1.8),
    figure!(swinging::VOLUME_JITTERED, JITTERED, volume_map, 1.8),
    figure!(swinging::POSITION_LINEAR, LINEAR, position, 1.8),
    figure!(swinging::VELOCITY_LINEAR, LINEAR, velocity, 1.9),
    figure!(manufactured::POSITION_FULL, MOVED, position, 1.9),
    figure!(manufactured::VELOCITY_FULL, MOVED, velocity, 1.9),
    figure!(manufactured::STRESS_FULL, MOVED, stress, 1.8),
    figure!(manufactured::VOLUME_FULL, MOVED, volume_map, 1.8),
    figure!(manufactured::POSITION_JITTERED, MOVED_JITTERED, position, 1.9),
    figure!(manufactured::VELOCITY_JITTERED, MOVED_JITTERED, velocity, 1.9),
    figure!(manufactured::STRESS_JITTERED, MOVED_JITTERED, stress, 1.8),
    figure!(manufactured::VOLUME_JITTERED, MOVED_JITTERED, volume_map, 1.8),
];

const COARSE: Families = || vec![("improved, quadratic", &swinging::QUICK), ("seed", &swinging::SEED)];

const LINEAR: Families = || {
    vec![
        ("improved, quadratic", &swinging::FULL[0]),
        ("improved, linear", &swinging::LINEAR),
        ("seed", &swinging::SEED),
    ]
};

const JITTERED: Families = || ratios(&swinging::JITTERED);

const RATIOS: Families = || ratios(&swinging::FULL);

fn ratios([compressible, between, stiff]: &'static [Orders; 3]) -> Vec<(&'static str, &'static Orders)> {
    vec![
        ("quadratic, ν = .3", compressible),
        ("quadratic, ν = .45", between),
        ("quadratic, ν = .495", stiff),
        ("seed, ν = .3, regular", &swinging::SEED),
    ]
}

const MOVED_FIBRES: Families =
    || vec![("improved, quadratic", &manufactured::QUICK), ("seed", &manufactured::SEED[1])];

const MOVED: Families = || solids(&manufactured::FULL);

const MOVED_JITTERED: Families = || solids(&manufactured::JITTERED);

fn solids([matrix, fibres]: &'static [Orders; 2]) -> Vec<(&'static str, &'static Orders)> {
    let [seed_matrix, seed_fibres] = &*manufactured::SEED;
    vec![
        ("quadratic, neo-Hookean", matrix),
        ("quadratic, fibrous", fibres),
        ("seed, neo-Hookean, regular", seed_matrix),
        ("seed, fibrous, regular", seed_fibres),
    ]
}

/// Errors over the spacing with the order claimed.
fn spacings(field: &str, lines: &[(&str, Vec<(f64, f64)>)], least: f64) -> Figure {
    let (words, unit) = match field {
        "position" => ("positions", "m"),
        "velocity" => ("velocities", "m/s"),
        "stress" => ("P", "Pa"),
        "volume_map" => ("J", ""),
        "gradient" => ("F", ""),
        _ => (field, ""),
    };
    let title = format!("rms error of {words}; the triangle has the order claimed");
    picture::orders(&title, ("spacing", "m"), (&format!("rms error of {words}"), unit), lines, least)
}
