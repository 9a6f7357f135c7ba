//! Fields of the particles, as a record, a figure or a probe names them.

use super::super::file::{File, Mistakes, Reported};
use super::super::model::Field;
use super::super::words::FIELD_WORDS;
use super::probes::AXES;
use crate::schema::nearest;
use crate::syntax::{Code, ExprId, ExprKind};
use crate::unit::Dimension;

/// A field of the particles, `sigma.xx`, and its dimension.
pub(super) fn written_field(
    mistakes: &mut Mistakes,
    file: &File,
    id: ExprId,
) -> Result<(Field, Dimension), Reported> {
    let written = file.expression(id);
    let (word, component) = written.split_once('.').unwrap_or((written, ""));
    let axis = AXES.iter().position(|axis| *axis == component).map(|axis| axis as u8);
    let pair: Vec<u8> = component.chars().filter_map(|c| "xyz".find(c)).map(|axis| axis as u8).collect();
    let pair = (component.len() == 2 && pair.len() == 2).then(|| (pair[0], pair[1]));
    let found = match (word, axis, pair) {
        ("displacement", Some(axis), _) => Some((Field::Displacement(axis), Dimension::LENGTH)),
        ("velocity", Some(axis), _) => Some((Field::Velocity(axis), Dimension::VELOCITY)),
        ("sigma", _, Some((i, j))) => Some((Field::Sigma(i, j), Dimension::PRESSURE)),
        ("P", _, Some((i, j))) => Some((Field::P(i, j), Dimension::PRESSURE)),
        ("F", _, Some((i, j))) => Some((Field::F(i, j), Dimension::NUMBER)),
        ("von_mises", ..) if component.is_empty() => Some((Field::VonMises, Dimension::PRESSURE)),
        ("pressure", ..) if component.is_empty() => Some((Field::Pressure, Dimension::PRESSURE)),
        ("J", ..) if component.is_empty() => Some((Field::J, Dimension::NUMBER)),
        _ => None,
    };
    found.ok_or_else(|| {
        let forms: Vec<&str> = FIELD_WORDS.iter().map(|word| word.form).collect();
        let message = format!("`{written}` is not a field of the particles");
        let help = match FIELD_WORDS.iter().find(|known| known.word == word) {
            Some(known) => format!("write `{}`", known.form),
            None => match nearest(word, FIELD_WORDS.iter().map(|word| word.word)) {
                Some(meant) => format!("write `{meant}`"),
                None => format!("the fields are {}", forms.join(", ")),
            },
        };
        // A field may be called by an expression of any form; what stands there is marked whole.
        let name = matches!(file.tree.expr(id).kind, ExprKind::Name(_) | ExprKind::Member { .. });
        let code = if name { Code::UnknownName } else { Code::WrongForm };
        mistakes.report(file, code, file.span(id), message, "", Some(help))
    })
}
