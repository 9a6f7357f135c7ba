//! What a resolved file holds, and where it was written.

use super::{Drive, FigureOf, Fit, Material, Scene, Sweep};

/// Where something was written, for the reasons a plan gives and the errors a run ends with.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// The file as named on the command line or by the import.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// A resolved file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Materials in order.
    pub materials: Vec<Material>,
    /// Scenes in order.
    pub scenes: Vec<Scene>,
    /// Drives of a material point in order.
    pub drives: Vec<Drive>,
    /// Sweeps and trades in order.
    pub sweeps: Vec<Sweep>,
    /// Figures in order.
    pub figures: Vec<FigureOf>,
    /// Fits in order.
    pub fits: Vec<Fit>,
    /// What must hold of materials, in order.
    pub checks: Vec<Check>,
}

/// What must hold of a material's law.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Where it is written.
    pub place: Place,
    /// The material.
    pub material: Material,
    /// Properties that must hold, by the names its audit gives them.
    pub require: Vec<String>,
    /// Smallest and largest stretch to be expected, if written.
    pub stretches: Option<[f64; 2]>,
}
