//! `vary path = [values]`.
//!
//! Owns the form of the values and what a table calls them. Whether the path leads anywhere is seen
//! when the points are described.

use super::super::file::{File, Mistakes, Reported};
use super::super::members::{Members, Site, VaryEntry};
use super::super::model::{Varied, VariedValue};
use super::super::scenes::fixed_quantity;
use super::super::session::Session;
use crate::syntax::{Block, Code, Diagnostic, ExprKind, Name};
use crate::unit::Dimension;
use std::rc::Rc;

/// Most points of a sweep.
const MOST_POINTS: usize = 1000;

/// A path, its values, and where each stands.
pub(super) struct Entry {
    pub(super) path: Name,
    pub(super) sites: Vec<Site>,
    pub(super) varied: Varied,
}

/// Reads every `vary` of a block.
pub(super) fn read(
    session: &mut Session,
    file: &Rc<File>,
    block: &Block,
    name: &Name,
    members: &Members,
) -> Result<Vec<Entry>, Reported> {
    if members.varied.is_empty() {
        let message = format!("`{} {}` varies nothing", block.kind.text, name.text);
        let help = Some(
            "write `vary strip.spacing = [0.5 mm, 0.25 mm]` with the path and the values that are meant"
                .into(),
        );
        let span = block.kind.span.start..name.span.end;
        return Err(session.mistakes.report(file, Code::MissingKey, span, message, "no `vary`", help));
    }
    let entries: Vec<Result<Entry, Reported>> =
        members.varied.iter().map(|entry| one(&mut session.mistakes, file, entry)).collect();
    let mut entries = entries.into_iter().collect::<Result<Vec<_>, _>>()?;
    name_columns(&mut entries);
    let count = entries.iter().fold(1_usize, |n, entry| n.saturating_mul(entry.sites.len()));
    if count > MOST_POINTS {
        let message =
            format!("a sweep has at most {MOST_POINTS} points, but these values combine to {count}");
        let span = name.span.clone();
        return Err(session.mistakes.report(file, Code::TooLarge, span, message, "", None));
    }
    Ok(entries)
}

fn one(mistakes: &mut Mistakes, file: &Rc<File>, entry: &VaryEntry) -> Result<Entry, Reported> {
    let ids = match &file.tree.expr(entry.value).kind {
        ExprKind::List(ids) if ids.len() >= 2 => ids.clone(),
        _ => {
            let message = format!("`vary {}` needs two values or more in brackets", entry.path.text);
            let help = Some(format!("write `vary {} = [first, second]`", entry.path.text));
            let span = file.span(entry.value);
            return Err(mistakes.report(file, Code::WrongForm, span, message, "", help));
        }
    };
    let texts: Vec<String> = ids.iter().map(|id| one_line(file.expression(*id))).collect();
    let known: Vec<Option<(f64, Dimension)>> = ids.iter().map(|id| fixed_quantity(file, *id)).collect();
    let quantities: Option<Vec<(f64, Dimension)>> = known.iter().copied().collect();
    let (values, dimension) = match &quantities {
        Some(quantities) => {
            let dimension = quantities[0].1;
            if let Some(other) = quantities.iter().position(|(_, found)| *found != dimension) {
                let (first, found) = (dimension.describe(), quantities[other].1.describe());
                let message = format!("the values of `{}` are {first} and {found}", entry.path.text);
                let diagnostic =
                    Diagnostic::new(Code::MixedDimensions, message, file.span(ids[other]), found)
                        .with_label(file.span(ids[0]), first);
                return Err(mistakes.push(file, diagnostic));
            }
            (quantities.iter().map(|(value, _)| *value).collect(), dimension)
        }
        None => ((1..=ids.len()).map(|n| n as f64).collect::<Vec<f64>>(), Dimension::NUMBER),
    };
    for (index, text) in texts.iter().enumerate() {
        let same = |other: usize| match &quantities {
            Some(_) => values[other] == values[index],
            None => texts[other] == *text,
        };
        if let Some(first) = (0..index).find(|other| same(*other)) {
            let message = format!("`{}` takes the value `{text}` twice", entry.path.text);
            let diagnostic =
                Diagnostic::new(Code::DuplicateName, message, file.span(ids[index]), "here again")
                    .with_label(file.span(ids[first]), "first here");
            return Err(mistakes.push(file, diagnostic));
        }
    }
    let is_quantity = quantities.is_some();
    let values = values.into_iter().zip(texts).map(|(value, text)| VariedValue { value, text }).collect();
    let varied = Varied {
        path: entry.path.text.clone(),
        column: String::new(),
        unit: dimension.si_symbol(),
        values,
        is_quantity,
    };
    let sites = ids.into_iter().map(|id| Site { file: Rc::clone(file), id }).collect();
    Ok(Entry { path: entry.path.clone(), sites, varied })
}

/// The last word of each path, or all of it where two end alike.
fn name_columns(entries: &mut [Entry]) {
    let last = |path: &str| path.rsplit('.').next().unwrap_or(path).to_string();
    let ends: Vec<String> = entries.iter().map(|entry| last(&entry.varied.path)).collect();
    for entry in entries.iter_mut() {
        let end = last(&entry.varied.path);
        let alone = ends.iter().filter(|other| **other == end).count() == 1;
        entry.varied.column = if alone { end } else { entry.varied.path.replace('.', "_") };
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
