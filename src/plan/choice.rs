//! The numerical choices of a run and where each came from.

use crate::discretisation::{Consistency, Kernel};
use crate::scene::{
    AngularMomentum, Formulation, Integrator, InterfaceStates, Loading, Run, Scene, Scheme, VolumeDissipation,
};

/// One numerical choice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// Its key in `run { … }`.
    pub key: &'static str,
    /// Its value as it would be written.
    pub value: String,
    /// Who chose: the file, the scheme or the plan.
    pub origin: String,
}

/// Every choice of a scene's run.
pub fn choices(scene: &Scene, formulation: Formulation) -> Vec<Choice> {
    let run = &scene.run;
    let scheme = match run.scheme {
        Scheme::Seed => "seed",
        Scheme::Improved => "improved",
    };
    let quadratic = run.consistency == Consistency::Quadratic;
    let written = |key: &str| run.written.iter().any(|written| written == key);
    let origin = |key: &str| match key {
        _ if written(key) => written_at(run, key),
        "cfl" if written("integrator") => {
            format!("integrator of {}", written_at(run, "integrator"))
        }
        "smoothing" if quadratic => format!("completeness of {}", written_at(run, "completeness")),
        "damping" | "volume_relaxation" => "the plan".into(),
        _ => format!("scheme {scheme}"),
    };
    let mut choices = Vec::new();
    let mut add = |key: &'static str, value: String| choices.push(Choice { key, value, origin: origin(key) });
    add("scheme", scheme.into());
    add(
        "formulation",
        match formulation {
            Formulation::Pf => "pF",
            Formulation::Pfj => "pFJ",
            Formulation::Pfhj => "pFHJ",
        }
        .into(),
    );
    add(
        "loading",
        match run.loading {
            Loading::Dynamic => "dynamic",
            Loading::QuasiStatic { .. } => "quasi_static",
        }
        .into(),
    );
    if let Loading::QuasiStatic { .. } = run.loading {
        add("damping", format!("{:.4e} s^-1", damping_rate(scene)));
    }
    add(
        "integrator",
        match run.integrator {
            Integrator::TvdRk2 => "tvd_rk2",
            Integrator::SspRk3 => "ssp_rk3",
            Integrator::VelocityVerlet => "velocity_verlet",
        }
        .into(),
    );
    add("cfl", run.cfl.to_string());
    add(
        "kernel",
        match run.kernel {
            Kernel::WendlandC2 => "wendland_c2",
            Kernel::CubicSpline => "cubic_spline",
            Kernel::QuinticSpline => "quintic_spline",
            Kernel::Quadratic => "quadratic",
        }
        .into(),
    );
    add("smoothing", run.smoothing.to_string());
    add("integration_consistency", on_off(run.consistency != Consistency::Kernel));
    add("completeness", if quadratic { "quadratic" } else { "linear" }.into());
    if !quadratic {
        let centroid = run.consistency == Consistency::Centroid;
        add("boundary_gradients", if centroid { "centroid" } else { "one_sided" }.into());
    }
    add(
        "momentum_dissipation",
        match run.momentum_dissipation {
            InterfaceStates::Off => "off",
            InterfaceStates::Constant => "constant",
            InterfaceStates::Variational => "variational",
        }
        .into(),
    );
    add("pressure_wave_weight", run.pressure_wave_weight.to_string());
    add("shear_wave_weight", run.shear_wave_weight.to_string());
    add("hourglass_stiffness", run.hourglass_stiffness.to_string());
    add(
        "volume_dissipation",
        match run.volume_dissipation {
            VolumeDissipation::Off => "off",
            VolumeDissipation::On => "on",
            VolumeDissipation::Restoring { .. } => "restoring",
        }
        .into(),
    );
    if run.volume_dissipation != VolumeDissipation::Off {
        add("volume_wave_weight", run.volume_wave_weight.to_string());
    }
    if let VolumeDissipation::Restoring { rate } = run.volume_dissipation {
        let chosen = format!("{RELAXATION_OF_J:.0} c_p/dx");
        add("volume_relaxation", rate.map_or(chosen, |rate| format!("{rate:.4e} s^-1")));
    }
    add(
        "angular_momentum",
        match run.angular_momentum {
            AngularMomentum::Free => "free",
            AngularMomentum::Projected => "projected",
        }
        .into(),
    );
    add(
        "wave_speed_every",
        match run.wave_speed_every {
            0 => "0 (at rest only)".into(),
            steps => format!("{steps} steps"),
        },
    );
    choices
}

/// Where a key of `run` is written: in the block, or on the command line.
pub(super) fn written_at(run: &Run, key: &str) -> String {
    if run.set.iter().any(|set| set == key) {
        return format!("--set run.{key}");
    }
    format!("line {}", run.place.line)
}

fn on_off(on: bool) -> String {
    if on { "on".into() } else { "off".into() }
}

/// Damping rate of quasi-static loading, 1/s: the scene's, or a number of oscillations of the
/// loading time.
///
/// ```text
/// η = 20 / T
/// ```
///
/// The transient of a critically damped mode then dies within a tenth of the loading time `T`,
/// while the drag of the motion relative to the affine one, of order `ρR η v L`, falls with `T²`
/// like inertia does. Zero for dynamic loading.
pub fn damping_rate(scene: &Scene) -> f64 {
    match scene.run.loading {
        Loading::Dynamic => 0.0,
        Loading::QuasiStatic { damping: Some(rate) } => rate,
        Loading::QuasiStatic { damping: None } => RELAXATIONS / scene.run.until,
    }
}

/// Relaxation times of the damping within the loading time.
const RELAXATIONS: f64 = 20.0;

/// Rate at which J is drawn to `det F` unless the scene states one, in units of `c_p/dx`.
///
/// D(J) smooths the shortest waves at a rate of the order of `c_p/dx` and longer ones more slowly, with the
/// square of their length. At the same rate J keeps no more than what D(J) adds in the time `dx/c_p`.
pub const RELAXATION_OF_J: f64 = 1.0;
