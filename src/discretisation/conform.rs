//! Solids to particles: a lattice whose boundary nodes lie on the surface.
//!
//! Owns which cells are kept, how boundary nodes move onto surface and sharp edges, how those nearby follow, and
//! how far where a cell would be turned inside out. Knows no file.

use super::error::DiscretisationError;
use super::grid::{Grid, least_determinant};
use super::lattice::{LIMIT, checked, divide, random};
use super::particles::Particles;
use super::solid::{Nearest, Solid};
use crate::tensor::Vec3;
use std::collections::{BTreeMap, BTreeSet};

/// Greatest ratio of the spacings of the lattice; beside the surface they vary by more anyway.
const EVENNESS: f64 = 1.25;

/// Rings of nodes around moved ones that follow, and sweeps of smoothing, as in the plane.
const RINGS: usize = 3;
const SWEEPS: usize = 30;

/// Reach of a boundary node, in spacings: the corner of a kept cell lies within half a diagonal of the surface.
const REACH: f64 = 1.5;

/// The same for a sharp edge; beyond it the next layer of nodes would be drawn to it as well.
const EDGE_REACH: f64 = 0.9;

/// Smallest determinant of a cell, relative to the regular one's: flatter cells shorten the time step.
const FLATTEST: f64 = 0.1;

/// Rounds in which the nodes of too flat cells go half the way back to the lattice.
const RETREATS: usize = 40;

impl Solid {
    /// Nodes of the solid, see [`Particles::lattice`].
    pub(super) fn particles(&self, spacing: f64, jitter: f64) -> Result<Particles, DiscretisationError> {
        checked(spacing, jitter)?;
        let (low, high) = self.bounds();
        let lengths = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let count = divide(&lengths, spacing, EVENNESS)?;
        let nodes: f64 = count.iter().map(|&n| n as f64 + 1.0).product();
        if nodes > f64::from(LIMIT) {
            return Err(DiscretisationError::TooManyParticles { count: nodes, limit: LIMIT });
        }
        let edge = Vec3::from_fn(|axis, _| lengths[axis] / count[axis] as f64);
        let cells = kept(self, &low, &edge, &count);
        if cells.is_empty() {
            return Err(DiscretisationError::FeatureTooSmall { radius: lengths[0].min(lengths[1]), spacing });
        }
        let mut body = Lattice::new(&cells, &low, &edge, &count, &high);
        body.fit(self, edge.max());
        body.shake(jitter);
        let (names, node) = (body.names(self), body.node);
        let name = |quad: &[u32; 4]| names[quad].to_owned();
        Grid { node, cell: body.cell }.into_particles(edge.max(), name)
    }
}

/// Cells whose centre is inside; where two touch along a line alone, one more.
fn kept(solid: &Solid, low: &Vec3, edge: &Vec3, count: &[usize]) -> BTreeSet<[usize; 3]> {
    // off the centre by a share that no drawing repeats, so that no line runs through an edge of the surface
    let middle = |axis: usize, i: usize, off: f64| low[axis] + edge[axis] * (i as f64 + 0.5 + off);
    let mut cells = BTreeSet::new();
    for j in 0..count[1] {
        for k in 0..count[2] {
            let crossings = solid.crossings(middle(1, j, 1.234_567e-6), middle(2, k, 2.718_281e-6));
            for i in 0..count[0] {
                let x = middle(0, i, 0.0);
                if crossings.partition_point(|at| *at < x) % 2 == 1 {
                    cells.insert([i, j, k]);
                }
            }
        }
    }
    loop {
        let before = cells.len();
        for [first, second] in [[0, 1], [1, 2], [2, 0]] {
            for cell in cells.clone() {
                for step in [1_isize, -1] {
                    let moved = |axis: usize, by: isize, from: [usize; 3]| {
                        let mut at = from;
                        at[axis] = at[axis].checked_add_signed(by)?;
                        (at[axis] < count[axis]).then_some(at)
                    };
                    let (Some(a), Some(b)) = (moved(first, 1, cell), moved(second, step, cell)) else {
                        continue;
                    };
                    let Some(across) = moved(second, step, a) else { continue };
                    if cells.contains(&across) && !cells.contains(&a) && !cells.contains(&b) {
                        cells.insert(a);
                    }
                }
            }
        }
        if cells.len() == before {
            return cells;
        }
    }
}

/// The grid on its way.
struct Lattice {
    node: Vec<Vec3>,
    original: Vec<Vec3>,
    cell: Vec<[u32; 8]>,
    boundary: Vec<[u32; 4]>,
    /// Nodes each node shares an edge with; of a boundary node those on the boundary.
    around: Vec<Vec<u32>>,
    on_boundary: Vec<bool>,
    /// Axes along which the boundary quadrilaterals of each node look on the lattice.
    looks: Vec<[bool; 3]>,
    near: BTreeSet<u32>,
    /// The plane ends of the bounds that each node lies in on the lattice: axis by axis, least and greatest.
    ends: Vec<[[bool; 2]; 3]>,
    regular: f64,
}

impl Lattice {
    fn new(cells: &BTreeSet<[usize; 3]>, low: &Vec3, edge: &Vec3, count: &[usize], high: &Vec3) -> Self {
        const OFFSET: [[usize; 3]; 8] =
            [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
        let corners = |at: &[usize; 3]| OFFSET.map(|o| [0, 1, 2].map(|i| at[i] + o[i]));
        let all: BTreeSet<[usize; 3]> = cells.iter().flat_map(corners).collect();
        let index: BTreeMap<[usize; 3], u32> =
            all.iter().enumerate().map(|(n, at)| (*at, n as u32)).collect();
        let node: Vec<Vec3> = all
            .iter()
            .map(|at| {
                Vec3::from_fn(|i, _| match at[i] {
                    n if n == count[i] => high[i],
                    n => low[i] + edge[i] * n as f64,
                })
            })
            .collect();
        let ends = all.iter().map(|at| [0, 1, 2].map(|i| [at[i] == 0, at[i] == count[i]])).collect();
        let cell: Vec<[u32; 8]> = cells.iter().map(|at| corners(at).map(|corner| index[&corner])).collect();
        let boundary = Grid { node: node.clone(), cell: cell.clone() }.boundary();
        let mut on_boundary = vec![false; node.len()];
        let mut looks = vec![[false; 3]; node.len()];
        let mut sets = vec![BTreeSet::new(); node.len()];
        for quad in &boundary {
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
        let around = sets.into_iter().map(|set| set.into_iter().collect()).collect();
        let (original, near) = (node.clone(), BTreeSet::new());
        let regular = edge.x * edge.y * edge.z / 8.0;
        Self { node, original, cell, boundary, around, on_boundary, looks, near, ends, regular }
    }

    /// Moves boundary nodes onto the surface and lets those around follow.
    fn fit(&mut self, solid: &Solid, spacing: f64) {
        let nearest = Nearest::new(solid, spacing);
        let (reach, edge_reach) = (REACH * spacing, EDGE_REACH * spacing);
        let mut fixed = vec![false; self.node.len()];
        for a in (0..self.node.len()).filter(|&a| self.on_boundary[a]) {
            let x = self.node[a];
            let is_corner = self.looks[a].iter().filter(|looks| **looks).count() > 1;
            let on_edge = if is_corner { nearest.edge(&x, edge_reach) } else { None };
            fixed[a] = on_edge.is_some();
            if let Some(point) = on_edge.or_else(|| nearest.surface(&x, reach)) {
                self.node[a] = point;
            }
        }
        let moved = |a: &u32| (self.node[*a as usize] - self.original[*a as usize]).norm() > 1e-9 * spacing;
        self.near = (0..self.node.len() as u32).filter(moved).collect();
        for _ in 0..RINGS {
            let ring: Vec<u32> =
                self.near.iter().flat_map(|&a| self.around[a as usize].iter().copied()).collect();
            self.near.extend(ring);
        }
        for _ in 0..SWEEPS {
            let old = self.node.clone();
            for &a in self.near.iter().filter(|&&a| !fixed[a as usize]) {
                let a = a as usize;
                let around = &self.around[a];
                let mean = around.iter().map(|&b| old[b as usize]).sum::<Vec3>() / around.len() as f64;
                let between = 0.5 * (old[a] + mean);
                self.node[a] = match self.on_boundary[a] {
                    true => nearest.surface(&between, reach).unwrap_or(old[a]),
                    false => between,
                };
            }
        }
        self.retreat();
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
                self.node[a] += Vec3::from_fn(|axis, _| jitter * edge * random(3 * a + axis));
            }
        }
    }

    /// Name of the face of each boundary quadrilateral.
    fn names(&self, solid: &Solid) -> BTreeMap<[u32; 4], &'static str> {
        const PLANES: [[&str; 2]; 3] = [["xmin", "xmax"], ["ymin", "ymax"], ["zmin", "zmax"]];
        let name = |quad: &[u32; 4]| {
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
