//! What a driven material point must not depend on: the distance of the points, the axes.

use super::super::energies::laws::{Random, compiled, goh};
use super::Claim;
use super::homogeneous::{ARTERIES, directions, driven};
use crate::drive::{Drive, Target};
use crate::tensor::{Mat3, Vec3};
use crate::verify::claim::Topic;

/// Largest stretch of the paths, 30 %.
const END: f64 = 1.3;

/// One leap through the toe of the curve and 120 small steps end in the same state.
pub(crate) const STEPS: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "a material point driven in one leap ends where 120 steps end",
    source: "uniqueness of the stable state",
    because: "round-off of the bulk term, ten times 20 MPa times 1.1e-16 at each end, over the smallest end \
              stress, 29 kPa: 2e-12",
    bound: 2e-12,
    measure: || leap(END),
    control: || leap(END + 1e-6),
};

/// Law and axes turned together turn the answer.
pub(crate) const AXES: Claim = Claim {
    topic: Topic::Benchmarks,
    claim: "turning a law and the axes of its drive turns the stresses with them",
    source: "objectivity and material symmetry",
    because: "round-off of the bulk term as for one leap; the rotations add 1e-15",
    bound: 2e-12,
    measure: || turned(true),
    // The fibres stay behind.
    control: || turned(false),
};

/// Relative difference of the end stress between one leap to `end` and small steps.
fn leap(end: f64) -> f64 {
    let stretches: Vec<f64> = (0..=120).map(|i| 1.0 + (END - 1.0) * f64::from(i) / 120.0).collect();
    let mut worst = 0.0_f64;
    for case in &ARTERIES {
        let stress = |stretches: &[f64]| driven(case, stretches).last().map(|point| point.cauchy);
        let (Some(one), Some(many)) = (stress(&[1.0, end]), stress(&stretches)) else {
            return f64::INFINITY;
        };
        worst = worst.max((one - many).norm() / many.norm());
    }
    worst
}

/// Relative difference of the end stress between turned axes and the turned answer.
fn turned(with_fibres: bool) -> f64 {
    let mut random = Random(7);
    let mut worst = 0.0_f64;
    for case in &ARTERIES {
        let rotation: Mat3 = random.rotation();
        let law = compiled(&goh(2, true), &case.law.parameters());
        let fibres = directions(case.angles);
        let turned_fibres: Vec<Vec3> =
            fibres.iter().map(|a| if with_fibres { rotation * a } else { *a }).collect();
        let plain = Drive::new(&law, &fibres);
        let other = Drive { frame: rotation, ..Drive::new(&law, &turned_fibres) };
        let end = |drive: &Drive<'_>| {
            let points = drive.follow(Target::uniaxial, &[1.0, 1.1, 1.2, END]).ok()?;
            points.last().map(|point| point.cauchy)
        };
        let (Some(plain), Some(other)) = (end(&plain), end(&other)) else { return f64::INFINITY };
        worst = worst.max((other - rotation * plain * rotation.transpose()).norm() / plain.norm());
    }
    worst
}
