//! The folder a run writes to.
//!
//! Owns the promise that results are replaced only on request and that nothing else in a folder is
//! ever touched.

use crate::output::RunReport;
use crate::output::file::{create_fresh_folder, write_atomic};
use std::fs;
use std::path::{Path, PathBuf};

/// The file that says what a folder holds.
pub const REPORT: &str = "run.json";

/// What the name of a folder gets while its earlier run is set aside.
const ASIDE: &str = ".earlier";

/// The files of an earlier run, set aside until the new one has begun.
#[derive(Debug)]
#[must_use = "an earlier run is either given back or let go"]
pub struct Earlier {
    folder: PathBuf,
    aside: Option<PathBuf>,
}

/// Makes the output folder; an earlier run in it is set aside, into a folder beside it, if it may go.
///
/// # Errors
/// What is in the way and what to write; `option` names the folder on the command line.
pub fn prepare(folder: &Path, overwrite: bool, option: &str) -> Result<Earlier, String> {
    let mut aside = None;
    if overwrite && folder.is_dir() {
        let earlier = earlier(folder);
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        if let Some(foreign) = names.find(|name| !earlier.contains(name)) {
            return Err(format!(
                "{} holds `{foreign}`, which no run listed in {REPORT} wrote; name another folder with {option}",
                folder.display()
            ));
        }
        let mut name = folder.file_name().unwrap_or_default().to_os_string();
        name.push(ASIDE);
        let place = folder.with_file_name(name);
        remove(&place)?;
        // what cannot be moved, as the root of a file system, is emptied instead
        match fs::rename(folder, &place) {
            Ok(()) => aside = Some(place),
            Err(_) => empty(folder)?,
        }
    }
    let earlier = Earlier { folder: folder.to_path_buf(), aside };
    match create_fresh_folder(folder) {
        Ok(()) => Ok(earlier),
        Err(cause) => {
            earlier.give_back()?;
            let replace = if overwrite { "" } else { ", or replace an earlier run with --overwrite" };
            Err(format!(
                "cannot write to {}: {cause}; name another folder with {option}{replace}",
                folder.display()
            ))
        }
    }
}

impl Earlier {
    /// Puts the earlier run back, for the new one could not begin.
    ///
    /// # Errors
    /// Where it is if it cannot be put back.
    pub fn give_back(self) -> Result<(), String> {
        // empty if the new run has withdrawn
        let _ = fs::remove_dir(&self.folder);
        let Some(aside) = self.aside else { return Ok(()) };
        fs::rename(&aside, &self.folder)
            .map_err(|cause| format!("the earlier results are in {}: {cause}", aside.display()))
    }

    /// Lets the earlier run go, for the new one stands in its place.
    ///
    /// # Errors
    /// What cannot be removed.
    pub fn let_go(self) -> Result<(), String> {
        self.aside.map_or(Ok(()), |aside| remove(&aside))
    }
}

/// Removes a folder and the files a run wrote into it, if there is one.
fn remove(folder: &Path) -> Result<(), String> {
    empty(folder)?;
    if folder.exists() {
        fs::remove_dir(folder).map_err(|cause| format!("cannot remove {}: {cause}", folder.display()))?;
    }
    Ok(())
}

/// Removes the files a run wrote into a folder.
fn empty(folder: &Path) -> Result<(), String> {
    for name in earlier(folder) {
        let path = folder.join(name);
        if path.is_file() {
            fs::remove_file(&path).map_err(|cause| format!("cannot remove {}: {cause}", path.display()))?;
        }
    }
    Ok(())
}

/// Writes the report that an interrupted run leaves behind.
///
/// # Errors
/// If the folder cannot be written.
pub fn announce(folder: &Path, report: &RunReport) -> Result<(), String> {
    let path = folder.join(REPORT);
    write_atomic(&path, report.to_json().as_bytes())
        .map_err(|cause| format!("cannot write {}: {cause}", path.display()))
}

/// Takes the announcement of a run back that could not begin, and the folder with it where nothing else is in it.
pub fn withdraw(folder: &Path) {
    // what cannot be removed stays and says "unfinished", which is true
    let _ = fs::remove_file(folder.join(REPORT));
    let _ = fs::remove_dir(folder);
}

/// Names of the files the report of an earlier run lists, and of the frames its collections name.
fn earlier(folder: &Path) -> Vec<String> {
    let Ok(text) = fs::read_to_string(folder.join(REPORT)) else { return Vec::new() };
    let Ok(report) = serde_json::from_str::<serde_json::Value>(&text) else { return Vec::new() };
    let Some(files) = report["files"].as_array() else { return Vec::new() };
    let mut names = vec![REPORT.to_string()];
    for file in files.iter().filter_map(|file| file.as_str()).filter(|file| is_plain(file)) {
        if let Some(stem) = file.strip_suffix(".pvd") {
            names.extend(frames(folder, stem));
        }
        names.push(file.to_string());
        names.push(format!("{file}.part"));
    }
    names
}

/// A name in the folder itself; a report is a file anyone may have edited.
fn is_plain(name: &str) -> bool {
    Path::new(name).components().count() == 1 && !name.contains(['/', '\\']) && name != ".."
}

/// `stem_0000.vtu`, `stem_0001.vtu`, … as they stand in the folder.
fn frames(folder: &Path, stem: &str) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let is_frame = |name: &String| {
        let number =
            name.strip_prefix(stem).and_then(|rest| rest.strip_prefix('_')).map(|rest| rest.split_once('.'));
        matches!(number, Some(Some((digits, "vtu" | "vtu.part"))) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()))
    };
    entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).filter(is_frame).collect()
}
