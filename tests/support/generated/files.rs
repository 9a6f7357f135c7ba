//! Bodies as files of other programs: random hulls and star-shaped surfaces as STL, hexahedra with displaced nodes as VTU.
//!
//! Owns their points and the two formats. Knows no language.

use crate::random::Random;
use std::fmt::Write;

/// Corners, counter-clockwise seen from outside.
type Triangle = [[f64; 3]; 3];

/// A number between -1 and 1.
fn share(random: &mut Random) -> f64 {
    (random.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A point of the unit sphere.
fn direction(random: &mut Random) -> [f64; 3] {
    let n = [share(random), share(random), share(random)];
    let length = dot(n, n).sqrt();
    if (0.1..=1.0).contains(&length) { n.map(|x| x / length) } else { direction(random) }
}

/// The hull of points of an ellipsoid: each three that all others lie on one side of.
pub fn hull(axes: [f64; 3], count: usize, seed: u64) -> Vec<Triangle> {
    let mut random = Random(seed);
    let points: Vec<[f64; 3]> = (0..count)
        .map(|_| {
            let n = direction(&mut random);
            [0, 1, 2].map(|i| axes[i] * n[i])
        })
        .collect();
    let mut triangles = Vec::new();
    for i in 0..count {
        for j in i + 1..count {
            for k in j + 1..count {
                let [a, b, c] = [points[i], points[j], points[k]];
                let normal = cross(minus(b, a), minus(c, a));
                let heights = || points.iter().map(|p| dot(minus(*p, a), normal));
                if heights().all(|height| height <= 1e-12) {
                    triangles.push([a, b, c]);
                } else if heights().all(|height| height >= -1e-12) {
                    triangles.push([a, c, b]);
                }
            }
        }
    }
    triangles
}

/// A sphere of 128 triangles with bumps and dents.
pub fn star(radius: f64, bump: f64, seed: u64) -> Vec<Triangle> {
    let mut random = Random(seed);
    let bumps: Vec<([f64; 3], f64)> =
        (0..4).map(|_| (direction(&mut random), bump * share(&mut random))).collect();
    let at = |n: [f64; 3]| {
        let length = dot(n, n).sqrt();
        let n = n.map(|x| x / length);
        let sum: f64 = bumps.iter().map(|(m, by)| by * (4.0 * (dot(n, *m) - 1.0)).exp()).sum();
        n.map(|x| radius * (1.0 + sum) * x)
    };
    let mut faces: Vec<Triangle> = Vec::new();
    for octant in 0..8 {
        let sign = |bit: usize| if octant >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let [x, y, z] = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        faces.push(if sign(0) * sign(1) * sign(2) > 0.0 { [x, y, z] } else { [x, z, y] });
    }
    for _ in 0..2 {
        let middle = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
        let split = |[a, b, c]: Triangle| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(split).collect();
    }
    faces.into_iter().map(|triangle| triangle.map(at)).collect()
}

/// Triangles as text, moved by `at` along each axis.
pub fn stl(triangles: &[Triangle], at: f64) -> String {
    let mut text = String::from("solid body\n");
    for triangle in triangles {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for p in triangle {
            let [x, y, z] = p.map(|c| c + at);
            let _ = writeln!(text, "vertex {x:.9e} {y:.9e} {z:.9e}");
        }
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid body\n"
}

/// A block of hexahedra with displaced nodes.
pub fn vtu(cells: [usize; 3], by: f64, surface: bool, seed: u64, at: f64) -> String {
    let mut random = Random(seed);
    let nodes = cells.map(|n| n + 1);
    let (mut points, mut corners) = (String::new(), String::new());
    for k in 0..nodes[2] {
        for j in 0..nodes[1] {
            for i in 0..nodes[0] {
                let index = [i, j, k];
                let moved = [share(&mut random), share(&mut random), share(&mut random)];
                let is_inner = (0..3).all(|axis| (1..cells[axis]).contains(&index[axis]));
                let by = if surface || is_inner { by } else { 0.0 };
                let p = [0, 1, 2].map(|axis| at + index[axis] as f64 + by * moved[axis]);
                let _ = writeln!(points, "{:.9e} {:.9e} {:.9e}", p[0], p[1], p[2]);
                if (0..3).all(|axis| index[axis] < cells[axis]) {
                    let node = |i: usize, j: usize, k: usize| (k * nodes[1] + j) * nodes[0] + i;
                    let ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                    for (i, j, k) in [k, k + 1].into_iter().flat_map(|k| ring.map(|(i, j)| (i, j, k))) {
                        let _ = write!(corners, "{} ", node(i, j, k));
                    }
                }
            }
        }
    }
    let count: usize = cells.iter().product();
    let offsets: String = (1..=count).map(|n| format!("{} ", 8 * n)).collect();
    let points_count: usize = nodes.iter().product();
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{points_count}\" NumberOfCells=\"{count}\">\n\
         <Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n{points}</DataArray>\n</Points>\n\
         <Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">{corners}</DataArray>\n\
         <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">{offsets}</DataArray>\n\
         <DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">{}</DataArray>\n</Cells>\n\
         </Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
        "12 ".repeat(count)
    )
}
