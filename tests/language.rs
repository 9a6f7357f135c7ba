//! Every mistake of `tests/language` is told as its snapshot shows.
//!
//! A file there is one mistake (or several, where its name says so); a new file needs a new snapshot
//! and nothing else.

use proptest::prelude::*;
use std::path::{Path, PathBuf};
use tissue::scene::{FileSystem, Mistake, resolve};
use tissue::syntax::Source;

fn files() -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir("tests/language")
        .expect("the folder is in the repository")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "tissue"))
        .collect();
    files.sort();
    files
}

fn mistakes(path: &Path) -> Vec<Mistake> {
    let text = std::fs::read_to_string(path).expect("the file is in the repository");
    resolve(&Source { name: path.display().to_string(), text }, &FileSystem, &[]).1
}

#[test]
fn every_mistake_is_told_as_recorded() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/language");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for path in files() {
            let name = path.file_stem().expect("a file has a stem").to_string_lossy().into_owned();
            let rendered: Vec<String> = mistakes(&path).iter().map(Mistake::render).collect();
            insta::assert_snapshot!(name, rendered.join("\n"));
        }
    });
}

#[test]
fn every_file_of_mistakes_has_one() {
    for path in files() {
        assert!(!mistakes(&path).is_empty(), "{}", path.display());
    }
}

#[test]
fn every_mistake_says_what_to_write() {
    for path in files() {
        for told in mistakes(&path).iter().map(Mistake::render) {
            let help = told.lines().rfind(|line| !line.is_empty());
            assert!(help.is_some_and(|line| line.starts_with("help: ") && line.len() > 12), "{told}");
        }
    }
}

#[test]
fn several_mistakes_are_told_in_one_run() {
    let found = mistakes(Path::new("tests/language/several_at_once.tissue"));
    assert!(found.len() >= 8, "{} mistakes", found.len());
}

/// Words and signs a file is mutated with.
const PIECES: &[&str] = &[
    "",
    "0",
    "-1",
    "1e308",
    "1 mm",
    "7 kPa",
    "J",
    "I4bar(a)",
    "lam1",
    "pos",
    "a1",
    "theta",
    "strip",
    "strip.xmin",
    "t",
    "X",
    "fe.F",
    "pull.d",
    "max",
    "at",
    "within",
    "over",
    "[",
    "]",
    "{",
    "}",
    "(",
    ")",
    "+",
    "^",
    "/",
    "->",
    "..",
    "==",
    "<",
    ",",
    "=",
    ".",
    "let",
    "param",
    "fibre",
    "fibres",
    "hold",
    "pull",
    "scene",
    "material",
    "energy",
    "psi",
    "run",
    "sum(i in 1 .. 3, i)",
    "sum(a in fibres, 1)",
    "if(1 < 2, 3, 4)",
    "unit([0, 0, 0])",
    "ramp(0 m -> 1 m, over = 1 s)",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(if cfg!(debug_assertions) { 400 } else { 4000 }))]

    // Every word of two specs is a place for a mistake: whatever is put there is told, not died of.
    #[test]
    fn no_mutation_of_a_spec_is_died_of(changes in prop::collection::vec((0usize..400, 0usize..PIECES.len()), 1..4)) {
        let scene = std::fs::read_to_string("tests/fixtures/axial.tissue").expect("the spec is in the repository");
        let energy = std::fs::read_to_string("specs/energies/goh.tissue").expect("the spec is in the repository");
        let (_, energy) = energy.split_once("energy goh").expect("the file declares goh");
        let text = format!("{}\nenergy goh{energy}", scene.replace("goh, ", ""));
        // Blanks and brackets separate words; comments hold none.
        let text: String = text.lines().map(|line| line.split('#').next().unwrap_or("").to_string() + "\n").collect();
        let mut words: Vec<&str> = text.split_inclusive([' ', '\n', '(', '*']).collect();
        for (place, piece) in changes {
            let place = place % words.len();
            words[place] = PIECES[piece];
            words.insert(place + 1, " ");
        }
        let source = Source { name: "specs/artery/mutated.tissue".into(), text: words.concat() };
        let (_, mistakes) = resolve(&source, &FileSystem, &[]);
        for mistake in mistakes {
            prop_assert!(mistake.render().starts_with("error[E0"));
        }
    }
}
