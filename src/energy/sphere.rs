//! Rules of quadrature over directions: the whole sphere, or the part inside a cone.
//!
//! Owns which directions a law is evaluated in and with which weights. Knows nothing of the integrand
//! but whether it tells a direction from its opposite.

use super::lanes::{Vector, ZERO};
use super::program::{LANES, Row};
use super::stretch::symmetric_eigen;
use crate::expression::gauss_legendre;
use crate::tensor::Mat3;
use std::f64::consts::PI;

/// A product rule: Gauss's in the height along an axis, in the longitude about it equal steps or Gauss's.
///
/// ```text
/// ∫ f dS = Σ_j v_j ∫ f(z, φ_j) dz,    n = z a + √(1 − z²) (cos φ b + sin φ c)
/// ```
///
/// On the whole sphere `a, b, c` are the common axes, heights those of the symmetric rule and longitudes
/// equally spaced: exact for polynomials in `n` of the degree asked for. Inside a cone `n · S n > t` they are the
/// eigenvectors of `S`, the axis the one whose eigenvalue has its sign relative to `t` alone. Then each meridian
/// meets the cone once, at `z² = −m(φ)/(s_a − t − m(φ))`, `m = (s_b − t) cos² φ + (s_c − t) sin² φ`, and Gauss's rule
/// on the arc inside sees a smooth integrand although it ends at the cone.
///
/// Where the middle eigenvalue is near `t` (a sheet that keeps its width, simple shear) the cone is nearly
/// two planes through `b`, and the end of the arcs has a corner at `φ = 0` and `π`: Gauss's rule on either
/// half circle puts it at an end. At order 16 the stress of fibres then errs by 5e-7 instead of 6e-4, their
/// tangent by 1e-5 instead of 4e-2; elsewhere equal steps err by 1e-13 and less.
#[derive(Debug, Clone)]
pub(super) struct Rule {
    /// Height and weight; on the whole sphere of the upper half only.
    heights: Vec<(f64, f64)>,
    /// Equally spaced longitudes.
    spaced: Vec<Longitude>,
    /// As many by Gauss's rule on either half circle.
    halves: Vec<Longitude>,
    /// The bound of the cone, where there is one.
    above: Option<f64>,
    /// Whether opposite directions count alike, so that one of them is enough.
    is_even: bool,
}

#[derive(Debug, Clone, Copy)]
struct Longitude {
    cos: f64,
    sin: f64,
    weight: f64,
}

impl Longitude {
    fn new(angle: f64, weight: f64) -> Self {
        Self { cos: libm::cos(angle), sin: libm::sin(angle), weight }
    }
}

/// Largest order of a rule; a cone's has 49 923 directions then.
pub const LARGEST_ORDER: u16 = 256;

/// Share of the middle eigenvalue in the outer one of its sign below which a cone is nearly two planes.
const NEARLY_PLANES: f64 = 0.5;

impl Rule {
    /// The rule of a degree, inside a cone of the bound `above`.
    pub(super) fn new(order: u16, above: Option<f64>, is_even: bool) -> Self {
        let order = usize::from(order.clamp(1, LARGEST_ORDER));
        // even numbers, so that the opposite of a direction is one of the rule too
        let (heights, count) = match above {
            Some(_) => (gauss_legendre(order / 2 + 1), 2 * (3 * order / 4 + 2)),
            None => {
                let half = order / 4 + 1;
                let all = gauss_legendre(2 * half);
                let upper = all[half..].iter().map(|&(x, weight)| (2.0 * x - 1.0, 2.0 * weight)).collect();
                (upper, order + 1 + (order + 1) % 2)
            }
        };
        let step = 2.0 * PI / count as f64;
        let spaced = (0..count).map(|j| Longitude::new(step * (j as f64 + 0.5), step)).collect();
        let half = gauss_legendre(count / 2);
        let on = |from: f64| half.iter().map(move |&(x, w)| Longitude::new(from + PI * x, PI * w));
        let halves = on(0.0).chain(on(PI)).collect();
        Self { heights, spaced, halves, above, is_even }
    }

    /// Directions a law is evaluated in.
    pub(super) fn count(&self) -> usize {
        self.heights.len() * self.spaced.len() * if self.is_even { 1 } else { 2 }
    }

    /// The same rule inside a cone of a bound moved by `change`.
    pub(super) fn lowered(&self, change: f64) -> Self {
        Self { above: self.above.map(|above| above + change), ..self.clone() }
    }

    /// The axes and eigenvalues of the cones of a block, `shape` being `S` as 11, 22, 33, 12, 13, 23.
    #[inline(always)]
    pub(super) fn cones(&self, shape: [&Row; 6], is_alone: bool) -> Cones {
        let mut cones = Cones::common();
        let Some(above) = self.above else { return cones };
        let lanes = if is_alone { 1 } else { LANES };
        for lane in 0..lanes {
            let [xx, yy, zz, xy, xz, yz] = shape.map(|row| row[lane]);
            let s = Mat3::new(xx - above, xy, xz, xy, yy - above, yz, xz, yz, zz - above);
            cones.set(lane, &s);
        }
        cones
    }

    /// The arc on a meridian inside the cone of a lane.
    #[inline(always)]
    fn arc(&self, cones: &Cones, lane: usize, meridian: usize) -> Arc {
        let longitudes = if cones.is_nearly_planes[lane] { &self.halves } else { &self.spaced };
        cones.arc(lane, longitudes[meridian])
    }

    /// Every direction of the rule with its weight, in a fixed order, each lane inside its own cone.
    #[inline(always)]
    pub(super) fn each(&self, cones: &Cones, mut visit: impl FnMut(&Vector, &Row)) {
        let both = if self.is_even { 2.0 } else { 1.0 };
        let (mut n, mut weight) = ([ZERO; 3], ZERO);
        for meridian in 0..self.spaced.len() {
            let arcs: [Arc; LANES] = std::array::from_fn(|lane| self.arc(cones, lane, meridian));
            for &(x, w) in &self.heights {
                for lane in 0..LANES {
                    let direction = arcs[lane].direction(x);
                    for i in 0..3 {
                        n[i][lane] = direction[i];
                    }
                    weight[lane] = both * w * arcs[lane].weight;
                }
                visit(&n, &weight);
                if !self.is_even {
                    n = n.map(|row| row.map(|value| -value));
                    visit(&n, &weight);
                }
            }
        }
    }

    /// The same directions inside the cone of the first lane, sixteen at a time; what is missing to the last
    /// sixteen weighs nothing.
    #[inline(always)]
    pub(super) fn each_of_one(&self, cones: &Cones, mut visit: impl FnMut(&Vector, &Row)) {
        let both = if self.is_even { 2.0 } else { 1.0 };
        let (mut n, mut weight, mut lane) = ([ZERO; 3], ZERO, 0);
        let signs: &[f64] = if self.is_even { &[1.0] } else { &[1.0, -1.0] };
        for meridian in 0..self.spaced.len() {
            let arc = self.arc(cones, 0, meridian);
            for &(x, w) in &self.heights {
                let direction = arc.direction(x);
                for sign in signs {
                    for i in 0..3 {
                        n[i][lane] = sign * direction[i];
                    }
                    weight[lane] = both * w * arc.weight;
                    lane += 1;
                    if lane == LANES {
                        visit(&n, &weight);
                        (weight, lane) = (ZERO, 0);
                    }
                }
            }
        }
        if lane > 0 {
            visit(&n, &weight);
        }
    }
}

/// A meridian inside a cone.
#[derive(Clone, Copy)]
struct Arc {
    low: f64,
    length: f64,
    /// Length times the meridian's share of the circle.
    weight: f64,
    axis: [f64; 3],
    across: [f64; 3],
}

impl Arc {
    /// The direction at a part of the arc's height.
    #[inline(always)]
    fn direction(&self, part: f64) -> [f64; 3] {
        let z = self.low + self.length * part;
        let s = (1.0 - z * z).sqrt();
        [0, 1, 2].map(|i| z * self.axis[i] + s * self.across[i])
    }
}

/// Where the meridians of a block lie inside the cone.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Inside {
    /// All of them.
    All,
    /// None.
    None,
    /// From the cone to the axis.
    About,
    /// From the equator to the cone.
    Around,
    /// The state is not a number.
    Undefined,
}

/// Cones of a block.
pub(super) struct Cones {
    /// Axis of the heights and two across it.
    axes: [Vector; 3],
    /// Eigenvalues of `S − t` along them.
    values: Vector,
    inside: [Inside; LANES],
    is_nearly_planes: [bool; LANES],
}

impl Cones {
    /// The common axes and no cone.
    fn common() -> Self {
        let unit = |axis: usize| std::array::from_fn(|i| [if i == axis { 1.0 } else { 0.0 }; LANES]);
        Self {
            axes: [2, 0, 1].map(unit),
            values: [ZERO; 3],
            inside: [Inside::All; LANES],
            is_nearly_planes: [false; LANES],
        }
    }

    fn set(&mut self, lane: usize, s: &Mat3) {
        let (values, vectors) = symmetric_eigen(s);
        let [first, second, third] = [values[0], values[1], values[2]];
        let inside = if !s.sum().is_finite() {
            Inside::Undefined
        } else if third > 0.0 {
            Inside::All
        } else if first <= 0.0 {
            Inside::None
        } else if second <= 0.0 {
            Inside::About
        } else {
            Inside::Around
        };
        self.inside[lane] = inside;
        self.is_nearly_planes[lane] = match inside {
            Inside::About => second > NEARLY_PLANES * third,
            Inside::Around => second < NEARLY_PLANES * first,
            _ => false,
        };
        // the middle one second
        let order = if inside == Inside::Around { [2, 1, 0] } else { [0, 1, 2] };
        for (place, from) in order.into_iter().enumerate() {
            self.values[place][lane] = values[from];
            for i in 0..3 {
                self.axes[place][i][lane] = vectors[(i, from)];
            }
        }
    }

    /// The arc inside on a meridian of a cosine and sine.
    #[inline(always)]
    fn arc(&self, lane: usize, Longitude { cos, sin, weight }: Longitude) -> Arc {
        let [along, second, third] = self.values.each_ref().map(|row| row[lane]);
        let m = second * cos * cos + third * sin * sin;
        let (low, length) = match self.inside[lane] {
            Inside::All => (0.0, 1.0),
            Inside::None => (0.0, 0.0),
            Inside::About => {
                let low = (-m / (along - m)).max(0.0).sqrt();
                (low, 1.0 - low)
            }
            Inside::Around => (0.0, (m / (m - along)).max(0.0).sqrt()),
            Inside::Undefined => (f64::NAN, f64::NAN),
        };
        let [axis, b, c] = self.axes.each_ref().map(|axis| axis.each_ref().map(|row| row[lane]));
        Arc { low, length, weight: weight * length, axis, across: [0, 1, 2].map(|i| cos * b[i] + sin * c[i]) }
    }
}
