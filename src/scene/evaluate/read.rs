//! Values of a required dimension, and the dimensions parameters are declared with.

use super::super::file::{File, Mistakes, Reported};
use super::{Evaluator, Leaves, Scalar, Scope, Value};
use crate::schema::nearest;
use crate::syntax::{BinaryOperator, Code, ExprId, ExprKind, Span};
use crate::unit::{Dimension, known_dimensions};
use std::rc::Rc;

/// What a value must be, and the name of what it is given to.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) struct Required<'a> {
    /// `spacing`, `C`: what the message is about.
    pub(in crate::scene) name: &'a str,
    /// The dimension.
    pub(in crate::scene) dimension: Dimension,
}

impl<L: Leaves> Evaluator<'_, L> {
    /// A value of a required dimension.
    pub(in crate::scene) fn quantity(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        required: Required,
    ) -> Result<Scalar, Reported> {
        let file = scope.file();
        let scalar = self.scalar(scope, id).inspect_err(|_| {
            if let ExprKind::Name(_) = file.tree.expr(id).kind {
                self.mistakes.advise(Code::UnknownName, &file.span(id), || unknown(required));
            }
        })?;
        self.require(file, id, scalar, required)
    }

    /// Three components of a required dimension.
    pub(in crate::scene) fn vector_quantity(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        required: Required,
    ) -> Result<[Scalar; 3], Reported> {
        let file = Rc::clone(scope.file());
        // A list is checked component by component, so that the mark stands under the one that is wrong.
        if let ExprKind::List(ids) = &file.tree.expr(id).kind
            && let &[x, y, z] = ids.as_slice()
        {
            let components = [x, y, z].map(|id| self.quantity(scope, id, required));
            let [x, y, z] = components;
            return Ok([x?, y?, z?]);
        }
        let vector = self.vector(scope, id)?;
        for component in vector {
            self.require(&file, id, component, required)?;
        }
        Ok(vector)
    }

    /// A number known without running anything.
    pub(in crate::scene) fn constant(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        required: Required,
    ) -> Result<f64, Reported> {
        let scalar = self.quantity(scope, id, required)?;
        self.fixed(scope, id, scalar, required.name)
    }

    /// Three numbers known without running anything.
    pub(in crate::scene) fn constant_vector(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        required: Required,
    ) -> Result<[f64; 3], Reported> {
        let [x, y, z] =
            self.vector_quantity(scope, id, required)?.map(|c| self.fixed(scope, id, c, required.name));
        Ok([x?, y?, z?])
    }

    fn fixed(
        &mut self,
        scope: &dyn Scope<L>,
        id: ExprId,
        scalar: Scalar,
        name: &str,
    ) -> Result<f64, Reported> {
        let file = Rc::clone(scope.file());
        match self.known(scalar) {
            Some(value) if value.is_finite() => Ok(value),
            Some(value) => {
                let message = format!("`{name}` must be finite, but this is {value}");
                Err(self.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", None))
            }
            None => {
                let message = format!("`{name}` must be one fixed value, but this depends on place or time");
                Err(self.mistakes.report(&file, Code::WrongForm, file.span(id), message, "", None))
            }
        }
    }

    /// Refuses a value of another dimension.
    pub(in crate::scene) fn require(
        &mut self,
        file: &Rc<File>,
        id: ExprId,
        scalar: Scalar,
        required: Required,
    ) -> Result<Scalar, Reported> {
        if scalar.dimension == required.dimension {
            return Ok(scalar);
        }
        let (found, wanted) = (scalar.dimension.describe(), required.dimension.describe());
        let name = required.name;
        let help = read_as_unit(file, id).or_else(|| help(file, id, required.dimension));
        let span = file.span(id);
        let (code, message) = if scalar.dimension.is_number() {
            (Code::MissingUnit, format!("`{name}` is {wanted}, but the value is a number without a unit"))
        } else {
            (Code::WrongDimension, format!("`{name}` is {wanted}, but the value is {found}"))
        };
        Err(self.mistakes.report(file, code, span, message, found, help))
    }
}

/// How to write a product with the time or the volume map whose name was read as tonne or joule: `1 kPa*t`.
pub(super) fn read_as_unit(file: &File, id: ExprId) -> Option<String> {
    let whole = file.span(id);
    let inside = |span: &Span| whole.start <= span.start && span.end <= whole.end;
    file.tree.expressions.iter().filter(|part| inside(&part.span)).find_map(|part| {
        let ExprKind::Number { unit: Some(unit), .. } = &part.kind else { return None };
        let at = unit.text.rfind(['*', '·', '/'])?;
        let (before, name) = (&unit.text[..at], unit.text[at..].trim_start_matches(['*', '·', '/']));
        let (meant, unit_name) = match name {
            "t" => ("the time", "tonne"),
            "J" => ("the volume map", "joule"),
            _ => return None,
        };
        let sign = if unit.text[at..].starts_with('/') { '/' } else { '*' };
        let number = file.text(&(part.span.start..unit.span.start)).trim_end();
        Some(format!(
            "`{name}` is the {unit_name} here: write `{number} {before} {sign} {name}` if {meant} is meant"
        ))
    })
}

/// What to write instead: the same number with a unit that fits, or the units there are.
fn help(file: &File, id: ExprId, dimension: Dimension) -> Option<String> {
    let units = dimension.suggested_units();
    if dimension.is_number() {
        return number(file, id).map(|number| format!("write `{number}` without a unit"));
    }
    if let ExprKind::Number { unit: Some(unit), .. } = &file.tree.expr(id).kind
        && crate::unit::parse_unit(&unit.text).is_ok_and(|known| known.dimension == dimension.recip())
    {
        let power = if unit.text.contains(['/', '*', '^']) {
            format!("1/({})", unit.text)
        } else {
            format!("{}^-1", unit.text)
        };
        return number(file, id).map(|number| format!("write `{number} {power}`"));
    }
    match number(file, id) {
        Some(number) => Some(format!(
            "write it in {}, for example `{number} {}`",
            units.join(", "),
            preferred(dimension)?
        )),
        None => Some(format!("{} is measured in {}", dimension.describe(), units.join(", "))),
    }
}

/// What to write where a word stands that nothing declares.
fn unknown(required: Required) -> String {
    let Required { name, dimension } = required;
    let example = example_with_unit("0.5", dimension);
    format!("`{name}` is {}: write one, as `{example}`, or a name that `let` declares", dimension.describe())
}

/// The unit a soft-tissue researcher would most likely write.
fn preferred(dimension: Dimension) -> Option<String> {
    let units = dimension.suggested_units();
    let small = [Dimension::PRESSURE, Dimension::LENGTH, Dimension::TIME].contains(&dimension);
    units.get(usize::from(small && units.len() > 1)).cloned()
}

/// The number of a literal as written, without its unit.
fn number(file: &File, id: ExprId) -> Option<String> {
    let expr = file.tree.expr(id);
    match &expr.kind {
        ExprKind::Number { unit: None, .. } => Some(file.text(&expr.span).to_string()),
        ExprKind::Number { unit: Some(unit), .. } => {
            Some(file.text(&(expr.span.start..unit.span.start)).trim_end().to_string())
        }
        _ => None,
    }
}

/// `value` with the unit to suggest for a dimension: `7.64 kPa`.
pub(in crate::scene) fn example_with_unit(value: &str, dimension: Dimension) -> String {
    match preferred(dimension) {
        Some(unit) if !dimension.is_number() => format!("{value} {unit}"),
        _ => value.into(),
    }
}

/// The dimension an expression of dimension names means: `1/pressure`, `pressure*length`.
pub(in crate::scene) fn dimension(
    mistakes: &mut Mistakes,
    file: &File,
    id: ExprId,
) -> Result<Dimension, Reported> {
    let expr = file.tree.expr(id);
    match &expr.kind {
        ExprKind::Name(name) => Dimension::named(name).ok_or_else(|| {
            let names = || {
                known_dimensions()
                    .iter()
                    .flat_map(|known| [known.name].into_iter().chain(known.aliases.iter().copied()))
            };
            let help = match nearest(name, names()) {
                Some(meant) => format!("write `{meant}`"),
                None => "write number, length, time, pressure, density, 1/pressure or the like".into(),
            };
            let message = format!("there is no dimension `{name}`");
            mistakes.report(file, Code::UnknownDimension, expr.span.clone(), message, "", Some(help))
        }),
        ExprKind::Number { value: 1.0, unit: None } => Ok(Dimension::NUMBER),
        ExprKind::Binary { operator: BinaryOperator::Multiply, left, right, .. } => {
            let (left, right) = (dimension(mistakes, file, *left), dimension(mistakes, file, *right));
            Ok(left? * right?)
        }
        ExprKind::Binary { operator: BinaryOperator::Divide, left, right, .. } => {
            let (left, right) = (dimension(mistakes, file, *left), dimension(mistakes, file, *right));
            Ok(left? / right?)
        }
        ExprKind::Binary { operator: BinaryOperator::Power, left, right, .. } => match whole(file, *right) {
            Some(power) => Ok(dimension(mistakes, file, *left)?.powi(power)),
            None => Err(mistakes.report(
                file,
                Code::UnknownDimension,
                file.span(*right),
                "a dimension is raised to a whole power",
                "",
                None,
            )),
        },
        _ => {
            let message = "a dimension is a product of names such as `pressure` or `1/pressure`";
            Err(mistakes.report(file, Code::UnknownDimension, expr.span.clone(), message, "", None))
        }
    }
}

fn whole(file: &File, id: ExprId) -> Option<i64> {
    match &file.tree.expr(id).kind {
        ExprKind::Number { value, unit: None } if value.fract() == 0.0 && value.abs() < 100.0 => {
            Some(*value as i64)
        }
        ExprKind::Unary { operator: crate::syntax::UnaryOperator::Minus, operand } => {
            whole(file, *operand).map(|n| -n)
        }
        _ => None,
    }
}

impl Value {
    /// The scalar, if it is one.
    pub(in crate::scene) fn as_scalar(&self) -> Option<Scalar> {
        match self {
            Value::Scalar(scalar) => Some(*scalar),
            _ => None,
        }
    }
}
