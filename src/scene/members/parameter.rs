//! Declared parameters.

use super::super::evaluate::{Evaluator, Leaves, Required, Scope, dimension};
use super::super::file::{File, Mistakes, Reported};
use super::{ParamEntry, ParameterDef, within};

impl ParameterDef {
    /// Proves that range and default have the parameter's dimension.
    pub(in crate::scene) fn prove<L: Leaves>(&self, evaluator: &mut Evaluator<L>, scope: &dyn Scope<L>) {
        let ends = self.bounds.iter().flat_map(|bounds| [&bounds.lower, &bounds.upper]).flatten();
        for (end, _) in ends {
            let _ = within::bound(evaluator, scope, *end, self);
        }
        if let Some(default) = self.default {
            let required = Required { name: &self.name.text, dimension: self.dimension };
            let _ = evaluator.quantity(scope, default, required);
        }
    }

    /// Reads a `param` entry.
    pub(in crate::scene) fn read(
        mistakes: &mut Mistakes,
        file: &File,
        entry: &ParamEntry,
    ) -> Result<Self, Reported> {
        Ok(Self {
            name: entry.name.clone(),
            count: entry.count.clone(),
            dimension: dimension(mistakes, file, entry.dimension)?,
            written: file.expression(entry.dimension).into(),
            bounds: entry.bounds.clone(),
            default: entry.default,
            doc: entry.doc.clone(),
        })
    }
}
