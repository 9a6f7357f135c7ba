//! Files that cannot be read and scenes that cannot be set up are verdicts.

use super::*;

/// A block thrown for a moment; gradients exact for quadratic fields need three layers of its particles.
fn thrown(name: &str, spacing: &str) -> String {
    format!(
        "scene {name} {{
  body block {{ shape = box(1 m, 1 m, 1 m)  spacing = {spacing}  material = gel }}
  start block {{ velocity = [1 m/s, 0 m/s, 0 m/s] }}
  record sums {{ p = momentum.x  every = 1 ms }}
  expect sums.p == 1000 kg*m/s within 1e-9 % at t = 1 ms
  run {{ until = 1 ms  completeness = quadratic }}
}}
"
    )
}

#[test]
fn a_scene_that_cannot_be_set_up_fails_line_by_line_and_the_next_is_run() {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 2 kPa)  density = 1000 kg/m^3 }}
{}{}",
        thrown("refused", "1 m"),
        thrown("runs", "0.25 m")
    );
    let mut held = Held::default();
    held.document("two.tissue", document("two.tissue", text, &[]), &[]);
    held.document("none.tissue", document("none.tissue", "scene".into(), &[]), &[]);
    let (refused, runs, unread) = match &held.verdicts[..] {
        [a, b, c] => (a, b, c),
        other => panic!("{other:#?}"),
    };
    assert!(refused.claim.starts_with("refused: ") && refused.source == "two.tissue:8", "{refused:?}");
    let cause = refused.fault().expect("it fails").to_string();
    assert!(cause.starts_with("it could not be measured: two.tissue: "), "{cause}");
    assert!(runs.holds && runs.cause.is_none(), "{runs:?}");
    assert!(unread.claim == "none.tissue can be read" && !unread.holds && unread.cause.is_some());
}

#[test]
fn a_panic_while_a_file_is_judged_is_a_verdict_too() {
    let mut held = Held::default();
    held.add("file.tissue", "run", &[], || panic!("no such face"));
    let told = held.verdicts[0].fault().map(|fault| fault.to_string());
    assert_eq!(told.as_deref(), Some("it could not be measured: no such face"));
}
