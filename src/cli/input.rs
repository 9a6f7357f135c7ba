//! Files read and resolved, their mistakes printed.

use super::Exit;
use crate::output::provenance;
use crate::scene::{Document, Drive, FileSystem, LoadError, Loader, Mistake, Scene, resolve};
use crate::syntax::Source;
use std::cell::RefCell;
use std::path::Path;

/// A resolved file with the hash of everything that was read for it.
#[derive(Debug)]
pub struct Input {
    /// Path as given.
    pub name: String,
    /// What it means.
    pub document: Document,
    /// Hash of the file, its imports, its tables and the values set on the command line.
    pub hash: String,
    /// Every mistake.
    pub mistakes: Vec<Mistake>,
}

/// A loader that remembers what it gave.
struct Remembering {
    read: RefCell<Vec<(String, String)>>,
}

impl Loader for Remembering {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        let text = FileSystem.load(path)?;
        self.read.borrow_mut().push((path.to_string(), text.clone()));
        Ok(text)
    }
}

/// Reads and resolves a file.
///
/// # Errors
/// If the file itself cannot be read; mistakes in it are in the input.
pub fn read(path: &Path, overrides: &[(String, String)]) -> Result<Input, String> {
    let name = path.to_string_lossy().into_owned();
    let text = FileSystem.load(&name).map_err(|cause| format!("error: cannot read {name}: {cause}"))?;
    let loader = Remembering { read: RefCell::default() };
    let source = Source { name: name.clone(), text };
    let (document, mistakes) = resolve(&source, &loader, overrides);
    let read = loader.read.into_inner();
    let texts = std::iter::once((name.as_str(), source.text.as_bytes()))
        .chain(read.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))
        .chain(overrides.iter().map(|(path, value)| (path.as_str(), value.as_bytes())));
    let hash = provenance::hash(texts);
    Ok(Input { name, document, hash, mistakes })
}

/// Reads a file and stops with its mistakes printed if it has any.
///
/// # Errors
/// [`Exit::WrongInput`] after printing why.
pub fn read_or_explain(path: &Path, overrides: &[(String, String)]) -> Result<Input, Exit> {
    let input = read(path, overrides).map_err(|message| {
        eprintln!("{message}");
        Exit::WrongInput
    })?;
    if input.mistakes.is_empty() {
        return Ok(input);
    }
    for mistake in &input.mistakes {
        eprintln!("{}", mistake.render());
    }
    eprintln!("{}", count(input.mistakes.len()));
    Err(Exit::WrongInput)
}

/// `1 mistake`, `3 mistakes`.
pub fn count(mistakes: usize) -> String {
    if mistakes == 1 { "1 mistake".into() } else { format!("{mistakes} mistakes") }
}

/// The scenes asked for: one by name, or all.
///
/// # Errors
/// [`Exit::WrongInput`] after printing which scenes there are.
pub fn scenes<'a>(input: &'a Input, name: Option<&str>) -> Result<Vec<&'a Scene>, Exit> {
    let all = &input.document.scenes;
    let names = || all.iter().map(|scene| format!("`{}`", scene.name)).collect::<Vec<_>>().join(", ");
    if all.is_empty() {
        eprintln!("error: {} has no scene to run; write `scene name {{ … }}`", input.name);
        return Err(Exit::WrongInput);
    }
    match name {
        None => Ok(all.iter().collect()),
        Some(name) => match all.iter().find(|scene| scene.name == name) {
            Some(scene) => Ok(vec![scene]),
            None => {
                eprintln!("error: {} has no scene `{name}`; its scenes are {}", input.name, names());
                Err(Exit::WrongInput)
            }
        },
    }
}

/// The scenes and drives asked for: one by name, or all.
///
/// # Errors
/// [`Exit::WrongInput`] after printing which there are.
pub fn runnable<'a>(input: &'a Input, name: Option<&str>) -> Result<(Vec<&'a Scene>, Vec<&'a Drive>), Exit> {
    let (scenes, drives) = (&input.document.scenes, &input.document.drives);
    let wanted = |found: &str| name.is_none_or(|name| name == found);
    let chosen: Vec<&Scene> = scenes.iter().filter(|scene| wanted(&scene.name)).collect();
    let driven: Vec<&Drive> = drives.iter().filter(|drive| wanted(&drive.name)).collect();
    if !chosen.is_empty() || !driven.is_empty() {
        return Ok((chosen, driven));
    }
    let names = scenes.iter().map(|scene| &scene.name).chain(drives.iter().map(|drive| &drive.name));
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match name {
        Some(name) if !names.is_empty() => {
            eprintln!("error: {} has no scene or drive `{name}`; it has {}", input.name, names.join(", "));
        }
        _ => eprintln!(
            "error: {} has nothing to run; write `scene name {{ … }}` or `drive name {{ … }}`",
            input.name
        ),
    }
    Err(Exit::WrongInput)
}
