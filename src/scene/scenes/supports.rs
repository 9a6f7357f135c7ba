//! `hold`, `slide` and `pull`: prescribed motions of faces.

use super::super::file::Reported;
use super::super::members::{Members, Site};
use super::super::model::{Coordinate, Prescribed, Region};
use super::super::words::{HOLD, MOVE, PULL, SLIDE};
use super::stage::{Stage, heading, zero};
use crate::expression::{Node, Tape};
use crate::syntax::{Block, Code, ExprKind};
use crate::unit::Dimension;
use std::rc::Rc;

impl Stage<'_> {
    pub(super) fn hold(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        Members::read(self.mistakes, &file, &HOLD, block);
        let region = self.target_face(block)?;
        self.prescribe(block, region, [Some(zero()), Some(zero()), Some(zero())]);
        Ok(())
    }

    pub(super) fn slide(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &SLIDE, block);
        let region = self.target_face(block);
        let normal = match members.written("normal") {
            Some(site) => self.field(&site.clone(), "normal", Dimension::LENGTH, (true, true)),
            None => Ok(zero()),
        };
        let region = region?;
        let displacement = self.along_normal(block, &region, &normal?, None)?;
        self.prescribe(block, region, displacement);
        Ok(())
    }

    pub(super) fn pull(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let region = self.target_face(block);
        let path = self.face_path(block);
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        let members = Members::read_with(self.mistakes, &file, &PULL, block, self.overrides, &path);
        let displacement = members
            .required(self.mistakes, &file, &PULL, block, "displacement")
            .and_then(|site: Site| self.field(&site, "displacement", Dimension::LENGTH, (true, true)));
        let grip = members
            .required(self.mistakes, &file, &PULL, block, "grip")
            .and_then(|site| self.choice(&site, &PULL, "grip"));
        let (region, displacement, grip) = (region?, displacement?, grip?);
        let tangential = (grip == "rigid").then(zero);
        let displacement = self.along_normal(block, &region, &displacement, tangential)?;
        self.prescribe(block, region, displacement);
        Ok(())
    }

    /// `move body.face { displacement = [u, v, free] }`
    pub(super) fn move_face(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let region = self.target_face(block);
        let path = self.face_path(block);
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        let members = Members::read_with(self.mistakes, &file, &MOVE, block, self.overrides, &path);
        let site = members.required(self.mistakes, &file, &MOVE, block, "displacement")?;
        let components = match &site.file.tree.expr(site.id).kind {
            ExprKind::List(ids) if ids.len() == 3 => [ids[0], ids[1], ids[2]],
            // a vector by another name, or a mistake that is told as such
            _ => {
                let all = self.fields(&site, "displacement", Dimension::LENGTH, (true, true))?;
                self.prescribe(block, region?, all.map(Some));
                return Ok(());
            }
        };
        let displacement = components.map(|id| {
            if matches!(&site.file.tree.expr(id).kind, ExprKind::Name(word) if word == "free") {
                return Ok(None);
            }
            let component = Site { file: Rc::clone(&site.file), id };
            self.field(&component, "displacement", Dimension::LENGTH, (true, true)).map(Some)
        });
        let [x, y, z] = displacement;
        let displacement = [x?, y?, z?];
        if displacement.iter().all(Option::is_none) {
            let message = "a face that is free in all components is not moved";
            let span = site.file.span(site.id);
            let help = Some("write `[1 mm, free, free]` or leave `move` out".into());
            return Err(self.mistakes.report(&site.file, Code::WrongForm, span, message, "", help));
        }
        self.prescribe(block, region?, displacement);
        Ok(())
    }

    /// The path of a face for values given on the command line: scene, kind, body, face.
    fn face_path(&self, block: &Block) -> Vec<String> {
        let target = block.target.iter().flat_map(|path| path.parts.iter().map(|part| part.text.clone()));
        [self.name.text.clone(), block.kind.text.clone()].into_iter().chain(target).collect()
    }

    /// Components of a displacement along the outward normal of a face; the others are as given.
    fn along_normal(
        &mut self,
        block: &Block,
        region: &Region,
        along: &Tape<Coordinate>,
        tangential: Option<Tape<Coordinate>>,
    ) -> Result<[Option<Tape<Coordinate>>; 3], Reported> {
        let body = &self.scene.bodies[region.body];
        let Some(normal) = body.shape.face_normal(&region.face) else {
            let face = format!("{}.{}", body.name, region.face);
            let message = format!("`{}` acts along one normal, but `{face}` has many", block.kind.text);
            let help = Some(format!("write `hold {face}` or name a plane face"));
            let (file, span) = (Rc::clone(&self.file), heading(block));
            return Err(self.mistakes.report(&file, Code::WrongForm, span, message, "not plane", help));
        };
        Ok([0, 1, 2].map(|axis| match normal[axis] {
            n if n > 0.5 => Some(along.clone()),
            n if n < -0.5 => Some(negated(along)),
            _ => tangential.clone(),
        }))
    }

    fn prescribe(&mut self, block: &Block, region: Region, displacement: [Option<Tape<Coordinate>>; 3]) {
        self.sites.push(heading(block));
        self.scene.prescribed.push(Prescribed {
            word: block.kind.text.clone(),
            place: self.file.place(&block.kind.span),
            region,
            displacement,
        });
    }
}

/// The formula with its sign changed; a constant stays one node.
fn negated(tape: &Tape<Coordinate>) -> Tape<Coordinate> {
    if let [Node::Constant(value)] = tape.nodes() {
        // Not -0, so that a held face equals a held face.
        return Tape::constant(0.0 - value);
    }
    let mut negated = tape.clone();
    let last = negated.nodes().len() as u32 - 1;
    negated.push(Node::Negate(last));
    negated
}
