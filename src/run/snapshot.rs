//! A state as a frame.
//!
//! Owns the choice of fields by name; a scene has already checked the names.

use crate::monitor::{cauchy_stress, field_value, von_mises};
use crate::output::{Frame, FrameField};
use crate::scene::Field;
use crate::solver::{BodyState, Simulation};
use crate::tensor::{Mat3, Vec3};

/// The fields of all particles at the current time.
pub fn frame(simulation: &Simulation, values: &[String], provenance: &[String]) -> Frame {
    let bodies = simulation.bodies();
    let each = || bodies.iter().flat_map(|body| (0..body.len()).map(move |a| (body, a)));
    let scalar = |field: Field| -> Vec<f64> { each().map(|(body, a)| field_value(body, a, field)).collect() };
    let tensor =
        |value: fn(&BodyState, usize) -> Mat3| -> Vec<Mat3> { each().map(|(b, a)| value(b, a)).collect() };
    let velocity = || -> Vec<Vec3> { each().map(|(body, a)| body.v[a].vector()).collect() };
    let stresses = || -> Vec<f64> { each().map(|(b, a)| von_mises(&cauchy_stress(b, a))).collect() };
    let mut fields: Vec<FrameField> = values
        .iter()
        .filter_map(|name| match name.as_str() {
            "velocity" => Some(FrameField::vector(name, "m/s", &velocity())),
            "sigma" => Some(FrameField::symmetric(name, "Pa", &tensor(cauchy_stress))),
            "P" => Some(FrameField::tensor(name, "Pa", &tensor(BodyState::stress))),
            "F" => Some(FrameField::tensor(name, "", &tensor(|body, a| *body.f(a)))),
            "von_mises" => Some(FrameField::scalar(name, "Pa", &stresses())),
            "pressure" => Some(FrameField::scalar(name, "Pa", &scalar(Field::Pressure))),
            "J" => Some(FrameField::scalar(name, "", &scalar(Field::J))),
            _ => None,
        })
        .collect();
    if bodies.len() > 1 {
        let number =
            bodies.iter().enumerate().flat_map(|(k, body)| std::iter::repeat_n(k as f64, body.len()));
        fields.push(FrameField::scalar("body", "", &number.collect::<Vec<f64>>()));
    }
    Frame {
        time: simulation.time(),
        reference: each().map(|(body, a)| body.particles.position[a]).collect(),
        displacement: each().map(|(b, a)| b.x[a].vector() - b.particles.position[a]).collect(),
        hexahedra: cells(bodies),
        fields,
        provenance: provenance.to_vec(),
    }
}

/// Cells of the background grids, the corners counted through all bodies.
fn cells(bodies: &[BodyState]) -> Vec<[usize; 8]> {
    let mut first = 0;
    let mut cells = Vec::new();
    for body in bodies {
        cells.extend(body.particles.cells.iter().map(|cell| cell.map(|corner| first + corner as usize)));
        first += body.len();
    }
    cells
}
