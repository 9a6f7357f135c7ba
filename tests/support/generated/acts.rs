//! What acts on generated bodies: start velocities, loads and supports, in multiples of the material's own scales.
//!
//! Owns their drawing and their lines. Knows no shape and no law.

use super::{Scales, number};
use proptest::prelude::*;
use proptest::sample::Index;

/// How a body starts; speeds are in shear wave speeds.
#[derive(Debug, Clone)]
pub enum Start {
    /// At rest.
    Rest,
    /// Waves: amplitude, and wave numbers in 1/spacing by component.
    Waves(f64, [[f64; 3]; 3]),
    /// A velocity gradient: speed a spacing, and its components.
    Affine(f64, [[f64; 3]; 3]),
    /// A throw: velocity.
    Throw(f64, [f64; 3]),
}

/// How a load or a displacement goes on.
#[derive(Debug, Clone)]
pub enum Course {
    /// Over this share of the run, from nothing.
    Ramp(f64),
    /// At once.
    Step,
    /// Back and forth this many times.
    Swing(f64),
    /// Up and down along straight lines.
    Table,
}

/// What acts; stresses are in shear moduli, displacements in spacings, accelerations in c²/spacing.
#[derive(Debug, Clone)]
pub enum Act {
    /// A dead traction.
    Traction(Index, f64, [f64; 3], Course),
    /// A pressure that follows, pushing or pulling.
    Pressure(Index, f64, Course),
    /// A force per volume.
    BodyForce(f64, [f64; 3], Course),
    /// Gravity.
    Gravity(f64, [f64; 3]),
    /// A face held.
    Hold(Index),
    /// A face held along its normal, or moved along it.
    Slide(Index, f64, Course),
    /// A face pulled, rigidly or not.
    Pull(Index, f64, bool, Course),
    /// A face moved, a component free where not drawn.
    Move(Index, f64, [Option<f64>; 3], Course),
}

/// How violently: the largest speed, strain or stress in units of the material.
fn sizes() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -5.0..-1.7_f64, 1 => -1.7..-0.3_f64].prop_map(|power| 10.0_f64.powf(power))
}

fn parts() -> impl Strategy<Value = [f64; 3]> {
    [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]
}

/// Starts, rest first.
pub fn starts() -> impl Strategy<Value = Start> {
    let waves = [parts(), parts(), parts()].prop_map(|k| k.map(|k| k.map(|k| 3.0 * k)));
    prop_oneof![
        1 => Just(Start::Rest),
        4 => (sizes(), waves).prop_map(|(size, k)| Start::Waves(size, k)),
        2 => (sizes(), [parts(), parts(), parts()]).prop_map(|(size, l)| Start::Affine(0.3 * size, l)),
        1 => (sizes(), parts()).prop_map(|(size, v)| Start::Throw(size, v)),
    ]
}

fn courses() -> impl Strategy<Value = Course> {
    prop_oneof![
        2 => (0.05..1.0_f64).prop_map(Course::Ramp),
        1 => Just(Course::Step),
        1 => (0.5..5.0_f64).prop_map(Course::Swing),
        1 => Just(Course::Table),
    ]
}

/// What acts on a body: nothing in two of five scenes.
pub fn acts() -> impl Strategy<Value = Vec<Act>> {
    let face = any::<Index>;
    let load = prop_oneof![
        3 => (face(), sizes(), parts(), courses()).prop_map(|(at, s, n, c)| Act::Traction(at, s, n, c)),
        3 => (face(), sizes(), any::<bool>(), courses())
            .prop_map(|(at, s, pulls, c)| Act::Pressure(at, if pulls { -s } else { s }, c)),
        1 => (sizes(), parts(), courses()).prop_map(|(s, n, c)| Act::BodyForce(0.3 * s, n, c)),
        1 => (sizes(), parts()).prop_map(|(s, n)| Act::Gravity(0.3 * s, n)),
    ];
    let component = || prop_oneof![1 => Just(None), 2 => (-1.0..1.0_f64).prop_map(Some)];
    let moved = [component(), component(), component()];
    let support = prop_oneof![
        3 => face().prop_map(Act::Hold),
        2 => (face(), sizes(), courses()).prop_map(|(at, s, c)| Act::Slide(at, s, c)),
        2 => (face(), sizes(), any::<bool>(), courses()).prop_map(|(at, s, rigid, c)| Act::Pull(at, s, rigid, c)),
        2 => (face(), sizes(), moved, courses()).prop_map(|(at, s, by, c)| Act::Move(at, s, by, c)),
    ];
    prop_oneof![
        2 => Just(Vec::new()),
        3 => (prop::collection::vec(load, 0..3), prop_oneof![2 => prop::collection::vec(support.clone(), 0..2), 1 => prop::collection::vec(support, 2..3)])
            .prop_map(|(loads, supports)| loads.into_iter().chain(supports).collect()),
    ]
}

impl Start {
    /// The lines that start the bodies, which all get the same field.
    pub fn lines(&self, bodies: &[&str], scales: &Scales) -> String {
        let speed = |share: f64| number(share * scales.shear);
        let unit = scales.spacing;
        let components = match self {
            Self::Rest => return String::new(),
            Self::Waves(size, k) => [0, 1, 2].map(|i| {
                let [x, y, z] = k[i].map(|k| number(k / unit));
                format!("{} m/s * sin({x} m^-1 * X + {y} m^-1 * Y + {z} m^-1 * Z + 0.{i}5)", speed(*size))
            }),
            Self::Affine(size, l) => [0, 1, 2].map(|i| {
                let [x, y, z] = l[i].map(|l| number(l * size * scales.shear / unit));
                let at = number(scales.middle);
                format!("{x} s^-1 * (X - {at} m) + {y} s^-1 * (Y - {at} m) + {z} s^-1 * (Z - {at} m)")
            }),
            Self::Throw(size, v) => v.map(|v| format!("{} m/s", speed(size * v))),
        };
        let [x, y, z] = components;
        let line =
            |body: &&str| format!("  start {body} {{\n    velocity = [{x},\n      {y},\n      {z}]\n  }}\n");
        bodies.iter().map(line).collect()
    }

    /// What of the start is symmetric about planes through the middle.
    pub fn along_the_axes(self) -> Self {
        match self {
            Self::Affine(size, l) => {
                Self::Affine(size, [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { l[i][j] } else { 0.0 })))
            }
            _ => Self::Rest,
        }
    }

    /// The largest speed over the wave speed.
    pub fn size(&self) -> f64 {
        match self {
            Self::Rest => 0.0,
            Self::Waves(size, _) | Self::Throw(size, _) => *size,
            Self::Affine(size, _) => 3.0 * size,
        }
    }
}

impl Course {
    /// The value `full unit` as it goes on until `end` s.
    fn value(&self, full: f64, unit: &str, end: f64) -> String {
        let top = format!("{} {unit}", number(full));
        match self {
            Self::Ramp(share) => format!("ramp(0 {unit} -> {top}, over = {} s)", number(share * end)),
            Self::Step => top,
            Self::Swing(times) => {
                format!("{top} * sin({} s^-1 * t)", number(std::f64::consts::TAU * times / end))
            }
            Self::Table => {
                let (first, second) = (number(0.3 * end), number(0.7 * end));
                format!("table([0 s, {first} s, {second} s], [0 {unit}, {top}, 0 {unit}])")
            }
        }
    }

    /// As it goes on where a jump cannot be followed.
    fn follows(&self, full: f64, unit: &str, end: f64) -> String {
        match self {
            Self::Step => Self::Ramp(1.0).value(full, unit, end),
            other => other.value(full, unit, end),
        }
    }
}

impl Act {
    /// The line, for the faces there are; `end` s is the end of the run.
    pub fn line(&self, bodies: &[&str], faces: &[(&str, &str)], scales: &Scales, end: f64) -> String {
        let face = |at: &Index| {
            let (body, face) = faces[at.index(faces.len())];
            format!("{body}.{face}")
        };
        // what moves along a normal needs a face that has one
        let plane = |at: &Index| {
            let plane = |(_, face): &&(&str, &str)| face.ends_with("min") || face.ends_with("max");
            let planes: Vec<_> = faces.iter().filter(plane).collect();
            let (body, face) = planes.get(at.index(planes.len().max(1))).copied().unwrap_or(&faces[0]);
            format!("{body}.{face}")
        };
        let stress = |size: f64| size * scales.modulus;
        let vector = |full: f64, n: &[f64; 3], unit: &str, course: &Course| {
            let [x, y, z] = n.map(|n| course.value(full * n, unit, end));
            format!("[{x}, {y}, {z}]")
        };
        match self {
            Self::Traction(at, size, n, course) => {
                format!("  traction {} {{ value = {} }}\n", face(at), vector(stress(*size), n, "Pa", course))
            }
            Self::Pressure(at, size, course) => {
                format!("  pressure {} {{ value = {} }}\n", face(at), course.value(stress(*size), "Pa", end))
            }
            Self::BodyForce(size, n, course) => {
                let value = vector(stress(*size) / scales.spacing, n, "N/m^3", course);
                bodies.iter().map(|body| format!("  body_force {body} {{ value = {value} }}\n")).collect()
            }
            Self::Gravity(size, n) => {
                let full = size * scales.shear * scales.shear / scales.spacing;
                format!("  gravity {{ acceleration = {} }}\n", vector(full, n, "m/s^2", &Course::Step))
            }
            Self::Hold(at) => format!("  hold {}\n", face(at)),
            Self::Slide(at, size, course) => {
                let normal = course.follows(size * scales.spacing, "m", end);
                format!("  slide {} {{ normal = {normal} }}\n", plane(at))
            }
            Self::Pull(at, size, rigid, course) => {
                let displacement = course.follows(size * scales.spacing, "m", end);
                let grip = if *rigid { "rigid" } else { "sliding" };
                format!("  pull {} {{ displacement = {displacement}  grip = {grip} }}\n", plane(at))
            }
            Self::Move(at, size, by, course) => {
                let by = by.map(|by| match by {
                    None => "free".to_string(),
                    Some(by) => course.follows(by * size * scales.spacing, "m", end),
                });
                format!("  move {} {{ displacement = [{}] }}\n", face(at), by.join(", "))
            }
        }
    }

    /// The face it acts on, by its number; none if it acts on the whole body.
    pub fn face(&self) -> Option<&Index> {
        match self {
            Self::Traction(at, ..) | Self::Pressure(at, ..) | Self::Hold(at) => Some(at),
            Self::Slide(at, ..) | Self::Pull(at, ..) | Self::Move(at, ..) => Some(at),
            Self::BodyForce(..) | Self::Gravity(..) => None,
        }
    }

    /// Whether it prescribes a displacement.
    pub fn supports(&self) -> bool {
        matches!(self, Self::Hold(_) | Self::Slide(..) | Self::Pull(..) | Self::Move(..))
    }

    /// The largest strain or stress, in units of the material.
    pub fn size(&self) -> f64 {
        match self {
            Self::Traction(_, size, ..) | Self::Pressure(_, size, _) => size.abs(),
            Self::BodyForce(size, ..) | Self::Gravity(size, _) => 10.0 * size,
            Self::Hold(_) => 0.0,
            Self::Slide(_, size, _) | Self::Pull(_, size, ..) | Self::Move(_, size, ..) => *size,
        }
    }
}
