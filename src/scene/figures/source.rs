//! `source`: a scene or drive of another file.

use super::super::blocks::block_name;
use super::super::file::{File, Reported};
use super::super::loader::relative_to;
use super::super::members::{Members, Site, duplicate};
use super::super::model::Source as Described;
use super::super::model::{Drive, Scene};
use super::super::resolve::resolve_runs;
use super::super::scenes::Stage;
use super::super::session::Session;
use super::super::words::SOURCE;
use crate::schema::nearest;
use crate::syntax::{Block, Code, ExprKind, Name, Source};
use crate::unit::{Dimension, parse_unit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A source with what its file says of it.
pub(super) struct Found {
    pub(super) source: Described,
    name: Name,
    run: Run,
}

/// What is run.
enum Run {
    Scene(Box<Scene>),
    Drive(Box<Drive>),
}

/// Reads a source and the file it names.
pub(super) fn read(session: &mut Session, file: &Rc<File>, block: &Block) -> Result<Found, Reported> {
    let name = block_name(&mut session.mistakes, file, block).ok_or(Reported)?;
    let members = Members::read(&mut session.mistakes, file, &SOURCE, block);
    let site = members.required(&mut session.mistakes, file, &SOURCE, block, "file")?;
    let span = file.span(site.id);
    let ExprKind::Text(path) = &file.tree.expr(site.id).kind else {
        let message = "`file` is a text in quotes";
        let help = Some("write `file = \"../artery/axial.tissue\"`".into());
        return Err(session.mistakes.report(file, Code::WrongForm, span, message, "", help));
    };
    let path = relative_to(&file.source.name, path);
    let full = settings(session, &members, "full")?;
    let quick = settings(session, &members, "quick")?;
    let text = session.loader.load(&path).map_err(|error| {
        let message = format!("`{path}` cannot be read: {error}");
        session.mistakes.report(file, Code::FileNotFound, span.clone(), message, "", None)
    })?;
    let source = Source { name: path.clone(), text };
    // the quick tier must be sound as well
    let mut described = Described { name: name.text.clone(), file: path, scene: String::new(), full, quick };
    let (document, mistakes) = resolve_runs(&source, session.loader, &described.full);
    let (_, more) = resolve_runs(&source, session.loader, &described.settings(true));
    if session.mistakes.extend(mistakes) | session.mistakes.extend(more) {
        return Err(Reported);
    }
    let site = members.required(&mut session.mistakes, file, &SOURCE, block, "scene")?;
    let written = file.expression(site.id).to_string();
    let names: Vec<String> = document
        .scenes
        .iter()
        .map(|scene| scene.name.clone())
        .chain(document.drives.iter().map(|drive| drive.name.clone()))
        .collect();
    let scene = document.scenes.into_iter().find(|scene| scene.name == written);
    let drive = document.drives.into_iter().find(|drive| drive.name == written);
    let run = match (scene, drive) {
        (Some(scene), _) => Run::Scene(Box::new(scene)),
        (None, Some(drive)) => Run::Drive(Box::new(drive)),
        (None, None) => {
            let help = match nearest(&written, names.iter().map(String::as_str)) {
                Some(meant) => format!("write `{meant}`"),
                None => format!("it has {}", names.join(", ")),
            };
            let message = format!("`{}` has no scene or drive `{written}`", described.file);
            let span = file.span(site.id);
            return Err(session.mistakes.report(file, Code::UnknownName, span, message, "", Some(help)));
        }
    };
    described.scene = written;
    Ok(Found { source: described, name, run })
}

/// `set(path = value, …)` as texts, as the command line gives them.
fn settings(session: &mut Session, members: &Members, key: &str) -> Result<Vec<(String, String)>, Reported> {
    let Some(Site { file, id }) = members.written(key) else { return Ok(Vec::new()) };
    let pairs = match &file.tree.expr(*id).kind {
        ExprKind::Call { function, arguments } if function.text == "set" => arguments
            .iter()
            .map(|argument| {
                let path = argument.name.as_ref()?;
                let parts: Vec<&str> = path.parts.iter().map(|part| part.text.as_str()).collect();
                Some((parts.join("."), file.expression(argument.value).to_string()))
            })
            .collect(),
        _ => None,
    };
    pairs.ok_or_else(|| {
        let message = format!("`{key}` is `set(…)` with values by path");
        let help = Some(format!("write `{key} = set(strip.spacing = 0.5 mm)`"));
        session.mistakes.report(file, Code::WrongForm, file.span(*id), message, "", help)
    })
}

impl Stage<'_> {
    /// Makes the records, frames and bodies of a source known under its name.
    pub(super) fn declare_source(&mut self, found: &Found) -> Result<(), Reported> {
        let name = &found.source.name;
        if let Some(first) = self.source_names.get(name) {
            duplicate(self.mistakes, &self.file, &found.name, first);
            return Err(Reported);
        }
        self.source_names.insert(name.clone(), found.name.clone());
        // units of columns are written by this program, from dimensions
        let dimension = |unit: &str| {
            if unit.is_empty() {
                Some(Dimension::NUMBER)
            } else {
                parse_unit(unit).ok().map(|unit| unit.dimension)
            }
        };
        match &found.run {
            Run::Scene(scene) => {
                for record in &scene.records {
                    let mut columns = BTreeMap::from([("t".to_string(), Some(Dimension::TIME))]);
                    let units = record.columns.iter();
                    columns.extend(units.map(|column| (column.name.clone(), dimension(&column.unit))));
                    self.columns.insert(format!("{name}.{}", record.name), columns);
                }
                self.sources.insert(name.clone(), Scene::clone(scene));
            }
            Run::Drive(drive) => {
                for record in &drive.records {
                    let mut columns = BTreeMap::from([(drive.parameter.clone(), dimension(&drive.unit))]);
                    let units = record.columns.iter();
                    columns.extend(units.map(|column| (column.name.clone(), dimension(&column.unit))));
                    self.columns.insert(format!("{name}.{}", record.name), columns);
                }
            }
        }
        Ok(())
    }
}
