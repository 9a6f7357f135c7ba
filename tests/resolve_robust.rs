//! Nothing a file can say makes resolving panic, hang or point beside the text.
//!
//! `TISSUE_INPUTS=1000000 cargo test --test resolve_robust many -- --ignored` is the long run.

#[path = "support/inputs.rs"]
mod inputs;
#[path = "support/random.rs"]
mod random;

use inputs::{Material, bytes, generated, mutated};
use random::Random;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tissue::scene::{LoadError, Loader, Memory, Mistake, resolve};
use tissue::syntax::{Code, Source};

/// What is told points into its file, can be drawn and has a form for editors.
fn told_well(found: &[Mistake]) {
    for mistake in found {
        let text = &mistake.source.text;
        let drawn = mistake.render();
        assert!(drawn.starts_with("error[E0"), "{drawn}");
        for label in &mistake.diagnostic.labels {
            assert!(text.get(label.span.clone()).is_some(), "{mistake:?}");
        }
        let json = mistake.diagnostic.to_json(&mistake.source);
        if let Some(label) = mistake.diagnostic.labels.first() {
            let before = &text[..label.span.start];
            // LF, CRLF and CR alone end a line
            let ends = before.replace("\r\n", "\n\n").replace('\r', "\n");
            let double = before.matches("\r\n").count();
            let line = ends.matches('\n').count() - double + 1;
            let column = ends.rsplit('\n').next().map_or(0, |line| line.chars().count()) + 1;
            let place = format!("--> {}:{line}:{column}\n", mistake.source.name);
            assert!(drawn.contains(&place), "{drawn} lacks {place}");
            assert!(json.to_string().contains(&format!("\"line\":{line}")), "{json}");
        }
    }
}

fn try_seed(seed: u64, material: &Material) {
    let random = &mut Random(seed);
    let (name, text) = match seed % 8 {
        0 => ("specs/bytes.tissue".to_string(), bytes(random)),
        1..=4 => mutated(random, material),
        _ => ("specs/generated.tissue".to_string(), generated(random, material)),
    };
    let clock = Instant::now();
    let found = resolve(&Source { name, text: text.clone() }, &material.files, &[]).1;
    assert!(clock.elapsed() < Duration::from_secs(60), "seed {seed} takes {:?}\n{text}", clock.elapsed());
    told_well(&found);
}

#[test]
fn no_input_makes_resolving_panic() {
    let material = Material::new();
    for seed in 0..400 {
        try_seed(seed, &material);
    }
}

#[test]
#[ignore = "a million inputs take minutes"]
fn many_inputs_make_no_resolving_panic() {
    let inputs: u64 = std::env::var("TISSUE_INPUTS").ok().and_then(|n| n.parse().ok()).unwrap_or(100_000);
    let next = AtomicU64::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                let material = Material::new();
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= inputs {
                        break;
                    }
                    try_seed(0xcafe_0000_0000 + seed, &material);
                }
            });
        }
    });
    assert!(next.load(Ordering::Relaxed) >= inputs);
}

#[test]
fn generated_files_are_mostly_about_meaning_and_some_are_right() {
    let material = Material::new();
    let (mut of_form, mut of_meaning, mut right) = (0, 0, 0);
    for seed in 0..400 {
        let (_, text) = mutated(&mut Random(seed), &material);
        let found = resolve(&Source { name: "specs/x.tissue".into(), text }, &material.files, &[]).1;
        let codes: Vec<Code> = found.iter().map(|mistake| mistake.diagnostic.code).collect();
        match codes.first() {
            None => right += 1,
            Some(code) if code.number() < "E0200" => of_form += 1,
            Some(_) => of_meaning += 1,
        }
    }
    assert!(of_form > 20 && of_meaning > 20 && right > 4, "{of_form} {of_meaning} {right}");
}

/// Every failing file with other line ends, other blanks and Greek names is told at the same characters.
#[test]
fn places_do_not_depend_on_line_ends_blanks_or_letters() {
    let mut checked = 0;
    for entry in fs::read_dir("tests/language").expect("the folder is there").flatten() {
        let path = entry.path().to_string_lossy().replace('\\', "/");
        let Some(stem) = path.strip_suffix(".tissue") else { continue };
        let text = fs::read_to_string(&path).expect("text");
        let told = |text: &str| -> String {
            let source = Source { name: path.clone(), text: text.into() };
            let found = resolve(&source, &tissue::scene::FileSystem, &[]).1;
            told_well(&found);
            let drawn = found.iter().map(Mistake::render).collect::<Vec<_>>().join("\n");
            // A long line is cut off, maybe within a name.
            drawn.lines().filter(|line| !line.ends_with("...")).map(|line| format!("{line}\n")).collect()
        };
        let plain = told(&text);
        assert_eq!(told(&text.replace('\n', "\r\n")).replace('\r', ""), plain, "{stem} with CRLF");
        let tabs = told(&text.replace("\n  ", "\n\t\t"));
        let place =
            |text: &str| text.lines().filter(|l| l.contains(" --> ")).map(String::from).collect::<Vec<_>>();
        assert_eq!(place(&tabs), place(&plain), "{stem} with tabs");
        // `gel` and `γελ` are three characters each, but three and six bytes; other files keep their names.
        // A name that was nearly `gel` is no longer near.
        if !text.contains("import \"") && !plain.contains("write `gel") {
            assert_eq!(told(&text.replace("gel", "γελ")).replace("γελ", "gel"), plain, "{stem} in Greek");
        }
        checked += 1;
    }
    assert!(checked > 100);
}

/// A loader whose files are there a few times and then are not.
struct Vanishing {
    left: Cell<u32>,
    text: &'static str,
}

impl Loader for Vanishing {
    fn load(&self, _: &str) -> Result<String, LoadError> {
        if self.left.get() == 0 {
            return Err(LoadError::Missing);
        }
        self.left.set(self.left.get() - 1);
        Ok(self.text.into())
    }
}

#[test]
fn a_file_that_vanishes_is_told_and_one_that_was_read_is_not_read_again() {
    let law = "tissue 1\nimport std.energies { neo_hooke, vol_quadratic }\nmaterial gel { energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }\n";
    let text = "tissue 1
import \"law.tissue\" { gel }
drive d { material = gel  path = uniaxial(x, stretch = 1 .. 1.1, steps = 2)  record test { P = P.xx } }
sweep s { of = d  vary gel.neo_hooke.mu = [1 kPa, 2 kPa, 3 kPa]  record table { P = final(test.P) } }
";
    let codes = |left| {
        let loader = Vanishing { left: Cell::new(left), text: law };
        let source = Source { name: "a.tissue".into(), text: text.into() };
        resolve(&source, &loader, &[]).1.iter().map(|m| m.diagnostic.code).collect::<Vec<_>>()
    };
    assert_eq!(codes(0), [Code::FileNotFound]);
    assert_eq!(codes(1), [], "read once, a sweep of three points sees the same text at each");
}

#[test]
fn files_in_a_circle_and_long_chains_are_told() {
    let mut files = BTreeMap::new();
    for index in 0..200 {
        let next = (index + 1) % 200;
        files.insert(format!("f{index}.tissue"), format!("tissue 1\nimport \"f{next}.tissue\" {{ gel }}\n"));
    }
    let text = files["f0.tissue"].clone();
    let found = resolve(&Source { name: "f0.tissue".into(), text }, &Memory { files }, &[]).1;
    assert!(found.iter().any(|mistake| mistake.diagnostic.code == Code::ImportCycle), "{found:?}");
    let files =
        BTreeMap::from([("f0.tissue".to_string(), "tissue 1\nimport \"f0.tissue\" { gel }\n".to_string())]);
    let text = files["f0.tissue"].clone();
    let found = resolve(&Source { name: "f0.tissue".into(), text }, &Memory { files }, &[]).1;
    assert_eq!(found[0].diagnostic.code, Code::ImportCycle);
}

/// A megabyte of lets, of columns, of sums, of points: told or read, in time.
#[test]
fn large_and_deep_meanings_are_refused_or_read_in_time() {
    let gel = "tissue 1\nimport std.energies { neo_hooke, vol_quadratic }\nmaterial gel { energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 1 MPa)  density = 1000 kg/m^3 }\n";
    let drive = |inner: &str| {
        format!(
            "{gel}drive d {{\nmaterial = gel\npath = uniaxial(x, stretch = 1 .. 1.1, steps = 2)\n{inner}}}\n"
        )
    };
    let chain: String = (0..3000).map(|i| format!("let a{} = a{i} + a{i}\n", i + 1)).collect();
    let bombs = [
        drive(&format!("let a0 = 1\n{chain}record t {{ x = a3000 }}\n")),
        drive(&format!("let a0 = 1\n{chain}record t {{ x = a60 }}\n")),
        drive(&format!(
            "record t {{\n{}}}\n",
            (0..20_000).map(|i| format!("c{i} = P.xx\n")).collect::<String>()
        )),
        drive("record t { x = sum(i in 1 .. 1000000, sum(j in 1 .. 1000000, i*j)) }\n"),
        drive(&format!("record t {{ x = {}1{} }}\n", "sqrt(".repeat(5000), ")".repeat(5000))),
        format!(
            "{}sweep s {{ of = d\nvary gel.neo_hooke.mu = [{}]\nrecord q {{ x = final(t.P) }} }}\n",
            drive("record t { P = P.xx }\n"),
            (0..30_000).map(|i| format!("{} kPa", i + 1)).collect::<Vec<_>>().join(", ")
        ),
        format!("{gel}{}", "material gel { }\n".repeat(40_000)),
        format!("tissue 1\n{}", "energy e { psi = nothing }\n".repeat(30_000)),
    ];
    for (index, text) in bombs.into_iter().enumerate() {
        assert!(text.len() < 1_000_000, "{index}: {}", text.len());
        let clock = Instant::now();
        let source = Source { name: "bomb.tissue".into(), text };
        let found = resolve(&source, &tissue::scene::FileSystem, &[]).1;
        let limit = if cfg!(debug_assertions) { 60 } else { 20 };
        assert!(clock.elapsed() < Duration::from_secs(limit), "{index} takes {:?}", clock.elapsed());
        told_well(&found[..found.len().min(50)]);
    }
}
