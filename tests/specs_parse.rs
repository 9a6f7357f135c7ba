//! Every specification of the repository is text the grammar reads.

use std::fs;
use std::path::{Path, PathBuf};
use tissue::syntax::{Source, format, parse};

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "tissue") {
            found.push(path);
        }
    }
}

/// Every specification, with its text.
fn specifications() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    files(&root.join("specs"), &mut found);
    files(&root.join("verification"), &mut found);
    found.sort();
    assert!(found.len() >= 5, "the specifications are found");
    let source = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a specification is readable");
        Source { name: path.display().to_string(), text }
    };
    found.into_iter().map(source).collect()
}

#[test]
fn every_specification_is_read_without_a_mistake() {
    for source in specifications() {
        let (tree, mistakes) = parse(&source);
        let told: String = mistakes.iter().map(|m| m.render(&source)).collect();
        assert!(mistakes.is_empty(), "{told}");
        assert!(!tree.items.is_empty());
    }
}

/// What was written, without blanks.
fn ink(text: &str) -> String {
    text.split_whitespace().collect()
}

#[test]
fn formatting_a_specification_twice_is_formatting_it_once_and_keeps_every_comment() {
    for source in specifications() {
        let once = format(&source).expect("a specification has no mistake");
        let again = format(&Source { text: once.clone(), ..source.clone() });
        assert_eq!(again.as_ref(), Ok(&once), "{}", source.name);
        assert_eq!(ink(&once), ink(&source.text), "{}", source.name);
    }
}

#[test]
fn every_specification_is_in_the_standard_form() {
    for source in specifications() {
        assert_eq!(format(&source).as_ref(), Ok(&source.text), "write `tissue fmt {}`", source.name);
    }
}
