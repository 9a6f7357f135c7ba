//! Scenes nobody chose: drawn part by part, written as `.tissue` text, shrunk to a text one can read.
//!
//! Owns what a scene is drawn from and its text. What must hold of it is `watch`'s, and of what that calls.

mod acts;
mod files;
mod laws;
mod ledger;
mod momenta;
pub mod runs;
mod shapes;
mod states;
pub mod watch;

use proptest::prelude::*;
use std::path::{Path, PathBuf};
use std::{fmt, fs, io};
use tissue::plan::Plan;
use tissue::scene::{Memory, resolve};
use tissue::solver::Simulation;
use tissue::syntax::Source;

/// A scene; prints as its text.
#[derive(Clone)]
pub struct Drawn {
    shape: shapes::Shape,
    jitter: f64,
    law: laws::Law,
    start: acts::Start,
    acts: Vec<acts::Act>,
    run: runs::Run,
    /// Planes of symmetry wanted.
    planes: usize,
    /// Whether what acts may meet on a face.
    conflicts: bool,
    /// Whether it is run on three threads too.
    threads: bool,
    /// Decimal logarithm of the spacing in m.
    size: i32,
    /// Where the middle of the body is, in spacings.
    middle: f64,
    /// End of the run in the time a pressure wave takes through a spacing.
    transits: f64,
}

/// What one unit of the drawing is in SI.
pub struct Scales {
    /// Spacing, m.
    pub spacing: f64,
    /// Coordinate of the body's middle, m.
    pub middle: f64,
    /// Speeds are in shear wave speeds, or a thirtieth of the pressure wave speed where that is greater, m/s.
    pub shear: f64,
    /// Pressure wave speed at rest, m/s.
    pub pressure: f64,
    /// Stresses are in ρ c², Pa.
    pub modulus: f64,
}

/// What is drawn.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Anything.
    Any,
    /// Bodies that nothing acts on.
    Free,
}

/// Scenes.
pub fn scenes(kind: Kind, dissipations: runs::Dissipations) -> impl Strategy<Value = Drawn> {
    let acts = match kind {
        Kind::Any => acts::acts().boxed(),
        Kind::Free => Just(Vec::new()).boxed(),
    };
    let jitter = prop_oneof![1 => Just(0.0), 1 => 0.0..0.45_f64];
    let planes = prop_oneof![6 => Just(0_usize), 1 => 1..8_usize];
    let middle = prop_oneof![4 => Just(0.0), 2 => 2.0..6.0_f64, 1 => -1000.0..1000.0_f64];
    let body = (shapes::shapes(), jitter, laws::laws());
    (
        body,
        acts::starts(),
        (acts, prop::bool::weighted(0.1), prop::bool::weighted(0.1)),
        runs::runs(dissipations),
        planes,
        -3..1_i32,
        middle,
        20.0..200.0_f64,
    )
        .prop_map(
            |(
                (shape, jitter, law),
                start,
                (acts, conflicts, threads),
                run,
                planes,
                size,
                middle,
                transits,
            )| {
                // a plane of symmetry asks for a symmetric start: the affine ones along the axes
                let planes = if shape.is_symmetric() { planes } else { 0 };
                Drawn {
                    shape,
                    jitter,
                    law,
                    start,
                    acts,
                    run,
                    planes,
                    conflicts,
                    threads,
                    size,
                    middle,
                    transits,
                }
            },
        )
}

/// A number in eight digits, as short as it can be written: bodies that touch do so to a millionth of a spacing.
pub fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.7e}").parse().unwrap_or(x);
    format!("{rounded:?}")
}

impl Drawn {
    /// The scales of its material and spacing.
    ///
    /// # Panics
    /// If the material's own text is not understood: the drawing of laws is wrong then, or the law.
    fn scales(&self) -> Scales {
        let spacing = 10.0_f64.powi(self.size);
        let middle = self.middle * spacing;
        let (material, name) = self.law.describe(0.0);
        let text = format!(
            "tissue 1\n{material}scene rest {{\n  body a {{ shape = box(1 m, 1 m, 1 m)  spacing = 0.5 m  material = {name} }}\n  \
             run {{ until = 1 s }}\n}}\n"
        );
        let (document, mistakes) = resolve(&Source { name: "rest".into(), text }, &Memory::default(), &[]);
        let told: String = mistakes.iter().map(|mistake| mistake.render()).collect();
        assert!(mistakes.is_empty(), "{told}");
        let scene = &document.scenes[0];
        let at_rest =
            Simulation::new(scene, &Plan::new(scene)).expect("a cube of the material can be set up");
        let body = &at_rest.bodies()[0];
        let shear = body.rest.shear.max(body.rest.pressure / 30.0);
        let modulus = body.density * shear * shear;
        Scales { spacing, middle, shear, pressure: body.rest.pressure, modulus }
    }

    /// The text and the files it names.
    pub fn text(&self) -> (String, Vec<(&'static str, String)>) {
        let scales = self.scales();
        let described = self.shape.describe(scales.spacing, self.middle);
        let (law, material) = self.law.describe(scales.middle);
        let end = self.transits * scales.spacing / scales.pressure;
        let mut text = format!("tissue 1\n{law}scene drawn {{\n");
        for (name, shape, spacing) in &described.bodies {
            let (spacing, jitter) = (number(*spacing), number(self.jitter));
            let jitter = if self.jitter > 0.0 { format!("  jitter = {jitter}") } else { String::new() };
            text.push_str(&format!(
                "  body {name} {{ shape = {shape}\n    spacing = {spacing} m  material = {material}{jitter} }}\n"
            ));
        }
        if let Some(bond) = &described.bond {
            text.push_str(&format!("  {bond}\n"));
        }
        if self.planes > 0 {
            let planes: Vec<&str> = ["x", "y", "z"]
                .into_iter()
                .enumerate()
                .filter(|(i, _)| self.planes >> i & 1 == 1)
                .map(|(_, p)| p)
                .collect();
            text.push_str(&format!("  symmetry {{ planes = [{}] }}\n", planes.join(", ")));
        }
        let names: Vec<&str> = described.bodies.iter().map(|body| body.0).collect();
        let start = if self.planes > 0 { self.start.clone().along_the_axes() } else { self.start.clone() };
        text.push_str(&start.lines(&names, &scales));
        let faces = self.modelled(&described.faces);
        for act in self.fitting(&faces) {
            text.push_str(&act.line(&names, &faces, &scales, end));
        }
        text.push_str(&self.run.line(end));
        text.push_str(&record(&names, end));
        (text + "}\n", described.files)
    }

    /// The faces of the modelled part, of which a plane of symmetry leaves the greater coordinates.
    fn modelled(&self, faces: &[(&'static str, &'static str)]) -> Vec<(&'static str, &'static str)> {
        let cut =
            |face: &str| (0..3).any(|i| self.planes >> i & 1 == 1 && face == ["xmin", "ymin", "zmin"][i]);
        faces.iter().copied().filter(|(_, face)| !cut(face)).collect()
    }

    /// What acts, less what the language refuses beside it: a load on a supported face, a second support that is not
    /// on the opposite face. Where conflicts are drawn, all.
    fn fitting(&self, faces: &[(&str, &str)]) -> Vec<&acts::Act> {
        let mut kept: Vec<&acts::Act> = Vec::new();
        let face = |act: &acts::Act| act.face().map(|at| faces[at.index(faces.len())]);
        let meets = |one: &acts::Act, other: &acts::Act| match (face(one), face(other)) {
            (Some((_, a)), Some((_, b))) => {
                let opposite = a.len() == 4 && b.len() == 4 && a[..1] == b[..1] && a != b;
                (one.supports() && !opposite) && (other.supports() || a == b)
            }
            _ => false,
        };
        // supports first, so that they stay
        let ordered = self
            .acts
            .iter()
            .filter(|act| act.supports())
            .chain(self.acts.iter().filter(|act| !act.supports()));
        for act in ordered {
            if self.conflicts || !kept.iter().any(|other| meets(other, act)) {
                kept.push(act);
            }
        }
        kept
    }

    /// Writes the text and its files into a folder; the path of the text.
    ///
    /// # Errors
    /// If the folder cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<PathBuf> {
        fs::create_dir_all(folder)?;
        let (text, files) = self.text();
        for (name, bytes) in files {
            fs::write(folder.join(name), bytes)?;
        }
        let path = folder.join("scene.tissue");
        fs::write(&path, text)?;
        Ok(path)
    }

    /// Whether it is to be run on three threads too.
    pub fn threads(&self) -> bool {
        self.threads
    }

    /// The largest strain, stress or speed at work, in units of the material.
    pub fn size(&self) -> f64 {
        self.acts.iter().map(acts::Act::size).fold(self.start.size(), f64::max)
    }
}

impl fmt::Debug for Drawn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (text, files) = self.text();
        writeln!(f, "\n{text}")?;
        files.iter().try_for_each(|(name, bytes)| writeln!(f, "--- {name}\n{bytes}"))
    }
}

/// One column of each kind.
fn record(bodies: &[&str], end: f64) -> String {
    let mut text = format!("  record watched {{ every = {} s\n", number(end / 5.0));
    text.push_str("    E = total_energy  V = volume  L = norm(angular_momentum)  r = roughness(pressure)\n");
    text.push_str(
        "    J_min = min(J)  J_max = max(J)  s = max(von_mises)  g = gradient_error  c = curl_F  d = div_H\n",
    );
    for body in bodies {
        let [x, y, z] = ["x", "y", "z"].map(|axis| format!("I{axis}_{body} = impulse({body}).{axis}"));
        text.push_str(&format!("    {x}  {y}  {z}\n"));
        text.push_str(&format!("    u_{body} = mean({body}, displacement.x)\n"));
    }
    text + "  }\n"
}
