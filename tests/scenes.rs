//! Files resolve to the materials and scenes they describe: SI numbers, formulas, every name bound.

#[path = "support/resolved.rs"]
mod resolved;

use resolved::{at, axial, resolve_with, whole};
use std::collections::BTreeMap;
use tissue::discretisation::{Consistency, Kernel, Shape};
use tissue::expression::Tape;
use tissue::scene::*;
use tissue::syntax::Source;
use tissue::tensor::Vec3;

#[test]
fn every_spec_of_this_repository_resolves() {
    let mut folders = vec![std::path::PathBuf::from("specs")];
    let mut scenes = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the folder is in the repository") {
            let path = entry.expect("the folder can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "tissue") {
                let text = std::fs::read_to_string(&path).expect("the spec can be read");
                scenes += whole(resolve_with(&path.display().to_string(), &text, &[])).scenes.len();
            }
        }
    }
    assert!(scenes >= 1);
}

#[test]
fn the_axial_strip_is_the_body_the_spec_describes() {
    let scene = axial(&[]);
    let [body] = scene.bodies.as_slice() else { panic!("one body") };
    let half = Vec3::new(5e-3, 1.5e-3, 0.25e-3);
    assert_eq!(body.shape, Shape::Box { min: -half, max: half });
    assert_eq!((body.name.as_str(), body.spacing, body.jitter), ("strip", 0.125e-3, 0.0));
    assert!(scene.symmetry.iter().all(|plane| plane.as_ref().is_some_and(|plane| plane.at == 0.0)));
    assert_eq!(scene.materials[body.material].density, 1000.0);
}

#[test]
fn the_grip_is_pulled_smoothly_and_then_held() {
    let scene = axial(&[]);
    let [pull] = scene.prescribed.as_slice() else { panic!("one support") };
    assert_eq!((pull.word.as_str(), pull.region.face.as_str()), ("pull", "xmax"));
    let [Some(x), Some(y), Some(z)] = &pull.displacement else { panic!("a rigid grip prescribes all") };
    assert_eq!((y, z), (&Tape::constant(0.0), &Tape::constant(0.0)));
    let u = |t| at(x, [0.0; 3], t);
    // 10 s³ − 15 s⁴ + 6 s⁵ is ½ at s = ½ and 53/512 at s = ¼.
    assert_eq!(u(0.0), 0.0);
    assert!((u(1.5e-3) - 1e-3 * 53.0 / 512.0).abs() < 1e-18);
    assert!((u(3e-3) - 0.5e-3).abs() < 1e-18);
    assert_eq!((u(6e-3), u(9e-3)), (1e-3, 1e-3));
    // The velocity vanishes at both ends like the square of the distance: 30 s² (1 − s)² · 1 mm/6 ms.
    let s = 1e-6 / 6e-3;
    let expected = 30.0 * s * s * (1.0 - s) * (1.0 - s) / 6.0;
    for t in [1e-6, 6e-3 - 1e-6] {
        let velocity = (u(t + 1e-8) - u(t - 1e-8)) / 2e-8;
        // Differences of values of 1 mm, each rounded to 1e-19 m, over 2e-8 s; their own error is 3e-5.
        assert!((velocity - expected).abs() < 1e-4 * expected + 1e-11, "{velocity} {expected}");
    }
}

#[test]
fn what_is_recorded_and_expected_is_bound_to_its_columns() {
    let scene = axial(&[]);
    let pull = &scene.records[0];
    // 0.03 is rounded, and rounded again when it is divided by 1000.
    assert!(pull.name == "pull" && (pull.every - 0.03e-3).abs() <= 0.03e-3 * f64::EPSILON);
    let units: Vec<_> =
        pull.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect();
    assert_eq!(units, [("d", "m"), ("F", "N")]);
    assert_eq!(pull.columns[0].text, "2*displacement(strip.xmax).x");
    let region = Region { body: 0, face: "xmax".into() };
    assert_eq!(pull.columns[1].value, Tape::leaf(Probe::Reaction { region, axis: 0 }));
    let section = Probe::SectionForce { body: 0, normal: 0, at: 0.0, axis: 0 };
    assert_eq!(scene.records[1].columns[0].value, Tape::leaf(section));

    let Judgement::Compare { left, right, tolerance, at, .. } = &scene.expectations[0].judgement else {
        panic!("a comparison")
    };
    assert_eq!(left, &Tape::leaf(Sample::Column { record: "pull".into(), column: "d".into() }));
    assert_eq!(tolerance, &Some(Tolerance::Relative(0.005)));
    assert_eq!(at, &Some(("pull".into(), "F".into(), vec![0.5, 1.0])));
    let Some(Sample::Reference { reference, column }) = right.leaves().next() else { panic!("a reference") };
    assert_eq!(column, "d");
    // The file's second row: 0.25 mm at 0.004497578873 N.
    let value = |name: &str| {
        let (_, values) = reference.columns.iter().find(|(column, _)| column == name).expect("a column");
        values[1]
    };
    assert_eq!((value("d"), value("F")), (0.25e-3, 0.004497578873));

    let Judgement::Compare { at, .. } = &scene.expectations[3].judgement else { panic!("a comparison") };
    assert_eq!(at, &Some(("checks".into(), "t".into(), vec![6e-3])));
    assert_eq!(scene.plots[0].points[0].reference.columns.len(), 2);
    assert_eq!(scene.frames[0].values.len(), 6);
}

#[test]
fn values_given_on_the_command_line_replace_those_written() {
    let scene = axial(&[
        ("strip.spacing", "0.25mm"),
        ("run.until", "8 ms"),
        ("adventitia.kappa", "0"),
        ("axial.run.cfl", "0.5"),
        ("pull.every", "1 ms"),
        ("adventitia.goh.C", "3.82 kPa"),
        ("symmetry.planes", "[x, y]"),
    ]);
    assert_eq!(scene.symmetry.each_ref().map(Option::is_some), [true, true, false]);
    assert_eq!(scene.bodies[0].spacing, 0.25e-3);
    assert_eq!((scene.run.until, scene.run.cfl), (8e-3, 0.5));
    assert_eq!(scene.materials[0].parameters[0].value, 0.0);
    assert_eq!(scene.records[0].every, 1e-3);
    let c = &scene.materials[0].parameters[1];
    assert_eq!((c.name.as_str(), c.value), ("goh.C", 3820.0));
}

#[test]
fn a_parameter_may_be_called_without_its_energy_where_one_has_the_name() {
    let text = |energies: &str| {
        format!(
            "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = {energies} + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }}
drive pull {{ material = gel  path = uniaxial(x, stretch = 1 .. 2, steps = 2)  record test {{ P = P.xx }} }}
sweep s {{ of = pull  vary gel.mu = [5 kPa, 6 kPa]  record all {{ P = final(test.P) }} }}"
        )
    };
    let set = [("gel.mu", "7 kPa")];
    let one = text("neo_hooke(mu = 1 kPa)");
    let document = whole(resolve_with("text", &one, &set));
    assert_eq!(document.materials[0].parameters[0].value, 7e3);
    let points = &document.sweeps[0].points;
    let mu = |at: usize| match &points[at].swept {
        Swept::Drive(drive) => drive.material.parameters[0].value,
        Swept::Scene(_) => panic!("a drive"),
    };
    assert_eq!([mu(0), mu(1)], [5e3, 6e3]);
    let two = text("neo_hooke(mu = 1 kPa) + neo_hooke(mu = 2 kPa)");
    let told: String = resolve_with("text", &two, &set).1.iter().map(Mistake::render).collect();
    let help = "help: write `gel.neo_hooke.mu` or `gel.neo_hooke2.mu`";
    assert!(told.contains("--> --set:1:1") && told.contains("--> text:5:"), "{told}");
    assert_eq!(told.matches(help).count(), 2, "{told}");
}

#[test]
fn a_body_may_give_the_parameters_of_its_material_other_values() {
    let text = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel {
  param mu : pressure > 0 = 10 kPa
  energy   = neo_hooke(mu = mu) + vol_quadratic(K = 1 MPa)
  density  = 1000 kg/m^3
}
scene three {
  body a { shape = box(1 m, 1 m, 1 m)  spacing = 0.5 m  material = gel(mu = 2 kPa) }
  body b { shape = box(1 m, 1 m, 1 m)  spacing = 0.5 m  material = gel }
  body c { shape = box(1 m, 1 m, 1 m)  spacing = 0.5 m  material = gel(mu = 2 kPa) }
  run { until = 1 s }
}
drive pulled {
  material = gel(mu = 3 kPa)
  path = uniaxial(x, stretch = 1 .. 1.1, steps = 1)
  record test { P = P.xx }
  expect final(test.P) > 0 kPa
}
";
    let moduli = |document: &Document| {
        let of = |material: &Material| material.parameters[0].value;
        let scene = &document.scenes[0];
        let bodies = scene.bodies.iter().map(|body| of(&scene.materials[body.material]));
        bodies.chain([of(&document.drives[0].material), of(&document.materials[0])]).collect::<Vec<_>>()
    };
    let document = whole(resolve_with("three.tissue", text, &[]));
    assert_eq!(moduli(&document), [2e3, 10e3, 2e3, 3e3, 10e3]);
    assert_eq!(document.scenes[0].materials.len(), 2);
    // the command line has the last word
    let document = whole(resolve_with("three.tissue", text, &[("gel.mu", "5 kPa")]));
    assert_eq!(moduli(&document), [5e3; 5]);
}

#[test]
fn a_wrong_value_on_the_command_line_is_a_mistake() {
    let text = std::fs::read_to_string("tests/fixtures/axial.tissue").expect("the spec is in the repository");
    let told = |path: &str, value: &str| {
        let (_, mistakes) = resolve_with("tests/fixtures/axial.tissue", &text, &[(path, value)]);
        mistakes.iter().map(Mistake::render).collect::<Vec<_>>().join("\n")
    };
    insta::assert_snapshot!(
        [
            told("strp.spacing", "0.25 mm"),
            told("strip.spacing", "0.25"),
            told("adventitia.kappa", "0.5"),
            told("run.integrator", "verlet"),
            told("strip.spacing", "0.25 mm +"),
            told("strip.spacing", "1 mm } body x { shape = 1"),
        ]
        .join("\n")
    );
}

#[test]
fn a_scheme_fills_in_what_is_not_written() {
    let run = |entries: &str| {
        let text = format!(
            "tissue 1\nimport std.energies {{ neo_hooke, vol_quadratic }}\n\
             material gel {{ energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }}\n\
             scene s {{ body b {{ shape = box(1 m, 1 m, 1 m)  spacing = 0.1 m  material = gel }}\n\
             run {{ until = 1 s  {entries} }} }}"
        );
        whole(resolve_with("text", &text, &[])).scenes.remove(0).run
    };
    let seed = run("scheme = seed");
    assert_eq!((seed.integrator, seed.cfl), (Integrator::TvdRk2, 0.3));
    assert_eq!((seed.formulation, seed.volume_dissipation), (Some(Formulation::Pfhj), VolumeDissipation::On));
    assert_eq!(
        (seed.consistency, seed.momentum_dissipation),
        (Consistency::Kernel, InterfaceStates::Constant)
    );
    assert_eq!((seed.wave_speed_every, seed.smoothing), (0, 1.01));
    let improved = run("scheme = improved");
    assert_eq!((improved.integrator, improved.cfl), (Integrator::VelocityVerlet, 0.9));
    assert_eq!((improved.formulation, improved.volume_dissipation), (None, VolumeDissipation::Off));
    assert_eq!(improved.consistency, Consistency::Integration);
    assert_eq!(
        (improved.momentum_dissipation, improved.wave_speed_every),
        (InterfaceStates::Variational, 100)
    );
    assert_eq!(improved.written, ["until", "scheme"]);
    assert_eq!(run("integrator = tvd_rk2").cfl, 0.3);
    assert_eq!(run("integrator = tvd_rk2  cfl = 0.2").cfl, 0.2);
    assert_eq!(
        (run("integrator = ssp_rk3").integrator, run("integrator = ssp_rk3").cfl),
        (Integrator::SspRk3, 0.8)
    );
    assert_eq!(run("boundary_gradients = centroid").consistency, Consistency::Centroid);
    assert_eq!(run("boundary_gradients = one_sided").consistency, Consistency::Integration);
    let consistent = run("scheme = seed  integration_consistency = on  boundary_gradients = centroid");
    assert_eq!(consistent.consistency, Consistency::Centroid);
    assert_eq!(
        (seed.angular_momentum, improved.angular_momentum),
        (AngularMomentum::Free, AngularMomentum::Free)
    );
    assert_eq!(run("kernel = cubic_spline").kernel, Kernel::CubicSpline);
    assert_eq!(run("").loading, Loading::Dynamic);
    let quasi_static = run("loading = quasi_static  damping = 100 s^-1");
    assert_eq!(quasi_static.loading, Loading::QuasiStatic { damping: Some(100.0) });
}

#[test]
fn a_field_may_depend_on_place() {
    let text = "tissue 1
import \"gel.tissue\" { gel }
scene punch {
  let H = 1 m
  body plate { shape = box(4 m, 4 m, H, centre = [0 m, 0 m, H/2])  spacing = 0.5 m  material = gel }
  symmetry { planes = [x, y] }
  slide plate.zmin { normal = 0 m }
  start plate { velocity = if(r <= 0.8 m, [0 m/s, 0 m/s, -10 m/s * Z/H], [0 m/s, 0 m/s, 0 m/s]) }
  traction plate.xmax { value = [1 kPa * t/1 s, 0 Pa, 0 Pa] }
  gravity { acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2] }
  run { until = 0.2 s }
  record centre {
    uz = displacement(at = [0 m, 0 m, H]).z  p = at(plate, [1 m, 1 m, 0 m], pressure)  s = max(sigma.xz)  every = 1 ms
  }
  expect never_grows(centre.uz)
}
";
    let gel = "tissue 1\nimport std.energies { neo_hooke, vol_quadratic }\nmaterial gel {
  param E  : pressure > 0       = 50.05 kPa
  param nu : number in [0, 0.5) = 0.499
  energy  = neo_hooke(mu = E/(2*(1 + nu))) + vol_quadratic(K = E/(3*(1 - 2*nu)))
  density = 1000 kg/m^3
}\n";
    let files = Memory { files: BTreeMap::from([("specs/gel.tissue".into(), gel.into())]) };
    let source = Source { name: "specs/punch.tissue".into(), text: text.into() };
    let document = whole(resolve(&source, &files, &[]));
    let scene = &document.scenes[0];
    let velocity = |x| scene.starts[0].velocity.each_ref().map(|tape| at(tape, x, 0.0));
    assert_eq!(velocity([0.3, 0.4, 0.25]), [0.0, 0.0, -2.5]);
    assert_eq!(velocity([0.6, 0.8, 0.25]), [0.0, 0.0, 0.0]);
    let Load::Traction { traction, .. } = &scene.loads[0] else { panic!("a traction") };
    assert_eq!(at(&traction[0], [0.0; 3], 0.5), 500.0);
    assert_eq!(scene.loads[1], {
        let Load::Gravity { place, .. } = &scene.loads[1] else { panic!("gravity") };
        Load::Gravity { place: place.clone(), acceleration: [0.0, 0.0, -9.81] }
    });
    let slide = &scene.prescribed[0];
    assert_eq!(slide.displacement, [None, None, Some(Tape::constant(0.0))]);
    assert_eq!(scene.records[0].columns[2].value, Tape::leaf(Probe::FieldMax(Field::Sigma(0, 2))));
    assert_eq!(scene.materials[0].parameters.len(), 2);
}
