//! Nodes with their volumes and boundary areas.

use crate::tensor::Vec3;

/// The nodes of one body, in spatial order.
#[derive(Debug, Clone, PartialEq)]
pub struct Particles {
    /// Reference positions `X_a`, m.
    pub position: Vec<Vec3>,
    /// Reference volumes `V_a`, m³.
    pub volume: Vec<f64>,
    /// Boundary faces, symmetry planes included; a node on an edge belongs to several.
    pub faces: Vec<FaceNodes>,
    /// Lattice spacing, m.
    pub spacing: f64,
}

/// The nodes of one face and the area each carries on it.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceNodes {
    /// Name of the face: `xmin` … `zmax`, `symmetry_x` … for a plane of symmetry.
    pub name: String,
    /// Node indices, ascending.
    pub nodes: Vec<u32>,
    /// `A_a N_a` of each of these nodes on this face alone, outward, m².
    pub area: Vec<Vec3>,
}

impl Particles {
    /// `A_a N_a` of every node: the sum over all faces, zero inside, m².
    pub fn boundary_area(&self) -> Vec<Vec3> {
        let mut area = vec![Vec3::zeros(); self.position.len()];
        for face in &self.faces {
            for (&node, face_area) in face.nodes.iter().zip(&face.area) {
                area[node as usize] += face_area;
            }
        }
        area
    }

    /// The face of a name.
    pub fn face(&self, name: &str) -> Option<&FaceNodes> {
        self.faces.iter().find(|face| face.name == name)
    }
}
