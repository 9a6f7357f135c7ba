//! Sweeps: every point is the file with its values in place, and the number of threads changes no bit.

use tissue::output::report::RunStatus;
use tissue::output::{Provenance, Table};
use tissue::run::{DriveJob, SweepJob, SweepOutcome, drive, settings, side_by_side, sweep, sweep_figures};
use tissue::scene::{Document, FileSystem, Sweep, Swept, resolve};
use tissue::syntax::Source;

const GEL: &str = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel {
  energy  = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 1 MPa)
  density = 1000 kg/m^3
}
drive tension {
  material = gel
  volume   = incompressible
  path     = uniaxial(x, stretch = 1 .. 1.5, steps = 10)
  record test { P = P.xx }
  expect final(test.P) < 15 kPa
}
";

const STRIP: &str = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel {
  energy  = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 100 kPa)
  density = 1000 kg/m^3
}
scene strip {
  body strip { shape = box(4 mm, 2 mm, 2 mm)  spacing = 0.5 mm  material = gel }
  hold strip.xmin
  pull strip.xmax { displacement = ramp(0 mm -> 0.4 mm, over = 1 ms)  grip = rigid }
  run { until = 1 ms }
  record force { F = reaction(strip.xmax).x  every = 0.1 ms }
}
";

fn document(text: &str, overrides: &[(&str, &str)]) -> Document {
    let overrides: Vec<(String, String)> =
        overrides.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    let source = Source { name: "sweep.tissue".into(), text: text.into() };
    let (document, mistakes) = resolve(&source, &FileSystem, &overrides);
    let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
    assert!(mistakes.is_empty(), "{told}");
    document
}

fn swept(sweep_of: &Sweep, threads: usize) -> SweepOutcome {
    let provenance = Provenance::new("sweep.tissue", "", &sweep_of.name);
    sweep(&SweepJob { sweep: sweep_of, provenance, folder: None, threads }).expect("set up")
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    table.column(name).expect("the column is there")
}

#[test]
fn one_thread_and_three_give_the_same_bits() {
    let drives = "sweep s {
  of = tension
  vary gel.neo_hooke.mu = [5 kPa, 10 kPa, 20 kPa]
  vary tension.volume = [compressible, incompressible]
  record table { P = final(test.P)  half = value(test.P, stretch = 1.25) }
  plot all { curve = test.P over test.stretch }
  plot ends { curve = table.P over table.mu  scale = log_log  slope = 1 }
}";
    let scenes = "sweep s {
  of = strip
  vary strip.spacing = [1 mm, 0.5 mm]
  vary run.cfl = [0.4, 0.8]
  record table { F = max(force.F)  work = particle_updates }
  plot ends { curve = table.F over table.spacing }
}";
    for text in [format!("{GEL}{drives}"), format!("{STRIP}{scenes}")] {
        let document = document(&text, &[]);
        let described = &document.sweeps[0];
        assert!(!side_by_side(described, 1) && side_by_side(described, 3));
        let (one, three) = (swept(described, 1), swept(described, 3));
        assert!(one.tables == three.tables && one.points == three.points);
        assert_eq!(one.report.points, three.report.points);
        assert_eq!(one.report.status, RunStatus::Held);
        let provenance = Provenance::new("sweep.tissue", "", "s");
        let drawn =
            |outcome: &SweepOutcome| sweep_figures(described, &outcome.tables, &outcome.points, &provenance);
        assert_eq!(drawn(&one), drawn(&three));
        for (name, svg) in drawn(&one) {
            assert!(svg.is_ok(), "{name}: {svg:?}");
        }
    }
}

#[test]
fn every_point_is_the_file_with_its_values_set() {
    let text = format!(
        "{GEL}sweep s {{ of = tension  vary gel.neo_hooke.mu = [5 kPa, 20 kPa]  record table {{ P = final(test.P) }} }}"
    );
    let all = document(&text, &[]);
    let outcome = swept(&all.sweeps[0], 2);
    for (index, value) in ["5 kPa", "20 kPa"].into_iter().enumerate() {
        let set = document(GEL, &[("gel.neo_hooke.mu", value)]);
        let Swept::Drive(point) = &all.sweeps[0].points[index].swept else { panic!("a drive") };
        assert_eq!(point.as_ref(), &set.drives[0]);
        let provenance = Provenance::new("sweep.tissue", "", "tension");
        let alone = drive(&DriveJob { drive: &set.drives[0], provenance, folder: None }).expect("set up");
        let last = column(&alone.tables[0], "P").pop().expect("a row");
        assert_eq!(column(&outcome.tables[0], "P")[index], last);
    }
}

// Of the incompressible neo-Hookean solid P = mu (l - l^-2): linear in mu, so the order is 1.
#[test]
fn values_are_read_where_they_are_asked_for_and_orders_are_those_of_the_law() {
    let text = format!(
        "{GEL}sweep s {{
  of = tension
  vary gel.neo_hooke.mu = [5 kPa, 10 kPa, 40 kPa]
  let exact = mu * (1.5 - 1/1.5^2)
  record table {{ P = value(test.P, stretch = 1.25)  top = max(test.P)  least = min(test.P)  gap = final(test.P)/exact - 1 }}
  expect order(table.P) == 1 within 1e-10
  expect least_order(table.top) == 1 within 1e-10
  expect max(table.gap) < 1e-12
  expect table.P == 6.1 kPa within 1e-10 % at mu = 10 kPa
  expect order(table.P) > 1.1
}}"
    );
    let document = document(&text, &[]);
    let outcome = swept(&document.sweeps[0], 2);
    let table = &outcome.tables[0];
    assert_eq!(table.columns[0].name, "mu");
    assert_eq!(table.columns[0].unit, "Pa");
    assert_eq!(column(table, "mu"), [5e3, 1e4, 4e4]);
    // Stretches are exact to round-off and the equilibrium to some ten of them.
    for (mu, found) in column(table, "mu").iter().zip(column(table, "P")) {
        let exact = mu * (1.25 - 1.0 / (1.25 * 1.25));
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
    }
    let holds: Vec<bool> = outcome.report.expectations.iter().map(|verdict| verdict.holds).collect();
    assert_eq!(holds, [true, true, true, true, false]);
    assert_eq!(outcome.report.status, RunStatus::ExpectationFailed);
    // The drive's own claim is broken by the stiffest gel alone, and that does not decide the sweep.
    let own: Vec<bool> = outcome.report.points.iter().map(|point| point.expectations[0].holds).collect();
    assert_eq!(own, [true, true, false]);
}

#[test]
fn words_are_numbered_and_every_combination_is_a_row_the_first_slowest() {
    let text = format!(
        "{GEL}sweep s {{ of = tension  vary tension.volume = [compressible, incompressible]  vary gel.vol_quadratic.K = [1 MPa, 2 MPa]  record table {{ P = final(test.P) }} }}"
    );
    let document = document(&text, &[]);
    let table = &swept(&document.sweeps[0], 1).tables[0];
    assert_eq!(column(table, "volume"), [1.0, 1.0, 2.0, 2.0]);
    assert_eq!(column(table, "K"), [1e6, 2e6, 1e6, 2e6]);
    assert_eq!(table.columns[0].text, "tension.volume: 1 compressible, 2 incompressible");
    // An incompressible law does not feel its volumetric part.
    let p = column(table, "P");
    assert!(p[0] != p[1] && (p[2] / p[3] - 1.0).abs() < 1e-12);
}

#[test]
fn a_point_that_stops_is_named_and_the_others_are_kept() {
    let text = format!(
        "{}sweep s {{ of = tension  vary tension.path = [uniaxial(x, stretch = 1 .. 1.5, steps = 10), deformation(F = [[1 - a, 0, 0], [0, 1, 0], [0, 0, 1]], a = 0 .. 1.5, steps = 3)]  record table {{ P = final(test.P) }}  expect max(table.P) > 0 Pa }}",
        GEL.replace("  volume   = incompressible\n", "")
    );
    let document = document(&text, &[]);
    let outcome = swept(&document.sweeps[0], 2);
    let RunStatus::Stopped { cause } = &outcome.report.status else { panic!("{:?}", outcome.report.status) };
    assert!(cause.starts_with("tension.path = deformation("), "{cause}");
    assert_eq!(outcome.tables[0].rows.len(), 2);
    assert!(outcome.points[1][0].rows.len() < 4);
}

#[test]
fn a_trade_finds_the_cheapest_setting_within_its_tolerance() {
    let text = format!(
        "{STRIP}trade t {{ of = strip  vary strip.spacing = [1 mm, 0.5 mm]  vary run.cfl = [0.4, 0.8]  error = max(force.F) - 60 mN  tolerance = 1 N }}"
    );
    let document = document(&text, &[]);
    let described = &document.sweeps[0];
    let outcome = swept(described, 2);
    let found = settings(described, &outcome.tables[0]);
    assert_eq!(found.len(), 4);
    assert!(found.iter().all(|setting| setting.error >= 0.0 && setting.cost > 0.0));
    let cheapest = found.iter().min_by(|a, b| a.cost.total_cmp(&b.cost)).expect("there are four");
    assert!(cheapest.on_front && cheapest.allowed);
    assert_eq!(cheapest.values, ["strip.spacing = 1 mm", "run.cfl = 0.8"]);
    let provenance = Provenance::new("sweep.tissue", "", "t");
    let drawn = sweep_figures(described, &outcome.tables, &outcome.points, &provenance);
    assert!(drawn.iter().any(|(name, svg)| name == "pareto" && svg.is_ok()));
    // The tolerance is a value like any other.
    let strict = self::document(&text, &[("t.tolerance", "1e-9 N")]);
    assert!(settings(&strict.sweeps[0], &outcome.tables[0]).iter().all(|setting| !setting.allowed));
}

#[test]
fn every_sweep_that_ships_holds_what_it_claims() {
    let mut held = 0;
    for folder in ["specs/sweeps", "specs/tutorial"] {
        for entry in std::fs::read_dir(folder).expect("the folder is in the repository").flatten() {
            let name = entry.path().to_string_lossy().replace('\\', "/");
            if !name.ends_with(".tissue") {
                continue;
            }
            let text = std::fs::read_to_string(&name).expect("text");
            let (document, mistakes) = resolve(&Source { name: name.clone(), text }, &FileSystem, &[]);
            assert!(mistakes.is_empty(), "{name}");
            for described in &document.sweeps {
                let outcome = swept(described, 2);
                let report = &outcome.report;
                assert_eq!(report.status, RunStatus::Held, "{name}: {:?}", report.expectations);
                assert!(!report.expectations.is_empty(), "{name}: `{}` claims nothing", described.name);
                held += 1;
            }
        }
    }
    assert!(held >= 4);
}
