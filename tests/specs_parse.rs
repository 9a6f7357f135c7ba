//! Every specification of the repository is text the grammar reads.

use std::fs;
use std::path::{Path, PathBuf};
use tissue::syntax::{Source, parse};

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

#[test]
fn every_specification_is_read_without_a_mistake() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    files(&root.join("specs"), &mut found);
    files(&root.join("verification"), &mut found);
    found.sort();
    assert!(found.len() >= 5, "the specifications are found");
    for path in found {
        let text = fs::read_to_string(&path).expect("a specification is readable");
        let source = Source { name: path.display().to_string(), text };
        let (tree, mistakes) = parse(&source);
        let told: String = mistakes.iter().map(|m| m.render(&source)).collect();
        assert!(mistakes.is_empty(), "{told}");
        assert!(!tree.items.is_empty());
    }
}
