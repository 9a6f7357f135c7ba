//! Boxes to node lattices.
//!
//! Owns counts, positions, order and random displacement of the nodes of a box. Volumes and areas come
//! from the background grid.

use super::error::DiscretisationError;
use super::grid::Grid;
use super::particles::Particles;
use crate::tensor::Vec3;

/// Most nodes a body may have.
const LIMIT: u32 = 100_000_000;

/// Greatest ratio of the spacings of two axes: up to it, with a support of 2.02 spacings, the lattice
/// neighbours are those of a cubic lattice (the nearest left out is at √5/1.05 = 2.13).
const EVENNESS: f64 = 1.05;

/// Seed of the random displacement; part of the definition of a jittered lattice.
const SEED: u64 = 0x7469_7373_7565;

/// Nodes of a box, possibly cut by planes of symmetry.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `min`, `max` | corners of the whole box | m |
/// | `spacing` | spacing asked for | m |
/// | `symmetry` | planes normal to x, y, z; the part of greater coordinates is kept | m |
/// | `jitter` | bound of each component of the nodes' random displacement, in spacings | – |
///
/// The count along each axis is the whole number nearest to length over spacing, at least one cell.
/// Nodes are in lexicographic order, the axis with the fewest nodes fastest. Inner nodes are displaced
/// along all axes, nodes on a face within it, nodes on edges and corners not at all.
pub(super) fn of_box(
    min: &Vec3,
    max: &Vec3,
    spacing: f64,
    symmetry: [Option<f64>; 3],
    jitter: f64,
) -> Result<Particles, DiscretisationError> {
    if !(spacing > 0.0 && spacing.is_finite()) {
        return Err(DiscretisationError::BadSpacing { spacing });
    }
    if !(0.0..0.5).contains(&jitter) {
        return Err(DiscretisationError::BadJitter { jitter });
    }
    let mut low = *min;
    for axis in 0..3 {
        let extent = (min[axis], max[axis]);
        if !(extent.1 - extent.0 > 0.0 && extent.0.is_finite() && extent.1.is_finite()) {
            let name = ["x", "y", "z"][axis];
            return Err(DiscretisationError::BadDimension { name, value: extent.1 - extent.0 });
        }
        if let Some(at) = symmetry[axis] {
            if !(at > extent.0 && at < extent.1) {
                return Err(DiscretisationError::PlaneOutside { axis, at, extent });
            }
            low[axis] = at;
        }
    }
    let length = max - low;
    let count = counts(&length, spacing)?;
    let actual: [f64; 3] = std::array::from_fn(|axis| length[axis] / count[axis] as f64);
    let greatest = actual.iter().fold(0.0_f64, |d, &x| d.max(x));
    let grid = lattice(&low, max, count, jitter * greatest);
    // the nodes of a face carry its coordinate to the last bit
    let name = |corner: &[Vec3; 4]| {
        for axis in 0..3 {
            let letter = ["x", "y", "z"][axis];
            if corner.iter().all(|x| x[axis] == low[axis]) {
                return if symmetry[axis].is_some() {
                    format!("symmetry_{letter}")
                } else {
                    format!("{letter}min")
                };
            }
            if corner.iter().all(|x| x[axis] == max[axis]) {
                return format!("{letter}max");
            }
        }
        unreachable!("every boundary quadrilateral of a lattice lies in a plane of the box")
    };
    grid.into_particles(greatest, name)
}

/// Cells along each axis.
fn counts(length: &Vec3, spacing: f64) -> Result<[usize; 3], DiscretisationError> {
    let wanted = length.map(|l| (l / spacing).round().max(1.0));
    let nodes = (wanted.x + 1.0) * (wanted.y + 1.0) * (wanted.z + 1.0);
    if nodes > f64::from(LIMIT) {
        return Err(DiscretisationError::TooManyParticles { count: nodes, limit: LIMIT });
    }
    let actual = length.component_div(&wanted);
    if actual.max() > EVENNESS * actual.min() {
        let suggestion = suggestion(length, spacing);
        return Err(DiscretisationError::UnevenSpacing {
            requested: spacing,
            actual: actual.into(),
            suggestion,
        });
    }
    Ok(std::array::from_fn(|axis| wanted[axis] as usize))
}

/// The spacing nearest to the one asked for that divides the shortest edge and all others evenly enough.
fn suggestion(length: &Vec3, spacing: f64) -> f64 {
    let shortest = length.min();
    let most = (4.0 * shortest / spacing).ceil().max(60.0) as usize;
    let even = |d: f64| {
        let actual = length.component_div(&length.map(|l| (l / d).round().max(1.0)));
        actual.max() <= EVENNESS * actual.min()
    };
    let distance = |d: f64| if d > spacing { d / spacing } else { spacing / d };
    (1..=most)
        .map(|n| shortest / n as f64)
        .filter(|&d| even(d))
        .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
        // 60 cells along the shortest edge leave every other within 1/120 of it
        .expect("a fine enough spacing is even")
}

/// The grid of `count` cells along each axis, its free nodes displaced by up to `shift` along each axis.
fn lattice(low: &Vec3, high: &Vec3, count: [usize; 3], shift: f64) -> Grid {
    let mut axes = [0, 1, 2];
    axes.sort_by_key(|&axis| count[axis]);
    let mut stride = [0; 3];
    let mut nodes = 1;
    for axis in axes {
        stride[axis] = nodes;
        nodes *= count[axis] + 1;
    }
    let index = |i: [usize; 3]| i[0] * stride[0] + i[1] * stride[1] + i[2] * stride[2];
    let place = |a: usize| -> Vec3 {
        let i: [usize; 3] = std::array::from_fn(|axis| a / stride[axis] % (count[axis] + 1));
        let end = |axis: usize| i[axis] == 0 || i[axis] == count[axis];
        let fixed = (0..3).filter(|&axis| end(axis)).count() > 1;
        Vec3::from_fn(|axis, _| {
            // both ends exactly: faces are recognised by their coordinate
            let regular = match i[axis] {
                0 => low[axis],
                k if k == count[axis] => high[axis],
                k => low[axis] + (high[axis] - low[axis]) * (k as f64 / count[axis] as f64),
            };
            if shift == 0.0 || fixed || end(axis) { regular } else { regular + shift * random(3 * a + axis) }
        })
    };
    let node = (0..nodes).map(place).collect();
    let mut cell = Vec::with_capacity(count[0] * count[1] * count[2]);
    for outer in 0..count[axes[2]] {
        for middle in 0..count[axes[1]] {
            for inner in 0..count[axes[0]] {
                let mut i = [0; 3];
                (i[axes[0]], i[axes[1]], i[axes[2]]) = (inner, middle, outer);
                let [x, y, z] = i;
                let corner = |dx, dy, dz| index([x + dx, y + dy, z + dz]) as u32;
                cell.push([
                    corner(0, 0, 0),
                    corner(1, 0, 0),
                    corner(1, 1, 0),
                    corner(0, 1, 0),
                    corner(0, 0, 1),
                    corner(1, 0, 1),
                    corner(1, 1, 1),
                    corner(0, 1, 1),
                ]);
            }
        }
    }
    Grid { node, cell }
}

/// A number in [−1, 1) that depends on `n` alone: the 53 leading bits of SplitMix64.
fn random(n: usize) -> f64 {
    let mut z = SEED.wrapping_add((n as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 * (2.0 / (1u64 << 53) as f64) - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::FaceNodes;

    const MIN: Vec3 = Vec3::new(-0.1, 0.0, 0.2);
    const MAX: Vec3 = Vec3::new(0.9, 0.6, 0.4);

    fn names(particles: &Particles) -> Vec<&str> {
        particles.faces.iter().map(|face| face.name.as_str()).collect()
    }

    #[test]
    fn a_regular_lattice_has_tributary_volumes_and_areas() {
        let particles = of_box(&MIN, &MAX, 0.1, [None; 3], 0.0).unwrap();
        assert_eq!(particles.len(), 11 * 7 * 3);
        let share = |x: f64, low: f64, high: f64| if x == low || x == high { 0.5 } else { 1.0 };
        for (x, v) in particles.position.iter().zip(&particles.volume) {
            let shares: Vec<f64> = (0..3).map(|i| share(x[i], MIN[i], MAX[i])).collect();
            assert!((v - 1e-3 * shares[0] * shares[1] * shares[2]).abs() < 1e-17, "{x}: {v}");
        }
        let FaceNodes { nodes, area, .. } = particles.face("zmax").unwrap();
        assert_eq!(nodes.len(), 11 * 7);
        for (&a, n) in nodes.iter().zip(area) {
            let x = particles.position[a as usize];
            let share = share(x.x, MIN.x, MAX.x) * share(x.y, MIN.y, MAX.y);
            assert!((n - Vec3::new(0.0, 0.0, 1e-2 * share)).norm() < 1e-16, "{x}: {n}");
        }
        assert_eq!(names(&particles), ["xmax", "xmin", "ymax", "ymin", "zmax", "zmin"]);
    }

    #[test]
    fn a_plane_of_symmetry_keeps_the_greater_part_and_names_the_cut() {
        let particles = of_box(&MIN, &MAX, 0.1, [Some(0.4), None, Some(0.3)], 0.0).unwrap();
        assert_eq!(particles.len(), 6 * 7 * 2);
        assert_eq!(names(&particles), ["symmetry_x", "symmetry_z", "xmax", "ymax", "ymin", "zmax"]);
        assert!(particles.position.iter().all(|x| x.x >= 0.4 && x.z >= 0.3));
    }

    #[test]
    fn a_plane_beside_the_box_is_refused() {
        let error = of_box(&MIN, &MAX, 0.1, [None, Some(0.6), None], 0.0).unwrap_err();
        let expected = DiscretisationError::PlaneOutside { axis: 1, at: 0.6, extent: (0.0, 0.6) };
        assert_eq!(error, expected);
    }

    #[test]
    fn a_spacing_that_divides_unevenly_is_refused_and_the_suggestion_is_accepted() {
        let max = MIN + Vec3::new(1.0, 0.33, 0.09);
        let error = of_box(&MIN, &max, 0.06, [None; 3], 0.0).unwrap_err();
        let DiscretisationError::UnevenSpacing { suggestion, .. } = error else { panic!("{error}") };
        let particles = of_box(&MIN, &max, suggestion, [None; 3], 0.0).unwrap();
        assert!(particles.least_spacing > particles.spacing / (EVENNESS + 1e-12));
        assert!((0.5..2.0).contains(&(suggestion / 0.06)), "{suggestion}");
    }

    #[test]
    fn nodes_are_in_order_with_the_shortest_axis_fastest() {
        let particles = of_box(&MIN, &MAX, 0.1, [None; 3], 0.0).unwrap();
        let key = |x: &Vec3| [x.x, x.y, x.z].map(|c| (c * 1e6).round() as i64);
        assert!(particles.position.iter().map(key).is_sorted());
    }

    #[test]
    fn jitter_moves_inner_nodes_and_leaves_every_face_plane_and_every_edge_alone() {
        let regular = of_box(&MIN, &MAX, 0.1, [None; 3], 0.0).unwrap();
        let moved = of_box(&MIN, &MAX, 0.1, [None; 3], 0.3).unwrap();
        assert_eq!(names(&regular), names(&moved));
        let mut most = Vec3::zeros();
        for (x, y) in regular.position.iter().zip(&moved.position) {
            let ends: Vec<usize> = (0..3).filter(|&i| x[i] == MIN[i] || x[i] == MAX[i]).collect();
            assert!(ends.iter().all(|&i| x[i] == y[i]));
            assert!(ends.len() < 2 || x == y);
            assert!(ends.len() > 1 || x != y);
            most = most.sup(&(x - y).abs());
        }
        // 45 to 99 draws a component: that none exceeds 0.8 of the bound has odds below 1e-4
        assert!(most.min() > 0.8 * 0.03 && most.max() <= 0.03, "{most}");
        assert!(moved.volume.iter().all(|&v| v > 0.0));
    }

    #[test]
    fn nonsense_is_refused() {
        for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = of_box(&MIN, &MAX, spacing, [None; 3], 0.0).unwrap_err();
            assert!(matches!(error, DiscretisationError::BadSpacing { .. }));
        }
        for jitter in [-0.1, 0.5, f64::NAN] {
            let error = of_box(&MIN, &MAX, 0.1, [None; 3], jitter).unwrap_err();
            assert!(matches!(error, DiscretisationError::BadJitter { .. }));
        }
        let error = of_box(&MAX, &MIN, 0.1, [None; 3], 0.0).unwrap_err();
        assert!(matches!(error, DiscretisationError::BadDimension { name: "x", .. }));
        let error = of_box(&MIN, &MAX, 1e-9, [None; 3], 0.0).unwrap_err();
        assert!(matches!(error, DiscretisationError::TooManyParticles { .. }));
    }
}
