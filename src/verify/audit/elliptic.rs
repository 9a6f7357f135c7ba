//! Strong ellipticity, outwards from rest.

use crate::energy::audit::{Ellipticity, Subject, ellipticity};
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;
use serde::Serialize;

/// Distance of two stretches of a scan.
const STEP: f64 = 0.025;

/// Halvings of a step to find where ellipticity ends: to 1e-4.
const HALVINGS: u32 = 8;

/// A path of deformation outwards from rest in both senses, each to its end or to the first failure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EllipticPath {
    /// The path in words.
    pub path: String,
    /// Smallest acoustic eigenvalue of the states that are elliptic, Pa.
    pub smallest: f64,
    /// Stretch at which it was found.
    pub smallest_at: f64,
    /// Stretch in compression at which it becomes zero.
    pub lost_in_compression: Option<f64>,
    /// Stretch in tension at which it becomes zero.
    pub lost_in_tension: Option<f64>,
    /// Direction of travel, in the reference configuration, of the wave lost first.
    pub travel: Option<[f64; 3]>,
    /// First stretch in compression whose tangent is not finite, or so large that its round-off hides
    /// the smallest eigenvalue; nothing is known beyond.
    pub unknown_in_compression: Option<f64>,
    /// The same in tension.
    pub unknown_in_tension: Option<f64>,
}

/// A way to stretch a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// `F = λ a⊗a + λ^(-1/2) (I − a⊗a)`
    Isochoric(Vec3),
    /// `F = λ a⊗a + (I − a⊗a)`
    Confined(Vec3),
    /// `F = λ I`
    Dilation,
}

impl Way {
    pub(super) fn state(self, stretch: f64) -> Mat3 {
        match self {
            Self::Isochoric(a) => {
                let line = a * a.transpose();
                stretch * line + (Mat3::identity() - line) / stretch.sqrt()
            }
            Self::Confined(a) => Mat3::identity() + (stretch - 1.0) * a * a.transpose(),
            Self::Dilation => stretch * Mat3::identity(),
        }
    }
}

/// Isochoric stretch along every direction, confined stretch along the first, and dilation.
pub(super) fn ways(named: &[(String, Vec3)]) -> Vec<(String, Way)> {
    let mut ways: Vec<(String, Way)> = named
        .iter()
        .map(|(name, a)| (format!("isochoric stretch along {name}"), Way::Isochoric(*a)))
        .collect();
    if let Some((name, a)) = named.first() {
        ways.push((format!("confined stretch along {name}"), Way::Confined(*a)));
    }
    ways.push(("dilation".into(), Way::Dilation));
    ways
}

/// Scans the ways outwards from rest.
pub(super) fn paths(subject: &Subject, named: &[(String, Vec3)], stretches: [f64; 2]) -> Vec<EllipticPath> {
    let ways = ways(named);
    let rest = ellipticity(subject, &Mat3::identity());
    ways.into_par_iter().map(|(path, way)| scan(subject, path, way, rest, stretches)).collect()
}

fn scan(subject: &Subject, path: String, way: Way, rest: Ellipticity, stretches: [f64; 2]) -> EllipticPath {
    let mut found = EllipticPath {
        path,
        smallest: rest.smallest,
        smallest_at: 1.0,
        lost_in_compression: None,
        lost_in_tension: None,
        travel: None,
        unknown_in_compression: None,
        unknown_in_tension: None,
    };
    if rest.smallest.is_nan() || rest.smallest <= rest.resolution {
        (found.lost_in_compression, found.lost_in_tension) = (Some(1.0), Some(1.0));
        found.travel = Some(rest.travel.into());
        return found;
    }
    for end in stretches {
        // Bounded: a range that is asked about ends below 100.
        let steps = libm::ceil((end - 1.0).abs() / STEP - 1e-9) as u32;
        let mut last = 1.0;
        for step in 1..=steps {
            let stretch = 1.0 + (end - 1.0) * f64::from(step) / f64::from(steps);
            let state = ellipticity(subject, &way.state(stretch));
            if state.smallest.is_nan() || state.smallest.abs() <= state.resolution {
                let unknown =
                    if end < 1.0 { &mut found.unknown_in_compression } else { &mut found.unknown_in_tension };
                *unknown = Some(stretch);
                break;
            }
            if state.smallest <= 0.0 {
                let (at, travel) = bisect(subject, way, last, (stretch, state.travel));
                let lost =
                    if end < 1.0 { &mut found.lost_in_compression } else { &mut found.lost_in_tension };
                *lost = Some(at);
                found.travel = found.travel.or(Some(travel.into()));
                break;
            }
            if state.smallest < found.smallest {
                (found.smallest, found.smallest_at) = (state.smallest, stretch);
            }
            last = stretch;
        }
    }
    found
}

/// The stretch nearest to rest that is known to be lost, and its wave.
fn bisect(subject: &Subject, way: Way, mut holds: f64, mut lost: (f64, Vec3)) -> (f64, Vec3) {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (holds + lost.0);
        let state = ellipticity(subject, &way.state(middle));
        if state.smallest > 0.0 {
            holds = middle;
        } else {
            lost = (middle, state.travel);
        }
    }
    lost
}
