//! What of a deformed body is seen: outer faces or discs, the nearest in front.
//!
//! Owns projection and hiding. Colours are not known here.

use super::canvas::Point;
use super::field::{Panel, View};
use crate::tensor::Vec3;

/// Something seen, on the plane of the view.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    /// A face by its corners, m, and its mean value.
    Face([Point; 4], f64),
    /// A disc by its centre and radius, m, and its value.
    Disc(Point, f64, f64),
}

/// Faces of a cell by its corners in VTK's order, each seen anticlockwise from outside.
const FACES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// The pieces of a panel in the order to draw them, the farthest first.
pub(super) fn pieces(panel: &Panel, view: &View) -> Vec<Piece> {
    if panel.hexahedra.is_empty() { discs(panel, view) } else { faces(panel, view) }
}

fn project(view: &View, x: &Vec3) -> Point {
    (view.right.dot(x), view.up.dot(x))
}

/// Outer faces turned towards the eye.
fn faces(panel: &Panel, view: &View) -> Vec<Piece> {
    let all = panel.hexahedra.iter().flat_map(|cell| FACES.map(|face| face.map(|corner| cell[corner])));
    let mut keyed: Vec<([usize; 4], [usize; 4])> = all
        .map(|face| {
            let mut key = face;
            key.sort_unstable();
            (key, face)
        })
        .collect();
    keyed.sort();
    // A face two cells share is inside.
    let outer = keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1).map(|same| same[0].1);
    let towards = view.towards();
    let mut seen: Vec<(f64, Piece)> = outer
        .filter_map(|face| {
            let corners = face.map(|i| panel.positions[i]);
            let normal = (corners[2] - corners[0]).cross(&(corners[3] - corners[1]));
            let depth = 0.25 * corners.iter().map(|x| towards.dot(x)).sum::<f64>();
            let value = 0.25 * face.iter().map(|&i| panel.values[i]).sum::<f64>();
            let piece = Piece::Face(corners.map(|x| project(view, &x)), value);
            (normal.dot(&towards) > 0.0).then_some((depth, piece))
        })
        .collect();
    seen.sort_by(|a, b| a.0.total_cmp(&b.0));
    seen.into_iter().map(|(_, piece)| piece).collect()
}

/// Discs of which some part is seen.
fn discs(panel: &Panel, view: &View) -> Vec<Piece> {
    let towards = view.towards();
    // Half the diagonal of a cell, so that a body shows no gaps until it is stretched much.
    let radius = 0.72 * panel.spacing;
    let mut order: Vec<usize> = (0..panel.positions.len()).collect();
    order.sort_by(|&a, &b| {
        let depth = |i: usize| towards.dot(&panel.positions[i]);
        depth(b).total_cmp(&depth(a)).then(a.cmp(&b))
    });
    // From the nearest on, a disc is hidden when every sixth of the spacing of it is covered.
    let cell = panel.spacing / 6.0;
    let mut covered = std::collections::HashSet::new();
    let mut seen = Vec::new();
    for i in order {
        let (x, y) = project(view, &panel.positions[i]);
        let reach = libm::ceil(radius / cell) as i64;
        // Grid cells are counted from the origin; bodies are some thousand spacings wide at most.
        let (column, row) = (libm::floor(x / cell) as i64, libm::floor(y / cell) as i64);
        let mut adds = false;
        for a in column - reach..=column + reach {
            for b in row - reach..=row + reach {
                let middle = ((a as f64 + 0.5) * cell, (b as f64 + 0.5) * cell);
                if libm::hypot(middle.0 - x, middle.1 - y) < radius {
                    adds |= covered.insert((a, b));
                }
            }
        }
        if adds {
            seen.push(Piece::Disc((x, y), radius, panel.values[i]));
        }
    }
    seen.reverse();
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodes of a grid of `n` cells a side with edge 1.
    pub(crate) fn grid(n: usize) -> Panel {
        let m = n + 1;
        let at = |i: usize, j: usize, k: usize| i + m * (j + m * k);
        let mut panel = Panel { spacing: 1.0 / n as f64, ..Panel::default() };
        for k in 0..m {
            for j in 0..m {
                for i in 0..m {
                    panel.positions.push(Vec3::new(i as f64, j as f64, k as f64) / n as f64);
                    panel.values.push((i + j + k) as f64);
                }
            }
        }
        for k in 0..n {
            for j in 0..n {
                for i in 0..n {
                    let layer = |k| [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)];
                    let (low, high) = (layer(k), layer(k + 1));
                    panel.hexahedra.push(std::array::from_fn(|c| if c < 4 { low[c] } else { high[c - 4] }));
                }
            }
        }
        panel
    }

    #[test]
    fn along_an_axis_one_side_of_a_cube_is_seen_and_obliquely_three() {
        assert_eq!(pieces(&grid(3), &View::default()).len(), 9);
        assert_eq!(pieces(&grid(3), &View::oblique()).len(), 27);
        let Piece::Face(corners, _) = pieces(&grid(1), &View::default())[0] else { panic!("a face") };
        assert_eq!(corners, [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    }

    #[test]
    fn of_discs_behind_one_another_only_the_nearest_are_kept_and_drawn_last() {
        let panel = Panel { hexahedra: vec![], ..grid(4) };
        let seen = pieces(&panel, &View::default());
        assert_eq!(seen.len(), 25, "125 positions in five layers");
        let nearest = panel.values[124];
        assert!(seen.iter().any(|piece| matches!(piece, Piece::Disc(_, _, value) if *value == nearest)));
        let pair = Panel {
            positions: vec![Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.5, 0.0, 0.0)],
            values: vec![1.0, 2.0],
            spacing: 1.0,
            ..Panel::default()
        };
        let order: Vec<f64> = pieces(&pair, &View::default())
            .iter()
            .map(|piece| match piece {
                Piece::Face(_, value) | Piece::Disc(_, _, value) => *value,
            })
            .collect();
        assert_eq!(order, [2.0, 1.0]);
    }

    #[test]
    fn a_mirror_image_shows_the_same_faces_from_the_other_side() {
        let whole = grid(2).mirrored(0, 0.0);
        assert_eq!(pieces(&whole, &View::default()).len(), 8);
        let back = View { right: -Vec3::x(), up: Vec3::y() };
        assert_eq!(pieces(&whole, &back).len(), 8);
    }
}
