//! The whole program against a change of frame, of handedness, of units, and of the part modelled.
//!
//! One scene with an L-shaped fibrous body, every kind of load and a general initial motion is written
//! again for another frame; what comes out must be the image of what came out before.

use super::super::scene;
use crate::solver::{BodyState, Simulation};
use crate::tensor::Vec3;
use crate::verify::{Claim, Topic};

/// A quarter turn, other axes.
pub(super) const TURNED: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a scene turned by a quarter about z and a third about the diagonal gives the turned answer",
    source: "objectivity: no equation of the scheme names an axis",
    because: "the axes change the order of every sum, so numbers differ by their rounding: positions of at most 8 dx to \
              1.1e-16 in each of 100 steps of either scene, adding up without cancelling, over a displacement \
              of a spacing: 2 * 100 * 8 * 1.1e-16",
    bound: 1.8e-13,
    measure: || worst([turned(Frame::QUARTER), turned(Frame::THIRD)]),
    // the fibre left where it was
    control: || worst([fibre_left_behind(Frame::QUARTER), fibre_left_behind(Frame::THIRD)]),
};

/// A mirror image.
pub(super) const MIRRORED: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a scene in a mirror gives the answer in the mirror",
    source: "energies of I4 and their sums are the same in a mirror, and so is the scheme",
    because: TURNED.because,
    bound: 1.8e-13,
    measure: || turned(Frame::MIRROR),
    control: || fibre_left_behind(Frame::MIRROR),
};

/// The numbers of another system of units given to the program as if they were SI.
pub(super) const HOMOGENEOUS: Claim = Claim {
    topic: Topic::Consistency,
    claim: "the numbers of a scene in mm, tonne and s give the digits of the same scene in m, kg and s",
    source: "no constant of the program has a dimension",
    because: "powers of ten round every number of the scene once, and every product after, as another order of the \
              sums does: 2 * 100 * 8 * 1.1e-16 of a displacement of a spacing",
    bound: 1.8e-13,
    measure: || difference(&Scene { scale: 1e3, ..SAME }),
    control: || difference(&Scene { scale: 1e3, density: 1.001, ..SAME }),
};

/// The same scene written with other units.
pub(super) const UNITS: Claim = Claim {
    topic: Topic::Consistency,
    claim: "a scene written in mm, MPa and t/mm^3 is the scene written in m, Pa and kg/m^3",
    source: "units belong to numbers and are gone after resolving",
    because: HOMOGENEOUS.because,
    bound: 1.8e-13,
    measure: || rewritten(&MILLIMETRES, 1.0),
    control: || rewritten(&MILLIMETRES, 1.001),
};

/// Planes of symmetry against the body they stand for.
pub(super) const EIGHTH: Claim = Claim {
    topic: Topic::Consistency,
    claim: "one eighth of a pulled block moves as the whole block does",
    source: "with integration consistency a plane of nodes at v_n = 0 is a mirror to second order",
    because: "gradients beside the plane are one-sided where the whole block's are central: they differ by the next \
              term of the expansion, (dx/w)^2 / 6 = 0.01 at dx = 0.5 mm and w = 2 mm, half the width",
    bound: 1e-2,
    measure: || eighth("planes = [x, y, z]"),
    // two of the planes forgotten: faces instead
    control: || eighth("planes = [x]"),
};

/// A signed permutation of the axes: component `i` of the image is `sign[i]` times component `from[i]`.
#[derive(Clone, Copy)]
struct Frame {
    from: [usize; 3],
    sign: [f64; 3],
}

impl Frame {
    const SAME: Self = Self { from: [0, 1, 2], sign: [1.0; 3] };
    const QUARTER: Self = Self { from: [1, 0, 2], sign: [-1.0, 1.0, 1.0] };
    const THIRD: Self = Self { from: [2, 0, 1], sign: [1.0; 3] };
    const MIRROR: Self = Self { from: [0, 1, 2], sign: [-1.0, 1.0, 1.0] };

    fn of(&self, v: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| self.sign[i] * v[self.from[i]])
    }

    /// The name of the image of a face.
    fn face(&self, axis: usize, greater: bool) -> String {
        let image = (0..3).find(|&i| self.from[i] == axis).expect("a permutation has every axis");
        let greater = greater == (self.sign[image] > 0.0);
        format!("{}{}", ["x", "y", "z"][image], if greater { "max" } else { "min" })
    }
}

/// How lengths, pressures, densities, speeds, accelerations and body forces are written.
struct Units([(&'static str, f64); 6]);

const SI: Units =
    Units([("m", 1.0), ("Pa", 1.0), ("kg/m^3", 1.0), ("m/s", 1.0), ("m/s^2", 1.0), ("N/m^3", 1.0)]);

const MILLIMETRES: Units =
    Units([("mm", 1e3), ("MPa", 1e-6), ("t/mm^3", 1e-12), ("mm/s", 1e3), ("mm/s^2", 1e3), ("N/mm^3", 1e-9)]);

impl Units {
    /// A quantity of the `kind`-th sort given in SI.
    fn write(&self, value: f64, kind: usize) -> String {
        let (unit, factor) = self.0[kind];
        format!("{:e} {unit}", value * factor)
    }

    fn list(&self, v: [f64; 3], kind: usize) -> String {
        format!("[{}]", v.map(|x| self.write(x, kind)).join(", "))
    }
}

/// A way of writing the scene: in a frame, its lengths `scale` times as large and its mass `1/scale`
/// times, time as it is.
struct Scene {
    frame: Frame,
    /// The frame of the fibre, another one in wrong variants.
    fibre: Frame,
    scale: f64,
    /// Factor of the density, 1 but in wrong variants.
    density: f64,
    units: &'static Units,
}

const SAME: Scene = Scene { frame: Frame::SAME, fibre: Frame::SAME, scale: 1.0, density: 1.0, units: &SI };

impl Scene {
    fn text(&self) -> String {
        let Self { frame, units, .. } = self;
        let (length, mass) = (self.scale, 1.0 / self.scale);
        let (pressure, density) = (mass / length, self.density * mass / (length * length * length));
        let block = |size: [f64; 3], centre: [f64; 3]| {
            let edges = frame.of(size).map(|edge| units.write((edge * length).abs(), 0)).join(", ");
            format!("box({edges}, centre = {})", units.list(frame.of(centre).map(|x| x * length), 0))
        };
        let long = block([6e-3, 2e-3, 3e-3], [3e-3, 1e-3, 1.5e-3]);
        let tall = block([2e-3, 3e-3, 3e-3], [1e-3, 3.5e-3, 1.5e-3]);
        let gradient = [[40.0, -130.0, 25.0], [90.0, -60.0, 70.0], [-35.0, 80.0, 15.0]];
        let velocity = [0, 1, 2].map(|i| {
            // row i of T G Tᵀ
            let row = [0, 1, 2].map(|j| {
                let entry = gradient[frame.from[i]][frame.from[j]] * frame.sign[i] * frame.sign[j];
                format!("{entry:e} s^-1 * {}", ["X", "Y", "Z"][j])
            });
            let own = units.write(frame.of([0.4, -0.1, 0.3])[i] * length, 3);
            format!("{own} + {}", row.join(" + "))
        });
        let [a, b, c] = self.fibre.of([0.48, 0.6, 0.64]);
        format!(
            "tissue 1
import std.energies {{ goh, vol_quadratic }}
material gel {{
  energy  = goh(C = {c1}, k1 = {k1}, k2 = 2, kappa = 0.1) + vol_quadratic(K = {k})
  density = {rho}
  fibre a = [{a:e}, {b:e}, {c:e}]
}}
scene framed {{
  body ell {{ shape = {long} + {tall}  spacing = {dx}  material = gel }}
  slide ell.{foot}
  traction ell.{end} {{ value = {traction} }}
  pressure ell.{side} {{ value = {p} }}
  body_force ell {{ value = {force} }}
  gravity {{ acceleration = {g} }}
  start ell {{ velocity = [{velocity}] }}
  run {{ until = 20 ms }}
}}
",
            c1 = units.write(10e3 * pressure, 1),
            k1 = units.write(50e3 * pressure, 1),
            k = units.write(200e3 * pressure, 1),
            rho = units.write(1000.0 * density, 2),
            dx = units.write(1e-3 * length, 0),
            foot = frame.face(1, false),
            end = frame.face(0, true),
            traction = units.list(frame.of([900.0, -400.0, 300.0]).map(|t| t * pressure), 1),
            side = frame.face(2, true),
            p = units.write(700.0 * pressure, 1),
            force = units.list(frame.of([3e4, 2e4, -5e4]).map(|f| f * pressure / length), 5),
            g = units.list(frame.of([1.0, -2.0, 9.81]).map(|g| g * length), 4),
            velocity = velocity.join(", "),
        )
    }
}

/// Steps of 0.02 ms, below the stable one, so that both scenes take the same.
fn advanced(text: &str, steps: u32) -> Simulation {
    let mut simulation = scene::simulation(&scene::scene(text));
    for n in 1..=steps {
        let reached = scene::stepped(&mut simulation, f64::from(n) * STEP);
        assert!(reached, "the step of a claim is below the stable one");
    }
    simulation
}

const STEP: f64 = 2e-5;

/// Steps of the framed scene.
const STEPS: u32 = 100;

fn turned(frame: Frame) -> f64 {
    difference(&Scene { frame, fibre: frame, ..SAME })
}

/// The wrong variant: all is turned but the fibre.
fn fibre_left_behind(frame: Frame) -> f64 {
    difference(&Scene { frame, ..SAME })
}

fn rewritten(units: &'static Units, density: f64) -> f64 {
    difference(&Scene { units, density, ..SAME })
}

/// Largest distance of a node from the image of its counterpart, over the largest displacement.
fn difference(scene: &Scene) -> f64 {
    let (plain, image) = (advanced(&SAME.text(), STEPS), advanced(&scene.text(), STEPS));
    let map = |x: &Vec3| Vec3::from(scene.frame.of([x.x, x.y, x.z])) * scene.scale;
    gap(&plain.bodies()[0], &image.bodies()[0], &map) / scene.scale
}

/// Largest `|x' − T x|` over the nodes of `image` that are images of nodes of `plain`, over the largest
/// displacement of `plain`, times the scale of the map.
fn gap(plain: &BodyState, image: &BodyState, map: &dyn Fn(&Vec3) -> Vec3) -> f64 {
    let tolerance = 1e-6 * image.particles.spacing;
    let displacement = |a: usize| (plain.x[a].vector() - plain.particles.position[a]).norm();
    let scale = (0..plain.len()).map(displacement).fold(0.0, f64::max);
    let images: Vec<Vec3> = plain.particles.position.iter().map(map).collect();
    let mut worst = 0.0_f64;
    for (b, at) in image.particles.position.iter().enumerate() {
        let Some(a) = images.iter().position(|x| (x - at).norm() < tolerance) else { return f64::NAN };
        worst = worst.max((image.x[b].vector() - map(&plain.x[a].vector())).norm());
    }
    worst / scale
}

/// The gap between a block pulled at both ends and a part of it cut by planes of symmetry.
fn eighth(planes: &str) -> f64 {
    let text = |body: &str, more: &str| {
        format!(
            "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 100 kPa)  density = 1000 kg/m^3 }}
scene pulled {{
  body block {{ shape = {body}  spacing = 0.5 mm  material = gel }}
  pull block.xmax {{ displacement = ramp(0 mm -> 1 mm, over = 4 ms)  grip = rigid }}
  {more}
  run {{ until = 20 ms }}
}}
"
        )
    };
    let all = "box(8 mm, 4 mm, 4 mm, centre = [0 mm, 0 mm, 0 mm])";
    // where planes are left out the part is a body of its own
    let part = match planes {
        "planes = [x]" => "box(8 mm, 2 mm, 2 mm, centre = [0 mm, 1 mm, 1 mm])",
        _ => all,
    };
    let other = "pull block.xmin { displacement = ramp(0 mm -> 1 mm, over = 4 ms)  grip = rigid }";
    let whole = advanced(&text(all, other), STEPS);
    let part = advanced(&text(part, &format!("symmetry {{ {planes} }}")), STEPS);
    gap(&whole.bodies()[0], &part.bodies()[0], &|x| *x)
}

/// The larger of several, or the first that is no number.
fn worst(values: [f64; 2]) -> f64 {
    values.into_iter().fold(0.0, |worst, value| if value.is_nan() || value > worst { value } else { worst })
}
