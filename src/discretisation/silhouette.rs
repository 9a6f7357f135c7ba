//! Outlines of shapes for drawings.
//!
//! Owns the points along straight edges and arcs; nothing here is computed with.

use super::outline::{Outline, Vec2};
use super::shape::Shape;
use std::f64::consts::TAU;

/// Points along a whole circle.
const CIRCLE: u32 = 120;
/// Points along the transition of a dumbbell.
const TRANSITION: u32 = 40;

impl Shape {
    /// Closed outlines of the whole shape seen along the axis that is neither `right` nor `up`, m.
    ///
    /// Along its own axis a prism shows its section with its holes, from the side its bounds.
    pub fn outlines(&self, right: usize, up: usize) -> Vec<Vec<[f64; 2]>> {
        if let Ok(prism) = self.prism()
            && prism.axis != right
            && prism.axis != up
        {
            let first = (prism.axis + 1) % 3;
            let onto = |p: Vec2| if first == right { [p.x, p.y] } else { [p.y, p.x] };
            return curves(&prism.outline)
                .into_iter()
                .map(|curve| curve.into_iter().map(onto).collect())
                .collect();
        }
        let (low, high) = self.bounds();
        vec![vec![
            [low[right], low[up]],
            [high[right], low[up]],
            [high[right], high[up]],
            [low[right], high[up]],
        ]]
    }
}

fn curves(outline: &Outline) -> Vec<Vec<Vec2>> {
    match outline {
        Outline::Rectangle { min, max } => {
            vec![vec![*min, Vec2::new(max.x, min.y), *max, Vec2::new(min.x, max.y)]]
        }
        Outline::Disc { centre, radius } => {
            let angle = |i: u32| TAU * f64::from(i) / f64::from(CIRCLE);
            let at = |a: f64| centre + *radius * Vec2::new(libm::cos(a), libm::sin(a));
            vec![(0..CIRCLE).map(|i| at(angle(i))).collect()]
        }
        Outline::Dumbbell { centre, profile } => {
            let (from, length) = (profile.gauge[0], profile.transition());
            let mut quarter: Vec<Vec2> = (0..=TRANSITION)
                .map(|i| from + length * f64::from(i) / f64::from(TRANSITION))
                .map(|x| Vec2::new(x, profile.half_width(x)))
                .collect();
            quarter.push(Vec2::new(profile.end, profile.tab));
            // by quadrants, every other one backwards
            let side = |sx: f64, sy: f64| quarter.iter().map(move |p| centre + Vec2::new(sx * p.x, sy * p.y));
            let points = side(1.0, 1.0)
                .chain(side(1.0, -1.0).rev())
                .chain(side(-1.0, -1.0))
                .chain(side(-1.0, 1.0).rev());
            vec![points.collect()]
        }
        Outline::Union(parts) => parts.iter().flat_map(curves).collect(),
        Outline::Difference(base, holes) => {
            curves(base).into_iter().chain(holes.iter().flat_map(curves)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tensor::Vec3;

    #[test]
    fn a_plate_with_holes_shows_them_from_above_and_its_bounds_from_the_side() {
        let plate = Shape::ring_of_holes(Vec3::zeros(), 2, 2.0, 1.0, 0.3, 1.3, 4, 0.5);
        let above = plate.outlines(0, 1);
        assert_eq!(above.len(), 5);
        assert!(above[0].iter().all(|p| (libm::hypot(p[0], p[1]) - 2.0).abs() < 1e-12));
        assert_eq!(plate.outlines(0, 2), [[[-2.0, -0.5], [2.0, -0.5], [2.0, 0.5], [-2.0, 0.5]]]);
    }

    #[test]
    fn a_dumbbell_is_one_closed_line_of_its_four_mirror_images() {
        let outlines = Shape::astm_d412_die_c(Vec3::zeros(), 2e-3).outlines(0, 1);
        let points = &outlines[0];
        assert_eq!(outlines.len(), 1);
        for axis in 0..2 {
            let sum: f64 = points.iter().map(|p| p[axis]).sum();
            assert!(sum.abs() < 1e-15);
        }
        let widest = points.iter().map(|p| p[1]).fold(0.0, f64::max);
        assert!((widest - 12.5e-3).abs() < 1e-12 && points.iter().all(|p| p[1].abs() > 2.9e-3));
    }
}
