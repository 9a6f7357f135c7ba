//! Background grids of hexahedra, and the volumes and areas they give their nodes.
//!
//! Owns the integrals of the trilinear shape functions. The particles of every shape come from such a
//! grid, so that volumes and boundary areas fit together exactly, whatever the shape. Knows no shape and
//! no kernel.
//!
//! With `V_a = ∫ N_a dV` and `A_a N_a = ∫ ∇N_a dV`, and because trilinear functions reproduce linear
//! fields, `Σ_a V_a` is the volume, `Σ_a A_a N_a = 0` and `Σ_a X_a ⊗ A_a N_a = Σ_a V_a I`: the
//! conditions under which integration consistency has a solution.

use super::error::DiscretisationError;
use super::particles::{FaceNodes, Particles};
use crate::tensor::{Mat3, Vec3};
use std::collections::BTreeMap;

/// A conforming grid of hexahedra.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    /// Nodes, m.
    pub node: Vec<Vec3>,
    /// Corners of each cell, in the order of VTK's hexahedron; a wedge has two corners twice.
    pub cell: Vec<[u32; 8]>,
}

/// Corners of the reference cube `[−1, 1]³` in the order of VTK's hexahedron.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Faces of a hexahedron, each counter-clockwise seen from outside.
const SIDES: [[usize; 4]; 6] =
    [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];

/// Edges of a hexahedron.
pub(super) const EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Two-point Gauss abscissa, `1/√3`: exact to degree 3 in each variable.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// The eight shape functions and their slopes at a point of the reference cube.
fn functions(xi: [f64; 3]) -> ([f64; 8], [Vec3; 8]) {
    let (mut value, mut slope) = ([0.0; 8], [Vec3::zeros(); 8]);
    for (a, xa) in CORNERS.iter().enumerate() {
        let t: [f64; 3] = std::array::from_fn(|i| 1.0 + xi[i] * xa[i]);
        value[a] = 0.125 * t[0] * t[1] * t[2];
        slope[a] = 0.125 * Vec3::new(xa[0] * t[1] * t[2], t[0] * xa[1] * t[2], t[0] * t[1] * xa[2]);
    }
    (value, slope)
}

/// Slopes of the eight shape functions on the reference cube at its eight Gauss points.
pub(super) fn slopes() -> [[Vec3; 8]; 8] {
    CORNERS.map(|point| functions(point.map(|c| c * GAUSS)).1)
}

/// The eight trilinear shape functions at a point `ξ` of a hexahedron, and `det(∂X/∂ξ)` there, m³.
pub(super) fn cell_hats(corner: &[Vec3; 8], xi: [f64; 3]) -> ([f64; 8], f64) {
    let (value, slope) = functions(xi);
    let mut map = Mat3::zeros();
    // from a corner on: slopes add up to zero, and far from the origin little would be left of their sum
    for (x, slope) in corner.iter().zip(slope) {
        map += (x - corner[0]) * slope.transpose();
    }
    (value, map.determinant())
}

/// The four bilinear shape functions at a point of a quadrilateral, and `∂X/∂ξ × ∂X/∂η` there, m².
pub(super) fn quad_hats(corner: &[Vec3; 4], [xi, eta]: [f64; 2]) -> ([f64; 4], Vec3) {
    const PLACE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let (mut along_xi, mut along_eta) = (Vec3::zeros(), Vec3::zeros());
    for (x, [s, t]) in corner.iter().map(|x| x - corner[0]).zip(PLACE) {
        along_xi += 0.25 * s * (1.0 + eta * t) * x;
        along_eta += 0.25 * t * (1.0 + xi * s) * x;
    }
    (PLACE.map(|[s, t]| 0.25 * (1.0 + xi * s) * (1.0 + eta * t)), along_xi.cross(&along_eta))
}

/// Integrals of the eight shape functions over a hexahedron.
///
/// ```text
/// ∫ N_a dV = ∫ N_a(ξ) det(∂X/∂ξ) dξ,    N_a = ⅛ Π_i (1 + ξ_i ξ_ai),    X(ξ) = Σ_a N_a X_a
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `corner` | corners in the order of VTK's hexahedron | m |
///
/// Returns the integrals in m³ and the smallest determinant met, m³ per unit of ξ (a regular cell of
/// edge `d` has `d³/8`). The integrand is of degree 3 in each variable, so the rule is exact.
fn cell_integrals(corner: &[Vec3; 8]) -> ([f64; 8], f64) {
    let mut integral = [0.0; 8];
    let mut least = f64::INFINITY;
    for point in CORNERS {
        let (value, determinant) = cell_hats(corner, point.map(|c| c * GAUSS));
        least = least.min(determinant);
        for (sum, n) in integral.iter_mut().zip(value) {
            *sum += n * determinant;
        }
    }
    (integral, least)
}

/// Smallest determinant of a cell's map at the Gauss points, m³ per unit of ξ.
pub(super) fn least_determinant(corner: &[Vec3; 8]) -> f64 {
    cell_integrals(corner).1
}

/// Integrals of the four shape functions times the outward normal over a bilinear quadrilateral.
///
/// ```text
/// ∫ N_a N dS = ∫ N_a(ξ, η) (∂X/∂ξ × ∂X/∂η) dξ dη
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `corner` | corners, counter-clockwise seen from outside | m |
///
/// Returns the integrals in m². The integrand is of degree 2 in each variable, so the rule is exact, and
/// summed over a grid's boundary it is `∫ ∇N_a dV` to round-off. Of current corners it is the gradient of
/// the enclosed volume with respect to the corner, and over a closed surface forces and moments cancel.
pub fn quad_integrals(corner: &[Vec3; 4]) -> [Vec3; 4] {
    let mut integral = [Vec3::zeros(); 4];
    for point in [[-GAUSS, -GAUSS], [GAUSS, -GAUSS], [GAUSS, GAUSS], [-GAUSS, GAUSS]] {
        let (value, normal) = quad_hats(corner, point);
        for (sum, n) in integral.iter_mut().zip(value) {
            *sum += n * normal;
        }
    }
    integral
}

impl Grid {
    /// Quadrilaterals that belong to one cell only, each counter-clockwise seen from outside, in the
    /// order of their cells.
    pub fn boundary(&self) -> Vec<[u32; 4]> {
        let mut sides: Vec<([u32; 4], u32, [u32; 4])> = Vec::with_capacity(6 * self.cell.len());
        for cell in &self.cell {
            for side in SIDES {
                let quad = side.map(|corner| cell[corner]);
                // the side of a wedge that is a line
                if quad[0] == quad[1] && quad[2] == quad[3] || quad[0] == quad[3] && quad[1] == quad[2] {
                    continue;
                }
                let mut key = quad;
                key.sort_unstable();
                sides.push((key, sides.len() as u32, quad));
            }
        }
        sides.sort_unstable();
        let mut single: Vec<_> =
            sides.chunk_by(|s, t| s.0 == t.0).filter(|same| same.len() == 1).map(|same| same[0]).collect();
        single.sort_unstable_by_key(|side| side.1);
        single.into_iter().map(|side| side.2).collect()
    }

    /// Turns the grid into particles: each node with the integral of its shape function, each boundary
    /// quadrilateral given to the face that `name` says it belongs to.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `spacing` | spacing the smoothing length is measured by | m |
    /// | `name` | face of a boundary quadrilateral, from its nodes | – |
    ///
    /// # Errors
    /// [`DiscretisationError::InvertedCell`] if a cell is turned inside out.
    pub fn into_particles(
        self,
        spacing: f64,
        name: impl Fn(&[u32; 4]) -> String,
    ) -> Result<Particles, DiscretisationError> {
        let mut volume = vec![0.0; self.node.len()];
        let mut least_spacing = f64::INFINITY;
        for cell in &self.cell {
            let corner = cell.map(|a| self.node[a as usize]);
            let (integral, determinant) = cell_integrals(&corner);
            let scale = spacing * spacing * spacing / 8.0;
            if determinant.is_nan() || determinant <= 0.0 {
                let position = corner.iter().sum::<Vec3>() / 8.0;
                return Err(DiscretisationError::InvertedCell { position, determinant: determinant / scale });
            }
            for (&a, v) in cell.iter().zip(integral) {
                volume[a as usize] += v;
            }
            for [a, b] in EDGES {
                if cell[a] != cell[b] {
                    least_spacing = least_spacing.min((corner[a] - corner[b]).norm());
                }
            }
        }
        let faces = self.faces(name);
        let (position, cells) = (self.node, self.cell);
        Ok(Particles { position, volume, faces, spacing, least_spacing, cells, first_moment: Vec::new() })
    }

    /// Boundary faces in the order of their names.
    fn faces(&self, name: impl Fn(&[u32; 4]) -> String) -> Vec<FaceNodes> {
        let mut quads: BTreeMap<String, Vec<[u32; 4]>> = BTreeMap::new();
        for quad in self.boundary() {
            quads.entry(name(&quad)).or_default().push(quad);
        }
        let face = |(name, quads): (String, Vec<[u32; 4]>)| {
            let mut area: BTreeMap<u32, Vec3> = BTreeMap::new();
            for quad in &quads {
                let integral = quad_integrals(&quad.map(|a| self.node[a as usize]));
                for (&a, n) in quad.iter().zip(integral) {
                    *area.entry(a).or_insert_with(Vec3::zeros) += n;
                }
            }
            let (nodes, area) = area.into_iter().unzip();
            FaceNodes { name, nodes, area, quads, bulges: Vec::new() }
        };
        quads.into_iter().map(face).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn distorted() -> impl Strategy<Value = [Vec3; 8]> {
        prop::array::uniform8(prop::array::uniform3(-0.2..0.2))
            .prop_map(|shift| std::array::from_fn(|a| Vec3::from(CORNERS[a]) + Vec3::from(shift[a])))
    }

    fn single(corner: [Vec3; 8]) -> Grid {
        Grid { node: corner.to_vec(), cell: vec![[0, 1, 2, 3, 4, 5, 6, 7]] }
    }

    proptest! {
        // 64 products of numbers of order one, summed: some 100 roundings of 1.1e-16 on 8 m³
        #[test]
        fn boundary_areas_and_volumes_of_any_cell_fit_together(corner in distorted()) {
            let particles = single(corner).into_particles(2.0, |_| "all".into()).unwrap();
            let area = particles.boundary_area();
            let volume: f64 = particles.volume.iter().sum();
            let first: Vec3 = area.iter().sum();
            let second: Mat3 = area.iter().zip(&particles.position).map(|(n, x)| x * n.transpose()).sum();
            prop_assert!(first.norm() < 1e-13);
            prop_assert!((second - volume * Mat3::identity()).norm() < 1e-12);
        }
    }

    #[test]
    fn the_corners_of_a_cube_share_its_volume_equally() {
        let particles = single(CORNERS.map(Vec3::from)).into_particles(2.0, |_| "all".into()).unwrap();
        for (v, n) in particles.volume.iter().zip(particles.boundary_area()) {
            assert!((v - 1.0).abs() < 1e-15);
            assert!((n.abs() - Vec3::new(1.0, 1.0, 1.0)).norm() < 1e-15);
        }
        assert_eq!(particles.least_spacing, 2.0);
    }

    #[test]
    fn normals_point_outward_on_every_side() {
        let grid = single(CORNERS.map(Vec3::from));
        assert_eq!(grid.boundary().len(), 6);
        for quad in grid.boundary() {
            let corner = quad.map(|a| grid.node[a as usize]);
            let centre = corner.iter().sum::<Vec3>() / 4.0;
            let area: Vec3 = quad_integrals(&corner).iter().sum();
            assert!((area - 4.0 * centre).norm() < 1e-14);
        }
    }

    #[test]
    fn a_cell_turned_inside_out_is_refused_with_its_place() {
        let mut corner = CORNERS.map(Vec3::from);
        corner.swap(0, 6);
        let error = single(corner).into_particles(2.0, |_| "all".into()).unwrap_err();
        assert!(
            matches!(error, DiscretisationError::InvertedCell { position, .. } if position.norm() < 1e-15)
        );
    }
}
