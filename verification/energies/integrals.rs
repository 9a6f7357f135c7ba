//! Laws that are integrals, against integrals on paper.

use super::derivatives::density;
use super::known_values::stress;
use super::laws::{Random, worse};
use crate::energy::Law;
use crate::scene::{Memory, resolve};
use crate::syntax::Source;
use crate::tensor::{Mat3, Vec3};
use crate::verify::{Claim, Topic};
use std::f64::consts::PI;

/// The law of `(J − 1)² + psi`, Pa, written as text; the first axis is its direction `a`.
fn written(psi: &str) -> Law {
    let text = format!(
        "tissue 1
energy tested {{
  direction a
  psi = 1 Pa*((J - 1)^2 + {psi})
}}
material m {{
  energy  = tested(a = along)
  density = 1 kg/m^3
  fibre along = [1, 0, 0]
}}
"
    );
    let source = Source { name: "claim.tissue".into(), text };
    let (document, mistakes) = resolve(&source, &Memory::default(), &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    let material = document.materials.first().expect("the text has a material");
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    Law::compile(&material.energy, &values).expect("the laws of the claims are complete")
}

/// The rule of a degree over the whole sphere.
pub(crate) const SPHERE: Claim = Claim {
    topic: Topic::Energies,
    claim: "an integral over directions is exact to its degree: int (I4(n) - 1)^2 dS at degree 4, stress and energy",
    source: "int (n.A n)^2 dS = 4 pi/15 ((tr A)^2 + 2 A:A), A = C - I",
    because: "sums of some twenty directions, each rounded to 1e-16, of terms that cancel tenfold",
    bound: 2e-14,
    measure: || sphere_error("4"),
    control: || sphere_error("3"),
};

fn sphere_error(order: &str) -> f64 {
    let law = written(&format!("integrate(n in sphere({order}), (I4(n) - 1)^2)"));
    let mut random = Random(4);
    (0..50).fold(0.0, |worst, _| {
        let f = random.deformation(0.3);
        let a = f.transpose() * f - Mat3::identity();
        let volume = f.determinant() - 1.0;
        let share = 4.0 * PI / 15.0;
        let psi = share * (a.trace() * a.trace() + 2.0 * a.norm_squared());
        let by_c = share * (2.0 * a.trace() * Mat3::identity() + 4.0 * a);
        let p = 2.0 * f * by_c + 2.0 * volume * crate::tensor::cofactor(&f);
        let worst = worse(worst, (stress(&law, &f, &[Vec3::x()]) - p).norm() / p.norm());
        worse(worst, (density(&law, &f, &[Vec3::x()]) / (psi + volume * volume) - 1.0).abs())
    })
}

/// The rule that ends where directions slacken.
pub(crate) const STRETCHED: Claim = Claim {
    topic: Topic::Energies,
    claim: "the sum over stretched directions alone is that on paper, in tension of a bar and of a sheet, turned at will",
    source: "I4bar - 1 = p + (q - p) z^2 about the odd axis, integrated over its positive part: polynomials in z",
    because: "an arc of Gauss's rule, exact for the polynomial of degree 4; its end is rounded to 1e-16 over the strain of 1e-2",
    bound: 1e-12,
    measure: || stretched_error(", I4bar(n) > 1", "I4bar(n) - 1"),
    control: || stretched_error("", "pos(I4bar(n) - 1)"),
};

fn stretched_error(part: &str, strain: &str) -> f64 {
    let law = written(&format!("integrate(n in sphere(16{part}), ({strain})^2)"));
    let mut random = Random(16);
    [1.01, 1.1, 1.4].iter().fold(0.0, |worst, &stretch| {
        let pulled = Vec3::new(stretch, 1.0 / stretch.sqrt(), 1.0 / stretch.sqrt());
        let sheet = Vec3::new(stretch, stretch, 1.0 / (stretch * stretch));
        // squared strains along the odd axis and across it, and the positive part of the heights
        let bar = on_paper([pulled.x, pulled.y], |root| [root, 1.0]);
        let flat = on_paper([sheet.z, sheet.x], |root| [0.0, root]);
        [(pulled, bar), (sheet, flat)].iter().fold(worst, |worst, &(stretches, psi)| {
            let (r, q) = (random.rotation(), random.rotation());
            let f = r * Mat3::from_diagonal(&stretches) * q.transpose();
            worse(worst, (density(&law, &f, &[Vec3::x()]) / psi - 1.0).abs())
        })
    })
}

/// `4 pi int (p + (q − p) z²)² dz` where the strain is positive, `q` along the odd axis.
fn on_paper([along, across]: [f64; 2], part: impl Fn(f64) -> [f64; 2]) -> f64 {
    let (q, p) = (along * along - 1.0, across * across - 1.0);
    let [low, high] = part((p / (p - q)).sqrt());
    let to = |z: f64| {
        let (z3, z5) = (z * z * z, z * z * z * z * z);
        p * p * z + 2.0 * p * (q - p) * z3 / 3.0 + (q - p) * (q - p) * z5 / 5.0
    };
    4.0 * PI * (to(high) - to(low))
}

/// The stress of the stretched directions is the slope of their energy, also where a sheet keeps its width.
pub(crate) const STRETCHED_STRESS: Claim = Claim {
    topic: Topic::Energies,
    claim: "the stress summed over stretched directions is the slope of the energy on paper along the stretch",
    source: "d psi/d lambda of the same polynomials, by Richardson's differences",
    because: "differences of step 1e-3, extrapolated, err by a quarter of 1e-12 times a fifth derivative, some 10 slopes",
    bound: 3e-12,
    measure: || stretched_stress_error(1.0),
    control: || stretched_stress_error(1.0 + 1e-6),
};

fn stretched_stress_error(factor: f64) -> f64 {
    let law = written("integrate(n in sphere(16, I4bar(n) > 1), (I4bar(n) - 1)^2)");
    let psi = |stretch: f64| on_paper([stretch, 1.0 / stretch.sqrt()], |root| [root, 1.0]);
    let difference = |l: f64, h: f64| (psi(l + h) - psi(l - h)) / (2.0 * h);
    [1.05, 1.2, 1.5].iter().fold(0.0, |worst, &l| {
        let slope = (4.0 * difference(l, 0.5e-3) - difference(l, 1e-3)) / 3.0;
        let f = Mat3::from_diagonal(&Vec3::new(l, 1.0 / l.sqrt(), 1.0 / l.sqrt()));
        let p = stress(&law, &f, &[Vec3::x()]);
        // dF/dl = diag(1, -1/2 l^(-3/2), ...)
        let power = p[(0, 0)] - 0.5 * (p[(1, 1)] + p[(2, 2)]) / (l * l.sqrt());
        worse(worst, (factor * power / slope - 1.0).abs())
    })
}

/// Exponential integral for positive arguments, `gamma + ln x + sum x^k/(k k!)`.
fn exponential_integral(x: f64) -> f64 {
    const EULER: f64 = 0.577_215_664_901_532_9;
    let (mut term, mut sum) = (1.0, 0.0);
    for k in 1..400 {
        term *= x / f64::from(k);
        sum += term / f64::from(k);
    }
    EULER + libm::log(x) + sum
}

/// A law given by its slope.
pub(crate) const SLOPE: Claim = Claim {
    topic: Topic::Energies,
    claim: "a fibre given by its slope (exp(48 (l - 1)) - 1)/l has the energy exp(-48) (Ei(48 l) - Ei(48)) - ln l",
    source: "Weiss et al. 1996; the exponential integral by its series",
    because: "Ei is a sum of positive terms, rounded to 1e-15; its difference and that of ln l cancel a hundredfold at stretch 1.01",
    bound: 3e-13,
    measure: || energy_error(48.0),
    control: || energy_error(48.0 * (1.0 + 1e-9)),
};

const BY_SLOPE: &str = "integrate(s in 1 .. sqrt(I4(a)), (exp(48*(s - 1)) - 1)/s)";

fn energy_error(c4: f64) -> f64 {
    let law = written(BY_SLOPE);
    [1.01, 1.03, 1.062, 1.2, 1.5].iter().fold(0.0, |worst, &l| {
        let width = 1.0 / f64::sqrt(l);
        let f = Mat3::from_diagonal(&Vec3::new(l, width, width));
        let difference = exponential_integral(c4 * l) - exponential_integral(c4);
        let psi = libm::exp(-c4) * difference - libm::log(l);
        worse(worst, (density(&law, &f, &[Vec3::x()]) / psi - 1.0).abs())
    })
}

/// Its derivatives are the integrand's.
pub(crate) const SLOPE_STRESS: Claim = Claim {
    topic: Topic::Energies,
    claim: "the stress of a fibre given by its slope is that slope, whatever quadrature gives its energy",
    source: "fundamental theorem of calculus",
    because: "some ten operations; exp turns the rounding of its argument 48 (l - 1), up to 96, into 7e-15",
    bound: 1e-14,
    measure: || slope_error(48.0),
    control: || slope_error(48.0 * (1.0 + 1e-12)),
};

fn slope_error(c4: f64) -> f64 {
    let law = written(BY_SLOPE);
    [1.01, 1.062, 1.5, 3.0].iter().fold(0.0, |worst, &l| {
        let f = Mat3::from_diagonal(&Vec3::new(l, 1.0, 1.0 / l));
        let slope = libm::expm1(c4 * (l - 1.0)) / l;
        worse(worst, (stress(&law, &f, &[Vec3::x()])[(0, 0)] / slope - 1.0).abs())
    })
}
