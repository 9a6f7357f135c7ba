//! Prisms to particles.
//!
//! Owns lattice lines, layers, names and random displacement for bodies extruded from a plane region.
//! Volumes and areas come from the background grid.

use super::error::DiscretisationError;
use super::grid::Grid;
use super::lattice::{Axis, LIMIT, checked, divide, random};
use super::outline::{Outline, Vec2};
use super::particles::Particles;
use super::planar::{Freedom, Planar};
use crate::tensor::Vec3;
use std::collections::BTreeMap;

/// Greatest ratio of the spacings of a regular lattice: up to it, with a support of 2.02 spacings, the
/// neighbours are those of a cubic lattice (the nearest left out is at √5/1.05 = 2.13).
const EVENNESS: f64 = 1.05;

/// The same where boundaries are curved; beside those the spacings vary by more than that anyway.
const EVENNESS_CURVED: f64 = 1.25;

/// Least distance of two nodes of a section in spacings; nearer ones would make the time step a thousand times shorter,
/// and none has a direction to a node it lies on.
const APART: f64 = 1e-3;

const LETTERS: [&str; 3] = ["x", "y", "z"];

/// A body extruded along an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Prism {
    /// The axis.
    pub axis: usize,
    /// Its ends along the axis, m.
    pub extent: (f64, f64),
    /// Cross-section; its axes follow the prism's in cyclic order.
    pub outline: Outline,
}

impl Prism {
    /// Nodes of the prism, see [`Particles::lattice`](super::Particles::lattice).
    ///
    /// Nodes are in lexicographic order of their lattice lines, the axis with the fewest lines fastest. At
    /// 64 000 nodes a loop over neighbours takes 1.3 times as long in Morton order and 2.7 times in random
    /// order (measured with [`Stencils::stable_length`](super::Stencils::stable_length) on one thread).
    pub fn particles(
        &self,
        spacing: f64,
        symmetry: [Option<f64>; 3],
        jitter: f64,
    ) -> Result<Particles, DiscretisationError> {
        checked(spacing, jitter)?;
        let radius = self.outline.least_radius();
        if radius < spacing {
            return Err(DiscretisationError::FeatureTooSmall { radius, spacing });
        }
        let axes: [Axis; 3] = [self.axis(0, &symmetry)?, self.axis(1, &symmetry)?, self.axis(2, &symmetry)?];
        let lengths: Vec<f64> = axes.iter().flat_map(Axis::lengths).collect();
        let evenness = if self.outline.is_straight() { EVENNESS } else { EVENNESS_CURVED };
        let count = divide(&lengths, spacing, evenness)?;
        let (along, rest) = count.split_at(axes[0].marks.len() - 1);
        let count =
            [along, rest.split_at(axes[1].marks.len() - 1).0, rest.split_at(axes[1].marks.len() - 1).1];
        let nodes: f64 = count.iter().map(|n| 1.0 + n.iter().map(|&n| n as f64).sum::<f64>()).product();
        if nodes > f64::from(LIMIT) {
            return Err(DiscretisationError::TooManyParticles { count: nodes, limit: LIMIT });
        }
        let cells = count.iter().flat_map(|n| n.iter());
        let greatest = lengths.iter().zip(cells).map(|(l, &n)| l / n as f64).fold(0.0, f64::max);
        let [layers, u, v] = std::array::from_fn(|k| axes[k].lines(count[k]));
        let cut = self.axes().map(|axis| symmetry[axis].is_some());
        let section = Planar::of(&self.outline, &[u, v], [cut[1], cut[2]], greatest);
        if let Some(place) = section.meeting(APART * greatest) {
            let mut position = Vec3::zeros();
            let [length, u, v] = self.axes();
            (position[length], position[u], position[v]) = (layers[0], place.x, place.y);
            return Err(DiscretisationError::NodesMeet { position, spacing });
        }
        // beside curved boundaries nodes are closer together and have less room
        let shift = section.shortest_edges().iter().map(|edge| jitter * edge.min(greatest)).collect();
        Extrusion { prism: self, section, layers, cut, shift }.particles(greatest)
    }

    /// Axes of space along the prism's own: its length, then the two of the outline.
    fn axes(&self) -> [usize; 3] {
        [self.axis, (self.axis + 1) % 3, (self.axis + 2) % 3]
    }

    /// Least and greatest coordinate along one of the prism's own axes.
    fn extent(&self, own: usize) -> (f64, f64) {
        if own == 0 { self.extent } else { self.outline.extent(own - 1) }
    }

    /// Marks along one of the prism's own axes.
    fn axis(&self, own: usize, symmetry: &[Option<f64>; 3]) -> Result<Axis, DiscretisationError> {
        let axis = self.axes()[own];
        let extent @ (low, high) = self.extent(own);
        if !(high - low > 0.0 && low.is_finite() && high.is_finite()) {
            return Err(DiscretisationError::BadDimension { name: ["x", "y", "z"][axis], value: high - low });
        }
        let mut marks = if own == 0 { vec![low, high] } else { self.outline.breaks(own - 1) };
        marks.retain(|&x| x >= low && x <= high);
        if let Some(at) = symmetry[axis] {
            if !(at > low && at < high) {
                return Err(DiscretisationError::PlaneOutside { axis, at, extent });
            }
            marks.retain(|&x| x > at);
            marks.push(at);
        }
        marks.sort_by(f64::total_cmp);
        marks.dedup_by(|x, y| (*x - *y).abs() < 1e-9 * (high - low));
        Ok(Axis { marks })
    }

    /// Name of the face between two neighbouring nodes of the outline: `xmin` … in an outermost plane,
    /// otherwise the kind of boundary.
    fn lateral_name(&self, points: [&Vec2; 2]) -> String {
        for own in [1, 2] {
            // the flanks of a dumbbell are one edge, its ends are planes
            if own == 2 && matches!(self.outline, Outline::Dumbbell { .. }) {
                continue;
            }
            let (low, high) = self.extent(own);
            for (end, side) in [(low, "min"), (high, "max")] {
                if points.iter().all(|p| (p[own - 1] - end).abs() < 1e-9 * (high - low)) {
                    return format!("{}{side}", LETTERS[self.axes()[own]]);
                }
            }
        }
        self.outline.nearest(&(0.5 * (points[0] + points[1]))).kind.to_owned()
    }
}

/// A prism's section and layers on the way to its grid.
struct Extrusion<'a> {
    prism: &'a Prism,
    section: Planar,
    layers: Vec<f64>,
    /// Whether the lesser end of each of the prism's own axes is a plane of symmetry.
    cut: [bool; 3],
    /// Bound of the random displacement of each node of the section, m.
    shift: Vec<f64>,
}

impl Extrusion<'_> {
    fn particles(self, spacing: f64) -> Result<Particles, DiscretisationError> {
        let order = self.order();
        let mut index = vec![0u32; order.len()];
        for (a, &(p, layer)) in order.iter().enumerate() {
            index[p * self.layers.len() + layer] = a as u32;
        }
        let node = order.iter().enumerate().map(|(a, &at)| self.place(a, at)).collect();
        let mut cell = Vec::with_capacity(self.section.quad.len() * (self.layers.len() - 1));
        for quad in &self.section.quad {
            for layer in 0..self.layers.len() - 1 {
                let corner = |k: usize| index[quad[k % 4] as usize * self.layers.len() + layer + k / 4];
                cell.push(std::array::from_fn(corner));
            }
        }
        // cells in the order of their first nodes, as the nodes are in spatial order
        cell.sort_unstable();
        let lateral = self.lateral_names();
        let [letter, ..] = self.prism.axes().map(|axis| LETTERS[axis]);
        let name = |quad: &[u32; 4]| {
            let at = quad.map(|a| order[a as usize]);
            if at.iter().all(|&(_, layer)| layer == 0) {
                return if self.cut[0] { format!("symmetry_{letter}") } else { format!("{letter}min") };
            }
            if at.iter().all(|&(_, layer)| layer == self.layers.len() - 1) {
                return format!("{letter}max");
            }
            let (low, high) = at.iter().fold((usize::MAX, 0), |(l, h), &(p, _)| (l.min(p), h.max(p)));
            lateral[&(low, high)].clone()
        };
        Grid { node, cell }.into_particles(spacing, name)
    }

    /// Section node and layer of each node, in lexicographic order of their lattice lines.
    fn order(&self) -> Vec<(usize, usize)> {
        let lines = |k: usize| self.section.line.iter().map(|l| l[k]).max().unwrap_or(0);
        let count = [self.layers.len() - 1, lines(0), lines(1)];
        let axes = self.prism.axes();
        let mut slowest = [0, 1, 2];
        slowest.sort_by_key(|&own| std::cmp::Reverse((count[own], axes[own])));
        let key = |&(p, layer): &(usize, usize)| {
            let [u, v] = self.section.line[p];
            slowest.map(|own| [layer, u, v][own])
        };
        let layers = self.layers.len();
        let mut order: Vec<(usize, usize)> =
            (0..self.section.node.len()).flat_map(|p| (0..layers).map(move |layer| (p, layer))).collect();
        order.sort_unstable_by_key(key);
        order
    }

    /// Position of node `a`: inner nodes are displaced along all axes, nodes on a plane face within it,
    /// nodes on a curved one along the prism, nodes on edges and corners not at all.
    fn place(&self, a: usize, (p, layer): (usize, usize)) -> Vec3 {
        let [length, u, v] = self.prism.axes();
        let mut x = Vec3::zeros();
        (x[length], x[u], x[v]) = (self.layers[layer], self.section.node[p].x, self.section.node[p].y);
        if self.shift[p] == 0.0 {
            return x;
        }
        let end = layer == 0 || layer == self.layers.len() - 1;
        let free = match (self.section.freedom[p], end) {
            (Freedom::Plane, false) => [true, true, true],
            (Freedom::Plane, true) => [false, true, true],
            (Freedom::Line(along), false) => [true, along == 0, along == 1],
            (Freedom::Curve, false) => [true, false, false],
            (Freedom::Line(_) | Freedom::Curve, true) | (Freedom::None, _) => [false; 3],
        };
        for (axis, free) in [length, u, v].into_iter().zip(free) {
            if free {
                x[axis] += self.shift[p] * random(3 * a + axis);
            }
        }
        x
    }

    /// Name of the face over each boundary edge of the section, by its nodes in ascending order.
    fn lateral_names(&self) -> BTreeMap<(usize, usize), String> {
        let name = |[p, q]: [u32; 2]| {
            let (p, q) = (p as usize, q as usize);
            let symmetric =
                |k: usize| self.cut[k + 1] && self.section.line[p][k] == 0 && self.section.line[q][k] == 0;
            let name = match (0..2).find(|&k| symmetric(k)) {
                Some(k) => format!("symmetry_{}", LETTERS[self.prism.axes()[k + 1]]),
                None => self.prism.lateral_name([&self.section.node[p], &self.section.node[q]]),
            };
            ((p.min(q), p.max(q)), name)
        };
        self.section.boundary().into_iter().map(name).collect()
    }
}

#[cfg(test)]
mod tests;
