//! The numerical choices of a run.

use super::Place;
use crate::discretisation::{Consistency, Kernel};

/// A set of numerical choices: the paper's or ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scheme {
    /// The paper as printed.
    Seed,
    /// With the improvements of this project.
    Improved,
}

/// Which maps are evolved beside p and F.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// H and J derived from F.
    Pf,
    /// J evolved, H derived.
    Pfj,
    /// H and J evolved.
    Pfhj,
}

/// Time integrators.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Integrator {
    /// Two-stage TVD Runge–Kutta (Heun), the paper's.
    TvdRk2,
    /// Three-stage, third-order strong-stability-preserving Runge–Kutta.
    SspRk3,
    /// Velocity Verlet.
    VelocityVerlet,
}

/// How the load is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loading {
    /// Inertia is part of the answer.
    Dynamic,
    /// Inertia is an error to be kept small: starts from the affine velocity field and is damped
    /// relative to it, at this rate (1/s; `None` lets the plan choose).
    QuasiStatic {
        /// Damping rate, 1/s.
        damping: Option<f64>,
    },
}

/// Interface states of the momentum dissipation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InterfaceStates {
    /// No dissipation of momentum.
    Off,
    /// The particles' own momenta.
    Constant,
    /// Carried to the middle of the pair with the corrected gradient, and the exact adjoint of that in the balance.
    Variational,
}

/// Dissipation of the volume map, D(J).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VolumeDissipation {
    /// None.
    Off,
    /// As printed.
    On,
    /// As printed, and J relaxes towards `det F` at a rate (1/s; `None` lets the plan choose).
    Restoring {
        /// Relaxation rate, 1/s.
        rate: Option<f64>,
    },
}

/// What becomes of the angular momentum of a free body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AngularMomentum {
    /// What the forces and the integrator make of it.
    Free,
    /// Kept to round-off by a least correction of the accelerations.
    Projected,
}

/// Numerical choices of `run { … }`, defaults filled in by the scheme.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Where the block stands.
    pub place: Place,
    /// End time, s.
    pub until: f64,
    /// The scheme the defaults come from.
    pub scheme: Scheme,
    /// `None` lets the plan choose the smallest that loses nothing.
    pub formulation: Option<Formulation>,
    /// How the load is meant.
    pub loading: Loading,
    /// Time integrator.
    pub integrator: Integrator,
    /// `α_CFL` of (42).
    pub cfl: f64,
    /// Kernel.
    pub kernel: Kernel,
    /// `h/dx`.
    pub smoothing: f64,
    /// Integration consistency on or off.
    pub consistency: Consistency,
    /// Interface states of D(p).
    pub momentum_dissipation: InterfaceStates,
    /// Weight of `c_p` in `S_p`.
    pub pressure_wave_weight: f64,
    /// Weight of `c_s` in `S_p`.
    pub shear_wave_weight: f64,
    /// Stiffness against hourglass modes, in shear moduli at rest; 0 for none.
    pub hourglass_stiffness: f64,
    /// D(J).
    pub volume_dissipation: VolumeDissipation,
    /// Factor of D(J).
    pub volume_wave_weight: f64,
    /// Angular momentum of free bodies.
    pub angular_momentum: AngularMomentum,
    /// Steps between two refreshes of the wave speed.
    pub wave_speed_every: u32,
    /// Which of the choices above were written in the file or on the command line, by key.
    pub written: Vec<String>,
    /// Which of them were given on the command line.
    pub set: Vec<String>,
}

impl Run {
    /// Courant number up to which an explicit step keeps waves bounded, the stable length of the nodes given.
    ///
    /// ```text
    /// undamped waves, z = ω Δt ≤ 2 α:   velocity Verlet        z < 2        α < 1
    ///                                    SSP Runge–Kutta of 3   z < √3       α < √3/2
    ///                                    Heun                   |G|² = 1 + z⁴/4 > 1 at every step
    /// ```
    ///
    /// Heun's method needs a dissipation to carry waves at all; with it the number measured stable on lattices and
    /// jittered cubes at Poisson's ratios to 0.4999 is returned, without it zero.
    pub fn courant_limit(&self) -> f64 {
        let damped = self.momentum_dissipation != InterfaceStates::Off
            && (self.pressure_wave_weight > 0.0 || self.shear_wave_weight > 0.0);
        match self.integrator {
            Integrator::VelocityVerlet => 1.0,
            Integrator::SspRk3 => 0.5 * 3.0_f64.sqrt(),
            Integrator::TvdRk2 if !damped => 0.0,
            Integrator::TvdRk2 if self.consistency == Consistency::Quadratic => HEUN_QUADRATIC,
            Integrator::TvdRk2 => HEUN_LINEAR,
        }
    }
}

/// Courant numbers measured stable with Heun's method and a dissipation of momentum, docs/seed_and_improved.md.
const HEUN_LINEAR: f64 = 0.77;
const HEUN_QUADRATIC: f64 = 0.38;
