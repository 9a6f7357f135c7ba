//! Whether the pieces of an `if` meet: their energies, and the stresses they give.

use super::STRETCHES;
use super::elliptic::{Way, ways};
use super::judge::{Property, Standing};
use crate::energy::audit::Subject;
use crate::energy::{EnergyError, Kink, Law, Leaf};
use crate::expression::{NodeId, Tape};
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

/// One `if`: its condition's margin, and the energy with either piece.
struct Choice {
    margin: Law,
    pieces: [Law; 2],
}

/// The largest jumps at the joins met, over the stiffness there.
#[derive(Default)]
struct Jumps {
    met: usize,
    energy: Option<(f64, String)>,
    stress: Option<(f64, String)>,
}

/// Looks for the joins of a law along the ways of the ellipticity scan; `None` if it has no `if`.
pub(super) fn property(
    subject: &Subject,
    material: &Material,
    values: &[f64],
    named: &[(String, Vec3)],
) -> Result<Option<Property>, EnergyError> {
    let choices: Vec<NodeId> = material.energy.choices().collect();
    if choices.is_empty() {
        return Ok(None);
    }
    let mut jumps = Jumps::default();
    for choice in choices {
        let law = |tape: Tape<Leaf>| Law::compile(&tape, values);
        let energy = || material.energy.clone();
        let choice = Choice {
            margin: law(energy().margin(choice))?,
            pieces: [law(energy().decided(choice, true))?, law(energy().decided(choice, false))?],
        };
        for (name, way) in ways(named) {
            for stretch in joins(subject, &choice.margin, way) {
                jumps.judge(subject, &choice, &way.state(stretch), format!("{stretch:.4} of {name}"));
            }
        }
    }
    Ok(Some(jumps.told()))
}

/// Stretches at which the condition changes.
fn joins(subject: &Subject, margin: &Law, way: Way) -> Vec<f64> {
    let margin = Subject { law: margin, directions: subject.directions };
    let at = |stretch: f64| margin.density(&way.state(stretch));
    let [low, high] = STRETCHES;
    let stretch = |k: u32| low + (high - low) * f64::from(k) / f64::from(SCANNED);
    let mut found = Vec::new();
    for k in 0..SCANNED {
        let (mut from, mut to) = (stretch(k), stretch(k + 1));
        let (a, b) = (at(from), at(to));
        if !(a.is_finite() && b.is_finite()) || (a > 0.0) == (b > 0.0) {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if (at(middle) > 0.0) == (a > 0.0) { from = middle } else { to = middle }
        }
        found.push(to);
    }
    found
}

impl Jumps {
    fn judge(&mut self, subject: &Subject, choice: &Choice, f: &Mat3, place: String) {
        let stiffness = subject.law.tangent(f, subject.directions, Kink::Slack).norm();
        if !(stiffness.is_finite() && stiffness > 0.0) {
            return;
        }
        let [then, otherwise] =
            choice.pieces.each_ref().map(|law| Subject { law, directions: subject.directions });
        let energy = (then.density(f) - otherwise.density(f)).abs() / stiffness;
        let stress = (then.stress(f) - otherwise.stress(f)).norm() / stiffness;
        self.met += 1;
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
            let found = format!("no join of an `if` lies between the stretches {low} and {high}");
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
                "energy and stress meet at the {met} joins of `if` met, to {stress:.0e} of the stiffness"
            );
            (Standing::Holds, stress, found)
        };
        Property { property, standing, measured, bound: Some(MEETS), found }
    }
}
