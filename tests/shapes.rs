//! Bodies that are no boxes, from text to particles, supports and probes.

use tissue::monitor::Observer;
use tissue::plan::Plan;
use tissue::scene::{FileSystem, Mistake, Scene, resolve};
use tissue::solver::{Simulation, SolveError};
use tissue::syntax::Source;

/// The scene of a text; `fibre` and `entries` stand in its material and its scene.
fn scene(fibre: &str, entries: &str) -> Scene {
    let law = match fibre {
        "" => "neo_hooke(mu = 10 kPa) + vol_quadratic(K = 100 kPa)",
        _ => "goh(C = 10 kPa, k1 = 10 kPa, k2 = 1, kappa = 0.1) + vol_quadratic(K = 100 kPa)",
    };
    let text = format!(
        "tissue 1\nimport std.energies {{ goh, neo_hooke, vol_quadratic }}\nmaterial gel {{\nenergy = {law}\n\
         density = 1000 kg/m^3\n{fibre}\n}}\nscene s {{\n{entries}\n}}\n"
    );
    let (document, mistakes) = resolve(&Source { name: "shapes".into(), text }, &FileSystem, &[]);
    let rendered: String = mistakes.iter().map(Mistake::render).collect();
    assert!(mistakes.is_empty(), "{rendered}");
    document.scenes.into_iter().next().expect("the text holds a scene")
}

const BLOCK: &str =
    "body b { shape = box(1 m, 1 m, 1 m)  spacing = 0.5 m  material = gel }\nrun { until = 1 ms }";

fn simulation(scene: &Scene) -> Result<Simulation, SolveError> {
    Simulation::new(scene, &Plan::new(scene))
}

#[test]
fn directions_over_place_are_of_unit_length_at_every_particle() {
    let fibre = |text: &str| simulation(&scene(&format!("fibre a = {text}"), BLOCK)).map(|_| ());
    assert_eq!(fibre("unit([1 m + Y, X, 0 m])"), Ok(()));
    let Err(SolveError::DirectionNotUnit { direction, body, length, .. }) = fibre("[1 + 0.1*X/1 m, 0, 0]")
    else {
        panic!("a direction longer than 1 is refused")
    };
    assert_eq!((direction.as_str(), body.as_str()), ("a", "b"));
    // the first particle off the plane X = 0, half a metre away
    assert!((length - 1.05).abs() < 1e-12, "{length}");
    let Err(error) = fibre("unit([0 m - Y, X, 0 m])") else { panic!("on the axis there is no direction") };
    assert!(error.to_string().contains("it has no value"), "{error}");
}

const PLATE: &str = "body b { shape = cylinder(radius = 2 m, height = 1 m)
  - ring(count = 4, radius = 1.3 m, start = 45 deg, of = cylinder(radius = 0.3 m, height = 1 m))
spacing = 0.125 m  material = gel }\n";

/// A record and the volume of the modelled plate after one step.
fn plate(entries: &str, columns: &str) -> (Vec<f64>, f64) {
    let scene = scene(
        "",
        &format!("{PLATE} {entries} run {{ until = 1 s }}\nrecord r {{ {columns}  every = 1 ms }}"),
    );
    let mut simulation = simulation(&scene).expect("the plate can be assembled");
    simulation.step_towards(1.0).expect("a step is harmless");
    let tapes = || scene.records[0].columns.iter().map(|column| &column.value);
    let observer = Observer::new(&scene, simulation.bodies(), tapes()).expect("the planes cut the plate");
    let volume: f64 = simulation.bodies()[0].particles.volume.iter().sum();
    (observer.evaluate(&simulation, tapes()), volume)
}

const QUARTER: &str = "symmetry { planes = [x, y] }";

/// Area of the plate as drawn, m².
const DRAWN: f64 = std::f64::consts::PI * (4.0 - 4.0 * 0.09);

#[test]
fn the_forces_of_a_plate_with_holes_are_the_whole_plates() {
    // A dilation is affine, so until the free boundary answers, stress is uniform: force is stress times area.
    let dilation =
        "slide b.zmin { normal = 0 m }\nstart b { velocity = [1 s^-1 * X, 1 s^-1 * Y, 1 s^-1 * Z] }";
    let columns = "fz = section_force(b, z = 0.5 m).z  fx = section_force(b, x = 0 m).x  \
                   rz = reaction(b.zmin).z  pz = at(b, [0 m, 0 m, 0.5 m], P.zz)  px = at(b, [0 m, 0 m, 0.5 m], P.xx)";
    for planes in ["", QUARTER] {
        let (values, volume) = plate(&format!("{planes} {dilation}"), columns);
        let [fz, fx, rz, pz, px] = values[..] else { panic!("{values:?}") };
        let images = if planes.is_empty() { 1.0 } else { 4.0 };
        assert!(pz > 0.0 && px > 0.0, "{values:?}");
        // chords of 1/8 m for arcs of radius 2 m and 0.3 m: 0.1 % and 3 % of areas 12.6 and 1.1 m²
        assert!((images * volume / DRAWN - 1.0).abs() < 5e-3, "{planes}: {volume}");
        assert!((fz / (pz * DRAWN) - 1.0).abs() < 0.01, "{planes}: {fz} {}", pz * DRAWN);
        // mean chord within 1/4 m of the middle: 4 m less 0.13 %; the end layers of volumes are uneven
        assert!((fx / (px * 4.0) - 1.0).abs() < 0.02, "{planes}: {fx} {}", px * 4.0);
        // the support pulls where the plate widens away from it
        assert!((rz / (-pz * DRAWN) - 1.0).abs() < 0.01, "{planes}: {rz} {}", pz * DRAWN);
    }
}

#[test]
fn a_curved_face_is_held_on_the_whole_body() {
    let held = |planes: &str, velocity: &str| {
        let entries = format!("{planes} hold b.side\nstart b {{ velocity = {velocity} }}");
        plate(&entries, "rx = reaction(b.side).x  rz = reaction(b.side).z").0
    };
    let (whole, quarter) = (held("", "[0 m/s, 0 m/s, 1 m/s]"), held(QUARTER, "[0 m/s, 0 m/s, 1 m/s]"));
    // four quarters; the lattices of the rim differ
    assert!(whole[1].abs() > 0.0 && (quarter[1] / whole[1] - 1.0).abs() < 0.02, "{whole:?} {quarter:?}");
    // what holds one side against x the mirror image gives back
    assert_eq!(quarter[0], 0.0);
    // control: thrown along x, the whole plate is held along x
    let thrown = held("", "[1 m/s, 0 m/s, 0 m/s]");
    assert!(thrown[0].abs() > 0.1 * whole[1].abs(), "{thrown:?} {whole:?}");
}
