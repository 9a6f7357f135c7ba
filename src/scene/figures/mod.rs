//! `figure`: pictures of several runs.
//!
//! Owns the reading of the block and its sources. Pictures are read as those of a scene.

mod source;

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::members::Members;
use super::model::FigureOf;
use super::scenes::Stage;
use super::session::{Module, Session};
use super::words::FIGURE;
use crate::syntax::{Block, Name};
use std::rc::Rc;

/// Pictures in a row where the file says nothing.
const COLUMNS: usize = 2;

/// Reads a figure.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
) -> Result<FigureOf, Reported> {
    let before = session.mistakes.len();
    let members = Members::read(&mut session.mistakes, file, &FIGURE, block);
    let mut read = Vec::new();
    let mut complete = true;
    for inner in members.blocks.iter().filter(|inner| inner.kind.text == "source") {
        match source::read(session, file, inner) {
            Ok(source) => read.push(source),
            Err(Reported) => complete = false,
        }
    }
    let mut stage = Stage::new(session, file, name, module, &members);
    for found in &read {
        if stage.declare_source(found).is_err() {
            complete = false;
        }
    }
    for inner in &members.blocks {
        match inner.kind.text.as_str() {
            "source" => {}
            // without its sources nothing is known of the columns
            "plot" if complete => {
                let _ = stage.plot(inner);
            }
            "plot" => {}
            _ => unknown_block(stage.mistakes, file, inner, Some(FIGURE.word)),
        }
    }
    let number = members
        .required(stage.mistakes, file, &FIGURE, block, "number")
        .and_then(|site| stage.count(&site, "number"));
    let title = members
        .required(stage.mistakes, file, &FIGURE, block, "title")
        .and_then(|_| stage.text(&members, "title"));
    let columns = match members.written("columns") {
        Some(site) => stage.count(site, "columns").map(|count| count as usize),
        None => Ok(COLUMNS),
    };
    let plots = std::mem::take(&mut stage.scene.plots);
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    Ok(FigureOf {
        name: name.text.clone(),
        place: file.place(&name.span),
        number: number?,
        title: title?.unwrap_or_default(),
        columns: columns?,
        sources: read.into_iter().map(|found| found.source).collect(),
        plots,
    })
}
