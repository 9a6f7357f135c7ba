//! Where a result comes from, the same lines at the head of every file.
//!
//! Owns the wording of provenance and the hash of the input. It reads no file.

use serde::{Deserialize, Serialize};

/// Version of this program, as every output names it.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What a result was computed from.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Provenance {
    /// Version of the program.
    pub version: String,
    /// The input file as named on the command line.
    pub input: String,
    /// Hash of the input and everything it imports, from [`hash`].
    pub hash: String,
    /// The scene, drive or sweep.
    pub scene: String,
}

impl Provenance {
    /// The provenance of `scene` in the file `input`, whose texts are hashed by [`hash`].
    pub fn new(input: &str, hash: &str, scene: &str) -> Self {
        Self { version: VERSION.into(), input: input.into(), hash: hash.into(), scene: scene.into() }
    }

    /// The lines that head a table, without a comment sign.
    pub fn lines(&self) -> Vec<String> {
        vec![
            format!("tissue {}", self.version),
            format!("input {}", self.input),
            format!("blake3 {}", self.hash),
            format!("scene {}", self.scene),
        ]
    }
}

/// Hash of a file and its imports, in the order given, as 64 hexadecimal digits (BLAKE3).
///
/// Every text enters with its name and both with their lengths, so that moving a byte from one file
/// to the next changes the hash.
pub fn hash<'a>(files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> String {
    let mut hasher = blake3::Hasher::new();
    for (name, text) in files {
        for bytes in [name.as_bytes(), text] {
            hasher.update(&(bytes.len() as u64).to_le_bytes());
            hasher.update(bytes);
        }
    }
    hasher.finalize().to_hex().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_tells_apart_texts_names_and_where_one_ends() {
        let one = hash([("a", b"xy".as_slice()), ("b", b"z")]);
        assert_eq!(one, hash([("a", b"xy".as_slice()), ("b", b"z")]));
        assert_eq!(one.len(), 64);
        assert_ne!(one, hash([("a", b"x".as_slice()), ("b", b"yz")]));
        assert_ne!(one, hash([("c", b"xy".as_slice()), ("b", b"z")]));
        assert_ne!(one, hash([("b", b"z".as_slice()), ("a", b"xy")]));
    }

    #[test]
    fn the_lines_name_version_input_hash_and_scene() {
        let lines = Provenance::new("a.tissue", "00ff", "axial").lines();
        assert_eq!(lines[0], format!("tissue {VERSION}"));
        assert_eq!(lines[1..], ["input a.tissue", "blake3 00ff", "scene axial"]);
    }
}
