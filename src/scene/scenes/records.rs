//! `record` and `frames`.

use super::super::blocks::block_name;
use super::super::evaluate::Evaluator;
use super::super::file::Reported;
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
        let mut dimensions = BTreeMap::from([(TIME.to_string(), Some(Dimension::TIME))]);
        let mut columns = Vec::new();
        let mut sound = true;
        for (column, id) in &members.free {
            if column.text == TIME {
                let message = "every record has the column `t` already: it is the time";
                self.mistakes.report(&file, Code::DuplicateName, column.span.clone(), message, "", None);
                sound = false;
                continue;
            }
            let value = self.column_value(column, *id);
            sound &= value.is_ok();
            dimensions.insert(column.text.clone(), value.as_ref().ok().map(|(_, dimension)| *dimension));
            columns.extend(value.map(|(column, _)| column));
        }
        self.columns.insert(name.text.clone(), dimensions);
        if members.free.is_empty() {
            let message = format!("the record `{}` has no columns", name.text);
            let help = "write `name = …` with what is to be recorded, for example `E = total_energy`";
            return Err(self.mistakes.report(
                &file,
                Code::MissingKey,
                name.span,
                message,
                "",
                Some(help.into()),
            ));
        }
        let every = every?;
        if sound {
            let place = file.place(&block.kind.span);
            self.scene.records.push(Record { name: name.text, place, columns, every });
        }
        Ok(())
    }

    fn column_value(&mut self, name: &Name, id: ExprId) -> Result<(Column, Dimension), Reported> {
        let file = Rc::clone(&self.file);
        let scope = ProbeScope {
            file: &file,
            lets: self.lets.fresh(),
            bodies: Bodies { names: &self.body_names, scene: &self.scene },
        };
        let mut evaluator = Evaluator::<Probe>::new(self.mistakes);
        let value = evaluator.scalar(&scope, id).map(|scalar| (evaluator.tape(scalar), scalar.dimension));
        let (value, dimension) = value?;
        let column = Column {
            name: name.text.clone(),
            place: file.place(&name.span),
            value,
            unit: dimension.si_symbol(),
            text: file.expression(id).split_whitespace().collect::<Vec<_>>().join(" "),
        };
        Ok((column, dimension))
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
        let values = values?.into_iter().map(String::from).collect();
        self.scene.frames.push(Frames {
            name: name.text,
            place: file.place(&block.kind.span),
            values,
            every: every?,
        });
        Ok(())
    }
}
