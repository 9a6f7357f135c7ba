//! Shapes of bodies.

use crate::tensor::Vec3;

/// A region of the reference configuration.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A box with edges along the axes.
    Box {
        /// Corner of least coordinates, m.
        min: Vec3,
        /// Corner of greatest coordinates, m.
        max: Vec3,
    },
}

impl Shape {
    /// Names of the faces a load can act on.
    pub fn face_names(&self) -> Vec<&'static str> {
        match self {
            Self::Box { .. } => vec!["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"],
        }
    }

    /// Least and greatest coordinates, m.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        match self {
            Self::Box { min, max } => (*min, *max),
        }
    }

    /// Outward normal of a plane face.
    pub fn face_normal(&self, name: &str) -> Option<Vec3> {
        match (self, name) {
            (Self::Box { .. }, "xmin") => Some(-Vec3::x()),
            (Self::Box { .. }, "xmax") => Some(Vec3::x()),
            (Self::Box { .. }, "ymin") => Some(-Vec3::y()),
            (Self::Box { .. }, "ymax") => Some(Vec3::y()),
            (Self::Box { .. }, "zmin") => Some(-Vec3::z()),
            (Self::Box { .. }, "zmax") => Some(Vec3::z()),
            _ => None,
        }
    }
}
