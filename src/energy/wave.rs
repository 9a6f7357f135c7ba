//! Speeds of the waves a material carries, in the reference metric.
//!
//! Owns the search for the fastest wave: `ρ c²` is the largest value of `(n⊗N) : ∂²ψ/∂F∂F : (n⊗N)`
//! over unit vectors `n` and `N`. For a fixed `N` the best `n` is an eigenvector of the acoustic
//! tensor, for a fixed `n` the best `N` one of its counterpart, so taking turns only climbs.

use super::error::EnergyError;
use super::law::{Directions, Law, Maps, Scratch};
use super::program::LANES;
use super::stretch::{principal, symmetric_eigen};
use super::tangent::{Kink, Tangent, TangentWork, acoustic_tensor, polarised_tensor};
use crate::tensor::{Mat3, Vec3};

/// Turns after which a climb ends; most end after some five.
const TURNS: usize = 40;

/// Relative gain below which a climb has arrived.
const ARRIVED: f64 = 1e-7;

/// The same of a climb that only serves a time step: a speed good to half of it.
const CLOSE: f64 = 1e-4;

/// Rounds between two searches from a further start.
const EXPLORE: usize = 8;

/// Speeds in the reference configuration, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveSpeeds {
    /// The fastest wave over all directions.
    pub pressure: f64,
    /// The fastest of the second waves over the searched directions.
    pub shear: f64,
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
    /// The search climbs from the axes, the principal directions, the fibres, their normals and
    /// bisectors.
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
        let (mut largest, mut second) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        let mut list = Vec::new();
        starts(f, &directions[..self.directions()], &mut list);
        for start in list {
            second = second.max(symmetric_eigen(&acoustic_tensor(&tangent, &start)).0[1]);
            largest = largest.max(climb(&tangent, start, ARRIVED).0);
        }
        if largest > 0.0 {
            Ok(WaveSpeeds { pressure: (largest / density).sqrt(), shear: (second.max(0.0) / density).sqrt() })
        } else {
            Err(EnergyError::NoWave { largest })
        }
    }

    /// Fastest wave of each particle, m/s; not a number where the tangent is not finite.
    ///
    /// A climb starts from the direction found at the last call and, every eighth round, from one
    /// further start, each in its turn; the first call searches them all. The result is never above the speed
    /// [`Law::wave_speeds`] finds from all starts and is below it only where the fastest direction
    /// jumps between two rounds.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `maps`, `directions` | as [`Law::stress`] | – |
    /// | `density` | ρ, mass per reference volume | kg m⁻³ |
    /// | `round` | counts the calls | – |
    /// | `normals` | direction of the fastest wave of each particle; zero before the first call | – |
    /// | `out` | speeds | m s⁻¹ |
    ///
    /// Allocates only on a scratch's first use.
    ///
    /// # Panics
    /// As [`Law::stress`].
    #[expect(clippy::too_many_arguments, reason = "a block kernel takes the arrays it reads and writes")]
    pub fn wave_speed_block(
        &self,
        maps: Maps,
        directions: Directions,
        density: f64,
        round: usize,
        normals: &mut [Vec3],
        out: &mut [f64],
        scratch: &mut Scratch,
    ) {
        self.check(&maps, &directions, out.len());
        let mut search = std::mem::take(&mut scratch.search);
        for (start, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
            self.load_derivatives(&maps, &directions, start, Kink::Taut, scratch);
            for (lane, out) in out.iter_mut().enumerate() {
                let particle = start + lane;
                search.own.clear();
                search.own.extend((0..self.directions()).map(|index| directions.of(particle, index)));
                let f = &maps.f[particle];
                let tangent =
                    self.tangent_of_lane(f, &search.own, Kink::Taut, lane, scratch, &mut search.work);
                *out = search.speed(&tangent, f, round, &mut normals[particle], density);
            }
        }
        scratch.search = search;
    }
}

/// What a search for the fastest wave keeps between particles.
#[derive(Debug, Clone, Default)]
pub(super) struct Search {
    own: Vec<Vec3>,
    starts: Vec<Vec3>,
    work: TangentWork,
}

impl Search {
    /// Speed of the fastest wave, m/s; updates its direction.
    fn speed(&mut self, tangent: &Tangent, f: &Mat3, round: usize, normal: &mut Vec3, density: f64) -> f64 {
        if !tangent.iter().all(|value| value.is_finite()) {
            return f64::NAN;
        }
        let first = *normal == Vec3::zeros();
        let explores = first || round.is_multiple_of(EXPLORE);
        if explores {
            starts(f, &self.own, &mut self.starts);
        }
        let (mut largest, mut best) = (f64::NEG_INFINITY, Vec3::zeros());
        let mut try_from = |start: Vec3| {
            let (reached, at) = climb(tangent, start, CLOSE);
            if reached > largest {
                (largest, best) = (reached, at);
            }
        };
        if first {
            self.starts.iter().copied().for_each(&mut try_from);
        } else {
            try_from(*normal);
            if explores {
                try_from(self.starts[round / EXPLORE % self.starts.len()]);
            }
        }
        *normal = best;
        if largest > 0.0 { (largest / density).sqrt() } else { f64::NAN }
    }
}

/// The largest value reached from a direction by taking turns, and the direction reached.
fn climb(tangent: &Tangent, start: Vec3, arrived: f64) -> (f64, Vec3) {
    let mut n_ref = start;
    let mut reached = f64::NEG_INFINITY;
    for _ in 0..TURNS {
        let (_, vectors) = symmetric_eigen(&acoustic_tensor(tangent, &n_ref));
        let n: Vec3 = vectors.column(0).into();
        let (values, vectors) = symmetric_eigen(&polarised_tensor(tangent, &n));
        n_ref = vectors.column(0).into();
        if values[0] - reached <= arrived * values[0].abs() {
            return (values[0].max(reached), n_ref);
        }
        reached = values[0];
    }
    (reached, n_ref)
}

/// Directions a search starts from, into `starts`.
fn starts(f: &Mat3, directions: &[Vec3], starts: &mut Vec<Vec3>) {
    starts.clear();
    starts.extend(Mat3::identity().column_iter().map(Vec3::from));
    starts.extend(principal(f).1.column_iter().map(Vec3::from));
    starts.extend(directions);
    for (k, a) in directions.iter().enumerate() {
        for b in &directions[..k] {
            starts.extend([a + b, a - b, a.cross(b)].iter().filter_map(|sum| sum.try_normalize(1e-6)));
        }
    }
}
