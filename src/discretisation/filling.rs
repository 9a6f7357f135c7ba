//! The regular cells around a solid, and which of them fill it.
//!
//! Owns the division of the solid's bounds, cut by planes of symmetry, and the choice of cells. Moves no node.

use super::error::DiscretisationError;
use super::lattice::{LIMIT, divide};
use super::solid::Solid;
use crate::tensor::Vec3;
use std::collections::BTreeSet;

/// Greatest ratio of the spacings of the lattice; beside the surface they vary by more anyway.
const EVENNESS: f64 = 1.25;

/// The bounds of a solid divided into cells of one size.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    pub low: Vec3,
    pub high: Vec3,
    /// Edges of a cell, m.
    pub edge: Vec3,
    /// Cells along each axis.
    pub count: [usize; 3],
    /// Whether the lesser end of each axis is a plane of symmetry.
    pub cut: [bool; 3],
}

impl Cells {
    /// The cells of the part of greater coordinates.
    ///
    /// # Errors
    /// [`DiscretisationError::PlaneOutside`] if a plane does not cut the solid, and what the spacing does not fit.
    pub fn of(solid: &Solid, spacing: f64, symmetry: [Option<f64>; 3]) -> Result<Self, DiscretisationError> {
        let (mut low, high) = solid.bounds();
        for (axis, at) in symmetry.into_iter().enumerate() {
            let Some(at) = at else { continue };
            if !(at > low[axis] && at < high[axis]) {
                return Err(DiscretisationError::PlaneOutside { axis, at, extent: (low[axis], high[axis]) });
            }
            low[axis] = at;
        }
        let lengths = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let divided = divide(&lengths, spacing, EVENNESS)?;
        let count = [divided[0], divided[1], divided[2]];
        let nodes: f64 = count.iter().map(|&n| n as f64 + 1.0).product();
        if nodes > f64::from(LIMIT) {
            return Err(DiscretisationError::TooManyParticles { count: nodes, limit: LIMIT });
        }
        let edge = Vec3::from_fn(|axis, _| lengths[axis] / count[axis] as f64);
        Ok(Self { low, high, edge, count, cut: symmetry.map(|at| at.is_some()) })
    }

    /// Place of a corner of the cells; the last lies on the bound to the last bit.
    pub fn corner(&self, at: &[usize; 3]) -> Vec3 {
        Vec3::from_fn(|i, _| match at[i] {
            n if n == self.count[i] => self.high[i],
            n => self.low[i] + self.edge[i] * n as f64,
        })
    }

    /// Cells whose centre is inside; where two touch along a line alone, one more.
    pub fn kept(&self, solid: &Solid) -> BTreeSet<[usize; 3]> {
        let (low, edge, count) = (&self.low, &self.edge, &self.count);
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
}
