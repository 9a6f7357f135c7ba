//! `check material { … }`: what must hold of a law.

use super::blocks::unknown_block;
use super::file::{File, Reported};
use super::members::{Members, Site};
use super::model::{Check, Material};
use super::scenes::Stage;
use super::session::{Module, Session};
use super::words::CHECK;
use crate::schema::nearest;
use crate::syntax::{BinaryOperator, Block, Code, ExprKind, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// Largest stretch that can be asked about, and the inverse of the smallest.
const LARGEST: f64 = 100.0;

/// Reads a check.
///
/// # Errors
/// [`Reported`] if anything is wrong with it.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    module: &Module,
) -> Result<Check, Reported> {
    let before = session.mistakes.len();
    let members = Members::read(&mut session.mistakes, file, &CHECK, block);
    let mut stage = Stage::new(session, file, name, module, &members);
    for inner in &members.blocks {
        unknown_block(stage.mistakes, file, inner, Some(CHECK.word));
    }
    let material = material(&mut stage, file, name);
    let require = members
        .required(stage.mistakes, file, &CHECK, block, "require")
        .and_then(|site| required(&mut stage, &site));
    let stretches = members.written("over").map(|site| stretches(&mut stage, site)).transpose();
    if session.mistakes.len() > before {
        return Err(Reported);
    }
    Ok(Check {
        place: file.place(&block.kind.span),
        material: Material::clone(&*material?),
        require: require?.into_iter().map(String::from).collect(),
        stretches: stretches?,
    })
}

fn material(stage: &mut Stage, file: &File, name: &Name) -> Result<Rc<Material>, Reported> {
    match stage.materials.get(&name.text) {
        // `None`: what is wrong with the material has been reported there.
        Some(declared) => declared.as_ref().map(|declared| Rc::clone(&declared.material)).ok_or(Reported),
        None => {
            let names: Vec<&str> = stage.materials.keys().map(String::as_str).collect();
            let help = match nearest(&name.text, names.iter().copied()) {
                Some(meant) => Some(format!("write `check {meant} {{ … }}`")),
                None if names.is_empty() => None,
                None => Some(format!("the materials are {}", names.join(", "))),
            };
            let message = format!("there is no material `{}`", name.text);
            let span = name.span.clone();
            Err(stage.mistakes.report(file, Code::UnknownName, span, message, "not declared", help))
        }
    }
}

fn required(stage: &mut Stage, site: &Site) -> Result<Vec<&'static str>, Reported> {
    let words = stage.chosen_list(site, &CHECK, "require")?;
    if words.is_empty() {
        let message = "a check requires something";
        let help = Some("write `require = [stress_free, objective, elliptic]`".into());
        let span = site.file.span(site.id);
        return Err(stage.mistakes.report(&site.file, Code::WrongForm, span, message, "nothing", help));
    }
    Ok(words)
}

/// `stretches(0.85 .. 1.25)`
fn stretches(stage: &mut Stage, site: &Site) -> Result<[f64; 2], Reported> {
    let file = Rc::clone(&site.file);
    let range = match &file.tree.expr(site.id).kind {
        ExprKind::Call { function, arguments } if function.text == "stretches" && arguments.len() == 1 => {
            match &file.tree.expr(arguments[0].value).kind {
                ExprKind::Binary { operator: BinaryOperator::Range, left, right, .. } => {
                    Some((*left, *right))
                }
                _ => None,
            }
        }
        _ => None,
    };
    let Some((left, right)) = range else {
        let message = "`over` is a range of stretches";
        let help = Some("write `over = stretches(0.85 .. 1.25)`".into());
        return Err(stage.mistakes.report(&file, Code::WrongForm, file.span(site.id), message, "", help));
    };
    let mut end = |id| {
        let site = Site { file: Rc::clone(&file), id };
        stage.constant(&site, "stretches", Dimension::NUMBER)
    };
    let (low, high) = (end(left), end(right));
    let (low, high) = (low?, high?);
    if low > 1.0 / LARGEST && low <= 1.0 && (1.0..LARGEST).contains(&high) && low < high {
        return Ok([low, high]);
    }
    let message = format!(
        "stretches run from compression to tension, 0.01 < low <= 1 <= high < 100, but these are {low} and {high}"
    );
    let span = file.span(site.id);
    Err(stage.mistakes.report(&file, Code::ParameterOutOfRange, span, message, "outside", None))
}
