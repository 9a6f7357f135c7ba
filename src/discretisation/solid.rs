//! Bodies bounded by triangles, as a file gives them.
//!
//! Owns the closed surface: whether it is closed, its inside, plane ends, sharp edges and mirror images. Knows no grid
//! and no file format.

use super::error::DiscretisationError;
use super::nearest::Nearest;
use crate::tensor::Vec3;
use std::collections::BTreeMap;

/// Share of the body's size within which two vertices are one.
const WELD: f64 = 1e-7;

/// Cosine of the angle between two triangles, 40°, below which their common edge is a sharp one.
const SHARP: f64 = 0.766;

/// Share of the body's size by which a surface and its mirror image may differ.
const ALIKE: f64 = 1e-3;

/// A closed surface of triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// Corners, counter-clockwise seen from outside, m.
    pub(super) triangle: Vec<[Vec3; 3]>,
    /// Edges at which the surface bends by more than 40°, m.
    pub(super) sharp: Vec<[Vec3; 2]>,
    low: Vec3,
    high: Vec3,
    /// Whether each end of each axis, least first, is a plane face.
    flat: [[bool; 2]; 3],
    /// Whether anything is left that is no plane end.
    curved: bool,
}

impl Solid {
    /// A solid from triangles in any order and of any common orientation.
    ///
    /// Vertices closer than 1e-7 of the size are one; triangles that this makes lines are left out.
    ///
    /// # Errors
    /// [`DiscretisationError::NoSurface`] without volume, [`DiscretisationError::OpenSurface`] if an edge does not
    /// belong to two triangles that agree on what is outside.
    pub fn new(triangles: &[[Vec3; 3]]) -> Result<Self, DiscretisationError> {
        let points = || triangles.iter().flatten();
        let finite = points().all(|x| x.iter().all(|c| c.is_finite()));
        let low = points().fold(Vec3::repeat(f64::INFINITY), |low, x| low.inf(x));
        let high = points().fold(Vec3::repeat(f64::NEG_INFINITY), |high, x| high.sup(x));
        if triangles.is_empty() || !finite || (high - low).min() <= 0.0 {
            return Err(DiscretisationError::NoSurface { triangles: triangles.len() });
        }
        let size = (high - low).norm();
        let (vertex, index) = weld(triangles, WELD * size);
        let mut faces: Vec<[u32; 3]> =
            index.into_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect();
        closed(&vertex, &faces)?;
        let volume = |faces: &[[u32; 3]]| -> f64 {
            let six = |f: &[u32; 3]| {
                let [a, b, c] = f.map(|v| vertex[v as usize] - low);
                a.dot(&b.cross(&c))
            };
            faces.iter().map(six).sum::<f64>() / 6.0
        };
        if volume(&faces) < 0.0 {
            faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        // NaN included
        if volume(&faces).partial_cmp(&(WELD * size * size * size)) != Some(std::cmp::Ordering::Greater) {
            return Err(DiscretisationError::NoSurface { triangles: faces.len() });
        }
        let triangle: Vec<[Vec3; 3]> = faces.iter().map(|face| face.map(|v| vertex[v as usize])).collect();
        let on = |t: &[Vec3; 3], axis: usize, at: f64| t.iter().all(|x| (x[axis] - at).abs() <= WELD * size);
        let flat =
            [0, 1, 2].map(|axis| [low[axis], high[axis]].map(|at| triangle.iter().any(|t| on(t, axis, at))));
        let plane = |t: &[Vec3; 3]| (0..3).any(|axis| on(t, axis, low[axis]) || on(t, axis, high[axis]));
        let curved = triangle.iter().any(|t| !plane(t));
        let sharp = sharp_edges(&vertex, &faces);
        Ok(Self { triangle, sharp, low, high, flat, curved })
    }

    /// Least and greatest coordinates, m.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        (self.low, self.high)
    }

    /// Names of its faces: plane ends by their axis, all else is `surface`.
    pub fn face_names(&self) -> Vec<&'static str> {
        const PLANES: [&str; 6] = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"];
        let flat = (0..6).filter(|&k| self.flat[k / 2][k % 2]).map(|k| PLANES[k]);
        flat.chain(self.curved.then_some("surface")).collect()
    }

    /// Whether an end of an axis is a plane face.
    pub(super) fn is_flat(&self, axis: usize, greater: bool) -> bool {
        self.flat[axis][usize::from(greater)]
    }

    /// Whether the mirror image of every vertex in the plane `X_axis = at` lies on the surface, to a thousandth of the
    /// size: triangles of a symmetric body seldom are symmetric, and cut that much off it themselves.
    pub(super) fn is_symmetric(&self, axis: usize, at: f64) -> bool {
        let size = (self.high - self.low).norm();
        let nearest = Nearest::new(self, size / 32.0);
        let image = |x: &Vec3| {
            let mut image = *x;
            image[axis] = 2.0 * at - x[axis];
            image
        };
        self.triangle.iter().flatten().all(|x| nearest.surface(&image(x), ALIKE * size).is_some())
    }

    /// Coordinates at which a line along x enters and leaves the solid, ascending.
    ///
    /// A line through an edge may miss or hit both of its triangles; whoever asks moves it a little.
    pub(super) fn crossings(&self, y: f64, z: f64) -> Vec<f64> {
        let side = |a: &Vec3, b: &Vec3| (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
        let mut found: Vec<f64> = self
            .triangle
            .iter()
            .filter_map(|[a, b, c]| {
                let (u, v, w) = (side(b, c), side(c, a), side(a, b));
                let inside = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
                inside.then(|| (u * a.x + v * b.x + w * c.x) / (u + v + w))
            })
            .collect();
        found.sort_by(f64::total_cmp);
        found
    }
}

/// Vertices without repetition, and the triangles by their indices.
fn weld(triangles: &[[Vec3; 3]], tolerance: f64) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let cube = |x: &Vec3| -> [i64; 3] { [0, 1, 2].map(|i| libm::round(x[i] / (4.0 * tolerance)) as i64) };
    let mut bins: BTreeMap<[i64; 3], Vec<u32>> = BTreeMap::new();
    let mut vertex: Vec<Vec3> = Vec::new();
    let mut index_of = |x: &Vec3| -> u32 {
        let at = cube(x);
        for i in -1..=1 {
            for j in -1..=1 {
                for k in -1..=1 {
                    let near = bins.get(&[at[0] + i, at[1] + j, at[2] + k]).into_iter().flatten();
                    for &known in near {
                        if (vertex[known as usize] - x).norm() <= tolerance {
                            return known;
                        }
                    }
                }
            }
        }
        let index = vertex.len() as u32;
        vertex.push(*x);
        bins.entry(at).or_default().push(index);
        index
    };
    let faces = triangles.iter().map(|t| [index_of(&t[0]), index_of(&t[1]), index_of(&t[2])]).collect();
    (vertex, faces)
}

/// Every edge must run once in each direction.
fn closed(vertex: &[Vec3], faces: &[[u32; 3]]) -> Result<(), DiscretisationError> {
    let mut count: BTreeMap<(u32, u32), i32> = BTreeMap::new();
    for [a, b, c] in faces {
        for edge in [(*a, *b), (*b, *c), (*c, *a)] {
            *count.entry(edge).or_default() += 1;
        }
    }
    let single =
        |(edge, times): &(&(u32, u32), &i32)| **times != 1 || count.get(&(edge.1, edge.0)) != Some(&1);
    let mut open = count.iter().filter(single);
    let Some(((a, b), _)) = open.next() else { return Ok(()) };
    let position = 0.5 * (vertex[*a as usize] + vertex[*b as usize]);
    Err(DiscretisationError::OpenSurface { edges: 1 + open.count(), position })
}

fn sharp_edges(vertex: &[Vec3], faces: &[[u32; 3]]) -> Vec<[Vec3; 2]> {
    let at = |v: u32| vertex[v as usize];
    let normal = |[a, b, c]: &[u32; 3]| (at(*b) - at(*a)).cross(&(at(*c) - at(*a))).normalize();
    let mut left: BTreeMap<(u32, u32), Vec3> = BTreeMap::new();
    for face @ [a, b, c] in faces {
        left.extend([((*a, *b), normal(face)), ((*b, *c), normal(face)), ((*c, *a), normal(face))]);
    }
    let sharp = |(a, b): &(u32, u32), n: &Vec3| {
        a < b && left.get(&(*b, *a)).is_some_and(|other| n.dot(other) < SHARP)
    };
    left.iter().filter(|(edge, n)| sharp(edge, n)).map(|((a, b), _)| [at(*a), at(*b)]).collect()
}
