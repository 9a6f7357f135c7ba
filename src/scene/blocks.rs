//! Blocks that cannot stand where they stand.

use super::file::{File, Mistakes};
use super::words::vocabulary;
use crate::schema::{Target, nearest};
use crate::syntax::{Block, Code, Name};

/// Reports a block that is unknown here, stands in the wrong place, or is not carried out yet.
pub(super) fn unknown_block(mistakes: &mut Mistakes, file: &File, block: &Block, within: Option<&str>) {
    let word = &block.kind.text;
    let span = block.kind.span.clone();
    let place = within.map_or("at the top of a file".to_string(), |outer| format!("in `{outer}`"));
    if vocabulary().block(word, within).is_some_and(|known| !known.available) {
        let message = format!("`{word}` is not yet available in this version");
        mistakes.report(file, Code::NotAvailable, span, message, "not carried out", None);
        return;
    }
    let before = file.text(&(0..span.start)).trim_end_matches([' ', '\t']);
    let last = before.rsplit([' ', '\t', '\n']).next().unwrap_or_default();
    if block.target.is_none() && vocabulary().blocks.iter().any(|known| known.word == last) {
        let message = format!("`{last}` before `{word}` was read as the unit of a number");
        let help = format!("start `{last} {word}` on a line of its own");
        mistakes.report(file, Code::UnknownBlock, span, message, "", Some(help));
        return;
    }
    let elsewhere = vocabulary().blocks.iter().find(|known| known.word == word);
    let message = format!("there is no block `{word}` {place}");
    let help = match elsewhere {
        Some(known) => match known.within {
            Some(outer) => format!("`{word}` stands in a `{outer}`"),
            None => format!("`{word}` stands at the top of a file"),
        },
        None => match nearest(word, vocabulary().kinds(within)) {
            Some(meant) => format!("write `{meant}`"),
            None => format!("the blocks {place} are {}", vocabulary().kinds(within).join(", ")),
        },
    };
    mistakes.report(file, Code::UnknownBlock, span, message, "", Some(help));
}

/// The new name a block declares.
pub(super) fn block_name(mistakes: &mut Mistakes, file: &File, block: &Block) -> Option<Name> {
    match block.target.as_ref().map(|path| path.parts.as_slice()) {
        Some([name]) => Some(name.clone()),
        Some([first, ..]) => {
            let message = format!("the name of a `{}` has no dots", block.kind.text);
            mistakes.report(file, Code::WrongForm, first.span.clone(), message, "", None);
            None
        }
        _ => {
            let message = format!("`{}` needs a name", block.kind.text);
            let help = format!("write `{} name {{ … }}`", block.kind.text);
            mistakes.report(file, Code::WrongForm, block.kind.span.clone(), message, "", Some(help));
            None
        }
    }
}

/// Reports a target where the block takes none.
pub(super) fn refuse_target(mistakes: &mut Mistakes, file: &File, block: &Block, target: Target) {
    if let (Target::Absent, Some(path)) = (target, &block.target) {
        let message = format!("`{}` takes no name", block.kind.text);
        mistakes.report(file, Code::WrongForm, path.parts[0].span.clone(), message, "", None);
    }
}
