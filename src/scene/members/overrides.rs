//! Values given on the command line in place of those in the file.

use super::super::file::{File, Mistakes};
use super::Site;
use crate::schema::nearest;
use crate::syntax::{Code, Name, Source, SyntaxTree, parse_expression};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;

/// What stands for the file of a value given on the command line.
pub(in crate::scene) const COMMAND_LINE: &str = "--set";

/// Values by path: `strip.spacing`, `run.until`, `adventitia.kappa`.
#[derive(Debug, Default)]
pub(in crate::scene) struct Overrides {
    values: BTreeMap<String, (Site, Name)>,
    used: RefCell<BTreeSet<String>>,
    known: RefCell<BTreeSet<String>>,
    /// What a parameter is called without its energy, `gel.mu`, and the whole paths that it may mean.
    short: RefCell<BTreeMap<String, BTreeSet<String>>>,
}

impl Overrides {
    /// Reads each value as the expression grammar does.
    pub(in crate::scene) fn read(mistakes: &mut Mistakes, overrides: &[(String, String)]) -> Self {
        let mut values = BTreeMap::new();
        for (path, value) in overrides {
            // A source of its own, so that a mistake shows the argument as it was given; read with the path blanked,
            // so that columns are those of the argument.
            let source = Source { name: COMMAND_LINE.into(), text: format!("{path}={value}") };
            let blanked = format!("{}{value}", " ".repeat(path.len() + 1));
            match parse_expression(&Source { name: source.name.clone(), text: blanked }) {
                Ok((tree, id)) => {
                    let file = Rc::new(File { source: Arc::new(source), tree, damaged: false });
                    let name = Name { text: path.clone(), span: 0..path.len() };
                    values.insert(path.clone(), (Site { file, id }, name));
                }
                Err(diagnostics) => {
                    let source = Arc::new(source);
                    let tree = SyntaxTree::default();
                    let file = Rc::new(File { source, tree, damaged: false });
                    for diagnostic in diagnostics {
                        mistakes.push(&file, diagnostic);
                    }
                }
            }
        }
        Self { values, ..Self::default() }
    }

    /// Puts a value in the place of one written, as a point of a sweep does.
    pub(in crate::scene) fn insert(&mut self, path: &Name, site: Site) {
        self.values.insert(path.text.clone(), (site, path.clone()));
    }

    /// What nothing asked for under this path, and the path most likely meant.
    pub(in crate::scene) fn unused(&self, path: &str) -> Option<Option<String>> {
        if self.used.borrow().contains(path) {
            return None;
        }
        let known = self.known.borrow();
        Some(meant(path, &known))
    }

    /// The value given for a key of a block; `path` is the scene, if any, and the block.
    pub(in crate::scene) fn find(&self, path: &[&str], key: &str) -> Option<Site> {
        (0..path.len()).find_map(|from| {
            let full = format!("{}.{key}", path[from..].join("."));
            let found = self.values.get(&full).map(|(site, _)| site.clone());
            if found.is_some() {
                self.used.borrow_mut().insert(full.clone());
            }
            self.known.borrow_mut().insert(full);
            found
        })
    }

    /// The value given for a parameter of an energy: `gel.goh.k1`, or `gel.k1`.
    pub(in crate::scene) fn find_parameter(&self, material: &str, energy: &str, key: &str) -> Option<Site> {
        let short = format!("{material}.{key}");
        let is_own = self.known.borrow().contains(&short);
        let found = self.find(&[material, energy], key);
        if is_own {
            // a parameter of the material itself
            return found;
        }
        let full = format!("{material}.{energy}.{key}");
        self.short.borrow_mut().entry(short.clone()).or_default().insert(full);
        found.or_else(|| {
            let (site, _) = self.values.get(&short)?;
            self.used.borrow_mut().insert(short);
            Some(site.clone())
        })
    }

    /// What a path may mean, where it is more than one parameter.
    pub(in crate::scene) fn several(&self, path: &str) -> Option<Vec<String>> {
        let short = self.short.borrow();
        let meant = short.get(path).filter(|meant| meant.len() > 1)?;
        Some(meant.iter().cloned().collect())
    }

    /// Reports a value as not used, at its path.
    pub(in crate::scene) fn refuse(
        &self,
        mistakes: &mut Mistakes,
        path: &str,
        message: String,
        help: String,
    ) {
        if let Some((site, name)) = self.values.get(path) {
            let span = name.span.clone();
            mistakes.report(&site.file, Code::UnknownOverride, span, message, "not used", Some(help));
        }
    }

    /// Reports the values nothing asked for, and those that several parameters could mean; `within` is what was
    /// read: the file, or the scene that is wanted.
    pub(in crate::scene) fn finish(&self, mistakes: &mut Mistakes, within: &str) {
        for (path, (site, name)) in &self.values {
            if let Some(meant) = self.several(path) {
                let (message, help) = ambiguous(path, &meant);
                mistakes.report(&site.file, Code::WrongForm, name.span.clone(), message, "", Some(help));
            }
        }
        let (used, known) = (self.used.borrow(), self.known.borrow());
        for (path, (site, name)) in self.values.iter().filter(|(path, _)| !used.contains(*path)) {
            let message = format!("nothing in {within} is called `{path}`");
            let help = meant(path, &known).map(|meant| format!("write `{meant}`"));
            mistakes.report(&site.file, Code::UnknownOverride, name.span.clone(), message, "not used", help);
        }
    }
}

/// That a short path is the name of several parameters, and what to write instead.
pub(in crate::scene) fn ambiguous(path: &str, meant: &[String]) -> (String, String) {
    let names: Vec<String> = meant.iter().map(|path| format!("`{path}`")).collect();
    (format!("`{path}` is the name of {} parameters", meant.len()), format!("write {}", names.join(" or ")))
}

/// The path most likely meant: one that ends in the same word below the same block, or the nearest.
fn meant(path: &str, known: &BTreeSet<String>) -> Option<String> {
    let first = |path: &str| path.split('.').next().map(String::from);
    let last = |path: &str| path.rsplit('.').next().map(String::from);
    let alike = known.iter().find(|other| first(other) == first(path) && last(other) == last(path));
    alike.map(String::as_str).or_else(|| nearest(path, known.iter().map(String::as_str))).map(String::from)
}
