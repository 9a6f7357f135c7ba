//! Bodies of points with volumes, as a file gives them.
//!
//! Owns what such points can and cannot do: they have no boundary areas. Knows no file format.

use super::error::DiscretisationError;
use super::particles::{FaceNodes, Particles};
use crate::tensor::Vec3;

/// Share of the body's size within which points lie in one plane.
const PLANE: f64 = 1e-6;

const PLANES: [&str; 6] = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"];

/// Points and the volume of each.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    position: Vec<Vec3>,
    volume: Vec<f64>,
    low: Vec3,
    high: Vec3,
}

impl Points {
    /// Points with volumes.
    ///
    /// # Errors
    /// [`DiscretisationError::BadPoint`] if a coordinate is not finite or a volume not positive.
    pub fn new(position: Vec<Vec3>, volume: Vec<f64>) -> Result<Self, DiscretisationError> {
        let bad = |(x, volume): (&Vec3, &f64)| {
            !(x.iter().all(|c| c.is_finite()) && *volume > 0.0 && volume.is_finite())
        };
        if let Some(point) = position.iter().zip(&volume).position(bad) {
            return Err(DiscretisationError::BadPoint { point, volume: volume[point] });
        }
        let low = position.iter().fold(Vec3::repeat(f64::INFINITY), |low, x| low.inf(x));
        let high = position.iter().fold(Vec3::repeat(f64::NEG_INFINITY), |high, x| high.sup(x));
        Ok(Self { position, volume, low, high })
    }

    /// Least and greatest coordinates, m.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        (self.low, self.high)
    }

    /// Names of its faces: the points of greatest and least coordinates.
    pub fn face_names(&self) -> Vec<&'static str> {
        PLANES.to_vec()
    }

    /// The points as particles, in the order of the file. The areas of their faces only weigh the points in means:
    /// each is `V^⅔` along the axis.
    pub(super) fn particles(
        &self,
        spacing: f64,
        symmetry: [Option<f64>; 3],
    ) -> Result<Particles, DiscretisationError> {
        if let Some(axis) = symmetry.iter().position(Option::is_some) {
            return Err(DiscretisationError::PlaneThroughPoints { axis });
        }
        let tolerance = PLANE * (self.high - self.low).norm();
        let face = |k: usize| {
            let (axis, greater) = (k / 2, k % 2 == 1);
            let at = if greater { self.high[axis] } else { self.low[axis] };
            let near = |a: &u32| (self.position[*a as usize][axis] - at).abs() <= tolerance;
            let nodes: Vec<u32> = (0..self.position.len() as u32).filter(near).collect();
            let side = |a: &u32| libm::cbrt(self.volume[*a as usize]);
            let weight = |a: &u32| {
                let mut area = Vec3::zeros();
                area[axis] = side(a) * side(a) * if greater { 1.0 } else { -1.0 };
                area
            };
            let area = nodes.iter().map(weight).collect();
            FaceNodes { name: PLANES[k].into(), nodes, area, quads: Vec::new(), bulges: Vec::new() }
        };
        let side = self.volume.iter().map(|v| libm::cbrt(*v)).fold(f64::INFINITY, f64::min);
        Ok(Particles {
            position: self.position.clone(),
            volume: self.volume.clone(),
            faces: (0..6).map(face).collect(),
            spacing,
            least_spacing: side.min(spacing),
            cells: Vec::new(),
            first_moment: Vec::new(),
        })
    }
}
