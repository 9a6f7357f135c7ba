//! `body` and `symmetry`.

use super::super::blocks::block_name;
use super::super::evaluate::{Evaluator, Required, Scope};
use super::super::file::Reported;
use super::super::members::{Members, duplicate};
use super::super::model::{Body, Coordinate, SymmetryPlane};
use super::super::words::{BODY, SYMMETRY};
use super::stage::Stage;
use crate::discretisation::Shape;
use crate::schema::nearest;
use crate::syntax::{Argument, Block, Code, ExprId, ExprKind};
use crate::tensor::Vec3;
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

impl Stage<'_> {
    pub(super) fn body(&mut self, block: &Block) -> Result<(), Reported> {
        let name = block_name(self.mistakes, &self.file, block).ok_or(Reported)?;
        if let Some(first) = self.body_names.iter().find(|known| known.text == name.text) {
            duplicate(self.mistakes, &self.file, &name, first);
            return Err(Reported);
        }
        self.body_names.push(name.clone());
        let file = Rc::clone(&self.file);
        let path = [self.name.text.as_str(), name.text.as_str()];
        let members = Members::read_with(self.mistakes, &file, &BODY, block, self.overrides, &path);
        let shape = members
            .required(self.mistakes, &file, &BODY, block, "shape")
            .and_then(|site| self.evaluate(&site, (false, false), shape).map(|shape| (shape, site)));
        let spacing = members.required(self.mistakes, &file, &BODY, block, "spacing").and_then(|site| {
            self.positive(&site, "spacing", Dimension::LENGTH).map(|spacing| (spacing, site))
        });
        let material = members
            .required(self.mistakes, &file, &BODY, block, "material")
            .and_then(|site| self.material(&site));
        let jitter = match members.written("jitter") {
            Some(site) => self.jitter(&site.clone()),
            None => Ok(0.0),
        };
        let ((shape, _), (spacing, site)) = (shape?, spacing?);
        let (low, high) = shape.bounds();
        let thinnest = (high - low).min();
        if spacing > thinnest * (1.0 + 1e-9) {
            let message = format!(
                "`spacing` must not be larger than the thinnest side of the body, {}, but it is {}",
                Quantity::new(thinnest, Dimension::LENGTH),
                Quantity::new(spacing, Dimension::LENGTH)
            );
            return Err(self.mistakes.report(
                &site.file,
                Code::WrongForm,
                site.file.span(site.id),
                message,
                "",
                None,
            ));
        }
        let (material, jitter) = (material?, jitter?);
        self.scene.bodies.push(Body {
            name: name.text.clone(),
            place: file.place(&block.kind.span),
            shape,
            spacing,
            jitter,
            material,
        });
        Ok(())
    }

    fn jitter(&mut self, site: &super::super::members::Site) -> Result<f64, Reported> {
        let jitter = self.constant(site, "jitter", Dimension::NUMBER)?;
        if (0.0..0.5).contains(&jitter) {
            return Ok(jitter);
        }
        let message = format!("`jitter` must be in [0, 0.5), but the value is {jitter}");
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "outside", None))
    }

    /// A value greater than 0.
    pub(super) fn positive(
        &mut self,
        site: &super::super::members::Site,
        name: &str,
        dimension: Dimension,
    ) -> Result<f64, Reported> {
        let value = self.constant(site, name, dimension)?;
        if value > 0.0 {
            return Ok(value);
        }
        let message = format!("`{name}` must be > 0, but the value is {}", Quantity::new(value, dimension));
        let span = site.file.span(site.id);
        Err(self.mistakes.report(&site.file, Code::ParameterOutOfRange, span, message, "outside", None))
    }

    /// The index of a material of the scene; it is added at its first use.
    fn material(&mut self, site: &super::super::members::Site) -> Result<usize, Reported> {
        let ExprKind::Name(name) = &site.file.tree.expr(site.id).kind else {
            let message = "`material` is the name of a material";
            return Err(self.mistakes.report(
                &site.file,
                Code::WrongForm,
                site.file.span(site.id),
                message,
                "",
                None,
            ));
        };
        let Some(material) = self.materials.get(name) else {
            let help = nearest(name, self.materials.keys().map(String::as_str))
                .map(|meant| format!("write `{meant}`"));
            let message = format!("there is no material `{name}`");
            let span = site.file.span(site.id);
            return Err(self.mistakes.report(
                &site.file,
                Code::UnknownName,
                span,
                message,
                "not declared",
                help,
            ));
        };
        // What is wrong with its declaration has been reported there.
        let material = material.as_ref().ok_or(Reported)?;
        let known = self.scene.materials.iter().position(|known| known.name == *name);
        Ok(known.unwrap_or_else(|| {
            self.scene.materials.push(material.as_ref().clone());
            self.scene.materials.len() - 1
        }))
    }

    pub(super) fn symmetry(&mut self, block: &Block) -> Result<(), Reported> {
        self.only_one(block)?;
        let file = Rc::clone(&self.file);
        let members = Members::read(self.mistakes, &file, &SYMMETRY, block);
        let site = members.required(self.mistakes, &file, &SYMMETRY, block, "planes")?;
        let planes = self.chosen_list(&site, &SYMMETRY, "planes")?;
        let bounds = self.scene.bodies.iter().map(|body| body.shape.bounds());
        let all = bounds.reduce(|(low, high), (l, h)| (low.inf(&l), high.sup(&h)));
        let (low, high) = all.ok_or(Reported)?;
        for (axis, word) in ["x", "y", "z"].into_iter().enumerate() {
            if planes.contains(&word) {
                let at = 0.5 * (low[axis] + high[axis]);
                self.scene.symmetry[axis] = Some(SymmetryPlane { at, place: file.place(&block.kind.span) });
            }
        }
        Ok(())
    }
}

/// `box(lx, ly, lz, centre = [x, y, z])`.
fn shape(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    id: ExprId,
) -> Result<Shape, Reported> {
    let file = Rc::clone(scope.file());
    let expr = file.tree.expr(id);
    match &expr.kind {
        ExprKind::Call { function, arguments } if function.text == "box" => {
            block(evaluator, scope, id, arguments)
        }
        ExprKind::Call { function, .. } => {
            let message = format!("there is no shape `{}`", function.text);
            let help = Some("write `box(lx, ly, lz)`".into());
            Err(evaluator.mistakes.report(
                &file,
                Code::UnknownFunction,
                function.span.clone(),
                message,
                "",
                help,
            ))
        }
        _ => Err(evaluator.wrong_form(
            &file,
            &expr.span,
            "this",
            "a shape is required, `box(10 mm, 3 mm, 0.5 mm)`",
        )),
    }
}

fn block(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    id: ExprId,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    let file = Rc::clone(scope.file());
    let mut edges = Vec::new();
    let mut centre = None;
    for argument in arguments {
        match argument.name.as_ref().map(|path| &path.parts[0]) {
            None => {
                let required = Required { name: "box", dimension: Dimension::LENGTH };
                edges.push(
                    evaluator.constant(scope, argument.value, required).map(|edge| (edge, argument.value)),
                );
            }
            Some(name) if name.text == "centre" => {
                let required = Required { name: "centre", dimension: Dimension::LENGTH };
                centre = Some(evaluator.constant_vector(scope, argument.value, required));
            }
            Some(name) => {
                let message = format!("`box` has no argument `{}`", name.text);
                let help = Some("write `centre = [x, y, z]`".into());
                return Err(evaluator.mistakes.report(
                    &file,
                    Code::UnknownArgument,
                    name.span.clone(),
                    message,
                    "",
                    help,
                ));
            }
        }
    }
    let edges: Vec<(f64, ExprId)> = edges.into_iter().collect::<Result<_, _>>()?;
    let centre = centre.transpose()?;
    let [x, y, z] = edges.as_slice() else {
        let message = format!("`box` takes three lengths, but {} are given", edges.len());
        let help = Some("write `box(10 mm, 3 mm, 0.5 mm)` with the lengths that are meant".into());
        return Err(evaluator.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", help));
    };
    for (edge, id) in [x, y, z] {
        if *edge <= 0.0 {
            let message = format!(
                "an edge of a box must be > 0, but it is {}",
                Quantity::new(*edge, Dimension::LENGTH)
            );
            return Err(evaluator.mistakes.report(
                &file,
                Code::ParameterOutOfRange,
                file.span(*id),
                message,
                "",
                None,
            ));
        }
    }
    let size = Vec3::new(x.0, y.0, z.0);
    Ok(match centre {
        Some([x, y, z]) => {
            let centre = Vec3::new(x, y, z);
            Shape::Box { min: centre - 0.5 * size, max: centre + 0.5 * size }
        }
        None => Shape::Box { min: Vec3::zeros(), max: size },
    })
}
