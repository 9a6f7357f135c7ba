//! Sweeps and trades: what varies, what is read at each point, what must hold.
//!
//! Owns the reading of a `sweep` and of a `trade`. What they compute is described by resolving the file
//! once more for every combination of values, so a point of a sweep is exactly what `--set` gives.

mod plot;
mod points;
mod record;
mod trade;
mod vary;

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::loader::Loader;
use super::members::Members;
use super::model::{Document, Sweep, Swept};
use super::scenes::Stage;
use super::session::{Module, Session};
use super::words::SWEEP;
use crate::schema::nearest;
use crate::syntax::{Block, Code, ExprKind, Name};
use std::rc::Rc;

/// What a sweep needs to describe its points: everything the file itself is resolved from.
pub(super) struct Setting<'a> {
    pub(super) loader: &'a dyn Loader,
    pub(super) overrides: &'a [(String, String)],
    pub(super) document: &'a Document,
    /// Names of scenes and drives that are there but have mistakes.
    pub(super) broken: &'a [String],
}

/// Reads a sweep.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
    setting: &Setting<'_>,
) -> Result<Sweep, Reported> {
    if block.kind.text != SWEEP.word {
        return trade::read(session, file, block, name, module, setting);
    }
    let before = session.mistakes.len();
    let members = Members::read(&mut session.mistakes, file, &SWEEP, block);
    let of = members
        .required(&mut session.mistakes, file, &SWEEP, block, "of")
        .and_then(|site| target(session, file, site.id, setting));
    let varied = vary::read(session, file, block, name, &members);
    let (of, varied) = (of?, varied?);
    let points = points::describe(session, file, &of, &varied, setting)?;
    let varied: Vec<_> = varied.into_iter().map(|entry| entry.varied).collect();
    let mut stage = Stage::new(session, file, name, module, &members);
    let records = record::read(&mut stage, &members, &varied, &points[0].swept);
    stage.varied = varied.iter().map(|varied| varied.column.clone()).collect();
    stage.abscissa.clone_from(&varied[0].column);
    for entry in &members.expects {
        let _ = claim(&mut stage, file, entry, &varied);
    }
    let plots = plot::read(&mut stage, &members, &points[0].swept);
    for inner in &members.blocks {
        if !matches!(inner.kind.text.as_str(), "record" | "plot") {
            unknown_block(stage.mistakes, file, inner, Some(SWEEP.word));
        }
    }
    let expectations = std::mem::take(&mut stage.scene.expectations);
    if records.is_empty() && plots.is_empty() && session.mistakes.len() == before {
        let message = format!("`sweep {}` reads nothing from its points", name.text);
        let help = Some("write `record table { … }` or a `plot` with what is to be compared".into());
        return Err(session.mistakes.report(file, Code::MissingKey, name.span.clone(), message, "", help));
    }
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    Ok(Sweep {
        name: name.text.clone(),
        place: file.place(&name.span),
        of,
        varied,
        points,
        records,
        plots,
        expectations,
        trade: None,
    })
}

/// One claim of a sweep; between its points only a single varied quantity can be read.
fn claim(
    stage: &mut Stage,
    file: &Rc<File>,
    entry: &super::members::ExpectEntry,
    varied: &[super::model::Varied],
) -> Result<(), Reported> {
    if let Some(at) = &entry.at
        && (varied.len() > 1 || !varied[0].is_quantity)
    {
        let message =
            "a place between points is read along one varied quantity, which this sweep does not have";
        let help = Some("claim it of `max(record.column)` or `min(record.column)`".into());
        return Err(stage.mistakes.report(file, Code::WrongForm, file.span(at.key), message, "", help));
    }
    stage.expectation(entry)
}

/// The name of the scene or drive that is swept.
fn target(
    session: &mut Session,
    file: &Rc<File>,
    id: crate::syntax::ExprId,
    setting: &Setting<'_>,
) -> Result<String, Reported> {
    let document = setting.document;
    let scenes = document.scenes.iter().map(|scene| scene.name.as_str());
    let known: Vec<&str> = scenes.chain(document.drives.iter().map(|drive| drive.name.as_str())).collect();
    let ExprKind::Name(name) = &file.tree.expr(id).kind else {
        let message = "`of` is the name of a scene or of a drive";
        return Err(session.mistakes.report(file, Code::WrongForm, file.span(id), message, "", None));
    };
    if known.contains(&name.as_str()) {
        return Ok(name.clone());
    }
    // What is wrong with it has been reported there.
    if setting.broken.contains(name) {
        return Err(Reported);
    }
    let help = match nearest(name, known.iter().copied()) {
        Some(meant) => Some(format!("write `{meant}`")),
        None if known.is_empty() => {
            Some("write `scene name { … }` or `drive name { … }` in this file".into())
        }
        None => Some(format!("the scenes and drives are {}", known.join(", "))),
    };
    let message = format!("there is no scene or drive `{name}` in this file");
    Err(session.mistakes.report(file, Code::UnknownName, file.span(id), message, "not declared", help))
}

impl Swept {
    /// Its tables: name, and name and SI unit of each column, the ordering one first.
    pub(super) fn tables(&self) -> Vec<(&str, Vec<(&str, &str)>)> {
        match self {
            Self::Scene(scene) => scene
                .records
                .iter()
                .map(|record| {
                    let own =
                        record.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str()));
                    (record.name.as_str(), std::iter::once(("t", "s")).chain(own).collect())
                })
                .collect(),
            Self::Drive(drive) => drive
                .records
                .iter()
                .map(|record| {
                    let own =
                        record.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str()));
                    let first = (drive.parameter.as_str(), drive.unit.as_str());
                    (record.name.as_str(), std::iter::once(first).chain(own).collect())
                })
                .collect(),
        }
    }
}
