//! Shapes from files: `stl(…)` and `vtu(…)`.

use super::super::evaluate::{Evaluator, Scope};
use super::super::file::Reported;
use super::super::files::{FileError, points, triangles};
use super::super::loader::{LoadError, Loader, relative_to};
use super::super::model::Coordinate;
use super::dimensions::Dimensions;
use crate::discretisation::{DiscretisationError, Mesh, Points, Shape, Solid};
use crate::syntax::{Argument, Code, ExprId, Name};
use crate::tensor::Vec3;
use std::fmt;
use std::rc::Rc;
use std::sync::Arc;

/// Why a file gives no shape.
enum Refusal {
    Load(LoadError),
    Format(FileError),
    Shape(DiscretisationError),
    NoVolumes,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Load(cause) => write!(f, "{cause}"),
            Self::Format(cause) => write!(f, "{cause}"),
            Self::Shape(cause) => write!(f, "{cause}"),
            Self::NoVolumes => f.write_str("its points have no cells, so their volumes must be named"),
        }
    }
}

/// `stl("part.stl", scale = 1 mm)`: what a closed surface encloses.
pub(super) fn stl(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    files: &dyn Loader,
    function: &Name,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    let mut given = Dimensions::read(evaluator, scope, function, arguments, &["file", "scale"])?;
    let (path, scale) = (given.text("file"), given.length("scale", None));
    let ((path, id), scale) = (path?, scale?);
    let read = |full: &str| {
        let bytes = files.load_bytes(full).map_err(Refusal::Load)?;
        let corners = triangles(&bytes).map_err(Refusal::Format)?;
        let scaled: Vec<[Vec3; 3]> =
            corners.into_iter().map(|triangle| triangle.map(|x| Vec3::from(x) * scale)).collect();
        let solid = Solid::new(&scaled).map_err(Refusal::Shape)?;
        Ok(Shape::Solid(Arc::new(solid)))
    };
    finish(evaluator, scope, &path, id, read)
}

/// `vtu("mesh.vtu", scale = 1 m)`: hexahedra, or points with `volume = "V"`.
pub(super) fn vtu(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    files: &dyn Loader,
    function: &Name,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    let mut given = Dimensions::read(evaluator, scope, function, arguments, &["file", "scale", "volume"])?;
    let (path, scale) = (given.text("file"), given.length("scale", None));
    let volume = if given.has("volume") { given.text("volume").map(Some) } else { Ok(None) };
    let ((path, id), scale, volume) = (path?, scale?, volume?);
    let read = |full: &str| {
        let text = files.load(full).map_err(Refusal::Load)?;
        let wanted = volume.as_ref().map(|(name, _)| name.as_str());
        let read = points(&text, wanted).map_err(Refusal::Format)?;
        let position = read.position.into_iter().map(|x| Vec3::from(x) * scale).collect();
        match (read.cell.is_empty(), read.data) {
            (false, _) => {
                let mesh = Mesh::new(position, read.cell).map_err(Refusal::Shape)?;
                Ok(Shape::Mesh(Arc::new(mesh)))
            }
            (true, Some(volume)) => {
                let cube = scale * scale * scale;
                let volume = volume.into_iter().map(|v| v * cube).collect();
                let points = Points::new(position, volume).map_err(Refusal::Shape)?;
                Ok(Shape::Points(Arc::new(points)))
            }
            (true, None) => Err(Refusal::NoVolumes),
        }
    };
    finish(evaluator, scope, &path, id, read)
}

/// Reads a file relative to the one that names it; what is wrong with it is told where it is named.
fn finish(
    evaluator: &mut Evaluator<Coordinate>,
    scope: &dyn Scope<Coordinate>,
    path: &str,
    id: ExprId,
    read: impl FnOnce(&str) -> Result<Shape, Refusal>,
) -> Result<Shape, Reported> {
    let file = Rc::clone(scope.file());
    let full = relative_to(&file.source.name, path);
    read(&full).map_err(|refusal| {
        let (code, help) = match &refusal {
            Refusal::Load(_) => (Code::FileNotFound, None),
            Refusal::NoVolumes => {
                (Code::WrongForm, Some("write `volume = \"V\"` with the name of a point array".into()))
            }
            Refusal::Format(_) | Refusal::Shape(_) => (Code::WrongForm, None),
        };
        let message = format!("`{full}` gives no shape: {refusal}");
        evaluator.mistakes.report(&file, code, file.span(id), message, "", help)
    })
}
