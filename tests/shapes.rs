//! Bodies that are no boxes, from text to particles, supports and probes.

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
