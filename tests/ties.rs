//! Bonded faces whose nodes do not meet: uniform stress passes, momentum stays, supports carry.

#[path = "support/layers.rs"]
mod layers;

use tissue::monitor::totals;
use tissue::plan::Plan;
use tissue::scene::Scene;
use tissue::solver::{Simulation, SolveError};
use tissue::tensor::{Mat3, Vec3};

fn scene(members: &str) -> Scene {
    layers::layers([1800, 900], members)
}

/// Two layers of 3 by 3 mm: 4 nodes an edge below, `above` for the spacing of the other.
fn layers(above: &str, jitter: f64, material: &str) -> String {
    let height = if above == "0.75 mm" { "2.25 mm" } else { "2 mm" };
    format!(
        "  body inner {{ shape = box(3 mm, 3 mm, 2 mm)  spacing = 1 mm  jitter = {jitter}  material = stiff }}
  body outer {{ shape = box(3 mm, 3 mm, {height}, centre = [1.5 mm, 1.5 mm, 2 mm + 0.5*{height}])  spacing = {above}  jitter = {jitter}  material = {material} }}
  bond inner.zmax {{ to = outer.zmin }}
"
    )
}

fn simulation(scene: &Scene) -> Simulation {
    Simulation::new(scene, &Plan::new(scene)).expect("the scene can be set up")
}

/// Largest difference of the stress from a uniform one, over that.
fn patch(above: &str, jitter: f64) -> f64 {
    let supports =
        "slide inner.xmin\n slide outer.xmin\n slide inner.ymin\n slide outer.ymin\n slide inner.zmin";
    let run = "run { until = 80 ms  loading = quasi_static  damping = 600 s^-1  momentum_dissipation = off  smoothing = 1.2 }";
    let traction = "traction outer.zmax { value = [0 Pa, 0 Pa, ramp(0 Pa -> 300 Pa, over = 4 ms)] }";
    let scene = scene(&format!("{} {supports}\n {traction}\n {run}", layers(above, jitter, "stiff")));
    let mut simulation = simulation(&scene);
    while !simulation.step_towards(scene.run.until).expect("the scene runs") {}
    let traction = Mat3::from_diagonal(&Vec3::new(0.0, 0.0, 300.0));
    let worst = simulation
        .bodies()
        .iter()
        .flat_map(|body| (0..body.len()).map(move |a| (body.stress(a) - traction).norm() / 300.0));
    worst.fold(0.0, f64::max)
}

/// The areas of the coarser face are those the finer hangs on it, so a uniform traction passes to the tolerance of the
/// integration constraint, 1e-12 dx² of areas down to a hundredth of that, and what is left of the transient: exp(-22) of
/// some percent at half the damping's rate over 76 ms.
#[test]
fn a_uniform_stress_passes_a_tie_of_any_spacings() {
    for (above, jitter) in [("0.5 mm", 0.0), ("0.5 mm", 0.2)] {
        let error = patch(above, jitter);
        assert!(error < 1e-9, "{above} {jitter}: {error}");
    }
}

/// Momentum of both bodies and its moment, over their scales, after 200 steps.
fn drift(run: &str) -> (f64, f64) {
    let scene = scene(&format!(
        "{} start inner {{ velocity = [0.3 m/s - 90 s^-1 * Y, 90 s^-1 * X, 40 s^-1 * Z] }}
 start outer {{ velocity = [0.3 m/s - 90 s^-1 * Y, 90 s^-1 * X - 30 s^-1 * (Z - 2 mm), 80 mm/s - 20 s^-1 * (Z - 2 mm)] }}
 run {{ until = 1 s  {run} }}",
        layers("0.75 mm", 0.0, "soft")
    ));
    let mut simulation = simulation(&scene);
    let state = |simulation: &Simulation| {
        let sums = totals(simulation.bodies(), &scene.symmetry);
        let moments = simulation.bodies().iter().flat_map(|body| {
            (0..body.len()).map(move |a| {
                let mass = body.density * body.particles.volume[a];
                body.x[a].vector().cross(&(body.v[a].vector() * mass))
            })
        });
        (sums.momentum, sums.momentum_scale, moments.sum::<Vec3>())
    };
    let (momentum, scale, moment) = state(&simulation);
    for _ in 0..200 {
        simulation.step_towards(scene.run.until).expect("the scene runs");
    }
    simulation.synchronise().expect("the state is admissible");
    let (after, _, turned) = state(&simulation);
    ((after - momentum).norm() / scale, (turned - moment).norm() / moment.norm())
}

/// 600 roundings of momentum and of its moment, which upwinding between constant states does not keep.
#[test]
fn momentum_and_its_moment_stay_across_a_tie() {
    let (momentum, moment) = drift("");
    assert!(momentum < 6.6e-14 && moment < 6.6e-14, "{momentum} {moment}");
    let (momentum, moment) = drift("momentum_dissipation = constant");
    assert!(momentum < 6.6e-14 && moment > 6.6e-12, "{momentum} {moment}");
}

#[test]
fn a_support_below_carries_what_hangs_on_it() {
    let hung = scene(&format!(
        "{} hold inner.xmin
 hold outer.xmin
 gravity {{ acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2] }}
 record wall {{ low = reaction(inner.xmin).z  high = reaction(outer.xmin).z  every = 10 ms }}
 run {{ until = 0.2 s  loading = quasi_static  damping = 300 s^-1 }}",
        layers("0.75 mm", 0.0, "soft")
    ));
    let mut simulation = simulation(&hung);
    let tapes = || hung.records[0].columns.iter().map(|column| &column.value);
    let observer =
        tissue::monitor::Observer::new(&hung, simulation.bodies(), tapes()).expect("the probes exist");
    while !simulation.step_towards(hung.run.until).expect("the scene runs") {}
    let force: f64 = observer.evaluate(&simulation, tapes()).iter().sum();
    let weight = 9.81 * 9e-6 * (2e-3 * 1800.0 + 2.25e-3 * 900.0);
    assert!((force / weight - 1.0).abs() < 1e-3, "{force} {weight}");
}

#[test]
fn what_is_no_tie_is_refused() {
    let refused = |members: &str| {
        let scene = scene(members);
        Simulation::new(&scene, &Plan::new(&scene)).expect_err("the scene cannot be set up")
    };
    let quadratic = layers("0.75 mm", 0.0, "soft") + "run { until = 1 s  completeness = quadratic }";
    assert!(matches!(refused(&quadratic), SolveError::NotBonded { .. }));
    let smaller =
        layers("0.75 mm", 0.0, "soft").replace("box(3 mm, 3 mm, 2.25 mm,", "box(2.25 mm, 3 mm, 2.25 mm,");
    assert!(matches!(refused(&(smaller + "run { until = 1 s }")), SolveError::NotBonded { .. }));
    // the hanging edge is held, the nodes it hangs on are not
    let torn = layers("0.75 mm", 0.0, "soft") + "hold outer.xmin\n run { until = 1 s }";
    let error = refused(&torn);
    assert!(matches!(&error, SolveError::BondedApart { axis: 'x', .. }), "{error}");
}
