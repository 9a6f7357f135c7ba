//! What is live, why, in which order.
//!
//! Owns the decision which fields a scene carries and which passes a stage runs. Drops only what is
//! identically zero or never read; whatever changes the discrete answer is a line of the scene.
//! Knows neither text nor grammar.

mod choice;
mod decide;
mod point;
mod reason;
mod render;

pub use choice::{Choice, RELAXATION_OF_J, choices, damping_rate};
pub use point::{DrivePlan, FitPlan};

use crate::scene::{Formulation, Scene};

/// An array a simulation may carry, one entry a particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// Current position `x`.
    Position,
    /// Linear momentum `p`, carried as the velocity `p/ρR`.
    Momentum,
    /// Deformation gradient `F`.
    DeformationGradient,
    /// Area map `H`, evolved.
    AreaMap,
    /// Volume map `J`, evolved.
    VolumeMap,
    /// Directions of the fibres.
    FibreDirection,
    /// Directions that vary in space, one set a particle.
    FibreDirectionField,
    /// Force per reference volume from tractions and body forces.
    ExternalForce,
}

/// A loop of a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Pass {
    /// Grips, supports, planes of symmetry.
    PrescribedMotion,
    /// `Grad v`, the rate of F (28).
    VelocityGradient,
    /// Rate of H (29).
    AreaMapRate,
    /// Rate of J (30).
    VolumeMapRate,
    /// Stress from the energy.
    Stress,
    /// Internal force (32).
    InternalForce,
    /// D(p) (33, 35, 37).
    MomentumDissipation,
    /// D(J) (34, 36, 38).
    VolumeDissipation,
    /// Stiffness against hourglass modes.
    Hourglass,
    /// Tractions and body forces (31).
    ExternalForce,
    /// Damping relative to the affine motion.
    AffineDamping,
    /// Forces shared on the common nodes of bonded bodies; asked only where there are several.
    Bond,
    /// Torques of the internal forces taken out of free bodies.
    TorqueProjection,
    /// Sums of what supports and loads give to the momentum.
    Impulse,
    /// Refresh of the wave speeds of (42).
    WaveSpeed,
}

/// One line of the plan: what, live or not, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decision<T> {
    /// The field or pass.
    pub what: T,
    /// Whether the simulation has it.
    pub live: bool,
    /// Why.
    pub reason: String,
}

/// What a simulation of a scene consists of.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Name of the scene.
    pub scene: String,
    /// Maps evolved beside p and F.
    pub formulation: Formulation,
    /// Every field, live or pruned, with its reason.
    pub fields: Vec<Decision<Field>>,
    /// Every pass in order, live or pruned, with its reason.
    pub passes: Vec<Decision<Pass>>,
    /// Numerical choices with their origin.
    pub choices: Vec<Choice>,
}

impl Plan {
    /// Decides what a scene needs.
    ///
    /// ```text
    /// live = read by a live pass, an output or the energy, and not identically zero
    /// ```
    pub fn new(scene: &Scene) -> Self {
        decide::plan(scene)
    }

    /// The same plan with everything live that was dropped for being zero or never read, for the
    /// test that dropping it changed no number.
    ///
    /// What the formulation leaves out (H, J) stays out: deriving a map and evolving it are two
    /// discretisations, and which one is a choice of the scene.
    pub fn unpruned(scene: &Scene) -> Self {
        let mut plan = Self::new(scene);
        for decision in &mut plan.fields {
            let zero_or_unread = matches!(
                decision.what,
                Field::FibreDirection | Field::FibreDirectionField | Field::ExternalForce
            );
            decision.live |= zero_or_unread;
        }
        for decision in &mut plan.passes {
            decision.live |= matches!(decision.what, Pass::ExternalForce | Pass::PrescribedMotion);
        }
        plan
    }

    /// Whether a field is carried.
    pub fn carries(&self, field: Field) -> bool {
        self.fields.iter().any(|decision| decision.what == field && decision.live)
    }

    /// Whether a pass is run.
    pub fn runs(&self, pass: Pass) -> bool {
        self.passes.iter().any(|decision| decision.what == pass && decision.live)
    }
}
