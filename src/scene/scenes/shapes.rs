//! Shapes of bodies: boxes, cylinders, rings of them, dumbbells, sums and differences.

use super::super::evaluate::{Evaluator, Required, Scope};
use super::super::file::Reported;
use super::super::loader::Loader;
use super::super::model::Coordinate;
use super::super::words::{FILE_SHAPES, SHAPES};
use super::dimensions::Dimensions;
use crate::discretisation::{DiscretisationError, Shape};
use crate::schema::nearest;
use crate::syntax::{Argument, BinaryOperator, Code, ExprId, ExprKind, Name};
use crate::tensor::Vec3;
use crate::unit::{Dimension, Quantity};
use std::rc::Rc;

/// An evaluator of places.
type Places<'m> = Evaluator<'m, Coordinate>;

/// The shape an expression describes, one that particles can fill.
pub(super) fn shape(
    evaluator: &mut Places,
    scope: &dyn Scope<Coordinate>,
    files: &dyn Loader,
    id: ExprId,
) -> Result<Shape, Reported> {
    let shape = described(evaluator, scope, files, id)?;
    match shape.validate() {
        Ok(()) => Ok(shape),
        Err(error) => {
            let help = (error == DiscretisationError::NotAPrism)
                .then(|| "give the parts the same extent along one axis".into());
            let file = Rc::clone(scope.file());
            let message = format!("this shape cannot be filled: {error}");
            Err(evaluator.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", help))
        }
    }
}

fn described(
    evaluator: &mut Places,
    scope: &dyn Scope<Coordinate>,
    files: &dyn Loader,
    id: ExprId,
) -> Result<Shape, Reported> {
    let file = Rc::clone(scope.file());
    let expr = file.tree.expr(id);
    match &expr.kind {
        ExprKind::Binary { operator: BinaryOperator::Add, left, right, .. } => {
            let left = described(evaluator, scope, files, *left);
            let right = described(evaluator, scope, files, *right);
            Ok(Shape::Union(parts(left?).chain(parts(right?)).collect()))
        }
        ExprKind::Binary { operator: BinaryOperator::Subtract, left, right, .. } => {
            let left = described(evaluator, scope, files, *left);
            let right = described(evaluator, scope, files, *right);
            Ok(match (left?, right?) {
                (Shape::Difference(base, mut holes), more) => {
                    holes.extend(parts(more));
                    Shape::Difference(base, holes)
                }
                (base, holes) => Shape::Difference(Box::new(base), parts(holes).collect()),
            })
        }
        ExprKind::Call { function, arguments } => match function.text.as_str() {
            "box" => block(evaluator, scope, id, arguments),
            "cylinder" => cylinder(evaluator, scope, function, arguments),
            "ring" => ring(evaluator, scope, files, function, arguments),
            "stl" => super::file_shapes::stl(evaluator, scope, files, function, arguments),
            "vtu" => super::file_shapes::vtu(evaluator, scope, files, function, arguments),
            "dumbbell" => dumbbell(evaluator, scope, function, arguments),
            _ => {
                let message = format!("there is no shape `{}`", function.text);
                let words = || SHAPES.iter().chain(FILE_SHAPES).map(|word| word.word);
                let help = match nearest(&function.text, words()) {
                    Some(meant) => format!("write `{}`", form(meant)),
                    None => format!("the shapes are {}", words().collect::<Vec<_>>().join(", ")),
                };
                let span = function.span.clone();
                Err(evaluator.mistakes.report(&file, Code::UnknownFunction, span, message, "", Some(help)))
            }
        },
        _ => Err(evaluator.wrong_form(
            &file,
            &expr.span,
            "this",
            "a shape is required, `box(10 mm, 3 mm, 0.5 mm)`",
        )),
    }
}

/// How a shape is written.
pub(super) fn form(word: &str) -> &'static str {
    SHAPES.iter().chain(FILE_SHAPES).find(|known| known.word == word).map_or("", |known| known.form)
}

/// The parts of a union, or the shape itself.
fn parts(shape: Shape) -> impl Iterator<Item = Shape> {
    match shape {
        Shape::Union(parts) => parts.into_iter(),
        other => vec![other].into_iter(),
    }
}

/// `cylinder(radius, height, centre, axis)`.
fn cylinder(
    evaluator: &mut Places,
    scope: &dyn Scope<Coordinate>,
    function: &Name,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    const NAMES: &[&str] = &["radius", "height", "centre", "axis"];
    let mut given = Dimensions::read(evaluator, scope, function, arguments, NAMES)?;
    let (radius, height) = (given.length("radius", None), given.length("height", None));
    let (centre, axis) = (given.point("centre"), given.choice("axis", &["x", "y", "z"]));
    let (radius, height, axis) = (radius?, height?, axis?.unwrap_or(2));
    let standing = || {
        let mut centre = Vec3::zeros();
        centre[axis] = 0.5 * height;
        centre
    };
    Ok(Shape::Cylinder { centre: centre?.unwrap_or_else(standing), axis, radius, height })
}

/// `ring(count, radius, start, of)`: copies of a cylinder on a circle about its centre.
fn ring(
    evaluator: &mut Places,
    scope: &dyn Scope<Coordinate>,
    files: &dyn Loader,
    function: &Name,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    const NAMES: &[&str] = &["count", "radius", "start", "of"];
    let mut given = Dimensions::read(evaluator, scope, function, arguments, NAMES)?;
    let (count, ring, start) = (given.count("count"), given.length("radius", None), given.angle("start"));
    let of = given.required("of")?;
    let file = Rc::clone(scope.file());
    let part = described(evaluator, scope, files, of)?;
    let Shape::Cylinder { centre, axis, radius, height } = part else {
        let message = "a ring is made of cylinders";
        let help = Some("write `of = cylinder(radius = 0.3 m, height = 1 m)`".into());
        return Err(evaluator.mistakes.report(&file, Code::WrongForm, file.span(of), message, "", help));
    };
    let whole =
        Shape::ring_of_holes(centre, axis, radius, height, radius, ring?, count?, start?.unwrap_or(0.0));
    Ok(match whole {
        Shape::Difference(_, holes) => Shape::Union(holes),
        other => other,
    })
}

/// `dumbbell(standard, thickness, …)`; with a standard only what differs from it is written.
fn dumbbell(
    evaluator: &mut Places,
    scope: &dyn Scope<Coordinate>,
    function: &Name,
    arguments: &[Argument],
) -> Result<Shape, Reported> {
    const NAMES: &[&str] = &[
        "thickness",
        "standard",
        "gauge_length",
        "gauge_width",
        "tab_width",
        "inner_radius",
        "outer_radius",
        "tab_length",
        "centre",
    ];
    let mut given = Dimensions::read(evaluator, scope, function, arguments, NAMES)?;
    let standard = given.choice("standard", &["astm_d412_die_c"])?;
    let die = match Shape::astm_d412_die_c(Vec3::zeros(), 1.0) {
        Shape::Dumbbell { gauge_length, gauge_width, tab_width, inner_radius, outer_radius, .. } => {
            standard.map(|_| [gauge_length, gauge_width, tab_width, inner_radius, outer_radius])
        }
        _ => None,
    };
    let thickness = given.length("thickness", None);
    let lengths: Vec<_> = (0..5).map(|k| given.length(NAMES[k + 2], die.map(|die| die[k]))).collect();
    let tab_length = given.length_or_zero("tab_length");
    let centre = given.point("centre");
    let lengths: Vec<f64> = lengths.into_iter().collect::<Result<_, _>>()?;
    let [gauge_length, gauge_width, tab_width, inner_radius, outer_radius] = lengths[..] else {
        return Err(Reported);
    };
    let thickness = thickness?;
    Ok(Shape::Dumbbell {
        centre: centre?.unwrap_or_else(|| Vec3::new(0.0, 0.0, 0.5 * thickness)),
        gauge_length,
        gauge_width,
        tab_width,
        tab_length: tab_length?,
        inner_radius,
        outer_radius,
        thickness,
    })
}

/// `box(lx, ly, lz, centre = [x, y, z])`.
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
