//! Files and what they import from one another.
//!
//! Owns the names of a file: its own and those it imports. Knows how an energy and a material are
//! read, not what they say.

use super::blocks::{block_name, unknown_block};
use super::energies;
use super::file::{File, Mistakes, Reported};
use super::library::{LIBRARIES, library};
use super::loader::{Loader, relative_to};
use super::materials::{self, Declared, Energies, Materials};
use super::members::{Overrides, duplicate};
use crate::schema::nearest;
use crate::syntax::{Block, Code, Import, ImportFrom, Item, Name, Path, Source, Span};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

/// What a file knows by name.
#[derive(Debug, Default)]
pub(super) struct Module {
    pub(super) energies: Energies,
    pub(super) materials: Materials,
    /// Names of the materials declared here, in order.
    pub(super) own_materials: Vec<String>,
    /// Blocks that are neither energies nor materials, in order.
    pub(super) rest: Vec<usize>,
}

/// What of a file is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Everything.
    All,
    /// Scenes and drives without what must hold of them, and no figures.
    Runs,
}

/// The files of one resolution.
pub(super) struct Session<'a> {
    pub(super) loader: &'a dyn Loader,
    pub(super) mistakes: Mistakes,
    pub(super) overrides: Overrides,
    /// What is read of the blocks.
    pub(super) wanted: Wanted,
    /// By name; `None` while the file is being read.
    modules: BTreeMap<String, Option<Rc<Module>>>,
    /// The files being read, outermost first.
    path: Vec<String>,
    /// Texts that have been parsed, by name.
    parsed: Rc<RefCell<BTreeMap<String, Rc<File>>>>,
}

impl<'a> Session<'a> {
    pub(super) fn new(loader: &'a dyn Loader, overrides: &[(String, String)]) -> Self {
        let mut mistakes = Mistakes::default();
        let overrides = Overrides::read(&mut mistakes, overrides);
        let parsed = Rc::new(RefCell::default());
        let wanted = Wanted::All;
        Self { loader, mistakes, overrides, wanted, modules: BTreeMap::new(), path: Vec::new(), parsed }
    }

    /// A session over the same texts that has found nothing yet.
    pub(super) fn again<'b>(&self, loader: &'b dyn Loader, overrides: &[(String, String)]) -> Session<'b> {
        Session { parsed: Rc::clone(&self.parsed), wanted: self.wanted, ..Session::new(loader, overrides) }
    }

    /// Parses a text; its mistakes are reported.
    pub(super) fn parse(&mut self, source: Source) -> Rc<File> {
        if let Some(known) = self.parsed.borrow().get(&source.name) {
            return Rc::clone(known);
        }
        let source = Arc::new(source);
        let (tree, diagnostics) = crate::syntax::parse(&source);
        let file = Rc::new(File { source, tree, damaged: !diagnostics.is_empty() });
        for diagnostic in diagnostics {
            self.mistakes.push(&file, diagnostic);
        }
        self.parsed.borrow_mut().insert(file.source.name.clone(), Rc::clone(&file));
        file
    }

    /// The names of a file.
    pub(super) fn module(&mut self, file: &Rc<File>) -> Rc<Module> {
        let key = file.source.name.clone();
        self.modules.insert(key.clone(), None);
        self.path.push(key.clone());
        let mut module = Module::default();
        let mut declared: BTreeMap<String, Name> = BTreeMap::new();
        for item in &file.tree.items {
            if let Item::Import(import) = item {
                self.import(file, import, &mut module, &mut declared);
            }
        }
        self.blocks(file, &mut module, &mut declared);
        self.path.pop();
        let module = Rc::new(module);
        self.modules.insert(key, Some(Rc::clone(&module)));
        module
    }

    fn blocks(&mut self, file: &Rc<File>, module: &mut Module, declared: &mut BTreeMap<String, Name>) {
        let mut materials: Vec<(&Block, Name)> = Vec::new();
        for (index, item) in file.tree.items.iter().enumerate() {
            let Item::Block(block) = item else { continue };
            let kind = block.kind.text.as_str();
            if !matches!(
                kind,
                "energy" | "material" | "scene" | "drive" | "fit" | "check" | "sweep" | "trade" | "figure"
            ) {
                unknown_block(&mut self.mistakes, file, block, None);
                continue;
            }
            let Some(name) = block_name(&mut self.mistakes, file, block) else { continue };
            // A check names a material that exists.
            if kind != "check" && !self.declare(file, declared, &name) {
                continue;
            }
            match kind {
                "energy" => {
                    let energy = energies::declare(&mut self.mistakes, file, block);
                    module.energies.insert(name.text, energy.ok().map(Rc::new));
                }
                "material" => materials.push((block, name)),
                _ => module.rest.push(index),
            }
        }
        // After all energies, wherever they stand.
        for (block, name) in materials {
            let (energies, written) = (&module.energies, BTreeMap::new());
            let overrides = &self.overrides;
            let material =
                materials::read(&mut self.mistakes, file, block, &name, energies, overrides, &written);
            module.own_materials.push(name.text.clone());
            let declared = material.ok().map(|material| Declared {
                material: Rc::new(material),
                file: Rc::clone(file),
                block: block.clone(),
                name: name.clone(),
                energies: module.energies.clone(),
            });
            module.materials.insert(name.text, declared.map(Rc::new));
        }
    }

    fn declare(&mut self, file: &File, declared: &mut BTreeMap<String, Name>, name: &Name) -> bool {
        if let Some(first) = declared.get(&name.text) {
            duplicate(&mut self.mistakes, file, name, first);
            return false;
        }
        declared.insert(name.text.clone(), name.clone());
        true
    }

    fn import(
        &mut self,
        file: &Rc<File>,
        import: &Import,
        module: &mut Module,
        declared: &mut BTreeMap<String, Name>,
    ) {
        let source = match &import.from {
            ImportFrom::Library(path) => self.library_name(file, path),
            ImportFrom::File(path, span) => self.imported(file, path, span).map(From::File),
        };
        for name in &import.names {
            if !self.declare(file, declared, name) {
                continue;
            }
            let found = match &source {
                Ok(From::File(module)) => Some(Rc::clone(module)),
                Ok(From::Library(library)) => self.library_module(library, &name.text),
                Err(Reported) => None,
            };
            let energy = found.as_ref().and_then(|found| found.energies.get(&name.text).cloned());
            let material = found.as_ref().and_then(|found| found.materials.get(&name.text).cloned());
            if energy.is_none() && material.is_none() && source.is_ok() {
                self.unknown_import(file, name, source.as_ref().ok(), import);
            }
            // A name that could not be imported stays known, so that its uses are no further mistakes.
            if material.is_some() || energy.is_none() {
                module.materials.insert(name.text.clone(), material.flatten());
            }
            if material_is_absent(module, &name.text) {
                module.energies.insert(name.text.clone(), energy.flatten());
            }
        }
    }

    fn library_name(&mut self, file: &File, path: &Path) -> Result<From, Reported> {
        let parts: Vec<&str> = path.parts.iter().map(|part| part.text.as_str()).collect();
        if let ["std", library] = parts.as_slice()
            && let Some(known) = LIBRARIES.iter().find(|known| known == &library)
        {
            return Ok(From::Library(known));
        }
        let span = path.parts[0].span.start..path.parts[path.parts.len() - 1].span.end;
        let last = path.parts[path.parts.len() - 1].text.as_str();
        let help = match nearest(last, LIBRARIES.iter().copied()) {
            Some(meant) => format!("write `std.{meant}`"),
            None => "the libraries are std.energies and std.materials; a file is named in quotes".into(),
        };
        let message = format!("there is no library `{}`", parts.join("."));
        Err(self.mistakes.report(file, Code::UnknownImport, span, message, "", Some(help)))
    }

    fn library_module(&mut self, library_name: &str, name: &str) -> Option<Rc<Module>> {
        // The file of the same name first: one file is parsed, not all.
        let of_library = || library().iter().filter(|file| file.library == library_name);
        let ordered = of_library()
            .filter(|file| file.name == name)
            .chain(of_library().filter(|file| file.name != name));
        for embedded in ordered {
            let key = format!("std/{}/{}.tissue", embedded.library, embedded.name);
            let module = match self.modules.get(&key) {
                Some(module) => module.clone()?,
                None => {
                    let file = self.parse(Source { name: key, text: embedded.text.into() });
                    self.module(&file)
                }
            };
            if module.energies.contains_key(name) || module.materials.contains_key(name) {
                return Some(module);
            }
        }
        None
    }

    fn imported(&mut self, file: &File, path: &str, span: &Span) -> Result<Rc<Module>, Reported> {
        let key = relative_to(&file.source.name, path);
        match self.modules.get(&key) {
            Some(Some(module)) => return Ok(Rc::clone(module)),
            Some(None) => {
                let from = self.path.iter().position(|name| *name == key).unwrap_or(0);
                let circle: Vec<&str> =
                    self.path[from..].iter().map(String::as_str).chain([key.as_str()]).collect();
                let message = format!("files import each other in a circle: {}", circle.join(" -> "));
                return Err(self.mistakes.report(file, Code::ImportCycle, span.clone(), message, "", None));
            }
            None => {}
        }
        if self.path.len() >= 64 {
            let message = "imports are nested deeper than 64 files";
            return Err(self.mistakes.report(file, Code::ImportCycle, span.clone(), message, "", None));
        }
        match self.loader.load(&key) {
            Ok(text) => {
                let imported = self.parse(Source { name: key, text });
                Ok(self.module(&imported))
            }
            Err(error) => {
                let message = format!("`{key}` cannot be read: {error}");
                Err(self.mistakes.report(file, error.code(), span.clone(), message, "", None))
            }
        }
    }

    fn unknown_import(&mut self, file: &File, name: &Name, from: Option<&From>, import: &Import) {
        let known: Vec<String> = match from {
            Some(From::File(module)) => {
                module.energies.keys().chain(module.materials.keys()).cloned().collect()
            }
            Some(From::Library(library_name)) => {
                let files = library().iter().filter(|file| file.library == *library_name);
                files.map(|file| file.name.to_string()).collect()
            }
            None => vec![],
        };
        let source = match &import.from {
            ImportFrom::Library(path) => {
                path.parts.iter().map(|part| part.text.as_str()).collect::<Vec<_>>().join(".")
            }
            ImportFrom::File(path, _) => path.clone(),
        };
        let help =
            nearest(&name.text, known.iter().map(String::as_str)).map(|meant| format!("write `{meant}`"));
        let message = format!("`{source}` has no `{}`", name.text);
        self.mistakes.report(file, Code::UnknownImport, name.span.clone(), message, "", help);
    }
}

fn material_is_absent(module: &Module, name: &str) -> bool {
    module.materials.get(name).is_none_or(Option::is_none)
}

/// Where names come from.
enum From {
    Library(&'static str),
    File(Rc<Module>),
}
