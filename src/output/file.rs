//! Whole files: written under a temporary name, then renamed.
//!
//! Owns the two promises about files: a reader never sees half a file, and results that already
//! exist are never overwritten silently. What the bytes mean is not known here.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Writes `bytes` to `path` so that `path` holds either its former content or all of them.
///
/// The bytes go to a neighbour with the suffix `.part`, which is then renamed. Folders on the way
/// are created.
///
/// # Errors
/// Whatever the file system reports; the temporary file is removed where writing failed.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let part = part_name(path);
    let written = fs::write(&part, bytes).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // The first failure is the one to report; a leftover that cannot be removed changes nothing.
        let _ = fs::remove_file(&part);
    }
    written
}

/// The temporary neighbour of `path`.
fn part_name(path: &Path) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(".part");
    path.with_file_name(name)
}

/// Creates an output folder, refusing one that already holds something.
///
/// # Errors
/// [`io::ErrorKind::AlreadyExists`] where `folder` is a file or a folder that is not empty; whatever
/// the file system reports otherwise.
pub fn create_fresh_folder(folder: &Path) -> io::Result<()> {
    if folder.exists() {
        if !folder.is_dir() {
            let message = format!("{} is no folder", folder.display());
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, message));
        }
        if fs::read_dir(folder)?.next().is_some() {
            let message = format!("{} already holds results", folder.display());
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, message));
        }
    }
    fs::create_dir_all(folder)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// An empty folder of this test's own, removed when dropped.
    pub(crate) struct Scratch(pub(crate) PathBuf);

    impl Scratch {
        pub(crate) fn new(test: &str) -> Self {
            let folder = std::env::temp_dir().join(format!("tissue-{}-{test}", std::process::id()));
            fs::create_dir_all(&folder).expect("the temporary folder is writable");
            Self(folder)
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_written_file_replaces_the_former_one_and_leaves_no_part() {
        let scratch = Scratch::new("atomic");
        let path = scratch.0.join("deep/a.csv");
        write_atomic(&path, b"old").expect("first");
        write_atomic(&path, b"new").expect("second");
        assert_eq!(fs::read(&path).expect("readable"), b"new");
        assert_eq!(fs::read_dir(path.parent().expect("has one")).expect("listed").count(), 1);
    }

    #[test]
    fn a_failed_write_leaves_the_former_file_and_no_part() {
        let scratch = Scratch::new("atomic-failed");
        let path = scratch.0.join("taken");
        fs::create_dir_all(path.join("inside")).expect("created");
        assert!(write_atomic(&path, b"new").is_err());
        assert_eq!(fs::read_dir(&scratch.0).expect("listed").count(), 1);
    }

    #[test]
    fn a_folder_with_results_is_refused_and_an_empty_one_is_taken() {
        let scratch = Scratch::new("fresh");
        let folder = scratch.0.join("out");
        create_fresh_folder(&folder).expect("absent");
        create_fresh_folder(&folder).expect("empty");
        fs::write(folder.join("run.json"), b"{}").expect("written");
        let error = create_fresh_folder(&folder).expect_err("not empty");
        assert_eq!(error.kind(), io::ErrorKind::AlreadyExists);
    }
}
