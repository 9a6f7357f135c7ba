//! Scenes of several bodies: what they refuse, and that probes, frames and plans know which is which.

#[path = "support/layers.rs"]
mod layers;

use tissue::monitor::{Observer, totals};
use tissue::plan::{Pass, Plan};
use tissue::run::{Job, execute};
use tissue::scene::Scene;
use tissue::solver::{Simulation, SolveError};

fn scene(members: &str) -> Scene {
    layers::layers([1200, 1000], members)
}

const INNER: &str = "body inner { shape = box(4 mm, 3 mm, 2 mm)  spacing = 1 mm  material = stiff }";

fn outer(size: &str, spacing: &str) -> String {
    format!(
        "body outer {{ shape = box({size}, centre = [2 mm, 1.5 mm, 3 mm])  spacing = {spacing}  material = soft }}"
    )
}

fn refused(scene: &Scene) -> SolveError {
    Simulation::new(scene, &Plan::new(scene)).expect_err("the scene cannot be set up")
}

#[test]
fn faces_whose_nodes_do_not_meet_are_not_bonded() {
    let bond = "bond inner.zmax { to = outer.zmin }  run { until = 1 s }";
    let coarse = scene(&format!("{INNER}\n{}\n{bond}", outer("3 mm, 3 mm, 2 mm", "0.5 mm")));
    let error = refused(&coarse);
    assert!(matches!(&error, SolveError::NotBonded { unmatched: 45, .. }), "{error}");
    assert!(error.to_string().contains("`bond inner.zmax` to `outer.zmin`: 45 nodes"), "{error}");
}

#[test]
fn a_face_that_is_part_of_a_larger_one_is_bonded() {
    let bond = "bond inner.zmax { to = outer.zmin }  run { until = 1 s }";
    let patch = scene(&format!("{INNER}\n{}\n{bond}", outer("2 mm, 1 mm, 2 mm", "1 mm")));
    assert!(Simulation::new(&patch, &Plan::new(&patch)).is_ok());
}

#[test]
fn a_shared_node_is_not_moved_in_two_ways() {
    let torn = scene(&format!(
        "{INNER}\n{}\nbond inner.zmax {{ to = outer.zmin }}\nhold inner.xmin
         pull outer.xmin {{ displacement = ramp(0 mm -> 1 mm, over = 1 s)  grip = rigid }}\nrun {{ until = 1 s }}",
        outer("4 mm, 3 mm, 2 mm", "1 mm")
    ));
    let error = refused(&torn);
    assert!(matches!(&error, SolveError::BondedApart { axis: 'x', .. }), "{error}");
}

/// A support of one body carries what the other brings to the shared edge.
#[test]
fn supports_of_one_body_carry_the_forces_of_the_other() {
    let weighed = scene(&format!(
        "{INNER}\n{}\nbond inner.zmax {{ to = outer.zmin }}\nhold inner.zmin
         gravity {{ acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2] }}
         record foot {{ F = reaction(inner.zmin).z  every = 10 ms }}
         frames fields {{ values = [J]  every = 50 ms }}
         run {{ until = 0.1 s  loading = quasi_static  damping = 400 s^-1 }}",
        outer("4 mm, 3 mm, 2 mm", "1 mm")
    ));
    let plan = Plan::new(&weighed);
    assert!(plan.runs(Pass::Bond));
    let folder = std::env::temp_dir().join(format!("tissue-bodies-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    let job =
        Job { scene: &weighed, plan: &plan, provenance: Default::default(), folder: Some(folder.clone()) };
    let outcome = execute(&job, &mut ()).expect("the scene can be set up");
    assert!(outcome.failure.is_none());
    let weight = 9.81 * 24e-9 * (1200.0 + 1000.0);
    let force = outcome.tables[0].rows.last().expect("the table has rows")[1];
    assert!((force / weight - 1.0).abs() < 1e-6, "{force} {weight}");
    let frame = std::fs::read_to_string(folder.join("fields_0001.vtu")).expect("the frame is written");
    assert!(frame.contains("Name=\"body\""), "particles of several bodies are told apart");
    std::fs::remove_dir_all(&folder).expect("the folder can be removed");
}

/// A support that pulls an edge of one body pulls what is bonded to it, on shared nodes and on hanging ones.
#[test]
fn the_impulse_of_a_support_is_all_it_gives_to_bonded_bodies() {
    let spacings = [("1 mm", "pull inner.xmin"), ("1 mm", "pull outer.xmin"), ("0.5 mm", "pull inner.xmin")];
    for (spacing, pull) in spacings {
        let pulled = scene(&format!(
            "{INNER}\n{}\nbond inner.zmax {{ to = outer.zmin }}
             {pull} {{ displacement = ramp(0 mm -> 0.1 mm, over = 20 ms)  grip = rigid }}
             record given {{ a = impulse(inner).x  b = impulse(outer).x  every = 1 ms }}
             run {{ until = 20 ms }}",
            outer("4 mm, 3 mm, 2 mm", spacing)
        ));
        let mut simulation = Simulation::new(&pulled, &Plan::new(&pulled)).expect("the scene can be set up");
        let tapes = || pulled.records[0].columns.iter().map(|column| &column.value);
        let observer = Observer::new(&pulled, simulation.bodies(), tapes()).expect("the probes exist");
        let momentum = |simulation: &Simulation| totals(simulation.bodies(), &pulled.symmetry).momentum.x;
        // the velocity of the first step, which the supports start with
        let start = momentum(&simulation);
        while simulation.steps() < 100 {
            simulation.step_towards(pulled.run.until).expect("the scene runs");
        }
        let given: f64 = observer.evaluate(&simulation, tapes()).iter().sum();
        let momentum = momentum(&simulation) - start;
        assert!(momentum < 0.0, "{pull}: it has begun to move outwards");
        // two imposed velocities a step, each a sum over some 40 nodes: 8000 roundings of terms below the whole
        assert!((given / momentum - 1.0).abs() < 1e-12, "{spacing} {pull}: {given} for {momentum}");
    }
}

#[test]
fn a_node_shared_by_a_held_edge_gives_its_force_to_the_support() {
    // outer is held nowhere: its two edge rows on the held face of inner hang on that support
    let hung = scene(&format!(
        "{INNER}\n{}\nbond inner.zmax {{ to = outer.zmin }}\nhold inner.xmin
         gravity {{ acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2] }}
         record wall {{ F = reaction(inner.xmin).z  every = 10 ms }}
         run {{ until = 0.2 s  loading = quasi_static  damping = 300 s^-1 }}",
        outer("4 mm, 3 mm, 2 mm", "1 mm")
    ));
    let plan = Plan::new(&hung);
    let mut simulation = Simulation::new(&hung, &plan).expect("the scene can be set up");
    let tapes = || hung.records[0].columns.iter().map(|column| &column.value);
    let observer = Observer::new(&hung, simulation.bodies(), tapes()).expect("the probes exist");
    while !simulation.step_towards(hung.run.until).expect("the scene runs") {}
    let force = observer.evaluate(&simulation, tapes())[0];
    let weight = 9.81 * 24e-9 * (1200.0 + 1000.0);
    assert!((force / weight - 1.0).abs() < 1e-3, "{force} {weight}");
}
