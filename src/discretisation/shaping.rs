//! How far cells are from regular ones, and where their nodes must move to come nearer.
//!
//! Owns one number a grid, its slopes and curvatures. Knows no surface: who calls says where a node may go.

use super::grid::slopes;
use crate::tensor::{Mat3, Vec3, cofactor};

/// Determinant, relative to the regular one, below which a cell is turned up by force rather than by shape.
const SOFT: f64 = 0.01;

/// Cells whose shape is to be improved.
///
/// ```text
/// E = Σ_cells Σ_gauss q² ½ (h + 1/h),   q = |M|² / (3 h^⅔),   h = ½ (d + √(d² + 4 δ²)),   d = det M
/// ```
///
/// with `M` the map from the regular cell to the cell: `q` is 1 for a regular cell of any size and `½ (h + 1/h)` for a cell
/// of its volume. Both grow without bound as a cell is flattened, and for cells turned inside out they still fall towards
/// those that are not.
#[derive(Debug)]
pub(super) struct Shaping<'a> {
    cell: Vec<&'a [u32; 8]>,
    /// Slopes of the shape functions at the Gauss points of a regular cell, 1/m.
    slope: [[Vec3; 8]; 8],
}

/// The number, its slopes and curvatures.
#[derive(Debug)]
pub(super) struct Quality {
    pub energy: f64,
    /// By node, 1/m.
    pub slope: Vec<Vec3>,
    /// A bound of the curvature along any direction, by node, 1/m².
    pub curvature: Vec<f64>,
    /// Least determinant relative to the regular one.
    pub least: f64,
}

impl<'a> Shaping<'a> {
    /// The cells, and the edges of a regular one, m.
    pub fn new(cell: Vec<&'a [u32; 8]>, edge: &Vec3) -> Self {
        let scaled = |slope: Vec3| (2.0 * slope).component_div(edge);
        Self { cell, slope: slopes().map(|point| point.map(scaled)) }
    }

    /// The number and its slopes where the nodes are.
    pub fn measure(&self, node: &[Vec3]) -> Quality {
        let mut shape = Quality {
            energy: 0.0,
            slope: vec![Vec3::zeros(); node.len()],
            curvature: vec![0.0; node.len()],
            least: f64::INFINITY,
        };
        for cell in &self.cell {
            let corner = cell.map(|a| node[a as usize]);
            for slope in &self.slope {
                let map: Mat3 = corner.iter().zip(slope).map(|(x, g)| x * g.transpose()).sum();
                let (d, square, area) = (map.determinant(), map.norm_squared(), cofactor(&map));
                let root = libm::sqrt(d * d + 4.0 * SOFT * SOFT);
                // of d < 0 without cancellation
                let h = if d > 0.0 { 0.5 * (d + root) } else { 2.0 * SOFT * SOFT / (root - d) };
                // (|M|²/3)² ½ (h^-⅓ + h^-7/3), and its first and second slope by ln h
                let third = square * square / (18.0 * libm::cbrt(h));
                let seventh = third / (h * h);
                let energy = third + seventh;
                let (first, second) = (-(third + 7.0 * seventh) / 3.0, (third + 49.0 * seventh) / 9.0);
                shape.energy += energy;
                shape.least = shape.least.min(d);
                let along = map * (4.0 * energy / square) + area * (first / root);
                for (&a, g) in cell.iter().zip(slope) {
                    let (lift, a) = (area * g, a as usize);
                    shape.slope[a] += along * g;
                    shape.curvature[a] += 4.0 * energy * g.norm_squared() / square
                        + (second - 0.5 * first) * lift.norm_squared() / (root * root);
                }
            }
        }
        shape
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CELL: [u32; 8] = [0, 1, 2, 3, 4, 5, 6, 7];

    /// A cell of edges 1, 2 and 3 whose corners are displaced by shares of a half.
    fn corners(shift: f64) -> Vec<Vec3> {
        let unit = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
        let place = |(a, at): (usize, &[i32; 3])| {
            let regular = Vec3::new(f64::from(at[0]), 2.0 * f64::from(at[1]), 3.0 * f64::from(at[2]));
            let off = |i: usize| libm::sin((7 * a + 3 * i + 1) as f64);
            regular + shift * Vec3::new(off(0), off(1), off(2))
        };
        unit.iter().enumerate().map(place).collect()
    }

    fn shaping(cell: &[u32; 8]) -> Shaping<'_> {
        Shaping::new(vec![cell], &Vec3::new(1.0, 2.0, 3.0))
    }

    #[test]
    fn a_regular_cell_has_the_least_value_and_no_slope() {
        let quality = shaping(&CELL).measure(&corners(0.0));
        // h is 1 + δ² in place of 1, and the value of a point falls by 4/3 of that
        assert!((quality.energy - 8.0 * (1.0 - 4.0 / 3.0 * SOFT * SOFT)).abs() < 1e-6, "{}", quality.energy);
        assert!((quality.least - 1.0).abs() < 1e-14);
        assert!(quality.slope.iter().all(|slope| slope.norm() < 1e-2), "{:?}", quality.slope);
        assert!(shaping(&CELL).measure(&corners(0.1)).energy > quality.energy + 0.01);
    }

    #[test]
    fn slopes_are_those_of_central_differences_also_inside_out() {
        let shaping = shaping(&CELL);
        for shift in [0.1, 0.3, 1.6] {
            let node = corners(shift);
            let quality = shaping.measure(&node);
            assert_eq!(quality.least < 0.0, shift == 1.6, "{}", quality.least);
            for a in 0..8 {
                for i in 0..3 {
                    let at = |by: f64| {
                        let mut moved = node.clone();
                        moved[a][i] += by;
                        shaping.measure(&moved).energy
                    };
                    let step = 1e-6;
                    let difference = (at(step) - at(-step)) / (2.0 * step);
                    let scale = quality.slope[a].norm() + 1.0;
                    assert!(
                        (quality.slope[a][i] - difference).abs() < 1e-6 * scale * quality.energy.max(1.0)
                    );
                    assert!(quality.curvature[a] > 0.0);
                }
            }
        }
    }
}
