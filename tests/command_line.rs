//! The tool as its users meet it: words, exit codes, files.

#[path = "support/tool.rs"]
mod tool;

use std::collections::BTreeMap;
use std::fs;
use tool::{contents, folder, path, text, tissue};

const STRIP: &str = "tests/scenes/strip.tissue";

#[test]
fn one_thread_and_two_write_the_same_bytes() {
    let home = folder("threads");
    let (one, two) = (home.join("one"), home.join("two"));
    for (threads, out) in [("1", &one), ("2", &two)] {
        let output = tissue(&["run", STRIP, "--out", path(out), "--threads", threads, "--quiet"]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(output.stdout.is_empty() && output.stderr.is_empty(), "quiet means quiet");
    }
    let (one, two) = (contents(&one), contents(&two));
    let names: Vec<&String> = one.keys().collect();
    let expected = [
        "energy.csv",
        "fields.pvd",
        "fields_0000.vtu",
        "fields_0001.vtu",
        "fields_0002.vtu",
        "force.svg",
        "pull.csv",
        "run.json",
    ];
    assert_eq!(names, expected);
    assert!(one == two, "the number of threads changed a byte");
}

#[test]
fn a_record_is_a_table_named_after_it_with_its_columns_and_units() {
    let out = folder("table").join("run");
    assert_eq!(tissue(&["run", STRIP, "--out", path(&out), "--quiet"]).status.code(), Some(0));
    let table = fs::read_to_string(out.join("pull.csv")).expect("the record is written");
    let (head, rows): (Vec<&str>, Vec<&str>) = table.lines().partition(|line| line.starts_with('#'));
    assert_eq!(rows[0], "t,d,F");
    assert_eq!(rows.len(), 1 + 11);
    assert!(
        head.iter().any(|line| line.contains("d [m]")) && head.iter().any(|line| line.contains("F [N]")),
        "{head:?}"
    );
    assert!(head.iter().any(|line| line.contains(STRIP)), "the input is named");
    let last: Vec<f64> = rows[11].split(',').map(|cell| cell.parse().expect("a number")).collect();
    // the ends have moved 0.2 mm each in 0.2 ms; the displacement is met to round-off
    assert_eq!(last[0], 2e-4);
    assert!((last[1] - 4e-4).abs() <= 1e-15 && last[2] > 0.0, "{last:?}");
}

#[test]
fn frames_hold_the_fields_asked_for_and_are_read_by_another_implementation() {
    let out = folder("frames").join("run");
    assert_eq!(tissue(&["run", STRIP, "--out", path(&out), "--quiet"]).status.code(), Some(0));
    let vtk = vtkio::Vtk::import(out.join("fields_0002.vtu")).expect("vtkio reads the frame");
    let vtkio::model::DataSet::UnstructuredGrid { pieces, .. } = vtk.data else {
        panic!("an unstructured grid")
    };
    let [vtkio::model::Piece::Inline(piece)] = pieces.as_slice() else { panic!("one piece") };
    let points = 13 * 7 * 3;
    assert_eq!(piece.num_points(), points);
    let mut found = BTreeMap::new();
    for attribute in &piece.data.point {
        if let vtkio::model::Attribute::DataArray(array) = attribute {
            let components = array.num_comp();
            assert_eq!(array.len(), points * components, "{}", array.name);
            found.insert(array.name.clone(), components);
        }
    }
    for field in ["displacement", "velocity", "sigma", "von_mises", "pressure", "J"] {
        assert!(found.contains_key(field), "{field} is missing among {:?}", found.keys());
    }
    assert_eq!((found["displacement"], found["sigma"], found["J"]), (3, 6, 1));
}

#[test]
fn run_json_says_what_was_run_and_what_became_of_it() {
    let out = folder("report").join("run");
    assert_eq!(tissue(&["run", STRIP, "--out", path(&out), "--quiet"]).status.code(), Some(0));
    let text = fs::read_to_string(out.join("run.json")).expect("the report is written");
    let report: serde_json::Value = serde_json::from_str(&text).expect("the report is JSON");
    for key in [
        "version",
        "hash",
        "plan",
        "choices",
        "particles",
        "steps",
        "wall_seconds",
        "updates_per_second",
        "totals",
    ] {
        assert!(report.get(key).is_some(), "{key}");
    }
    assert_eq!(report["particles"], 13 * 7 * 3);
    assert_eq!(report["expectations"].as_array().map(Vec::len), Some(2));
    assert!(report["expectations"][0]["holds"].as_bool().expect("a verdict"));
}

#[test]
fn results_are_replaced_only_on_request() {
    let out = folder("overwrite").join("run");
    let run = |more: &[&str]| tissue(&[&["run", STRIP, "--out", path(&out), "--quiet"], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0));
    let before = contents(&out);
    let refused = run(&["--set", "run.cfl=0.7"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("--overwrite"), "{}", text(&refused.stderr));
    assert!(contents(&out) == before, "a refused run changed a file");
    assert_eq!(run(&["--set", "run.cfl=0.7", "--overwrite"]).status.code(), Some(0));
    assert!(contents(&out) != before);
}

#[test]
fn an_earlier_run_outlives_one_that_cannot_begin() {
    let out = folder("outlives").join("run");
    let run = |more: &[&str]| tissue(&[&["run", STRIP, "--out", path(&out), "--quiet"], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0));
    let before = contents(&out);
    // a spacing only the lattice can refuse
    assert_eq!(run(&["--overwrite", "--set", "strip.spacing=0.7mm"]).status.code(), Some(2));
    assert!(contents(&out) == before, "the earlier run is not what it was");
    assert_eq!(run(&["--overwrite", "--set", "run.cfl=0.7"]).status.code(), Some(0));
    let beside = fs::read_dir(out.parent().expect("a parent")).expect("readable").count();
    assert_eq!(beside, 1, "the earlier run is let go once the new one stands");
}

#[test]
fn a_folder_that_holds_something_else_is_never_emptied() {
    let out = folder("foreign");
    fs::write(out.join("thesis.csv"), "years of work").expect("the folder can be written");
    let output = tissue(&["run", STRIP, "--out", path(&out), "--quiet", "--overwrite"]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(fs::read_to_string(out.join("thesis.csv")).expect("still there"), "years of work");
}

#[test]
fn what_the_user_put_beside_an_earlier_run_stays() {
    let out = folder("beside").join("run");
    let run = |more: &[&str]| tissue(&[&["run", STRIP, "--out", path(&out), "--quiet"], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0));
    fs::write(out.join("thesis.csv"), "years of work").expect("the folder can be written");
    let before = contents(&out);
    let output = run(&["--overwrite"]);
    assert_eq!(output.status.code(), Some(2), "a folder that holds more than a run is not written to");
    assert!(text(&output.stderr).contains("thesis.csv"), "{}", text(&output.stderr));
    assert!(contents(&out) == before, "a refused run changed a file");
    assert_eq!(fs::read_to_string(out.join("thesis.csv")).expect("still there"), "years of work");
}

#[test]
fn a_scene_that_cannot_be_set_up_ends_with_2() {
    let out = folder("set_up").join("run");
    let output = tissue(&["run", STRIP, "--out", path(&out), "--quiet", "--set", "strip.spacing=0.7mm"]);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("`strip`"), "{}", text(&output.stderr));
}

#[test]
fn a_run_that_goes_wrong_names_particle_place_time_and_cause_and_keeps_what_it_had() {
    let out = folder("blow_up").join("run");
    let output = tissue(&["run", STRIP, "--out", path(&out), "--quiet", "--set", "run.cfl=2.5"]);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    for part in ["particle ", "of `strip`", "X = (", "t = ", "likely cause", "Courant number 2.5", "cfl"] {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
    let files = contents(&out);
    assert!(files.contains_key("fields_0000.vtu") && files.contains_key("pull.csv"));
    assert!(!text(&files["pull.csv"]).to_lowercase().contains("nan"));
    assert!(text(&files["run.json"]).contains("\"outcome\": \"stopped\""));
}

#[test]
fn an_expectation_that_fails_ends_with_1_and_is_named() {
    let home = folder("expectation");
    let spec = fs::read_to_string(STRIP).expect("the scene is there").replace("< 1e-12", "< 1e-30");
    let file = home.join("strict.tissue");
    fs::write(&file, spec).expect("the folder can be written");
    let output = tissue(&["run", path(&file), "--out", path(&home.join("run"))]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stdout).contains("FAILS  expect max(energy.gap) < 1e-30"),
        "{}",
        text(&output.stdout)
    );
}

#[test]
fn a_wrong_file_ends_with_2_and_the_place() {
    let home = folder("wrong_file");
    let spec = fs::read_to_string(STRIP).expect("the scene is there").replace("C = 7.64 kPa", "C = 7.64 mm");
    let file = home.join("wrong.tissue");
    fs::write(&file, spec).expect("the folder can be written");
    for command in ["check", "plan", "run"] {
        let output = tissue(&[command, path(&file)]);
        assert_eq!(output.status.code(), Some(2), "{command}");
        assert!(text(&output.stderr).contains("wrong.tissue:6:"), "{}", text(&output.stderr));
    }
    assert_eq!(tissue(&["check", STRIP]).status.code(), Some(0));
    assert_eq!(tissue(&["check", "no/such/file.tissue"]).status.code(), Some(2));
}

#[test]
fn a_wrong_command_line_ends_with_2() {
    let cases: &[&[&str]] = &[
        &[],
        &["runn", STRIP],
        &["run"],
        &["run", STRIP, "--threads", "0"],
        &["run", STRIP, "--set", "run.cfl"],
        &["run", STRIP, "--set", "run.cfll=0.3"],
        &["run", STRIP, "--scene", "strap"],
        &["verify", "energise"],
        &["explain", "notaword"],
    ];
    for case in cases {
        let output = tissue(case);
        assert_eq!(output.status.code(), Some(2), "{case:?}");
        assert!(!output.stderr.is_empty(), "{case:?} says nothing");
    }
}

#[test]
fn check_as_json_carries_every_mistake_with_its_place() {
    let output = tissue(&["check", "--json", "tests/language/pressure_in_millimetres.tissue", STRIP]);
    assert_eq!(output.status.code(), Some(2));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON on standard output");
    assert_eq!(report[0]["mistakes"].as_array().map(|list| list.is_empty()), Some(false));
    assert_eq!(report[1]["mistakes"].as_array().map(Vec::len), Some(0));
    // twice C: kappa and k1 give the slack fibres no part
    let shear = report[1]["audits"][0]["shear_modulus"].as_f64().expect("a number");
    assert!((shear / 15.28e3 - 1.0).abs() < 1e-12, "{shear}");
}

#[test]
fn verify_prints_claims_with_bound_and_control_and_writes_them() {
    let json = folder("verify").join("claims.json");
    let output = tissue(&["verify", "conservation", "--json", path(&json)]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
    assert!(text(&output.stdout).contains("control"));
    let report: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&json).expect("the report is written")).expect("JSON");
    for key in ["topic", "claim", "source", "because", "measured", "bound", "control", "holds"] {
        assert!(report["claims"][0].get(key).is_some(), "{key}");
    }
}

#[test]
fn verify_names_a_claim_that_is_broken_on_purpose_and_ends_with_1() {
    let home = folder("verify_broken");
    let (json, html) = (home.join("claims.json"), home.join("report.html"));
    let sentence = "linear momentum of a free body stays what it was, by velocity Verlet";
    let arguments = ["verify", "conservation", "--json", path(&json), "--html", path(&html)];
    let broken = [&arguments[..], &["--break", sentence]].concat();
    let output = tissue(&broken);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    let told = text(&output.stdout);
    let fails: Vec<&str> = told.lines().filter(|line| line.contains("FAILS")).collect();
    assert!(fails.len() == 1 && fails[0].contains(sentence), "{told}");
    let report: serde_json::Value =
        serde_json::from_slice(&fs::read(&json).expect("written")).expect("the report is JSON");
    assert_eq!(report["holds"], false);
    for claim in report["claims"].as_array().expect("claims are a list") {
        for key in ["topic", "claim", "source", "because", "measured", "bound", "control", "holds"] {
            assert!(!claim[key].is_null(), "{key} of {claim}");
        }
        assert_eq!(claim["holds"], !claim["claim"].as_str().is_some_and(|text| text.contains(sentence)));
    }
    let page = fs::read_to_string(&html).expect("written");
    assert!(page.contains("FAILS") && page.contains("<h2>What fails</h2>") && page.contains(sentence));
    assert!(page.contains("<figure><svg"), "the history of momentum and energy is on the page");
    // A control: the same topic as it is.
    let output = tissue(&[&arguments[..], &["--overwrite"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
    assert!(!fs::read_to_string(&html).expect("written").contains("What fails"));
    // Neither file is replaced unasked, and what no claim says cannot be broken.
    assert_eq!(tissue(&arguments).status.code(), Some(2));
    assert_eq!(tissue(&["verify", "conservation", "--break", "no such words"]).status.code(), Some(2));
}

/// A refusal in the set-up of one claim is that claim's verdict: the others are measured all the same.
#[test]
fn verify_goes_on_where_the_set_up_of_a_claim_panics_and_ends_with_1() {
    let home = folder("verify_stopped");
    let (json, html) = (home.join("claims.json"), home.join("report.html"));
    let sentence = "the tangent of the artery has major symmetry";
    let arguments = ["verify", "energies", "--json", path(&json), "--html", path(&html)];
    let output = tissue(&[&arguments[..], &["--stop", sentence]].concat());
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(!text(&output.stderr).contains("panicked"), "{}", text(&output.stderr));
    let told = text(&output.stdout);
    let lines: Vec<&str> = told.lines().collect();
    let cause = "it could not be measured: stopped on purpose";
    let report: serde_json::Value =
        serde_json::from_slice(&fs::read(&json).expect("written")).expect("the report is JSON");
    let claims = report["claims"].as_array().expect("claims are a list");
    let named = claims.iter().filter(|claim| claim["claim"].as_str().is_some_and(|it| it.contains(sentence)));
    assert!(named.count() == 1 && claims.len() > 5, "{report}");
    for claim in claims {
        let stopped = claim["claim"].as_str().is_some_and(|text| text.contains(sentence));
        assert_eq!(claim["holds"], !stopped, "{claim}");
        assert_eq!(claim.get("cause").and_then(|cause| cause.as_str()), stopped.then_some(cause));
        assert_eq!(claim["measured"].is_null(), stopped);
    }
    let fails = lines.iter().position(|line| line.contains("FAILS")).expect("it is named");
    assert!(lines[fails].contains(sentence) && lines[fails + 2].contains(cause), "{told}");
    let page = fs::read_to_string(&html).expect("written");
    assert!(page.contains(cause) && page.contains("<h2>What fails</h2>"));
}

/// What only the particles show is still a mistake of the file: exit code 2, with its place.
#[test]
fn what_cannot_be_set_up_is_wrong_input_and_has_a_place() {
    let folder = folder("setup");
    let file = folder.join("setup.tissue");
    let scene = |fibre: &str, shape: &str, rest: &str| {
        format!(
            "tissue 1
import std.energies {{ goh, vol_ogden2 }}
material wall {{
  energy  = goh(C = 7 kPa, k1 = 1 MPa, k2 = 5, kappa = 0.1) + vol_ogden2(D = 1e-6 Pa^-1)
  density = 1000 kg/m^3
  fibre a = {fibre}
}}
scene s {{
  body b {{ shape = {shape}  spacing = 0.5 mm  material = wall }}
  {rest}
  run {{ until = 1 ms }}
}}
"
        )
    };
    let cases = [
        (scene("[-Y/r, X/r, 0]", "box(1 mm, 1 mm, 1 mm)", ""), "has no value", "setup.tissue:9:3"),
        (
            scene(
                "[1, 0, 0]",
                "cylinder(radius = 1 mm, height = 1 mm) - cylinder(radius = 2 mm, height = 1 mm)",
                "",
            ),
            "no particle lies in the shape",
            "setup.tissue:9:3",
        ),
        (
            scene("[1, 0, 0]", "box(1 mm, 1 mm, 1 mm)", "pull b.xmax { displacement = 1 mm  grip = rigid }"),
            "starts with a displacement",
            "setup.tissue:10:3",
        ),
        (
            scene("[1, 0, 0]", "box(1 mm, 1 mm, 1 mm)", "motion { x = [-X, Y, Z] }"),
            "turns the body inside out",
            "setup.tissue:8:7",
        ),
        (
            scene("[1, 0, 0]", "box(1 mm, 1 mm, 1 mm)", "motion { x = [X * (1 - t/0.5 ms), Y, Z] }"),
            "at t = 7.1000e-4 s",
            "setup.tissue:8:7",
        ),
    ];
    for (scene, told, place) in cases {
        std::fs::write(&file, scene).expect("a folder of our own");
        let out = folder.join("out");
        let output = tissue(&["run", path(&file), "--out", path(&out)]);
        assert!(!out.exists(), "a run that did not begin left its folder");
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(told) && said.contains(place), "{said}");
    }
}
