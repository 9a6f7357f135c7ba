//! Boundary areas that agree with the volumes to second degree.
//!
//! Owns a small change of nodal areas. Knows no kernel.

use super::moments::{Basis, QUADRATIC};
use super::particles::Particles;
use crate::tensor::Vec3;

/// Share of a function's square that must be left after all earlier ones are taken out of it; less is
/// rounding, and the function is one of those.
const INDEPENDENT: f64 = 1e-12;

/// A condition on the changes `s_e` of the entries' shares: `Σ_e ω_e g(e) s_e = missing`.
struct Condition {
    g: Vec<f64>,
    missing: f64,
}

impl Particles {
    /// Changes the nodal areas of every face by the least share that makes
    ///
    /// ```text
    /// Σ_a f(X_a) A_a N_a = Σ_a V_a Grad f(X_a)
    /// ```
    ///
    /// for all quadratic `f` (for linear ones it holds already), which gradients that are exact for
    /// quadratic fields and meet the integration constraint imply. Sums of a face stay as they are. Nothing changes on a
    /// regular lattice: the trapezium rule errs by as much on opposite faces. What no area can balance is left.
    pub(super) fn balance_second_moments(&mut self) {
        let (low, high) = self
            .position
            .iter()
            .fold((Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)), |(low, high), x| {
                (low.inf(x), high.sup(x))
            });
        let centre = 0.5 * (low + high);
        let basis = Basis { inverse_length: 2.0 / (high - low).amax() };
        for axis in 0..3 {
            self.balance(axis, basis, centre);
        }
    }

    fn balance(&mut self, axis: usize, basis: Basis, centre: Vec3) {
        let entries: Vec<(usize, usize)> = self
            .faces
            .iter()
            .enumerate()
            .flat_map(|(face, nodes)| (0..nodes.nodes.len()).map(move |node| (face, node)))
            .collect();
        let area = |&(face, node): &(usize, usize)| self.faces[face].area[node][axis];
        let place =
            |&(face, node): &(usize, usize)| self.position[self.faces[face].nodes[node] as usize] - centre;
        let weight: Vec<f64> = entries.iter().map(|entry| area(entry).abs()).collect();
        let mut conditions: Vec<Condition> = (0..self.faces.len())
            .map(|face| Condition {
                g: entries.iter().map(|entry| if entry.0 == face { 1.0 } else { 0.0 }).collect(),
                missing: 0.0,
            })
            .collect();
        for m in 0..QUADRATIC {
            let g: Vec<f64> = entries.iter().map(|entry| basis.at::<QUADRATIC>(&place(entry))[m]).collect();
            let volumes: f64 = self
                .position
                .iter()
                .zip(&self.volume)
                .map(|(x, v)| v * basis.slope(&(x - centre), m, axis))
                .sum();
            let areas: f64 = entries.iter().zip(&g).map(|(entry, g)| g * area(entry)).sum();
            conditions.push(Condition { g, missing: volumes - areas });
        }
        let share = solve(conditions, &weight);
        for ((&(face, node), share), weight) in entries.iter().zip(&share).zip(&weight) {
            self.faces[face].area[node][axis] += share * weight;
        }
    }
}

/// The `s` of least `Σ ω s²` that meets the conditions, by Gram–Schmidt done twice.
fn solve(conditions: Vec<Condition>, weight: &[f64]) -> Vec<f64> {
    let product =
        |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).zip(weight).map(|((a, b), w)| a * b * w).sum() };
    let mut done: Vec<Condition> = Vec::new();
    let mut share = vec![0.0; weight.len()];
    for Condition { mut g, mut missing } in conditions {
        let whole = product(&g, &g);
        for _ in 0..2 {
            for other in &done {
                let overlap = product(&g, &other.g);
                g.iter_mut().zip(&other.g).for_each(|(g, other)| *g -= overlap * other);
                missing -= overlap * other.missing;
            }
        }
        let left = product(&g, &g);
        if left.is_nan() || left <= INDEPENDENT * whole {
            continue;
        }
        let norm = left.sqrt();
        g.iter_mut().for_each(|g| *g /= norm);
        missing /= norm;
        share.iter_mut().zip(&g).for_each(|(share, g)| *share += missing * g);
        done.push(Condition { g, missing });
    }
    share
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::Shape;

    /// `Σ f A N − Σ V Grad f` for `f = (X · m)²`, over its greatest possible size.
    fn imbalance(particles: &Particles, m: Vec3) -> f64 {
        let areas = particles
            .boundary_area()
            .iter()
            .zip(&particles.position)
            .fold(Vec3::zeros(), |sum, (area, x)| sum + area * x.dot(&m).powi(2));
        let volumes = particles
            .volume
            .iter()
            .zip(&particles.position)
            .fold(Vec3::zeros(), |sum, (volume, x)| sum + m * (2.0 * volume * x.dot(&m)));
        (areas - volumes).amax()
    }

    #[test]
    fn displaced_nodes_balance_and_faces_keep_their_areas() {
        let shape = Shape::Box { min: Vec3::new(-0.1, 0.0, 0.2), max: Vec3::new(0.9, 0.6, 0.6) };
        let m = Vec3::new(0.3, -0.8, 0.5);
        let before = Particles::lattice(&shape, 0.1, [None; 3], 0.3).unwrap();
        let mut after = before.clone();
        after.balance_second_moments();
        assert!(imbalance(&before, m) > 1e-8);
        // sums of a few hundred terms below 0.02
        assert!(imbalance(&after, m) < 1e-15);
        for (old, new) in before.faces.iter().zip(&after.faces) {
            let (old, new): (Vec3, Vec3) = (old.area.iter().sum(), new.area.iter().sum());
            assert!((old - new).amax() < 1e-15);
        }
    }

    #[test]
    fn a_regular_lattice_stays_as_it_is() {
        let shape = Shape::Box { min: Vec3::zeros(), max: Vec3::new(0.8, 0.6, 0.4) };
        let before = Particles::lattice(&shape, 0.1, [Some(0.4), None, None], 0.0).unwrap();
        let mut after = before.clone();
        after.balance_second_moments();
        for (old, new) in before.boundary_area().iter().zip(after.boundary_area()) {
            assert!((old - new).amax() < 1e-16);
        }
    }
}
