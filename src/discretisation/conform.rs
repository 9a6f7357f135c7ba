//! Solids to particles: a lattice whose boundary nodes lie on the surface.
//!
//! Owns how boundary nodes move onto surface and sharp edges, how those nearby follow, and
//! how far where a cell would be turned inside out. Knows no file.

use super::error::DiscretisationError;
use super::filling::Cells;
use super::grid::{Grid, least_determinant};
use super::lattice::{checked, random};
use super::nearest::Nearest;
use super::particles::Particles;
use super::solid::Solid;
use crate::tensor::Vec3;
use std::collections::{BTreeMap, BTreeSet};

/// Rings of nodes around moved ones that follow, and sweeps of smoothing, as in the plane.
const RINGS: usize = 3;
const SWEEPS: usize = 30;

/// Reach of a boundary node, in spacings: the corner of a kept cell lies within half a diagonal of the surface.
const REACH: f64 = 1.5;

/// The same for a sharp edge; beyond it the next layer of nodes would be drawn to it as well.
const EDGE_REACH: f64 = 0.9;

/// How often a point is taken to the surface and back to the plane of symmetry it lies in.
const MEETINGS: usize = 3;

/// Smallest determinant of a cell, relative to the regular one's: flatter cells shorten the time step.
const FLATTEST: f64 = 0.1;

/// Rounds in which the nodes of too flat cells go half the way back to the lattice.
const RETREATS: usize = 40;

impl Solid {
    /// Nodes of the solid, see [`Particles::lattice`].
    pub(super) fn particles(
        &self,
        spacing: f64,
        symmetry: [Option<f64>; 3],
        jitter: f64,
    ) -> Result<Particles, DiscretisationError> {
        checked(spacing, jitter)?;
        let cells = Cells::of(self, spacing, symmetry)?;
        let kept = cells.kept(self);
        if kept.is_empty() {
            let size = cells.high - cells.low;
            return Err(DiscretisationError::FeatureTooSmall { radius: size.x.min(size.y), spacing });
        }
        let mut body = Lattice::new(&cells, &kept);
        body.fit(self, cells.edge.max());
        body.shake(jitter);
        let (names, node) = (body.names(self), body.node);
        let name = |quad: &[u32; 4]| names[quad].to_owned();
        Grid { node, cell: body.cell }.into_particles(cells.edge.max(), name)
    }
}

/// The grid on its way.
struct Lattice {
    node: Vec<Vec3>,
    original: Vec<Vec3>,
    cell: Vec<[u32; 8]>,
    boundary: Vec<[u32; 4]>,
    /// Nodes each node shares an edge with, of a boundary node those on the boundary; one whose mirror image beyond a
    /// plane of symmetry is another neighbour counts twice.
    around: Vec<Vec<(u32, f64)>>,
    on_boundary: Vec<bool>,
    /// Axes along which the boundary quadrilaterals of each node look on the lattice.
    looks: Vec<[bool; 3]>,
    near: BTreeSet<u32>,
    /// The plane ends of the bounds that each node lies in on the lattice: axis by axis, least and greatest.
    ends: Vec<[[bool; 2]; 3]>,
    /// Planes of symmetry each node lies in, and their coordinates.
    mirrors: Vec<[bool; 3]>,
    plane: Vec3,
    regular: f64,
}

impl Lattice {
    fn new(cells: &Cells, kept: &BTreeSet<[usize; 3]>) -> Self {
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
        let (plane, regular) = (cells.low, cells.edge.product() / 8.0);
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
            regular,
        }
    }

    /// Moves boundary nodes onto the surface and lets those around follow.
    fn fit(&mut self, solid: &Solid, spacing: f64) {
        let nearest = Nearest::new(solid, spacing);
        let (reach, edge_reach) = (REACH * spacing, EDGE_REACH * spacing);
        let mut fixed = vec![false; self.node.len()];
        for a in (0..self.node.len()).filter(|&a| self.on_boundary[a]) {
            let x = self.node[a];
            let is_corner = self.looks[a].iter().filter(|looks| **looks).count() > 1;
            let on_edge = if is_corner { self.within(a, &x, |x| nearest.edge(x, edge_reach)) } else { None };
            fixed[a] = on_edge.is_some();
            if let Some(point) = on_edge.or_else(|| self.within(a, &x, |x| nearest.surface(x, reach))) {
                self.node[a] = point;
            }
        }
        let moved = |a: &u32| (self.node[*a as usize] - self.original[*a as usize]).norm() > 1e-9 * spacing;
        self.near = (0..self.node.len() as u32).filter(moved).collect();
        for _ in 0..RINGS {
            let ring: Vec<u32> =
                self.near.iter().flat_map(|&a| self.around[a as usize].iter().map(|(b, _)| *b)).collect();
            self.near.extend(ring);
        }
        for _ in 0..SWEEPS {
            let old = self.node.clone();
            for &a in self.near.iter().filter(|&&a| !fixed[a as usize]) {
                let a = a as usize;
                let around = &self.around[a];
                let weights: f64 = around.iter().map(|(_, weight)| weight).sum();
                let mean =
                    around.iter().map(|(b, weight)| *weight * old[*b as usize]).sum::<Vec3>() / weights;
                let between = self.mirrored(a, &(0.5 * (old[a] + mean)));
                self.node[a] = match self.on_boundary[a] {
                    true => self.within(a, &between, |x| nearest.surface(x, reach)).unwrap_or(old[a]),
                    false => between,
                };
            }
        }
        self.retreat();
    }

    /// The mean of a point and of its images beyond the planes of symmetry that node `a` lies in.
    fn mirrored(&self, a: usize, x: &Vec3) -> Vec3 {
        Vec3::from_fn(|i, _| if self.mirrors[a][i] { self.plane[i] } else { x[i] })
    }

    /// The point that `find` gives for one of node `a`, within the planes of symmetry the node lies in.
    fn within(&self, a: usize, x: &Vec3, find: impl Fn(&Vec3) -> Option<Vec3>) -> Option<Vec3> {
        let mut point = find(x)?;
        // a surface that is its own image meets the plane at a right angle, but for its chords
        for _ in 0..MEETINGS {
            let met = self.mirrored(a, &point);
            if (met - point).norm() <= 1e-9 * (point - x).norm() {
                break;
            }
            point = find(&met)?;
        }
        Some(self.mirrored(a, &point))
    }

    /// Takes the nodes of cells that came out too flat back towards the lattice, where no cell is, until none is left.
    fn retreat(&mut self) {
        for _ in 0..RETREATS {
            let flat = |cell: &&[u32; 8]| {
                let corner = cell.map(|a| self.node[a as usize]);
                // NaN included
                least_determinant(&corner).partial_cmp(&(FLATTEST * self.regular))
                    != Some(std::cmp::Ordering::Greater)
            };
            let back: BTreeSet<u32> = self.cell.iter().filter(flat).flatten().copied().collect();
            if back.is_empty() {
                return;
            }
            for a in back {
                let a = a as usize;
                self.node[a] = 0.5 * (self.node[a] + self.original[a]);
            }
        }
    }

    /// Displaces inner nodes that have not followed the surface at random.
    fn shake(&mut self, jitter: f64) {
        if jitter == 0.0 {
            return;
        }
        let edge = 2.0 * libm::cbrt(self.regular);
        for a in 0..self.node.len() {
            if !self.on_boundary[a] && !self.near.contains(&(a as u32)) {
                let shift = Vec3::from_fn(|axis, _| jitter * edge * random(3 * a + axis));
                self.node[a] = self.mirrored(a, &(self.node[a] + shift));
            }
        }
    }

    /// Name of the face of each boundary quadrilateral.
    fn names(&self, solid: &Solid) -> BTreeMap<[u32; 4], &'static str> {
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
