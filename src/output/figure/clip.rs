//! Lines and regions cut off at the axes.
//!
//! Owns geometry on the page only.

use super::canvas::Point;
use super::curves::Area;

/// The parts of a line through `places` that lie within `area`.
pub(super) fn line(places: &[Point], area: &Area) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let mut last: Option<Point> = None;
    for pair in places.windows(2) {
        match segment(pair[0], pair[1], area) {
            Some((from, to)) => {
                if last != Some(from) {
                    parts.push(vec![from]);
                }
                if let Some(part) = parts.last_mut() {
                    part.push(to);
                }
                last = (to == pair[1]).then_some(to);
            }
            None => last = None,
        }
    }
    parts
}

/// Whether a place lies within `area`, its rim included.
pub(super) fn holds(area: &Area, (x, y): Point) -> bool {
    (area.left - SLACK..=area.right + SLACK).contains(&x)
        && (area.top - SLACK..=area.bottom + SLACK).contains(&y)
}

/// Distance outside of the rim at which a place still counts as within, units.
const SLACK: f64 = 1e-6;

/// The part of a segment within `area` (Liang and Barsky 1984).
fn segment(from: Point, to: Point, area: &Area) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let sides = [
        (-dx, from.0 - area.left + SLACK),
        (dx, area.right - from.0 + SLACK),
        (-dy, from.1 - area.top + SLACK),
        (dy, area.bottom - from.1 + SLACK),
    ];
    for (speed, distance) in sides {
        if speed == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            enter = enter.max(distance / speed);
        } else {
            leave = leave.min(distance / speed);
        }
    }
    let at = |s: f64| match s {
        0.0 => from,
        1.0 => to,
        s => (from.0 + s * dx, from.1 + s * dy),
    };
    (enter <= leave).then(|| (at(enter), at(leave)))
}

/// The part of a region within `area` (Sutherland and Hodgman 1974).
pub(super) fn region(corners: &[Point], area: &Area) -> Vec<Point> {
    let inside: [&dyn Fn(&Point) -> f64; 4] =
        [&|p| p.0 - area.left, &|p| area.right - p.0, &|p| p.1 - area.top, &|p| area.bottom - p.1];
    let mut left = corners.to_vec();
    for distance in inside {
        let n = left.len();
        let mut kept = Vec::with_capacity(n + 2);
        for i in 0..n {
            let (a, b) = (left[i], left[(i + 1) % n]);
            let (da, db) = (distance(&a), distance(&b));
            if da >= 0.0 {
                kept.push(a);
            }
            if (da >= 0.0) != (db >= 0.0) {
                let s = da / (da - db);
                kept.push((a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1)));
            }
        }
        left = kept;
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Area = Area { left: 0.0, right: 10.0, top: 0.0, bottom: 10.0 };

    #[test]
    fn a_line_that_leaves_and_returns_has_two_parts() {
        let parts = line(&[(1.0, 5.0), (1.0, 15.0), (9.0, 15.0), (9.0, 5.0)], &AREA);
        let near = |a: Point, b: Point| (a.0 - b.0).abs() < 1e-5 && (a.1 - b.1).abs() < 1e-5;
        assert_eq!(parts.len(), 2);
        assert!(near(parts[0][1], (1.0, 10.0)) && near(parts[1][0], (9.0, 10.0)), "{parts:?}");
    }

    #[test]
    fn a_line_within_stays_one_and_one_without_is_none() {
        let within = [(1.0, 1.0), (2.0, 3.0), (10.0, 10.0)];
        assert_eq!(line(&within, &AREA), [within.to_vec()]);
        assert!(line(&[(11.0, 0.0), (12.0, 10.0)], &AREA).is_empty());
    }

    #[test]
    fn a_region_is_cut_at_each_side() {
        let cut = region(&[(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)], &AREA);
        assert_eq!(cut.len(), 4);
        assert!(cut.iter().all(|&p| holds(&AREA, p)));
    }
}
