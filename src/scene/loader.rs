//! Where the files come from that a scene names.
//!
//! Owns the joining of paths and the caps on size. A scene is resolved against a [`Loader`], so it can
//! be resolved without a file system.

use crate::syntax::{Code, NotText, text_of};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Component, Path, PathBuf};

/// Largest file that is read, bytes.
const LARGEST: u64 = 64 << 20;

/// Gives the text of a file that another one names.
pub trait Loader {
    /// The text of a file.
    ///
    /// # Errors
    /// [`LoadError`] says why there is none.
    fn load(&self, path: &str) -> Result<String, LoadError>;

    /// The bytes of a file that need not be text.
    ///
    /// # Errors
    /// [`LoadError`] says why there are none.
    fn load_bytes(&self, path: &str) -> Result<Vec<u8>, LoadError> {
        self.load(path).map(String::into_bytes)
    }
}

/// Why a file could not be read.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum LoadError {
    /// There is no such file.
    Missing,
    /// It is larger than is read.
    TooLarge,
    /// It is not UTF-8 text.
    NotText(NotText),
    /// The system refused.
    Refused(std::io::ErrorKind),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing => f.write_str("there is no such file"),
            Self::TooLarge => write!(f, "the file is larger than {} MB", LARGEST >> 20),
            Self::NotText(cause) => write!(f, "it {cause}; save it as UTF-8"),
            Self::Refused(kind) => write!(f, "{kind}"),
        }
    }
}

impl std::error::Error for LoadError {}

impl LoadError {
    /// The code of the mistake that a file named in another one cannot be read.
    pub(super) fn code(&self) -> Code {
        match self {
            Self::NotText(_) => Code::NotUtf8,
            _ => Code::FileNotFound,
        }
    }
}

/// A loader that reads each file once, so that one resolution never sees two versions of it.
pub(super) struct Once<'a> {
    inner: &'a dyn Loader,
    texts: RefCell<BTreeMap<String, Result<String, LoadError>>>,
}

impl<'a> Once<'a> {
    pub(super) fn new(inner: &'a dyn Loader) -> Self {
        Self { inner, texts: RefCell::default() }
    }
}

impl Loader for Once<'_> {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        let mut texts = self.texts.borrow_mut();
        texts.entry(path.into()).or_insert_with(|| self.inner.load(path)).clone()
    }

    // a file that is no text is named for its shape and read where it is named
    fn load_bytes(&self, path: &str) -> Result<Vec<u8>, LoadError> {
        self.inner.load_bytes(path)
    }
}

/// The file system, paths relative to the working directory.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FileSystem;

impl Loader for FileSystem {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        text_of(self.load_bytes(path)?).map_err(LoadError::NotText)
    }

    fn load_bytes(&self, path: &str) -> Result<Vec<u8>, LoadError> {
        let refused = |error: std::io::Error| match error.kind() {
            std::io::ErrorKind::NotFound => LoadError::Missing,
            kind => LoadError::Refused(kind),
        };
        let metadata = std::fs::metadata(path).map_err(refused)?;
        if metadata.is_dir() {
            return Err(LoadError::Refused(std::io::ErrorKind::IsADirectory));
        }
        if !metadata.is_file() {
            // a device or a pipe has no size to hold against the limit, and may never end
            return Err(LoadError::Refused(std::io::ErrorKind::InvalidInput));
        }
        if metadata.len() > LARGEST {
            return Err(LoadError::TooLarge);
        }
        std::fs::read(path).map_err(refused)
    }
}

/// Files in memory, by path.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Memory {
    /// Path and text.
    pub files: BTreeMap<String, String>,
}

impl Loader for Memory {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        self.files.get(path).cloned().ok_or(LoadError::Missing)
    }
}

/// The path of a file named in another one: relative to the folder of the one that names it.
///
/// `.` and `..` are taken out where the text allows, so that one file has one name.
pub(super) fn relative_to(naming: &str, named: &str) -> String {
    let folder = Path::new(naming).parent().unwrap_or(Path::new(""));
    let mut parts: Vec<Component> = Vec::new();
    let joined = folder.join(named);
    for part in joined.components() {
        match (part, parts.last()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                parts.pop();
            }
            (Component::ParentDir, Some(Component::RootDir)) => {}
            (part, _) => parts.push(part),
        }
    }
    parts.iter().collect::<PathBuf>().to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_relative_to_the_file_that_names_it() {
        assert_eq!(relative_to("specs/artery/axial.tissue", "../../data/a.csv"), "data/a.csv");
        assert_eq!(relative_to("axial.tissue", "a.csv"), "a.csv");
        assert_eq!(relative_to("axial.tissue", "../a.csv"), "../a.csv");
        assert_eq!(relative_to("/x/axial.tissue", "./b/../a.csv"), "/x/a.csv");
        assert_eq!(relative_to("x/axial.tissue", "/a.csv"), "/a.csv");
    }

    #[test]
    fn a_missing_file_and_a_folder_are_refused() {
        assert_eq!(FileSystem.load("no/such/file.tissue"), Err(LoadError::Missing));
        assert!(matches!(FileSystem.load("src"), Err(LoadError::Refused(_))));
    }
}
