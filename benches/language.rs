//! From text to numbers: checking a file, driving a point, compiling a law.
//!
//! `cargo bench --bench language`. Budgets: `tissue check` on a 2 kB file under 20 ms, a drive of 1000 steps
//! under 50 ms, the largest law from its formula to its programs under 20 ms.

use divan::{Bencher, black_box};
use std::fmt::Write;
use tissue::energy::Law;
use tissue::output::Provenance;
use tissue::run::{DriveJob, drive};
use tissue::scene::{Document, Memory, library, resolve};
use tissue::syntax::Source;
use tissue::verify::MaterialAudit;

fn main() {
    divan::main();
}

fn document(name: &str, text: &str) -> Document {
    let source = Source { name: name.into(), text: text.into() };
    let (document, mistakes) = resolve(&source, &Memory::default(), &[]);
    assert!(mistakes.is_empty(), "{}", mistakes.iter().map(|m| m.render()).collect::<String>());
    document
}

fn material(name: &str) -> &'static str {
    library().iter().find(|file| file.library == "materials" && file.name == name).expect("a material").text
}

/// Some 4 kB: a scene of the artery's axial strip, its material imported.
const AXIAL: &str = include_str!("../specs/artery/axial.tissue");

/// A law that sums over so many fibre families.
fn many_families(count: usize) -> String {
    let mut text = String::from(
        "tissue 1
import std.energies { goh, vol_ogden2 }
material many {
  energy  = goh(C = 7.64 kPa, k1 = 996.6 kPa, k2 = 524.6, kappa = 0.226) + vol_ogden2(D = 1e-7 Pa^-1)
  density = 1000 kg/m^3
",
    );
    for k in 0..count {
        writeln!(text, "  fibre a{k} = tilt([1, 0, 0], [0, 1, 0], {} deg)", 180.0 * k as f64 / count as f64)
            .expect("text grows");
    }
    text.push_str("}\n");
    text
}

fn audit(document: &Document) {
    for material in &document.materials {
        black_box(MaterialAudit::of(material).expect("the law can be differentiated"));
    }
}

/// `tissue check` without the start of the process.
#[divan::bench]
fn check_axial_strip(bencher: Bencher) {
    bencher.bench(|| {
        let source = Source { name: "specs/artery/axial.tissue".into(), text: black_box(AXIAL).into() };
        let (document, mistakes) = resolve(&source, &tissue::scene::FileSystem, &[]);
        assert!(mistakes.is_empty(), "the spec is without mistakes");
        audit(&document);
    });
}

#[divan::bench(args = ["iliac_adventitia", "myocardium_holzapfel_ogden", "treloar_ogden", "dispersed_fibres_artery"])]
fn check_material(bencher: Bencher, name: &str) {
    bencher.bench(|| audit(&document(name, black_box(material(name)))));
}

#[divan::bench(args = ["iliac_adventitia", "myocardium_holzapfel_ogden", "treloar_ogden", "dispersed_fibres_artery"])]
fn drive_of_1000_steps(bencher: Bencher, name: &str) {
    let text = material(name).replace("steps = 10)", "steps = 1000)");
    let document = document(name, &text);
    assert!(document.drives[0].steps == 1000);
    bencher.bench(|| {
        let provenance = Provenance::new(name, "", "bench");
        let job = DriveJob { drive: &document.drives[0], provenance, folder: None };
        black_box(drive(&job).expect("the drive is set up"));
    });
}

fn compile(bencher: Bencher, text: &str) {
    let document = document("law", text);
    let material = &document.materials[0];
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    bencher.bench(|| black_box(Law::compile(black_box(&material.energy), &values).expect("a law")));
}

#[divan::bench(args = ["iliac_adventitia", "artery_fung", "dispersed_fibres_artery"])]
fn compile_law(bencher: Bencher, name: &str) {
    compile(bencher, material(name));
}

#[divan::bench(args = [2, 10, 100])]
fn compile_families(bencher: Bencher, count: usize) {
    compile(bencher, &many_families(count));
}
