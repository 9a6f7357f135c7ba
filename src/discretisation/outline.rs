//! Plane regions: what a prism is extruded from.
//!
//! Owns distance to and nearest point of their boundaries. Knows no grid.

use std::f64::consts::FRAC_PI_2;

/// A point of the plane, m.
pub(super) type Vec2 = nalgebra::Vector2<f64>;

/// A region of the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Outline {
    /// A rectangle with edges along the axes.
    Rectangle { min: Vec2, max: Vec2 },
    /// A disc.
    Disc { centre: Vec2, radius: f64 },
    /// A dumbbell along the first axis.
    Dumbbell { centre: Vec2, profile: Profile },
    /// All points of any part.
    Union(Vec<Outline>),
    /// The points of the first that belong to none of the others.
    Difference(Box<Outline>, Vec<Outline>),
}

/// The quarter outline of a dumbbell: gauge, concave arc, convex arc, tab, end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Profile {
    /// Half length and half width of the gauge, m.
    pub gauge: [f64; 2],
    /// Half width of the tabs, m.
    pub tab: f64,
    /// Radius of the concave arc at the gauge, m.
    pub inner: f64,
    /// Radius of the convex arc at the tab, m.
    pub outer: f64,
    /// Half of the whole length, m.
    pub end: f64,
}

/// The nearest point of a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nearest {
    /// Distance to it, negative inside, m.
    pub distance: f64,
    /// The point.
    pub point: Vec2,
    /// Kind of boundary it lies on: `side`, `inner`, `edge`, `hole`.
    pub kind: &'static str,
}

impl Profile {
    /// Angle the two arcs turn through: `cos θ = 1 − (tab − gauge)/(inner + outer)`.
    fn angle(&self) -> f64 {
        libm::acos(1.0 - (self.tab - self.gauge[1]) / (self.inner + self.outer))
    }

    /// Length of the transition along the axis: `(inner + outer) sin θ`.
    pub fn transition(&self) -> f64 {
        (self.inner + self.outer) * libm::sin(self.angle())
    }

    /// Half width at a distance from the middle, both positive.
    pub fn half_width(&self, x: f64) -> f64 {
        let from_gauge = x - self.gauge[0];
        let to_tab = self.transition() - from_gauge;
        if from_gauge <= 0.0 {
            self.gauge[1]
        } else if from_gauge <= self.inner * libm::sin(self.angle()) {
            self.gauge[1] + self.inner - (self.inner * self.inner - from_gauge * from_gauge).sqrt()
        } else if to_tab > 0.0 {
            self.tab - self.outer + (self.outer * self.outer - to_tab * to_tab).sqrt()
        } else {
            self.tab
        }
    }

    /// Nearest point of the quarter outline to a point of the quarter plane.
    fn nearest(&self, p: &Vec2) -> Vec2 {
        let [length, width] = self.gauge;
        let (angle, start) = (self.angle(), self.gauge[0] + self.transition());
        let candidates = [
            Vec2::new(p.x.clamp(0.0, length), width),
            on_arc(p, &Vec2::new(length, width + self.inner), self.inner, -FRAC_PI_2, -FRAC_PI_2 + angle),
            on_arc(p, &Vec2::new(start, self.tab - self.outer), self.outer, FRAC_PI_2, FRAC_PI_2 + angle),
            Vec2::new(p.x.clamp(start, self.end), self.tab),
            Vec2::new(self.end, p.y.clamp(0.0, self.tab)),
        ];
        let near = |q: &Vec2| (q - p).norm_squared();
        candidates.into_iter().min_by(|q, r| near(q).total_cmp(&near(r))).expect("there are five candidates")
    }
}

/// Nearest point of an arc; angles from the first axis, `from < to`.
fn on_arc(p: &Vec2, centre: &Vec2, radius: f64, from: f64, to: f64) -> Vec2 {
    let d = p - centre;
    // measured from the middle of the arc, so that the ends are the nearest of the points beyond
    let middle = 0.5 * (from + to);
    let (sin, cos) = (libm::sin(middle), libm::cos(middle));
    let turned = libm::atan2(cos * d.y - sin * d.x, cos * d.x + sin * d.y);
    let half = 0.5 * (to - from);
    if turned.abs() <= half && d != Vec2::zeros() {
        return centre + radius / d.norm() * d;
    }
    let end = middle + half.copysign(turned);
    centre + radius * Vec2::new(libm::cos(end), libm::sin(end))
}

impl Outline {
    /// The nearest point of the boundary. Of a union or difference it is the nearest of the part that
    /// decides whether the point is inside, which near the boundary is the nearest of all.
    pub fn nearest(&self, p: &Vec2) -> Nearest {
        match self {
            Self::Rectangle { min, max } => {
                let outside = min.sup(&p.inf(max));
                if outside != *p {
                    return Nearest { distance: (p - outside).norm(), point: outside, kind: "inner" };
                }
                let sides = [
                    (p.x - min.x, Vec2::new(min.x, p.y)),
                    (max.x - p.x, Vec2::new(max.x, p.y)),
                    (p.y - min.y, Vec2::new(p.x, min.y)),
                    (max.y - p.y, Vec2::new(p.x, max.y)),
                ];
                let (depth, point) =
                    sides.into_iter().min_by(|s, t| s.0.total_cmp(&t.0)).expect("there are four sides");
                Nearest { distance: -depth, point, kind: "inner" }
            }
            Self::Disc { centre, radius } => {
                let d = p - centre;
                let r = d.norm();
                let direction = if r > 0.0 { d / r } else { Vec2::x() };
                Nearest { distance: r - radius, point: centre + *radius * direction, kind: "side" }
            }
            Self::Dumbbell { centre, profile } => {
                let d = p - centre;
                let quarter = profile.nearest(&d.abs());
                let inside = d.x.abs() < profile.end && d.y.abs() < profile.half_width(d.x.abs());
                let distance = (quarter - d.abs()).norm();
                let point = centre + Vec2::new(quarter.x.copysign(d.x), quarter.y.copysign(d.y));
                Nearest { distance: if inside { -distance } else { distance }, point, kind: "edge" }
            }
            Self::Union(parts) => parts
                .iter()
                .map(|part| part.nearest(p))
                .min_by(|s, t| s.distance.total_cmp(&t.distance))
                .expect("a union has parts"),
            Self::Difference(base, holes) => holes
                .iter()
                .map(|hole| {
                    let Nearest { distance, point, .. } = hole.nearest(p);
                    Nearest { distance: -distance, point, kind: "hole" }
                })
                .fold(base.nearest(p), |s, t| if t.distance > s.distance { t } else { s }),
        }
    }

    /// The point of the boundary reached by going to the nearest point of the part that decides, again
    /// and again where parts meet.
    pub fn project(&self, p: &Vec2) -> Nearest {
        let mut at = *p;
        let mut nearest = self.nearest(&at);
        for _ in 0..64 {
            at = nearest.point;
            let next = self.nearest(&at);
            // 4 roundings at the size of the coordinates
            if next.distance.abs() <= 4.0 * f64::EPSILON * (1.0 + at.amax()) {
                break;
            }
            nearest = next;
        }
        Nearest { point: at, ..nearest }
    }

    /// Coordinates along an axis that lines of the lattice must take: straight edges and extremes.
    pub fn breaks(&self, axis: usize) -> Vec<f64> {
        match self {
            Self::Rectangle { min, max } => vec![min[axis], max[axis]],
            Self::Disc { centre, radius } => vec![centre[axis] - radius, centre[axis] + radius],
            Self::Dumbbell { centre, profile } => {
                let marks = if axis == 0 { vec![profile.end] } else { vec![profile.gauge[1], profile.tab] };
                marks.iter().flat_map(|m| [centre[axis] - m, centre[axis] + m]).collect()
            }
            Self::Union(parts) => {
                let (low, high) = self.extent(axis);
                // a curved part asks for a line only where it is outermost
                let wanted = |part: &Self, at: f64| part.is_straight() || at == low || at == high;
                parts
                    .iter()
                    .flat_map(|part| part.breaks(axis).into_iter().filter(move |&at| wanted(part, at)))
                    .collect()
            }
            Self::Difference(base, holes) => {
                let straight = holes.iter().filter(|hole| hole.is_straight());
                base.breaks(axis).into_iter().chain(straight.flat_map(|hole| hole.breaks(axis))).collect()
            }
        }
    }

    /// Least and greatest coordinate along an axis.
    pub fn extent(&self, axis: usize) -> (f64, f64) {
        let of = |breaks: Vec<f64>| {
            breaks.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)))
        };
        match self {
            Self::Union(parts) => {
                of(parts.iter().flat_map(|part| <[f64; 2]>::from(part.extent(axis))).collect())
            }
            Self::Difference(base, _) => base.extent(axis),
            _ => of(self.breaks(axis)),
        }
    }

    /// Smallest radius of a disc, which the lattice must resolve.
    pub fn least_radius(&self) -> f64 {
        match self {
            Self::Rectangle { .. } => f64::INFINITY,
            Self::Disc { radius, .. } => *radius,
            Self::Dumbbell { profile, .. } => profile.inner.min(profile.outer),
            Self::Union(parts) => parts.iter().map(Self::least_radius).fold(f64::INFINITY, f64::min),
            Self::Difference(base, holes) => {
                holes.iter().map(Self::least_radius).fold(base.least_radius(), f64::min)
            }
        }
    }

    /// Whether all edges run along the axes.
    pub fn is_straight(&self) -> bool {
        match self {
            Self::Rectangle { .. } => true,
            Self::Disc { .. } | Self::Dumbbell { .. } => false,
            Self::Union(parts) => parts.iter().all(Self::is_straight),
            Self::Difference(base, holes) => base.is_straight() && holes.iter().all(Self::is_straight),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Outline> {
        let profile = Profile { gauge: [16.5, 3.0], tab: 12.5, inner: 25.0, outer: 14.0, end: 45.0 };
        let disc = |x, radius| Outline::Disc { centre: Vec2::new(x, 0.4), radius };
        let rectangle = Outline::Rectangle { min: Vec2::new(-3.0, -2.0), max: Vec2::new(1.0, 2.5) };
        vec![
            rectangle.clone(),
            disc(0.3, 4.0),
            Outline::Dumbbell { centre: Vec2::new(0.5, -0.2), profile },
            Outline::Union(vec![rectangle, disc(1.0, 2.0)]),
            Outline::Difference(Box::new(disc(0.0, 5.0)), vec![disc(2.0, 1.0), disc(-2.0, 1.5)]),
        ]
    }

    fn points() -> impl Iterator<Item = Vec2> {
        (0..900).map(|n| Vec2::new((n % 30) as f64 * 3.4 - 49.7, (n / 30) as f64 * 1.1 - 15.8))
    }

    #[test]
    fn projected_points_lie_on_the_boundary_and_stay_there() {
        for outline in all() {
            for p in points() {
                let nearest = outline.project(&p);
                let again = outline.nearest(&nearest.point);
                assert!(again.distance.abs() < 1e-13, "{outline:?} at {p}: {again:?}");
                assert!((again.point - nearest.point).norm() < 1e-7, "{outline:?} at {p}: {again:?}");
            }
        }
    }

    #[test]
    fn the_distance_changes_sign_across_the_boundary_only() {
        // between two points closer to each other than to the boundary the sign is the same
        for outline in all() {
            for p in points() {
                let here = outline.nearest(&p).distance;
                for k in 0..8 {
                    let angle = k as f64 * 0.8;
                    let q = p + 0.999 * here.abs() * Vec2::new(libm::cos(angle), libm::sin(angle));
                    let there = outline.nearest(&q).distance;
                    assert!(here * there >= 0.0, "{outline:?} at {p}, {q}: {here}, {there}");
                }
            }
        }
    }

    #[test]
    fn the_dumbbell_of_die_c_is_84_02_mm_between_its_tabs() {
        // BENCHMARKS.md: 84.02 mm; Pythagoras: sqrt(39^2 - 29.5^2) = 25.510 on each side of 33 mm
        let profile = Profile { gauge: [16.5, 3.0], tab: 12.5, inner: 25.0, outer: 14.0, end: 42.01 };
        assert!((33.0 + 2.0 * profile.transition() - 84.02).abs() < 0.005);
        // the arcs join with the same height
        let joint = 16.5 + 25.0 * libm::sin(profile.angle());
        assert!((profile.half_width(joint - 1e-9) - profile.half_width(joint + 1e-9)).abs() < 1e-8);
    }
}
