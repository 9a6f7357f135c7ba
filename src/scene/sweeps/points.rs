//! The points of a sweep, each described by resolving the file with its values in place.
//!
//! Owns the mistakes that only a value brings about: they are told where they lie, with the values
//! that brought them about.

use super::super::file::{File, Mistake, Reported};
use super::super::members::{Overrides, ambiguous};
use super::super::model::{SweepPoint, Swept};
use super::super::session::Session;
use super::super::words::DRIVE;
use super::super::{drives, scenes};
use super::Setting;
use super::vary::Entry;
use crate::syntax::{Code, Item};
use std::rc::Rc;

/// Describes every combination of the values, the first path slowest.
pub(super) fn describe(
    session: &mut Session,
    file: &Rc<File>,
    of: &str,
    entries: &[Entry],
    setting: &Setting<'_>,
) -> Result<Vec<SweepPoint>, Reported> {
    let mut points: Vec<SweepPoint> = Vec::new();
    for at in combinations(entries) {
        let swept = point(session, file, of, entries, &at, setting)?;
        points.push(SweepPoint { at, swept });
    }
    for (index, entry) in entries.iter().enumerate() {
        // Two points that differ in this value alone.
        let other = points.iter().find(|point| {
            point.at[index] == 1 && point.at.iter().enumerate().all(|(i, n)| i == index || *n == 0)
        });
        if other.is_some_and(|other| other.swept == points[0].swept) {
            let message = format!("`{}` changes nothing in `{of}`", entry.path.text);
            let span = entry.path.span.clone();
            let help = Some(format!("vary what `{of}` uses: its material, its bodies, its `run`"));
            return Err(session.mistakes.report(file, Code::NoEffect, span, message, "no effect", help));
        }
    }
    Ok(points)
}

/// Indices of every combination.
fn combinations(entries: &[Entry]) -> Vec<Vec<usize>> {
    entries.iter().fold(vec![Vec::new()], |done, entry| {
        let longer = |at: Vec<usize>| {
            (0..entry.sites.len()).map(move |index| at.iter().copied().chain([index]).collect())
        };
        done.into_iter().flat_map(longer).collect()
    })
}

fn point(
    session: &mut Session,
    file: &Rc<File>,
    of: &str,
    entries: &[Entry],
    at: &[usize],
    setting: &Setting<'_>,
) -> Result<Swept, Reported> {
    let mut inner = session.again(setting.loader, setting.overrides);
    for (entry, index) in entries.iter().zip(at) {
        inner.overrides.insert(&entry.path, entry.sites[*index].clone());
    }
    let module = inner.module(file);
    let block = file.tree.items.iter().find_map(|item| match item {
        Item::Block(block) => {
            let path = block.target.as_ref()?;
            let [name] = path.parts.as_slice() else { return None };
            let runs = matches!(block.kind.text.as_str(), "scene" | "drive");
            (runs && name.text == of).then_some((block, name))
        }
        Item::Import(_) => None,
    });
    let (block, name) = block.ok_or(Reported)?;
    let swept = if block.kind.text == DRIVE.word {
        drives::read(&mut inner, file, block, name, &module).map(|drive| Swept::Drive(Box::new(drive)))
    } else {
        scenes::read(&mut inner, file, block, name, &module).map(|scene| Swept::Scene(Box::new(scene)))
    };
    refuse_unused(session, file, of, entries, &inner.overrides)?;
    let values: Vec<String> = entries
        .iter()
        .zip(at)
        .map(|(entry, index)| format!("{} = {}", entry.path.text, entry.varied.values[*index].text))
        .collect();
    let found = inner.mistakes.finish(file);
    if found.is_empty() {
        return swept;
    }
    let of_value = |mistake: &Mistake| {
        let label = mistake.diagnostic.labels.first();
        let sites = || entries.iter().flat_map(|entry| &entry.sites);
        mistake.source.name == file.source.name
            && label.is_some_and(|l| sites().any(|s| file.span(s.id).contains(&l.span.start)))
    };
    // What is wrong whatever the values are has been told.
    let new: Vec<Mistake> = found.into_iter().filter(|mistake| !session.mistakes.has(mistake)).collect();
    session.mistakes.extend(new.into_iter().map(|mut mistake| {
        if !of_value(&mistake) {
            mistake.diagnostic.message.push_str(&format!(", with {}", values.join(", ")));
        }
        mistake
    }));
    Err(Reported)
}

/// Refuses paths that lead nowhere.
fn refuse_unused(
    session: &mut Session,
    file: &Rc<File>,
    of: &str,
    entries: &[Entry],
    overrides: &Overrides,
) -> Result<(), Reported> {
    let mut sound = Ok(());
    for entry in entries {
        if let Some(meant) = overrides.several(&entry.path.text) {
            let (message, help) = ambiguous(&entry.path.text, &meant);
            let span = entry.path.span.clone();
            sound = Err(session.mistakes.report(file, Code::WrongForm, span, message, "", Some(help)));
        } else if let Some(meant) = overrides.unused(&entry.path.text) {
            let message = format!("nothing in `{of}` is called `{}`", entry.path.text);
            let help = meant.map(|meant| format!("write `{meant}`"));
            let span = entry.path.span.clone();
            sound =
                Err(session.mistakes.report(file, Code::UnknownOverride, span, message, "not used", help));
        }
    }
    sound
}
