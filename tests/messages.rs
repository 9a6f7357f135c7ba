//! What the tool says when something does not work: the cause, with names, numbers and places.

#[path = "support/tool.rs"]
mod tool;

use std::fs;
use tool::{contents, folder, path, text, tissue};

/// A small cube of gel; blocks of its scene are put in.
fn cube(blocks: &str) -> String {
    format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3 }}
scene cube {{
  body b {{ shape = box(1 mm, 1 mm, 1 mm)  spacing = 0.25 mm  material = gel }}
{blocks}
}}
"
    )
}

#[test]
fn a_column_without_a_value_is_named_with_its_record_formula_time_and_place() {
    let home = folder("column_without_value");
    let file = home.join("cube.tissue");
    let record = "  record r { every = 0.1 ms  v = volume  share = kinetic_energy/(t - 0.2 ms)*1 s/1 J }";
    fs::write(&file, cube(&format!("  run {{ until = 1 ms }}\n{record}"))).expect("writable");
    let out = home.join("out");
    let output = tissue(&["run", path(&file), "--out", path(&out), "--quiet"]);
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    for part in [
        "`share = kinetic_energy/(t - 0.2 ms)*1 s/1 J`",
        "record `r`",
        "at t = 2.0000e-4 s",
        "cube.tissue:7:42",
    ] {
        assert!(said.contains(part), "`{part}` is missing in: {said}");
    }
    // what was before it is kept: rows at 0 and 0.1 ms
    let table = text(&contents(&out)["r.csv"]);
    assert_eq!(table.lines().filter(|line| !line.starts_with('#')).count(), 3, "{table}");

    let drive = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3 }
drive d {
  material = gel
  path = uniaxial([1, 0, 0], stretch = 0.5 .. 2, steps = 6)
  record r { s = P.xx   u = 1/(stretch - 1) }
}
";
    let file = home.join("point.tissue");
    fs::write(&file, drive).expect("writable");
    let out = home.join("point");
    let output = tissue(&["run", path(&file), "--out", path(&out), "--quiet"]);
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stderr);
    for part in ["`u = 1/(stretch - 1)`", "record `r`", "infinite at stretch = 1;", "point.tissue:7:25"] {
        assert!(said.contains(part), "`{part}` is missing in: {said}");
    }
    let table = text(&contents(&out)["r.csv"]);
    assert_eq!(table.lines().filter(|line| !line.starts_with('#')).count(), 3, "{table}");
}

#[test]
fn a_mistake_on_the_command_line_shows_the_argument_its_column_and_what_is_required() {
    let file = folder("set").join("cube.tissue");
    fs::write(&file, cube("  run { until = 1 ms }")).expect("writable");
    let cases = [
        ("run.cfl=foo", "--set:1:9\n", "`cfl` is a number"),
        ("run.cfl=0.5mm", "--set:1:9\n", "`cfl` is a number, but the value is a length"),
        ("gel.mu=7kpa", "--set:1:9\n", "write `kPa`"),
        ("b.spacing=0.25", "--set:1:11\n", "`spacing` is a length"),
        ("b.spacing=0.25 mm mm", "--set:1:19\n", "one value is required"),
        ("run.until=2 ms)", "--set:1:15\n", "one value is required"),
        ("run.nix=3", "--set:1:1\n", "`run.nix`"),
        ("β.ν=3", "--set:1:1\n", "`β.ν`"),
        ("run.loading=quick", "--set:1:13\n", "write one of dynamic, quasi_static"),
    ];
    for (argument, place, required) in cases {
        let output = tissue(&["plan", path(&file), "--set", argument]);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{argument}: {said}");
        let shown = format!("1 | {argument}\n");
        for part in [place, &shown, required] {
            assert!(said.contains(part), "{argument}: `{part}` is missing in: {said}");
        }
    }
    let plan = text(&tissue(&["plan", path(&file), "--set", "run.cfl=0.4"]).stdout);
    let line = plan.lines().find(|line| line.trim_start().starts_with("cfl")).expect("the plan has the line");
    assert!(line.ends_with("0.4               --set run.cfl"), "{line}");
    // what only the particles show repeats what was set, beside the line it replaces
    let set = ["--set", "strip.spacing=0.7mm"];
    let output = tissue(&[&["plan", "tests/scenes/strip.tissue", "--cost"], &set[..]].concat());
    let said = text(&output.stderr);
    assert!(said.contains("strip.tissue:13:3\n  with --set strip.spacing=0.7mm"), "{said}");
}

#[test]
fn a_value_for_one_scene_is_judged_by_that_scene_alone() {
    let home = folder("one_scene");
    let file = home.join("several.tissue");
    let body = |name: &str, material: &str| {
        format!(
            "  body {name} {{ shape = box(1 mm, 1 mm, 1 mm)  spacing = 0.5 mm  material = {material} }}\n"
        )
    };
    let energy = "energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3";
    let (short, long) = (body("b", "gel"), body("c", "stiff"));
    let spec = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ {energy} }}
material stiff {{ {energy} }}
scene short {{
{short}  run {{ until = 1 ms }}
  record r {{ every = 0.1 ms  e = total_energy }}
}}
scene long {{
{long}  pull c.xmax {{ displacement = ramp(0 mm -> 0.1 mm, over = 2 ms)  grip = rigid }}
  run {{ until = 2 ms }}
  record r {{ every = 0.1 ms  e = total_energy }}
}}
sweep w {{ of = short   vary gel.mu = [1 kPa, 2 kPa]   record t {{ e = max(r.e) }} }}
"
    );
    fs::write(&file, spec).expect("writable");
    let plan = |only: &str, set: &str| tissue(&["plan", path(&file), "--scene", only, "--set", set]);
    // shorter than a ramp of the other scene
    for only in ["short", "w"] {
        let output = plan(only, "run.until=0.5ms");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    }
    let cases = [
        ("long", "run.until=0.5ms", "after the end of the run"),
        ("short", "c.spacing=0.25mm", "nothing in `short` is called `c.spacing`"),
        ("w", "c.spacing=0.25mm", "nothing in `w` is called `c.spacing`"),
        ("short", "stiff.mu=2kPa", "`short` is not made of `stiff`"),
        ("shrt", "run.until=0.5ms", "no scene, drive, fit or sweep `shrt`"),
    ];
    for (only, set, told) in cases {
        let output = plan(only, set);
        assert_eq!(output.status.code(), Some(2), "{only} {set}");
        assert!(text(&output.stderr).contains(told), "{}", text(&output.stderr));
    }
    // a mistake of the other scene is still one of the file
    let broken =
        fs::read_to_string(&file).expect("written").replace("displacement = ramp", "displacment = ramp");
    fs::write(&file, broken).expect("writable");
    let output = plan("short", "run.until=0.5ms");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("`displacement`"), "{}", text(&output.stderr));
}

#[test]
fn a_load_beyond_the_stiffness_and_a_body_squeezed_flat_are_named_as_causes_with_numbers() {
    let home = folder("causes");
    let cases = [
        // 1e12 Pa against the shear modulus of 1 kPa
        (
            "hold b.xmin\n  traction b.xmax { value = [1e12 Pa, 0 Pa, 0 Pa] }",
            "load of 1.00e12 Pa",
            "1.00e9 times",
        ),
        ("hold b.xmin\n  pressure b.xmax { value = 1e7 Pa }", "load of 1.00e7 Pa", "1.00e4 times"),
        // density 1000 kg/m^3 over 1 mm
        (
            "hold b.xmin\n  gravity { acceleration = [1e9 m/s^2, 0 m/s^2, 0 m/s^2] }",
            "load of 1.00e9 Pa",
            "shear modulus at rest, 1.00e3 Pa",
        ),
        // the grip would have to pass through the support
        (
            "hold b.xmin\n  pull b.xmax { displacement = ramp(0 mm -> -1.5 mm, over = 10 ms)  grip = sliding }",
            "squeezed: its ends along x",
            "least principal stretch",
        ),
    ];
    for (index, (blocks, one, other)) in cases.iter().enumerate() {
        let file = home.join(format!("cube_{index}.tissue"));
        fs::write(&file, cube(&format!("  {blocks}\n  run {{ until = 10 ms }}"))).expect("writable");
        let out = home.join(format!("out_{index}"));
        let output = tissue(&["run", path(&file), "--out", path(&out), "--quiet"]);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{blocks}: {said}");
        assert!(said.contains(one) && said.contains(other), "{blocks}: {said}");
    }
}

#[test]
fn figures_are_made_of_a_file_of_ones_own() {
    let home = folder("own_figure");
    let (point, file) = (home.join("point.tissue"), home.join("mine.tissue"));
    let drive = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 10 kPa)  density = 1000 kg/m^3 }
drive pull {
  material = gel
  path = uniaxial([1, 0, 0], stretch = 1 .. 2, steps = 6)
  record r { s = P.xx }
}
";
    let figure = "tissue 1
figure mine {
  number = 3
  title = \"A law\"
  source gel { file = \"point.tissue\"  scene = pull }
  plot law { curve = gel.r.s over gel.r.stretch }
}
";
    fs::write(&point, drive).expect("writable");
    fs::write(&file, figure).expect("writable");
    let (out, runs) = (home.join("figures"), home.join("runs"));
    let make = |files: &[&str], more: &[&str]| {
        let folders = ["--out", path(&out), "--runs", path(&runs), "--quiet"];
        tissue(&[&["figures"], files, &folders[..], more].concat())
    };
    let output = make(&[path(&file)], &[]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let svg = fs::read_to_string(out.join("03_mine.svg")).expect("drawn");
    assert!(svg.starts_with("<svg") || svg.contains("<svg"), "{svg}");
    assert_eq!(make(&[path(&file)], &["--only", "3", "--redraw"]).status.code(), Some(0));
    for (files, more, told) in [
        (vec![path(&point)], vec![], "point.tissue has no figure; write `figure name"),
        (vec![path(&file)], vec!["--only", "4"], "mine.tissue has no figure 4; there are 3"),
        (vec![path(&file), path(&file)], vec![], "two figures are called 03_mine"),
        (vec![path(&file)], vec!["--from", "specs"], "cannot be used with"),
    ] {
        let output = make(&files, &more);
        assert_eq!(output.status.code(), Some(2), "{files:?} {more:?}");
        assert!(text(&output.stderr).contains(told), "{}", text(&output.stderr));
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_keeps_what_it_has_and_says_so() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    let home = folder("interrupted");
    let (file, out) = (home.join("cube.tissue"), home.join("out"));
    let blocks = "  run { until = 1000 s }\n  record r { every = 1 ms  v = volume }";
    fs::write(&file, cube(blocks)).expect("writable");
    let mut run = Command::new(env!("CARGO_BIN_EXE_tissue"))
        .args(["run", path(&file), "--out", path(&out), "--quiet"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("the tool starts");
    let rows = || fs::read_to_string(out.join("r.csv")).map_or(0, |table| table.lines().count());
    let start = Instant::now();
    while rows() < 20 && start.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(20));
    }
    let id = run.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill is there").success());
    assert_eq!(run.wait().expect("it ends").code(), Some(130));
    let mut said = String::new();
    std::io::Read::read_to_string(&mut run.stderr.take().expect("piped"), &mut said).expect("text");
    assert!(said.contains("interrupted at t = ") && said.contains(path(&out)), "{said}");
    let report: serde_json::Value =
        serde_json::from_slice(&fs::read(out.join("run.json")).expect("written")).expect("JSON");
    assert_eq!(report["status"]["outcome"], "interrupted");
    assert!(report["end_time"].as_f64().is_some_and(|time| time > 0.0 && time < 1000.0));
    assert!(rows() >= 20, "the rows are kept");
}

#[test]
fn a_path_that_is_set_twice_is_told_with_both_values() {
    let home = folder("set_twice");
    let file = home.join("cube.tissue");
    fs::write(&file, cube("  run { until = 1 ms }\n  record r { every = 0.1 ms  v = volume }"))
        .expect("writable");
    for command in ["run", "plan"] {
        let output = tissue(&[command, path(&file), "--set", "run.cfl=0.5", "--set", "run.cfl = 0.6"]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(
            text(&output.stderr),
            "error: --set run.cfl is given twice, 0.5 and 0.6; write one of them\n"
        );
    }
}
