//! A file to its document.

use super::file::Mistake;
use super::loader::{Loader, Once};
use super::model::Document;
use super::session::{Session, Wanted};
use super::sweeps::Setting;
use super::{checks, drives, figures, fits, scenes, sweeps};
use crate::syntax::{Item, Source};

/// The meaning of a file, and every mistake found in it and in the files it imports.
///
/// `source.name` is the path of the file: what the file names is looked for relative to it. `overrides`
/// are values in place of those written, by path: `("strip.spacing", "0.25 mm")`.
///
/// With no mistakes the document is whole; with mistakes it holds what has none.
pub fn resolve(
    source: &Source,
    loader: &dyn Loader,
    overrides: &[(String, String)],
) -> (Document, Vec<Mistake>) {
    read(source, loader, overrides, Wanted::All)
}

/// The same without figures, sweeps and `expect` lines: what a figure takes its numbers from. The quick tier of a
/// figure may end before a line asks for a value.
pub fn resolve_runs(
    source: &Source,
    loader: &dyn Loader,
    overrides: &[(String, String)],
) -> (Document, Vec<Mistake>) {
    read(source, loader, overrides, Wanted::Runs)
}

fn read(
    source: &Source,
    loader: &dyn Loader,
    overrides: &[(String, String)],
    wanted: Wanted,
) -> (Document, Vec<Mistake>) {
    let loader = &Once::new(loader);
    let mut session = Session::new(loader, overrides);
    session.wanted = wanted;
    let file = session.parse(source.clone());
    let module = session.module(&file);
    let mut document = Document::default();
    for name in &module.own_materials {
        let declared = module.materials.get(name).and_then(Option::as_ref);
        document.materials.extend(declared.map(|declared| declared.material.as_ref().clone()));
    }
    let mut broken = Vec::new();
    let mut sweeps = Vec::new();
    let mut fitted = Vec::new();
    let mut known = fits::Drives::new();
    for index in &module.rest {
        let Item::Block(block) = &file.tree.items[*index] else { continue };
        let Some(name) = block.target.as_ref().and_then(|path| path.parts.first()) else { continue };
        let read = match block.kind.text.as_str() {
            "drive" => {
                let drive = drives::read(&mut session, &file, block, name, &module);
                known.insert(name.text.clone(), drive.clone().ok());
                drive.map(|d| document.drives.push(d))
            }
            "fit" => {
                fitted.push((block, name));
                Ok(())
            }
            "check" => {
                // It has no name of its own that a sweep could be of.
                document.checks.extend(checks::read(&mut session, &file, block, name, &module));
                Ok(())
            }
            "scene" => {
                scenes::read(&mut session, &file, block, name, &module).map(|s| document.scenes.push(s))
            }
            "figure" => match wanted {
                Wanted::All => figures::read(&mut session, &file, block, name, &module)
                    .map(|figure| document.figures.push(figure)),
                Wanted::Runs => Ok(()),
            },
            _ => {
                sweeps.push((block, name));
                Ok(())
            }
        };
        if read.is_err() {
            broken.push(name.text.clone());
        }
    }
    // After all drives, wherever they stand.
    for (block, name) in fitted {
        document.fits.extend(fits::read(&mut session, &file, block, name, &module, &known));
    }
    // After all they can be of, wherever these stand.
    for (block, name) in sweeps.into_iter().filter(|_| wanted == Wanted::All) {
        let setting = Setting { loader, overrides, document: &document, broken: &broken };
        let sweep = sweeps::read(&mut session, &file, block, name, &module, &setting);
        document.sweeps.extend(sweep);
    }
    session.overrides.finish(&mut session.mistakes);
    (document, session.mistakes.finish(&file))
}
