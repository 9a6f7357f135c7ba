//! Second derivatives of a law with respect to `F`, the area and volume map following.

use super::kinematics::Reads;
use super::law::{Directions, Law, Maps, Scratch};
use super::raw::Raw;
use super::stretch;
use super::trace::pair;
use crate::tensor::{Mat3, Vec3, cofactor, cross};
use nalgebra::{SMatrix, SVector};

/// `∂²ψ/∂F_iI ∂F_jJ` at row `i + 3 I`, column `j + 3 J`.
pub type Tangent = SMatrix<f64, 9, 9>;

/// A tensor as a column, in the order of its storage.
type Column = SVector<f64, 9>;

/// Which side of its kink a Macaulay bracket is differentiated on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kink {
    /// At its kink a bracket is off: a fibre at rest carries nothing.
    Slack,
    /// At its kink (or less than 1e-8 below) a bracket is on: a fibre at rest is about to be pulled.
    Taut,
}

/// Relative difference of two stretches below which their divided difference is its limit.
///
/// The limit errs by the square of the difference (1e-10), the quotient by round-off over it (1e-11).
const EQUAL_STRETCHES: f64 = 1e-5;

/// First and second derivatives by the raw invariants at one state.
struct Derivatives {
    first: Vec<f64>,
    second: Vec<f64>,
}

impl Law {
    /// Tangent of the law in `F` alone: `H = cof F`, `J = det F`.
    ///
    /// ```text
    /// ∂²ψ/∂F∂F = Σ_kl ∂²ψ/∂I_k∂I_l ∂I_k/∂F ⊗ ∂I_l/∂F + Σ_k ∂ψ/∂I_k ∂²I_k/∂F∂F
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `f` | deformation gradient | – |
    /// | `directions` | unit vectors the law reads | – |
    /// | `kink` | side of the Macaulay brackets' kinks | |
    ///
    /// Returns Pa; not finite where the law is not defined.
    ///
    /// # Panics
    /// If `directions` holds fewer than the law reads.
    pub fn tangent(&self, f: &Mat3, directions: &[Vec3], kink: Kink) -> Tangent {
        let derivatives = self.derivatives(f, directions, kink);
        let geometry = Geometry::new(f, directions, self.reads);
        let gradients: Vec<Column> = self.raws.iter().map(|&raw| geometry.gradient(raw)).collect();
        let mut tangent = Tangent::zeros();
        for l in 0..self.raws.len() {
            for k in 0..=l {
                let second = derivatives.second[pair(k, l)];
                if second == 0.0 {
                    continue;
                }
                tangent += second * gradients[k] * gradients[l].transpose();
                if k != l {
                    tangent += second * gradients[l] * gradients[k].transpose();
                }
            }
        }
        for place in 0..9 {
            let mut unit = Mat3::zeros();
            unit.as_mut_slice()[place] = 1.0;
            let mut change = Mat3::zeros();
            for (&raw, &first) in self.raws.iter().zip(&derivatives.first) {
                if first != 0.0 {
                    change += first * geometry.gradient_change(raw, &unit);
                }
            }
            let mut column = tangent.column_mut(place);
            column += Column::from_column_slice(change.as_slice());
        }
        if self.reads.stretch {
            tangent += self.stretch_rotation(&geometry, &derivatives);
        }
        tangent
    }

    /// Acoustic tensor `Q_ij = N_I N_J ∂²ψ/∂F_iI ∂F_jJ`, Pa, brackets at their kink loaded.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `n` | `N`, direction of travel in the reference configuration, a unit vector | – |
    ///
    /// # Panics
    /// If `directions` holds fewer than the law reads.
    pub fn acoustic_tensor(&self, f: &Mat3, directions: &[Vec3], n: &Vec3) -> Mat3 {
        acoustic_tensor(&self.tangent(f, directions, Kink::Taut), n)
    }

    fn derivatives(&self, f: &Mat3, directions: &[Vec3], kink: Kink) -> Derivatives {
        let program = &self.hessians[usize::from(kink == Kink::Taut)];
        let maps = Maps { f: &[*f], h: None, j: None };
        let directions = Directions::Uniform(directions);
        self.check(&maps, &directions, 1);
        let mut scratch = Scratch::default();
        self.prepare(program, &mut scratch);
        scratch.block.load(&maps, &directions, 0, self.reads);
        self.run(program, &mut scratch);
        let values: Vec<f64> =
            program.outputs().iter().map(|&register| scratch.rows[register as usize][0]).collect();
        let (first, second) = values.split_at(self.raws.len());
        Derivatives { first: first.to_vec(), second: second.to_vec() }
    }

    /// `Σ_i g_i ∂²λ_i/∂F∂F`: what turning the principal directions adds.
    ///
    /// ```text
    /// Σ_{i≠j} ½ (D + M) (n_i⊗N_j)⊗(n_i⊗N_j) + ½ (D − M) (n_i⊗N_j)⊗(n_j⊗N_i)
    /// D = (g_i − g_j)/(λ_i − λ_j),   M = (g_i + g_j)/(λ_i + λ_j)
    /// ```
    ///
    /// At equal stretches `D` is its limit `½ (ψ_ii + ψ_jj) − ψ_ij`.
    fn stretch_rotation(&self, geometry: &Geometry, derivatives: &Derivatives) -> Tangent {
        let place = |i: usize| self.raws.iter().position(|&raw| raw == Raw::Stretch(i as u8));
        let first = |i| place(i).map_or(0.0, |k| derivatives.first[k]);
        let second = |i, j| match (place(i), place(j)) {
            (Some(k), Some(l)) => derivatives.second[pair(k.min(l), k.max(l))],
            _ => 0.0,
        };
        let stretches = &geometry.stretches;
        let mut tangent = Tangent::zeros();
        for i in 0..3 {
            for j in (0..3).filter(|&j| j != i) {
                let (g_i, g_j) = (first(i), first(j));
                let gap = stretches[i] - stretches[j];
                let divided = if gap.abs() > EQUAL_STRETCHES * stretches[i].abs() {
                    (g_i - g_j) / gap
                } else {
                    0.5 * (second(i, i) + second(j, j)) - second(i, j)
                };
                let mean = (g_i + g_j) / (stretches[i] + stretches[j]);
                let (ij, ji) = (geometry.mixed(i, j), geometry.mixed(j, i));
                tangent += 0.5 * (divided + mean) * ij * ij.transpose();
                tangent += 0.5 * (divided - mean) * ij * ji.transpose();
            }
        }
        tangent
    }
}

/// Acoustic tensor of a tangent.
pub(super) fn acoustic_tensor(tangent: &Tangent, n: &Vec3) -> Mat3 {
    let mut q = Mat3::zeros();
    for (place_j, weight_j) in n.iter().enumerate() {
        for (place_i, weight_i) in n.iter().enumerate() {
            q += weight_i * weight_j * tangent.fixed_view::<3, 3>(3 * place_i, 3 * place_j);
        }
    }
    q
}

/// `R_IJ = n_i n_j ∂²ψ/∂F_iI ∂F_jJ`: the acoustic tensor with the polarisation held instead.
pub(super) fn polarised_tensor(tangent: &Tangent, n: &Vec3) -> Mat3 {
    Mat3::from_fn(|i, j| n.dot(&(tangent.fixed_view::<3, 3>(3 * i, 3 * j) * n)))
}

/// The state a tangent is taken at.
struct Geometry<'a> {
    f: &'a Mat3,
    h: Mat3,
    directions: &'a [Vec3],
    stretches: Vec3,
    principal: Mat3,
}

impl<'a> Geometry<'a> {
    fn new(f: &'a Mat3, directions: &'a [Vec3], reads: Reads) -> Self {
        let (stretches, principal) =
            if reads.stretch { stretch::principal(f) } else { (Vec3::zeros(), Mat3::zeros()) };
        Self { f, h: cofactor(f), directions, stretches, principal }
    }

    /// `n_i ⊗ N_j` as a column.
    fn mixed(&self, i: usize, j: usize) -> Column {
        let spatial = self.f * self.principal.column(i) / self.stretches[i];
        Column::from_column_slice((spatial * self.principal.column(j).transpose()).as_slice())
    }

    /// `∂I/∂F`
    fn gradient(&self, raw: Raw) -> Column {
        let at = |a: u8| self.directions[usize::from(a)];
        let f = self.f;
        let gradient = match raw {
            Raw::I1 => 2.0 * f,
            Raw::I2 => 2.0 * cross(&self.h, f),
            Raw::J => self.h,
            Raw::Stretch(i) => return self.mixed(usize::from(i), usize::from(i)),
            Raw::Fourth(a) => 2.0 * (f * at(a)) * at(a).transpose(),
            Raw::Fifth(a) => {
                let b = f.transpose() * (f * at(a));
                2.0 * ((f * at(a)) * b.transpose() + (f * b) * at(a).transpose())
            }
            Raw::Eighth(a, b) => (f * at(a)) * at(b).transpose() + (f * at(b)) * at(a).transpose(),
            Raw::Metric(i, j) => metric_change(f, i, j),
            Raw::Dot(..) | Raw::Component(..) => Mat3::zeros(),
        };
        Column::from_column_slice(gradient.as_slice())
    }

    /// Change of `∂I/∂F` along `e`; of stretches none, see [`Law::stretch_rotation`].
    fn gradient_change(&self, raw: Raw, e: &Mat3) -> Mat3 {
        let at = |a: u8| self.directions[usize::from(a)];
        let f = self.f;
        match raw {
            Raw::I1 => 2.0 * e,
            Raw::I2 => 2.0 * (cross(&cross(f, e), f) + cross(&self.h, e)),
            Raw::J => cross(f, e),
            Raw::Stretch(_) | Raw::Dot(..) | Raw::Component(..) => Mat3::zeros(),
            Raw::Metric(i, j) => metric_change(e, i, j),
            Raw::Fourth(a) => 2.0 * (e * at(a)) * at(a).transpose(),
            Raw::Fifth(a) => {
                let a = at(a);
                let m = f * a;
                let b = f.transpose() * m;
                let change = e.transpose() * m + f.transpose() * (e * a);
                2.0 * ((e * a) * b.transpose()
                    + m * change.transpose()
                    + (e * b + f * change) * a.transpose())
            }
            Raw::Eighth(a, b) => (e * at(a)) * at(b).transpose() + (e * at(b)) * at(a).transpose(),
        }
    }
}

/// `f e_i ⊗ e_j + f e_j ⊗ e_i`
fn metric_change(f: &Mat3, i: u8, j: u8) -> Mat3 {
    let (i, j) = (usize::from(i), usize::from(j));
    let mut change = Mat3::zeros();
    for (line, image) in [(i, j), (j, i)] {
        let column = change.column(line) + f.column(image);
        change.set_column(line, &column);
    }
    change
}
