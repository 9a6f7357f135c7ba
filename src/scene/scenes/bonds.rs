//! `bond`: two bodies that share an interface.

use super::super::file::Reported;
use super::super::members::Members;
use super::super::model::Bond;
use super::super::words::BOND;
use super::faces::Bodies;
use super::stage::{Stage, heading};
use crate::syntax::{Block, Code};
use std::rc::Rc;

/// Share of the bodies' size within which two planes are one.
const ONE: f64 = 1e-9;

impl Stage<'_> {
    pub(super) fn bond(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &BOND, block);
        let first = self.target_face(block);
        let site = members.required(self.mistakes, &file, &BOND, block, "to")?;
        let bodies = Bodies { names: &self.body_names, scene: &self.scene };
        let second = bodies.face_of(self.mistakes, &site.file, site.id);
        let (first, second) = (first?, second?);
        let shapes = [&first, &second].map(|region| &self.scene.bodies[region.body].shape);
        let normals = [shapes[0].face_normal(&first.face), shapes[1].face_normal(&second.face)];
        let problem = if first.body == second.body {
            Some("a body cannot be bonded to itself")
        } else if let [Some(a), Some(b)] = normals {
            let axis = a.iamax();
            let plane = |k: usize| {
                let (low, high) = shapes[k].bounds();
                if normals[k].is_some_and(|normal| normal[axis] < 0.0) { low[axis] } else { high[axis] }
            };
            let size = (shapes[0].bounds().1 - shapes[0].bounds().0).norm();
            if a.dot(&b) > -0.5 {
                Some("bonded faces look at each other: their normals must be opposite")
            } else if (plane(0) - plane(1)).abs() > ONE * size {
                Some("bonded faces must lie in one plane")
            } else {
                None
            }
        } else {
            None
        };
        if let Some(message) = problem {
            let span = heading(block);
            return Err(self.mistakes.report(&file, Code::Conflict, span, message, "", None));
        }
        let same = |bond: &Bond| {
            (&bond.first, &bond.second) == (&first, &second)
                || (&bond.first, &bond.second) == (&second, &first)
        };
        if let Some(known) = self.scene.bonds.iter().find(|bond| same(bond)) {
            let message = format!("these faces are bonded twice, first on line {}", known.place.line);
            let span = heading(block);
            return Err(self.mistakes.report(&file, Code::Conflict, span, message, "here again", None));
        }
        self.scene.bonds.push(Bond { place: file.place(&block.kind.span), first, second });
        Ok(())
    }
}
