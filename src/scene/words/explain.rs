//! What `tissue explain` knows: words of the language, the standard library, units, dimensions, codes.

use super::super::library::{LibraryFile, library};
use super::{BLOCKS, VOCABULARY};
use crate::schema;
use crate::unit::{known_dimensions, parse_unit, unit_symbols};

/// The page of every diagnostic, by its code.
static PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// What a word means: a block, a key (`run.cfl`), a choice, a function; an energy or material of the library; a
/// unit or dimension; the code of a mistake. A word with several meanings gets all of them, `None` if it has none.
pub fn explain(word: &str) -> Option<String> {
    // `goh.kappa` is shown where it is declared
    let owner = |file: &LibraryFile| {
        word.split_once('.')
            .is_some_and(|(name, key)| name == file.name && file.text.contains(&format!("param {key}")))
    };
    let named = library().iter().filter(|file| file.name == word || written(file) == word || owner(file));
    let parts = schema::explain(&VOCABULARY, word).into_iter();
    let parts = parts.chain(named.map(shown)).chain(unit(word)).chain(dimension(word)).chain(page(word));
    let parts: Vec<String> = parts.collect();
    (!parts.is_empty()).then(|| parts.join("\n"))
}

/// The word nearest to one that means nothing.
pub fn nearest_word(word: &str) -> Option<&'static str> {
    let blocks = BLOCKS.iter().map(|block| block.word);
    let keys = BLOCKS.iter().flat_map(|block| block.keys.iter().map(|key| key.name));
    let words = VOCABULARY.all_words().map(|entry| entry.word);
    let files = library().iter().map(|file| file.name);
    let dimensions = known_dimensions().iter().map(|known| known.name);
    let units = unit_symbols().iter().copied();
    let codes = PAGES.iter().map(|(code, _)| *code);
    let all: Vec<&'static str> =
        blocks.chain(keys).chain(words).chain(files).chain(dimensions).chain(units).chain(codes).collect();
    let meant = schema::nearest(word, all.iter().copied())?;
    all.into_iter().find(|known| *known == meant)
}

fn written(file: &LibraryFile) -> String {
    format!("std.{}.{}", file.library, file.name)
}

/// A file of the library with the line that imports it.
fn shown(file: &LibraryFile) -> String {
    let kind = if file.library == "energies" { "energy" } else { "material" };
    let text: String = file.text.lines().skip(1).map(|line| format!("  {line}\n")).collect();
    let text = text.trim_start_matches([' ', '\n']).trim_end();
    format!(
        "{} ({kind} of the standard library)\n  import std.{} {{ {} }}\n\n  {text}\n",
        file.name, file.library, file.name
    )
}

fn unit(word: &str) -> Option<String> {
    let unit = parse_unit(word).ok()?;
    let (is, si) = (unit.dimension.describe(), unit.dimension.si_symbol());
    let si = if si.is_empty() { String::new() } else { format!(" {si}") };
    Some(format!("{word} (unit)\n  {is}: 1 {word} = {}{si}\n", unit.factor()))
}

fn dimension(word: &str) -> Option<String> {
    let known = known_dimensions().iter().find(|known| known.name == word)?;
    let (name, units) = (known.name, known.dimension);
    let units = units.suggested_units().join(", ");
    let units = if units.is_empty() { String::new() } else { format!("; units such as {units}") };
    Some(format!("{name} (dimension)\n  `param x : {name}`{units}\n"))
}

/// The page of a code, as it is written.
fn page(word: &str) -> Option<String> {
    let code = word.to_uppercase();
    PAGES.iter().find(|(known, _)| *known == code).map(|(_, page)| (*page).to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Code;

    #[test]
    fn units_dimensions_codes_and_the_library_are_explained() {
        for code in Code::ALL {
            assert!(explain(code.number()).is_some_and(|text| text.contains(code.title())), "{code}");
        }
        for file in library() {
            assert!(explain(file.name).is_some_and(|text| text.contains("import std.")), "{}", file.name);
        }
        for symbol in unit_symbols() {
            assert!(explain(symbol).is_some_and(|text| text.contains("(unit)")), "{symbol}");
        }
        for known in known_dimensions() {
            assert!(explain(known.name).is_some_and(|text| text.contains("(dimension)")), "{}", known.name);
        }
        let kilopascal = explain("kPa").expect("a unit");
        assert!(kilopascal.contains("1 kPa = 1000 Pa"), "{kilopascal}");
        assert!(explain("goh.kappa").is_some_and(|text| text.contains("energy goh")));
        assert!(explain("e0304").is_some() && explain("std.energies.goh").is_some());
    }

    #[test]
    fn a_near_miss_of_any_kind_is_guessed() {
        let guesses = [
            ("neo_hoke", "neo_hooke"),
            ("tractoin", "traction"),
            ("presure", "pressure"),
            ("E0340", "E0304"),
        ];
        for (word, meant) in guesses {
            assert_eq!(nearest_word(word), Some(meant));
        }
        assert_eq!(explain("no_such_word"), None);
    }
}
