//! `record` and `frames`.

use super::super::blocks::block_name;
use super::super::evaluate::{Evaluator, Leaves, Scope};
use super::super::file::{Mistakes, Reported};
use super::super::members::{Members, duplicate};
use super::super::model::{Column, Frames, Probe, Record};
use super::super::words::{FRAMES, RECORD};
use super::faces::Bodies;
use super::probes::ProbeScope;
use super::stage::Stage;
use crate::syntax::{Block, Code, ExprId, Name};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The column every record has.
pub(super) const TIME: &str = "t";

impl Stage<'_> {
    /// The name of a table, of frames or of a figure, which is also that of their files.
    pub(in crate::scene) fn output_name(&mut self, block: &Block) -> Result<Name, Reported> {
        let name = block_name(self.mistakes, &self.file, block).ok_or(Reported)?;
        if let Some(first) = self.outputs.get(&name.text) {
            duplicate(self.mistakes, &self.file, &name, first);
            return Err(Reported);
        }
        self.outputs.insert(name.text.clone(), name.clone());
        Ok(name)
    }

    pub(super) fn record(&mut self, block: &Block) -> Result<(), Reported> {
        let name = self.output_name(block)?;
        let file = Rc::clone(&self.file);
        let path = [self.name.text.clone(), name.text.clone()];
        let path = [path[0].as_str(), path[1].as_str()];
        let members = Members::read_with(self.mistakes, &file, &RECORD, block, self.overrides, &path);
        let every = members
            .required(self.mistakes, &file, &RECORD, block, "every")
            .and_then(|site| self.positive(&site, "every", Dimension::TIME));
        let time = BTreeMap::from([(TIME.to_string(), Some(Dimension::TIME))]);
        let own = |column: &Name| {
            let message = "every record has the column `t` already: it is the time";
            (column.text == TIME).then(|| (Code::DuplicateName, message.into(), None))
        };
        let example = "is to be recorded, for example `E = total_energy`";
        let columns = self.read_columns(&name, &members, time, example, own, Self::column_value);
        let every = every?;
        let (columns, place) = (columns?, file.place(&block.kind.span));
        self.scene.records.push(Record { name: name.text, place, columns, every });
        Ok(())
    }

    /// Columns of a record and their dimensions, which are declared with those it has anyway, mistakes or none.
    ///
    /// `refused` tells which names it may not give a column and why; `example` ends the help of an empty record.
    pub(in crate::scene) fn read_columns<L>(
        &mut self,
        record: &Name,
        members: &Members,
        mut dimensions: BTreeMap<String, Option<Dimension>>,
        example: &str,
        refused: impl Fn(&Name) -> Option<(Code, String, Option<String>)>,
        read: impl Fn(&mut Self, &Name, ExprId) -> Result<(Column<L>, Dimension), Reported>,
    ) -> Result<Vec<Column<L>>, Reported> {
        let file = Rc::clone(&self.file);
        let mut columns = Vec::new();
        let mut sound = true;
        for (column, id) in &members.free {
            if let Some((code, message, help)) = refused(column) {
                self.mistakes.report(&file, code, column.span.clone(), message, "", help);
                sound = false;
                continue;
            }
            let value = read(self, column, *id);
            sound &= value.is_ok();
            dimensions.insert(column.text.clone(), value.as_ref().ok().map(|(_, dimension)| *dimension));
            columns.extend(value.map(|(column, _)| column));
        }
        self.columns.insert(record.text.clone(), dimensions);
        if members.free.is_empty() {
            let message = format!("the record `{}` has no columns", record.text);
            let help = Some(format!("write `name = …` with what {example}"));
            return Err(self.mistakes.report(
                &file,
                Code::MissingKey,
                record.span.clone(),
                message,
                "",
                help,
            ));
        }
        if sound { Ok(columns) } else { Err(Reported) }
    }

    fn column_value(&mut self, name: &Name, id: ExprId) -> Result<(Column<Probe>, Dimension), Reported> {
        let file = Rc::clone(&self.file);
        let scope = ProbeScope {
            file: &file,
            lets: self.lets.fresh(),
            bodies: Bodies { names: &self.body_names, scene: &self.scene },
        };
        column(self.mistakes, &scope, name, id)
    }

    pub(super) fn frames(&mut self, block: &Block) -> Result<(), Reported> {
        let name = self.output_name(block)?;
        let file = Rc::clone(&self.file);
        let path = [self.name.text.clone(), name.text.clone()];
        let path = [path[0].as_str(), path[1].as_str()];
        let members = Members::read_with(self.mistakes, &file, &FRAMES, block, self.overrides, &path);
        let every = members
            .required(self.mistakes, &file, &FRAMES, block, "every")
            .and_then(|site| self.positive(&site, "every", Dimension::TIME));
        let values = members
            .required(self.mistakes, &file, &FRAMES, block, "values")
            .and_then(|site| self.chosen_list(&site, &FRAMES, "values"));
        let values: Vec<String> = values?.into_iter().map(String::from).collect();
        if let ([], Some(site)) = (values.as_slice(), members.written("values")) {
            let message = format!("the frames `{}` hold no field", name.text);
            let span = site.file.span(site.id);
            let help =
                Some("write the fields to look at, for example `values = [displacement, sigma]`".into());
            return Err(self.mistakes.report(&site.file, Code::MissingKey, span, message, "", help));
        }
        self.scene.frames.push(Frames {
            name: name.text,
            place: file.place(&block.kind.span),
            values,
            every: every?,
        });
        Ok(())
    }
}

/// One column: the formula as written, with its unit.
pub(in crate::scene) fn column<L: Leaves>(
    mistakes: &mut Mistakes,
    scope: &dyn Scope<L>,
    name: &Name,
    id: ExprId,
) -> Result<(Column<L>, Dimension), Reported> {
    let mut evaluator = Evaluator::<L>::new(mistakes);
    let scalar = evaluator.scalar(scope, id)?;
    let file = scope.file();
    let column = Column {
        name: name.text.clone(),
        place: file.place(&name.span),
        value: evaluator.tape(scalar),
        unit: scalar.dimension.si_symbol(),
        text: file.expression(id).split_whitespace().collect::<Vec<_>>().join(" "),
    };
    Ok((column, scalar.dimension))
}
