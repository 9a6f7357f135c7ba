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
