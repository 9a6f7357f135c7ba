//! The use of a material by name, with other values of its parameters if a use gives them.
//!
//! Owns the lookup for bodies and drives alike. Knows neither.

use super::arguments::Arguments;
use super::*;
use crate::schema::nearest;
use crate::syntax::{Entry, ExprKind};

/// A material and its declaration, so that a use may give its parameters other values.
#[derive(Debug)]
pub(in crate::scene) struct Declared {
    /// With the values written.
    pub(in crate::scene) material: Rc<Material>,
    /// Where it stands.
    pub(in crate::scene) file: Rc<File>,
    /// What is written there.
    pub(in crate::scene) block: Block,
    /// Its name.
    pub(in crate::scene) name: Name,
    /// The energies known there.
    pub(in crate::scene) energies: Energies,
}

/// Materials by name, `None` where the declaration is wrong.
pub(in crate::scene) type Materials = BTreeMap<String, Option<Rc<Declared>>>;

/// The material a `material = …` names: `gel`, or `gel(mu = 2 kPa)` with values for its parameters.
///
/// # Errors
/// [`Reported`] if there is no such material, its declaration is wrong or a value is.
pub(in crate::scene) fn used(
    mistakes: &mut Mistakes,
    overrides: &Overrides,
    materials: &Materials,
    site: &Site,
) -> Result<Rc<Material>, Reported> {
    let (file, span) = (&site.file, site.file.span(site.id));
    let (name, call) = match &file.tree.expr(site.id).kind {
        ExprKind::Name(name) => (name, None),
        ExprKind::Call { function, arguments } => (&function.text, Some((function, arguments))),
        _ => {
            let message = "`material` is the name of a material";
            return Err(mistakes.report(file, Code::WrongForm, span, message, "", None));
        }
    };
    let Some(declared) = materials.get(name) else {
        let names: Vec<&str> = materials.keys().map(String::as_str).collect();
        let help = match nearest(name, names.iter().copied()) {
            Some(meant) => Some(format!("write `{meant}`")),
            None if names.is_empty() => None,
            None => Some(format!("the materials are {}", names.join(", "))),
        };
        let message = format!("there is no material `{name}`");
        return Err(mistakes.report(file, Code::UnknownName, span, message, "not declared", help));
    };
    // What is wrong with its declaration has been reported there.
    let declared = declared.as_ref().ok_or(Reported)?;
    let Some((function, arguments)) = call else { return Ok(Rc::clone(&declared.material)) };
    let parameters = declared.block.entries.iter().filter_map(|entry| match entry {
        Entry::Parameter { name, .. } => Some(name.text.as_str()),
        _ => None,
    });
    let known: Vec<&str> = parameters.collect();
    let given = Arguments::read(mistakes, file, function, arguments, &known);
    if !given.sound {
        return Err(Reported);
    }
    let Declared { file, block, name, energies, .. } = &**declared;
    read(mistakes, file, block, name, energies, overrides, &given.values()).map(Rc::new)
}
