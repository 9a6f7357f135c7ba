//! Sorting entries.

use super::super::evaluate::Let;
use super::super::file::{File, Mistakes, Reported};
use super::Overrides;
use crate::schema::{Declaration, Member, Presence, nearest};
use crate::syntax::{At, Block, Bounds, Code, Diagnostic, Entry, ExprId, Name, Span};
use crate::unit::Dimension;
use std::collections::BTreeMap;
use std::rc::Rc;

/// An expression and the file it stands in, which is not the block's where a value is overridden.
#[derive(Debug, Clone)]
pub(in crate::scene) struct Site {
    pub(in crate::scene) file: Rc<File>,
    pub(in crate::scene) id: ExprId,
}

/// `param name : dimension in bounds = default`, as written.
#[derive(Debug, Clone)]
pub(in crate::scene) struct ParamEntry {
    pub(in crate::scene) name: Name,
    pub(in crate::scene) count: Option<Name>,
    pub(in crate::scene) dimension: ExprId,
    pub(in crate::scene) bounds: Option<Bounds>,
    pub(in crate::scene) default: Option<ExprId>,
    pub(in crate::scene) doc: Vec<String>,
}

/// A declared parameter.
#[derive(Debug, Clone)]
pub(in crate::scene) struct ParameterDef {
    pub(in crate::scene) name: Name,
    pub(in crate::scene) count: Option<Name>,
    pub(in crate::scene) dimension: Dimension,
    /// The dimension as written.
    pub(in crate::scene) written: String,
    pub(in crate::scene) bounds: Option<Bounds>,
    pub(in crate::scene) default: Option<ExprId>,
    pub(in crate::scene) doc: Vec<String>,
}

/// `expect claim within tolerance at key = values`, as written.
#[derive(Debug, Clone)]
pub(in crate::scene) struct ExpectEntry {
    pub(in crate::scene) claim: ExprId,
    pub(in crate::scene) within: Option<ExprId>,
    pub(in crate::scene) at: Option<At>,
    pub(in crate::scene) span: Span,
}

/// `vary path = values`, as written.
#[derive(Debug, Clone)]
pub(in crate::scene) struct VaryEntry {
    /// The path with dots, and where it stands.
    pub(in crate::scene) path: Name,
    pub(in crate::scene) value: ExprId,
}

/// The entries of a block.
#[derive(Debug, Default)]
pub(in crate::scene) struct Members<'a> {
    keys: BTreeMap<String, Site>,
    pub(in crate::scene) parameters: Vec<ParamEntry>,
    pub(in crate::scene) lets: BTreeMap<String, Let>,
    pub(in crate::scene) fibres: Option<Name>,
    pub(in crate::scene) fibre: Vec<(Name, ExprId)>,
    pub(in crate::scene) directions: Vec<Name>,
    /// Entries whose name is free: columns of a record, directions of a frame.
    pub(in crate::scene) free: Vec<(Name, ExprId)>,
    pub(in crate::scene) expects: Vec<ExpectEntry>,
    pub(in crate::scene) varied: Vec<VaryEntry>,
    pub(in crate::scene) blocks: Vec<&'a Block>,
    declared: BTreeMap<String, Name>,
    /// Keys that a misspelt one most likely means.
    meant: Vec<&'static str>,
}

impl<'a> Members<'a> {
    /// Sorts the entries of a block; what does not belong there is reported.
    pub(in crate::scene) fn read(
        mistakes: &mut Mistakes,
        file: &Rc<File>,
        declaration: &'static Declaration,
        block: &'a Block,
    ) -> Self {
        let mut members = Members::default();
        let mut sorting = Sorting { mistakes, file, declaration };
        for entry in &block.entries {
            sorting.sort(&mut members, entry);
        }
        members
    }

    /// The same with the values given on the command line for this block in place of those written.
    pub(in crate::scene) fn read_with(
        mistakes: &mut Mistakes,
        file: &Rc<File>,
        declaration: &'static Declaration,
        block: &'a Block,
        overrides: &Overrides,
        path: &[&str],
    ) -> Self {
        let mut members = Self::read(mistakes, file, declaration, block);
        for key in declaration.keys {
            if let Some(site) = overrides.find(path, key.name) {
                members.keys.insert(key.name.into(), site);
            }
        }
        members
    }

    /// The names the block declares.
    pub(in crate::scene) fn names(&self) -> impl Iterator<Item = &Name> {
        self.declared.values()
    }

    /// The value of a key, if it is written.
    pub(in crate::scene) fn written(&self, key: &str) -> Option<&Site> {
        self.keys.get(key)
    }

    /// The value of a key that must be written.
    pub(in crate::scene) fn required(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        declaration: &Declaration,
        block: &Block,
        key: &str,
    ) -> Result<Site, Reported> {
        if let Some(site) = self.keys.get(key) {
            return Ok(site.clone());
        }
        if self.meant.contains(&key) {
            // It is there, misspelt, and that has been reported.
            return Err(Reported);
        }
        let name = block.target.as_ref().map_or(String::new(), |path| {
            let parts: Vec<&str> = path.parts.iter().map(|part| part.text.as_str()).collect();
            format!(" {}", parts.join("."))
        });
        let message = format!("`{}{name}` needs `{key}`", block.kind.text);
        let help = declaration.key(key).and_then(|parameter| match parameter.presence {
            Presence::Required(example) => Some(format!("write `{example}` with the value that is meant")),
            _ => None,
        });
        let span = block.target.as_ref().map_or(block.kind.span.clone(), |path| {
            block.kind.span.start..path.parts.last().map_or(block.kind.span.end, |part| part.span.end)
        });
        Err(mistakes.report(file, Code::MissingKey, span, message, format!("no `{key}`"), help))
    }

    /// The expression of a key that must be written in the block itself.
    pub(in crate::scene) fn key(
        &self,
        mistakes: &mut Mistakes,
        file: &File,
        declaration: &Declaration,
        block: &Block,
        key: &str,
    ) -> Result<ExprId, Reported> {
        self.required(mistakes, file, declaration, block, key).map(|site| site.id)
    }
}

struct Sorting<'m, 'f> {
    mistakes: &'m mut Mistakes,
    file: &'f Rc<File>,
    declaration: &'static Declaration,
}

impl Sorting<'_, '_> {
    fn sort<'a>(&mut self, members: &mut Members<'a>, entry: &'a Entry) {
        match entry {
            Entry::Block(block) => members.blocks.push(block),
            Entry::Parameter { name, count, dimension, bounds, default, doc, .. } => {
                if self.allowed(Member::Param, "param", &name.span) && self.declare(members, name) {
                    members.parameters.push(ParamEntry {
                        name: name.clone(),
                        count: count.clone(),
                        dimension: *dimension,
                        bounds: bounds.clone(),
                        default: *default,
                        doc: doc.clone(),
                    });
                }
            }
            Entry::Declare { keyword, name } => match keyword.text.as_str() {
                "fibres" if self.allowed(Member::Fibres, "fibres", &keyword.span) => {
                    members.fibres = Some(name.clone());
                }
                "direction" if self.allowed(Member::Direction, "direction", &keyword.span) => {
                    if self.declare(members, name) {
                        members.directions.push(name.clone());
                    }
                }
                "fibres" | "direction" => {}
                other => {
                    self.unknown(other, &keyword.span, other);
                }
            },
            Entry::Expect { claim, within, at, span } => {
                if self.allowed(Member::Expect, "expect", span) {
                    members.expects.push(ExpectEntry {
                        claim: *claim,
                        within: *within,
                        at: at.clone(),
                        span: span.clone(),
                    });
                }
            }
            Entry::Assign { keyword, key, arguments, value, span } => {
                let Some(name) = key.parts.first() else { return };
                if key.parts.len() > 1 && keyword.is_none() {
                    let written = self
                        .file
                        .text(&(name.span.start..key.parts[key.parts.len() - 1].span.end))
                        .to_string();
                    self.unknown(&written, &name.span, &written);
                    return;
                }
                match keyword.as_ref().map(|keyword| keyword.text.as_str()) {
                    None => self.assign(members, name, *value),
                    Some("let") if self.allowed(Member::Let, "let", span) => {
                        if self.declare(members, name) {
                            let definition =
                                Let { name: name.clone(), arguments: arguments.clone(), value: *value };
                            members.lets.insert(name.text.clone(), definition);
                        }
                    }
                    Some("fibre") if self.allowed(Member::Fibre, "fibre", span) => {
                        if self.declare(members, name) {
                            members.fibre.push((name.clone(), *value));
                        }
                    }
                    Some("vary") if self.allowed(Member::Vary, "vary", span) => {
                        let parts: Vec<&str> = key.parts.iter().map(|part| part.text.as_str()).collect();
                        let span = name.span.start..key.parts[key.parts.len() - 1].span.end;
                        let path = Name { text: parts.join("."), span };
                        if self.declare(members, &path) {
                            members.varied.push(VaryEntry { path, value: *value });
                        }
                    }
                    Some("let" | "fibre" | "vary") => {}
                    Some(other) => {
                        let span = keyword.as_ref().map_or(span.clone(), |keyword| keyword.span.clone());
                        self.unknown(other, &span, other);
                    }
                }
            }
        }
    }

    fn assign(&mut self, members: &mut Members, name: &Name, value: ExprId) {
        let free = self.declaration.allows(Member::Columns) || self.declaration.allows(Member::Directions);
        if self.declaration.key(&name.text).is_some() {
            if self.declare(members, name) {
                members.keys.insert(name.text.clone(), Site { file: Rc::clone(self.file), id: value });
            }
        } else if free {
            if self.declare(members, name) {
                members.free.push((name.clone(), value));
            }
        } else {
            members.meant.extend(self.unknown(&name.text, &name.span, &name.text));
        }
    }

    fn declare(&mut self, members: &mut Members, name: &Name) -> bool {
        if let Some(first) = members.declared.get(&name.text) {
            duplicate(self.mistakes, self.file, name, first);
            return false;
        }
        members.declared.insert(name.text.clone(), name.clone());
        true
    }

    fn allowed(&mut self, member: Member, word: &str, span: &Span) -> bool {
        let allowed = self.declaration.allows(member);
        if !allowed {
            let message = format!("`{word}` cannot stand in `{}`", self.declaration.word);
            self.mistakes.report(self.file, Code::UnknownKey, span.clone(), message, "", None);
        }
        allowed
    }

    /// Reports a key that is not declared; the one it most likely means.
    fn unknown(&mut self, written: &str, span: &Span, key: &str) -> Option<&'static str> {
        let keys: Vec<&'static str> = self.declaration.keys.iter().map(|key| key.name).collect();
        let message = format!("`{}` has no key `{written}`", self.declaration.word);
        let meant = nearest(key, keys.iter().copied());
        let meant = meant.and_then(|meant| keys.iter().copied().find(|key| *key == meant));
        let help = match meant {
            Some(meant) => Some(format!("write `{meant}`")),
            None if keys.is_empty() => None,
            None => Some(format!("its keys are {}", keys.join(", "))),
        };
        self.mistakes.report(self.file, Code::UnknownKey, span.clone(), message, "", help);
        meant
    }
}

/// Reports a name that is declared a second time in the same file.
pub(in crate::scene) fn duplicate(mistakes: &mut Mistakes, file: &File, second: &Name, first: &Name) {
    let message = format!("`{}` is declared twice", second.text);
    let diagnostic = Diagnostic::new(Code::DuplicateName, message, second.span.clone(), "here again")
        .with_label(first.span.clone(), "first declared here");
    mistakes.push(file, diagnostic);
}
