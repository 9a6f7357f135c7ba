//! Bodies and faces by name.

use super::super::file::{File, Mistakes, Reported};
use super::super::model::{Region, Scene};
use super::stage::Stage;
use crate::schema::nearest;
use crate::syntax::{Block, Code, ExprId, ExprKind, Name, Span};

/// The bodies of a scene by name.
#[derive(Clone, Copy)]
pub(super) struct Bodies<'a> {
    /// Their names, of those that are wrong as well.
    pub(super) names: &'a [Name],
    /// The bodies and the planes that cut them.
    pub(super) scene: &'a Scene,
}

impl Stage<'_> {
    /// The face a block acts on.
    pub(super) fn target_face(&mut self, block: &Block) -> Result<Region, Reported> {
        let file = std::rc::Rc::clone(&self.file);
        match block.target.as_ref().map(|path| path.parts.as_slice()) {
            Some([body, face]) => {
                Bodies { names: &self.body_names, scene: &self.scene }.face(self.mistakes, &file, body, face)
            }
            other => {
                let span =
                    other.and_then(|parts| parts.first()).map_or(&block.kind.span, |name| &name.span).clone();
                let message = format!("`{}` acts on a face", block.kind.text);
                let help = format!("write `{} body.xmax`", block.kind.text);
                Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", Some(help)))
            }
        }
    }

    /// The body a block acts on.
    pub(super) fn target_body(&mut self, block: &Block) -> Result<usize, Reported> {
        let file = std::rc::Rc::clone(&self.file);
        match block.target.as_ref().map(|path| path.parts.as_slice()) {
            Some([body]) => {
                Bodies { names: &self.body_names, scene: &self.scene }.body_index(self.mistakes, &file, body)
            }
            other => {
                let span =
                    other.and_then(|parts| parts.first()).map_or(&block.kind.span, |name| &name.span).clone();
                let message = format!("`{}` acts on a body", block.kind.text);
                let help =
                    self.body_names.first().map(|body| format!("write `{} {}`", block.kind.text, body.text));
                Err(self.mistakes.report(&file, Code::WrongForm, span, message, "", help))
            }
        }
    }
}

impl Bodies<'_> {
    /// The face an expression names: `strip.xmax`.
    pub(super) fn face_of(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        id: ExprId,
    ) -> Result<Region, Reported> {
        let expr = file.tree.expr(id);
        if let ExprKind::Member { base, name } = &expr.kind
            && let ExprKind::Name(body) = &file.tree.expr(*base).kind
        {
            let body = Name { text: body.clone(), span: file.span(*base) };
            return self.face(mistakes, file, &body, name);
        }
        let message = "the face of a body is required";
        Err(mistakes.report(file, Code::WrongForm, expr.span.clone(), message, "", self.example_face()))
    }

    /// The body an expression names.
    pub(super) fn body_of(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        id: ExprId,
    ) -> Result<usize, Reported> {
        let expr = file.tree.expr(id);
        match &expr.kind {
            ExprKind::Name(body) => {
                let body = Name { text: body.clone(), span: expr.span.clone() };
                self.body_index(mistakes, file, &body)
            }
            _ => {
                let help = self.names.first().map(|body| format!("write `{}`", body.text));
                let message = "the name of a body is required";
                Err(mistakes.report(file, Code::WrongForm, expr.span.clone(), message, "", help))
            }
        }
    }

    /// The only body of the scene.
    pub(super) fn only_body(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        span: &Span,
        function: &str,
    ) -> Result<usize, Reported> {
        match self.names {
            [body] => self.body_index(mistakes, file, body),
            _ => {
                let message = format!("`{function}` needs the name of a body, the scene has several");
                Err(mistakes.report(file, Code::MissingArgument, span.clone(), message, "", None))
            }
        }
    }

    fn example_face(&self) -> Option<String> {
        let body = self.scene.bodies.first()?;
        let faces = body.shape.face_names();
        let face = faces.iter().find(|face| face.ends_with("max")).or(faces.first())?;
        Some(format!("write `{}.{face}`", body.name))
    }

    pub(super) fn body_index(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        body: &Name,
    ) -> Result<usize, Reported> {
        if let Some(index) = self.scene.bodies.iter().position(|known| known.name == body.text) {
            return Ok(index);
        }
        if self.names.iter().any(|known| known.text == body.text) {
            // What is wrong with its declaration has been reported there.
            return Err(Reported);
        }
        let names = self.names.iter().map(|known| known.text.as_str());
        let help = match nearest(&body.text, names) {
            Some(meant) => Some(format!("write `{meant}`")),
            None if self.names.is_empty() => None,
            None => {
                let names: Vec<&str> = self.names.iter().map(|known| known.text.as_str()).collect();
                Some(format!("the bodies of this scene are {}", names.join(", ")))
            }
        };
        let message = format!("there is no body `{}`", body.text);
        Err(mistakes.report(file, Code::UnknownName, body.span.clone(), message, "not declared", help))
    }

    pub(super) fn face(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        body: &Name,
        face: &Name,
    ) -> Result<Region, Reported> {
        let index = self.body_index(mistakes, file, body)?;
        let shape = &self.scene.bodies[index].shape;
        let names = shape.face_names();
        if !names.contains(&face.text.as_str()) {
            let message = format!("`{}` has no face `{}`", body.text, face.text);
            let faces = format!("its faces are {}", names.join(", "));
            let help = match nearest(&face.text, names.iter().copied()) {
                Some(meant) => format!("write `{}.{meant}`; {faces}", body.text),
                None => faces,
            };
            return Err(mistakes.report(file, Code::UnknownFace, face.span.clone(), message, "", Some(help)));
        }
        let normal = shape.face_normal(&face.text);
        let cut = normal.and_then(|normal| {
            (0..3).find(|&axis| normal[axis] < 0.0 && self.scene.symmetry[axis].is_some())
        });
        if let Some(axis) = cut {
            let axis = ["x", "y", "z"][axis];
            let message = format!(
                "`{}.{}` lies outside the modelled part: the plane of symmetry normal to {axis} leaves the side of greater coordinates",
                body.text, face.text
            );
            let span = body.span.start..face.span.end;
            let other = format!("{axis}max");
            let help = names.contains(&other.as_str()).then(|| format!("write `{}.{other}`", body.text));
            return Err(mistakes.report(file, Code::UnknownFace, span, message, "mirrored", help));
        }
        Ok(Region { body: index, face: face.text.clone() })
    }
}
