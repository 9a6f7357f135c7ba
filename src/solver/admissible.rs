//! What a scene must not ask of a body at time zero.
//!
//! Owns the refusal of jumps and of scenes that are not symmetric about their planes of symmetry; it
//! looks at the assembled body, so that every way of writing a thing is met.

use super::body::{BodyState, DirectionField};
use super::constraint::Support;
use super::error::SolveError;
use super::loads::evaluate;
use super::quad::Quad;
use crate::scene::Scene;
use crate::tensor::Vec3;

/// Share of the spacing, of a force or of a speed below which it is a zero with round-off.
const ZERO: f64 = 1e-9;

/// Refuses a prescribed displacement that is not zero at time zero.
///
/// # Errors
/// [`SolveError::Jump`] with the line of the word.
pub fn starts_at_rest(scene: &Scene, index: usize, body: &BodyState) -> Result<(), SolveError> {
    let mut scratch = Vec::new();
    let given = scene.prescribed.iter().filter(|prescribed| prescribed.region.body == index);
    // an exact motion brings its own initial state
    for prescribed in given.filter(|prescribed| prescribed.word != super::exact::WORD) {
        let Some(face) = body.particles.face(&prescribed.region.face) else { continue };
        for tape in prescribed.displacement.iter().flatten() {
            for &node in &face.nodes {
                let displacement = evaluate(tape, &body.particles.position[node as usize], 0.0, &mut scratch);
                if displacement.abs() > ZERO * body.particles.spacing {
                    let (word, line) = (prescribed.word.clone(), prescribed.place.line);
                    return Err(SolveError::Jump { word, line, displacement });
                }
            }
        }
    }
    Ok(())
}

/// Refuses forces, velocities and directions that a plane of symmetry would contradict.
///
/// On the plane a force or velocity across it must vanish, and the mirror image of every direction
/// must be one of the directions, up to its sign.
///
/// # Errors
/// [`SolveError::NotSymmetric`].
pub fn is_symmetric(scene: &Scene, body: &BodyState) -> Result<(), SolveError> {
    for axis in (0..3).filter(|&axis| scene.symmetry[axis].is_some()) {
        let letter = ['x', 'y', 'z'][axis];
        let refuse = |what: &str| Err(SolveError::NotSymmetric { what: what.into(), axis: letter });
        let on_plane = |support: &&Support| support.face == ["symmetry_x", "symmetry_y", "symmetry_z"][axis];
        let Some(plane) = body.supports.iter().find(on_plane) else { continue };
        let crosses = |field: &[Quad]| {
            let largest = field.iter().map(|v| v.dot(*v)).fold(0.0, f64::max).sqrt();
            plane.nodes.iter().any(|&node| field[node as usize].0[axis].abs() > ZERO * largest)
        };
        if crosses(&body.v) {
            return refuse("the start velocity");
        }
        if !body.external.is_empty() && crosses(&body.external) {
            return refuse("a load");
        }
        if let DirectionField::Uniform(directions) = &body.directions
            && !closed_under_mirror(&directions[..body.law.directions().min(directions.len())], axis)
        {
            return refuse("the set of fibre directions");
        }
    }
    Ok(())
}

/// Whether the mirror image of every direction is one of them, up to its sign.
fn closed_under_mirror(directions: &[Vec3], axis: usize) -> bool {
    directions.iter().all(|direction| {
        let mut image = *direction;
        image[axis] = -image[axis];
        directions.iter().any(|other| (other - image).norm().min((other + image).norm()) < ZERO)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_of_families_is_its_own_mirror_image_and_a_single_oblique_one_is_not() {
        let (a, b) = (Vec3::new(0.8, 0.6, 0.0), Vec3::new(0.8, -0.6, 0.0));
        for axis in 0..3 {
            assert!(closed_under_mirror(&[a, b], axis));
        }
        assert!(!closed_under_mirror(&[a], 0) && !closed_under_mirror(&[a], 1));
        assert!(closed_under_mirror(&[a], 2), "a direction in the plane");
        assert!(closed_under_mirror(&[Vec3::x()], 0), "a direction across it");
    }
}
