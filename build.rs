//! Embeds the standard library (every `.tissue` file of `specs/energies` and `specs/materials`), the pages of
//! diagnostics, and what the claims about scenes read: all of `specs` and `verification/references`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

fn main() {
    let root =
        PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets the manifest directory"));
    let mut code = String::from("&[\n");
    for library in ["energies", "materials"] {
        let folder = root.join("specs").join(library);
        println!("cargo:rerun-if-changed={}", folder.display());
        for file in tissue_files(&folder) {
            let stem = file.file_stem().expect("a .tissue file has a stem").to_string_lossy().into_owned();
            writeln!(
                code,
                "    LibraryFile {{ library: {library:?}, name: {stem:?}, text: include_str!({:?}) }},",
                file.display().to_string()
            )
            .expect("writing to a string cannot fail");
        }
    }
    code.push_str("]\n");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets the output directory"));
    std::fs::write(out.join("pages.rs"), pages(&root)).expect("the output directory can be written");
    std::fs::write(out.join("library.rs"), code).expect("the output directory can be written");
    std::fs::write(out.join("files.rs"), embedded(&root)).expect("the output directory can be written");
}

/// Every scene file and every reference table, by its path in the project.
fn embedded(root: &Path) -> String {
    let mut files = Vec::new();
    for (folder, extension) in [("specs", "tissue"), ("specs", "csv"), ("verification/references", "csv")] {
        walk(&root.join(folder), extension, &mut files);
    }
    files.sort();
    let mut code = String::from("&[\n");
    for file in files {
        let path = file.strip_prefix(root).expect("the walk starts below the root");
        let path = path.to_string_lossy().replace('\\', "/");
        writeln!(code, "    ({path:?}, include_str!({:?})),", file.display().to_string())
            .expect("writing to a string cannot fail");
    }
    code.push_str("]\n");
    code
}

/// The page of every diagnostic, by its code.
fn pages(root: &Path) -> String {
    let mut files = Vec::new();
    walk(&root.join("docs/diagnostics"), "md", &mut files);
    files.sort();
    let mut code = String::from("&[\n");
    for file in files {
        let stem = file.file_stem().expect("a page has a stem").to_string_lossy().into_owned();
        writeln!(code, "    ({stem:?}, include_str!({:?})),", file.display().to_string())
            .expect("writing to a string cannot fail");
    }
    code.push_str("]\n");
    code
}

/// Files of an extension in a folder and the folders below it.
fn walk(folder: &Path, extension: &str, files: &mut Vec<PathBuf>) {
    println!("cargo:rerun-if-changed={}", folder.display());
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for path in entries.filter_map(|entry| entry.ok().map(|entry| entry.path())) {
        if path.is_dir() {
            walk(&path, extension, files);
        } else if path.extension().is_some_and(|found| found == extension) {
            files.push(path);
        }
    }
}

/// The library files of a folder by name; none if the folder does not exist.
fn tissue_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "tissue"))
        .collect();
    files.sort();
    files
}
