//! The cells that fill a solid as a grid, before and after its nodes have moved.
//!
//! Owns which nodes lie on the surface, in plane ends and in planes of symmetry, and which are neighbours. Moves none.

use super::filling::Cells;
use super::grid::Grid;
use super::solid::Solid;
use crate::tensor::Vec3;
use std::collections::{BTreeMap, BTreeSet};

/// The grid on its way.
pub(super) struct Lattice {
    pub node: Vec<Vec3>,
    pub original: Vec<Vec3>,
    pub cell: Vec<[u32; 8]>,
    pub boundary: Vec<[u32; 4]>,
    /// Nodes each node shares an edge with, of a boundary node those on the boundary; one whose mirror image beyond a
    /// plane of symmetry is another neighbour counts twice.
    pub around: Vec<Vec<(u32, f64)>>,
    pub on_boundary: Vec<bool>,
    /// Axes along which the boundary quadrilaterals of each node look on the lattice.
    pub looks: Vec<[bool; 3]>,
    pub near: BTreeSet<u32>,
    /// The plane ends of the bounds that each node lies in on the lattice: axis by axis, least and greatest.
    pub ends: Vec<[[bool; 2]; 3]>,
    /// Planes of symmetry each node lies in, and their coordinates.
    pub mirrors: Vec<[bool; 3]>,
    pub plane: Vec3,
    /// Edges of a regular cell, m.
    pub edge: Vec3,
    pub regular: f64,
}

impl Lattice {
    /// The kept cells, their nodes where the lattice has them.
    pub fn new(cells: &Cells, kept: &BTreeSet<[usize; 3]>) -> Self {
        const OFFSET: [[usize; 3]; 8] =
            [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
        let corners = |at: &[usize; 3]| OFFSET.map(|o| [0, 1, 2].map(|i| at[i] + o[i]));
        let all: BTreeSet<[usize; 3]> = kept.iter().flat_map(corners).collect();
        let index: BTreeMap<[usize; 3], u32> =
            all.iter().enumerate().map(|(n, at)| (*at, n as u32)).collect();
        let node: Vec<Vec3> = all.iter().map(|at| cells.corner(at)).collect();
        let ends = all.iter().map(|at| [0, 1, 2].map(|i| [at[i] == 0, at[i] == cells.count[i]])).collect();
        let mirrors: Vec<[bool; 3]> =
            all.iter().map(|at| [0, 1, 2].map(|i| cells.cut[i] && at[i] == 0)).collect();
        let cell: Vec<[u32; 8]> = kept.iter().map(|at| corners(at).map(|corner| index[&corner])).collect();
        let boundary = Grid { node: node.clone(), cell: cell.clone() }.boundary();
        let mut on_boundary = vec![false; node.len()];
        let mut looks = vec![[false; 3]; node.len()];
        let mut sets = vec![BTreeSet::new(); node.len()];
        let cut = |quad: &&[u32; 4]| (0..3).any(|i| quad.iter().all(|&a| mirrors[a as usize][i]));
        for quad in boundary.iter().filter(|quad| !cut(quad)) {
            let [a, b, _, d] = quad.map(|a| node[a as usize]);
            let axis = (b - a).cross(&(d - a)).iamax();
            for k in 0..4 {
                let a = quad[k] as usize;
                on_boundary[a] = true;
                looks[a][axis] = true;
                sets[a].extend([quad[(k + 1) % 4], quad[(k + 3) % 4]]);
            }
        }
        for cell in &cell {
            for [a, b] in super::grid::EDGES {
                for (a, b) in [(cell[a], cell[b]), (cell[b], cell[a])] {
                    if !on_boundary[a as usize] {
                        sets[a as usize].insert(b);
                    }
                }
            }
        }
        let weight = |a: usize, b: u32| {
            let mirrored = (0..3).any(|i| mirrors[a][i] && !mirrors[b as usize][i]);
            (b, if mirrored { 2.0 } else { 1.0 })
        };
        let weighted = |(a, set): (usize, BTreeSet<u32>)| set.into_iter().map(|b| weight(a, b)).collect();
        let around = sets.into_iter().enumerate().map(weighted).collect();
        let (original, near) = (node.clone(), BTreeSet::new());
        let (plane, edge, regular) = (cells.low, cells.edge, cells.edge.product() / 8.0);
        Self {
            node,
            original,
            cell,
            boundary,
            around,
            on_boundary,
            looks,
            near,
            ends,
            mirrors,
            plane,
            edge,
            regular,
        }
    }

    /// The mean of a point and of its images beyond the planes of symmetry that node `a` lies in.
    pub fn mirrored(&self, a: usize, x: &Vec3) -> Vec3 {
        Vec3::from_fn(|i, _| if self.mirrors[a][i] { self.plane[i] } else { x[i] })
    }

    /// Name of the face of each boundary quadrilateral.
    pub fn names(&self, solid: &Solid) -> BTreeMap<[u32; 4], &'static str> {
        const PLANES: [[&str; 2]; 3] = [["xmin", "xmax"], ["ymin", "ymax"], ["zmin", "zmax"]];
        const CUTS: [&str; 3] = ["symmetry_x", "symmetry_y", "symmetry_z"];
        let name = |quad: &[u32; 4]| {
            if let Some(axis) = (0..3).find(|&axis| quad.iter().all(|&a| self.mirrors[a as usize][axis])) {
                return CUTS[axis];
            }
            for (axis, names) in PLANES.iter().enumerate() {
                for (end, name) in names.iter().enumerate() {
                    let within = quad.iter().all(|&a| self.ends[a as usize][axis][end]);
                    if within && solid.is_flat(axis, end == 1) {
                        return *name;
                    }
                }
            }
            "surface"
        };
        self.boundary.iter().map(|quad| (*quad, name(quad))).collect()
    }
}
