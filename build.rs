//! Embeds the standard library: every `.tissue` file of `specs/energies` and `specs/materials`.

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
    std::fs::write(out.join("library.rs"), code).expect("the output directory can be written");
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
