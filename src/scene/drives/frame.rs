//! The axes of a path.

use super::super::evaluate::{Elsewhere, Evaluator, Required};
use super::super::file::Reported;
use super::super::members::Site;
use super::super::model::{Material, PathParameter};
use super::super::scenes::Stage;
use super::constants;
use super::scope::PathScope;
use crate::syntax::{Code, Diagnostic, ExprId};
use crate::tensor::Vec3;
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// How far from unit length or a right angle a direction may be written: six digits.
const WRITTEN: f64 = 1e-6;

/// Directions by name: the common axes, then those of the material, which go first.
pub(super) fn named(material: Option<&Material>) -> BTreeMap<String, [f64; 3]> {
    let axes = [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];
    let mut named: BTreeMap<String, [f64; 3]> =
        axes.into_iter().map(|(name, axis)| (name.to_string(), axis)).collect();
    for direction in material.iter().flat_map(|material| material.frame.iter().chain(&material.directions)) {
        match constants(&direction.components) {
            Some(components) => named.insert(direction.name.clone(), components),
            // It depends on place: unknown here, rather than the common axis of the same name.
            None => named.remove(&direction.name),
        };
    }
    named
}

/// The first two axes from the directions written: none, one or two.
pub(super) fn axes(
    stage: &mut Stage,
    site: &Site,
    named: &BTreeMap<String, [f64; 3]>,
    written: &[ExprId],
) -> Result<[[f64; 3]; 2], Reported> {
    let directions: Vec<Result<Vec3, Reported>> =
        written.iter().map(|id| direction(stage, site, named, *id)).collect();
    let directions: Vec<Vec3> = directions.into_iter().collect::<Result<_, _>>()?;
    let (first, second) = match directions.as_slice() {
        [] => (Vec3::x(), Vec3::y()),
        [first] => (*first, beside(first)),
        [first, second, ..] => (*first, *second),
    };
    let slope = first.dot(&second);
    if slope.abs() > WRITTEN {
        let angle = libm::acos(slope.clamp(-1.0, 1.0)).to_degrees();
        let message =
            format!("the directions of a path must be at a right angle, but theirs is {angle:.4} deg");
        let diagnostic = Diagnostic::new(Code::WrongForm, message, site.file.span(written[1]), "")
            .with_label(site.file.span(written[0]), "");
        return Err(stage.mistakes.push(&site.file, diagnostic));
    }
    // Exact where it was written to six digits.
    let second = (second - slope * first).normalize();
    Ok([first.into(), second.into()])
}

/// A direction at a right angle to the only one given: the next common axis after its largest component.
fn beside(first: &Vec3) -> Vec3 {
    let next = Vec3::ith((first.iamax() + 1) % 3, 1.0);
    (next - first.dot(&next) * first).normalize()
}

fn direction(
    stage: &mut Stage,
    site: &Site,
    named: &BTreeMap<String, [f64; 3]>,
    id: ExprId,
) -> Result<Vec3, Reported> {
    let home = PathScope { file: &stage.file, lets: stage.lets.fresh(), directions: named, parameter: None };
    let scope = Elsewhere { outer: &home, file: Rc::clone(&site.file) };
    let mut evaluator = Evaluator::<PathParameter>::new(stage.mistakes);
    let required = Required { name: "direction", dimension: Dimension::NUMBER };
    let vector = Vec3::from(evaluator.constant_vector(&scope, id, required)?);
    let length = vector.norm();
    if (length - 1.0).abs() <= WRITTEN {
        return Ok(vector / length);
    }
    let message = format!("a direction must be of length 1, but its length is {length:.4}");
    let help = (length > 0.0)
        .then(|| format!("write `unit({})` if the direction is meant", site.file.expression(id)));
    let label = format!("length {length:.4}");
    Err(stage.mistakes.report(&site.file, Code::NotUnitLength, site.file.span(id), message, label, help))
}
