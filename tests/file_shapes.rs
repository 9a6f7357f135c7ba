//! Bodies from files of triangles, hexahedra and points are the bodies they describe.

use std::collections::BTreeMap;
use tissue::discretisation::{Consistency, Kernel, Particles, Shape, Solid, Stencils};
use tissue::monitor::totals;
use tissue::output::{Frame, FrameField};
use tissue::plan::Plan;
use tissue::scene::{Memory, Scene, resolve};
use tissue::solver::{Simulation, SolveError};
use tissue::syntax::Source;
use tissue::tensor::{Mat3, Vec3};

type Triangle = [Vec3; 3];

/// Two triangles for each quadrilateral given counter-clockwise seen from outside.
fn quads(quads: &[[Vec3; 4]]) -> Vec<Triangle> {
    quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect()
}

fn block(size: Vec3) -> Vec<Triangle> {
    let p = |i: usize| {
        let bit = |k: usize| if i >> k & 1 == 1 { size[k] } else { 0.0 };
        Vec3::new(bit(0), bit(1), bit(2))
    };
    let side = |i: [usize; 4]| i.map(p);
    quads(&[[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]].map(side))
}

/// A sphere of radius 1 by bands of latitude, with twice as many faces around: 28 bands are some 3 000 triangles.
fn ball(bands: usize) -> Vec<Triangle> {
    let around = 2 * bands;
    let at = |i: usize, j: usize| {
        let (theta, phi) = (
            std::f64::consts::PI * i as f64 / bands as f64,
            std::f64::consts::TAU * (j % around) as f64 / around as f64,
        );
        Vec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
    };
    let mut all = Vec::new();
    for i in 0..bands {
        for j in 0..around {
            all.push([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    quads(&all)
}

/// A cylinder of radius 1 and height 1 with 96 sides.
fn cylinder() -> Vec<Triangle> {
    let around = 96;
    let at = |j: usize, z: f64| {
        let phi = std::f64::consts::TAU * (j % around) as f64 / around as f64;
        Vec3::new(phi.cos(), phi.sin(), z)
    };
    let mut all = Vec::new();
    for j in 0..around {
        all.extend(quads(&[[at(j, 0.0), at(j + 1, 0.0), at(j + 1, 1.0), at(j, 1.0)]]));
        all.push([Vec3::zeros(), at(j + 1, 0.0), at(j, 0.0)]);
        all.push([Vec3::z(), at(j, 1.0), at(j + 1, 1.0)]);
    }
    all
}

/// Triangles turned about z and x.
fn turned(triangles: &[Triangle], angle: f64) -> Vec<Triangle> {
    let (c, s) = (angle.cos(), angle.sin());
    let turn =
        Mat3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0) * Mat3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
    triangles.iter().map(|t| t.map(|x| turn * x)).collect()
}

fn filled(triangles: &[Triangle], spacing: f64) -> Particles {
    let shape = Shape::Solid(Solid::new(triangles).expect("the surface is closed").into());
    Particles::lattice(&shape, spacing, [None; 3], 0.0).expect("the spacing resolves the body")
}

#[test]
fn a_box_of_triangles_is_the_box() {
    let size = Vec3::new(1.0, 0.8, 0.6);
    let read = filled(&block(size), 0.2);
    let own = Particles::lattice(&Shape::Box { min: Vec3::zeros(), max: size }, 0.2, [None; 3], 0.0)
        .expect("the box can be filled");
    let key = |x: &Vec3| [0, 1, 2].map(|i| (x[i] * 1e6).round() as i64);
    let of = |p: &Particles| -> BTreeMap<[i64; 3], f64> {
        p.position.iter().map(key).zip(p.volume.iter().map(|v| (v * 1e12).round())).collect()
    };
    assert_eq!(of(&read), of(&own));
    let area = |p: &Particles| -> Vec<(String, usize, f64)> {
        let total = |f: &tissue::discretisation::FaceNodes| f.area.iter().sum::<Vec3>().norm();
        p.faces.iter().map(|f| (f.name.clone(), f.nodes.len(), (total(f) * 1e9).round())).collect()
    };
    assert_eq!(area(&read), area(&own));
}

/// By what shares a filled ball has too little volume and too little area; the sums that must vanish do.
fn ball_errors(spacing: f64) -> (f64, f64) {
    let triangles = ball(56);
    let particles = filled(&triangles, spacing);
    let area = particles.boundary_area();
    // sums of some 1000 areas of at most dx²: the divergence theorem of the grid, to round-off
    let closed: Vec3 = area.iter().sum();
    assert!(closed.norm() < 1e-12, "{closed}");
    let moment: Mat3 = area.iter().zip(&particles.position).map(|(n, x)| x * n.transpose()).sum();
    let volume: f64 = particles.volume.iter().sum();
    assert!((moment - volume * Mat3::identity()).norm() < 1e-12);
    let quads = particles.faces.iter().flat_map(|face| &face.quads);
    let surface: f64 = quads
        .map(|quad| {
            let [a, b, c, d] = quad.map(|a| particles.position[a as usize]);
            0.5 * (c - a).cross(&(d - b)).norm()
        })
        .sum();
    let full: f64 = triangles.iter().map(|[a, b, c]| a.dot(&b.cross(c)) / 6.0).sum();
    let whole: f64 = triangles.iter().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum();
    (1.0 - volume / full.abs(), 1.0 - surface / whole)
}

/// A square of edge a inscribed in a unit sphere lies a²/6 below it in the mean and has a²/12 less area: a²/2 of the
/// volume and a²/12 of the area. Cells with two or three sides on the surface are stretched along it, up to √3 times.
/// Both are of order 2; the file's own triangles are a fifth of the finer spacing less exact.
#[test]
fn volume_and_surface_of_a_ball_converge_with_order_two() {
    let (coarse, fine) = (ball_errors(0.2), ball_errors(0.1));
    println!("{coarse:?} {fine:?}");
    for (spacing, (volume, surface)) in [(0.2_f64, coarse), (0.1, fine)] {
        let square = spacing * spacing;
        assert!((0.0..square / 2.0).contains(&volume), "{volume} at {spacing}");
        assert!((0.0..3.0 * square / 12.0).contains(&surface), "{surface} at {spacing}");
    }
    let order = |coarse: f64, fine: f64| (coarse / fine).log2();
    assert!(order(coarse.0, fine.0) > 1.7 && order(coarse.1, fine.1) > 1.7, "{coarse:?} {fine:?}");
}

/// No node of the surface is left off it: it lies between the triangles' planes and the sphere, whose sagitta they are.
#[test]
fn every_node_of_the_surface_of_a_ball_lies_on_it() {
    for spacing in [0.25, 0.2, 0.15, 0.1] {
        let particles = filled(&ball(28), spacing);
        let face = particles.face("surface").expect("it has a surface");
        let below =
            face.nodes.iter().map(|&a| 1.0 - particles.position[a as usize].norm()).fold(0.0, f64::max);
        // the middle of a face of edge 0.112: its half diagonal, squared and halved
        assert!(below < 0.112_f64.powi(2) / 4.0 && face.nodes.len() > 100, "{below} at {spacing}");
    }
}

/// Nodes that are drawn to the same sharp edge keep apart, and so do those between: the time step follows the shortest
/// edge of a cell.
#[test]
fn a_block_turned_out_of_the_axes_has_its_edges_and_no_node_twice() {
    for spacing in [0.2, 0.1] {
        let particles = filled(&turned(&block(Vec3::new(1.0, 0.8, 0.6)), 0.5), spacing);
        assert!(particles.least_spacing > 0.1 * particles.spacing, "{}", particles.least_spacing);
        let volume: f64 = particles.volume.iter().sum();
        // along 7.2 m of edge, and at most half a cell across, is cut off what no node met
        assert!((volume / 0.48 - 1.0).abs() < 7.2 * spacing * spacing / 8.0 / 0.48, "{volume}");
        let low = particles.position.iter().map(|x| x.z).fold(f64::INFINITY, f64::min);
        assert!((low - 0.0).abs() < 1e-9, "the lowest corner is a node: {low}");
    }
}

#[test]
fn the_rim_of_a_cylinder_is_met_and_its_ends_are_faces() {
    let particles = filled(&cylinder(), 0.2);
    let names: Vec<&str> = particles.faces.iter().map(|face| face.name.as_str()).collect();
    assert_eq!(names, ["surface", "zmax", "zmin"]);
    let end: f64 = particles.face("zmax").expect("it has an end").area.iter().map(|n| n.z).sum();
    let volume: f64 = particles.volume.iter().sum();
    let pi = std::f64::consts::PI;
    assert!((end / pi - 1.0).abs() < 0.02 && (volume / pi - 1.0).abs() < 0.02, "{end} {volume}");
    let side = particles.face("surface").expect("it has a side");
    let radius = |a: &u32| particles.position[*a as usize].xy().norm();
    assert!(side.nodes.iter().all(|a| (radius(a) - 1.0).abs() < 2e-3), "nodes of the side lie on it");
}

#[test]
fn a_uniform_stress_is_in_equilibrium_on_a_ball_of_triangles() {
    let particles = filled(&ball(28), 0.2);
    let stencils = Stencils::build(&particles, Kernel::WendlandC2, 1.2, Consistency::Integration)
        .expect("the integration constraint can be met");
    for (a, area) in particles.boundary_area().iter().enumerate() {
        let sum: Vec3 = stencils.row(a).backward.iter().sum();
        // conjugate gradients stop at 1e-12 dx²
        assert!((sum - area).norm() < 1e-11 * 0.04, "{a}: {sum} {area}");
    }
}

/// A half, a quarter and an eighth of the ball are those parts of the whole: to the last digits where the lattice of the
/// whole has a layer in the plane, for images move alike. Areas of curved and plane faces balance.
#[test]
fn a_part_of_a_ball_is_that_part_of_the_whole() {
    let shape = Shape::Solid(Solid::new(&ball(28)).expect("the surface is closed").into());
    let whole = Particles::lattice(&shape, 0.2, [None; 3], 0.0).expect("the spacing resolves the body");
    for planes in [[true, false, false], [false, true, true], [true; 3]] {
        let symmetry = planes.map(|cut| cut.then_some(0.0));
        let part = Particles::lattice(&shape, 0.2, symmetry, 0.0).expect("the spacing resolves the body");
        let cut = |axis: usize| planes[axis].then_some(["symmetry_x", "symmetry_y", "symmetry_z"][axis]);
        let names: Vec<&str> = ["surface"].into_iter().chain((0..3).filter_map(cut)).collect();
        assert_eq!(part.faces.iter().map(|face| face.name.as_str()).collect::<Vec<_>>(), names);
        for axis in (0..3).filter(|&axis| planes[axis]) {
            let face = part.face(["symmetry_x", "symmetry_y", "symmetry_z"][axis]).expect("it is named");
            assert!(face.nodes.iter().all(|&a| part.position[a as usize][axis] == 0.0));
            // a disc of this many sides, or its part: a chord of dx cuts dx²/8 off
            let disc =
                std::f64::consts::PI / 2_f64.powi(planes.iter().filter(|cut| **cut).count() as i32 - 1);
            let area: f64 = face.area.iter().map(|n| -n[axis]).sum();
            assert!((area / disc - 1.0).abs() < 0.02, "{planes:?}: {area} {disc}");
        }
        let area = part.boundary_area();
        assert!(area.iter().sum::<Vec3>().norm() < 1e-12);
        let moment: Mat3 = area.iter().zip(&part.position).map(|(n, x)| x * n.transpose()).sum();
        let volume: f64 = part.volume.iter().sum();
        assert!((moment - volume * Mat3::identity()).norm() < 1e-12);
        let kept = |x: &&Vec3| (0..3).all(|axis| !planes[axis] || x[axis] > -1e-9);
        let of_whole: Vec<&Vec3> = whole.position.iter().filter(kept).collect();
        assert_eq!(part.len(), of_whole.len());
        let apart = |x: &Vec3| of_whole.iter().map(|y| (*y - x).norm()).fold(f64::INFINITY, f64::min);
        let worst = part.position.iter().map(apart).fold(0.0, f64::max);
        // vertices of the file are sines and cosines in double precision, projected some 100 times
        assert!(worst < 1e-10, "{planes:?}: {worst}");
    }
}

fn scene(shape: &str, files: Memory, more: &str) -> Scene {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = 1000 kg/m^3 }}
scene read {{
  body part {{ shape = {shape}  spacing = 1 mm  material = gel }}
  {more}
}}
"
    );
    let (document, mistakes) = resolve(&Source { name: "read.tissue".into(), text }, &files, &[]);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    document.scenes.into_iter().next().expect("the text has a scene")
}

/// A block of hexahedra, jittered, as a file, and the particles it was written from.
fn written(cells: bool) -> (Memory, Particles) {
    let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(4.0, 3.0, 3.0) };
    let particles = Particles::lattice(&shape, 1.0, [None; 3], 0.2).expect("the block can be filled");
    let frame = Frame {
        reference: particles.position.clone(),
        displacement: vec![Vec3::zeros(); particles.len()],
        hexahedra: match cells {
            true => particles.cells.iter().map(|cell| cell.map(|a| a as usize)).collect(),
            false => Vec::new(),
        },
        fields: vec![FrameField::scalar("V", "m^3", &particles.volume)],
        ..Frame::default()
    };
    let text = frame.to_vtu().expect("the frame is whole");
    (Memory { files: BTreeMap::from([("block.vtu".into(), text)]) }, particles)
}

#[test]
fn hexahedra_of_a_file_are_the_particles_they_were_written_from() {
    let (files, particles) = written(true);
    let more = "slide part.xmin  slide part.ymin  slide part.zmin
                traction part.xmax { value = [300 Pa, 0 Pa, 0 Pa] }
                run { until = 20 ms  loading = quasi_static  damping = 2000 s^-1  momentum_dissipation = off }"
        .replace("  slide", "\n slide");
    let scene = scene("vtu(\"block.vtu\", scale = 1 mm)", files, &more);
    let mut simulation = Simulation::new(&scene, &Plan::new(&scene)).expect("the scene can be set up");
    let read = &simulation.bodies()[0].particles;
    for (a, volume) in particles.volume.iter().enumerate() {
        assert!((read.volume[a] / volume * 1e9 - 1.0).abs() < 1e-12);
        assert!((read.position[a] * 1e3 - particles.position[a]).norm() < 1e-14);
    }
    while !simulation.step_towards(scene.run.until).expect("the scene runs") {}
    let body = &simulation.bodies()[0];
    let traction = Mat3::from_diagonal(&Vec3::new(300.0, 0.0, 0.0));
    // as for a jittered block of this program's own: exp(-20) of the first swing
    let worst = (0..body.len()).map(|a| (body.stress(a) - traction).norm()).fold(0.0, f64::max);
    assert!(worst < 2e-8 * 300.0, "{worst}");
}

/// The block as one eighth of another, twice as large in all directions: its least ends are the planes of symmetry.
#[test]
fn hexahedra_of_a_file_are_the_part_beyond_planes_of_symmetry() {
    let (files, _) = written(true);
    let more = "symmetry { planes = [x, y, z] }
                traction part.xmax { value = [300 Pa, 0 Pa, 0 Pa] }
                record whole { volume = volume  every = 1 ms }
                run { until = 20 ms  loading = quasi_static  damping = 2000 s^-1  momentum_dissipation = off }"
        .replace("  record", "\n record");
    let scene = scene("vtu(\"block.vtu\", scale = 1 mm)", files, &more);
    let mut simulation = Simulation::new(&scene, &Plan::new(&scene)).expect("the scene can be set up");
    while !simulation.step_towards(scene.run.until).expect("the scene runs") {}
    let body = &simulation.bodies()[0];
    let names: Vec<&str> = body.particles.faces.iter().map(|face| face.name.as_str()).collect();
    assert_eq!(names, ["symmetry_x", "symmetry_y", "symmetry_z", "xmax", "ymax", "zmax"]);
    let traction = Mat3::from_diagonal(&Vec3::new(300.0, 0.0, 0.0));
    let worst = (0..body.len()).map(|a| (body.stress(a) - traction).norm()).fold(0.0, f64::max);
    assert!(worst < 2e-8 * 300.0, "{worst}");
    let whole = totals(simulation.bodies(), &scene.symmetry).volume;
    let bar = body.f(0).determinant() * 8.0 * 36e-9;
    assert!((whole / bar - 1.0).abs() < 1e-8, "{whole} {bar}");
}

#[test]
fn points_with_volumes_move_but_have_no_areas() {
    let (files, _) = written(false);
    let shape = "vtu(\"block.vtu\", scale = 1 mm, volume = \"V\")";
    let thrown = "start part { velocity = [1 m/s, 30 s^-1 * X, 0 m/s] }";
    let consistent = scene(shape, files.clone(), &format!("{thrown}\n run {{ until = 1 ms }}"));
    let refused = Simulation::new(&consistent, &Plan::new(&consistent)).expect_err("there are no areas");
    assert!(matches!(&refused, SolveError::Discretisation { .. }), "{refused}");
    assert!(refused.to_string().contains("integration_consistency = off"), "{refused}");
    let run = format!("{thrown}\n run {{ until = 1 ms  integration_consistency = off }}");
    let free = scene(shape, files, &run);
    let mut simulation = Simulation::new(&free, &Plan::new(&free)).expect("the scene can be set up");
    while !simulation.step_towards(free.run.until).expect("the scene runs") {}
    let body = &simulation.bodies()[0];
    let weighed = |of: &dyn Fn(usize) -> Vec3| -> Vec3 {
        (0..body.len()).map(|a| of(a) * body.particles.volume[a]).sum()
    };
    let start = |a: usize| Vec3::new(1.0, 30.0 * body.particles.position[a].x, 0.0);
    let (before, after) = (weighed(&start), weighed(&|a| body.v[a].vector()));
    assert!((after - before).norm() < 1e-13 * before.norm(), "{before} {after}");
}

/// A file of triangles.
fn stl(triangles: &[Triangle]) -> Memory {
    let corner = |x: &Vec3| format!("vertex {:e} {:e} {:e}\n", x.x, x.y, x.z);
    let facet = |t: &Triangle| {
        let corners: String = t.iter().map(corner).collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let text: String = triangles.iter().map(facet).collect();
    Memory { files: BTreeMap::from([("part.stl".into(), format!("solid part\n{text}endsolid part\n"))]) }
}

/// Reference positions and displacements of a cylinder of triangles, `size` wide and half as high, gripped below and
/// pulled: the grip hinders its narrowing.
fn pulled(symmetry: &str, size: &str) -> Vec<(Vec3, Vec3)> {
    let more = format!(
        "{symmetry}
  hold part.zmin
  traction part.zmax {{ value = [0 kPa, 0 kPa, ramp(0 kPa -> 10 kPa, over = 5 ms)] }}
  run {{ until = 20 ms  loading = quasi_static  damping = 1500 s^-1  momentum_dissipation = off }}"
    );
    let scene = scene(&format!("stl(\"part.stl\", scale = {size})"), stl(&cylinder()), &more);
    let mut simulation = Simulation::new(&scene, &Plan::new(&scene)).expect("the scene can be set up");
    while !simulation.step_towards(scene.run.until).expect("the scene runs") {}
    let body = &simulation.bodies()[0];
    let moved = |a: usize| (body.particles.position[a], body.x[a].vector() - body.particles.position[a]);
    (0..body.len()).map(moved).collect()
}

/// Gradients beside a plane of symmetry are one-sided there and central in the whole: both are of second order, so the
/// two differ by that, and by no more than the whole from itself on a finer lattice.
#[test]
fn a_quarter_of_a_pulled_cylinder_moves_as_the_whole() {
    let quarter = "symmetry { planes = [x, y] }";
    // root mean square over the nodes, over the largest displacement
    let apart = |part: &[(Vec3, Vec3)], whole: &[(Vec3, Vec3)]| {
        let largest = whole.iter().map(|(_, u)| u.norm()).fold(0.0, f64::max);
        let square = |(x, u): &(Vec3, Vec3)| {
            let distance = |(y, _): &&(Vec3, Vec3)| (y - x).norm();
            let near = whole.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("nodes");
            assert!(distance(&near) < 1e-12, "{x} is no node of the whole");
            (u - near.1).norm_squared() / (largest * largest)
        };
        (part.iter().map(square).sum::<f64>() / part.len() as f64).sqrt()
    };
    // over the height: mean stretch of the axis
    let stretch = |of: &[(Vec3, Vec3)]| {
        let top = of.iter().map(|(x, _)| x.z).fold(0.0, f64::max);
        let end = of.iter().find(|(x, _)| x.xy().norm() < 1e-9 && x.z == top).expect("a node on the axis");
        end.1.z / top
    };
    let (coarse, fine) = (pulled("", "4 mm"), pulled("", "8 mm"));
    let (part, fine_part) = (pulled(quarter, "4 mm"), pulled(quarter, "8 mm"));
    let (far, near) = (apart(&part, &coarse), apart(&fine_part, &fine));
    assert!(near < 0.005 && near < far / 2_f64.powf(1.5), "{far} {near}");
    let own = (stretch(&fine) - stretch(&coarse)).abs();
    for (part, whole) in [(&part, &coarse), (&fine_part, &fine)] {
        assert!((stretch(part) - stretch(whole)).abs() < own, "{} {} {own}", stretch(part), stretch(whole));
    }
}
