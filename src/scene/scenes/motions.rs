//! `motion`: an exact motion and what the boundary is told of it.

use super::super::file::Reported;
use super::super::members::Members;
use super::super::model::{Coordinate, Load, Loading, Motion, Prescribed, Region};
use super::super::words::MOTION;
use super::faces::Bodies;
use super::stage::{Stage, heading};
use crate::syntax::{Block, Code, Diagnostic, ExprId, ExprKind, Span};
use crate::unit::Dimension;
use std::rc::Rc;

/// The column of the table `motion` that `residual(motion)` reads.
pub(super) const RESIDUAL: &str = "residual";

/// A face the motion says something of: which face, what, and where it is written.
type Told = (Region, &'static str, Span);

impl Stage<'_> {
    /// Reads the block; it comes after every other that acts on faces.
    pub(super) fn motion(&mut self, block: &Block) -> Result<(), Reported> {
        self.only_one(block)?;
        let file = Rc::clone(&self.file);
        let path = [self.name.text.clone(), block.kind.text.clone()];
        let path = [path[0].as_str(), path[1].as_str()];
        let members = Members::read_with(self.mistakes, &file, &MOTION, block, self.overrides, &path);
        let formulas = members.required(self.mistakes, &file, &MOTION, block, "x").and_then(|site| {
            self.evaluate(&site, (true, true), |evaluator, scope, id| {
                let required = super::super::evaluate::Required { name: "x", dimension: Dimension::LENGTH };
                let position = evaluator.vector_quantity(scope, id, required)?;
                let mut displacement = position;
                for (axis, component) in displacement.iter_mut().enumerate() {
                    let own = evaluator.graph.leaf(Coordinate::X(axis as u8));
                    component.node = evaluator.graph.subtract(component.node, own);
                }
                let tapes = |vector: [super::super::evaluate::Scalar; 3]| vector.map(|c| evaluator.tape(c));
                Ok((tapes(position), tapes(displacement)))
            })
        });
        let choice = |stage: &mut Self, key: &str| {
            members.written(key).map(|site| stage.choice(&site.clone(), &MOTION, key)).transpose()
        };
        let boundary = choice(self, "boundary").map(|word| word.unwrap_or("motion"));
        let body_force = choice(self, "body_force").map(|word| word != Some("off"));
        let mut told: Vec<Told> = Vec::new();
        let mut sound = true;
        for word in ["motion", "traction", "normal", "tangential"] {
            if let Some(site) = members.written(word) {
                let site = site.clone();
                let ids: Vec<ExprId> = match &site.file.tree.expr(site.id).kind {
                    ExprKind::List(ids) => ids.clone(),
                    _ => vec![site.id],
                };
                for id in ids {
                    let bodies = Bodies { names: &self.body_names, scene: &self.scene };
                    match bodies.face_of(self.mistakes, &site.file, id) {
                        Ok(region) => told.push((region, word, site.file.span(id))),
                        Err(Reported) => sound = false,
                    }
                }
            }
        }
        told.sort_by_key(|(.., span)| span.start);
        self.refuse_other_states(block)?;
        self.refuse_twice(&told)?;
        let ((position, displacement), boundary, body_force) = (formulas?, boundary?, body_force?);
        if !sound {
            return Err(Reported);
        }
        let rest = self.untold(&told);
        told.extend(rest.into_iter().map(|region| (region, boundary, heading(block))));
        let mut loaded = Vec::new();
        for (region, word, span) in told {
            let components = self.moved(&region, word, &span)?;
            if components != [true; 3] {
                loaded.push(region.clone());
            }
            if components != [false; 3] {
                let displacement = [0, 1, 2].map(|axis| components[axis].then(|| displacement[axis].clone()));
                self.sites.push(span);
                self.scene.prescribed.push(Prescribed {
                    word: block.kind.text.clone(),
                    place: file.place(&block.kind.span),
                    region,
                    displacement,
                });
            }
        }
        let place = file.place(&block.kind.span);
        self.scene.motion = Some(Motion { place, position, body_force, loaded });
        self.outputs.insert(block.kind.text.clone(), block.kind.clone());
        self.columns.insert(
            block.kind.text.clone(),
            [("t", Dimension::TIME), (RESIDUAL, Dimension::NUMBER)]
                .map(|(name, dimension)| (name.to_string(), Some(dimension)))
                .into(),
        );
        Ok(())
    }

    /// Which components of a face are moved.
    fn moved(&mut self, region: &Region, word: &str, span: &Span) -> Result<[bool; 3], Reported> {
        let body = &self.scene.bodies[region.body];
        let along = |normal: crate::tensor::Vec3, wanted: bool| {
            [0, 1, 2].map(|axis: usize| (normal[axis].abs() > 0.5) == wanted)
        };
        match (word, body.shape.face_normal(&region.face)) {
            ("motion", _) => Ok([true; 3]),
            ("traction", _) => Ok([false; 3]),
            (_, Some(normal)) => Ok(along(normal, word == "normal")),
            (_, None) => {
                let face = format!("{}.{}", body.name, region.face);
                let message = format!("`{word}` needs one normal, but `{face}` has many");
                let help = Some(format!("write `{face}` under `motion` or `traction`"));
                let file = Rc::clone(&self.file);
                Err(self.mistakes.report(&file, Code::WrongForm, span.clone(), message, "not plane", help))
            }
        }
    }

    /// Faces no line of the scene says anything of.
    fn untold(&self, told: &[Told]) -> Vec<Region> {
        let prescribed = self.scene.prescribed.iter().map(|prescribed| &prescribed.region);
        let loads = self.scene.loads.iter().filter_map(|load| match load {
            Load::Traction { region, .. } => Some(region),
            _ => None,
        });
        let named: Vec<&Region> = prescribed.chain(loads).chain(told.iter().map(|told| &told.0)).collect();
        let faces = self.scene.bodies.iter().enumerate().flat_map(|(body, declared)| {
            let shape = &declared.shape;
            let kept = |face: &&str| {
                let normal = shape.face_normal(face);
                normal.is_none_or(|normal| {
                    !(0..3).any(|axis| normal[axis] < 0.0 && self.scene.symmetry[axis].is_some())
                })
            };
            shape.face_names().into_iter().filter(kept).map(move |face| Region { body, face: face.into() })
        });
        faces.filter(|region| !named.contains(&region)).collect()
    }

    /// Refuses what would contradict the state the motion prescribes.
    fn refuse_other_states(&mut self, block: &Block) -> Result<(), Reported> {
        let file = Rc::clone(&self.file);
        let here = block.kind.span.clone();
        if let Some(start) = self.scene.starts.first() {
            let line = start.place.line;
            let message =
                format!("the motion says how the bodies start, but `start` on line {line} does too");
            return Err(self.mistakes.report(&file, Code::Conflict, here, message, "", None));
        }
        if self.run.as_ref().is_some_and(|run| run.loading != Loading::Dynamic) {
            let message = "quasi-static loading is damped, so the bodies cannot follow the motion";
            let help = Some("write `loading = dynamic`".into());
            return Err(self.mistakes.report(&file, Code::Conflict, here, message, "", help));
        }
        Ok(())
    }

    /// Refuses a face named twice in the block.
    fn refuse_twice(&mut self, told: &[Told]) -> Result<(), Reported> {
        for (index, (region, _, span)) in told.iter().enumerate() {
            if let Some((_, _, first)) = told[..index].iter().find(|(other, ..)| other == region) {
                let face = format!("{}.{}", self.scene.bodies[region.body].name, region.face);
                let message = format!("the motion says twice what `{face}` is given");
                let diagnostic = Diagnostic::new(Code::Conflict, message, span.clone(), "here again")
                    .with_label(first.clone(), "first here");
                return Err(self.mistakes.push(&Rc::clone(&self.file), diagnostic));
            }
        }
        Ok(())
    }
}
