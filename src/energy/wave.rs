//! Speeds of the waves a material carries, in the reference metric.
//!
//! Owns the search for the fastest wave: `ρ c²` is the largest value of `(n⊗N) : ∂²ψ/∂F∂F : (n⊗N)`
//! over unit vectors `n` and `N`. For a fixed `N` the best `n` is an eigenvector of the acoustic
//! tensor, for a fixed `n` the best `N` one of its counterpart, so taking turns only climbs.

use super::error::EnergyError;
use super::law::Law;
use super::stretch::{principal, symmetric_eigen};
use super::tangent::{Kink, Tangent, acoustic_tensor, polarised_tensor};
use crate::tensor::{Mat3, Vec3};

/// Starts climbed from: the best of them.
const CLIMBS: usize = 4;

/// Turns after which a climb ends; most end after some five.
const TURNS: usize = 40;

/// Relative gain below which a climb has arrived.
const ARRIVED: f64 = 1e-7;

/// Speeds in the reference configuration, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveSpeeds {
    /// The fastest wave over all directions.
    pub pressure: f64,
    /// The fastest of the second waves over the searched directions.
    pub shear: f64,
    /// The slowest wave over the searched directions, brackets at their kink slack: shear of what is between the
    /// fibres. Zero where a wave has no stiffness.
    pub matrix: f64,
}

impl Law {
    /// Fastest waves at a state, Macaulay brackets at their kink taken as loaded.
    ///
    /// ```text
    /// ρ c² = max over n, N of n_i N_I n_j N_J ∂²ψ/∂F_iI ∂F_jJ
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `f` | deformation gradient | – |
    /// | `directions` | unit vectors the law reads | – |
    /// | `density` | ρ, mass per reference volume | kg m⁻³ |
    ///
    /// The search climbs from the best four of the axes, the principal directions, the fibres, their
    /// normals and bisectors.
    ///
    /// # Errors
    /// If the tangent is not finite, or no wave travels at all.
    ///
    /// # Panics
    /// If `directions` holds fewer than the law reads.
    pub fn wave_speeds(
        &self,
        f: &Mat3,
        directions: &[Vec3],
        density: f64,
    ) -> Result<WaveSpeeds, EnergyError> {
        let tangent = self.tangent(f, directions, Kink::Taut);
        if !tangent.iter().all(|value| value.is_finite()) {
            return Err(EnergyError::NonFiniteTangent { jacobian: f.determinant() });
        }
        let slack = self.tangent(f, directions, Kink::Slack);
        let mut slowest = f64::INFINITY;
        let mut ranked: Vec<(f64, Vec3)> = Vec::new();
        let mut second = f64::NEG_INFINITY;
        for start in starts(f, &directions[..self.directions()]) {
            let values = symmetric_eigen(&acoustic_tensor(&tangent, &start)).0;
            second = second.max(values[1]);
            slowest = slowest.min(symmetric_eigen(&acoustic_tensor(&slack, &start)).0[2]);
            ranked.push((values[0], start));
        }
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
        let climbs = ranked.iter().take(CLIMBS).map(|(_, start)| climb(&tangent, *start));
        let largest = climbs.fold(f64::NEG_INFINITY, f64::max);
        if largest > 0.0 {
            let speed = |modulus: f64| (modulus.max(0.0) / density).sqrt();
            Ok(WaveSpeeds { pressure: speed(largest), shear: speed(second), matrix: speed(slowest) })
        } else {
            Err(EnergyError::NoWave { largest })
        }
    }
}

/// The largest value reached from a direction by taking turns.
fn climb(tangent: &Tangent, start: Vec3) -> f64 {
    let mut n_ref = start;
    let mut reached = f64::NEG_INFINITY;
    for _ in 0..TURNS {
        let (_, vectors) = symmetric_eigen(&acoustic_tensor(tangent, &n_ref));
        let n: Vec3 = vectors.column(0).into();
        let (values, vectors) = symmetric_eigen(&polarised_tensor(tangent, &n));
        n_ref = vectors.column(0).into();
        if values[0] - reached <= ARRIVED * values[0].abs() {
            return values[0].max(reached);
        }
        reached = values[0];
    }
    reached
}

/// Directions a search starts from.
fn starts(f: &Mat3, directions: &[Vec3]) -> Vec<Vec3> {
    let mut starts: Vec<Vec3> = Mat3::identity().column_iter().map(Into::into).collect();
    starts.extend(principal(f).1.column_iter().map(Vec3::from));
    starts.extend(directions);
    for (k, a) in directions.iter().enumerate() {
        for b in &directions[..k] {
            starts.extend([a + b, a - b, a.cross(b)].iter().filter_map(|sum| sum.try_normalize(1e-6)));
        }
    }
    starts
}
