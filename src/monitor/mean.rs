//! Means of a field over a part of a body.
//!
//! Owns the weights of the particles: what an integral over the cells between them gives to each.

use crate::discretisation::Particles;
use crate::expression::Tape;
use crate::scene::{Coordinate, Field};
use crate::tensor::{Mat3, Vec3};

/// Points a cell is cut into along each edge.
const CUTS: usize = 4;

/// Weights of the particles in a mean over the whole body.
///
/// ```text
/// f̄ = ∫ w f dV / ∫ w dV,   f = Σ_a N_a f_a
/// ```
///
/// with the trilinear functions `N_a` of the cells and the mid-point rule on 4³ parts of each, mirror
/// images at planes of symmetry included, where the field may turn its sign.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `particles` | the modelled part | – |
/// | `symmetry` | coordinates of the planes of symmetry | m |
/// | `field` | the field that is averaged | – |
/// | `weight` | `w(X)` | – |
///
/// Not a number where the weight vanishes everywhere.
pub(super) fn mean_weights(
    particles: &Particles,
    symmetry: [Option<f64>; 3],
    field: Field,
    weight: &Tape<Coordinate>,
) -> Vec<(usize, f64)> {
    let planes: Vec<usize> = (0..3).filter(|&axis| symmetry[axis].is_some()).collect();
    let mut scratch = Vec::new();
    let mut value = |x: &Vec3| {
        let leaf = |coordinate: &Coordinate| match coordinate {
            Coordinate::X(axis) => x[usize::from(*axis)],
            Coordinate::Time => f64::NAN,
        };
        weight.evaluate(leaf, &mut scratch)
    };
    let mut weights = vec![0.0; particles.len()];
    let mut total = 0.0;
    for cell in &particles.cells {
        let corners = cell.map(|corner| particles.position[corner as usize]);
        for part in 0..CUTS * CUTS * CUTS {
            let xi: [f64; 3] = std::array::from_fn(|k| {
                let step = part / CUTS.pow(k as u32) % CUTS;
                (step as f64 + 0.5) / CUTS as f64
            });
            let (shape, slope) = trilinear(&xi);
            let x: Vec3 = corners.iter().zip(shape).map(|(x, n)| n * x).sum();
            let map: Mat3 = corners.iter().zip(&slope).map(|(x, d)| x * d.transpose()).sum();
            let volume = map.determinant().abs() / (CUTS * CUTS * CUTS) as f64;
            let (mut signed, mut plain) = (0.0, 0.0);
            for image in 0..1_usize << planes.len() {
                let (mut point, mut sign) = (x, 1.0);
                for (bit, &axis) in planes.iter().enumerate() {
                    if let Some(at) = symmetry[axis]
                        && image >> bit & 1 == 1
                    {
                        point[axis] = 2.0 * at - point[axis];
                        sign = if field.flips(axis) { -sign } else { sign };
                    }
                }
                let w = value(&point);
                signed += sign * w;
                plain += w;
            }
            total += plain * volume;
            for (&corner, n) in cell.iter().zip(shape) {
                weights[corner as usize] += n * signed * volume;
            }
        }
    }
    let kept = weights.into_iter().enumerate().map(|(a, w)| (a, w / total));
    kept.filter(|(_, w)| *w != 0.0).collect()
}

/// Trilinear functions and their slopes in a cell, corners in VTK's order.
fn trilinear(xi: &[f64; 3]) -> ([f64; 8], [Vec3; 8]) {
    const CORNERS: [[usize; 3]; 8] =
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    let value = |k: usize, end: usize| if end == 1 { xi[k] } else { 1.0 - xi[k] };
    let slope = |end: usize| if end == 1 { 1.0 } else { -1.0 };
    let shape = CORNERS.map(|c| value(0, c[0]) * value(1, c[1]) * value(2, c[2]));
    let slopes = CORNERS.map(|c| {
        Vec3::new(
            slope(c[0]) * value(1, c[1]) * value(2, c[2]),
            value(0, c[0]) * slope(c[1]) * value(2, c[2]),
            value(0, c[0]) * value(1, c[1]) * slope(c[2]),
        )
    });
    (shape, slopes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::Shape;

    fn block() -> Particles {
        let shape = Shape::Box { min: Vec3::repeat(-1.0), max: Vec3::repeat(1.0) };
        Particles::lattice(&shape, 0.25, [Some(0.0), None, None], 0.0).expect("a box has a lattice")
    }

    fn mean(field: Field, weight: &Tape<Coordinate>, value: fn(&Vec3) -> f64) -> f64 {
        let particles = block();
        let weights = mean_weights(&particles, [Some(0.0), None, None], field, weight);
        weights.iter().map(|&(a, w)| w * value(&particles.position[a])).sum()
    }

    #[test]
    fn the_mean_of_a_linear_field_is_its_value_in_the_middle() {
        let all = Tape::constant(1.0);
        let found = mean(Field::J, &all, |x| 2.0 + 3.0 * x.y - x.z);
        assert!((found - 2.0).abs() < 1e-13, "{found}");
    }

    #[test]
    fn what_a_mirror_turns_round_cancels_and_what_it_keeps_counts_twice() {
        let all = Tape::constant(1.0);
        let odd = mean(Field::Displacement(0), &all, |x| x.x);
        let even = mean(Field::Displacement(2), &all, |x| x.x);
        assert!(odd.abs() < 1e-15 && (even - 0.5).abs() < 1e-13, "{odd} {even}");
    }
}
