//! A file to its document.

use super::file::{File, Mistake, Mistakes};
use super::loader::{Loader, Once};
use super::model::{Document, Scene, Swept};
use super::session::{Module, Session, Wanted};
use super::sweeps::Setting;
use super::{checks, drives, figures, fits, scenes, sweeps};
use crate::syntax::{Block, Entry, ExprKind, Item, Source};
use std::rc::Rc;

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

/// The same of one scene, drive, fit or sweep of a file: the values given in place of those written are for it alone,
/// and so is the judgement of them. What the file says elsewhere is held as it is written.
///
/// A path that `only` does not read is a mistake. Without such a block the file is read as written.
pub fn resolve_one(
    source: &Source,
    loader: &dyn Loader,
    overrides: &[(String, String)],
    only: &str,
) -> (Document, Vec<Mistake>) {
    let loader = &Once::new(loader);
    let mut session = Session::new(loader, overrides);
    let file = session.parse(source.clone());
    let Some(wanted) = wanted_blocks(&file, only) else { return read(source, loader, &[], Wanted::All) };
    let (module, mut document) = materials(&mut session, &file);
    let is_wanted = |block: &Block| wanted.iter().any(|other| other.span == block.span);
    blocks(&mut session, &file, &module, &mut document, (loader, overrides), is_wanted);
    refuse_materials(&mut session, &module, &document, overrides, only);
    session.overrides.finish(&mut session.mistakes, &format!("`{only}`"));
    let mut plain = session.again(loader, &[]);
    let (module, mut rest) = materials(&mut plain, &file);
    // told with the values in place
    plain.mistakes = Mistakes::default();
    blocks(&mut plain, &file, &module, &mut rest, (loader, &[]), |_| true);
    let elsewhere = |mistake: &Mistake| {
        let label = mistake.diagnostic.labels.first();
        let inside = |at: usize| wanted.iter().any(|block| block.span.contains(&at));
        mistake.source.name != file.source.name || !label.is_some_and(|label| inside(label.span.start))
    };
    session.mistakes.extend(plain.mistakes.finish(&file).into_iter().filter(elsewhere));
    (document, session.mistakes.finish(&file))
}

/// The block of that name and those it is of: `of = …` of a sweep, `drive = …` of a fit.
fn wanted_blocks<'a>(file: &'a File, only: &str) -> Option<Vec<&'a Block>> {
    let runs = |kind: &str| matches!(kind, "scene" | "drive" | "fit" | "sweep" | "trade");
    let named = |name: &str| {
        file.tree.items.iter().find_map(|item| match item {
            Item::Block(block) if runs(&block.kind.text) => {
                let [own] = block.target.as_ref()?.parts.as_slice() else { return None };
                (own.text == name).then_some(block)
            }
            _ => None,
        })
    };
    let block = named(only)?;
    let mut wanted = vec![block];
    for entry in &block.entries {
        let Entry::Assign { keyword: None, key, value, .. } = entry else { continue };
        if matches!(key.parts.as_slice(), [key] if matches!(key.text.as_str(), "of" | "drive")) {
            let ids = match &file.tree.expr(*value).kind {
                ExprKind::List(ids) => ids.clone(),
                _ => vec![*value],
            };
            wanted.extend(ids.iter().filter_map(|id| match &file.tree.expr(*id).kind {
                ExprKind::Name(name) => named(name),
                _ => None,
            }));
        }
    }
    Some(wanted)
}

/// Refuses values for materials that what is asked for is not made of.
fn refuse_materials(
    session: &mut Session,
    module: &Module,
    document: &Document,
    overrides: &[(String, String)],
    only: &str,
) {
    let of_scene = |scene: &Scene| scene.materials.iter().map(|m| m.name.clone()).collect::<Vec<_>>();
    let points = document.sweeps.iter().flat_map(|sweep| &sweep.points);
    let swept = points.flat_map(|point| match &point.swept {
        Swept::Scene(scene) => of_scene(scene),
        Swept::Drive(drive) => vec![drive.material.name.clone()],
    });
    let mut used: Vec<String> = document.scenes.iter().flat_map(of_scene).chain(swept).collect();
    used.extend(document.drives.iter().map(|drive| drive.material.name.clone()));
    used.sort();
    used.dedup();
    if used.is_empty() {
        // it has mistakes of its own
        return;
    }
    for (path, _) in overrides {
        let first = path.split('.').next().unwrap_or_default();
        if module.materials.contains_key(first) && !used.iter().any(|name| name == first) {
            let names: Vec<String> = used.iter().map(|name| format!("`{name}`")).collect();
            let help = format!("it is made of {}", names.join(" and "));
            let message = format!("`{only}` is not made of `{first}`");
            session.overrides.refuse(&mut session.mistakes, path, message, help);
        }
    }
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
    let (module, mut document) = materials(&mut session, &file);
    blocks(&mut session, &file, &module, &mut document, (loader, overrides), |_| true);
    session.overrides.finish(&mut session.mistakes, "the file");
    (document, session.mistakes.finish(&file))
}

/// The names of a file, and a document that holds its materials.
fn materials(session: &mut Session, file: &Rc<File>) -> (Rc<Module>, Document) {
    let module = session.module(file);
    let mut document = Document::default();
    for name in &module.own_materials {
        let declared = module.materials.get(name).and_then(Option::as_ref);
        document.materials.extend(declared.map(|declared| declared.material.as_ref().clone()));
    }
    (module, document)
}

/// Reads the blocks that are wanted into a document.
fn blocks(
    session: &mut Session,
    file: &Rc<File>,
    module: &Module,
    document: &mut Document,
    (loader, overrides): (&dyn Loader, &[(String, String)]),
    is_wanted: impl Fn(&Block) -> bool,
) {
    let wanted = session.wanted;
    let mut broken = Vec::new();
    let mut sweeps = Vec::new();
    let mut fitted = Vec::new();
    let mut known = fits::Drives::new();
    for index in &module.rest {
        let Item::Block(block) = &file.tree.items[*index] else { continue };
        let Some(name) = block.target.as_ref().and_then(|path| path.parts.first()) else { continue };
        if !is_wanted(block) {
            continue;
        }
        let read = match block.kind.text.as_str() {
            "drive" => {
                let drive = drives::read(session, file, block, name, module);
                known.insert(name.text.clone(), drive.clone().ok());
                drive.map(|d| document.drives.push(d))
            }
            "fit" => {
                fitted.push((block, name));
                Ok(())
            }
            "check" => {
                // It has no name of its own that a sweep could be of.
                document.checks.extend(checks::read(session, file, block, name, module));
                Ok(())
            }
            "scene" => scenes::read(session, file, block, name, module).map(|s| document.scenes.push(s)),
            "figure" => match wanted {
                Wanted::All => figures::read(session, file, block, name, module)
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
        document.fits.extend(fits::read(session, file, block, name, module, &known));
    }
    // After all they can be of, wherever these stand.
    let mut described = Vec::new();
    for (block, name) in sweeps.into_iter().filter(|_| wanted == Wanted::All) {
        let setting = Setting { loader, overrides, document, broken: &broken };
        described.extend(sweeps::read(session, file, block, name, module, &setting));
    }
    document.sweeps.extend(described);
}
