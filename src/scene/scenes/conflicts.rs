//! Conditions that cannot hold together.

use super::super::model::{Load, Region};
use super::stage::Stage;
use crate::expression::Tape;
use crate::syntax::{Code, Diagnostic};
use crate::unit::{Dimension, Quantity};

impl Stage<'_> {
    /// Refuses two prescribed motions of one degree of freedom.
    ///
    /// On one face no component may be prescribed twice. Faces that share an edge share its particles:
    /// there both must say the same.
    pub(super) fn refuse_conflicts(&mut self) {
        let mut found = Vec::new();
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
        for (first, second, axis, same) in found {
            let axis = ["x", "y", "z"][axis];
            let (earlier, later) = (&self.scene.prescribed[first], &self.scene.prescribed[second]);
            let body = &self.scene.bodies[later.region.body].name;
            let place = if same {
                format!("`{body}.{}`", later.region.face)
            } else {
                format!("the edge of `{body}.{}` and `{body}.{}`", earlier.region.face, later.region.face)
            };
            let message = format!("the displacement along {axis} of {place} is prescribed twice");
            let diagnostic =
                Diagnostic::new(Code::Conflict, message, self.sites[second].clone(), "here again")
                    .with_label(self.sites[first].clone(), "first here");
            self.mistakes.push(&self.file, diagnostic);
        }
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
