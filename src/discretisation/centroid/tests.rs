//! Tests of offsets and of rows, before and after integration consistency.

use super::*;
use crate::discretisation::{Consistency, Shape, Solid, Stencils, correction};

const HIGH: Vec3 = Vec3::new(0.9, 0.6, 0.5);
const LOW: Vec3 = Vec3::new(0.0, 0.2, 0.0);

fn lattice(shape: &Shape, symmetry: [Option<f64>; 3], jitter: f64) -> Particles {
    Particles::lattice(shape, 0.1, symmetry, jitter).unwrap()
}

fn block(jitter: f64) -> Particles {
    lattice(&Shape::Box { min: LOW, max: HIGH }, [None; 3], jitter)
}

/// Two layers of particles.
fn sheet(jitter: f64) -> Particles {
    lattice(&Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.5, 0.5, 0.1) }, [None; 3], jitter)
}

fn cylinder() -> Particles {
    let shape = Shape::Cylinder { axis: 2, centre: Vec3::zeros(), radius: 0.3, height: 0.4 };
    lattice(&shape, [None; 3], 0.0)
}

/// An octahedron of triangles: edges and corners of a body from a file.
fn octahedron() -> Particles {
    let corner = |axis: usize, sign: f64| (0.4 * sign) * Vec3::ith(axis, 1.0);
    let triangle = |octant: usize| {
        let sign: [f64; 3] = std::array::from_fn(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 });
        let [x, y, z] = std::array::from_fn(|axis| corner(axis, sign[axis]));
        if sign.iter().product::<f64>() > 0.0 { [x, y, z] } else { [x, z, y] }
    };
    let triangles: Vec<[Vec3; 3]> = (0..8).map(triangle).collect();
    lattice(&Shape::Solid(Solid::new(&triangles).unwrap().into()), [None; 3], 0.0)
}

fn bodies() -> Vec<(&'static str, Particles, f64)> {
    vec![
        ("block", block(0.0), 1.01),
        ("displaced nodes", block(0.3), 1.2),
        ("nodes displaced by all they may be", block(0.45), 1.2),
        ("two layers", sheet(0.0), 1.01),
        ("two layers displaced", sheet(0.3), 1.2),
        ("cylinder", cylinder(), 1.2),
        ("triangles", octahedron(), 1.2),
    ]
}

/// Rows with the correction but without integration consistency, and where they start.
fn rows(particles: &Particles, smoothing: f64) -> (Neighbours, Vec<Vec3>) {
    let (kernel, h) = (Kernel::WendlandC2, smoothing * particles.spacing);
    let list = Neighbours::search(&particles.position, kernel.support() * h).unwrap();
    let row = |a: usize| {
        let neighbours = &list.neighbour[list.range(a)];
        correction::row(kernel, h, a, neighbours, &particles.position, &particles.volume).unwrap()
    };
    let mut forward: Vec<Vec3> = (0..particles.len()).flat_map(row).collect();
    impose(particles, kernel, h, &list, &mut forward).unwrap();
    (list, forward)
}

/// Worst `|1/V_a Σ_b C_ab f(X_b − X_a) − expected_a|` over the particles of `which`.
fn worst(
    particles: &Particles,
    (list, forward): &(Neighbours, Vec<Vec3>),
    which: impl Fn(&Vec3) -> bool,
    field: impl Fn(&Vec3) -> f64,
    expected: impl Fn(usize) -> Vec3,
) -> f64 {
    let error = |a: usize| {
        let sum = list.range(a).fold(Vec3::zeros(), |sum, entry| {
            let distance = particles.position[list.neighbour[entry] as usize] - particles.position[a];
            sum + forward[entry] * field(&distance)
        });
        (sum / particles.volume[a] - expected(a)).amax()
    };
    (0..particles.len()).filter(|&a| which(&particles.position[a])).map(error).fold(0.0, f64::max)
}

/// Distance to the nearer of a block's two faces normal to an axis.
fn depth(x: &Vec3, axis: usize) -> f64 {
    (x[axis] - LOW[axis]).min(HIGH[axis] - x[axis])
}

fn second_degree(axes: [usize; 2]) -> (impl Fn(&Vec3) -> f64, impl Fn(&Vec3) -> Vec3) {
    let [i, j] = axes;
    let slope = move |d: &Vec3| {
        let mut slope = Vec3::zeros();
        slope[i] += d[j];
        slope[j] += d[i];
        slope
    };
    (move |d: &Vec3| d[i] * d[j], slope)
}

const SECOND_DEGREE: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]];

#[test]
fn rows_keep_constants_and_linear_fields_in_every_body() {
    for (name, particles, smoothing) in bodies() {
        let rows = rows(&particles, smoothing);
        let constant = worst(&particles, &rows, |_| true, |_| 1.0, |_| Vec3::zeros());
        // a hundred entries of up to some hundred per metre, rounded
        assert!(constant < 1e-11, "{name}: {constant:e}");
        for axis in 0..3 {
            let linear = worst(&particles, &rows, |_| true, |d| d[axis], |_| Vec3::ith(axis, 1.0));
            assert!(linear < 1e-12, "{name}: {linear:e}");
        }
    }
}

#[test]
fn rows_see_second_degree_fields_half_way_to_the_centroid() {
    // The third layer behind a face tells the square of the depth from the depth, and what is left of that out mixes with
    // the rest: at most by the ratio of the moments, 2e-7 and 0.021/0.34.
    for (smoothing, mixed) in [(1.01, 1e-6), (1.2, 0.07)] {
        let particles = block(0.0);
        let (rows, offset) = (rows(&particles, smoothing), offsets(&particles));
        for axes in SECOND_DEGREE {
            let (field, slope) = second_degree(axes);
            let error = |which: &dyn Fn(&Vec3) -> bool| {
                worst(&particles, &rows, which, &field, |a| slope(&(0.5 * offset[a])))
            };
            let inside = error(&|x| (0..3).all(|axis| depth(x, axis) > 0.01));
            // lengths of a spacing, 0.1 m, and moments of condition below 1e3
            assert!(inside < 1e-12, "h/dx {smoothing}, {axes:?}: {inside:e}");
            let error = error(&|x| axes[0] != axes[1] || depth(x, axes[0]) > 0.01);
            assert!(error < 0.1 * mixed, "h/dx {smoothing}, {axes:?}: {error:e}");
        }
    }
}

#[test]
fn displaced_nodes_inside_see_second_degree_fields_half_way_to_the_centroid() {
    for (jitter, smoothing) in [(0.3, 1.2), (0.45, 1.2), (0.45, 1.5)] {
        let particles = block(jitter);
        let (rows, offset) = (rows(&particles, smoothing), offsets(&particles));
        assert!(offset.iter().all(|c| c.amax() < 0.1), "in the cells round the node");
        let which = |x: &Vec3| (0..3).all(|axis| depth(x, axis) > 0.1);
        for axes in SECOND_DEGREE {
            let (field, slope) = second_degree(axes);
            let error = worst(&particles, &rows, which, &field, |a| slope(&(0.5 * offset[a])));
            assert!(error < 1e-12, "jitter {jitter}, {axes:?}: {error:e}");
            let at_nodes = worst(&particles, &rows, which, field, |_| Vec3::zeros());
            assert!(at_nodes > 1e-3, "and not at the nodes: {at_nodes:e}");
        }
    }
}

#[test]
fn two_layers_see_what_they_tell_apart() {
    let particles = sheet(0.0);
    let (rows, offset) = (rows(&particles, 1.01), offsets(&particles));
    for axes in [[0, 1], [1, 2], [2, 0]] {
        let (field, slope) = second_degree(axes);
        let error = worst(&particles, &rows, |_| true, field, |a| slope(&(0.5 * offset[a])));
        // as above
        assert!(error < 1e-7, "{axes:?}: {error:e}");
    }
    // z² is 0.1 m times z on both layers
    let inward = |a: usize| Vec3::z() * if particles.position[a].z < 0.05 { 0.1 } else { -0.1 };
    let error = worst(&particles, &rows, |_| true, |d| d.z * d.z, inward);
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn a_node_of_a_plane_face_is_seen_a_sixth_of_a_spacing_inside() {
    let particles = block(0.0);
    for (x, c) in particles.position.iter().zip(offsets(&particles)) {
        for axis in 0..3 {
            let inward = if x[axis] < LOW[axis] + 1e-9 {
                1.0
            } else if x[axis] > HIGH[axis] - 1e-9 {
                -1.0
            } else {
                0.0
            };
            assert!((0.5 * c[axis] - inward * 0.1 / 6.0).abs() < 1e-15, "{x:?} {c:?}");
        }
    }
}

/// `Σ_a V_a [f(X_a + ½c_a) − ⅛ c_a·K c_a] = ∫ f dV`, over any grid of hats that fills the block.
#[test]
fn volumes_integrate_second_degree_fields_half_way_to_the_centroids() {
    for jitter in [0.0, 0.3, 0.45] {
        let particles = block(jitter);
        let offset = offsets(&particles);
        for [i, j] in SECOND_DEGREE {
            let sum = |share: f64| -> f64 {
                let term = |a: usize| {
                    let (c, x) = (offset[a], particles.position[a] + share * offset[a]);
                    particles.volume[a] * (x[i] * x[j] - share * share * c[i] * c[j])
                };
                (0..particles.len()).map(term).sum()
            };
            let exact: f64 = (0..3)
                .map(|axis| {
                    let power = usize::from(axis == i) + usize::from(axis == j);
                    let integral = |x: f64| x.powi(power as i32 + 1) / (power + 1) as f64;
                    integral(HIGH[axis]) - integral(LOW[axis])
                })
                .product();
            // 240 terms below 1e-3 m⁵
            assert!((sum(0.5) - exact).abs() < 1e-15, "{jitter} {i} {j}: {:e}", sum(0.5) - exact);
            // the trapezium rule errs by dx²/12 of f'' where i = j, and displaced cells in all
            if i == j || jitter > 0.0 {
                assert!((sum(0.0) - exact).abs() > 1e-9, "{jitter} {i} {j}: {:e}", sum(0.0) - exact);
            }
        }
    }
}

#[test]
fn in_a_plane_of_symmetry_half_a_body_is_seen_where_the_whole_is() {
    let shape = Shape::Box { min: LOW, max: Vec3::new(0.8, 0.6, 0.4) };
    let whole = lattice(&shape, [None; 3], 0.0);
    let part = lattice(&shape, [Some(0.4), Some(0.4), None], 0.0);
    let of_whole = offsets(&whole);
    for (x, c) in part.position.iter().zip(offsets(&part)) {
        let same = whole.position.iter().position(|other| (other - x).norm() < 1e-9).unwrap();
        assert!((c - of_whole[same]).norm() < 1e-15, "{x:?}: {c:?} and {:?}", of_whole[same]);
    }
}

#[test]
fn columns_sum_to_the_areas_in_every_body() {
    for (name, particles, smoothing) in bodies() {
        let stencils =
            Stencils::build(&particles, Kernel::WendlandC2, smoothing, Consistency::Centroid).unwrap();
        for (a, area) in particles.boundary_area().iter().enumerate() {
            let sum: Vec3 = stencils.row(a).backward.iter().sum();
            // what the conjugate gradients leave, in squared spacings
            assert!((sum - area).amax() <= 1e-12 * particles.spacing.powi(2), "{name}");
        }
    }
}

#[test]
fn inside_a_lattice_nothing_changes() {
    let particles = lattice(&Shape::Box { min: Vec3::zeros(), max: Vec3::repeat(0.9) }, [None; 3], 0.0);
    let (kernel, h) = (Kernel::WendlandC2, 0.101);
    let (list, forward) = rows(&particles, 1.01);
    for a in 0..particles.len() {
        let neighbours = &list.neighbour[list.range(a)];
        let before =
            correction::row(kernel, h, a, neighbours, &particles.position, &particles.volume).unwrap();
        let change = before.iter().zip(&forward[list.range(a)]).map(|(c, d)| (c - d).amax());
        let change = change.fold(0.0, f64::max);
        // neighbours reach two spacings: from the third layer on all are there, entries are below 0.01 m²
        let inside = particles.position[a].iter().all(|&c| c > 0.25 && c < 0.65);
        assert!(
            if inside { change < 1e-16 } else { change >= 0.0 },
            "{:?} {change:e}",
            particles.position[a]
        );
        let on_face = particles.position[a].iter().any(|&c| !(1e-9..0.9 - 1e-9).contains(&c));
        assert!(!on_face || change > 1e-5, "{:?} {change:e}", particles.position[a]);
    }
}
