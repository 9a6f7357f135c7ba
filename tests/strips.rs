//! The strips and dumbbells of the paper on lattices coarser than their files say, in seconds.
//!
//! `tissue verify --full` holds every line of the files as they are.

use tissue::output::Provenance;
use tissue::output::report::ExpectationVerdict;
use tissue::plan::Plan;
use tissue::run::{Job, execute};
use tissue::scene::{FileSystem, Mistake, resolve};
use tissue::syntax::Source;

/// The verdicts of a file's scene, with values in place of those written.
fn run(path: &str, values: &[(&str, &str)]) -> Vec<ExpectationVerdict> {
    let text = std::fs::read_to_string(path).expect("the spec is in the repository");
    let values: Vec<(String, String)> = values.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect();
    let (document, mistakes) = resolve(&Source { name: path.into(), text }, &FileSystem, &values);
    let told: String = mistakes.iter().map(Mistake::render).collect();
    assert!(mistakes.is_empty(), "{told}");
    let scene = &document.scenes[0];
    let plan = Plan::new(scene);
    let job = Job { scene, plan: &plan, provenance: Provenance::new(path, "", &scene.name), folder: None };
    let outcome = execute(&job, &mut ()).expect("the spec can be set up");
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.report.expectations
}

/// The lines that do not hold.
fn broken(verdicts: &[ExpectationVerdict]) -> Vec<String> {
    let failed = verdicts.iter().filter(|verdict| !verdict.holds);
    failed.map(|verdict| format!("{}: {:?}, {}", verdict.text, verdict.measured, verdict.note)).collect()
}

#[test]
fn every_line_of_the_dispersed_strips_holds_on_a_lattice_twice_as_coarse() {
    for name in ["axial", "circumferential"] {
        let verdicts = run(&format!("specs/artery/{name}.tissue"), &[("strip.spacing", "0.25 mm")]);
        assert!(verdicts.len() >= 10);
        assert_eq!(broken(&verdicts), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn strips_of_other_fibres_break_the_lines() {
    let values = [("strip.spacing", "0.25 mm"), ("adventitia.kappa", "0.2")];
    let verdicts = run("specs/artery/axial.tissue", &values);
    let lines = broken(&verdicts);
    for column in ["pull.d == fe.d", "middle.width == fe.width", "middle.thickness == fe.thickness"] {
        assert!(
            lines.iter().any(|line| line.contains(column)),
            "`{column}` holds of other fibres: {lines:?}"
        );
    }
}

#[test]
fn a_coarse_dumbbell_follows_the_homogeneous_curve() {
    let values = [("dumbbell.spacing", "1.125 mm")];
    let verdicts = run("specs/skin/perpendicular.tissue", &values);
    // the force through its middle as well: its layers are not those of a mean spacing
    for column in ["hom.sigma", "pull.F_mid"] {
        let line = verdicts.iter().find(|verdict| verdict.text.contains(column)).expect("it is in the file");
        assert!(line.holds, "{line:?}");
    }
}
