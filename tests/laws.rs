//! Energies and directions of materials resolve to the formulas that were written.

#[path = "support/resolved.rs"]
mod resolved;

use resolved::{at, axial, resolve_with, whole};
use tissue::energy::{Invariant, Leaf};
use tissue::scene::*;

/// The energy at invariants given by a function, the parameters as in the file.
fn energy(material: &Material, invariant: impl Fn(Invariant) -> f64) -> f64 {
    let leaf = |leaf: &Leaf| match leaf {
        Leaf::Parameter(index) => material.parameters[*index as usize].value,
        Leaf::Invariant(which) => invariant(*which),
        Leaf::Running(_) => panic!("the energy has no integral"),
    };
    material.energy.evaluate(leaf, &mut Vec::new())
}

#[test]
fn the_adventitias_energy_is_the_formula_of_the_paper() {
    let scene = axial(&[]);
    let material = &scene.materials[0];
    // Equations 46 and 47 with Table 1, written by hand.
    let (c, k1, k2, kappa, d) = (7640.0, 996.6e3, 524.6, 0.226, 1e-7);
    for (i1, i4, j) in [(3.0, [1.0, 1.0], 1.0), (3.1, [1.08, 0.9], 1.002), (3.02, [1.01, 1.03], 0.97)] {
        let fibre = |i4: f64| {
            let e: f64 = kappa * (i1 - 3.0) + (1.0 - 3.0 * kappa) * (i4 - 1.0);
            f64::exp(k2 * e.max(0.0).powi(2)) - 1.0
        };
        let psi = c * (i1 - 3.0)
            + k1 / (2.0 * k2) * (fibre(i4[0]) + fibre(i4[1]))
            + ((j * j - 1.0) / 2.0 - f64::ln(j)) / d;
        let computed = energy(material, |invariant| match invariant {
            Invariant::I1Bar => i1,
            Invariant::I4Bar(a) => i4[usize::from(a)],
            Invariant::J => j,
            other => panic!("the energy reads {other:?}"),
        });
        // Some thirty operations, the exponent of at most 12 amplifying the error of its argument.
        assert!((computed - psi).abs() <= 1e-13 * psi.abs(), "{computed} {psi}");
    }
}

#[test]
fn the_fibres_are_tilted_from_theta_towards_z() {
    let scene = axial(&[]);
    let angle = 49.98 * std::f64::consts::PI / 180.0;
    let directions = &scene.materials[0].directions;
    assert_eq!(directions.len(), 2);
    for (direction, sign) in directions.iter().zip([1.0, -1.0]) {
        let found = direction.components.each_ref().map(|tape| at(tape, [0.0; 3], 0.0));
        let expected = [sign * f64::sin(angle), f64::cos(angle), 0.0];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15);
        }
    }
}

const LAWS: &str = "tissue 1
energy holzapfel_ogden {
  param a_f : pressure > 0
  param a_fs : pressure > 0
  direction f
  direction s
  let stretch(d) = I4(d) - 1
  psi = a_f*pos(stretch(f))^2 + a_fs*I8(f, s)^2 + a_fs*E(s, f)^2
}
energy ogden {
  param mu[n]    : pressure
  param alpha[n] : number
  psi = sum(i in 1 .. n, mu[i]/alpha[i] * (lam1bar^alpha[i] + lam2bar^alpha[i] + lam3bar^alpha[i] - 3))
}
energy vol {
  param K : pressure > 0 = 1 MPa
  psi = K/2 * (J - 1)^2
}
material heart {
  param scale : number > 0 = 2
  let a = scale * 3 kPa
  energy  = holzapfel_ogden(a_f = a, a_fs = 2 kPa, f = f0, s = sheet) + ogden(mu = [630 kPa, -10 kPa], alpha = [1.3, -2]) + vol()
  density = 1060 kg/m^3
  frame { other = [0, 0, 1]  sheet = [0, 1, 0] }
  fibre f0 = [1, 0, 0]
}
";

#[test]
fn directions_arrays_and_lets_reach_the_energy() {
    let document = whole(resolve_with("laws.tissue", LAWS, &[]));
    let heart = &document.materials[0];
    let names: Vec<&str> = heart.directions.iter().map(|direction| direction.name.as_str()).collect();
    // The fibre, and of the frame only what the energy names.
    assert_eq!(names, ["f0", "sheet"]);
    let names: Vec<&str> = heart.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    let expected = [
        "scale",
        "holzapfel_ogden.a_fs",
        "ogden.mu[1]",
        "ogden.mu[2]",
        "ogden.alpha[1]",
        "ogden.alpha[2]",
        "vol.K",
    ];
    assert_eq!(names, expected);
    let (i4, i8, e, lam, j) = (1.2, 0.1, 0.05, [1.1, 1.0, 0.9], 1.01);
    let computed = energy(heart, |invariant| match invariant {
        Invariant::I4(0) => i4,
        Invariant::I8(0, 1) => i8,
        Invariant::Green(0, 1) => e,
        Invariant::StretchBar(index) => lam[usize::from(index)],
        Invariant::J => j,
        other => panic!("the energy reads {other:?}"),
    });
    let term =
        |mu: f64, alpha: f64| mu / alpha * (lam.iter().map(|l| f64::powf(*l, alpha)).sum::<f64>() - 3.0);
    let psi = 6e3 * (i4 - 1.0f64).powi(2)
        + 2e3 * i8 * i8
        + 2e3 * e * e
        + term(630e3, 1.3)
        + term(-10e3, -2.0)
        + 0.5e6 * (j - 1.0f64).powi(2);
    assert!((computed - psi).abs() < 1e-12 * psi.abs(), "{computed} {psi}");
}

#[test]
fn a_unit_ends_before_a_function_or_a_list() {
    let law = |psi: &str| {
        let text = format!(
            "tissue 1
import std.energies {{ vol_quadratic }}
energy soft {{ param n[k] : number > 0  psi = {psi} }}
material gel {{ energy = soft(n = [1, 2]) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }}"
        );
        let document = whole(resolve_with("text", &text, &[]));
        energy(&document.materials[0], |invariant| if invariant == Invariant::J { 1.0 } else { 3.5 })
    };
    assert_eq!(law("1 kPa*exp(I1bar - 3)"), law("1 kPa * exp(I1bar - 3)"));
    assert_eq!(law("2 N/mm^2*sqrt(I1bar - 3 + 1)"), law("(2 MPa) * sqrt(I1bar - 3 + 1)"));
    assert_eq!(law("2 kPa*n[2]*(I1bar - 3)"), law("2 kPa * n[2] * (I1bar - 3)"));
}

#[test]
fn every_energy_of_the_library_is_sound() {
    for file in library() {
        let text = format!("tissue 1\nimport std.{} {{ {} }}\n", file.library, file.name);
        whole(resolve_with("text", &text, &[]));
    }
}
