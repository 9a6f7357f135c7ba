//! `body` and `symmetry`.

use super::super::blocks::block_name;
use super::super::file::Reported;
use super::super::materials::{stressed, used};
use super::super::members::{Members, duplicate};
use super::super::model::{Body, SymmetryPlane};
use super::super::words::{BODY, SYMMETRY};
use super::shapes::shape;
use super::stage::Stage;
use crate::discretisation::Shape;
use crate::syntax::{Block, Code};
use crate::tensor::Vec3;
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// Most particles of a body, as the lattice has it.
const MOST_PARTICLES: f64 = 1e8;

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
        let shape = members.required(self.mistakes, &file, &BODY, block, "shape").and_then(|site| {
            let files = self.loader;
            let shape = self.evaluate(&site, (false, false), |e, scope, id| shape(e, scope, files, id));
            shape.map(|shape| (shape, site))
        });
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
        self.refuse_stressed(block, (low, high), material)?;
        let place = file.place(&block.kind.span);
        let body = Body { name: name.text.clone(), place, shape, spacing, jitter, material };
        self.refuse_flood(&body, &site)?;
        self.scene.bodies.push(body);
        Ok(())
    }

    /// Refuses a body that fibres which vary with the place put under stress where it is not deformed.
    fn refuse_stressed(
        &mut self,
        block: &Block,
        (low, high): (Vec3, Vec3),
        material: usize,
    ) -> Result<(), Reported> {
        let material = &self.scene.materials[material];
        let part = |i: u8| f64::from(i) / 4.0;
        let place = |i, j, k| low + (high - low).component_mul(&Vec3::new(part(i), part(j), part(k)));
        let places = (0..5).flat_map(|i| (0..5).flat_map(move |j| (0..5).map(move |k| place(i, j, k))));
        let Some((x, p)) = stressed(material, &places.collect::<Vec<_>>()) else { return Ok(()) };
        let message = format!(
            "the undeformed body must be free of stress, but with the directions of `{}` at X = ({:.4e}, {:.4e}, {:.4e}) m it has P = {p}",
            material.name, x.x, x.y, x.z
        );
        let help =
            "subtract in the energy what its invariants are at rest, or turn the directions there".into();
        let file = Rc::clone(&self.file);
        let span = block.kind.span.clone();
        Err(self.mistakes.report(&file, Code::StressAtRest, span, message, "", Some(help)))
    }

    /// Refuses more particles than any machine holds, whatever the symmetry.
    fn refuse_flood(&mut self, body: &Body, site: &super::super::members::Site) -> Result<(), Reported> {
        let least = body.most_particles([true; 3]);
        if least <= MOST_PARTICLES {
            return Ok(());
        }
        let message = format!(
            "`{}` asks for some {least:.1e} particles, at most {MOST_PARTICLES:.0e} are computed",
            body.name
        );
        let span = site.file.span(site.id);
        let help = Some("write a larger `spacing`: twice the spacing, an eighth of the particles".into());
        Err(self.mistakes.report(&site.file, Code::TooLarge, span, message, "", help))
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
    pub(in crate::scene) fn positive(
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
        let material = used(self.mistakes, self.overrides, self.materials, site)?;
        let known = self.scene.materials.iter().position(|known| *known == *material);
        Ok(known.unwrap_or_else(|| {
            self.scene.materials.push(material.as_ref().clone());
            self.scene.materials.len() - 1
        }))
    }

    pub(super) fn symmetry(&mut self, block: &Block) -> Result<(), Reported> {
        self.only_one(block)?;
        let file = Rc::clone(&self.file);
        let path = [self.name.text.clone(), SYMMETRY.word.to_string()];
        let path = path.each_ref().map(String::as_str);
        let members = Members::read_with(self.mistakes, &file, &SYMMETRY, block, self.overrides, &path);
        let site = members.required(self.mistakes, &file, &SYMMETRY, block, "planes")?;
        let planes = self.chosen_list(&site, &SYMMETRY, "planes")?;
        let bounds = self.scene.bodies.iter().map(|body| body.shape.bounds());
        let all = bounds.reduce(|(low, high), (l, h)| (low.inf(&l), high.sup(&h)));
        let (low, high) = all.ok_or(Reported)?;
        for (axis, word) in ["x", "y", "z"].into_iter().enumerate() {
            if planes.contains(&word) {
                let end = self.scene.bodies.iter().find_map(|body| body.shape.end_plane(axis));
                let at = end.unwrap_or(0.5 * (low[axis] + high[axis]));
                if let Some(body) = self.scene.bodies.iter().find(|body| !body.shape.is_symmetric(axis, at)) {
                    let plane = format!("{word} = {}", Quantity::new(at, Dimension::LENGTH));
                    let (message, help) = not_symmetric(body, word, &plane);
                    let span = site.file.span(site.id);
                    let label = match end {
                        Some(_) => "where the hexahedra of a file end",
                        None => "through the centre of the bodies",
                    };
                    let help = Some(help);
                    return Err(self.mistakes.report(&site.file, Code::Conflict, span, message, label, help));
                }
                self.scene.symmetry[axis] = Some(SymmetryPlane { at, place: file.place(&block.kind.span) });
            }
        }
        Ok(())
    }
}

/// Why a plane is none of symmetry of a body, and what to write.
fn not_symmetric(body: &Body, word: &str, plane: &str) -> (String, String) {
    let name = &body.name;
    let without = format!("leave {word} out of `planes`");
    match body.shape {
        Shape::Mesh(_) => (
            format!(
                "`{name}` is read from hexahedra, which must be the part beyond the plane of symmetry, but they do not \
                 end with a plane face `{word}min` at {plane}"
            ),
            format!(
                "write the half of greater {word} to the file, its least {word} one plane face, or {without}"
            ),
        ),
        Shape::Points(_) => (
            format!("`{name}` is read from points without cells, which a plane of symmetry cannot cut"),
            format!("read hexahedra, or {without}"),
        ),
        _ => (format!("`{name}` is not symmetric about the plane {plane}"), without),
    }
}
