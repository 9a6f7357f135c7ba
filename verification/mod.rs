//! The claims of this program, one directory a topic, one file a claim.
//!
//! Each file measures one number against mathematics or an independent reference, and measures a
//! deliberately wrong variant beside it. The numbers come from algebra, a second route or a cited
//! table, never from this program's own past.

use super::claim::Claim;

pub(crate) mod benchmarks;
mod conservation;
mod consistency;
mod convergence;
mod cube;
mod discretisation;
mod drive;
mod energies;
mod figures;
mod fit;
mod language;
mod picture;
mod scene;

pub use picture::illustrations;

/// The claims that together take seconds; `cargo test` holds every one of them.
pub fn quick() -> Vec<Claim> {
    let groups = [
        language::CLAIMS,
        energies::CLAIMS,
        discretisation::CLAIMS,
        conservation::CLAIMS,
        consistency::CLAIMS,
        convergence::CLAIMS,
        drive::CLAIMS,
        fit::CLAIMS,
        benchmarks::CLAIMS,
        figures::CLAIMS,
    ];
    groups.concat()
}

/// The claims that take minutes, for `tissue verify --full`.
pub fn full() -> Vec<Claim> {
    let groups: [&[Claim]; 2] = [convergence::FULL, benchmarks::FULL];
    groups.concat()
}
