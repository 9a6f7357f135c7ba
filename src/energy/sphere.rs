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

/// A product rule: Gauss's in the height along an axis, equal weights in the longitude about it.
///
/// ```text
/// ∫ f dS = Σ_j (2π/M) ∫ f(z, φ_j) dz,    φ_j = (j + ½) 2π/M,   n = z a + √(1 − z²) (cos φ b + sin φ c)
/// ```
///
/// On the whole sphere `a, b, c` are the common axes and heights those of the symmetric rule: exact for
/// polynomials in `n` of the degree asked for. Inside a cone `n · S n > t` they are the eigenvectors of
/// `S`, the axis the one whose eigenvalue has its sign relative to `t` alone. Then each meridian
/// meets the cone once, at `z²= −m(φ)/(s_a − t − m(φ))`, `m = (s_b − t) cos² φ + (s_c − t) sin² φ`, and Gauss's rule
/// on the arc inside sees a smooth integrand although it ends at the cone.
#[derive(Debug, Clone)]
pub(super) struct Rule {
    /// Height and weight; on the whole sphere of the upper half only.
    heights: Vec<(f64, f64)>,
    /// Cosine and sine of the longitudes.
    longitudes: Vec<(f64, f64)>,
    /// The bound of the cone, where there is one.
    above: Option<f64>,
    /// Whether opposite directions count alike, so that one of them is enough.
    is_even: bool,
}

/// Largest order of a rule; a cone's has 33 153 directions then.
pub const LARGEST_ORDER: u16 = 256;

impl Rule {
    /// The rule of a degree, inside a cone of the bound `above`.
    pub(super) fn new(order: u16, above: Option<f64>, is_even: bool) -> Self {
        let order = usize::from(order.clamp(1, LARGEST_ORDER));
        let heights = match above {
            Some(_) => gauss_legendre(order / 2 + 1),
            // an even number on both halves: all but the upper ones are mirror images
            None => {
                let half = order / 4 + 1;
                let all = gauss_legendre(2 * half);
                all[half..].iter().map(|&(x, weight)| (2.0 * x - 1.0, 2.0 * weight)).collect()
            }
        };
        // even, so that the opposite of a direction is one of the rule too
        let count = order + 1 + (order + 1) % 2;
        let longitudes = (0..count).map(|j| 2.0 * PI * (j as f64 + 0.5) / count as f64);
        let longitudes = longitudes.map(|angle| (libm::cos(angle), libm::sin(angle))).collect();
        Self { heights, longitudes, above, is_even }
    }

    /// The same rule inside a cone of a bound moved by `change`.
    pub(super) fn lowered(&self, change: f64) -> Self {
        Self { above: self.above.map(|above| above + change), ..self.clone() }
    }

    /// Directions a law is evaluated in.
    pub(super) fn count(&self) -> usize {
        self.heights.len() * self.longitudes.len() * if self.is_even { 1 } else { 2 }
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

    /// What a direction of unit height and arc weighs.
    fn share(&self) -> f64 {
        2.0 * PI / self.longitudes.len() as f64 * if self.is_even { 2.0 } else { 1.0 }
    }

    /// Every direction of the rule with its weight, in a fixed order, each lane inside its own cone.
    #[inline(always)]
    pub(super) fn each(&self, cones: &Cones, mut visit: impl FnMut(&Vector, &Row)) {
        let share = self.share();
        let (mut n, mut weight) = ([ZERO; 3], ZERO);
        for &longitude in &self.longitudes {
            let arcs: [Arc; LANES] = std::array::from_fn(|lane| cones.arc(lane, longitude));
            for &(x, w) in &self.heights {
                for lane in 0..LANES {
                    let direction = arcs[lane].direction(x);
                    for i in 0..3 {
                        n[i][lane] = direction[i];
                    }
                    weight[lane] = share * w * arcs[lane].length;
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
        let share = self.share();
        let (mut n, mut weight, mut lane) = ([ZERO; 3], ZERO, 0);
        let signs: &[f64] = if self.is_even { &[1.0] } else { &[1.0, -1.0] };
        for &longitude in &self.longitudes {
            let arc = cones.arc(0, longitude);
            for &(x, w) in &self.heights {
                let direction = arc.direction(x);
                for sign in signs {
                    for i in 0..3 {
                        n[i][lane] = sign * direction[i];
                    }
                    weight[lane] = share * w * arc.length;
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
}

impl Cones {
    /// The common axes and no cone.
    fn common() -> Self {
        let unit = |axis: usize| std::array::from_fn(|i| [if i == axis { 1.0 } else { 0.0 }; LANES]);
        Self { axes: [2, 0, 1].map(unit), values: [ZERO; 3], inside: [Inside::All; LANES] }
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
        let order = if inside == Inside::Around { [2, 0, 1] } else { [0, 1, 2] };
        for (place, from) in order.into_iter().enumerate() {
            self.values[place][lane] = values[from];
            for i in 0..3 {
                self.axes[place][i][lane] = vectors[(i, from)];
            }
        }
    }

    /// The arc inside on a meridian of a cosine and sine.
    #[inline(always)]
    fn arc(&self, lane: usize, (cos, sin): (f64, f64)) -> Arc {
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
        Arc { low, length, axis, across: [0, 1, 2].map(|i| cos * b[i] + sin * c[i]) }
    }
}
