//! The language reference, written from the declarations.

use super::explain::{kind_text, presence_text};
use super::{Choice, Declaration, Kind, Target, Vocabulary, Word};

/// The reference of a vocabulary as Markdown: every block with its keys, then every word by context.
pub fn reference(vocabulary: &Vocabulary) -> String {
    let mut text = String::from(
        "# Language reference\n\nWritten from the declarations that check a file; `tissue explain WORD` prints the same.\n",
    );
    text.push_str("\n## Blocks\n");
    for block in vocabulary.blocks {
        text.push_str(&block_text(block));
    }
    text.push_str("\n## Words\n");
    let mut contexts: Vec<&str> = Vec::new();
    for word in vocabulary.all_words() {
        if !contexts.contains(&word.context) {
            contexts.push(word.context);
        }
    }
    for context in contexts {
        text.push_str(&format!("\n### {context}\n\n| word | meaning |\n|---|---|\n"));
        for Word { form, doc, .. } in vocabulary.all_words().filter(|word| word.context == context) {
            text.push_str(&format!("| `{}` | {} |\n", cell(form), cell(doc)));
        }
    }
    text
}

fn block_text(block: &Declaration) -> String {
    let target = match block.target {
        Target::Absent => "",
        Target::Name => " name",
        Target::Material => " material",
        Target::Body => " body",
        Target::Face => " body.face",
    };
    let place = block.within.map_or("At the top of a file.".into(), |outer| format!("In `{outer}`."));
    let mut text = format!("\n### `{}{target}`\n\n{} {place}\n", block.word, block.doc);
    if !block.available {
        text.push_str("\nRead, but not yet carried out by this version.\n");
    }
    if !block.keys.is_empty() {
        text.push_str("\n| key | value | without it | meaning |\n|---|---|---|---|\n");
    }
    for key in block.keys {
        let value = cell(&kind_text(key.kind));
        let absent = cell(&presence_text(key.presence));
        text.push_str(&format!("| `{}` | {value} | {absent} | {} |\n", key.name, cell(key.doc)));
    }
    for key in block.keys {
        if let Kind::Choice(choices) | Kind::Choices(choices) = key.kind {
            text.push_str(&format!("\nChoices of `{}`:\n\n", key.name));
            for Choice { word, doc } in choices {
                text.push_str(&format!("- `{word}`: {doc}\n"));
            }
        }
    }
    if !block.example.is_empty() {
        text.push_str(&format!("\n```tissue\n{}\n```\n", block.example));
    }
    text
}

/// A text that can stand in a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}
