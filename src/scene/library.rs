//! The standard library, embedded when the crate is built.
//!
//! Owns the texts of `specs/energies` and `specs/materials`. A new file there needs nothing else.

/// A file of the standard library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LibraryFile {
    /// `energies` or `materials`.
    pub library: &'static str,
    /// Its name without the ending.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
}

static FILES: &[LibraryFile] = include!(concat!(env!("OUT_DIR"), "/library.rs"));

/// Every file of the standard library, by library and name.
pub fn library() -> &'static [LibraryFile] {
    FILES
}

/// The libraries there are: what can follow `std.`.
pub(super) const LIBRARIES: &[&str] = &["energies", "materials"];
