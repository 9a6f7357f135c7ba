//! How faces of a shape meet, and whether a shape is its own mirror image.
//!
//! Owns questions the scene asks of a shape before any node is placed. Knows no grid.

use super::error::DiscretisationError;
use super::shape::Shape;
use crate::tensor::Vec3;

/// Share of a body's size below which two lengths are one.
const ALIKE: f64 = 1e-9;

impl Shape {
    /// Refuses dimensions that are no lengths, and unions and differences that are no prism.
    ///
    /// # Errors
    /// A [`DiscretisationError`] that names the dimension.
    pub fn validate(&self) -> Result<(), DiscretisationError> {
        match self {
            Self::Solid(_) | Self::Mesh(_) | Self::Points(_) => Ok(()),
            _ => self.prism().map(drop),
        }
    }

    /// Whether two faces share an edge, and with it its nodes.
    ///
    /// Two planes do unless they are opposite. A face that is no plane meets the two ends of the prism
    /// the shape is; whether it meets another lateral face is not told apart, and taken as not.
    pub fn faces_meet(&self, first: &str, second: &str) -> bool {
        match (self.face_normal(first), self.face_normal(second)) {
            (Some(a), Some(b)) => a.dot(&b).abs() < 0.5,
            (Some(normal), None) | (None, Some(normal)) => {
                // of a shape from a file that is not known
                self.prism().map_or(true, |prism| normal[prism.axis].abs() > 0.5)
            }
            (None, None) => false,
        }
    }

    /// Whether the plane `X_axis = at` mirrors the shape onto itself, hexahedra from a file onto their other half.
    pub fn is_symmetric(&self, axis: usize, at: f64) -> bool {
        match self {
            Self::Solid(solid) => solid.is_symmetric(axis, at),
            Self::Mesh(mesh) => mesh.ends_in(axis, at),
            Self::Points(_) => false,
            _ => {
                let (low, high) = self.bounds();
                self.alike(&self.mirrored(axis, at), ALIKE * (high - low).norm())
            }
        }
    }

    /// The only coordinate of a plane of symmetry that hexahedra from a file can have, their least: the file has the part
    /// beyond it. `None` of other shapes.
    pub fn end_plane(&self, axis: usize) -> Option<f64> {
        if let Self::Mesh(mesh) = self { Some(mesh.bounds().0[axis]) } else { None }
    }

    fn mirrored(&self, axis: usize, at: f64) -> Self {
        let image = |x: &Vec3| {
            let mut image = *x;
            image[axis] = 2.0 * at - x[axis];
            image
        };
        let mut mirrored = self.clone();
        match &mut mirrored {
            Self::Box { min, max } => {
                let (a, b) = (image(min), image(max));
                (*min, *max) = (a.inf(&b), a.sup(&b));
            }
            Self::Cylinder { centre, .. } | Self::Dumbbell { centre, .. } => *centre = image(centre),
            Self::Solid(_) | Self::Mesh(_) | Self::Points(_) => {}
            Self::Union(parts) => parts.iter_mut().for_each(|part| *part = part.mirrored(axis, at)),
            Self::Difference(base, holes) => {
                **base = base.mirrored(axis, at);
                holes.iter_mut().for_each(|hole| *hole = hole.mirrored(axis, at));
            }
        }
        mirrored
    }

    /// Whether two shapes differ by less than a length in place; parts may be in any order.
    fn alike(&self, other: &Self, length: f64) -> bool {
        let near = |a: &Vec3, b: &Vec3| (a - b).norm() <= length;
        let matched = |a: &[Self], b: &[Self]| {
            let mut left: Vec<&Self> = b.iter().collect();
            a.len() == b.len()
                && a.iter().all(|part| {
                    let found = left.iter().position(|candidate| part.alike(candidate, length));
                    found.map(|index| left.swap_remove(index)).is_some()
                })
        };
        match (self, other) {
            (Self::Box { min, max }, Self::Box { min: low, max: high }) => near(min, low) && near(max, high),
            (Self::Union(a), Self::Union(b)) => matched(a, b),
            (Self::Difference(a, holes), Self::Difference(b, others)) => {
                a.alike(b, length) && matched(holes, others)
            }
            (Self::Cylinder { centre: a, .. }, Self::Cylinder { centre: b, .. })
            | (Self::Dumbbell { centre: a, .. }, Self::Dumbbell { centre: b, .. }) => {
                // a mirror image keeps every other dimension to the last bit
                let mut moved = self.clone();
                if let Self::Cylinder { centre, .. } | Self::Dumbbell { centre, .. } = &mut moved {
                    *centre = *b;
                }
                near(a, b) && moved == *other
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate(count: usize, first: f64) -> Shape {
        Shape::ring_of_holes(Vec3::zeros(), 2, 2.0, 1.0, 0.3, 1.3, count, first)
    }

    #[test]
    fn a_plate_is_symmetric_where_its_holes_are() {
        let eighth = std::f64::consts::FRAC_PI_4;
        for (shape, axis, at, symmetric) in [
            (plate(4, eighth), 0, 0.0, true),
            (plate(4, eighth), 1, 0.0, true),
            (plate(4, eighth), 2, 0.0, true),
            (plate(4, eighth), 0, 0.1, false),
            (plate(4, 0.1), 0, 0.0, false),
            (plate(3, 0.0), 0, 0.0, false),
            (plate(3, 0.0), 1, 0.0, true),
            (Shape::Box { min: Vec3::zeros(), max: Vec3::new(1.0, 2.0, 3.0) }, 1, 1.0, true),
            (Shape::Box { min: Vec3::zeros(), max: Vec3::new(1.0, 2.0, 3.0) }, 1, 1.1, false),
            (Shape::astm_d412_die_c(Vec3::x(), 1e-3), 0, 1.0, true),
        ] {
            assert_eq!(shape.is_symmetric(axis, at), symmetric, "{shape:?} {axis} {at}");
        }
    }

    #[test]
    fn a_curved_face_meets_the_ends_and_no_other() {
        let plate = plate(4, 0.0);
        for (first, second, meet) in [
            ("zmin", "side", true),
            ("hole", "zmax", true),
            ("zmin", "zmax", false),
            ("hole", "side", false),
            ("no_face", "side", false),
        ] {
            assert_eq!(plate.faces_meet(first, second), meet, "{first} {second}");
        }
        let block = Shape::Box { min: Vec3::zeros(), max: Vec3::repeat(1.0) };
        let drilled = Shape::Difference(
            Box::new(block.clone()),
            vec![Shape::Cylinder { centre: Vec3::repeat(0.5), axis: 2, radius: 0.2, height: 1.0 }],
        );
        assert!(block.faces_meet("xmin", "ymax") && !drilled.faces_meet("hole", "xmin"));
    }
}
