//! `vary = [material.parameter, …]`.

use super::super::file::{File, Reported};
use super::super::members::{Site, ambiguous};
use super::super::model::{Drive, Material, MaterialParameter, Sought};
use super::super::scenes::Stage;
use super::listed;
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind};

/// The parameters sought.
pub(super) fn read(stage: &mut Stage, site: &Site, drives: &[Drive]) -> Result<Vec<Sought>, Reported> {
    let mut varied: Vec<Sought> = Vec::new();
    let mut sound = true;
    for id in listed(site) {
        let one = parameter(stage, &site.file, id, drives);
        sound &= one.is_ok();
        let Ok(one) = one else { continue };
        if varied.iter().any(|known| known.material == one.material && known.index == one.index) {
            let message = format!("`{}` is varied twice", one.name);
            let span = site.file.span(id);
            stage.mistakes.report(&site.file, Code::DuplicateName, span, message, "here again", None);
            sound = false;
        } else {
            varied.push(one);
        }
    }
    if varied.is_empty() && sound {
        let message = "a fit without a parameter has nothing to find";
        let span = site.file.span(site.id);
        return Err(stage.mistakes.report(&site.file, Code::WrongForm, span, message, "none", None));
    }
    if sound { Ok(varied) } else { Err(Reported) }
}

fn parameter(stage: &mut Stage, file: &File, id: ExprId, drives: &[Drive]) -> Result<Sought, Reported> {
    let span = file.span(id);
    let written: String = file.expression(id).split_whitespace().collect();
    let materials = materials(drives);
    let split = written.split_once('.').filter(|_| is_path(file, id));
    let Some((material_name, parameter_name)) = split else {
        let message = "a parameter is named with its material";
        let example = materials.first().and_then(|material| {
            Some(format!("{}.{}", material.name, short(&material.parameters.first()?.name)))
        });
        let help = example.map(|example| format!("write it as in `{example}`"));
        return Err(stage.mistakes.report(file, Code::WrongForm, span, message, "", help));
    };
    let Some(material) = materials.iter().find(|material| material.name == material_name) else {
        let names: Vec<&str> = materials.iter().map(|material| material.name.as_str()).collect();
        let message = format!("no drive of this fit is of a material `{material_name}`");
        let help = match nearest(material_name, names.iter().copied()) {
            Some(meant) => format!("write `{meant}.{parameter_name}`"),
            None => format!("the drives are of {}", names.join(", ")),
        };
        return Err(stage.mistakes.report(file, Code::UnknownName, span, message, "", Some(help)));
    };
    let index = index(stage, file, id, material, parameter_name)?;
    let found = &material.parameters[index];
    if found.turns_direction {
        let message = format!("`{written}` turns a direction of the material, which a fit cannot vary");
        let help = Some("fit the other parameters at several angles and compare".into());
        return Err(stage.mistakes.report(file, Code::WrongForm, span, message, "", help));
    }
    Ok(Sought {
        name: written,
        material: material.name.clone(),
        index,
        start: found.value,
        unit: found.unit.clone(),
        range: found.range,
    })
}

/// Whether an expression is a dotted name, the last part possibly an element of an array.
fn is_path(file: &File, id: ExprId) -> bool {
    match &file.tree.expr(id).kind {
        ExprKind::Name(_) => true,
        ExprKind::Member { base, .. } | ExprKind::Index { base, .. } => is_path(file, *base),
        _ => false,
    }
}

/// The materials of the drives, each once.
fn materials(drives: &[Drive]) -> Vec<&Material> {
    let mut materials: Vec<&Material> = Vec::new();
    for drive in drives {
        if materials.iter().all(|known| known.name != drive.material.name) {
            materials.push(&drive.material);
        }
    }
    materials
}

/// A parameter's name without the energy it belongs to.
fn short(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, last)| last)
}

/// The parameter meant by `goh.kappa`, or by `kappa` where only one has that name.
fn index(
    stage: &mut Stage,
    file: &File,
    id: ExprId,
    material: &Material,
    written: &str,
) -> Result<usize, Reported> {
    let all = || material.parameters.iter().map(|parameter: &MaterialParameter| parameter.name.as_str());
    if let Some(index) = all().position(|name| name == written) {
        return Ok(index);
    }
    let meant: Vec<usize> =
        all().enumerate().filter(|(_, name)| short(name) == written).map(|(index, _)| index).collect();
    let span = file.span(id);
    match meant.as_slice() {
        [one] => Ok(*one),
        [] => {
            let message =
                format!("the material `{}` has no parameter `{written}` with a value", material.name);
            let shorts: Vec<&str> = all().map(short).collect();
            let near = nearest(written, all()).or_else(|| nearest(written, shorts.iter().copied()));
            let help = match near {
                Some(near) => format!("write `{}.{near}`", material.name),
                None => format!("its parameters are {}", all().collect::<Vec<_>>().join(", ")),
            };
            Err(stage.mistakes.report(file, Code::UnknownName, span, message, "", Some(help)))
        }
        several => {
            let full = |&index: &usize| format!("{}.{}", material.name, material.parameters[index].name);
            let meant: Vec<String> = several.iter().map(full).collect();
            let (message, help) = ambiguous(&format!("{}.{written}", material.name), &meant);
            Err(stage.mistakes.report(file, Code::WrongForm, span, message, "", Some(help)))
        }
    }
}
