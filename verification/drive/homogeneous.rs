//! Uniaxial tension of oblique fibre laws against a material-point code of another author.
//!
//! Its stresses are hand-written and its Jacobian comes from complex steps; ours are derived by
//! automatic differentiation. Both solve for the free shears and lateral stretches.

use super::super::energies::laws::{Artery, compiled, goh};
use super::Claim;
use crate::drive::{Drive, Point, Target, Volume};
use crate::output::Table;
use crate::tensor::Vec3;
use crate::verify::claim::Topic;

/// A table with what it was computed for.
pub(super) struct Case {
    text: &'static str,
    pub(super) law: Artery,
    /// Angles of the families to the axis of tension, degrees.
    pub(super) angles: [f64; 2],
    volume: Volume,
}

macro_rules! reference {
    ($name:literal) => {
        include_str!(concat!("../references/hom_", $name, ".csv"))
    };
}

const TISSUE: Artery = Artery { c: 7.64e3, k1: 996.6e3, k2: 524.6, kappa: 0.0, d: 1e-7 };
const DERMIS: Artery = Artery { c: 0.1007e6, k1: 24.53e6, k2: 0.1327, kappa: 0.0, d: 1e-7 };

const fn artery(text: &'static str, kappa: f64, angles: [f64; 2]) -> Case {
    Case { text, law: Artery { kappa, ..TISSUE }, angles, volume: Volume::Compressible }
}

const fn skin(text: &'static str, kappa: f64, angles: [f64; 2], volume: Volume) -> Case {
    Case { text, law: Artery { kappa, ..DERMIS }, angles, volume }
}

pub(super) const ARTERIES: [Case; 6] = [
    artery(reference!("artery_uni_15_k0226_D1e-7perPa"), 0.226, [34.98, -64.98]),
    artery(reference!("artery_uni_15_k0_D1e-7perPa"), 0.0, [34.98, -64.98]),
    artery(reference!("artery_uni_axial_k0226_D1e-7perPa"), 0.226, [40.02, -40.02]),
    artery(reference!("artery_uni_axial_k0_D1e-7perPa"), 0.0, [40.02, -40.02]),
    artery(reference!("artery_uni_circ_k0226_D1e-7perPa"), 0.226, [49.98, -49.98]),
    artery(reference!("artery_uni_circ_k0_D1e-7perPa"), 0.0, [49.98, -49.98]),
];

const SKINS: [Case; 3] = [
    skin(reference!("skin_uni_asymmetric_D1e-7perPa"), 0.1602, [17.0, -65.0], Volume::Compressible),
    skin(reference!("skin_uni_parallel_D1e-7perPa"), 0.1535, [43.0, -39.0], Volume::Compressible),
    skin(reference!("skin_uni_perpendicular_D1e-7perPa"), 0.1459, [-49.0, 49.0], Volume::Compressible),
];

const INCOMPRESSIBLE_SKINS: [Case; 3] = [
    skin(reference!("skin_uni_asymmetric_incompressible"), 0.1602, [17.0, -65.0], Volume::Incompressible),
    skin(reference!("skin_uni_parallel_incompressible"), 0.1535, [43.0, -39.0], Volume::Incompressible),
    skin(reference!("skin_uni_perpendicular_incompressible"), 0.1459, [-49.0, 49.0], Volume::Incompressible),
];

/// Six tables of the artery, both dispersions, three cuts.
pub(crate) const ARTERY: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "a material point of the artery follows an independent code in stress, shear and stretches",
    source: "hom_artery_uni_*.csv",
    because: "the bulk term's round-off, ten times 20 MPa times 1.1e-16 in each of two programs, over the \
              smallest stress, 120 Pa: 4e-10",
    bound: 5e-10,
    measure: || worst(&ARTERIES, |_| {}),
    // A fibre turned by a hundredth of a degree.
    control: || worst(&ARTERIES, |case| case.angles[0] += 0.01),
};

/// Three tables of compressible skin.
pub(crate) const SKIN: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "a material point of compressible skin follows an independent code in stress, shear and stretches",
    source: "hom_skin_uni_*_D1e-7perPa.csv",
    because: "the bulk term's round-off, ten times 20 MPa times 1.1e-16 in each of two programs, over the \
              smallest stress, 6.6 kPa: 7e-12",
    bound: 1e-11,
    measure: || worst(&SKINS, |_| {}),
    // The dispersion in its sixth digit.
    control: || worst(&SKINS, |case| case.law.kappa *= 1.000_01),
};

/// Three tables of incompressible skin.
pub(crate) const INCOMPRESSIBLE_SKIN: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "a material point of incompressible skin follows an independent code in stress, shear and stretches",
    source: "hom_skin_uni_*_incompressible.csv",
    because: "round-off of the fibres, ten times 25 MPa times 1.1e-16 in each of two programs, over the \
              smallest stress, 6.6 kPa: 8e-12",
    bound: 1e-11,
    measure: || worst(&INCOMPRESSIBLE_SKINS, |_| {}),
    control: || worst(&INCOMPRESSIBLE_SKINS, |case| case.law.k2 *= 1.000_01),
};

/// The tractions that should vanish do.
pub(crate) const EQUILIBRIUM: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "lateral tractions of a driven material point vanish to 1e-12 of the largest stress of its path",
    source: "definition of uniaxial tension",
    because: "round-off of the bulk term, ten times 20 MPa times 1.1e-16, over the smallest end stress, \
              29 kPa: 8e-13",
    bound: 1e-12,
    measure: || largest_traction(&ARTERIES),
    // The lateral stretches of an incompressible solid, the usual shortcut, leave a traction.
    control: shortcut,
};

pub(super) fn directions(angles: [f64; 2]) -> [Vec3; 2] {
    angles.map(|degrees| {
        let angle = degrees.to_radians();
        Vec3::new(libm::cos(angle), libm::sin(angle), 0.0)
    })
}

/// The points of a case at the stretches of its table.
pub(super) fn driven(case: &Case, stretches: &[f64]) -> Vec<Point> {
    let law = compiled(&goh(2, true), &case.law.parameters());
    let directions = directions(case.angles);
    let drive = Drive { volume: case.volume, ..Drive::new(&law, &directions) };
    drive.follow(Target::uniaxial, stretches).unwrap_or_default()
}

/// Largest difference to the tables: stresses relative, components of F absolute.
fn worst(cases: &[Case], change: impl Fn(&mut Case)) -> f64 {
    cases.iter().map(|case| difference(case, &change)).fold(0.0, f64::max)
}

/// Column of a table, the same number of a point, whether they are compared relatively.
type Compared = (&'static str, fn(&Point) -> f64, bool);

fn difference(case: &Case, change: impl Fn(&mut Case)) -> f64 {
    let mut changed = Case { law: Artery { ..case.law }, ..*case };
    change(&mut changed);
    let table = Table::parse("homogeneous", case.text).expect("the reference is a table");
    let column = |name: &str| table.column(name).expect("the reference has its columns");
    let stretches = column("stretch_x");
    let points = driven(&changed, &stretches);
    if points.len() != stretches.len() {
        return f64::INFINITY;
    }
    let compared: [Compared; 6] = [
        ("sigma_xx_Pa", |point| point.cauchy[(0, 0)], true),
        ("P_xx_Pa(nominal;uniaxial only)", |point| point.first_piola[(0, 0)], true),
        ("lam_y(F22)", |point| point.f[(1, 1)], false),
        ("lam_z(F33)", |point| point.f[(2, 2)], false),
        ("F12", |point| point.f[(0, 1)], false),
        ("J", |point| point.j, false),
    ];
    let mut worst = 0.0_f64;
    for (name, value, is_relative) in compared {
        // The first row is the state of rest, where both are zero.
        for (point, reference) in points.iter().zip(column(name)).skip(1) {
            let error = (value(point) - reference).abs();
            worst = worst.max(if is_relative { error / reference.abs() } else { error });
        }
    }
    worst
}

/// Largest traction that should vanish, over the largest stress of its path.
fn largest_traction(cases: &[Case]) -> f64 {
    let mut worst = 0.0_f64;
    for case in cases {
        let stretches: Vec<f64> = (0..=60).map(|i| 1.0 + 0.005 * f64::from(i)).collect();
        let points = driven(case, &stretches);
        let largest = points.iter().map(|point| point.cauchy[(0, 0)]).fold(0.0, f64::max);
        let tractions = points.iter().flat_map(|point| {
            [(1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(i, j)| point.cauchy[(i, j)].abs())
        });
        worst = worst.max(tractions.fold(0.0, f64::max) / largest);
    }
    worst
}

/// The traction left by lateral stretches `λ^(-1/2)` each.
fn shortcut() -> f64 {
    let case = &ARTERIES[4];
    let law = compiled(&goh(2, true), &case.law.parameters());
    let directions = directions(case.angles);
    let path = |l: f64| {
        let lateral = 1.0 / l.sqrt();
        Target::deformation(&crate::tensor::Mat3::from_diagonal(&Vec3::new(l, lateral, lateral)))
    };
    let points = Drive::new(&law, &directions).follow(path, &[1.0, 1.3]).unwrap_or_default();
    points.last().map_or(f64::NAN, |point| point.cauchy[(1, 1)].abs() / point.cauchy[(0, 0)])
}
