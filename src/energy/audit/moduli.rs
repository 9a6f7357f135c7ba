//! Moduli at rest and the response to pulling in one direction.

use super::Subject;
use crate::energy::tangent::Kink;
use crate::tensor::{Mat3, Vec3};
use nalgebra::{SMatrix, SVector};

/// Stiffness at rest, Macaulay brackets slack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moduli {
    /// `(1/9) δ_iI δ_jJ A_iIjJ`, Pa.
    pub bulk: f64,
    /// `(1/10) (A_iIiI − (1/3) A_iijj)` of the symmetric strains: the mean over all shears, Pa.
    pub shear: f64,
}

/// Bulk and mean shear modulus at the reference configuration.
pub fn moduli(subject: &Subject) -> Moduli {
    let a = subject.law.tangent(&Mat3::identity(), subject.directions, Kink::Slack);
    let at = |i: usize, j: usize, k: usize, l: usize| a[(i + 3 * j, k + 3 * l)];
    let pairs = || (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    let volume: f64 = pairs().map(|(i, j)| at(i, i, j, j)).sum();
    let all: f64 = pairs().map(|(i, j)| 0.5 * (at(i, j, i, j) + at(i, j, j, i))).sum();
    Moduli { bulk: volume / 9.0, shear: (all - volume / 3.0) / 10.0 }
}

/// A bar pulled along one direction, free on its sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uniaxial {
    /// Deformation gradient; the pulled line keeps its direction.
    pub f: Mat3,
    /// Nominal stress along the direction, Pa.
    pub stress: f64,
}

/// Newton steps before a state is given up.
const STEPS: usize = 100;

/// Change of a component of `F` at which Newton's method has arrived.
const ARRIVED: f64 = 1e-13;

/// Free components of `F` in the bar's own axes; `F_21 = F_31 = F_32 = 0`.
const FREE: [(usize, usize); 5] = [(1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// State of a bar at a stretch along a unit vector `a`, all other stresses zero.
///
/// ```text
/// F a = λ a,   S = F⁻¹ P = S_aa a⊗a
/// ```
///
/// Newton's method on the five other components of the second Piola–Kirchhoff stress `S`, from
/// `start` (the state at a nearby stretch, or the identity); `None` where it does not arrive.
pub fn uniaxial(subject: &Subject, along: &Vec3, stretch: f64, start: &Mat3) -> Option<Uniaxial> {
    let axes = frame(along);
    let mut local = axes.transpose() * start * axes;
    local[(0, 0)] = stretch;
    for _ in 0..STEPS {
        let f = axes * local * axes.transpose();
        let inverse = f.try_inverse()?;
        let s = inverse * subject.stress(&f);
        let tangent = subject.law.tangent(&f, subject.directions, Kink::Slack);
        let component = |s: &Mat3, (i, j): (usize, usize)| axes.column(i).dot(&(s * axes.column(j)));
        let residual = SVector::<f64, 5>::from_fn(|k, _| component(&s, FREE[k]));
        let mut slope = SMatrix::<f64, 5, 5>::zeros();
        for (l, &(i, j)) in FREE.iter().enumerate() {
            let df = axes.column(i) * axes.column(j).transpose();
            let dp = tangent * SVector::<f64, 9>::from_column_slice(df.as_slice());
            let ds = inverse * (Mat3::from_column_slice(dp.as_slice()) - df * s);
            for (k, &place) in FREE.iter().enumerate() {
                slope[(k, l)] = component(&ds, place);
            }
        }
        let change = slope.lu().solve(&residual)?;
        for (&place, change) in FREE.iter().zip(change.iter()) {
            local[place] -= change;
        }
        if !change.iter().all(|change| change.is_finite()) {
            return None;
        }
        if change.amax() <= ARRIVED {
            let f = axes * local * axes.transpose();
            return Some(Uniaxial { f, stress: along.dot(&(subject.stress(&f) * along)) });
        }
    }
    None
}

/// An orthonormal frame whose first axis is given.
fn frame(along: &Vec3) -> Mat3 {
    let helper: Vec3 = Mat3::identity().column(along.iamin()).into();
    let second = along.cross(&helper).normalize();
    Mat3::from_columns(&[*along, second, along.cross(&second)])
}

/// Young's modulus and the two lateral contractions on one side of rest.
///
/// A secant at the stretch `1 + strain`; take some ±1e-6. Returns `(E, ν)`, E in Pa, ν for the two
/// principal lateral directions in ascending order; `None` where no state is found.
pub fn one_sided(subject: &Subject, along: &Vec3, strain: f64) -> Option<(f64, [f64; 2])> {
    let bar = uniaxial(subject, along, 1.0 + strain, &Mat3::identity())?;
    let axes = frame(along);
    let lateral = axes.transpose() * bar.f * axes;
    let (a, b, c) = (lateral[(1, 1)] - 1.0, lateral[(2, 2)] - 1.0, 0.5 * lateral[(1, 2)]);
    let (mean, radius) = (0.5 * (a + b), (0.25 * (a - b) * (a - b) + c * c).sqrt());
    let mut contractions = [-(mean + radius) / strain, -(mean - radius) / strain];
    contractions.sort_by(f64::total_cmp);
    Some((bar.stress / strain, contractions))
}
