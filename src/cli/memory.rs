//! Whether a scene fits into this machine.
//!
//! Owns the question to the system; what a scene needs is the scene's to say.

use crate::scene::Scene;

/// Refuses a scene that needs more memory than the machine has, before it is set up.
///
/// # Errors
/// What is needed and what there is.
pub(super) fn fits(scene: &Scene) -> Result<(), String> {
    let needed = scene.least_memory();
    match installed() {
        Some(installed) if needed > installed => Err(format!(
            "up to {:.1e} particles need {:.0} GB or more, but this machine has {:.0} GB; write a larger `spacing`",
            scene.most_particles(),
            needed / GIGABYTE,
            installed / GIGABYTE
        )),
        _ => Ok(()),
    }
}

const GIGABYTE: f64 = 1e9;

/// Memory of the machine in bytes, where the system says so.
fn installed() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    let kilobytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024.0 * kilobytes)
}
