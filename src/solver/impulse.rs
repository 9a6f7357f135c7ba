//! What supports and loads give to the momentum of a body.
//!
//! Owns the sums over time. They follow the integrator's own weights, so that momentum and impulse
//! balance to round-off. Knows no stage and no material.

use super::body::BodyState;
use super::constraint::Support;
use super::loads::ExternalForces;
use super::quad::Quad;
use crate::tensor::Vec3;

/// Impulses on one body since the start, kg m/s.
#[derive(Debug, Clone, Default)]
pub struct Impulses {
    live: bool,
    /// Face and component of each support, and the impulse of its reaction.
    reactions: Vec<(String, usize, f64)>,
    /// Face of each load, `None` if it acts on the whole body, and its impulse.
    loads: Vec<(Option<String>, Vec3)>,
    /// Impulse of everything external, the forces of an exact motion included.
    external: Vec3,
}

impl Impulses {
    /// Zero impulses of the supports and loads of a body; nothing is summed unless `live`.
    pub fn new(live: bool, body: &BodyState, external: &ExternalForces) -> Self {
        if !live {
            return Self::default();
        }
        let reactions =
            body.supports.iter().map(|support| (support.face.clone(), support.axis, 0.0)).collect();
        let loads = external.totals().map(|(face, _)| (face.map(String::from), Vec3::zeros())).collect();
        Self { live, reactions, loads, external: Vec3::zeros() }
    }

    /// Adds what a support is about to change of the momentum.
    ///
    /// ```text
    /// I_i += w Σ_a ρR V_a (v_prescribed − v_a)_i
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `index` | of the support in its body | |
    /// | `weight` | `w`, the share of the stage in the step | – |
    /// | `density` | `ρR` | kg/m³ |
    /// | `volume`, `velocity` | of all particles of the body, before the support acts | m³, m/s |
    /// | `step` | the step under way | s |
    /// | `support` | what is about to act | |
    #[expect(clippy::too_many_arguments, reason = "a pass takes the arrays it reads")]
    pub fn add_reaction(
        &mut self,
        index: usize,
        weight: f64,
        density: f64,
        volume: &[f64],
        velocity: &[Quad],
        step: f64,
        support: &Support,
    ) {
        if !self.live || weight == 0.0 {
            return;
        }
        let change: f64 = support
            .nodes
            .iter()
            .enumerate()
            .map(|(i, &node)| {
                let a = node as usize;
                volume[a] * (support.velocity(i, step) - velocity[a].0[support.axis])
            })
            .sum();
        self.reactions[index].2 += weight * density * change;
    }

    /// Adds what support number `index` changed of the momentum of nodes bonded to its own, kg m/s.
    pub fn add_carried(&mut self, index: usize, momentum: f64) {
        if self.live {
            self.reactions[index].2 += momentum;
        }
    }

    /// Adds the loads of the last evaluation over a time `step`, s.
    pub fn add_loads(&mut self, step: f64, body: &BodyState, external: &ExternalForces) {
        if self.live {
            for (force, &volume) in body.external.iter().zip(&body.particles.volume) {
                self.external += force.vector() * (volume * step);
            }
            for ((_, sum), (_, force)) in self.loads.iter_mut().zip(external.totals()) {
                *sum += force * step;
            }
        }
    }

    /// Component of the impulse of what acts on a face, or on the whole body, kg m/s.
    pub fn of(&self, face: Option<&str>, axis: usize) -> f64 {
        let reactions = self
            .reactions
            .iter()
            .filter(|(on, component, _)| *component == axis && face.is_none_or(|face| face == on));
        let reaction: f64 = reactions.map(|(.., impulse)| impulse).sum();
        match face {
            None => reaction + self.external[axis],
            Some(_) => {
                let loads = self.loads.iter().filter(|(on, _)| on.as_deref() == face);
                reaction + loads.map(|(_, sum)| sum[axis]).sum::<f64>()
            }
        }
    }
}
