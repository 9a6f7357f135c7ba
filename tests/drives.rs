//! Drives from text to tables: their numbers against closed forms, their verdicts, their files.

use tissue::output::Provenance;
use tissue::output::report::RunStatus;
use tissue::run::{DriveJob, DriveOutcome, drive};
use tissue::scene::{Drive, FileSystem, Memory, Mistake, resolve};
use tissue::syntax::Source;

const GEL: &str = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }
";

fn described(text: &str, overrides: &[(String, String)]) -> Vec<Drive> {
    let source = Source { name: "drive.tissue".into(), text: format!("{GEL}{text}") };
    let (document, mistakes) = resolve(&source, &Memory::default(), overrides);
    let told: Vec<String> = mistakes.iter().map(Mistake::render).collect();
    assert!(mistakes.is_empty(), "{}", told.join("\n"));
    document.drives
}

fn driven(text: &str) -> DriveOutcome {
    let drives = described(text, &[]);
    let provenance = Provenance::new("drive.tissue", "", &drives[0].name);
    drive(&DriveJob { drive: &drives[0], provenance, folder: None }).expect("the drive is set up")
}

fn column(outcome: &DriveOutcome, name: &str) -> Vec<f64> {
    outcome.tables[0].column(name).expect("the column was recorded")
}

#[test]
fn a_table_runs_over_the_parameter_with_its_ends_as_written() {
    let outcome = driven(
        "drive d { material = gel  path = uniaxial(x, stretch = 0.9 .. 1.3, steps = 7)  record test { P = P.xx } }",
    );
    let stretch = column(&outcome, "stretch");
    assert_eq!((stretch.len(), stretch[0], stretch[7]), (8, 0.9, 1.3));
    assert_eq!(outcome.report.points, 8);
    assert_eq!(outcome.report.status, RunStatus::Held);
}

#[test]
fn incompressible_paths_follow_the_closed_forms_of_the_neo_hookean_solid() {
    // Ogden 1984: sigma = mu (lambda^2 - thickness^2), terms up to 4 and round-off of some ten operations.
    let close = |text: &str, exact: fn(f64) -> f64| {
        let outcome = driven(text);
        let (x, sigma) = (outcome.tables[0].rows.iter().map(|row| row[0]), column(&outcome, "s"));
        x.zip(sigma).map(|(x, s)| (s / 10e3 - exact(x)).abs()).fold(0.0, f64::max)
    };
    let path = |path: &str| {
        format!(
            "drive d {{ material = gel  volume = incompressible  path = {path}  record test {{ s = sigma.xx }} }}"
        )
    };
    let uniaxial = path("uniaxial(x, stretch = 0.5 .. 2, steps = 10)");
    assert!(close(&uniaxial, |l| l * l - 1.0 / l) < 1e-13);
    assert!(close(&uniaxial, |l| l * l - 1.001 / l) > 1e-4, "a control");
    let sheet = path("equibiaxial(x, y, stretch = 1 .. 2, steps = 10)");
    assert!(close(&sheet, |l| l * l - 1.0 / (l * l * l * l)) < 1e-13);
    let strip = path("planar(z, x, stretch = 1 .. 2, steps = 10)");
    assert!(close(&strip, |l| l * l - 1.0 / (l * l)) < 1e-13);
    let half = path("biaxial(x, y, stretch = 1 .. 2, ratio = 0.5, steps = 10)");
    assert!(close(&half, |l| l * l - 1.0 / (l * (0.5 + 0.5 * l)).powi(2)) < 1e-13);
    let shear = path("simple_shear(unit([1, 1, 0]), z, amount = 0 .. 1, steps = 10)");
    assert!(close(&shear, |g| g * g) < 1e-13);
}

#[test]
fn components_are_those_in_the_axes_of_the_path() {
    let along = |path: &str| {
        let text = format!(
            "drive d {{ material = gel  path = {path}  record test {{ f = F.xy  s = sigma.xy  t = sigma.yz }} }}"
        );
        let outcome = driven(&text);
        outcome.tables[0].rows.last().expect("rows")[1..].to_vec()
    };
    // An isotropic law answers alike in every plane; the frame's own rotation costs round-off.
    let common = along("simple_shear(x, y, amount = 0 .. 0.4, steps = 1)");
    let tilted = along("simple_shear(unit([1, 2, 2]), unit([2, 1, -2]), amount = 0 .. 0.4, steps = 1)");
    assert_eq!(common[0], 0.4);
    for (a, b) in common.iter().zip(&tilted) {
        assert!((a - b).abs() <= 1e-13 * 10e3, "{a} {b}");
    }
    assert!((common[1] - 4e3).abs() < 1e-9, "mu times the amount");
}

#[test]
fn a_stress_can_be_prescribed_over_a_parameter_with_a_dimension() {
    let outcome = driven(
        "drive d {
  material = gel
  path = deformation(F = [[P(p), 0, 0], [0, free, 0], [0, 0, free]], p = 0 kPa .. 10 kPa, steps = 5)
  record test { P = P.xx  l = F.xx  s = sigma.yy }
}",
    );
    assert_eq!(outcome.tables[0].columns[0].unit, "Pa");
    for (p, (found, side)) in
        column(&outcome, "p").iter().zip(column(&outcome, "P").iter().zip(column(&outcome, "s")))
    {
        // Round-off of the bulk term, 1 MPa times 1.1e-16 times some ten operations.
        assert!((p - found).abs() < 1e-9 && side.abs() < 1e-9);
    }
    assert!(column(&outcome, "l")[5] > 1.3);
}

#[test]
fn an_expectation_that_does_not_hold_is_told_with_what_was_measured() {
    let outcome = driven(
        "drive d {
  let wanted = 14.95 kPa
  material = gel
  volume = incompressible
  path = uniaxial(x, stretch = 1 .. 1.5, steps = 5)
  record test { s = sigma.xx }
  expect test.s == 15.83333333 kPa within 1e-6 % at stretch = 1.5
  expect test.s == wanted within 1 % at stretch = 1.5
}",
    );
    let holds: Vec<bool> = outcome.report.expectations.iter().map(|verdict| verdict.holds).collect();
    assert_eq!(holds, [true, false]);
    assert_eq!(outcome.report.status, RunStatus::ExpectationFailed);
}

#[test]
fn a_drive_without_equilibrium_keeps_the_points_before() {
    // The pressure of a quadratic volumetric part cannot exceed its bulk modulus of 1 MPa.
    let outcome = driven(
        "drive d {
  material = gel
  path = deformation(F = [[sigma(p), 0, 0], [0, sigma(p), 0], [0, 0, sigma(p)]], p = 0 MPa .. -1.6 MPa, steps = 2)
  record test { J = J }
}",
    );
    assert!(outcome.failure.is_some());
    assert!(matches!(outcome.report.status, RunStatus::Stopped { .. }));
    // J = 1 + p/K: 0.2 at the second point, none at the third.
    assert_eq!(column(&outcome, "J").len(), 2);
    assert!((column(&outcome, "J")[1] - 0.2).abs() < 1e-12);
}

#[test]
fn names_of_the_material_go_before_the_common_axes() {
    let drives = described(
        "import std.energies { goh }
material artery {
  energy  = goh(C = 7.64 kPa, k1 = 996.6 kPa, k2 = 524.6, kappa = 0.226) + vol_quadratic(K = 20 MPa)
  density = 1000 kg/m^3
  frame { theta = [0, 1, 0]  z = [1, 0, 0] }
  fibre a1 = tilt(theta, z, 45 deg)
}
drive d { material = artery  path = uniaxial(z, theta, stretch = 1 .. 1.1, steps = 2)  record test { P = P.xx } }
drive e { material = artery  path = uniaxial(a1, stretch = 1 .. 1.1, steps = 2)  record test { P = P.xx } }",
        &[],
    );
    assert_eq!(drives[0].axes, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let half = 0.5_f64.sqrt();
    assert!((drives[1].axes[0][0] - half).abs() < 1e-15 && (drives[1].axes[0][1] - half).abs() < 1e-15);
    let [first, second] = drives[1].axes;
    assert!((0..3).map(|i| first[i] * second[i]).sum::<f64>().abs() < 1e-15);
}

#[test]
fn values_of_a_drive_can_be_set_on_the_command_line() {
    let text = "drive d { material = gel  path = uniaxial(x, stretch = 1 .. 2, steps = 2)  record test { P = P.xx } }";
    let set = |key: &str, value: &str| described(text, &[(key.into(), value.into())]);
    let other = set("d.path", "planar(y, z, stretch = 1 .. 3, steps = 4)");
    assert_eq!((other[0].steps, other[0].range), (4, (1.0, 3.0)));
    assert_eq!(set("d.volume", "incompressible")[0].volume, tissue::scene::VolumeChange::Incompressible);
    assert_ne!(described(text, &[])[0].steps, 4);
}

#[test]
fn a_reference_table_is_compared_with_at_its_stretches() {
    let text = format!(
        "{}{}",
        GEL.replace("neo_hooke, vol_quadratic", "goh, vol_ogden2, neo_hooke, vol_quadratic"),
        "material artery {
  energy  = goh(C = 7.64 kPa, k1 = 996.6 kPa, k2 = 524.6, kappa = 0.226) + vol_ogden2(D = 1e-7 Pa^-1)
  density = 1000 kg/m^3
  frame { theta = [0, 1, 0]  z = [1, 0, 0] }
  fibre a1 = tilt(theta, z, +49.98 deg)
  fibre a2 = tilt(theta, z, -49.98 deg)
}
drive circ {
  let hom  = csv(\"verification/references/hom_artery_uni_circ_k0226_D1e-7perPa.csv\", stretch = \"stretch_x\", s = \"sigma_xx_Pa\", width = \"lam_y(F22)\")
  material = artery
  path     = uniaxial(theta, z, stretch = 1 .. 1.1, steps = 100)
  record test { s = sigma.xx  width = F.yy }
  expect test.s == hom.s within 1e-6 % at stretch = [1.02, 1.05, 1.1]
  expect test.width == hom.width within 1e-8 % at stretch = [1.02, 1.05, 1.1]
}"
    );
    let (document, mistakes) = resolve(&Source { name: "drive.tissue".into(), text }, &FileSystem, &[]);
    assert!(mistakes.is_empty(), "{}", mistakes[0].render());
    let provenance = Provenance::new("drive.tissue", "", "circ");
    let outcome = drive(&DriveJob { drive: &document.drives[0], provenance, folder: None }).expect("set up");
    assert_eq!(outcome.report.status, RunStatus::Held, "{:?}", outcome.report.expectations);
}

/// Another law beside the common one.
const FOAM: &str =
    "material foam { energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }\n";

/// Mirrored in two axes `J` is as positive as before, so a coarse step could end there.
#[test]
fn one_long_step_ends_on_the_branch_of_many_short_ones() {
    let width = |steps: u32| {
        let outcome = driven(&format!(
            "{FOAM}drive pull {{ material = foam  path = uniaxial(x, stretch = 1 .. 4, steps = {steps})  record test {{ width = F.yy }} }}"
        ));
        *column(&outcome, "width").last().expect("a point")
    };
    let (one, many) = (width(1), width(200));
    // both solved to round-off of stresses of some hundred shear moduli
    assert!(many > 0.0 && (one / many - 1.0).abs() < 1e-12, "{one} against {many}");
}

/// `σ.xy = σ.yy = 0` leaves no `P.yx`, so a prescribed one has no equilibrium however far one goes.
#[test]
fn loads_that_contradict_one_another_are_no_equilibrium_far_away() {
    let outcome = driven(&format!(
        "{FOAM}drive shear {{
  material = foam
  path = deformation(F = [[1 + w, free, 0], [P(w*1 kPa), free, 0], [0, 0, free]], w = 0 .. 0.5, steps = 5)
  record test {{ J = J }}
}}"
    ));
    let told = outcome.failure.as_ref().expect("it stops").to_string();
    assert!(told.contains("no equilibrium"), "{told}");
    assert!(column(&outcome, "J").iter().all(|j| (0.1..10.0).contains(j)));
}
