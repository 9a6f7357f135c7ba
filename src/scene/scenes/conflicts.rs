//! Conditions that cannot hold together.

use super::super::model::{Load, Region};
use super::stage::Stage;
use crate::expression::Tape;
use crate::syntax::{Code, Diagnostic, Span};
use crate::unit::{Dimension, Quantity};

/// The earlier and the later of two prescribed motions, the axis of the component both prescribe, and whether
/// their face is one.
type Clash = (usize, usize, usize, bool);

impl Stage<'_> {
    /// Refuses two prescribed motions of one degree of freedom.
    ///
    /// On one face no component may be prescribed twice. Faces that share an edge share its particles:
    /// there both must say the same.
    pub(super) fn refuse_conflicts(&mut self) {
        let mut found: Vec<Clash> = Vec::new();
        for (second, later) in self.scene.prescribed.iter().enumerate() {
            for (first, earlier) in self.scene.prescribed[..second].iter().enumerate() {
                if later.region.body != earlier.region.body {
                    continue;
                }
                let shape = &self.scene.bodies[later.region.body].shape;
                let same = later.region.face == earlier.region.face;
                if !same && !shape.faces_meet(&later.region.face, &earlier.region.face) {
                    continue;
                }
                let clash =
                    (0..3).find(|&axis| match (&later.displacement[axis], &earlier.displacement[axis]) {
                        (Some(a), Some(b)) => same || a != b,
                        _ => false,
                    });
                if let Some(axis) = clash {
                    found.push((first, second, axis, same));
                    break;
                }
            }
        }
        let mut told: Vec<(Span, Span)> = Vec::new();
        for (first, second, ..) in &found {
            let lines = (self.sites[*first].clone(), self.sites[*second].clone());
            if told.contains(&lines) {
                continue;
            }
            // two lines that meet on several edges are one mistake
            let alike = |(a, b, ..): &&Clash| (&self.sites[*a], &self.sites[*b]) == (&lines.0, &lines.1);
            let alike: Vec<Clash> = found.iter().filter(alike).copied().collect();
            let message = self.clash(&alike);
            let diagnostic = Diagnostic::new(Code::Conflict, message, lines.1.clone(), "here again")
                .with_label(lines.0.clone(), "first here");
            let earlier = &self.scene.prescribed[*first];
            let diagnostic = match (earlier.word.as_str(), self.scene.prescribed[*second].word.as_str()) {
                (word, "motion") if word != "motion" && alike.len() > 1 => {
                    let face =
                        format!("{}.{}", self.scene.bodies[earlier.region.body].name, earlier.region.face);
                    diagnostic.with_help(format!("leave `{word} {face}` out, or write `boundary = traction`"))
                }
                _ => diagnostic,
            };
            self.mistakes.push(&self.file, diagnostic);
            told.push(lines);
        }
    }

    /// Which displacement two lines both prescribe, and where.
    fn clash(&self, found: &[Clash]) -> String {
        let face = |index: usize| {
            let region = &self.scene.prescribed[index].region;
            format!("`{}.{}`", self.scene.bodies[region.body].name, region.face)
        };
        let axis = |(_, _, axis, _): &Clash| ["x", "y", "z"][*axis];
        let place = match found {
            [(_, second, _, true)] => face(*second),
            [(first, second, ..)] => format!("the edge of {} and {}", face(*first), face(*second)),
            several => {
                let common = several.iter().all(|clash| clash.0 == several[0].0);
                let edges = several.iter().map(|(first, second, _, same)| match (common, same) {
                    (true, _) | (_, true) => face(*second),
                    (false, false) => format!("{} and {}", face(*first), face(*second)),
                });
                let edges = edges.collect::<Vec<_>>().join(", ");
                let first = face(several[0].0);
                if common {
                    format!("the edges of {first} with {edges}")
                } else {
                    format!("the edges of {edges}")
                }
            }
        };
        let mut axes: Vec<&str> = found.iter().map(axis).collect();
        axes.sort_unstable();
        axes.dedup();
        format!("the displacement along {} of {place} is prescribed twice", axes.join(" or "))
    }

    /// Components of the force of a pressure at the start: the normal of a plane face, or all.
    fn pushed_by_pressure(&self, region: &Region) -> [bool; 3] {
        let normal = self.scene.bodies[region.body].shape.face_normal(&region.face);
        [0, 1, 2].map(|axis| normal.is_none_or(|normal| normal[axis] != 0.0))
    }

    /// Refuses a traction along a prescribed displacement of the same face, and a pressure on a face
    /// that it cannot move: they could do nothing.
    pub(super) fn refuse_idle_tractions(&mut self) {
        let mut found = Vec::new();
        for (index, load) in self.scene.loads.iter().enumerate() {
            let (region, acts): (_, [bool; 3]) = match load {
                Load::Traction { region, traction, .. } => {
                    (region, [0, 1, 2].map(|axis| traction[axis] != Tape::constant(0.0)))
                }
                Load::Pressure { region, .. } => (region, self.pushed_by_pressure(region)),
                _ => continue,
            };
            for (support, prescribed) in self.scene.prescribed.iter().enumerate() {
                if prescribed.region != *region {
                    continue;
                }
                let held = |axis: &usize| prescribed.displacement[*axis].is_some();
                let clash = match load {
                    // a pressure that moves the face in one component at least does something
                    Load::Pressure { .. } if (0..3).any(|axis| acts[axis] && !held(&axis)) => None,
                    _ => (0..3).find(|axis| acts[*axis] && held(axis)),
                };
                found.extend(clash.map(|axis| (index, support, axis, region.clone())));
            }
        }
        for (load, support, axis, region) in found {
            let axis = ["x", "y", "z"][axis];
            let body = &self.scene.bodies[region.body].name;
            let word = match &self.scene.loads[load] {
                Load::Pressure { .. } => "pressure",
                _ => "traction",
            };
            let message = format!(
                "the {word} along {axis} on `{body}.{}` meets a prescribed displacement",
                region.face
            );
            let diagnostic = Diagnostic::new(Code::Conflict, message, self.load_sites[load].clone(), word)
                .with_label(self.sites[support].clone(), "prescribed here");
            self.mistakes.push(&self.file, diagnostic);
        }
    }

    /// Refuses a ramp that the run does not see the end of.
    pub(super) fn refuse_late_ramps(&mut self) {
        let Some(until) = self.run.as_ref().map(|run| run.until) else { return };
        for (file, span, end) in std::mem::take(&mut self.ramps) {
            // A ramp over `until` itself, computed in other units, may differ by round-off.
            if end <= until * (1.0 + 1e-12) {
                continue;
            }
            let time = |value| Quantity::new(value, Dimension::TIME);
            let message =
                format!("the ramp ends at {}, after the end of the run at {}", time(end), time(until));
            let mut diagnostic = Diagnostic::new(Code::AfterEnd, message, span, "ends too late");
            if let Some((home, until)) = &self.until
                && home.source.name == file.source.name
            {
                diagnostic = diagnostic.with_label(until.clone(), "the run ends here");
            }
            self.mistakes.push(&file, diagnostic);
        }
    }
}
