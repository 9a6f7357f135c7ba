//! The plan of every specification, and the promise that what it drops changes no number.

use std::fs;
use std::path::{Path, PathBuf};
use tissue::plan::Plan;
use tissue::scene::{FileSystem, Scene, resolve};
use tissue::solver::{BodyState, Simulation};
use tissue::syntax::Source;

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "tissue") {
            found.push(path);
        }
    }
}

/// Every scene of `specs/` and `tests/scenes/`, with the name of its file.
fn scenes() -> Vec<(String, Scene)> {
    let mut found = Vec::new();
    files(Path::new("specs"), &mut found);
    files(Path::new("tests/scenes"), &mut found);
    let mut scenes = Vec::new();
    for path in found {
        let name = path.to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("a specification is readable");
        let (document, mistakes) = resolve(&Source { name: name.clone(), text }, &FileSystem, &[]);
        let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
        assert!(mistakes.is_empty(), "{told}");
        scenes.extend(document.scenes.into_iter().map(|scene| (name.clone(), scene)));
    }
    scenes
}

#[test]
fn every_specification_plans_as_recorded() {
    let scenes = scenes();
    assert!(scenes.len() >= 2, "the scenes are found");
    for (file, scene) in scenes {
        let name = format!("{}__{}", file.trim_end_matches(".tissue").replace(['/', '\\'], "__"), scene.name);
        insta::assert_snapshot!(name, Plan::new(&scene).to_string());
    }
}

/// Positions, velocities, maps and stresses of a body, entry by entry.
fn entries(body: &BodyState) -> Vec<f64> {
    let mut list = Vec::new();
    for a in 0..body.len() {
        list.extend(body.x[a].0);
        list.extend(body.v[a].0);
        list.extend(body.f(a).iter());
        list.extend(body.stress(a).iter());
    }
    list
}

fn after_twenty_steps(scene: &Scene, plan: &Plan) -> Vec<f64> {
    let mut simulation = Simulation::new(scene, plan).expect("a specification can be set up");
    for _ in 0..20 {
        simulation.step_towards(scene.run.until).expect("a specification runs");
    }
    simulation.bodies().iter().flat_map(entries).collect()
}

/// Particles above which a scene is made coarser: what a plan may drop does not depend on their number.
const MANY: f64 = 20_000.0;

/// Four times the spacing where there are many particles, or three where four do not divide the body.
fn coarsened(scene: Scene) -> Scene {
    let coarser = by(&scene, 4.0);
    if Simulation::new(&coarser, &Plan::new(&coarser)).is_ok() { coarser } else { by(&scene, 3.0) }
}

fn by(scene: &Scene, factor: f64) -> Scene {
    let mut scene = scene.clone();
    let planes = scene.symmetry.iter().flatten().count() as i32;
    for body in &mut scene.bodies {
        let (low, high) = body.shape.bounds();
        let cells = (high - low).product() / body.spacing.powi(3) / 2.0_f64.powi(planes);
        if cells > MANY {
            body.spacing *= factor;
        }
    }
    scene
}

#[test]
fn the_pruned_run_equals_the_unpruned_one_entry_by_entry() {
    for (file, scene) in scenes() {
        let scene = coarsened(scene);
        let pruned = after_twenty_steps(&scene, &Plan::new(&scene));
        let whole = after_twenty_steps(&scene, &Plan::unpruned(&scene));
        assert!(pruned == whole, "{file}, scene {}: what the plan drops changes a number", scene.name);
        assert!(pruned.iter().any(|x| *x != 0.0));
    }
}

#[test]
fn dropping_what_is_read_would_be_noticed() {
    for (_, mut scene) in scenes().into_iter().filter(|(file, _)| file.contains("tests/scenes")) {
        let right = after_twenty_steps(&scene, &Plan::new(&scene));
        scene.prescribed.clear();
        assert!(after_twenty_steps(&scene, &Plan::new(&scene)) != right);
    }
}

/// The line of the plan that starts with a word.
fn line_of(scene: &Scene, word: &str) -> String {
    let plan = Plan::new(scene).to_string();
    plan.lines().find(|line| line.contains(word)).expect("the plan has the line").to_string()
}

#[test]
fn the_plan_says_what_the_momentum_dissipation_does_with_the_weights_it_has() {
    let (_, mut scene) =
        scenes().into_iter().find(|(file, _)| file.contains("tests/scenes")).expect("a scene");
    for (pressure, shear, says) in [
        (1.0, 1.0, "removes zero-energy modes"),
        (1.0, 0.0, "shear_wave_weight is 0"),
        (0.0, 1.0, "pressure_wave_weight is 0"),
        (0.0, 0.0, "both wave weights are 0"),
    ] {
        (scene.run.pressure_wave_weight, scene.run.shear_wave_weight) = (pressure, shear);
        scene.run.hourglass_stiffness = 0.0;
        let (line, stiffness) = (line_of(&scene, "MomentumDissipation"), line_of(&scene, "gradient sees"));
        assert!(line.contains(says), "{line}");
        let both_off = pressure + shear == 0.0;
        assert_eq!(stiffness.contains("nor does"), both_off, "{stiffness}");
    }
}
