//! Tests of prisms: boxes on regular lattices, then curved bodies.

use super::*;
use crate::discretisation::{FaceNodes, Shape};

const MIN: Vec3 = Vec3::new(-0.1, 0.0, 0.2);
const MAX: Vec3 = Vec3::new(0.9, 0.6, 0.4);

fn of_box(
    min: &Vec3,
    max: &Vec3,
    spacing: f64,
    symmetry: [Option<f64>; 3],
    jitter: f64,
) -> Result<Particles, DiscretisationError> {
    Particles::lattice(&Shape::Box { min: *min, max: *max }, spacing, symmetry, jitter)
}

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

/// Every curved shape with its exact section, at a spacing and cut by these planes.
fn curved() -> Vec<(Shape, f64, [Option<f64>; 3])> {
    let centre = Vec3::new(0.3, -0.2, 0.1);
    let cylinder = |axis| Shape::Cylinder { centre, axis, radius: 1.0, height: 0.4 };
    let plates = [0.0, 0.3].map(|first| Shape::ring_of_holes(centre, 2, 1.0, 0.4, 0.2, 0.6, 4, first));
    let planes = [Some(centre.x), Some(centre.y), None];
    let [plate, turned] = plates;
    vec![
        (cylinder(0), 0.1, [None; 3]),
        (cylinder(1), 0.11, planes),
        (cylinder(2), 0.2, [Some(centre.x), None, Some(centre.z)]),
        (plate, 0.1, planes),
        (turned, 0.08, [None; 3]),
        (Shape::astm_d412_die_c(Vec3::zeros(), 2.25e-3), 1e-3, [Some(0.0); 3]),
    ]
}

#[test]
fn nodes_of_curved_faces_lie_on_them_and_no_node_is_beyond() {
    for (shape, spacing, symmetry) in curved() {
        for jitter in [0.0, 0.3] {
            let particles = Particles::lattice(&shape, spacing, symmetry, jitter).unwrap();
            let prism = shape.prism().unwrap();
            let [_, u, v] = prism.axes();
            let distance = |a: u32| {
                let x = &particles.position[a as usize];
                prism.outline.nearest(&Vec2::new(x[u], x[v])).distance
            };
            for face in &particles.faces {
                if ["side", "hole", "edge"].contains(&face.name.as_str()) {
                    let worst = face.nodes.iter().map(|&a| distance(a).abs()).fold(0.0, f64::max);
                    assert!(worst < 1e-14, "{shape:?}, jitter {jitter}, {}: {worst:e}", face.name);
                }
            }
            assert!((0..particles.len() as u32).all(|a| distance(a) < 1e-14));
        }
    }
}

#[test]
fn no_node_carries_less_than_a_regular_corner_by_much() {
    // a regular corner carries 1/8; nodes of triangles on a cap edge carry at least 1/12 before the
    // smoothing, which moves shares by less than their half
    for (shape, spacing, symmetry) in curved() {
        let particles = Particles::lattice(&shape, spacing, symmetry, 0.0).unwrap();
        let least = particles.volume.iter().fold(f64::INFINITY, |l, &v| v.min(l));
        let share = least / particles.spacing.powi(3);
        assert!(share > 1.0 / 24.0, "{shape:?}: {share}");
        assert!(particles.least_spacing > 0.4 * particles.spacing, "{shape:?}");
    }
}

#[test]
fn every_face_has_a_name_the_shape_announces() {
    for (shape, spacing, symmetry) in curved() {
        let particles = Particles::lattice(&shape, spacing, symmetry, 0.0).unwrap();
        let announced = shape.face_names();
        for name in names(&particles) {
            assert!(announced.contains(&name) || name.starts_with("symmetry_"), "{name}");
        }
        if symmetry == [None; 3] {
            assert!(announced.iter().all(|name| particles.face(name).is_some()), "{announced:?}");
        }
    }
}

#[test]
fn an_l_block_is_a_union_of_boxes_on_a_regular_lattice() {
    let block = |min: [f64; 3], max: [f64; 3]| Shape::Box { min: min.into(), max: max.into() };
    let shape =
        Shape::Union(vec![block([3.0, 0.0, 0.0], [6.0, 3.0, 3.0]), block([0.0; 3], [3.0, 10.0, 3.0])]);
    let particles = Particles::lattice(&shape, 0.5, [None; 3], 0.0).unwrap();
    assert_eq!(particles.len(), (13 * 7 + 7 * 14) * 7);
    assert!((particles.volume.iter().sum::<f64>() - 117.0).abs() < 1e-11);
    assert_eq!(names(&particles), ["inner", "xmax", "xmin", "ymax", "ymin", "zmax", "zmin"]);
    assert_eq!(shape.face_names(), ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax", "inner"]);
    let area = |name| particles.face(name).unwrap().area.iter().sum::<Vec3>();
    assert!((area("xmax") - Vec3::new(9.0, 0.0, 0.0)).norm() < 1e-12);
    assert!((area("ymax") - Vec3::new(0.0, 9.0, 0.0)).norm() < 1e-12);
    assert!((area("inner") - Vec3::new(21.0, 9.0, 0.0)).norm() < 1e-12);
}

#[test]
fn the_dumbbell_of_die_c_has_the_area_of_its_drawing() {
    // quarter: gauge, then both arcs by the integral of the root
    let (gauge, tab, inner, outer) = (3.0_f64, 12.5_f64, 25.0_f64, 14.0_f64);
    let angle = libm::acos(1.0 - (tab - gauge) / (inner + outer));
    let root = |r: f64, a: f64| 0.5 * (a * (r * r - a * a).sqrt() + r * r * libm::asin(a / r));
    let (a, b) = (inner * libm::sin(angle), outer * libm::sin(angle));
    let quarter = 16.5 * gauge + (gauge + inner) * a - root(inner, a) + (tab - outer) * b + root(outer, b);
    let shape = Shape::astm_d412_die_c(Vec3::zeros(), 2.25e-3);
    let mut errors = vec![];
    for spacing in [1e-3, 0.5e-3] {
        let particles = Particles::lattice(&shape, spacing, [Some(0.0); 3], 0.0).unwrap();
        let volume: f64 = particles.volume.iter().sum();
        errors.push((volume / (quarter * 1.125e-9) - 1.0).abs());
        // chords of 1.5 spacings on arcs of 14 mm: 2/3 of the sagitta over at most 31 mm of edge
        let sagitta = (1.5 * spacing * 1e3).powi(2) / (8.0 * 14.0);
        assert!(errors[errors.len() - 1] < 2.0 / 3.0 * sagitta * 31.0 / quarter, "{errors:?}");
    }
    assert!(errors[1] < errors[0]);
}

#[test]
fn shapes_that_are_no_prisms_and_features_too_small_are_refused() {
    let centre = Vec3::zeros();
    let cylinder = |axis, radius, height| Shape::Cylinder { centre, axis, radius, height };
    let refused = |shape: Shape| Particles::lattice(&shape, 0.1, [None; 3], 0.0).unwrap_err();
    let blind = Shape::Difference(Box::new(cylinder(2, 1.0, 1.0)), vec![cylinder(2, 0.5, 0.5)]);
    assert_eq!(refused(blind), DiscretisationError::NotAPrism);
    let crossed = Shape::Union(vec![cylinder(0, 1.0, 1.0), cylinder(1, 1.0, 1.0)]);
    assert_eq!(refused(crossed), DiscretisationError::NotAPrism);
    assert_eq!(refused(Shape::Union(vec![])), DiscretisationError::NotAPrism);
    let pinhole = Shape::Difference(Box::new(cylinder(2, 1.0, 1.0)), vec![cylinder(2, 0.05, 1.0)]);
    assert_eq!(refused(pinhole), DiscretisationError::FeatureTooSmall { radius: 0.05, spacing: 0.1 });
    let error = refused(cylinder(2, -1.0, 1.0));
    assert_eq!(error, DiscretisationError::BadDimension { name: "radius", value: -1.0 });
}

/// Four holes of 1.159 mm whose centres are 1.824 mm from the axis leave 0.665 mm beside the rim: at 1 mm two nodes of
/// the cells that fill it go to one point of a hole, and a pair has no direction. The finer spacings are the advice.
#[test]
fn holes_that_leave_too_thin_a_wall_are_refused_by_its_place_and_a_finer_spacing_does() {
    let shape = Shape::ring_of_holes(Vec3::zeros(), 2, 3.648e-3, 2.023e-3, 1.159e-3, 1.824e-3, 4, 0.0);
    let fill = |spacing: f64| Particles::lattice(&shape, spacing, [None; 3], 0.0);
    let Err(DiscretisationError::NodesMeet { position, spacing }) = fill(1e-3) else {
        panic!("two nodes lie on each other")
    };
    assert_eq!(spacing, 1e-3);
    // on the edge of a hole
    let radii = (0..4).map(|k| {
        let angle = std::f64::consts::FRAC_PI_2 * f64::from(k);
        (position - 1.824e-3 * Vec3::new(angle.cos(), angle.sin(), 0.0)).xy().norm()
    });
    let gap = radii.map(|radius| (radius - 1.159e-3).abs()).fold(f64::INFINITY, f64::min);
    assert!(gap < 1e-9, "{position:?}");
    for finer in [0.7e-3, 0.5e-3, 0.4e-3] {
        let particles = fill(finer).expect("the wall is resolved");
        let nearest = |a: usize| {
            let others = particles.position.iter().enumerate().filter(move |(b, _)| *b != a);
            others.map(|(_, x)| (x - particles.position[a]).norm()).fold(f64::INFINITY, f64::min)
        };
        let least = (0..particles.position.len()).map(nearest).fold(f64::INFINITY, f64::min);
        assert!(least > 0.05 * finer, "{finer}: {least}");
    }
}
