//! Values given on the command line in place of those in the file.

use super::super::file::{File, Mistakes};
use super::Site;
use crate::schema::nearest;
use crate::syntax::{Code, Entry, Item, Name, Source};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;

/// Values by path: `strip.spacing`, `run.until`, `adventitia.kappa`.
#[derive(Debug, Default)]
pub(in crate::scene) struct Overrides {
    values: BTreeMap<String, (Site, Name)>,
    used: RefCell<BTreeSet<String>>,
    known: RefCell<BTreeSet<String>>,
}

impl Overrides {
    /// Reads each value as the expression grammar does.
    pub(in crate::scene) fn read(mistakes: &mut Mistakes, overrides: &[(String, String)]) -> Self {
        let mut values = BTreeMap::new();
        for (path, value) in overrides {
            // One line each, so that a mistake shows the value as it was given.
            let text = format!("tissue 1\nset {{\n{path} = {value}\n}}\n");
            let source = Arc::new(Source { name: "--set".into(), text });
            let (tree, diagnostics) = crate::syntax::parse(&source);
            let file = Rc::new(File { source, tree, damaged: false });
            let broken = !diagnostics.is_empty();
            for diagnostic in diagnostics {
                mistakes.push(&file, diagnostic);
            }
            let entry = match file.tree.items.as_slice() {
                [Item::Block(block)] => match block.entries.as_slice() {
                    [Entry::Assign { keyword: None, key, value, .. }] => Some((key.clone(), *value)),
                    _ => None,
                },
                _ => None,
            };
            match entry {
                Some((key, id)) => {
                    let parts = &key.parts;
                    let span = parts[0].span.start..parts[parts.len() - 1].span.end;
                    let name = Name { text: path.clone(), span };
                    values.insert(path.clone(), (Site { file, id }, name));
                }
                None if broken => {}
                None => {
                    let end = file.source.text.len();
                    let message = "one value of the form `block.key=value` is required";
                    mistakes.report(&file, Code::UnknownOverride, 0..end, message, "", None);
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

    /// Reports the values nothing asked for.
    pub(in crate::scene) fn finish(&self, mistakes: &mut Mistakes) {
        let (used, known) = (self.used.borrow(), self.known.borrow());
        for (path, (site, name)) in self.values.iter().filter(|(path, _)| !used.contains(*path)) {
            let message = format!("nothing in the file is called `{path}`");
            let help = meant(path, &known).map(|meant| format!("write `{meant}`"));
            mistakes.report(&site.file, Code::UnknownOverride, name.span.clone(), message, "not used", help);
        }
    }
}

/// The path most likely meant: one that ends in the same word below the same block, or the nearest.
fn meant(path: &str, known: &BTreeSet<String>) -> Option<String> {
    let first = |path: &str| path.split('.').next().map(String::from);
    let last = |path: &str| path.rsplit('.').next().map(String::from);
    let alike = known.iter().find(|other| first(other) == first(path) && last(other) == last(path));
    alike.map(String::as_str).or_else(|| nearest(path, known.iter().map(String::as_str))).map(String::from)
}
