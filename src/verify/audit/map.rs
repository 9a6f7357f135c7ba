//! Where a law keeps its waves, as a picture.

use super::{STRETCHES, named, vector};
use crate::energy::Law;
use crate::energy::audit::{Subject, ellipticity};
use crate::output::{Axis, Cell, MapFigure, Provenance};
use crate::scene::Material;
use crate::tensor::{Mat3, Vec3};
use rayon::prelude::*;

/// Cells to a side.
const CELLS: usize = 41;

/// Map of the smallest acoustic eigenvalue over two principal stretches at constant volume, as SVG.
///
/// ```text
/// F = λ1 e1⊗e1 + λ2 e2⊗e2 + 1/(λ1 λ2) e3⊗e3
/// ```
///
/// `e1` is the first named direction of the material, `e2` the part of the next at a right angle to it; x and
/// y for an isotropic law. Crossed out is where strong ellipticity is lost in some direction of travel, grey
/// where the round-off of a stiff tangent hides the smallest eigenvalue.
///
/// # Errors
/// A sentence, if the energy cannot be differentiated or the map not be drawn.
pub fn ellipticity_map(
    material: &Material,
    stretches: Option<[f64; 2]>,
    provenance: &Provenance,
) -> Result<String, String> {
    let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
    let law = Law::compile(&material.energy, &values).map_err(|cause| cause.to_string())?;
    let given: Vec<Vec3> = material.directions.iter().map(vector).collect();
    let subject = Subject { law: &law, directions: &given };
    let [first, second] = axes(material);
    let [low, high] = stretches.unwrap_or(STRETCHES);
    let size = (high - low) / CELLS as f64;
    let middles: Vec<f64> = (0..CELLS).map(|i| low + (i as f64 + 0.5) * size).collect();
    let third = first.1.cross(&second.1);
    let line = |a: &Vec3| a * a.transpose();
    let cell = |along: f64, across: f64| {
        let f: Mat3 = along * line(&first.1) + across * line(&second.1) + line(&third) / (along * across);
        let found = ellipticity(&subject, &f);
        match found.smallest {
            value if value.is_nan() || value.abs() <= found.resolution => Cell::Unknown,
            value if value <= 0.0 => Cell::Lost,
            value => Cell::Value(value),
        }
    };
    let rows = middles.par_iter().map(|&across| middles.iter().map(|&along| cell(along, across)).collect());
    let cells: Vec<Vec<Cell>> = rows.collect();
    let stretch = |name: &str| Axis { label: format!("stretch along {name}"), ..Axis::default() };
    let figure = MapFigure {
        title: format!("{}: strong ellipticity at constant volume", material.name),
        x: stretch(&first.0),
        y: stretch(&second.0),
        value: Axis { label: "smallest acoustic eigenvalue".into(), unit: "Pa".into(), ..Axis::default() },
        across: middles.clone(),
        up: middles,
        cells,
        lost: "lost".into(),
        unknown: "too stiff to tell".into(),
        mark: Some((1.0, 1.0)),
        provenance: provenance.lines(),
    };
    figure.to_svg().map_err(|cause| cause.to_string())
}

/// Two orthonormal axes with their names.
fn axes(material: &Material) -> [(String, Vec3); 2] {
    let all = named(material);
    let (first_name, first) = all[0].clone();
    // The frame says what the axes of the tissue are; fibres are seldom at right angles.
    let frame = material.frame.iter().map(|direction| (direction.name.clone(), vector(direction)));
    let framed: Vec<(String, Vec3)> = frame.collect();
    if let [(a, e1), (b, e2), ..] = framed.as_slice()
        && e1.dot(e2).abs() < 1e-9
    {
        return [(a.clone(), *e1), (b.clone(), *e2)];
    }
    let right_angle = |a: &Vec3| (a - first.dot(a) * first).try_normalize(1e-6);
    let next = all[1..].iter().find_map(|(name, a)| Some((name.clone(), a, right_angle(a)?)));
    match next {
        Some((name, a, across)) if first.dot(a).abs() < 1e-9 => [(first_name, first), (name, across)],
        Some((name, _, across)) => {
            let label = format!("the normal to {first_name} towards {name}");
            [(first_name, first), (label, across)]
        }
        None => {
            let helper: Vec3 = Mat3::identity().column((first.iamax() + 1) % 3).into();
            let across = right_angle(&helper).unwrap_or(Vec3::y());
            let name = if first_name == "x" { "y".into() } else { format!("a normal to {first_name}") };
            [(first_name, first), (name, across)]
        }
    }
}
