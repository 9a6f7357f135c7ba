//! The numbers `check` reports, against closed forms and other programs.

use super::laws::{
    ARTERY, Artery, DISPERSED, MATRIX, Writer, circumferential, compiled, families, goh, neo_hooke, worse,
};
use crate::energy::audit::{
    Ellipticity, Subject, baker_ericksen, ellipticity_along, moduli, one_sided, overflow_stretch,
    smallest_volumetric_stiffness, uniaxial, volumetric_growth,
};
use crate::energy::{Invariant, Law};
use crate::expression::Function;
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};

/// Elastic constants of the matrix.
pub(crate) const MODULI: Claim = Claim {
    topic: Topic::Energies,
    claim: "bulk, shear and Young's modulus and Poisson's ratio of the matrix are those of K = 2/D and mu = 2C",
    source: "linear elasticity: E = 9 K mu/(3 K + mu), nu = (3 K - 2 mu)/(2 (3 K + mu))",
    because: "a secant at strain 1e-6 errs by a few times that",
    bound: 1e-5,
    measure: || moduli_error(1.0),
    control: || moduli_error(1.001),
};

fn moduli_error(factor: f64) -> f64 {
    let (k, mu) = (2.0 / MATRIX.d, factor * 2.0 * MATRIX.c);
    let (young, poisson) = (9.0 * k * mu / (3.0 * k + mu), (3.0 * k - 2.0 * mu) / (2.0 * (3.0 * k + mu)));
    let law = MATRIX.law();
    let directions = circumferential();
    let subject = Subject { law: &law, directions: &directions };
    let found = moduli(&subject);
    let mut worst = (found.bulk / k - 1.0).abs().max((found.shear / mu - 1.0).abs());
    for strain in [1e-6, -1e-6] {
        let Some((e, nu)) = one_sided(&subject, &Vec3::new(0.6, 0.0, 0.8), strain) else {
            return f64::INFINITY;
        };
        worst = worse(worst, (e / young - 1.0).abs());
        worst = worse(worst, (nu[0] / poisson - 1.0).abs());
        worst = worse(worst, (nu[1] / poisson - 1.0).abs());
    }
    worst
}

/// Slopes on both sides of rest: kappa, angle of the families to the pull, E+ and E-, Pa.
const SLOPES: [(f64, f64, f64, f64); 3] =
    [(0.226, 49.98, 47.96e3, 45.845e3), (0.226, 40.02, 81.885e3, 45.845e3), (0.0, 40.02, 95.2e3, 45.845e3)];

/// Fibres make tension and compression differ.
pub(crate) const ONE_SIDED: Claim = Claim {
    topic: Topic::Energies,
    claim: "the artery's slopes at strains of +-1e-4 are 47.96, 81.885, 95.2 and 45.845 kPa",
    source: "reference/energies.md, another program by complex steps, incompressible",
    because: "half of the last digit given; K = 20 GPa stands for incompressible, mu/(3K) = 3e-7",
    bound: 0.05 / 95.2,
    measure: || slope_error(1e-4),
    control: || slope_error(1e-3),
};

fn slope_error(strain: f64) -> f64 {
    SLOPES.iter().fold(0.0, |worst, &(kappa, degrees, tension, compression)| {
        let law = Artery { kappa, d: 1e-10, ..ARTERY }.law();
        let directions = families(degrees);
        let subject = Subject { law: &law, directions: &directions };
        [(strain, tension), (-strain, compression)].iter().fold(worst, |worst, &(strain, expected)| {
            let found = one_sided(&subject, &Vec3::x(), strain).map_or(f64::INFINITY, |(young, _)| young);
            worse(worst, (found / expected - 1.0).abs())
        })
    })
}

/// Where the strip loses its waves without the bracket.
pub(crate) const ELLIPTICITY: Claim = Claim {
    topic: Topic::Stability,
    claim: "without the Macaulay bracket isochoric compression loses ellipticity between 0.98 and 0.95",
    source: "BENCHMARKS, section C; circumferential kappa = 0 and axial kappa = 0.226",
    because: "distance of the stretch of loss to the middle of the interval; half its width",
    bound: 0.015,
    measure: || worse(distance_of_loss(&ARTERY, 49.98, false), distance_of_loss(&DISPERSED, 40.02, false)),
    control: || distance_of_loss(&ARTERY, 49.98, true),
};

/// Distance of the loss of ellipticity from 0.965; the whole way to 0.8 and more if there is none.
fn distance_of_loss(artery: &Artery, degrees: f64, bracket: bool) -> f64 {
    let law = compiled(&goh(2, bracket), &artery.parameters());
    let path = (1..=80).map(|k| 1.0 - 0.0025 * f64::from(k));
    let (_, lost) = isochoric(&law, degrees, path);
    lost.map_or(1.0, |stretch| (stretch - 0.965).abs())
}

/// With the bracket the matrix alone carries the slowest wave.
pub(crate) const MATRIX_CARRIES: Claim = Claim {
    topic: Topic::Stability,
    claim: "with the bracket no acoustic eigenvalue falls below 2C on isochoric stretches 0.8 to 1.5",
    source: "BENCHMARKS, section C",
    because: "waves of shear and of volume couple: a share of the order of 2C/K = 8e-4 may be lost",
    bound: 8e-4,
    measure: || shortfall(true),
    control: || shortfall(false),
};

/// `1 − smallest/(2C)` over pulls and pushes along the strip, where positive.
fn shortfall(bracket: bool) -> f64 {
    let law = compiled(&goh(2, bracket), &ARTERY.parameters());
    let stretches = (0..=70).map(|k| 0.8 + 0.01 * f64::from(k));
    let (scanned, _) = isochoric(&law, 49.98, stretches);
    scanned.iter().fold(0.0, |worst, (_, found)| worse(worst, 1.0 - found.smallest / (2.0 * ARTERY.c)))
}

/// Ellipticity at isochoric stretches along the strip.
fn isochoric(
    law: &Law,
    degrees: f64,
    stretches: impl Iterator<Item = f64>,
) -> (Vec<(f64, Ellipticity)>, Option<f64>) {
    let directions = families(degrees);
    let state =
        |stretch: f64| Mat3::from_diagonal(&Vec3::new(stretch, 1.0 / stretch.sqrt(), 1.0 / stretch.sqrt()));
    let path = stretches.map(|stretch| (stretch, state(stretch)));
    ellipticity_along(&Subject { law, directions: &directions }, path)
}

/// Where the exponential ends.
pub(crate) const OVERFLOW: Claim = Claim {
    topic: Topic::Stability,
    claim: "the aligned fibre's energy leaves the range of numbers at stretch sqrt(1 + sqrt(709.8/k2)) = 1.471",
    source: "ln of the largest double is 709.78; Ebar = stretch^2 - 1",
    because: "the stress carries a factor of some 1e7 before the exponential: 16 of 710 in its argument",
    bound: 5e-3,
    measure: || overflow_error(1.0),
    control: || overflow_error(1.5),
};

fn overflow_error(stiffening: f64) -> f64 {
    let law = compiled(&goh(1, true), &Artery { k2: stiffening * ARTERY.k2, ..ARTERY }.parameters());
    let found = overflow_stretch(&Subject { law: &law, directions: &[Vec3::z()] }, &Vec3::z());
    let expected = (1.0 + (709.78 / ARTERY.k2).sqrt()).sqrt();
    found.map_or(f64::INFINITY, |found| (found / expected - 1.0).abs())
}

/// How the volumetric part grows.
pub(crate) const GROWTH: Claim = Claim {
    topic: Topic::Energies,
    claim: "the volumetric part grows as J^2 outwards and logarithmically inwards",
    source: "NB25 (47): (J^2 - 1)/2 - ln J",
    because: "logarithms of four numbers, each rounded to 1e-16, over ln 1e4",
    bound: 1e-12,
    measure: || growth_error(0.5),
    control: || growth_error(0.6),
};

fn growth_error(half: f64) -> f64 {
    let law = MATRIX.law();
    let growth = volumetric_growth(&Subject { law: &law, directions: &circumferential() });
    let psi = |j: f64| half * (j * j - 1.0) - libm::log(j);
    let slope = |low: f64, high: f64| libm::log(psi(high) / psi(low)) / libm::log(high / low);
    let inwards = (growth.towards_zero - slope(1e-8, 1e-4)).abs();
    worse(inwards, (growth.towards_infinity - slope(1e4, 1e8)).abs())
}

/// The Baker–Ericksen quotient of the neo-Hookean solid.
pub(crate) const BAKER_ERICKSEN: Claim = Claim {
    topic: Topic::Stability,
    claim: "the smallest Baker-Ericksen quotient of the neo-Hookean solid is mu J^(-5/3) (l1 + l2) of its state",
    source: "principal Cauchy stresses of NB25 (44)-(45)",
    because: "the difference of two stresses, some 1e7 Pa of bulk, over a difference of stretches of 0.1: 1e-8 Pa of 1e3 Pa",
    bound: 1e-10,
    measure: || baker_ericksen_error(1.0),
    control: || baker_ericksen_error(1.0 + 1e-8),
};

fn baker_ericksen_error(factor: f64) -> f64 {
    let mu = 15.28e3;
    let law = compiled(&neo_hooke(), &[mu, 2e7]);
    let Some(found) = baker_ericksen(&Subject { law: &law, directions: &[] }, 0.7, 1.5, 9) else {
        return f64::NAN;
    };
    let l = found.stretches;
    let expected = factor * mu * libm::pow(l.product(), -5.0 / 3.0) * (l[0] + l[1]);
    (found.smallest / expected - 1.0).abs()
}

/// A volumetric part that is not convex.
pub(crate) const CONVEXITY: Claim = Claim {
    topic: Topic::Stability,
    claim: "K/2 (ln J)^2 has stiffness K (1 - ln J)/J^2, negative beyond J = e",
    source: "second derivative on paper",
    because: "a second derivative of some 50 operations of 1.1e-16, cancelling tenfold",
    bound: 1e-13,
    measure: || convexity_error(1.0),
    control: || convexity_error(1.0 + 1e-9),
};

fn convexity_error(factor: f64) -> f64 {
    let mut w = Writer::default();
    let j = w.invariant(Invariant::J);
    let logarithm = w.call(Function::Ln, j);
    let squared = w.power(logarithm, 2.0);
    let half = w.number(0.5);
    w.multiply(half, squared);
    let law = compiled(&w.finish(), &[]);
    let (found, j) = smallest_volumetric_stiffness(&Subject { law: &law, directions: &[] }, 0.5, 3.0, 40);
    let expected = factor * (1.0 - libm::log(j)) / (j * j);
    if found < 0.0 { (found / expected - 1.0).abs() } else { f64::INFINITY }
}

/// A row of an independent table: families at +34.98 and -64.98 degrees, kappa 0.226.
pub(crate) const OBLIQUE: Claim = Claim {
    topic: Topic::Energies,
    claim: "the oblique strip, free to shear, has the tabulated stress, shear and thickness at stretch 1.2",
    source: "hom_artery_uni_15_k0226_D1e-7perPa.csv, another program's Newton iteration",
    because: "fifteen digits given; bulk stress balanced to 1e-8 Pa of 1e4 Pa",
    bound: 1e-9,
    measure: || oblique_error(1.2),
    control: || oblique_error(1.2 + 1e-6),
};

/// Row at stretch 1.2: nominal stress, Pa, `F_33`, `F_12`.
const OBLIQUE_ROW: [f64; 3] = [88_969.427_879_697, 1.024_704_898_434_79, -0.164_479_841_269_608];

fn oblique_error(stretch: f64) -> f64 {
    let law = DISPERSED.law();
    let directions = [families(34.98)[0], families(64.98)[1]];
    let subject = Subject { law: &law, directions: &directions };
    let bar = (1..=20).try_fold(Mat3::identity(), |f, k| {
        uniaxial(&subject, &Vec3::x(), 1.0 + (stretch - 1.0) * f64::from(k) / 20.0, &f).map(|bar| bar.f)
    });
    let Some(f) = bar else { return f64::INFINITY };
    let found = [subject.stress(&f)[(0, 0)], f[(2, 2)], f[(0, 1)]];
    found.iter().zip(OBLIQUE_ROW).fold(0.0, |worst, (found, row)| worse(worst, (found / row - 1.0).abs()))
}
