//! Reasons that several choices of a run decide together.
//!
//! Owns what is said of a pass as its weights are set; whether the pass is live is decided beside.

use super::choice::written_at;
use crate::scene::{AngularMomentum, InterfaceStates, Run, Scene};

/// Which waves D(p) damps as its weights are set.
#[derive(PartialEq)]
enum Damps {
    Both,
    Pressure,
    Shear,
    Nothing,
}

fn damps(run: &Run) -> Damps {
    match (run.pressure_wave_weight > 0.0, run.shear_wave_weight > 0.0) {
        (true, true) => Damps::Both,
        (true, false) => Damps::Pressure,
        (false, true) => Damps::Shear,
        (false, false) => Damps::Nothing,
    }
}

/// What D(p) does as it is set.
pub(super) fn why_dissipated(run: &Run) -> String {
    let what = match damps(run) {
        Damps::Both => "removes zero-energy modes",
        Damps::Pressure => "damps jumps along each pair alone, shear_wave_weight is 0",
        Damps::Shear => "damps jumps across each pair alone, pressure_wave_weight is 0",
        Damps::Nothing => "adds nothing: both wave weights are 0",
    };
    match run.momentum_dissipation {
        InterfaceStates::Off => format!("switched off, {}", written_at(run, "momentum_dissipation")),
        _ if damps(run) == Damps::Nothing => format!("{what}, {}", written_at(run, "shear_wave_weight")),
        InterfaceStates::Constant => format!("{what}; states of the particles (33)"),
        InterfaceStates::Variational => {
            format!("{what}; states carried to mid-pair, never feeds energy (33)")
        }
    }
}

/// What keeps even and odd nodes together, or does not.
pub(super) fn why_stiffened(run: &Run) -> &'static str {
    if run.hourglass_stiffness > 0.0 {
        "even and odd nodes may not stretch differently"
    } else if run.momentum_dissipation != InterfaceStates::Off && damps(run) != Damps::Nothing {
        "no stiffness against what no gradient sees; D(p) only damps it"
    } else {
        "no stiffness against what no gradient sees, nor does D(p) damp it"
    }
}

/// Whether any body has an angular momentum to keep, and why.
pub(super) fn projection(scene: &Scene) -> (bool, String) {
    let held = |body: usize| scene.prescribed.iter().any(|prescribed| prescribed.region.body == body);
    if scene.run.angular_momentum == AngularMomentum::Free {
        (false, "angular momentum is what forces and integrator make of it".into())
    } else if scene.symmetry.iter().flatten().count() > 1 {
        (false, "mirrored about more than one plane, the whole has no angular momentum".into())
    } else if !scene.bonds.is_empty() {
        (false, "bonded bodies exchange angular momentum".into())
    } else if scene.motion.is_some() {
        (false, "an exact motion moves the body".into())
    } else if (0..scene.bodies.len()).all(held) {
        (false, "every body is held, so reactions change its angular momentum".into())
    } else {
        (true, format!("internal forces lose their torque, {}", written_at(&scene.run, "angular_momentum")))
    }
}
