//! Where a law keeps waves real and stresses in order.

use super::Subject;
use crate::energy::stretch::symmetric_eigen;
use crate::energy::tangent::{Kink, Tangent, acoustic_tensor, polarised_tensor};
use crate::tensor::{Mat3, Vec3};

/// Directions of travel a scan looks into before it refines the worst.
const DIRECTIONS: usize = 400;

/// Turns of the refinement.
const TURNS: usize = 30;

/// The smallest acoustic eigenvalue of a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipticity {
    /// `min n_i N_I n_j N_J ∂²ψ/∂F_iI∂F_jJ`, Pa; negative where strong ellipticity is lost.
    pub smallest: f64,
    /// Direction of travel `N` of it, in the reference configuration.
    pub travel: Vec3,
    /// Size below which `smallest` says nothing, Pa: the round-off of the tangent.
    pub resolution: f64,
}

/// Round-off of a tangent's entries relative to its norm: some hundred products, each to 1.1e-16.
const ROUND_OFF: f64 = 1e-14;

/// Smallest acoustic eigenvalue over all directions, Macaulay brackets at their kink slack.
///
/// Four hundred directions over half the sphere, then turns of eigenvectors from the worst.
/// Not a number where the tangent is not finite.
pub fn ellipticity(subject: &Subject, f: &Mat3) -> Ellipticity {
    let tangent = subject.law.tangent(f, subject.directions, Kink::Slack);
    if !tangent.iter().all(|value| value.is_finite()) {
        return Ellipticity { smallest: f64::NAN, travel: Vec3::x(), resolution: f64::INFINITY };
    }
    let candidates = sphere(DIRECTIONS).chain(subject.directions.iter().copied());
    let worst = candidates
        .map(|travel| (lowest_value(&acoustic_tensor(&tangent, &travel)), travel))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, travel)| Ellipticity {
            smallest: lowest(&acoustic_tensor(&tangent, &travel)).0,
            travel,
            resolution: ROUND_OFF * tangent.norm(),
        })
        .expect("the scan has directions");
    descend(&tangent, worst)
}

fn descend(tangent: &Tangent, mut at: Ellipticity) -> Ellipticity {
    for _ in 0..TURNS {
        let (_, n) = lowest(&acoustic_tensor(tangent, &at.travel));
        let (smallest, travel) = lowest(&polarised_tensor(tangent, &n));
        if smallest < at.smallest {
            at = Ellipticity { smallest, travel, ..at };
        } else {
            break;
        }
    }
    at
}

fn lowest(q: &Mat3) -> (f64, Vec3) {
    let (values, vectors) = symmetric_eigen(q);
    (values[2], vectors.column(2).into())
}

/// The lowest eigenvalue in closed form, to half the digits: enough to rank directions by.
///
/// ```text
/// λ_3 = m + 2 p cos(φ + 2π/3),   m = tr Q/3,   p² = |Q − m I|²/6,   cos 3φ = det(Q − m I)/(2 p³)
/// ```
fn lowest_value(q: &Mat3) -> f64 {
    let mean = q.trace() / 3.0;
    let deviator = q - mean * Mat3::identity();
    let p = (deviator.norm_squared() / 6.0).sqrt();
    if p == 0.0 {
        return mean;
    }
    let cosine = (deviator.determinant() / (2.0 * p * p * p)).clamp(-1.0, 1.0);
    mean + 2.0 * p * libm::cos((libm::acos(cosine) + 2.0 * std::f64::consts::PI) / 3.0)
}

/// Directions spread evenly over the half sphere `z > 0`, on a spiral of the golden angle.
fn sphere(count: usize) -> impl Iterator<Item = Vec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |k| {
        let z = (k as f64 + 0.5) / count as f64;
        let (radius, angle) = ((1.0 - z * z).sqrt(), golden * k as f64);
        Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
    })
}

/// The smallest acoustic eigenvalue along a path, and the first place where it is not positive.
///
/// `path` pairs a parameter (a stretch, say) with its state, in order. The place is that of the first
/// state without strong ellipticity, or whose tangent is not finite.
pub fn ellipticity_along(
    subject: &Subject,
    path: impl IntoIterator<Item = (f64, Mat3)>,
) -> (Vec<(f64, Ellipticity)>, Option<f64>) {
    let scanned: Vec<_> = path.into_iter().map(|(at, f)| (at, ellipticity(subject, &f))).collect();
    let holds = |ellipticity: &Ellipticity| ellipticity.smallest > 0.0;
    let lost = scanned.iter().find(|(_, ellipticity)| !holds(ellipticity)).map(|(at, _)| *at);
    (scanned, lost)
}

/// The pair of stretches by which the Baker–Ericksen inequality is closest to failing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BakerEricksen {
    /// Smallest `(σ_i − σ_j)/(λ_i − λ_j)`, Pa; negative where the inequality fails.
    pub smallest: f64,
    /// Stretches of the state.
    pub stretches: Vec3,
}

/// Baker–Ericksen inequality over a cube of stretches, `count` to an edge, for an isotropic law.
///
/// The larger Cauchy stress must act along the larger stretch. `None` for a law that reads
/// directions: its principal stresses need not follow the stretches.
pub fn baker_ericksen(subject: &Subject, low: f64, high: f64, count: usize) -> Option<BakerEricksen> {
    if subject.law.directions() > 0 {
        return None;
    }
    let stretch = |k: usize| low + (high - low) * k as f64 / (count.max(2) - 1) as f64;
    let mut worst = BakerEricksen { smallest: f64::INFINITY, stretches: Vec3::zeros() };
    for k in 0..count {
        for l in 0..k {
            for m in 0..count {
                let stretches = Vec3::new(stretch(k), stretch(l), stretch(m));
                let f = Mat3::from_diagonal(&stretches);
                let p = subject.stress(&f);
                let sigma = p * f.transpose() / f.determinant();
                let ratio = (sigma[(0, 0)] - sigma[(1, 1)]) / (stretches[0] - stretches[1]);
                // a NaN counts as a failure
                if ratio.is_nan() || ratio < worst.smallest {
                    worst = BakerEricksen { smallest: ratio, stretches };
                }
            }
        }
    }
    Some(worst)
}

/// Smallest `d²ψ/dJ²` under pure dilation for `J` from `low` to `high`, Pa, and its `J`.
///
/// For a law that splits into an isochoric and a volumetric part this is the convexity of the
/// volumetric one, which polyconvexity requires: an indicator, necessary and not sufficient.
pub fn smallest_volumetric_stiffness(subject: &Subject, low: f64, high: f64, count: usize) -> (f64, f64) {
    let mut worst = (f64::INFINITY, low);
    for k in 0..count.max(2) {
        let j = low * libm::pow(high / low, k as f64 / (count.max(2) - 1) as f64);
        let lambda = libm::cbrt(j);
        let f = lambda * Mat3::identity();
        // with F = λ I: dψ/dλ = tr P, d²ψ/dλ² = δ:A:δ, dλ/dJ = 1/(3 λ²)
        let slope = subject.stress(&f).trace();
        let tangent = subject.law.tangent(&f, subject.directions, Kink::Slack);
        let curvature: f64 = (0..9).map(|k| tangent[(4 * (k / 3), 4 * (k % 3))]).sum();
        let by_j = 1.0 / (3.0 * lambda * lambda);
        let stiffness = curvature * by_j * by_j - slope * 2.0 / (9.0 * libm::pow(lambda, 5.0));
        if stiffness.is_nan() || stiffness < worst.0 {
            worst = (stiffness, j);
        }
    }
    worst
}
