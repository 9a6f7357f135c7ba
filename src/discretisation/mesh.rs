//! Bodies of hexahedra, as a file gives them: every node is a particle.
//!
//! Owns the way from points and cells to particles, and the names of plane ends. Knows no file format.

use super::error::DiscretisationError;
use super::grid::Grid;
use super::particles::Particles;
use crate::tensor::Vec3;

/// Share of the body's size within which nodes lie in one plane.
const PLANE: f64 = 1e-6;

/// Points and hexahedra.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    node: Vec<Vec3>,
    cell: Vec<[u32; 8]>,
    low: Vec3,
    high: Vec3,
}

impl Mesh {
    /// A mesh; its cells have their corners in the order of VTK's hexahedron.
    ///
    /// # Errors
    /// [`DiscretisationError::BadCell`] if a corner is no point, [`DiscretisationError::InvertedCell`] if a cell is
    /// turned inside out, [`DiscretisationError::NoSurface`] without cells.
    pub fn new(node: Vec<Vec3>, cell: Vec<[u32; 8]>) -> Result<Self, DiscretisationError> {
        let outside = |cell: &[u32; 8]| cell.iter().any(|&a| a as usize >= node.len());
        if let Some(cell) = cell.iter().position(outside) {
            return Err(DiscretisationError::BadCell { cell, points: node.len() });
        }
        if cell.is_empty() {
            return Err(DiscretisationError::NoSurface { triangles: 0 });
        }
        // points that no cell uses are no particles
        let mut used = vec![false; node.len()];
        cell.iter().flatten().for_each(|&a| used[a as usize] = true);
        let mut next = 0;
        let index: Vec<u32> = used
            .iter()
            .map(|&used| {
                next += u32::from(used);
                next.saturating_sub(1)
            })
            .collect();
        let cell: Vec<[u32; 8]> = cell.iter().map(|cell| cell.map(|a| index[a as usize])).collect();
        let node: Vec<Vec3> =
            node.into_iter().zip(&used).filter(|(_, used)| **used).map(|(x, _)| x).collect();
        let low = node.iter().fold(Vec3::repeat(f64::INFINITY), |low, x| low.inf(x));
        let high = node.iter().fold(Vec3::repeat(f64::NEG_INFINITY), |high, x| high.sup(x));
        let mesh = Self { node, cell, low, high };
        // cells turned inside out are found here, where the file is read
        mesh.particles((high - low).norm(), [None; 3])?;
        Ok(mesh)
    }

    /// Least and greatest coordinates, m.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        (self.low, self.high)
    }

    /// Names of its faces: plane ends by their axis, all else is `surface`.
    pub fn face_names(&self) -> Vec<&'static str> {
        let boundary = Grid { node: self.node.clone(), cell: self.cell.clone() }.boundary();
        let mut names: Vec<&'static str> = boundary.iter().map(|quad| self.name(quad)).collect();
        names.sort_unstable_by_key(|name| (*name == "surface", *name));
        names.dedup();
        names
    }

    fn name(&self, quad: &[u32; 4]) -> &'static str {
        const PLANES: [[&str; 2]; 3] = [["xmin", "xmax"], ["ymin", "ymax"], ["zmin", "zmax"]];
        let tolerance = PLANE * (self.high - self.low).norm();
        for (axis, names) in PLANES.iter().enumerate() {
            for (end, at) in [self.low[axis], self.high[axis]].into_iter().enumerate() {
                if quad.iter().all(|&a| (self.node[a as usize][axis] - at).abs() <= tolerance) {
                    return names[end];
                }
            }
        }
        "surface"
    }

    /// The nodes as particles, in the order of the file so that results can be laid beside it.
    ///
    /// A plane of symmetry is the plane end of least coordinate: the file has the part beyond it.
    pub(super) fn particles(
        &self,
        spacing: f64,
        symmetry: [Option<f64>; 3],
    ) -> Result<Particles, DiscretisationError> {
        const ENDS: [(&str, &str); 3] =
            [("xmin", "symmetry_x"), ("ymin", "symmetry_y"), ("zmin", "symmetry_z")];
        for (axis, at) in symmetry.into_iter().enumerate() {
            let Some(at) = at else { continue };
            if !self.ends_in(axis, at) {
                return Err(DiscretisationError::PlaneNotAnEnd { axis, at, end: self.low[axis] });
            }
        }
        let name = |quad: &[u32; 4]| {
            let name = self.name(quad);
            let cut = (0..3).find(|&axis| symmetry[axis].is_some() && ENDS[axis].0 == name);
            cut.map_or(name, |axis| ENDS[axis].1).to_owned()
        };
        let grid = Grid { node: self.node.clone(), cell: self.cell.clone() };
        grid.into_particles(spacing, name)
    }

    /// Whether the plane `X_axis = at` is the mesh's end of least coordinate, and some of its sides lie in it.
    pub(super) fn ends_in(&self, axis: usize, at: f64) -> bool {
        let end = ["xmin", "ymin", "zmin"][axis];
        (self.low[axis] - at).abs() <= PLANE * (self.high - self.low).norm()
            && self.face_names().contains(&end)
    }
}
