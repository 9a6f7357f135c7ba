//! Planes of which the face of a body consists.

use super::super::particles::FaceNodes;
use crate::tensor::Vec3;
use std::collections::BTreeMap;

/// How far normals of a plane may differ.
const FLATNESS: f64 = 1e-9;

/// Cosine of the angle from which two planes of one face meet at an edge; a curved face turns by less from one
/// quadrilateral to the next.
const SHARP: f64 = 0.766;

/// Quadrilaterals of a face in planes of one normal.
pub(super) struct Patch {
    pub normal: Vec3,
    pub quads: Vec<[u32; 4]>,
}

/// The planes of a face; none if it is curved.
pub(super) fn planes(face: &FaceNodes, position: &[Vec3]) -> Option<Vec<Patch>> {
    let mut patches: Vec<Patch> = Vec::new();
    let mut edges: BTreeMap<(u32, u32), Vec3> = BTreeMap::new();
    for quad in &face.quads {
        let [a, b, c, d] = quad.map(|a| position[a as usize]);
        let normal = (c - a).cross(&(d - b)).normalize();
        let turned = |other: &Vec3| (normal - other).amax() >= FLATNESS;
        for (&a, &b) in quad.iter().zip(quad.iter().cycle().skip(1)) {
            let other = edges.insert((a.min(b), a.max(b)), normal);
            if other.is_some_and(|other| turned(&other) && normal.dot(&other) > SHARP) {
                return None;
            }
        }
        match patches.iter_mut().find(|patch| !turned(&patch.normal)) {
            Some(patch) => patch.quads.push(*quad),
            None => patches.push(Patch { normal, quads: vec![*quad] }),
        }
    }
    // a quadrilateral without area has no normal
    patches.iter().all(|patch| patch.normal.norm() > 0.0).then_some(patches)
}
