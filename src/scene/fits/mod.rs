//! Fits: drives, their data, the parameters sought.
//!
//! Owns the reading of a `fit`. Drives are read before it; tables and expectations are those of a scene.

mod data;
mod vary;

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::members::{Members, Site};
use super::model::{Drive, Fit, FitSet, Weighing};
use super::scenes::Stage;
use super::session::{Module, Session};
use super::words::FIT;
use crate::schema::nearest;
use crate::syntax::{Block, Code, ExprId, ExprKind, Name};
use crate::unit::{Dimension, parse_unit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The drives of a file by name; `None` where one is wrong.
pub(super) type Drives = BTreeMap<String, Option<Drive>>;

/// Reads a fit.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
    drives: &Drives,
) -> Result<Fit, Reported> {
    let before = session.mistakes.len();
    let members =
        Members::read_with(&mut session.mistakes, file, &FIT, block, &session.overrides, &[&name.text]);
    let mut stage = Stage::new(session, file, name, module, &members);
    for inner in &members.blocks {
        unknown_block(stage.mistakes, file, inner, Some(FIT.word));
    }
    let required = |stage: &mut Stage, key| members.required(stage.mistakes, file, &FIT, block, key);
    let driven = required(&mut stage, "drive").and_then(|site| named_drives(&mut stage, &site, drives));
    let weighing = match members.written("weights") {
        Some(site) => stage.choice(site, &FIT, "weights").map(weighing),
        None => Ok(Weighing::Column),
    };
    let data = required(&mut stage, "data");
    let sets = match (&driven, data) {
        (Ok(driven), Ok(site)) => sets(&mut stage, &site, driven),
        _ => Err(Reported),
    };
    if let (Ok(sets), Ok(weighing)) = (&sets, weighing) {
        data::refuse_unweighable(&mut stage, name, sets, weighing);
    }
    let vary = required(&mut stage, "vary");
    let vary = match (&driven, vary) {
        (Ok(driven), Ok(site)) => vary::read(&mut stage, &site, driven),
        _ => Err(Reported),
    };
    if let (Ok(sets), Ok(vary)) = (&sets, &vary) {
        data::refuse_too_few(&mut stage, name, sets, vary.len());
    }
    if let Ok(vary) = &vary {
        for varied in vary {
            stage.fitted.insert(varied.name.clone(), dimension_of(&varied.unit));
        }
        for number in ["r_squared", "condition"] {
            stage.fitted.insert(number.into(), Dimension::NUMBER);
        }
        for entry in &members.expects {
            let _ = stage.expectation(entry);
        }
    }
    let expectations = std::mem::take(&mut stage.scene.expectations);
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    Ok(Fit {
        name: name.text.clone(),
        place: file.place(&name.span),
        sets: sets?,
        vary: vary?,
        weighing: weighing?,
        expectations,
    })
}

fn weighing(word: &str) -> Weighing {
    match word {
        "uniform" => Weighing::Uniform,
        "relative" => Weighing::Relative,
        _ => Weighing::Column,
    }
}

/// The dimension of an SI unit symbol as a description holds it.
fn dimension_of(unit: &str) -> Dimension {
    parse_unit(unit).map_or(Dimension::NUMBER, |unit| unit.dimension)
}

/// The elements of a list, or the one expression that is none.
fn listed(site: &Site) -> Vec<ExprId> {
    match &site.file.tree.expr(site.id).kind {
        ExprKind::List(ids) => ids.clone(),
        _ => vec![site.id],
    }
}

fn named_drives(stage: &mut Stage, site: &Site, drives: &Drives) -> Result<Vec<Drive>, Reported> {
    let file = &site.file;
    let mut found: Vec<Drive> = Vec::new();
    let mut sound = true;
    for id in listed(site) {
        let one = match &file.tree.expr(id).kind {
            ExprKind::Name(name) => named_drive(stage, file, id, name, drives),
            _ => {
                let message = "`drive` is the name of a drive, or a list of names";
                Err(stage.mistakes.report(file, Code::WrongForm, file.span(id), message, "", None))
            }
        };
        sound &= one.is_ok();
        found.extend(one);
    }
    if found.is_empty() && sound {
        let message = "a fit needs a drive";
        return Err(stage.mistakes.report(file, Code::WrongForm, file.span(site.id), message, "none", None));
    }
    if sound { Ok(found) } else { Err(Reported) }
}

fn named_drive(
    stage: &mut Stage,
    file: &File,
    id: ExprId,
    name: &str,
    drives: &Drives,
) -> Result<Drive, Reported> {
    match drives.get(name) {
        // `None`: what is wrong with the drive has been reported there.
        Some(drive) => drive.clone().ok_or(Reported),
        None => {
            let names: Vec<&str> = drives.keys().map(String::as_str).collect();
            let help = match nearest(name, names.iter().copied()) {
                Some(meant) => Some(format!("write `{meant}`")),
                None if names.is_empty() => {
                    Some("write `drive name { material = …  path = … }` in this file".into())
                }
                None => Some(format!("the drives are {}", names.join(", "))),
            };
            let message = format!("there is no drive `{name}`");
            let span = file.span(id);
            Err(stage.mistakes.report(file, Code::UnknownName, span, message, "not declared", help))
        }
    }
}

fn sets(stage: &mut Stage, site: &Site, drives: &[Drive]) -> Result<Vec<FitSet>, Reported> {
    let tables = listed(site);
    if tables.len() != drives.len() {
        let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let message = format!(
            "each drive has its own table: {} for {}",
            count(tables.len(), "table"),
            count(drives.len(), "drive")
        );
        let file = &site.file;
        return Err(stage.mistakes.report(file, Code::WrongForm, file.span(site.id), message, "", None));
    }
    let mut sets = Vec::new();
    let mut sound = true;
    for (&id, drive) in tables.iter().zip(drives) {
        let set = data::read(stage, &site.file, id, drive);
        sound &= set.is_ok();
        sets.extend(set);
    }
    if sound { Ok(sets) } else { Err(Reported) }
}
