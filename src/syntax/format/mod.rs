//! The formatter: one way to space, indent and align a file.
//!
//! Owns blanks only: tokens, comments and line breaks stay as written. Blanks around `*` and `/` are the
//! author's, all others are given; entries that follow each other line by line are aligned.

mod atoms;
mod layout;

use super::diagnostic::Diagnostic;
use super::encoding::line_ends;
use super::parse::parse;
use super::tree::Source;

/// The text of a file in the one form, ended by a line feed.
///
/// Formatting again changes nothing; the tree is that of the source but for spans.
///
/// # Errors
/// Every mistake of form; a file with mistakes is not formatted.
pub fn format(source: &Source) -> Result<String, Vec<Diagnostic>> {
    let (tree, mistakes) = parse(source);
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    Ok(layout::layout(&atoms::Atoms::new(&line_ends(&source.text), &tree)))
}

#[cfg(test)]
mod tests;
