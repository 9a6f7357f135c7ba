//! Nodes with their volumes and boundary areas.
//!
//! Owns the arrays a body is given to the solver as. Knows no kernel.

use super::error::DiscretisationError;
use super::grid::quad_integrals;
use super::shape::Shape;
use crate::tensor::{Mat3, Vec3};

/// Up to here areas that meet in a node are those of one plane: some hundred roundings of 1.1e-16.
const FLAT: f64 = 1e-13;

/// The nodes of one body, in spatial order.
#[derive(Debug, Clone, PartialEq)]
pub struct Particles {
    /// Reference positions `X_a`, m.
    pub position: Vec<Vec3>,
    /// Reference volumes `V_a = ∫ N_a dV`, m³.
    pub volume: Vec<f64>,
    /// Boundary faces, symmetry planes included; a node on an edge belongs to several.
    pub faces: Vec<FaceNodes>,
    /// Spacing the smoothing length is measured by: the greatest over the axes of a lattice, m.
    pub spacing: f64,
    /// Shortest edge of the background grid, at most `spacing`, m.
    pub least_spacing: f64,
    /// Cells of the background grid, corners in the order of VTK's hexahedron; a wedge has two
    /// corners twice.
    pub cells: Vec<[u32; 8]>,
    /// `B_a = ∮ N_a (X − X_a) ⊗ N dS` of every node, m³; empty before [`Particles::integrate_quadratics`].
    pub first_moment: Vec<Mat3>,
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
    /// Quadrilaterals of the face, each counter-clockwise seen from outside.
    pub quads: Vec<[u32; 4]>,
    /// By how much quadrilaterals differ from the surface through the nodes round them; empty before
    /// [`Particles::integrate_quadratics`].
    pub bulges: Vec<Bulge>,
}

/// The mean distance of a bilinear quadrilateral from the quadratic surface through the nodes round it:
/// `m = Σ_a c_a x_a`. Constants and linear fields have none.
#[derive(Debug, Clone, PartialEq)]
pub struct Bulge {
    /// The quadrilateral.
    pub quad: [u32; 4],
    /// Nodes and their `c_a = ∮ ½ K_a : S dS` over the quadrilateral's area.
    pub shares: Vec<(u32, f64)>,
}

impl Particles {
    /// Nodes of a shape on a lattice, nodes on its boundary included.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `shape` | the whole body | – |
    /// | `spacing` | spacing asked for; [`Particles::spacing`] is what fits the shape | m |
    /// | `symmetry` | planes normal to x, y, z; the part of greater coordinates is kept | m |
    /// | `jitter` | bound of each component of the nodes' random displacement, in shortest edges at the node | – |
    ///
    /// Hexahedra from a file keep their nodes: of those the spacing only measures the smoothing length, and a plane of
    /// symmetry is the end the file gives them.
    ///
    /// The displacement is the same in every run. A face cut by a plane is named `symmetry_x`,
    /// `symmetry_y` or `symmetry_z` and carries its areas like every other.
    ///
    /// # Errors
    /// A [`DiscretisationError`] that says which argument does not fit the shape.
    pub fn lattice(
        shape: &Shape,
        spacing: f64,
        symmetry: [Option<f64>; 3],
        jitter: f64,
    ) -> Result<Self, DiscretisationError> {
        match shape {
            Shape::Solid(solid) => solid.particles(spacing, symmetry, jitter),
            Shape::Mesh(mesh) => mesh.particles(spacing, symmetry),
            Shape::Points(points) => points.particles(spacing, symmetry),
            _ => shape.prism()?.particles(spacing, symmetry, jitter),
        }
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

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

    /// How much of a face's surface every node stands for, m².
    ///
    /// ```text
    /// A_a = |A_a N_a| · Σ_q |A_qa| / |Σ_q A_qa|
    /// ```
    ///
    /// over the quadrilaterals `q` of the face that meet there: where planes meet in an edge, the vectors of their
    /// areas add to less than their areas do.
    pub fn sizes(&self, face: &FaceNodes) -> Vec<f64> {
        let mut shares = vec![(0.0, Vec3::zeros()); face.nodes.len()];
        for quad in &face.quads {
            let integral = quad_integrals(&quad.map(|a| self.position[a as usize]));
            for (a, share) in quad.iter().zip(integral) {
                let (size, vector) = &mut shares[face.nodes.partition_point(|node| node < a)];
                *size += share.norm();
                *vector += share;
            }
        }
        let size = |(area, (size, vector)): (&Vec3, &(f64, Vec3))| match size / vector.norm() {
            // areas that cancel have no direction for corrections of second order to change
            bent if bent.is_infinite() => *size,
            bent if bent > 1.0 + FLAT => area.norm() * bent,
            _ => area.norm(),
        };
        face.area.iter().zip(&shares).map(size).collect()
    }
}
