//! What must hold of any state: bodies that are bodies, positive volumes, numbers, F the gradient of the positions.
//!
//! Owns these and their bounds. Knows no text and no history.

use super::watch::{Fault, fault};
use tissue::monitor::involutions;
use tissue::solver::{BodyState, Simulation};
use tissue::tensor::Vec3;

/// What set-up hands to the time loop is a body: nodes of positive volume, areas, weights and a step that are numbers.
pub fn sound(bodies: &[BodyState]) -> Result<(), Fault> {
    for body in bodies {
        let bad = body.particles.volume.iter().position(|volume| !(*volume > 0.0 && volume.is_finite()));
        if let Some(a) = bad {
            return Err(fault(
                "volume",
                format!("{} m^3 at particle {a} of {}", body.particles.volume[a], body.name),
            ));
        }
        let unsound = |a: usize| {
            let row = body.links.row(a);
            let pairs = body.links.forward[row.clone()].iter().zip(&body.links.pair[row]);
            !pairs.flat_map(|(forward, pair)| forward.iter().chain(&pair.backward)).all(|g| g.is_finite())
        };
        if let Some(a) = (0..body.len()).find(|a| unsound(*a)) {
            let neighbours = body.links.row(a).len();
            let found =
                format!("a weight is no number at particle {a} of {}, {neighbours} neighbours", body.name);
            return Err(fault("weights", found));
        }
        // half steps of a pair, twice
        let closest = |a: usize| {
            let pairs = &body.links.pair[body.links.row(a)];
            pairs.iter().map(|pair| 2.0 * Vec3::from(pair.half_step).norm()).fold(f64::INFINITY, f64::min)
        };
        let (a, least) = (0..body.len())
            .map(|a| (a, closest(a)))
            .fold((0, f64::INFINITY), |x, y| if y.1 < x.1 { y } else { x });
        if !(least > 1e-3 * body.particles.spacing) {
            let x = body.particles.position[a];
            return Err(fault(
                "coincident",
                format!("{least:.2e} m to the nearest of particle {a} of {}, {x:?}", body.name),
            ));
        }
        let mut areas = body.particles.faces.iter().flat_map(|face| &face.area);
        if !areas.all(|n| n.norm().is_finite()) {
            return Err(fault("area", format!("an area of {} is no number", body.name)));
        }
        if !body.elastic_length.is_finite() || !body.rates.shared.is_finite() {
            let found = format!("{} m, {} 1/s of {}", body.elastic_length, body.rates.shared, body.name);
            return Err(fault("rate", found));
        }
    }
    Ok(())
}

/// No particle is turned inside out, nothing of the state is no number.
pub fn admissible(bodies: &[BodyState]) -> Result<(), Fault> {
    for body in bodies {
        for a in 0..body.len() {
            let j = body.j(a).unwrap_or_else(|| body.f(a).determinant());
            if !(j > 0.0) {
                return Err(fault(
                    "jacobian",
                    format!("J = {j} at particle {a} of {} and no error", body.name),
                ));
            }
            let numbers = body.x[a].0.iter().chain(&body.v[a].0).chain(&body.acceleration[a].0);
            if !numbers.chain(body.stress(a).iter()).all(|number| number.is_finite()) {
                return Err(fault("finite", format!("particle {a} of {}", body.name)));
            }
        }
    }
    Ok(())
}

/// What solving for the gradients leaves of `Grad X = I`: round-off times the condition of the moments, which set-up
/// lets be 1e9 at most.
const SOLVED: f64 = 2.2e-7;

/// How far F is from the gradient of the positions at the start.
pub fn initial_gap(simulation: &Simulation) -> Result<f64, Fault> {
    let found = involutions(simulation.bodies()).gradient;
    if found <= SOLVED {
        return Ok(found);
    }
    Err(fault("reproduction", format!("|Grad X - I| = {found:.2e} at the start")))
}

/// F is the gradient of the positions but for round-off and what it was at the start.
///
/// Both add up the same velocities; each step rounds a position, at most as large as the body and its place, and a row of
/// products of that with the weights, whose sum of magnitudes is `g`.
pub fn gradients(simulation: &Simulation, gap: f64, of_area: bool) -> Result<(), Fault> {
    let involutions = involutions(simulation.bodies());
    let found = if of_area { involutions.area_map } else { involutions.gradient };
    let of = |body: &BodyState| {
        let rows = (0..body.len()).map(|a| {
            let row = body.links.row(a);
            let sum: f64 = body.links.forward[row].iter().map(|g| Vec3::from(*g).norm()).sum();
            sum * body.inverse_volume[a]
        });
        let far = body.x.iter().map(|x| x.vector().norm()).fold(0.0, f64::max);
        rows.fold(0.0, f64::max) * far
    };
    let largest = simulation.bodies().iter().map(of).fold(0.0, f64::max);
    let stretch = simulation.bodies().iter().flat_map(|body| (0..body.len()).map(|a| body.f(a).norm()));
    let allowed = 2.0 * f64::EPSILON * (simulation.evaluations() + 2) as f64 * largest
        + gap * stretch.fold(1.0, f64::max);
    if found <= allowed {
        return Ok(());
    }
    Err(fault("gradient", format!("|F - Grad x| = {found:.2e}, {allowed:.2e} from round-off")))
}
