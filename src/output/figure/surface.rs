//! What of a deformed body is seen: shares of its outer faces or discs, the nearest in front.
//!
//! Owns projection and hiding. Colours are not known here.

use super::canvas::Point;
use super::field::{Panel, View};
use crate::tensor::Vec3;
use std::collections::BTreeMap;

/// Something seen, on the plane of the view.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    /// The share of the surface that belongs to one position, by its corners, m, and its value.
    Share(Vec<Point>, f64),
    /// A sharp edge or the end of what is seen.
    Edge([Point; 2]),
    /// A disc by its centre and radius, m, and its value.
    Disc(Point, f64, f64),
}

/// Faces of a cell by its corners in VTK's order, each seen anticlockwise from outside.
const FACES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// Cosine of the angle between two faces from which their common edge is drawn.
const SHARP: f64 = 0.6;

/// Sine of the angle to the line of sight from which a face is seen: of one on edge there is but its outline.
const SEEN: f64 = 0.01;

/// The pieces of a panel in the order to draw them, the farthest first.
pub(super) fn pieces(panel: &Panel, view: &View) -> Vec<Piece> {
    if panel.faces.is_empty() { discs(panel, view) } else { shares(panel, view) }
}

fn project(view: &View, x: &Vec3) -> Point {
    (view.right.dot(x), view.up.dot(x))
}

/// The outer faces of cells: those no two of them share; corners that coincide are one.
pub(crate) fn outer_faces(hexahedra: &[[usize; 8]]) -> Vec<Vec<usize>> {
    let all = hexahedra.iter().flat_map(|cell| FACES.map(|face| face.map(|corner| cell[corner])));
    let mut keyed: Vec<(Vec<usize>, Vec<usize>)> = all
        .map(|face| {
            let mut corners = face.to_vec();
            corners.dedup();
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            let mut key = corners.clone();
            key.sort_unstable();
            (key, corners)
        })
        .filter(|(key, _)| key.len() > 2)
        .collect();
    keyed.sort();
    keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1).map(|same| same[0].1.clone()).collect()
}

/// A quarter of a face: the corner's, between the middles of the two edges that meet there.
struct Quarter {
    /// The corner before and the one after, anticlockwise.
    before: usize,
    after: usize,
    /// Middle of the face.
    centre: Vec3,
}

/// Every position's share of the faces turned towards the eye, in the colour of that position alone, so
/// that values which alternate from one position to the next are seen to do so.
fn shares(panel: &Panel, view: &View) -> Vec<Piece> {
    let towards = view.towards();
    // Along an axis the side of a strip that bulges is seen as a sliver; a line between it and the front
    // would look like a crease.
    let draws_sharp = towards.iter().filter(|part| part.abs() > 1e-9).count() > 1;
    let at = |i: usize| panel.positions[i];
    let mut quarters: BTreeMap<usize, Vec<Quarter>> = BTreeMap::new();
    // of every edge the unit normals of its faces, and whether they are seen
    let mut edges: BTreeMap<(usize, usize), Vec<(Vec3, bool)>> = BTreeMap::new();
    for face in &panel.faces {
        let n = face.len();
        let centre = face.iter().map(|&i| at(i)).sum::<Vec3>() / n as f64;
        let normal: Vec3 =
            (0..n).map(|k| (at(face[k]) - centre).cross(&(at(face[(k + 1) % n]) - centre))).sum();
        let is_seen = normal.dot(&towards) > SEEN * normal.norm();
        for k in 0..n {
            let (corner, after) = (face[k], face[(k + 1) % n]);
            let normal = normal.try_normalize(0.0).unwrap_or_default();
            edges.entry((corner.min(after), corner.max(after))).or_default().push((normal, is_seen));
            if is_seen {
                let before = face[(k + n - 1) % n];
                quarters.entry(corner).or_default().push(Quarter { before, after, centre });
            }
        }
    }
    let mut seen: Vec<(f64, Piece)> = Vec::new();
    for (corner, around) in quarters {
        for outline in outlines(corner, around, &at) {
            let depth = outline.iter().map(|x| towards.dot(x)).sum::<f64>() / outline.len() as f64;
            let corners = outline.iter().map(|x| project(view, x)).collect();
            seen.push((depth, Piece::Share(corners, panel.values[corner])));
        }
    }
    let reach = 1.5 * mean_length(panel, &edges);
    for ((a, b), faces) in edges {
        let is_end = faces.len() == 1 || faces.iter().any(|face| face.1 != faces[0].1);
        let is_sharp = draws_sharp && faces.windows(2).any(|pair| pair[0].0.dot(&pair[1].0) < SHARP);
        if faces.iter().any(|face| face.1) && (is_end || is_sharp) {
            let depth = 0.5 * towards.dot(&(at(a) + at(b)));
            // in front of the shares beside it, whose middles lie a cell or so away
            seen.push((depth + reach, Piece::Edge([project(view, &at(a)), project(view, &at(b))])));
        }
    }
    seen.sort_by(|a, b| a.0.total_cmp(&b.0));
    seen.into_iter().map(|(_, piece)| piece).collect()
}

fn mean_length(panel: &Panel, edges: &BTreeMap<(usize, usize), Vec<(Vec3, bool)>>) -> f64 {
    let sum: f64 = edges.keys().map(|&(a, b)| (panel.positions[a] - panel.positions[b]).norm()).sum();
    sum / edges.len().max(1) as f64
}

/// The outlines of the quarters around a corner: closed through the middles of the faces where they
/// surround it, through the corner itself where they end.
fn outlines(corner: usize, mut left: Vec<Quarter>, at: &dyn Fn(usize) -> Vec3) -> Vec<Vec<Vec3>> {
    let mut outlines = Vec::new();
    while !left.is_empty() {
        // a quarter none precedes, or any where they close
        let start = left.iter().position(|q| left.iter().all(|other| other.before != q.after)).unwrap_or(0);
        let mut chain = vec![left.swap_remove(start)];
        while let Some(next) = left.iter().position(|q| q.after == chain[chain.len() - 1].before) {
            chain.push(left.swap_remove(next));
        }
        let middle = |other: usize| 0.5 * (at(corner) + at(other));
        let (first, last) = (&chain[0], &chain[chain.len() - 1]);
        let mut outline = Vec::new();
        let closes = first.after == last.before && chain.len() > 1;
        if !closes {
            outline.extend([at(corner), middle(first.after)]);
        }
        for quarter in &chain {
            outline.push(quarter.centre);
            if closes || !std::ptr::eq(quarter, last) {
                outline.push(middle(quarter.before));
            }
        }
        if !closes {
            outline.push(middle(last.before));
        }
        outlines.push(outline);
    }
    outlines
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
    fn grid(n: usize) -> Panel {
        let m = n + 1;
        let at = |i: usize, j: usize, k: usize| i + m * (j + m * k);
        let mut panel = Panel { spacing: 1.0 / n as f64, ..Panel::default() };
        let mut hexahedra = Vec::new();
        for (k, j, i) in (0..m * m * m).map(|c| (c / (m * m), c / m % m, c % m)) {
            panel.positions.push(Vec3::new(i as f64, j as f64, k as f64) / n as f64);
            panel.values.push((i + j + k) as f64);
            if i < n && j < n && k < n {
                let layer = |k| [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)];
                let (low, high) = (layer(k), layer(k + 1));
                hexahedra.push(std::array::from_fn(|c| if c < 4 { low[c] } else { high[c - 4] }));
            }
        }
        panel.faces = outer_faces(&hexahedra);
        panel
    }

    fn area(corners: &[Point]) -> f64 {
        let n = corners.len();
        let cross = |a: Point, b: Point| a.0 * b.1 - b.0 * a.1;
        0.5 * (0..n).map(|i| cross(corners[i], corners[(i + 1) % n])).sum::<f64>()
    }

    fn seen(panel: &Panel, view: &View) -> (Vec<(f64, f64)>, usize) {
        let pieces = pieces(panel, view);
        let share = |piece: &Piece| match piece {
            Piece::Share(corners, value) => Some((area(corners), *value)),
            _ => None,
        };
        let shares: Vec<(f64, f64)> = pieces.iter().filter_map(share).collect();
        let edges = pieces.iter().filter(|piece| matches!(piece, Piece::Edge(_))).count();
        (shares, edges)
    }

    #[test]
    fn along_an_axis_the_shares_of_one_side_cover_it_and_end_at_its_rim() {
        let (shares, edges) = seen(&grid(3), &View::default());
        // 4 corners of a quarter cell, 8 on the rim of a half, 4 inside of a whole one, which is 1/9
        let mut areas: Vec<f64> = shares.iter().map(|share| 36.0 * share.0).collect();
        areas.sort_by(f64::total_cmp);
        let expected = [1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 4.0, 4.0, 4.0, 4.0];
        assert_eq!(areas.len(), 16);
        assert!(areas.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{areas:?}");
        assert_eq!(edges, 12);
    }

    #[test]
    fn obliquely_three_sides_are_seen_with_their_common_edges() {
        let view = View::oblique();
        let (shares, edges) = seen(&grid(3), &view);
        let normal = view.towards();
        let covered: f64 = shares.iter().map(|share| share.0).sum();
        assert!((covered - normal.iter().map(|n| n.abs()).sum::<f64>()).abs() < 1e-12);
        assert_eq!(edges, 9 * 3);
    }

    #[test]
    fn a_share_has_the_value_of_its_own_position_and_of_no_other() {
        let mut panel = grid(4);
        for (x, value) in panel.positions.iter().zip(&mut panel.values) {
            let parity = libm::round(4.0 * (x.x + x.y)) as i64 % 2;
            *value = parity as f64;
        }
        let (shares, _) = seen(&panel, &View::default());
        assert!(shares.iter().all(|share| share.1 == 0.0 || share.1 == 1.0));
        assert_eq!(shares.iter().filter(|share| share.1 == 1.0).count(), 12);
    }

    #[test]
    fn of_discs_behind_one_another_only_the_nearest_are_kept_and_drawn_last() {
        let panel = Panel { faces: vec![], ..grid(4) };
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
        let value = |piece: &Piece| match piece {
            Piece::Share(_, value) | Piece::Disc(_, _, value) => *value,
            Piece::Edge(_) => f64::NAN,
        };
        let order: Vec<f64> = pieces(&pair, &View::default()).iter().map(value).collect();
        assert_eq!(order, [2.0, 1.0]);
    }

    #[test]
    fn a_mirror_image_shows_the_same_side_twice_as_wide_without_a_seam() {
        let whole = grid(2).mirrored(0, 0.0, false);
        let (shares, edges) = seen(&whole, &View::default());
        assert_eq!((shares.len(), edges), (15, 12));
        assert!((shares.iter().map(|share| share.0).sum::<f64>() - 2.0).abs() < 1e-12);
        let back = View { right: -Vec3::x(), up: Vec3::y() };
        assert_eq!(seen(&whole, &back).0.len(), 15);
    }

    #[test]
    fn a_field_that_a_mirror_turns_round_changes_its_sign() {
        let whole = grid(1).mirrored(0, 0.0, true);
        let image = whole.positions.iter().position(|x| x.x == -1.0 && x.y == 1.0 && x.z == 1.0);
        assert_eq!(image.map(|i| whole.values[i]), Some(-3.0));
    }
}
