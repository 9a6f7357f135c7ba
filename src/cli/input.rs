//! Files read and resolved, their mistakes printed.

use super::Exit;
use crate::output::provenance;
use crate::scene::{
    Document, Drive, FileSystem, Fit, LoadError, Loader, Mistake, Scene, Sweep, resolve, resolve_one,
    resolve_runs,
};
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
    read: RefCell<Vec<(String, Vec<u8>)>>,
}

impl Loader for Remembering {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        let text = FileSystem.load(path)?;
        self.read.borrow_mut().push((path.to_string(), text.clone().into_bytes()));
        Ok(text)
    }

    fn load_bytes(&self, path: &str) -> Result<Vec<u8>, LoadError> {
        let bytes = FileSystem.load_bytes(path)?;
        self.read.borrow_mut().push((path.to_string(), bytes.clone()));
        Ok(bytes)
    }
}

/// Reads and resolves a file.
///
/// # Errors
/// If the file itself cannot be read; mistakes in it are in the input.
pub fn read(path: &Path, overrides: &[(String, String)]) -> Result<Input, String> {
    read_with(path, overrides, resolve)
}

fn read_with(
    path: &Path,
    overrides: &[(String, String)],
    resolve: impl Fn(&Source, &dyn Loader, &[(String, String)]) -> (Document, Vec<Mistake>),
) -> Result<Input, String> {
    let name = path.to_string_lossy().into_owned();
    let text = FileSystem.load(&name).map_err(|cause| format!("error: cannot read {name}: {cause}"))?;
    let loader = Remembering { read: RefCell::default() };
    let source = Source { name: name.clone(), text };
    let (document, mistakes) = resolve(&source, &loader, overrides);
    let read = loader.read.into_inner();
    let texts = std::iter::once((name.as_str(), source.text.as_bytes()))
        .chain(read.iter().map(|(name, text)| (name.as_str(), text.as_slice())))
        .chain(overrides.iter().map(|(path, value)| (path.as_str(), value.as_bytes())));
    let hash = provenance::hash(texts);
    Ok(Input { name, document, hash, mistakes })
}

/// Reads a file and stops with its mistakes printed if it has any.
///
/// # Errors
/// [`Exit::WrongInput`] after printing why.
pub fn read_or_explain(path: &Path, overrides: &[(String, String)]) -> Result<Input, Exit> {
    sound(read(path, overrides))
}

/// The same for one of its scenes, drives, fits and sweeps, which alone the values are given to.
///
/// # Errors
/// As [`read_or_explain`].
pub fn read_one_or_explain(
    path: &Path,
    overrides: &[(String, String)],
    only: Option<&str>,
) -> Result<Input, Exit> {
    for (place, (path, value)) in overrides.iter().enumerate() {
        if let Some((_, earlier)) = overrides[..place].iter().find(|(other, _)| other == path) {
            tell!("error: --set {path} is given twice, {earlier} and {value}; write one of them");
            return Err(Exit::WrongInput);
        }
    }
    match only {
        Some(only) if !overrides.is_empty() => {
            sound(read_with(path, overrides, |source, loader, set| resolve_one(source, loader, set, only)))
        }
        _ => read_or_explain(path, overrides),
    }
}

/// The same of a file's scenes and drives alone, without what must hold of them.
///
/// # Errors
/// As [`read_or_explain`].
pub fn read_runs_or_explain(path: &Path, overrides: &[(String, String)]) -> Result<Input, Exit> {
    sound(read_with(path, overrides, resolve_runs))
}

fn sound(input: Result<Input, String>) -> Result<Input, Exit> {
    let input = input.map_err(|message| {
        tell!("{message}");
        Exit::WrongInput
    })?;
    if input.mistakes.is_empty() {
        return Ok(input);
    }
    tell_mistakes("", &input.mistakes);
    Err(Exit::WrongInput)
}

/// Most mistakes that are drawn.
const MOST_DRAWN: usize = 50;

/// Prints the first mistakes and how many there are, that line behind `name`.
pub fn tell_mistakes(name: &str, mistakes: &[Mistake]) {
    for mistake in mistakes.iter().take(MOST_DRAWN) {
        tell!("{}", mistake.render());
    }
    let all = count(mistakes.len());
    match mistakes.len().saturating_sub(MOST_DRAWN) {
        0 => tell!("{name}{all}"),
        more => tell!("{name}{all}, {more} of them not shown"),
    }
}

/// `1 mistake`, `3 mistakes`.
pub fn count(mistakes: usize) -> String {
    if mistakes == 1 { "1 mistake".into() } else { format!("{mistakes} mistakes") }
}

/// What of a file is asked for.
#[derive(Debug)]
pub struct Chosen<'a> {
    /// Scenes of particles.
    pub scenes: Vec<&'a Scene>,
    /// Drives of a material point.
    pub drives: Vec<&'a Drive>,
    /// Fits.
    pub fits: Vec<&'a Fit>,
    /// Sweeps and trades.
    pub sweeps: Vec<&'a Sweep>,
}

impl Chosen<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.scenes.len() + self.drives.len() + self.fits.len() + self.sweeps.len()
    }
}

/// What is asked for: one by name, or all.
///
/// # Errors
/// [`Exit::WrongInput`] after printing what there is.
pub fn chosen<'a>(input: &'a Input, name: Option<&str>) -> Result<Chosen<'a>, Exit> {
    let Document { scenes, drives, fits, sweeps, .. } = &input.document;
    let wanted = |found: &str| name.is_none_or(|name| name == found);
    let chosen = Chosen {
        scenes: scenes.iter().filter(|scene| wanted(&scene.name)).collect(),
        drives: drives.iter().filter(|drive| wanted(&drive.name)).collect(),
        fits: fits.iter().filter(|fit| wanted(&fit.name)).collect(),
        sweeps: sweeps.iter().filter(|sweep| wanted(&sweep.name)).collect(),
    };
    if chosen.len() > 0 {
        return Ok(chosen);
    }
    let names = scenes.iter().map(|scene| &scene.name).chain(drives.iter().map(|drive| &drive.name));
    let names = names.chain(fits.iter().map(|fit| &fit.name));
    let names: Vec<String> =
        names.chain(sweeps.iter().map(|sweep| &sweep.name)).map(|name| format!("`{name}`")).collect();
    match name {
        Some(name) if !names.is_empty() => {
            tell!(
                "error: {} has no scene, drive, fit or sweep `{name}`; it has {}",
                input.name,
                names.join(", ")
            );
        }
        _ => tell!(
            "error: {} has nothing to run; write `scene name {{ … }}`, `drive name {{ … }}` or `fit name {{ … }}`",
            input.name
        ),
    }
    Err(Exit::WrongInput)
}
