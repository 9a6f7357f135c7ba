//! The tool, started as its users start it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder of this test's own, emptied.
pub fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("command_line").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("the folder for tests can be written");
    path
}

pub fn tissue(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tissue"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(arguments)
        .output()
        .expect("the tool starts")
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

pub fn path(path: &Path) -> &str {
    path.to_str().expect("a path of the test is text")
}

/// Every file of a folder by name, the timings of `run.json` taken out.
pub fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the run wrote its folder");
    let mut files = BTreeMap::new();
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let mut bytes = fs::read(entry.path()).expect("a file of the run is readable");
        if name == "run.json" {
            let timing =
                |line: &str| line.contains("\"wall_seconds\"") || line.contains("\"updates_per_second\"");
            let kept: Vec<String> =
                text(&bytes).lines().filter(|line| !timing(line)).map(String::from).collect();
            bytes = kept.join("\n").into_bytes();
        }
        files.insert(name, bytes);
    }
    files
}
