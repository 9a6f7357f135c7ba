//! Scenes: bodies, what acts on them, what is recorded, what must hold.
//!
//! Owns the order in which the blocks of a scene are read, since a face needs its body and a plot its
//! record.

mod bodies;
mod bonds;
mod conflicts;
mod dimensions;
mod expectations;
mod faces;
mod fields;
mod file_shapes;
mod loads;
mod motions;
mod plots;
mod probe_calls;
mod probes;
mod records;
mod run;
mod samples;
mod scope;
mod shapes;
mod stage;
mod supports;
mod tables;
mod timetable;
mod values;

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::members::Members;
use super::model::Scene;
use super::session::{Module, Session, Wanted};
use super::words::SCENE;
use crate::syntax::{Block, Name};
pub(super) use plots::{column_dimension, column_name, listed};
pub(super) use records::column;
pub use samples::{ERRORS, FITTED};
pub(super) use scope::fixed_quantity;
pub(super) use stage::{Records, Stage};
use std::rc::Rc;
pub(super) use tables::Table;
pub(super) use values::place_of_value;

/// Blocks a scene can have, in the order they are read.
const ORDER: &[&str] = &[
    "body",
    "symmetry",
    "bond",
    "hold",
    "slide",
    "pull",
    "move",
    "traction",
    "pressure",
    "body_force",
    "gravity",
    "start",
    "run",
    "motion",
    "record",
    "frames",
    "plot",
];

/// Reads a scene.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
) -> Result<Scene, Reported> {
    let (before, wanted) = (session.mistakes.len(), session.wanted);
    let members = Members::read(&mut session.mistakes, file, &SCENE, block);
    let mut stage = Stage::new(session, file, name, module, &members);
    for inner in &members.blocks {
        if !ORDER.contains(&inner.kind.text.as_str()) {
            unknown_block(stage.mistakes, file, inner, Some(SCENE.word));
        }
    }
    for kind in ORDER {
        for inner in members.blocks.iter().filter(|inner| inner.kind.text == *kind) {
            // What is wrong has been reported; the rest of the scene is still read.
            let _: Result<(), Reported> = match *kind {
                "body" => stage.body(inner),
                "symmetry" => stage.symmetry(inner),
                "bond" => stage.bond(inner),
                "hold" => stage.hold(inner),
                "slide" => stage.slide(inner),
                "pull" => stage.pull(inner),
                "move" => stage.move_face(inner),
                "traction" => stage.traction(inner),
                "pressure" => stage.pressure(inner),
                "body_force" => stage.body_force(inner),
                "gravity" => stage.gravity(inner),
                "start" => stage.start(inner),
                "run" => stage.run(inner),
                "motion" => stage.motion(inner),
                "record" => stage.record(inner),
                "frames" => stage.frames(inner),
                _ => stage.plot(inner),
            };
        }
    }
    for entry in members.expects.iter().filter(|_| wanted == Wanted::All) {
        let _ = stage.expectation(entry);
    }
    let scene = stage.finish(block);
    if session.mistakes.len() > before { Err(Reported) } else { scene }
}
