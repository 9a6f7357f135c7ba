//! Tree and vocabulary to a checked description.
//!
//! Owns meaning: SI numbers, proved dimensions, every name resolved, all mistakes collected. Knows
//! neither the solver nor files written.

mod blocks;
mod checks;
mod drives;
mod energies;
mod evaluate;
mod figures;
mod file;
mod files;
mod fits;
mod graph;
mod library;
mod loader;
mod materials;
mod members;
mod model;
mod resolve;
mod scenes;
mod session;
mod size;
mod sweeps;
mod words;

pub use file::Mistake;
pub use library::{LibraryFile, library};
pub use loader::{FileSystem, LoadError, Loader, Memory};
pub use model::*;
pub use resolve::{resolve, resolve_one, resolve_runs};
pub use scenes::{ERRORS, FITTED};
pub use words::{explain, nearest_word, vocabulary};
