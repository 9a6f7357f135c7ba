//! Drives: a material point, its path, what is recorded, what must hold.
//!
//! Owns the reading of a `drive`. Tables, plots and expectations are those of a scene.

mod frame;
mod path;
mod record;
mod scope;
mod target;

pub(super) use record::probe_of;

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::materials::used;
use super::members::Members;
use super::model::{Coordinate, Drive, Material, Path, PathControl, PointRecord, VolumeChange};
use super::scenes::Stage;
use super::session::{Module, Session, Wanted};
use super::words::DRIVE;
use crate::expression::{Node, Tape};
use crate::syntax::{Block, Code, Name};
use std::rc::Rc;

/// Reads a drive.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
) -> Result<Drive, Reported> {
    let (before, wanted) = (session.mistakes.len(), session.wanted);
    let members =
        Members::read_with(&mut session.mistakes, file, &DRIVE, block, &session.overrides, &[&name.text]);
    let mut stage = Stage::new(session, file, name, module, &members);
    let required = |stage: &mut Stage, key| members.required(stage.mistakes, file, &DRIVE, block, key);
    let material = required(&mut stage, "material")
        .and_then(|site| used(stage.mistakes, stage.overrides, stage.materials, &site));
    let volume = match members.written("volume") {
        Some(site) => stage.choice(site, &DRIVE, "volume").map(volume),
        None => Ok(VolumeChange::Compressible),
    };
    let directions = material.clone().and_then(|material| point_directions(&mut stage, &members, &material));
    let way =
        required(&mut stage, "path").and_then(|site| path::read(&mut stage, &site, material.as_deref().ok()));
    if let (Ok(way), Ok(VolumeChange::Incompressible)) = (&way, &volume) {
        refuse_undetermined(&mut stage, way);
    }
    let records = records(&mut stage, &members, way.as_ref().ok());
    // Without a path nothing is known of the columns.
    if way.is_ok() {
        for inner in members.blocks.iter().filter(|inner| inner.kind.text == "plot") {
            let _ = stage.plot(inner);
        }
        for entry in members.expects.iter().filter(|_| wanted == Wanted::All) {
            let _ = stage.expectation(entry);
        }
    }
    let (plots, expectations) =
        (std::mem::take(&mut stage.scene.plots), std::mem::take(&mut stage.scene.expectations));
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    let way = way?;
    Ok(Drive {
        name: name.text.clone(),
        place: file.place(&name.span),
        material: Material::clone(&*material?),
        directions: directions?,
        axes: way.axes,
        path: way.path,
        written: way.written,
        parameter: way.parameter,
        unit: way.dimension.si_symbol(),
        range: way.range,
        steps: way.steps,
        volume: volume?,
        records,
        plots,
        expectations,
    })
}

fn volume(word: &str) -> VolumeChange {
    if word == "incompressible" { VolumeChange::Incompressible } else { VolumeChange::Compressible }
}

/// The directions the law reads, which a point without a place must know.
fn point_directions(
    stage: &mut Stage,
    members: &Members,
    material: &Material,
) -> Result<Vec<[f64; 3]>, Reported> {
    let mut directions = Vec::new();
    for direction in &material.directions {
        match constants(&direction.components) {
            Some(components) => directions.push(components),
            None => {
                let Some(site) = members.written("material") else { return Err(Reported) };
                let message = format!(
                    "a drive has no place, but the direction `{}` of `{}` depends on it",
                    direction.name, material.name
                );
                let span = site.file.span(site.id);
                let help = Some("drive a material whose directions are fixed".into());
                return Err(stage.mistakes.report(&site.file, Code::WrongForm, span, message, "", help));
            }
        }
    }
    Ok(directions)
}

/// Three components that are numbers.
fn constants(components: &[Tape<Coordinate>; 3]) -> Option<[f64; 3]> {
    let value = |tape: &Tape<Coordinate>| match tape.nodes() {
        [Node::Constant(value)] => Some(*value),
        _ => None,
    };
    match components.each_ref().map(value) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    }
}

/// Refuses a path that leaves no condition for the pressure of an incompressible law.
fn refuse_undetermined(stage: &mut Stage, way: &path::Way) {
    let Path::Deformation(components) = &way.path else { return };
    if components.iter().flatten().all(|control| matches!(control, PathControl::Deformation(_))) {
        let message =
            "all of F is prescribed, so the stress of an incompressible law is known but for a pressure";
        let help =
            Some("write `free` for the component that is not held, for example in the place of zz".into());
        stage.mistakes.report(&way.site.file, Code::Conflict, way.span.clone(), message, "", help);
    }
}

fn records(stage: &mut Stage, members: &Members, way: Option<&path::Way>) -> Vec<PointRecord> {
    let mut records = Vec::new();
    for inner in &members.blocks {
        match inner.kind.text.as_str() {
            "record" => match way {
                Some(way) => records.extend(record::read(stage, inner, way)),
                None => {
                    let _ = stage.output_name(inner);
                }
            },
            "plot" => {}
            _ => {
                let file = Rc::clone(&stage.file);
                unknown_block(stage.mistakes, &file, inner, Some(DRIVE.word));
            }
        }
    }
    records
}
