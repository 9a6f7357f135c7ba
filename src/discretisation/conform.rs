//! Solids to particles: a lattice whose boundary nodes lie on the surface.
//!
//! Owns how boundary nodes move onto surface and sharp edges, how those nearby follow, and
//! how far where a cell would be turned inside out. Knows no file.

use super::error::DiscretisationError;
use super::filled::Lattice;
use super::filling::Cells;
use super::grid::{Grid, least_determinant};
use super::lattice::{checked, random};
use super::nearest::Nearest;
use super::particles::Particles;
use super::shaping::Shaping;
use super::solid::Solid;
use crate::tensor::Vec3;
use std::collections::BTreeSet;

/// Rings of nodes around moved ones that follow, and sweeps of smoothing, as in the plane.
const RINGS: usize = 3;
const SWEEPS: usize = 30;

/// Reach of a boundary node, in spacings: the corner of a kept cell lies within half a diagonal of the surface.
const REACH: f64 = 1.5;

/// The same for a sharp edge; beyond it the next layer of nodes would be drawn to it as well.
const EDGE_REACH: f64 = 0.9;

/// Least distance of two nodes on sharp edges, as a share of that reach.
const APART: f64 = 0.4;

/// How often a point is taken to the surface and back to the plane of symmetry it lies in.
const MEETINGS: usize = 3;

/// Smallest determinant of a cell, relative to the regular one's: flatter cells shorten the time step. Three sides of a
/// cell in one plane leave it 0.08 to 0.16.
const FLATTEST: f64 = 0.05;

/// Rounds in which the nodes of too flat cells go half the way back to the lattice.
const RETREATS: usize = 40;

/// Rounds in which cells are shaped. They end with a smaller share of the step that the curvatures allow, and with a
/// smaller gain; larger steps would let round-off grow, and parts would not be those of the whole.
const ROUNDS: usize = 100;
const LEAST_SHARE: f64 = 1e-3;
const LEAST_GAIN: f64 = 1e-6;

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

impl Lattice {
    /// Moves boundary nodes onto the surface and lets those around follow.
    fn fit(&mut self, solid: &Solid, spacing: f64) {
        let nearest = Nearest::new(solid, spacing);
        let reach = REACH * spacing;
        let on_edge = self.on_edges(&nearest, EDGE_REACH * spacing);
        let fixed: Vec<bool> = on_edge.iter().map(Option::is_some).collect();
        for a in (0..self.node.len()).filter(|&a| self.on_boundary[a]) {
            let x = self.node[a];
            if let Some(point) = on_edge[a].or_else(|| self.within(a, &x, |x| nearest.surface(x, reach))) {
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
        self.shape(&nearest, &fixed, reach);
        self.retreat();
    }

    /// The point of a sharp edge that each corner of the lattice goes to, the nearest first, none beside another's.
    fn on_edges(&self, nearest: &Nearest<'_>, reach: f64) -> Vec<Option<Vec3>> {
        let is_corner = |a: &usize| self.looks[*a].iter().filter(|looks| **looks).count() > 1;
        let mut found: Vec<(f64, usize, Vec3)> = (0..self.node.len())
            .filter(|&a| self.on_boundary[a])
            .filter(is_corner)
            .filter_map(|a| {
                let x = self.node[a];
                let point = self.within(a, &x, |x| nearest.edge(x, reach))?;
                Some(((point - x).norm(), a, point))
            })
            .collect();
        found.sort_by(|(r, a, _), (s, b, _)| r.total_cmp(s).then(a.cmp(b)));
        let (mut on_edge, mut taken): (Vec<Option<Vec3>>, Vec<Vec3>) = (vec![None; self.node.len()], vec![]);
        for (_, a, point) in found {
            if taken.iter().all(|other| (other - point).norm() > APART * reach) {
                taken.push(point);
                on_edge[a] = Some(point);
            }
        }
        on_edge
    }

    /// Brings cells beside the surface nearer to regular ones, boundary nodes along the surface.
    fn shape(&mut self, nearest: &Nearest<'_>, fixed: &[bool], reach: f64) {
        let touched = |cell: &&[u32; 8]| cell.iter().any(|a| self.near.contains(a));
        let shaping = Shaping::new(self.cell.iter().filter(touched).collect(), &self.edge);
        let free: Vec<usize> = self.near.iter().map(|&a| a as usize).filter(|&a| !fixed[a]).collect();
        let mut quality = shaping.measure(&self.node);
        let mut share = 1.0;
        for _ in 0..ROUNDS {
            let mut node = self.node.clone();
            for &a in &free {
                let step = quality.slope[a] * (share / quality.curvature[a]);
                let moved = self.mirrored(a, &(node[a] - step));
                node[a] = match self.on_boundary[a] {
                    true => self.within(a, &moved, |x| nearest.surface(x, reach)).unwrap_or(node[a]),
                    false => moved,
                };
            }
            let next = shaping.measure(&node);
            // NaN included
            if next.energy.partial_cmp(&quality.energy) != Some(std::cmp::Ordering::Less) {
                share *= 0.5;
                if share < LEAST_SHARE {
                    return;
                }
                continue;
            }
            let gained = quality.energy - next.energy;
            (self.node, quality, share) = (node, next, (1.5 * share).min(1.0));
            if gained < LEAST_GAIN * quality.energy {
                return;
            }
        }
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
}
