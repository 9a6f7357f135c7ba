//! Claims about cases with an independent reference: the scenes of `specs/` that carry expect lines.

use super::Claim;

/// The claims of this directory, in the order of the report; the scenes bring their own.
pub(crate) const CLAIMS: &[Claim] = &[];

/// A file compiled into the program.
pub(crate) struct BenchmarkFile {
    /// Its path in the project.
    pub(crate) path: &'static str,
    /// Its text.
    pub(crate) text: &'static str,
}

/// A file of the project, embedded.
macro_rules! embedded {
    ($path:literal) => {
        BenchmarkFile { path: $path, text: include_str!(concat!("../../", $path)) }
    };
}

/// Values that make every scene a wrong one, for the controls: fibres without dispersion, on a coarse
/// lattice. Lines that hold of any material are displaced by twenty tolerances instead.
pub(crate) const WRONG: &[(&str, &str)] = &[("adventitia.kappa", "0"), ("strip.spacing", "0.25 mm")];

/// Scenes whose expect lines are held.
pub(crate) const SCENES: &[BenchmarkFile] = &[embedded!("specs/artery/axial.tissue")];

/// Everything the scenes read.
pub(crate) const FILES: &[BenchmarkFile] = &[
    embedded!("specs/artery/axial.tissue"),
    embedded!("verification/references/fe_artery_axial_k0.226_D1e-7_Q2P1_28x10x3g.csv"),
];
