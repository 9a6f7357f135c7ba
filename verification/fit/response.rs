//! The derivatives of a driven point by the parameters of its law, against differences.

use super::super::energies::laws::{Artery, DISPERSED, compiled, families, goh};
use super::Claim;
use crate::drive::{Drive, Point, PointSlope, Target, Volume};
use crate::energy::{ParameterSlopes, Scratch};
use crate::tensor::{Mat3, Vec3};
use crate::verify::claim::Topic;

/// Relative step of the differences.
const STEP: f64 = 1e-4;

/// A soft artery with all five parameters at work and an exponent of some two at the end of the path.
const SOFT: Artery = Artery { k2: 20.0, d: 2e-6, ..DISPERSED };

/// Stretches along the bisector of the fibres.
const STRETCHES: [f64; 4] = [1.0, 1.1, 1.2, 1.3];

/// With the volumetric part at work.
pub(crate) const COMPRESSIBLE: Claim = Claim {
    topic: Topic::Energies,
    claim: "stress, energy and lateral stretch of a pulled bar answer to each parameter as central differences say",
    source: "implicit differentiation of the equilibrium",
    because: "central differences over 1e-4 of a parameter err by that squared times the cube of its exponent, \
              some 3^3/6, relative to the largest slope of the path",
    bound: 5e-8,
    measure: || worst(Volume::Compressible, true),
    // F held: what the law's own derivative says without the lateral stretches that follow
    control: || worst(Volume::Compressible, false),
};

/// With the pressure as a further unknown.
pub(crate) const INCOMPRESSIBLE: Claim = Claim {
    topic: Topic::Energies,
    claim: "the same of an incompressible bar, whose constraint's stress answers too",
    source: "implicit differentiation of the equilibrium and of J = 1",
    because: "as for the compressible bar",
    bound: 5e-8,
    measure: || worst(Volume::Incompressible, true),
    control: || worst(Volume::Incompressible, false),
};

/// What is compared of a point.
fn seen(point: &Point) -> [f64; 4] {
    [point.first_piola[(0, 0)], point.psi, point.f[(2, 2)], point.constraint_stress]
}

fn seen_slope(slope: &PointSlope) -> [f64; 4] {
    [slope.first_piola[(0, 0)], slope.psi, slope.f[(2, 2)], slope.constraint_stress]
}

/// Largest difference of a slope to a central difference, relative to the largest on the path.
fn worst(volume: Volume, is_total: bool) -> f64 {
    let (psi, parameters) = (goh(2, true), SOFT.parameters());
    let directions = families(35.0);
    let varied: Vec<u32> = (0..5).collect();
    let Ok(slopes) = ParameterSlopes::compile(&psi, &parameters, &varied) else { return f64::INFINITY };
    let drive = Drive { volume, ..Drive::new(slopes.law(), &directions) };
    let mut found: Vec<Vec<[f64; 4]>> = Vec::new();
    let driven = drive.visit_with_slopes(Target::uniaxial, &STRETCHES, &slopes, |point, total| {
        let partial = || held(&slopes, &point.f, &directions);
        found.push(if is_total { total.iter().map(seen_slope).collect() } else { partial() });
    });
    if driven.is_err() {
        return f64::INFINITY;
    }
    let mut worst = 0.0_f64;
    for index in 0..parameters.len() {
        let at = |sign: f64| {
            let mut moved = parameters;
            moved[index] *= 1.0 + sign * STEP;
            let law = compiled(&psi, &moved);
            let drive = Drive { volume, ..Drive::new(&law, &directions) };
            drive.follow(Target::uniaxial, &STRETCHES).unwrap_or_default()
        };
        let (plus, minus) = (at(1.0), at(-1.0));
        if plus.len() != STRETCHES.len() || minus.len() != STRETCHES.len() {
            return f64::INFINITY;
        }
        let difference = |row: usize, k: usize| {
            (seen(&plus[row])[k] - seen(&minus[row])[k]) / (2.0 * STEP * parameters[index])
        };
        let compared = |k: usize| {
            let rows = || 0..STRETCHES.len();
            let largest = rows().map(|row| difference(row, k).abs()).fold(0.0, f64::max);
            let gap = |row: usize| (found[row][index][k] - difference(row, k)).abs();
            let error = rows().map(gap).fold(0.0, f64::max);
            let size = plus.iter().map(|point| seen(point)[k].abs()).fold(0.0, f64::max);
            // what does not answer at all, such as the stress of a law without volume change to its bulk
            // modulus, must not: a difference resolves 1e-16 of the size over twice 1e-4 of the parameter
            let answers = largest * parameters[index] > 1e-9 * size;
            match (answers, size > 0.0) {
                (true, _) => error / largest,
                (false, true) => error * parameters[index] / size,
                (false, false) => error,
            }
        };
        worst = (0..4).map(compared).fold(worst, f64::max);
    }
    worst
}

/// Slopes with F held.
fn held(slopes: &ParameterSlopes, f: &Mat3, directions: &[Vec3]) -> Vec<[f64; 4]> {
    let partial = slopes.at(f, directions, &mut Scratch::default());
    partial.iter().map(|slope| [slope.first_piola[(0, 0)], slope.psi, 0.0, 0.0]).collect()
}
