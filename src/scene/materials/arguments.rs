//! The arguments an energy or a material is given, by name.

use super::*;
use crate::schema::nearest;

/// One argument: its name and its value, which is another than written if the command line says so.
pub(super) struct Given {
    pub(super) name: Name,
    pub(super) site: Site,
}

/// The arguments of a call.
pub(super) struct Arguments {
    list: Vec<Given>,
    /// Names that are no parameter, and the parameters they most likely mean.
    meant: Vec<String>,
    /// Whether an argument has no name; it may be meant for any parameter.
    unnamed: bool,
    /// Whether every argument is named, known and given once.
    pub(super) sound: bool,
}

impl Arguments {
    /// The argument of a name.
    pub(super) fn get(&self, name: &str) -> Option<&Given> {
        self.list.iter().find(|given| given.name.text == name)
    }

    /// Whether a parameter may be there, but misspelt or without its name.
    pub(super) fn is_misspelt(&self, name: &str) -> bool {
        self.unnamed || self.meant.iter().any(|meant| meant == name)
    }

    /// Sorts the arguments of a call; those that are not named, not known or given twice are reported.
    pub(super) fn read(
        mistakes: &mut Mistakes,
        file: &Rc<File>,
        function: &Name,
        arguments: &[Argument],
        known: &[&str],
    ) -> Self {
        let mut sorted = Self { list: Vec::new(), meant: Vec::new(), unnamed: false, sound: true };
        for argument in arguments {
            let Some(name) = argument.name.as_ref().and_then(|path| path.parts.first()) else {
                let message = format!("arguments of `{}` are named", function.text);
                let written = file.expression(argument.value);
                let help = known.first().map(|first| format!("write `{first} = {written}`"));
                let span = file.span(argument.value);
                mistakes.report(file, Code::WrongForm, span, message, "", help);
                (sorted.sound, sorted.unnamed) = (false, true);
                continue;
            };
            if !known.contains(&name.text.as_str()) {
                let message = format!("`{}` has no parameter `{}`", function.text, name.text);
                let meant = nearest(&name.text, known.iter().copied());
                let help = match meant {
                    Some(meant) => format!("write `{meant}`"),
                    None if known.is_empty() => "it has none".into(),
                    None => format!("its parameters are {}", known.join(", ")),
                };
                sorted.meant.extend(meant.map(String::from));
                let span = name.span.clone();
                mistakes.report(file, Code::UnknownArgument, span, message, "", Some(help));
                sorted.sound = false;
            } else if let Some(first) = sorted.get(&name.text) {
                super::super::members::duplicate(mistakes, file, name, &first.name);
                sorted.sound = false;
            } else {
                let site = Site { file: Rc::clone(file), id: argument.value };
                sorted.list.push(Given { name: name.clone(), site });
            }
        }
        sorted
    }

    /// The values by name.
    pub(super) fn values(self) -> BTreeMap<String, Site> {
        self.list.into_iter().map(|given| (given.name.text, given.site)).collect()
    }

    /// Puts values given on the command line in the place of those written: `adventitia.goh.C`.
    pub(super) fn replace(
        &mut self,
        energy: &EnergyDef,
        overrides: &Overrides,
        (material, prefix): (&str, &str),
    ) {
        for parameter in &energy.parameters {
            let found = overrides.find_parameter(material, prefix, &parameter.name.text);
            let Some(site) = found else { continue };
            match self.list.iter_mut().find(|given| given.name.text == parameter.name.text) {
                Some(given) => given.site = site,
                None => self.list.push(Given { name: parameter.name.clone(), site }),
            }
        }
    }
}
