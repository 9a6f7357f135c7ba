//! Nearest points of a solid's surface.
//!
//! Owns the search among triangles and sharp edges. Knows no grid.

use super::solid::Solid;
use crate::tensor::Vec3;
use std::collections::BTreeMap;

/// Share of a distance by which two distances are equal.
const TIE: f64 = 1e-9;

/// Share of the distance within which two nearest points lie beside each other.
const BESIDE: f64 = 0.25;

/// Nearest points of a solid's surface and of its sharp edges, by bins.
#[derive(Debug)]
pub(super) struct Nearest<'a> {
    solid: &'a Solid,
    triangles: Bins,
    edges: Bins,
}

impl<'a> Nearest<'a> {
    /// Bins as large as the triangles, within a share of the spacing, which nodes are from the surface.
    pub fn new(solid: &'a Solid, spacing: f64) -> Self {
        let area: f64 = solid.triangle.iter().map(|[a, b, c]| (b - a).cross(&(c - a)).norm()).sum();
        let size = 2.0 * libm::sqrt(area / solid.triangle.len() as f64);
        let edge = size.clamp(spacing / 8.0, spacing);
        let boxes = |points: &[Vec3]| {
            let start = (points[0], points[0]);
            points.iter().fold(start, |(low, high), x| (low.inf(x), high.sup(x)))
        };
        let low = solid.bounds().0;
        let triangles = Bins::new(low, edge, solid.triangle.iter().map(|t| boxes(t)));
        let edges = Bins::new(low, edge, solid.sharp.iter().map(|e| boxes(e)));
        Self { solid, triangles, edges }
    }

    /// The nearest point of the surface within `reach`.
    pub fn surface(&self, x: &Vec3, reach: f64) -> Option<Vec3> {
        self.triangles.nearest(x, reach, |k| on_triangle(x, &self.solid.triangle[k]))
    }

    /// The nearest point of a sharp edge within `reach`.
    pub fn edge(&self, x: &Vec3, reach: f64) -> Option<Vec3> {
        self.edges.nearest(x, reach, |k| on_segment(x, &self.solid.sharp[k]))
    }
}

/// Things by the cubes of one edge length they touch.
#[derive(Debug)]
struct Bins {
    origin: Vec3,
    edge: f64,
    member: BTreeMap<[i32; 3], Vec<u32>>,
    /// Bounds of each thing.
    bounds: Vec<(Vec3, Vec3)>,
}

impl Bins {
    fn new(origin: Vec3, edge: f64, boxes: impl Iterator<Item = (Vec3, Vec3)>) -> Self {
        let bounds: Vec<(Vec3, Vec3)> = boxes.collect();
        let mut bins = Self { origin, edge, member: BTreeMap::new(), bounds };
        for index in 0..bins.bounds.len() {
            let (low, high) = bins.bounds[index];
            let (from, to) = (bins.cube(&low), bins.cube(&high));
            for i in from[0]..=to[0] {
                for j in from[1]..=to[1] {
                    for k in from[2]..=to[2] {
                        bins.member.entry([i, j, k]).or_default().push(index as u32);
                    }
                }
            }
        }
        bins
    }

    fn cube(&self, x: &Vec3) -> [i32; 3] {
        let at = (x - self.origin) / self.edge;
        [0, 1, 2].map(|i| at[i].floor() as i32)
    }

    /// The nearest of the points `of` gives for members around `x`, within `reach` of it; of points equally near and
    /// beside each other, as on both faces of a blunt edge, the mean, so that mirror images have mirror images.
    fn nearest(&self, x: &Vec3, reach: f64, of: impl Fn(usize) -> Vec3) -> Option<Vec3> {
        let centre = self.cube(x);
        let mut points: Vec<(f64, Vec3)> = Vec::new();
        let most = libm::ceil(reach / self.edge) as i32;
        for ring in 0..=most {
            // what is farther out lies beyond the whole cubes between
            let between = f64::from(ring - 1) * self.edge;
            if points.first().is_some_and(|(least, _)| least * (1.0 + TIE) < between) {
                break;
            }
            for cube in shell(centre, ring) {
                for &index in self.member.get(&cube).into_iter().flatten() {
                    let (low, high) = &self.bounds[index as usize];
                    let nearest = points.first().map_or(reach, |(least, _)| least * (1.0 + TIE));
                    if (x - x.sup(low).inf(high)).norm() > nearest {
                        continue;
                    }
                    let point = of(index as usize);
                    let distance = (point - x).norm();
                    if distance <= reach && points.iter().all(|(least, _)| distance <= least * (1.0 + TIE)) {
                        points.retain(|(other, _)| *other <= distance * (1.0 + TIE));
                        points.push((distance, point));
                    }
                }
            }
        }
        let (distance, first) = *points.first()?;
        // one triangle is found in several bins, one point on several triangles
        let mut distinct: Vec<Vec3> = Vec::new();
        for (_, point) in points {
            let apart = |other: &Vec3| (point - other).norm() > TIE * distance;
            if (point - first).norm() <= BESIDE * distance && distinct.iter().all(apart) {
                distinct.push(point);
            }
        }
        Some(distinct.iter().sum::<Vec3>() / distinct.len() as f64)
    }
}

/// Cubes whose farthest index from a cube's is `ring`.
fn shell(centre: [i32; 3], ring: i32) -> impl Iterator<Item = [i32; 3]> {
    let span = move || -ring..=ring;
    span().flat_map(move |i| {
        span().flat_map(move |j| {
            // inside the shell only its two ends
            let step = if i.abs() == ring || j.abs() == ring { 1 } else { (2 * ring).max(1) };
            span().step_by(step as usize).map(move |k| [centre[0] + i, centre[1] + j, centre[2] + k])
        })
    })
}

fn on_segment(x: &Vec3, [a, b]: &[Vec3; 2]) -> Vec3 {
    let along = b - a;
    let share = ((x - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    a + share * along
}

/// Nearest point of a triangle.
fn on_triangle(x: &Vec3, corner: &[Vec3; 3]) -> Vec3 {
    let [a, b, c] = corner;
    let normal = (b - a).cross(&(c - a));
    let square = normal.norm_squared();
    if square > 0.0 {
        let inside = |from: &Vec3, to: &Vec3| (to - from).cross(&(x - from)).dot(&normal) >= 0.0;
        if inside(a, b) && inside(b, c) && inside(c, a) {
            return x - normal * ((x - a).dot(&normal) / square);
        }
    }
    let edges = [[*a, *b], [*b, *c], [*c, *a]].map(|edge| on_segment(x, &edge));
    let distance = |p: &Vec3| (p - x).norm_squared();
    edges.into_iter().min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap_or(*a)
}
