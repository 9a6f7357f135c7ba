//! Shapes of bodies.
//!
//! Owns the shapes a body can have, their bounds and the names of their faces. Knows no grid.

use super::error::DiscretisationError;
use super::mesh::Mesh;
use super::outline::{Outline, Profile, Vec2};
use super::points::Points;
use super::prism::Prism;
use super::solid::Solid;
use crate::tensor::Vec3;
use std::sync::Arc;

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
    /// A circular cylinder along an axis.
    Cylinder {
        /// Its centre, m.
        centre: Vec3,
        /// Its axis: 0, 1 or 2.
        axis: usize,
        /// Its radius, m.
        radius: f64,
        /// Its height along the axis, m.
        height: f64,
    },
    /// A tensile specimen, flat in x and y, long in x. From the gauge the width grows along a concave
    /// arc and a convex one, tangent to each other, to gauge and to tab.
    Dumbbell {
        /// Its centre, m.
        centre: Vec3,
        /// Length of the gauge, m.
        gauge_length: f64,
        /// Width of the gauge, m.
        gauge_width: f64,
        /// Width of the tabs, m.
        tab_width: f64,
        /// Length of each tab, m; zero ends the body where the tabs begin.
        tab_length: f64,
        /// Radius of the concave arc at the gauge, m.
        inner_radius: f64,
        /// Radius of the convex arc at the tab, m.
        outer_radius: f64,
        /// Thickness along z, m.
        thickness: f64,
    },
    /// What a closed surface of triangles encloses.
    Solid(Arc<Solid>),
    /// Hexahedra as a file gives them.
    Mesh(Arc<Mesh>),
    /// Points with volumes as a file gives them.
    Points(Arc<Points>),
    /// All points of any part; parts are prisms along one axis that end together.
    Union(Vec<Shape>),
    /// The points of the first that belong to none of the others, which reach through it along one axis.
    Difference(Box<Shape>, Vec<Shape>),
}

impl Shape {
    /// The dumbbell of ASTM D412 die C between its tabs.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `centre` | its centre | m |
    /// | `thickness` | its thickness along z | m |
    ///
    /// Gauge 33 × 6 mm, tabs 25 mm wide and 84.02 mm apart, radii 25 and 14 mm.
    pub fn astm_d412_die_c(centre: Vec3, thickness: f64) -> Self {
        Self::Dumbbell {
            centre,
            gauge_length: 33e-3,
            gauge_width: 6e-3,
            tab_width: 25e-3,
            tab_length: 0.0,
            inner_radius: 25e-3,
            outer_radius: 14e-3,
            thickness,
        }
    }

    /// A cylinder with through-holes on a circle about its axis.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `centre`, `axis`, `radius`, `height` | the cylinder | m, –, m, m |
    /// | `hole` | radius of the holes | m |
    /// | `ring` | distance of their centres from the axis | m |
    /// | `count` | how many, evenly spaced | – |
    /// | `first` | angle of the first from the axis after the cylinder's, in cyclic order | rad |
    #[expect(clippy::too_many_arguments, reason = "eight dimensions of one drawing")]
    pub fn ring_of_holes(
        centre: Vec3,
        axis: usize,
        radius: f64,
        height: f64,
        hole: f64,
        ring: f64,
        count: usize,
        first: f64,
    ) -> Self {
        let holes = (0..count).map(|k| {
            let angle = first + std::f64::consts::TAU * (k as f64 / count as f64);
            let mut at = centre;
            at[(axis + 1) % 3] += ring * libm::cos(angle);
            at[(axis + 2) % 3] += ring * libm::sin(angle);
            Self::Cylinder { centre: at, axis, radius: hole, height }
        });
        Self::Difference(Box::new(Self::Cylinder { centre, axis, radius, height }), holes.collect())
    }

    /// Names of the faces a load can act on.
    pub fn face_names(&self) -> Vec<&'static str> {
        const PLANES: [&str; 6] = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"];
        match self {
            Self::Box { .. } => PLANES.to_vec(),
            Self::Cylinder { axis, .. } => vec![PLANES[2 * axis], PLANES[2 * axis + 1], "side"],
            Self::Dumbbell { .. } => vec!["xmin", "xmax", "zmin", "zmax", "edge"],
            Self::Solid(solid) => solid.face_names(),
            Self::Mesh(mesh) => mesh.face_names(),
            Self::Points(points) => points.face_names(),
            Self::Union(parts) => {
                let (low, high) = self.bounds();
                let mut names = vec![];
                for part in parts {
                    let (part_low, part_high) = part.bounds();
                    names.extend(part.face_names().into_iter().filter(|name| {
                        let plane = PLANES.iter().position(|plane| plane == name);
                        plane.is_none_or(|n| match n % 2 {
                            0 => part_low[n / 2] == low[n / 2],
                            _ => part_high[n / 2] == high[n / 2],
                        })
                    }));
                }
                // planes that lie further in; discs may have some beside them as well
                if parts.iter().any(|part| matches!(part, Self::Box { .. })) {
                    names.push("inner");
                }
                let rank =
                    |name: &&str| PLANES.iter().position(|plane| plane == name).unwrap_or(PLANES.len());
                names.sort_by_key(|name| (rank(name), *name));
                names.dedup();
                names
            }
            Self::Difference(base, _) => {
                let mut names = base.face_names();
                names.push("hole");
                names.dedup();
                names
            }
        }
    }

    /// Least and greatest coordinates, m.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        match self {
            Self::Box { min, max } => (*min, *max),
            Self::Cylinder { centre, axis, radius, height } => {
                let mut half = Vec3::repeat(*radius);
                half[*axis] = 0.5 * height;
                (centre - half, centre + half)
            }
            Self::Solid(solid) => solid.bounds(),
            Self::Mesh(mesh) => mesh.bounds(),
            Self::Points(points) => points.bounds(),
            Self::Dumbbell { centre, tab_width, thickness, .. } => {
                let half = Vec3::new(self.profile().end, 0.5 * tab_width, 0.5 * thickness);
                (centre - half, centre + half)
            }
            Self::Union(parts) => parts
                .iter()
                .map(Self::bounds)
                .reduce(|(low, high), (l, h)| (low.inf(&l), high.sup(&h)))
                .unwrap_or_default(),
            Self::Difference(base, _) => base.bounds(),
        }
    }

    /// Outward normal of a plane face.
    pub fn face_normal(&self, name: &str) -> Option<Vec3> {
        if !self.face_names().contains(&name) {
            return None;
        }
        match name {
            "xmin" => Some(-Vec3::x()),
            "xmax" => Some(Vec3::x()),
            "ymin" => Some(-Vec3::y()),
            "ymax" => Some(Vec3::y()),
            "zmin" => Some(-Vec3::z()),
            "zmax" => Some(Vec3::z()),
            _ => None,
        }
    }

    /// The prism that the shape is.
    pub(super) fn prism(&self) -> Result<Prism, DiscretisationError> {
        self.check()?;
        // the first axis along which it is one; of a lone box any will do
        [2, 0, 1].into_iter().find_map(|axis| self.along(axis)).ok_or(DiscretisationError::NotAPrism)
    }

    /// The shape as a prism along an axis.
    fn along(&self, axis: usize) -> Option<Prism> {
        let plane = |x: &Vec3| Vec2::new(x[(axis + 1) % 3], x[(axis + 2) % 3]);
        let (low, high) = self.bounds();
        let extent = (low[axis], high[axis]);
        let outline = match self {
            Self::Box { min, max } => Outline::Rectangle { min: plane(min), max: plane(max) },
            Self::Cylinder { centre, axis: own, radius, .. } if *own == axis => {
                Outline::Disc { centre: plane(centre), radius: *radius }
            }
            Self::Dumbbell { centre, .. } if axis == 2 => {
                Outline::Dumbbell { centre: plane(centre), profile: self.profile() }
            }
            Self::Cylinder { .. } | Self::Dumbbell { .. } => return None,
            Self::Solid(_) | Self::Mesh(_) | Self::Points(_) => return None,
            Self::Union(parts) => {
                let parts = parts.iter().map(|part| part.along(axis)).collect::<Option<Vec<Prism>>>()?;
                if parts.iter().any(|part| part.extent != extent) {
                    return None;
                }
                Outline::Union(parts.into_iter().map(|part| part.outline).collect())
            }
            Self::Difference(base, holes) => {
                let base = base.along(axis)?;
                let holes = holes.iter().map(|hole| hole.along(axis)).collect::<Option<Vec<Prism>>>()?;
                if holes.iter().any(|hole| hole.extent.0 > extent.0 || hole.extent.1 < extent.1) {
                    return None;
                }
                let holes = holes.into_iter().map(|hole| hole.outline).collect();
                Outline::Difference(Box::new(base.outline), holes)
            }
        };
        Some(Prism { axis, extent, outline })
    }

    /// Quarter outline of a dumbbell; of another shape that of a point.
    fn profile(&self) -> Profile {
        let mut profile = Profile { gauge: [0.0; 2], tab: 0.0, inner: 0.0, outer: 0.0, end: 0.0 };
        if let Self::Dumbbell {
            gauge_length,
            gauge_width,
            tab_width,
            tab_length,
            inner_radius,
            outer_radius,
            ..
        } = self
        {
            profile.gauge = [0.5 * gauge_length, 0.5 * gauge_width];
            profile.tab = 0.5 * tab_width;
            (profile.inner, profile.outer) = (*inner_radius, *outer_radius);
            profile.end = profile.gauge[0] + profile.transition() + tab_length;
        }
        profile
    }

    /// Refuses dimensions that are no lengths.
    fn check(&self) -> Result<(), DiscretisationError> {
        let positive = |name, value: f64| {
            let fine = value > 0.0 && value.is_finite();
            if fine { Ok(()) } else { Err(DiscretisationError::BadDimension { name, value }) }
        };
        match self {
            Self::Box { min, max } => {
                (0..3).try_for_each(|axis| positive(["x", "y", "z"][axis], max[axis] - min[axis]))
            }
            Self::Cylinder { axis, radius, height, .. } => {
                if *axis > 2 {
                    return Err(DiscretisationError::NotAPrism);
                }
                positive("radius", *radius)?;
                positive("height", *height)
            }
            Self::Dumbbell {
                gauge_length,
                gauge_width,
                tab_width,
                tab_length,
                inner_radius,
                outer_radius,
                thickness,
                ..
            } => {
                positive("gauge length", *gauge_length)?;
                positive("gauge width", *gauge_width)?;
                positive("tab width", *tab_width)?;
                positive("inner radius", *inner_radius)?;
                positive("outer radius", *outer_radius)?;
                positive("thickness", *thickness)?;
                // the arcs meet with a common tangent as long as each turns by less than a right angle
                positive("width the tabs add to the gauge", tab_width - gauge_width)?;
                positive("sum of the radii less half that width", {
                    inner_radius + outer_radius - 0.5 * (tab_width - gauge_width)
                })?;
                if *tab_length == 0.0 { Ok(()) } else { positive("tab length", *tab_length) }
            }
            // checked when they were made
            Self::Solid(_) | Self::Mesh(_) | Self::Points(_) => Ok(()),
            Self::Union(parts) if parts.is_empty() => Err(DiscretisationError::NotAPrism),
            Self::Union(parts) => parts.iter().try_for_each(Self::check),
            Self::Difference(base, holes) => {
                base.check()?;
                holes.iter().try_for_each(Self::check)
            }
        }
    }
}
