//! Grids of quadrilaterals whose boundary nodes lie on the boundary of a plane region.
//!
//! Owns the way from lattice lines to such a grid: keep the cells inside, move boundary nodes onto the
//! boundary, let the nodes nearby follow. Away from curved boundaries the lattice stays regular, which is
//! what the kernel likes best. Knows no third dimension.

use super::outline::{Outline, Vec2};
use std::collections::{BTreeMap, BTreeSet};

/// Rings of nodes around moved ones that follow.
const RINGS: usize = 3;

/// Sweeps of smoothing; each halves the shortest-waved unevenness, and three rings have settled to a few
/// per cent of a spacing after some twenty.
const SWEEPS: usize = 30;

/// Cosine of the angle, about 140°, from which on a corner counts as flat.
const FLAT: f64 = -0.77;

/// How a node may move within the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Freedom {
    /// Inside: anywhere.
    Plane,
    /// On a straight edge: along this axis.
    Line(usize),
    /// On a curved boundary: not at all within the plane.
    Curve,
    /// At a corner of the region.
    None,
}

/// A conforming grid of quadrilaterals, counter-clockwise; a triangle has one corner twice.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Planar {
    /// Nodes, m.
    pub node: Vec<Vec2>,
    /// Which lines of the lattice each node came from.
    pub line: Vec<[usize; 2]>,
    /// How each node may move without leaving the boundary.
    pub freedom: Vec<Freedom>,
    /// Corners of each quadrilateral.
    pub quad: Vec<[u32; 4]>,
}

/// What a boundary node has to keep to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Inside,
    /// Not moved at all: corners and nodes the lattice already put on the boundary, between these
    /// neighbours.
    Fixed([usize; 2]),
    /// On the curved boundary, between these neighbours.
    Curve([usize; 2]),
    /// On a plane of symmetry, free along this axis.
    Symmetry(usize),
    /// Where the boundary meets a plane of symmetry, found along this axis.
    End(usize),
}

impl Planar {
    /// Grid of a region from lattice lines along both axes; the region ends at planes of symmetry, given
    /// as the coordinate of the first line of an axis.
    pub fn of(outline: &Outline, lines: &[Vec<f64>; 2], symmetry: [bool; 2], spacing: f64) -> Self {
        let cells = kept(outline, lines);
        let mut index = BTreeMap::new();
        let mut line = Vec::new();
        let mut quad = Vec::with_capacity(cells.len());
        for &[i, j] in &cells {
            quad.push([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|at| {
                *index.entry(at).or_insert_with(|| {
                    line.push(at);
                    (line.len() - 1) as u32
                })
            }));
        }
        let node = line.iter().map(|&[i, j]| Vec2::new(lines[0][i], lines[1][j])).collect();
        let mut grid = Self { node, line, freedom: vec![], quad };
        grid.cut_flat_corners(outline, symmetry, spacing);
        let place = grid.places(outline, symmetry, spacing);
        grid.fit(outline, &place);
        let freedom = |(a, place): (usize, &Place)| match *place {
            Place::Inside => Freedom::Plane,
            Place::Symmetry(axis) => Freedom::Line(axis),
            // in one line with both neighbours: on a straight edge
            Place::Fixed([before, after]) => {
                let straight = |axis: &usize| {
                    let at = |b: usize| grid.node[b][*axis];
                    at(before) == at(a) && at(after) == at(a)
                };
                (0..2).find(straight).map_or(Freedom::None, |axis| Freedom::Line(1 - axis))
            }
            Place::Curve(_) => Freedom::Curve,
            Place::End(_) => Freedom::None,
        };
        grid.freedom = place.iter().enumerate().map(freedom).collect();
        grid
    }

    /// Edges that belong to one quadrilateral only, the region on their left.
    pub fn boundary(&self) -> Vec<[u32; 2]> {
        let edges = || self.quad.iter().flat_map(|q| (0..4).map(|k| [q[k], q[(k + 1) % 4]]));
        let all: BTreeSet<[u32; 2]> = edges().collect();
        edges().filter(|&[a, b]| a != b && !all.contains(&[b, a])).collect()
    }

    /// Makes triangles (quadrilaterals with one corner twice) of those whose corner would lie flat on a
    /// curved boundary between two others: such a node would carry a ninth of a boundary node's volume,
    /// and with it a third of its stable time step.
    fn cut_flat_corners(&mut self, outline: &Outline, symmetry: [bool; 2], spacing: f64) {
        let place = self.places(outline, symmetry, spacing);
        let mut uses = vec![0; self.node.len()];
        self.quad.iter().flatten().for_each(|&a| uses[a as usize] += 1);
        let fitted = |a: usize| match place[a] {
            Place::Curve(_) => outline.project(&self.node[a]).point,
            Place::End(axis) => along(outline, &self.node[a], axis),
            _ => self.node[a],
        };
        let flat = |a: usize| {
            let Place::Curve([before, after]) = place[a] else { return false };
            let (back, ahead) = (fitted(before) - fitted(a), fitted(after) - fitted(a));
            uses[a] == 1 && back.dot(&ahead) < FLAT * back.norm() * ahead.norm()
        };
        let mut kept = vec![true; self.node.len()];
        for quad in &mut self.quad {
            let corners: Vec<usize> = (0..4).filter(|&k| flat(quad[k] as usize)).collect();
            if let [k] = corners[..] {
                kept[quad[k] as usize] = false;
                quad[k] = quad[(k + 1) % 4];
            }
        }
        let mut next = 0;
        let renumbered: Vec<u32> = kept
            .iter()
            .map(|&kept| {
                next += u32::from(kept);
                next.saturating_sub(1)
            })
            .collect();
        self.quad.iter_mut().flatten().for_each(|a| *a = renumbered[*a as usize]);
        let mut keep = kept.iter();
        self.node.retain(|_| keep.next() == Some(&true));
        let mut keep = kept.iter();
        self.line.retain(|_| keep.next() == Some(&true));
    }

    /// What each node has to keep to.
    fn places(&self, outline: &Outline, symmetry: [bool; 2], spacing: f64) -> Vec<Place> {
        let mut place = vec![Place::Inside; self.node.len()];
        let mut previous = BTreeMap::new();
        let mut next = BTreeMap::new();
        for [a, b] in self.boundary() {
            next.insert(a as usize, b as usize);
            previous.insert(b as usize, a as usize);
        }
        let on_plane = |a: usize, axis: usize| symmetry[axis] && self.line[a][axis] == 0;
        for (&a, &after) in &next {
            let before = previous[&a];
            let planes: Vec<usize> = (0..2).filter(|&axis| on_plane(a, axis)).collect();
            place[a] = if let [axis] = planes[..] {
                let within = on_plane(before, axis) && on_plane(after, axis);
                if within { Place::Symmetry(1 - axis) } else { Place::End(1 - axis) }
            } else if planes.len() == 2 || outline.nearest(&self.node[a]).distance.abs() < 1e-9 * spacing {
                Place::Fixed([before, after])
            } else {
                Place::Curve([before, after])
            };
        }
        place
    }

    /// Moves boundary nodes onto the boundary and smooths the rings around those that moved.
    fn fit(&mut self, outline: &Outline, place: &[Place]) {
        let original = self.node.clone();
        for (a, place) in place.iter().enumerate() {
            match place {
                Place::Curve(_) => self.node[a] = outline.project(&self.node[a]).point,
                Place::End(axis) => self.node[a] = along(outline, &self.node[a], *axis),
                Place::Inside | Place::Fixed(_) | Place::Symmetry(_) => {}
            }
        }
        let neighbours = self.neighbours();
        let mut near: BTreeSet<usize> =
            (0..self.node.len()).filter(|&a| self.node[a] != original[a]).collect();
        for _ in 0..RINGS {
            let ring: Vec<usize> = near.iter().flat_map(|&a| neighbours[a].iter().copied()).collect();
            near.extend(ring);
        }
        for _ in 0..SWEEPS {
            let old = self.node.clone();
            for &a in &near {
                let mean = neighbours[a].iter().map(|&b| old[b]).sum::<Vec2>() / neighbours[a].len() as f64;
                match place[a] {
                    Place::Inside => self.node[a] = 0.5 * (old[a] + mean),
                    Place::Symmetry(axis) => self.node[a][axis] = 0.5 * (old[a][axis] + mean[axis]),
                    Place::Curve([before, after]) => {
                        let between = 0.25 * (2.0 * old[a] + old[before] + old[after]);
                        self.node[a] = outline.project(&between).point;
                    }
                    Place::Fixed(_) | Place::End(_) => {}
                }
            }
        }
    }

    /// The first place, by the first coordinate, where two nodes are less than `least` m apart.
    ///
    /// Boundary nodes go to the nearest point of the boundary each by itself: where lattice cells fill what two faces
    /// leave between them and are not a part of it, nodes of both sides go to one point.
    pub fn meeting(&self, least: f64) -> Option<Vec2> {
        let mut order: Vec<&Vec2> = self.node.iter().collect();
        order.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
        let near = |(a, p): (usize, &&Vec2)| {
            let ahead = order[a + 1..].iter().take_while(|q| q.x - p.x < least);
            ahead.into_iter().any(|q| (**q - **p).norm() < least)
        };
        order.iter().enumerate().find(|(a, p)| near((*a, p))).map(|(_, p)| **p)
    }

    /// Length of the shortest edge at each node, m.
    pub fn shortest_edges(&self) -> Vec<f64> {
        let mut shortest = vec![f64::INFINITY; self.node.len()];
        for quad in &self.quad {
            for k in 0..4 {
                let (a, b) = (quad[k] as usize, quad[(k + 1) % 4] as usize);
                if a == b {
                    continue;
                }
                let length = (self.node[a] - self.node[b]).norm();
                shortest[a] = length.min(shortest[a]);
                shortest[b] = length.min(shortest[b]);
            }
        }
        shortest
    }

    /// Nodes each node shares an edge with, ascending.
    fn neighbours(&self) -> Vec<Vec<usize>> {
        let mut sets = vec![BTreeSet::new(); self.node.len()];
        for quad in &self.quad {
            for k in 0..4 {
                let (a, b) = (quad[k] as usize, quad[(k + 1) % 4] as usize);
                if a != b {
                    sets[a].insert(b);
                    sets[b].insert(a);
                }
            }
        }
        sets.into_iter().map(|set| set.into_iter().collect()).collect()
    }
}

/// Lattice cells whose centre is inside, and those without which two would touch at a node alone, in
/// lexicographic order.
fn kept(outline: &Outline, lines: &[Vec<f64>; 2]) -> BTreeSet<[usize; 2]> {
    let (cells_x, cells_y) = (lines[0].len() - 1, lines[1].len() - 1);
    let middle = |axis: usize, i: usize| 0.5 * (lines[axis][i] + lines[axis][i + 1]);
    let distance = |i, j| outline.nearest(&Vec2::new(middle(0, i), middle(1, j))).distance;
    let mut cells: BTreeSet<[usize; 2]> = (0..cells_x)
        .flat_map(|i| (0..cells_y).map(move |j| [i, j]))
        .filter(|&[i, j]| distance(i, j) < 0.0)
        .collect();
    loop {
        let before = cells.len();
        for i in 1..cells_x {
            for j in 1..cells_y {
                let around = [[i - 1, j - 1], [i, j - 1], [i, j], [i - 1, j]];
                let has = around.map(|cell| cells.contains(&cell));
                if has == [true, false, true, false] || has == [false, true, false, true] {
                    let missing = around.into_iter().filter(|cell| !cells.contains(cell));
                    let best = missing.min_by(|s, t| distance(s[0], s[1]).total_cmp(&distance(t[0], t[1])));
                    cells.extend(best);
                }
            }
        }
        if cells.len() == before {
            return cells;
        }
    }
}

/// The point of the boundary reached along one axis, by secant steps with the distance.
fn along(outline: &Outline, from: &Vec2, axis: usize) -> Vec2 {
    let at = |s: f64| {
        let mut p = *from;
        p[axis] += s;
        p
    };
    let f = |s: f64| outline.nearest(&at(s)).distance;
    // the distance changes by no more than the step, so the first step does not overshoot
    let (mut s0, mut f0) = (0.0, f(0.0));
    let mut s1 = if f(f0).abs() < f(-f0).abs() { f0 } else { -f0 };
    for _ in 0..64 {
        let f1 = f(s1);
        if f1.abs() <= 4.0 * f64::EPSILON * (1.0 + from.amax()) || f1 == f0 {
            break;
        }
        (s0, f0, s1) = (s1, f1, s1 - f1 * (s1 - s0) / (f1 - f0));
    }
    at(s1)
}
