//! Whether the pieces of a law meet, of `if`, `max`, `min`, `abs` and the Macaulay bracket: their energies, and the
//! stresses they give.

use super::STRETCHES;
use super::elliptic::{Way, ways};
use super::judge::{Property, Standing};
use crate::energy::audit::Subject;
use crate::energy::{EnergyError, Kink, Law, Leaf};
use crate::expression::Tape;
use crate::scene::Material;
use crate::tensor::{Mat3, Vec3};

/// Stretches of a scan from end to end.
const SCANNED: u32 = 112;

/// Halvings of a step: to the last bit of the stretch.
const HALVINGS: u32 = 50;

/// Jump over the stiffness at the join, a strain, that is more than round-off.
///
/// The join is found to 1e-16 of the stretch, the energies and stresses there to some 1e-13 of the stiffness.
const MEETS: f64 = 1e-10;

/// One choice: what it compares, and the energy with the piece above and the piece below.
struct Choice {
    word: &'static str,
    margin: Law,
    pieces: [Law; 2],
}

/// The largest jumps at the joins met, over the stiffness there.
#[derive(Default)]
struct Jumps {
    met: usize,
    energy: Option<(f64, String)>,
    stress: Option<(f64, String)>,
    words: Vec<&'static str>,
}

/// Looks for the joins of a law along the ways of the ellipticity scan; `None` if it has one piece.
///
/// Along a stretch of one direction the two others are equal, so a law that compares those is also looked at where
/// they pass each other.
pub(super) fn property(
    subject: &Subject,
    material: &Material,
    values: &[f64],
    named: &[(String, Vec3)],
) -> Result<Option<Property>, EnergyError> {
    let choices = material.energy.choices(|leaf| matches!(leaf, Leaf::Running(_)));
    if choices.is_empty() {
        return Ok(None);
    }
    let mut jumps = Jumps::default();
    for place in choices {
        let law = |tape: Tape<Leaf>| Law::compile(&tape, values);
        let energy = || material.energy.clone();
        let choice = Choice {
            word: material.energy.choice_word(place),
            margin: law(energy().margin(place))?,
            pieces: [law(energy().decided(place, true))?, law(energy().decided(place, false))?],
        };
        for (name, line) in lines(named) {
            for at in joins(subject, &choice.margin, line) {
                let place = line.told(at[0], &name);
                jumps.judge(subject, &choice, &at.map(|at| line.state(at)), place);
            }
        }
    }
    Ok(Some(jumps.told()))
}

/// States in a row.
#[derive(Clone, Copy)]
enum Line {
    /// The stretches of a way.
    Along(Way),
    /// Across an isochoric stretch of `a`: `F = λ a⊗a + λ^(-1/2) (eˢ b⊗b + e⁻ˢ c⊗c)`.
    Across { a: Vec3, stretch: f64 },
}

/// Stretches at which states across are looked at.
const CROSSED: [f64; 4] = [0.8, 0.9, 1.1, 1.25];

/// Largest `s` of the states across.
const ACROSS: f64 = 0.05;

/// The ways of the ellipticity scan, and states across the isochoric ones.
fn lines(named: &[(String, Vec3)]) -> Vec<(String, Line)> {
    let ways = ways(named);
    let across = named.iter().flat_map(|(name, a)| {
        let line = |stretch| (format!("isochoric stretch along {name}"), Line::Across { a: *a, stretch });
        CROSSED.map(line)
    });
    let across: Vec<(String, Line)> = across.collect();
    ways.into_iter().map(|(name, way)| (name, Line::Along(way))).chain(across).collect()
}

impl Line {
    fn ends(self) -> [f64; 2] {
        match self {
            Self::Along(_) => STRETCHES,
            Self::Across { .. } => [-ACROSS, ACROSS],
        }
    }

    fn state(self, at: f64) -> Mat3 {
        match self {
            Self::Along(way) => way.state(at),
            Self::Across { a, stretch } => {
                let least = a.iamin();
                let mut aside = Vec3::zeros();
                aside[least] = 1.0;
                let b = a.cross(&aside).normalize();
                let c = a.cross(&b);
                let change = Mat3::identity()
                    + (libm::exp(at) - 1.0) * b * b.transpose()
                    + (libm::exp(-at) - 1.0) * c * c.transpose();
                Way::Isochoric(a).state(stretch) * change
            }
        }
    }

    fn told(self, at: f64, name: &str) -> String {
        match self {
            Self::Along(_) => format!("{at:.4} of {name}"),
            Self::Across { stretch, .. } => format!("equal stretches across {stretch} of {name}"),
        }
    }
}

/// Where what is compared changes its sign: the last place at which it is positive, and the first at which it is not.
fn joins(subject: &Subject, margin: &Law, line: Line) -> Vec<[f64; 2]> {
    let margin = Subject { law: margin, directions: subject.directions };
    let at = |along: f64| margin.density(&line.state(along));
    let [low, high] = line.ends();
    let along = |k: u32| low + (high - low) * f64::from(k) / f64::from(SCANNED);
    let mut found = Vec::new();
    for k in 0..SCANNED {
        let (mut from, mut to) = (along(k), along(k + 1));
        let (a, b) = (at(from), at(to));
        if !(a.is_finite() && b.is_finite()) || (a > 0.0) == (b > 0.0) {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if (at(middle) > 0.0) == (a > 0.0) { from = middle } else { to = middle }
        }
        found.push(if a > 0.0 { [from, to] } else { [to, from] });
    }
    found
}

impl Jumps {
    fn judge(&mut self, subject: &Subject, choice: &Choice, states: &[Mat3; 2], place: String) {
        let stiffness = subject.law.tangent(&states[0], subject.directions, Kink::Slack).norm();
        if !(stiffness.is_finite() && stiffness > 0.0) {
            return;
        }
        // each piece on its own side, to the last bit of the stretch: beyond, it may be no number
        let [above, below] =
            choice.pieces.each_ref().map(|law| Subject { law, directions: subject.directions });
        let energy = (above.density(&states[0]) - below.density(&states[1])).abs() / stiffness;
        let stress = (above.stress(&states[0]) - below.stress(&states[1])).norm() / stiffness;
        self.met += 1;
        if !self.words.contains(&choice.word) {
            self.words.push(choice.word);
        }
        let place = format!("{place}, where a piece of `{}` ends", choice.word);
        for (worst, jump) in [(&mut self.energy, energy), (&mut self.stress, stress)] {
            // a jump that is no number is the worst
            if jump.is_nan() || worst.as_ref().is_none_or(|(largest, _)| jump > *largest) {
                *worst = Some((jump, place.clone()));
            }
        }
    }

    fn told(self) -> Property {
        let property = "joins";
        let (Some((energy, torn)), Some((stress, kinked))) = (self.energy, self.stress) else {
            let [low, high] = STRETCHES;
            let found = format!("no join of two pieces lies between the stretches {low} and {high}");
            return Property {
                property,
                standing: Standing::NotAsked,
                measured: f64::NAN,
                bound: None,
                found,
            };
        };
        let meets = |jump: f64| jump <= MEETS;
        let (standing, measured, found) = if !meets(energy) {
            (Standing::Broken, energy, format!("the energy jumps by {energy:.1e} of the stiffness at {torn}"))
        } else if !meets(stress) {
            (
                Standing::Warns,
                stress,
                format!("the stress jumps by {stress:.1e} of the stiffness at {kinked}"),
            )
        } else {
            let met = self.met;
            let found = format!(
                "energy and stress meet at the {met} joins of {} met, to {stress:.0e} of the stiffness",
                self.words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
            );
            (Standing::Holds, stress, found)
        };
        Property { property, standing, measured, bound: Some(MEETS), found }
    }
}
