//! Shapes of generated bodies, in spacings, as text.
//!
//! Owns the drawing and the words. Knows no material, no load and no run.

use super::files::{hull, star, stl, vtu};
use super::number;
use proptest::prelude::*;

/// A shape; lengths are in spacings.
#[derive(Debug, Clone)]
pub enum Shape {
    /// Edges along the axes.
    Block([f64; 3]),
    /// Radius and height, along an axis.
    Cylinder(f64, f64, usize),
    /// A cylinder less one of its height, by radius and offset: a tube, an eccentric tube, a crescent.
    Tube(f64, f64, f64, f64),
    /// A block less a cylinder along z: its edges, radius and offset.
    Plate([f64; 3], f64, f64),
    /// A cylinder less a ring of holes: radius, height, holes, their radius.
    Colander(f64, f64, usize, f64),
    /// A block and a taller one beside it: edges of the first, of the second.
    Angle([f64; 3], [f64; 2]),
    /// A block and a cylinder through its end: edges, radius.
    Head([f64; 3], f64),
    /// Two blocks on each other that are bonded: edges, height and cells of the upper one across, jitter of both.
    Bonded([f64; 3], f64, f64),
    /// The hull of random points: semi-axes, points, seed.
    Hull([f64; 3], usize, u64),
    /// A star-shaped body: radius, bumps of a share of it, seed.
    Star(f64, f64, u64),
    /// Hexahedra of a file: cells, displacement of nodes in spacings, whether the surface's too, seed.
    Mesh([usize; 3], f64, bool, u64),
}

/// Shapes of some 30 to 300 nodes; the simplest first, which shrinking tends to.
pub fn shapes() -> impl Strategy<Value = Shape> {
    let edge = || 2.0..5.0_f64;
    let whole = || (2..5_usize).prop_map(|n| n as f64);
    prop_oneof![
        4 => [whole(), whole(), whole()].prop_map(Shape::Block),
        1 => (whole(), whole(), edge()).prop_map(|(x, y, z)| Shape::Block([x, y, z])),
        2 => (1.5..3.0_f64, whole(), 0..3_usize).prop_map(|(r, h, axis)| Shape::Cylinder(r, h, axis)),
        2 => (2.2..4.0_f64, whole(), 0.5..1.0_f64, 0.0..0.5_f64)
            .prop_map(|(r, h, inner, off)| Shape::Tube(r, h, inner * r, off * r)),
        2 => ([4.0..6.0_f64, 4.0..6.0, 2.0..3.5].prop_map(|e| e.map(f64::round)), 1.0..1.9_f64, 0.0..0.5_f64)
            .prop_map(|(e, r, off)| Shape::Plate(e, r, off)),
        1 => (3.5..4.5_f64, (2..4_u32).prop_map(f64::from), 2..5_usize, 0.8..1.2_f64)
            .prop_map(|(r, h, n, hole)| Shape::Colander(r, h, n, hole)),
        2 => ([whole(), whole(), whole()], [whole(), whole()]).prop_map(|(a, b)| Shape::Angle(a, b)),
        1 => ([edge(), edge(), edge()], 1.2..2.5_f64).prop_map(|([x, y, z], r)| Shape::Head([x, y.max(r + 0.5), z.round()], r)),
        2 => ([whole(), whole(), whole()], whole(), prop_oneof![Just(1.0), Just(0.5), Just(0.75)])
            .prop_map(|([x, y, z], h, ratio)| match ratio == 0.75 {
                true => Shape::Bonded([3.0, 3.0, z], 0.75 * h, ratio),
                false => Shape::Bonded([x, y, z], h, ratio),
            }),
        2 => ([1.5..3.0_f64, 1.5..3.0, 1.5..3.0], 6..14_usize, any::<u64>())
            .prop_map(|(axes, n, seed)| Shape::Hull(axes, n, seed)),
        2 => (1.6..2.8_f64, 0.0..0.35_f64, any::<u64>()).prop_map(|(r, bump, seed)| Shape::Star(r, bump, seed)),
        2 => ([2..5_usize, 2..5, 2..5], 0.0..0.35_f64, any::<bool>(), any::<u64>())
            .prop_map(|(n, by, surface, seed)| Shape::Mesh(n, by, surface, seed)),
    ]
}

/// What the bodies of a scene are made of in text.
pub struct Described {
    /// Name, shape and spacing of each body as written.
    pub bodies: Vec<(&'static str, String, f64)>,
    /// The line that bonds them.
    pub bond: Option<String>,
    /// Names and bytes of files beside the text.
    pub files: Vec<(&'static str, String)>,
    /// Body and face, of those a load or support may be written for.
    pub faces: Vec<(&'static str, &'static str)>,
}

const PLANES: [&str; 6] = ["xmin", "xmax", "ymin", "ymax", "zmin", "zmax"];

/// Middle of the body at a place, in spacings.
fn centre(at: f64, unit: f64, shift: [f64; 3]) -> String {
    let [x, y, z] = shift.map(|s| number((at + s) * unit));
    format!("centre = [{x} m, {y} m, {z} m]")
}

fn block([x, y, z]: [f64; 3], place: &str, unit: f64) -> String {
    let [x, y, z] = [x, y, z].map(|e| number(e * unit));
    format!("box({x} m, {y} m, {z} m, {place})")
}

fn cylinder(radius: f64, height: f64, axis: usize, place: &str, unit: f64) -> String {
    let axis = ["", ", axis = y", ", axis = x"][[2, 1, 0][axis]];
    format!(
        "cylinder(radius = {} m, height = {} m{axis}, {place})",
        number(radius * unit),
        number(height * unit)
    )
}

impl Shape {
    /// The shape in text, `unit` m a spacing, its middle at `at` spacings along each axis.
    pub fn describe(&self, unit: f64, at: f64) -> Described {
        let here = |shift: [f64; 3]| centre(at, unit, shift);
        let middle = here([0.0; 3]);
        let on = |faces: &[&'static str]| faces.iter().map(|face| ("a", *face)).collect::<Vec<_>>();
        let mut files = Vec::new();
        let mut bond = None;
        let mut spacing = vec![unit];
        let (texts, faces) = match self {
            Self::Block(edges) => (vec![block(*edges, &middle, unit)], on(&PLANES)),
            Self::Cylinder(radius, height, axis) => {
                let ends = &PLANES[2 * axis..2 * axis + 2];
                let text = cylinder(*radius, *height, *axis, &middle, unit);
                (vec![text], on(&[ends[0], ends[1], "side"]))
            }
            Self::Tube(outer, height, inner, off) => {
                let whole = cylinder(*outer, *height, 2, &middle, unit);
                let hole = cylinder(*inner, *height, 2, &here([*off, 0.0, 0.0]), unit);
                (vec![format!("{whole} - {hole}")], on(&["zmin", "zmax", "side", "hole"]))
            }
            Self::Plate(edges, radius, off) => {
                let hole = cylinder(*radius, edges[2], 2, &here([*off, 0.0, 0.0]), unit);
                let faces: Vec<_> = PLANES.into_iter().chain(["hole"]).collect();
                (vec![format!("{} - {hole}", block(*edges, &middle, unit))], on(&faces))
            }
            Self::Colander(radius, height, count, hole) => {
                let of = cylinder(*hole, *height, 2, &middle, unit);
                let ring = number(0.5 * radius * unit);
                let ring = format!("ring(count = {count}, radius = {ring} m, of = {of})");
                let whole = cylinder(*radius, *height, 2, &middle, unit);
                (vec![format!("{whole} - {ring}")], on(&["zmin", "zmax", "side", "hole"]))
            }
            Self::Angle(edges, [width, height]) => {
                // side by side along x, standing on one plane
                let shift = [0.5 * (edges[0] + width), 0.5 * (height - edges[1]), 0.0];
                let other = block([*width, *height, edges[2]], &here(shift), unit);
                (vec![format!("{} + {other}", block(*edges, &middle, unit))], on(&PLANES))
            }
            Self::Head(edges, radius) => {
                let disc = cylinder(*radius, edges[2], 2, &here([0.5 * edges[0], 0.0, 0.0]), unit);
                (vec![format!("{} + {disc}", block(*edges, &middle, unit))], on(&["zmin", "zmax", "xmin"]))
            }
            Self::Bonded(edges, height, ratio) => {
                let shift = [0.0, 0.0, 0.5 * (edges[2] + height)];
                let upper = block([edges[0], edges[1], *height], &here(shift), unit);
                bond = Some("bond a.zmax { to = b.zmin }".to_string());
                spacing.push(ratio * unit);
                let below = on(&["xmin", "xmax", "ymin", "ymax", "zmin"]);
                let faces = below.into_iter().chain([("b", "zmax"), ("b", "xmax"), ("b", "ymin")]).collect();
                (vec![block(*edges, &middle, unit), upper], faces)
            }
            Self::Hull(axes, points, seed) => {
                files.push(("body.stl", stl(&hull(*axes, *points, *seed), at)));
                (vec![format!("stl(\"body.stl\", scale = {} m)", number(unit))], on(&["surface"]))
            }
            Self::Star(radius, bump, seed) => {
                files.push(("body.stl", stl(&star(*radius, *bump, *seed), at)));
                (vec![format!("stl(\"body.stl\", scale = {} m)", number(unit))], on(&["surface"]))
            }
            Self::Mesh(cells, by, surface, seed) => {
                files.push(("body.vtu", vtu(*cells, *by, *surface, *seed, at)));
                let faces = if *surface && *by > 0.0 { on(&["surface"]) } else { on(&PLANES) };
                (vec![format!("vtu(\"body.vtu\", scale = {} m)", number(unit))], faces)
            }
        };
        let bodies = ["a", "b"].into_iter().zip(texts).zip(spacing).map(|((a, b), c)| (a, b, c)).collect();
        Described { bodies, bond, files, faces }
    }

    /// Whether the body is its own mirror image about planes through its middle.
    pub fn is_symmetric(&self) -> bool {
        matches!(self, Self::Block(_) | Self::Cylinder(..))
            || matches!(self, Self::Tube(_, _, _, off) | Self::Plate(_, _, off) if *off == 0.0)
    }
}
