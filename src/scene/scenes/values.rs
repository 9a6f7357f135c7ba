//! `value(record.column, other = quantity)`: a column where another of the same table has a value.

use super::super::evaluate::{Evaluator, Leaves, Required, Scope};
use super::super::file::{Mistakes, Reported};
use super::plots::{ColumnName, column_name};
use crate::syntax::{Argument, Code, Name};
use crate::unit::Dimension;

/// Which number of a column is meant.
pub(in crate::scene) struct PlaceOfValue {
    pub(in crate::scene) record: String,
    pub(in crate::scene) column: String,
    /// Dimension of the column.
    pub(in crate::scene) dimension: Dimension,
    /// The column that takes the value.
    pub(in crate::scene) abscissa: String,
    /// The value, SI.
    pub(in crate::scene) value: f64,
}

/// Reads the arguments of `value(…)`; `dimension` knows the columns.
pub(in crate::scene) fn place_of_value<L: Leaves>(
    evaluator: &mut Evaluator<L>,
    outer: &dyn Scope<L>,
    function: &Name,
    arguments: &[Argument],
    dimension: &dyn Fn(&mut Mistakes, &ColumnName) -> Result<Dimension, Reported>,
) -> Result<PlaceOfValue, Reported> {
    let file = std::rc::Rc::clone(outer.file());
    let (id, other, place) = match arguments {
        [Argument { name: None, value: column }, Argument { name: Some(other), value: place }]
            if other.parts.len() == 1 =>
        {
            (*column, &other.parts[0], *place)
        }
        _ => {
            let message = "`value` takes a column and where it is read";
            let help = Some("write `value(record.column, t = 1 ms)`".into());
            let span = function.span.clone();
            return Err(evaluator.mistakes.report(&file, Code::WrongForm, span, message, "", help));
        }
    };
    let column = column_name(evaluator.mistakes, &file, id)?;
    let own = dimension(evaluator.mistakes, &column)?;
    let abscissa = ColumnName { table: column.table.clone(), column: other.clone() };
    let along = dimension(evaluator.mistakes, &abscissa)?;
    let required = Required { name: &other.text, dimension: along };
    let value = evaluator.constant(outer, place, required)?;
    Ok(PlaceOfValue {
        record: column.table.text,
        column: column.column.text,
        dimension: own,
        abscissa: abscissa.column.text,
        value,
    })
}
