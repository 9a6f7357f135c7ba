//! The description of a drive: one material point led along a path.

use super::{Column, Expectation, Material, Place, Plot};
use crate::expression::Tape;

/// A material point led along a path of deformation.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Its name, also of its folder.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// The law.
    pub material: Material,
    /// Unit directions of the material, in the order of its own.
    pub directions: Vec<[f64; 3]>,
    /// First and second axis of the path, orthonormal; the third completes a right-handed set.
    pub axes: [[f64; 3]; 2],
    /// Where it leads.
    pub path: Path,
    /// The path as written.
    pub written: String,
    /// What varies along the path: `stretch`, `amount`, or a name of the file's own.
    pub parameter: String,
    /// SI unit symbol of the parameter, empty for a number.
    pub unit: String,
    /// First and last value of the parameter.
    pub range: (f64, f64),
    /// Equal steps between the two, one row of every table more.
    pub steps: u32,
    /// Whether the volume may change.
    pub volume: VolumeChange,
    /// Tables to write.
    pub records: Vec<PointRecord>,
    /// Figures to draw.
    pub plots: Vec<Plot>,
    /// What must hold.
    pub expectations: Vec<Expectation>,
}

impl Drive {
    /// Values of the parameter, the ends exactly as written.
    pub fn parameters(&self) -> Vec<f64> {
        let (from, to) = self.range;
        let n = f64::from(self.steps);
        (0..=self.steps)
            .map(|i| if i == self.steps { to } else { from + (to - from) * f64::from(i) / n })
            .collect()
    }
}

/// Whether a material point may change its volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum VolumeChange {
    /// As the law's volumetric part says.
    Compressible,
    /// `J = 1` exactly, with a hydrostatic stress as further unknown.
    Incompressible,
}

/// Where a drive leads, in its axes.
#[derive(Debug, Clone, PartialEq)]
pub enum Path {
    /// Stretched along the first axis, all other tractions zero.
    Uniaxial,
    /// A sheet stretched along both axes.
    Biaxial {
        /// `(λ2 − 1)/(λ1 − 1)`.
        ratio: f64,
    },
    /// A sheet stretched equally along both axes.
    Equibiaxial,
    /// A sheet stretched along the first axis that keeps its width along the second.
    Planar,
    /// Planes normal to the second axis sheared along the first.
    SimpleShear,
    /// Any deformation gradient, free where a stress is prescribed; row by row.
    Deformation(Box<[[PathControl; 3]; 3]>),
}

/// What is prescribed of one component, over the parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum PathControl {
    /// The component of F.
    Deformation(Tape<PathParameter>),
    /// The component of the first Piola–Kirchhoff stress, Pa.
    FirstPiola(Tape<PathParameter>),
    /// The component of the Cauchy stress, Pa.
    Cauchy(Tape<PathParameter>),
}

/// The only leaf of a path written as text: its parameter, SI.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PathParameter;

/// A table with one row a point of the path.
#[derive(Debug, Clone, PartialEq)]
pub struct PointRecord {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Columns after the parameter.
    pub columns: Vec<Column<PointProbe>>,
}

/// What a record can ask of a material point; components are those in the axes of the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum PointProbe {
    /// Parameter of the path, SI.
    Parameter,
    /// Component of the deformation gradient.
    F(u8, u8),
    /// Component of the first Piola–Kirchhoff stress, Pa.
    P(u8, u8),
    /// Component of the Cauchy stress, Pa.
    Sigma(u8, u8),
    /// Strain energy per reference volume, Pa.
    Psi,
    /// Volume map.
    J,
    /// Von Mises stress, Pa.
    VonMises,
    /// `tr σ/3`, Pa.
    Pressure,
    /// Hydrostatic stress added by `J = 1`, Pa.
    ConstraintStress,
    /// Largest difference between a stress and its prescribed value, Pa.
    Residual,
}
