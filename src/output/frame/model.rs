//! What a frame is, and what makes one unfit to be written.
//!
//! Owns the data and its consistency; the file format is in the neighbouring files.

use std::fmt;

use crate::tensor::{Mat3, Vec3};

/// Fields over the particles of all bodies at one time, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Frame {
    /// Time, s.
    pub time: f64,
    /// Reference positions `X`, m.
    pub reference: Vec<Vec3>,
    /// Displacements `u = x − X`, m; written as the field `displacement`.
    pub displacement: Vec<Vec3>,
    /// Cells with the particles as corners, in VTK's order; may be empty, then every particle is a
    /// cell of its own.
    pub hexahedra: Vec<[usize; 8]>,
    /// Other fields.
    pub fields: Vec<FrameField>,
    /// Lines at the head of the file: program, input, hash, scene.
    pub provenance: Vec<String>,
}

/// One field of a [`Frame`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameField {
    /// Its name.
    pub name: String,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// 1 (scalar), 3 (vector), 6 (symmetric tensor: xx, yy, zz, xy, yz, xz) or 9 (tensor, row by row).
    pub components: usize,
    /// All components of the first particle, then of the next.
    pub values: Vec<f64>,
}

impl FrameField {
    /// A scalar field.
    pub fn scalar(name: &str, unit: &str, values: &[f64]) -> Self {
        Self { name: name.into(), unit: unit.into(), components: 1, values: values.to_vec() }
    }

    /// A vector field.
    pub fn vector(name: &str, unit: &str, values: &[Vec3]) -> Self {
        let values = values.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
        Self { name: name.into(), unit: unit.into(), components: 3, values }
    }

    /// The symmetric part of a tensor field, as six components.
    ///
    /// For a Cauchy stress this loses nothing: its skew part is round-off.
    pub fn symmetric(name: &str, unit: &str, values: &[Mat3]) -> Self {
        let half = |m: &Mat3, i: usize, j: usize| 0.5 * (m[(i, j)] + m[(j, i)]);
        let six = |m: &Mat3| [m[(0, 0)], m[(1, 1)], m[(2, 2)], half(m, 0, 1), half(m, 1, 2), half(m, 0, 2)];
        let values = values.iter().flat_map(six).collect();
        Self { name: name.into(), unit: unit.into(), components: 6, values }
    }

    /// A tensor field of nine components.
    pub fn tensor(name: &str, unit: &str, values: &[Mat3]) -> Self {
        let values = values.iter().flat_map(|m| m.transpose().as_slice().to_vec()).collect();
        Self { name: name.into(), unit: unit.into(), components: 9, values }
    }

    /// Names of the components, as plotting programs show them; empty for a scalar.
    pub fn component_names(&self) -> &'static [&'static str] {
        match self.components {
            3 => &["x", "y", "z"],
            6 => &["xx", "yy", "zz", "xy", "yz", "xz"],
            9 => &["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"],
            _ => &[],
        }
    }
}

impl Frame {
    /// Current positions `x = X + u`, m.
    pub fn positions(&self) -> Vec<Vec3> {
        self.reference.iter().zip(&self.displacement).map(|(x, u)| x + u).collect()
    }

    /// The field named `name`.
    pub fn field(&self, name: &str) -> Option<&FrameField> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// Every field that is written: the displacement, then the others.
    pub(super) fn all_fields(&self) -> Vec<FrameField> {
        let displacement = FrameField::vector("displacement", "m", &self.displacement);
        std::iter::once(displacement).chain(self.fields.iter().cloned()).collect()
    }

    /// Whether every field fits the points, every number is finite and every corner exists.
    ///
    /// # Errors
    /// The first fault, in the order of [`FrameError`].
    pub fn check(&self) -> Result<(), FrameError> {
        let points = self.reference.len();
        let fields = self.all_fields();
        for (i, FrameField { name, components, values, .. }) in fields.iter().enumerate() {
            if fields[..i].iter().any(|other| other.name == *name) {
                return Err(FrameError::DuplicateField { field: name.clone() });
            }
            if ![1, 3, 6, 9].contains(components) {
                return Err(FrameError::Components { field: name.clone(), found: *components });
            }
            let (found, required) = (values.len(), points * components);
            if found != required {
                return Err(FrameError::Length { field: name.clone(), found, required });
            }
            if let Some(at) = values.iter().position(|value| !value.is_finite()) {
                let point = at / components;
                let position = self.reference[point];
                return Err(FrameError::NotFinite { field: name.clone(), point, position, time: self.time });
            }
        }
        for (cell, corners) in self.hexahedra.iter().enumerate() {
            if let Some(&corner) = corners.iter().find(|&&corner| corner >= points) {
                return Err(FrameError::Corner { cell, corner, points });
            }
        }
        Ok(())
    }
}

/// Why a frame was not written.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FrameError {
    /// Two fields have one name; `displacement` is always there.
    DuplicateField {
        /// The name.
        field: String,
    },
    /// A field has a number of components that is none of 1, 3, 6, 9.
    Components {
        /// The field.
        field: String,
        /// The number found.
        found: usize,
    },
    /// A field has another number of values than points times components.
    Length {
        /// The field.
        field: String,
        /// Values found.
        found: usize,
        /// Values required.
        required: usize,
    },
    /// A value is infinite or not a number.
    NotFinite {
        /// The field.
        field: String,
        /// Index of the particle.
        point: usize,
        /// Its reference position, m.
        position: Vec3,
        /// Time, s.
        time: f64,
    },
    /// A cell names a corner that is no particle.
    Corner {
        /// Index of the cell.
        cell: usize,
        /// The corner named.
        corner: usize,
        /// Number of particles.
        points: usize,
    },
    /// A file holds no frame of this program's.
    Unreadable {
        /// The part that is missing or damaged.
        part: String,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DuplicateField { field } => write!(f, "two fields of a frame are named `{field}`"),
            Self::Components { field, found } => {
                write!(f, "field `{field}` has {found} components, but 1, 3, 6 or 9 are required")
            }
            Self::Length { field, found, required } => {
                write!(f, "field `{field}` has {found} values, but {required} are required")
            }
            Self::NotFinite { field, point, position: x, time } => write!(
                f,
                "field `{field}` is not finite at particle {point}, X = ({:.4e}, {:.4e}, {:.4e}) m, \
                 t = {time:.4e} s",
                x.x, x.y, x.z
            ),
            Self::Corner { cell, corner, points } => {
                write!(f, "cell {cell} names corner {corner}, but there are {points} particles")
            }
            Self::Unreadable { part } => {
                write!(f, "the frame cannot be read: `{part}` is missing or damaged")
            }
        }
    }
}

impl std::error::Error for FrameError {}
