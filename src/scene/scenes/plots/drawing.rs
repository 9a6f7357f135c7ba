//! `outline`, `disc`, `dimension`, `note`: a drawing of a body.

use super::super::super::file::Reported;
use super::super::super::members::Members;
use super::super::super::model::{Body, Drawing, DrawnNote};
use super::super::super::words::{DIMENSION, DISC, NOTE, OUTLINE, PLOT};
use super::super::stage::Stage;
use super::dotted;
use crate::schema::nearest;
use crate::syntax::{Block, Code};
use crate::unit::Dimension;
use std::rc::Rc;

const PLANE: [Dimension; 2] = [Dimension::LENGTH; 2];

impl Stage<'_> {
    pub(super) fn drawing(&mut self, members: &Members) -> Result<Option<Drawing>, Reported> {
        let mut drawing = Drawing::default();
        let mut is_drawing = false;
        for inner in &members.blocks {
            is_drawing |= matches!(inner.kind.text.as_str(), "outline" | "disc" | "dimension" | "note");
            match inner.kind.text.as_str() {
                "outline" => drawing.outlines.extend(self.outline(inner, members)?),
                "disc" => drawing.discs.push(self.disc(inner)?),
                "dimension" => drawing.dimensions.push(self.dimension_line(inner)?),
                "note" => drawing.notes.push(self.note(inner)?),
                _ => {}
            }
        }
        Ok(is_drawing.then_some(drawing))
    }

    fn outline(&mut self, block: &Block, plot: &Members) -> Result<Vec<Vec<[f64; 2]>>, Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &OUTLINE, block);
        let site = members.required(self.mistakes, &file, &OUTLINE, block, "body")?;
        let axes = match plot.written("view") {
            None => (0, 1),
            Some(view) => match self.choice(view, &PLOT, "view")? {
                "xy" => (0, 1),
                "xz" => (0, 2),
                "yz" => (1, 2),
                other => {
                    let message = format!("an outline is seen along an axis, not `{other}`");
                    let help = Some("write `view = xy`, `xz` or `yz`".into());
                    let span = view.file.span(view.id);
                    return Err(self.mistakes.report(&view.file, Code::WrongForm, span, message, "", help));
                }
            },
        };
        let written = dotted(&site.file, site.id).map(|name| name.text).unwrap_or_default();
        let known = self.known_bodies();
        if let Some((_, body)) = known.iter().find(|(name, _)| *name == written) {
            return Ok(body.shape.outlines(axes.0, axes.1));
        }
        let names = || known.iter().map(|(name, _)| name.as_str());
        let help = match nearest(&written, names()) {
            Some(meant) => format!("write `{meant}`"),
            None => format!("the bodies are {}", names().collect::<Vec<_>>().join(", ")),
        };
        let message = format!("there is no body `{}`", site.file.expression(site.id));
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::UnknownName, span, message, "", Some(help)))
    }

    fn known_bodies(&self) -> Vec<(String, Body)> {
        let own = self.scene.bodies.iter().map(|body| (body.name.clone(), body.clone()));
        let others = self.sources.iter().flat_map(|(source, scene)| {
            scene.bodies.iter().map(move |body| (format!("{source}.{}", body.name), body.clone()))
        });
        own.chain(others).collect()
    }

    fn disc(&mut self, block: &Block) -> Result<([f64; 2], f64, usize), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &DISC, block);
        let centre = members.required(self.mistakes, &file, &DISC, block, "centre")?;
        let centre = self.pair_of(&centre.file, centre.id, "centre", PLANE)?;
        let site = members.required(self.mistakes, &file, &DISC, block, "radius")?;
        let radius = self.positive(&site, "radius", Dimension::LENGTH)?;
        Ok((centre, radius, self.colour(&members, &DISC)?.unwrap_or(1)))
    }

    fn dimension_line(&mut self, block: &Block) -> Result<([f64; 2], [f64; 2], f64, String), Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &DIMENSION, block);
        let from = members.required(self.mistakes, &file, &DIMENSION, block, "from")?;
        let from = self.pair_of(&from.file, from.id, "from", PLANE)?;
        let site = members.required(self.mistakes, &file, &DIMENSION, block, "to")?;
        let to = self.pair_of(&site.file, site.id, "to", PLANE)?;
        if from == to {
            let message = "the two ends of a dimension are one point";
            let span = site.file.span(site.id);
            return Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "", None));
        }
        let offset = match members.written("offset") {
            Some(site) => self.constant(site, "offset", Dimension::LENGTH)?,
            None => 0.0,
        };
        Ok((from, to, offset, self.text(&members, "text")?.unwrap_or_default()))
    }

    fn note(&mut self, block: &Block) -> Result<DrawnNote, Reported> {
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &NOTE, block);
        members.required(self.mistakes, &file, &NOTE, block, "text")?;
        let text = self.text(&members, "text")?.unwrap_or_default();
        let at = members.required(self.mistakes, &file, &NOTE, block, "at")?;
        let at = self.pair_of(&at.file, at.id, "at", PLANE)?;
        let to = match members.written("to") {
            Some(site) => Some(self.pair_of(&site.file, site.id, "to", PLANE)?),
            None => None,
        };
        Ok(DrawnNote { at, to, text })
    }
}
