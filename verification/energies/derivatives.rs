//! The traced programs against other ways to the same derivatives.

use super::super::picture::orders;
use super::known_values::stress;
use super::laws::{ARTERY, Artery, DISPERSED, Random, circumferential, goh, worse};
use crate::energy::{Directions, Invariant, Kink, Law, Leaf, Maps, Scratch};
use crate::expression::{Number, Scalar, Tape};
use crate::tensor::{Mat3, Vec3, cofactor, cross};
use crate::verify::claim::Illustration;
use crate::verify::{Claim, Topic};
use num_dual::Dual;

type Nine<T> = [[T; 3]; 3];

/// The program's stress is num-dual's, nine derivatives of ψ by the components of `F`.
pub(crate) const DIRECT: Claim = Claim {
    topic: Topic::Energies,
    claim: "the traced stress equals direct dual-number differentiation of psi(F) in 10000 states",
    source: "derivative of NB25 (46)-(47) by the components of F, num-dual without tracing",
    because: "exp(k2 E^2) turns an error of 1e-16 in E into 2 k2 E 1e-16 (1e-14 at E = 0.1); sums of 100 terms",
    bound: 1e-12,
    measure: || direct_error(1.0),
    control: || direct_error(1.0 + 1e-9),
};

fn direct_error(scale: f64) -> f64 {
    let directions = circumferential();
    let psi = goh(2, true);
    let law = DISPERSED.law();
    let wrong =
        Artery { c: DISPERSED.c * scale, k1: DISPERSED.k1 * scale, d: DISPERSED.d / scale, ..DISPERSED };
    let mut random = Random(10_000);
    let states: Vec<Mat3> = (0..10_000).map(|_| random.deformation(0.12)).collect();
    let mut traced = vec![Mat3::zeros(); states.len()];
    let maps = Maps { f: &states, h: None, j: None };
    law.stress(maps, Directions::Uniform(&directions), &mut traced, &mut Scratch::default());
    states.iter().zip(&traced).fold(0.0, |worst: f64, (f, p)| {
        let direct = Mat3::from_fn(|i, j| {
            let seed = |row, column| f64::from(u8::from((row, column) == (i, j)));
            let f = std::array::from_fn(|row| {
                std::array::from_fn(|column| Dual::new(Number(f[(row, column)]), Number(seed(row, column))))
            });
            density_of(&psi, &wrong.parameters(), &f, &directions).eps.0
        });
        worse(worst, (p - direct).norm() / direct.norm())
    })
}

/// `ψ(F)` as it reads, in any scalar.
fn density_of<T: Scalar>(psi: &Tape<Leaf>, parameters: &[f64], f: &Nine<T>, directions: &[Vec3]) -> T {
    let square = |x: &T| x.clone() * x.clone();
    let minor = |i: usize, j: usize| f[1][i].clone() * f[2][j].clone() - f[1][j].clone() * f[2][i].clone();
    let jacobian =
        f[0][0].clone() * minor(1, 2) + f[0][1].clone() * minor(2, 0) + f[0][2].clone() * minor(0, 1);
    let shrink = jacobian.reciprocal_cbrt() * jacobian.reciprocal_cbrt();
    let squares = f.iter().flatten().map(square).reduce(|a, b| a + b).expect("nine components");
    let fourth = |a: &Vec3| {
        let image = f.iter().map(|row| {
            row.iter()
                .zip(a.iter())
                .map(|(x, a)| x.clone() * T::constant(*a))
                .reduce(|a, b| a + b)
                .expect("three")
        });
        image.map(|x| square(&x)).reduce(|a, b| a + b).expect("three")
    };
    let leaf = |leaf: &Leaf| match leaf {
        Leaf::Parameter(index) => T::constant(parameters[*index as usize]),
        Leaf::Invariant(Invariant::J) => jacobian.clone(),
        Leaf::Invariant(Invariant::I1Bar) => squares.clone() * shrink.clone(),
        Leaf::Invariant(Invariant::I4Bar(a)) => fourth(&directions[usize::from(*a)]) * shrink.clone(),
        other => unreachable!("the law reads no {other:?}"),
    };
    psi.evaluate(leaf, &mut Vec::new())
}

/// The same law differentiated by hand.
pub(crate) const BY_HAND: Claim = Claim {
    topic: Topic::Energies,
    claim: "the traced stress of the artery equals the one written by hand",
    source: "NB25 (46)-(49), differentiated on paper",
    because: "as for direct differentiation: relative error of exp times that of its argument",
    bound: 1e-12,
    measure: || by_hand_error(-2.0 / 3.0),
    control: || by_hand_error(-2.0 / 3.0 * 1.0001),
};

fn by_hand_error(two_thirds: f64) -> f64 {
    let directions = circumferential();
    let law = DISPERSED.law();
    let mut random = Random(46);
    (0..1000).fold(0.0, |worst: f64, _| {
        let f = random.deformation(0.12);
        let by_hand = goh_stress(&DISPERSED, &f, &directions, two_thirds);
        worse(worst, (stress(&law, &f, &directions) - by_hand).norm() / by_hand.norm())
    })
}

/// Stress of the dispersed law from its derivatives on paper.
fn goh_stress(artery: &Artery, f: &Mat3, directions: &[Vec3], two_thirds: f64) -> Mat3 {
    let Artery { c, k1, k2, kappa, d } = *artery;
    let h = cofactor(f);
    let j = f.determinant();
    let shrink = libm::pow(j, -2.0 / 3.0);
    let i1_bar = shrink * f.norm_squared();
    let (mut by_i1, mut sigma_f, mut by_j) = (c, Mat3::zeros(), 0.0);
    for a in directions {
        let m = f * a;
        let i4_bar = shrink * m.norm_squared();
        let strain = kappa * (i1_bar - 3.0) + (1.0 - 3.0 * kappa) * (i4_bar - 1.0);
        if strain > 0.0 {
            let slope = k1 * strain * libm::exp(k2 * strain * strain);
            by_i1 += slope * kappa;
            let by_i4 = slope * (1.0 - 3.0 * kappa);
            sigma_f += 2.0 * by_i4 * shrink * m * a.transpose();
            by_j += two_thirds * by_i4 * i4_bar / j;
        }
    }
    sigma_f += 2.0 * by_i1 * shrink * f;
    by_j += two_thirds * by_i1 * i1_bar / j + (j - 1.0 / j) / d;
    sigma_f + by_j * h
}

/// A wrong derivative keeps a constant error; a right one loses it at the order of the difference.
pub(crate) const ORDER: Claim = Claim {
    topic: Topic::Energies,
    claim: "central differences of psi approach the traced stress at second order",
    source: "Taylor's theorem; the order is measured, not a tolerance",
    because: "the next term is of relative size step^2 times the fifth over the third derivative, below 1e-2",
    bound: 0.02,
    measure: || order_error(1.0),
    control: || order_error(1.0 + 1e-4),
};

/// The errors over the step, for the law and for a stress off by 1e-4.
pub(crate) const ORDER_FIGURE: Illustration = Illustration {
    claim: ORDER.claim,
    figure: || {
        let errors =
            |scale: f64| [8e-4, 4e-4, 2e-4, 1e-4].map(|step| (step, difference_error(scale, step))).to_vec();
        let lines = [("derived stress", errors(1.0)), ("wrong by 1e-4", errors(1.0 + 1e-4))];
        orders(
            "Differences of the energy against the stress",
            ("step", ""),
            ("error of the stress", ""),
            &lines,
            2.0,
        )
    },
};

fn order_error(scale: f64) -> f64 {
    let order = libm::log2(difference_error(scale, 4e-4) / difference_error(scale, 2e-4));
    (order - 2.0).abs()
}

/// `|P − P_differences|` with central differences over `step`, Pa; the stress off by a factor.
fn difference_error(scale: f64, step: f64) -> f64 {
    let directions = circumferential();
    let law = DISPERSED.law();
    let f = Mat3::new(1.05, 0.03, -0.01, 0.02, 0.99, 0.02, 0.01, -0.02, 1.01);
    let p = scale * stress(&law, &f, &directions);
    let difference = Mat3::from_fn(|i, j| {
        let mut e = Mat3::zeros();
        e[(i, j)] = step;
        (density(&law, &(f + e), &directions) - density(&law, &(f - e), &directions)) / (2.0 * step)
    });
    (p - difference).norm()
}

/// Strain energy of one state.
pub(crate) fn density(law: &Law, f: &Mat3, directions: &[Vec3]) -> f64 {
    let mut out = [0.0];
    let maps = Maps { f: &[*f], h: None, j: None };
    law.density(maps, Directions::Uniform(directions), &mut out, &mut Scratch::default());
    out[0]
}

/// The tangent is that of a potential.
pub(crate) const SYMMETRY: Claim = Claim {
    topic: Topic::Energies,
    claim: "the tangent of the artery has major symmetry",
    source: "second derivatives commute",
    because: "sums of some 100 terms, each rounded to 1.1e-16",
    bound: 1e-14,
    measure: || asymmetry(true),
    control: || asymmetry(false),
};

/// Asymmetry of the tangent; else of the slope of the stress while `J` is held.
fn asymmetry(whole: bool) -> f64 {
    let directions = circumferential();
    let law = DISPERSED.law();
    let mut random = Random(9);
    (0..100).fold(0.0, |worst: f64, _| {
        let f = random.deformation(0.1);
        let mut tangent = law.tangent(&f, &directions, Kink::Slack);
        if !whole {
            let (h, j, step) = (cofactor(&f), f.determinant(), 1e-6);
            let at = |f: &Mat3| {
                let sigma = law.conjugate_stresses(f, &h, j, &directions);
                sigma.sigma_f + cross(&sigma.sigma_h, f) + sigma.sigma_j * h
            };
            for place in 0..9 {
                let mut e = Mat3::zeros();
                e.as_mut_slice()[place] = step;
                let slope = (at(&(f + e)) - at(&(f - e))) / (2.0 * step);
                tangent.column_mut(place).copy_from_slice(slope.as_slice());
            }
        }
        worse(worst, (tangent - tangent.transpose()).norm() / tangent.norm())
    })
}

/// The law is blind to the observer.
pub(crate) const OBJECTIVITY: Claim = Claim {
    topic: Topic::Energies,
    claim: "a rotation after the deformation rotates the stress: P(QF) = Q P(F)",
    source: "objectivity; invariants of C only",
    because: "QF is rounded to 1e-16 and exp multiplies the error of its argument, as above",
    bound: 1e-12,
    measure: || objectivity_error(false),
    control: || objectivity_error(true),
};

fn objectivity_error(rotate_the_reference: bool) -> f64 {
    let directions = circumferential();
    let law = DISPERSED.law();
    let mut random = Random(1872);
    (0..1000).fold(0.0, |worst: f64, _| {
        let f = random.deformation(0.12);
        let q = random.rotation();
        let rotated = if rotate_the_reference {
            stress(&law, &(f * q), &directions)
        } else {
            stress(&law, &(q * f), &directions)
        };
        let p = stress(&law, &f, &directions);
        let expected = if rotate_the_reference { p * q } else { q * p };
        worse(worst, (rotated - expected).norm() / p.norm())
    })
}

/// Nothing pulls on a body at rest.
pub(crate) const STRESS_FREE: Claim = Claim {
    topic: Topic::Energies,
    claim: "the reference configuration is free of stress",
    source: "P(I) = 0",
    because: "2 C and its pressure, each rounded to 1.1e-16, relative to 2 C",
    bound: 1e-15,
    measure: || stress_at_rest(0.0),
    control: || stress_at_rest(1e-13),
};

/// `|P|/(2C)` at a dilation.
fn stress_at_rest(dilation: f64) -> f64 {
    let f = (1.0 + dilation) * Mat3::identity();
    stress(&ARTERY.law(), &f, &circumferential()).norm() / (2.0 * ARTERY.c)
}
