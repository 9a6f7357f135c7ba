//! Materials of generated scenes: those of the library, and its energies with numbers of their own.
//!
//! Owns which parameters an energy is given. Knows no body.

use super::number;
use proptest::prelude::*;
use tissue::scene::library;

/// A material.
#[derive(Debug, Clone)]
pub enum Law {
    /// An energy of the library with numbers, and a volumetric part of `10^ratio` shear moduli.
    Made {
        /// Which matrix, and numbers between 0 and 1 for its parameters.
        matrix: (usize, [f64; 3]),
        /// Which volumetric part.
        volumetric: usize,
        /// Decimal logarithm of K/μ.
        ratio: f64,
        /// Fibre families, none for matrices without.
        fibres: Vec<Fibre>,
        /// Decimal logarithm of the shear modulus in Pa.
        modulus: f64,
    },
    /// A material of the library by number.
    Library(usize),
}

/// A direction: of the same everywhere, or about the z axis through the middle, at an angle to the plane.
#[derive(Debug, Clone)]
pub enum Fibre {
    /// Components, not of unit length.
    Straight([f64; 3]),
    /// Helix angle, degrees.
    Winding(f64),
}

const VOLUMETRIC: [(&str, &str); 7] = [
    ("vol_quadratic", "K = {K} Pa"),
    ("vol_log", "K = {K} Pa"),
    ("vol_miehe", "K = {K} Pa"),
    ("vol_liu", "K = {K} Pa"),
    ("vol_ogden", "K = {K} Pa, b = 9"),
    ("vol_hartmann_neff", "K = {K} Pa"),
    ("vol_bischoff", "K = {K} Pa, a = 5"),
];

/// How many matrices there are; those from [`FIBROUS`] on have fibres.
const MATRICES: usize = 11;
const FIBROUS: usize = 8;

/// A matrix of shear modulus `mu` Pa with numbers between 0 and 1 for what else it has.
fn matrix(which: usize, mu: f64, [a, b, c]: [f64; 3]) -> (&'static str, String) {
    let log = |low: f64, high: f64, share: f64| number(low * (high / low).powf(share));
    let part = |share: f64| number(mu * share);
    match which {
        0 => ("neo_hooke", format!("mu = {} Pa", part(1.0))),
        1 => ("mooney_rivlin", format!("c1 = {} Pa, c2 = {} Pa", part(0.5 - 0.3 * a), part(0.3 * a))),
        2 => ("gent", format!("mu = {} Pa, Jm = {}", part(1.0), log(1.0, 100.0, a))),
        3 => {
            let [first, second] = [part(1.0), part(2.0 * b)];
            ("yeoh", format!("C10 = {} Pa, C20 = {} Pa, C30 = {first} Pa", part(0.5), second))
        }
        4 => ("fung_demiray", format!("a = {} Pa, b = {}", part(1.0), log(0.5, 30.0, a))),
        5 => {
            let (first, second) = (1.5 + 2.0 * a, -1.5 - 2.0 * b);
            let weight = |share: f64, exponent: f64| part(2.0 * share / exponent);
            let (al, mu) = (format!("[{first:.3}, {second:.3}]"), [weight(0.7, first), weight(0.3, second)]);
            ("ogden", format!("mu = [{} Pa, {} Pa], al = {al}", mu[0], mu[1]))
        }
        6 => ("arruda_boyce", format!("mu = {} Pa, N = {}", part(1.0), log(3.0, 50.0, a))),
        7 => ("veronda_westmann", format!("c1 = {} Pa, c2 = {}", part(0.5), number(1.0 + 4.0 * a))),
        8 => {
            let (k1, k2) = (part(0.1 * 1000.0_f64.powf(a)), log(0.5, 100.0, b));
            ("goh", format!("C = {} Pa, k1 = {k1} Pa, k2 = {k2}, kappa = {:.3}", part(0.5), 0.33 * c))
        }
        9 => {
            let (k1, k2) = (part(0.1 * 1000.0_f64.powf(a)), log(0.5, 100.0, b));
            ("hgo", format!("c = {} Pa, k1 = {k1} Pa, k2 = {k2}", part(1.0)))
        }
        _ => {
            let (k1, k2) = (part(0.1 * 100.0_f64.powf(a)), log(0.5, 20.0, b));
            let spread = number(0.2 + 4.0 * c);
            ("fibres_von_mises", format!("k1 = {k1} Pa, k2 = {k2}, b = {spread}"))
        }
    }
}

fn fibres() -> impl Strategy<Value = Vec<Fibre>> {
    let part = || -1.0..1.0_f64;
    let straight = [part(), part(), part()].prop_map(|[x, y, z]| Fibre::Straight([1.0 + 0.5 * x, y, z]));
    let winding = (-80.0..80.0_f64).prop_map(Fibre::Winding);
    prop::collection::vec(prop_oneof![2 => straight, 1 => winding], 1..3)
}

/// Laws, the simplest first.
pub fn laws() -> impl Strategy<Value = Law> {
    let numbers = || [0.0..1.0_f64, 0.0..1.0, 0.0..1.0];
    let made = (0..MATRICES, numbers(), 0..VOLUMETRIC.len(), 0.3..4.0_f64, fibres(), 3.0..6.0_f64);
    let made = made.prop_map(|(which, numbers, volumetric, ratio, fibres, modulus)| Law::Made {
        matrix: (which, numbers),
        volumetric,
        ratio,
        fibres: if which >= FIBROUS { fibres } else { Vec::new() },
        modulus,
    });
    prop_oneof![3 => made, 1 => any::<prop::sample::Index>().prop_map(|at| Law::Library(at.index(materials().len())))]
}

fn materials() -> Vec<&'static str> {
    library().iter().filter(|file| file.library == "materials").map(|file| file.name).collect()
}

impl Law {
    /// What stands before the scene, and the material's name; `middle` m is where winding fibres turn about.
    pub fn describe(&self, middle: f64) -> (String, &'static str) {
        match self {
            Self::Library(at) => {
                let name = materials()[*at];
                (format!("import std.materials {{ {name} }}\n"), name)
            }
            Self::Made { matrix: (which, numbers), volumetric, ratio, fibres, modulus } => {
                let mu = 10.0_f64.powf(*modulus);
                let (name, arguments) = matrix(*which, mu, *numbers);
                let (part, form) = VOLUMETRIC[*volumetric];
                let bulk = form.replace("{K}", &number(mu * 10.0_f64.powf(*ratio)));
                let (import, own) = match name {
                    "fibres_von_mises" => (", neo_hooke", format!("neo_hooke(mu = {} Pa) + ", number(mu))),
                    _ => ("", String::new()),
                };
                let lines: String =
                    fibres.iter().enumerate().map(|(i, fibre)| fibre.line(i, middle)).collect();
                let text = format!(
                    "import std.energies {{ {name}, {part}{import} }}\nmaterial tissue {{\n  energy = {own}{name}({arguments})\n    \
                     + {part}({bulk})\n  density = 1000 kg/m^3\n{lines}}}\n"
                );
                (text, "tissue")
            }
        }
    }
}

impl Fibre {
    fn line(&self, index: usize, middle: f64) -> String {
        let name = index + 1;
        match self {
            Self::Straight(n) => {
                let [x, y, z] = n.map(|x| format!("{x:.2}"));
                format!("  fibre a{name} = unit([{x}, {y}, {z}])\n")
            }
            Self::Winding(angle) => {
                let (c, s) = (angle.to_radians().cos(), angle.to_radians().sin());
                // off the axis by a millionth of a metre, so that it has a direction on it too
                let at = number(middle);
                let from = number(middle - 1e-6);
                let (x, y) = (format!("(X - {at} m)"), format!("(Y - {from} m)"));
                let length = format!("sqrt({x}^2 + {y}^2)");
                format!("  fibre a{name} = unit([-{c:.3}*{y}, {c:.3}*{x}, {s:.3}*{length}])\n")
            }
        }
    }
}
