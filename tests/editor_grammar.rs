//! The TextMate grammar of `docs/editors` knows every word of the language's grammar and every dimension.

use serde_json::Value;
use tissue::unit::known_dimensions;

const TEXTMATE: &str = include_str!("../docs/editors/tissue.tmLanguage.json");
const PEST: &str = include_str!("../grammar/tissue.pest");

fn rule(name: &str) -> String {
    let grammar: Value = serde_json::from_str(TEXTMATE).expect("the grammar is JSON");
    grammar["repository"][name]["match"].as_str().unwrap_or_default().to_string()
}

/// The alternatives of the first group `(?:a|b|c)` of a pattern.
fn alternatives(pattern: &str) -> Vec<&str> {
    let inner = pattern.split_once("(?:").map_or("", |(_, rest)| rest);
    inner.split_once(')').map_or("", |(words, _)| words).split('|').collect()
}

/// The words in quotes of every rule of the language that is a word.
fn words() -> Vec<&'static str> {
    let is_word = |line: &&str| line.contains("_word ") || line.starts_with("infix");
    let definitions = PEST.lines().filter(|line| line.contains("~ !name_rest }")).filter(is_word);
    definitions.flat_map(|line| line.split('"').skip(1).step_by(2)).collect()
}

#[test]
fn every_word_of_the_language_is_coloured_as_one() {
    let pattern = rule("word");
    let known = alternatives(&pattern);
    let words = words();
    assert!(words.len() >= 12, "the words are found: {words:?}");
    for word in words {
        assert!(known.contains(&word), "{word}");
    }
}

#[test]
fn every_dimension_is_coloured_as_one_and_nothing_else_is() {
    let pattern = rule("dimension");
    let known = alternatives(&pattern);
    let names: Vec<&str> = known_dimensions()
        .iter()
        .flat_map(|k| [k.name].into_iter().chain(k.aliases.iter().copied()))
        .collect();
    for name in &names {
        assert!(known.contains(name), "{name}");
    }
    assert_eq!(known.len(), names.len());
}

#[test]
fn every_rule_included_is_there_and_every_rule_there_is_included() {
    let grammar: Value = serde_json::from_str(TEXTMATE).expect("the grammar is JSON");
    let mut included: Vec<String> = grammar["patterns"]
        .as_array()
        .expect("patterns are a list")
        .iter()
        .filter_map(|p| p["include"].as_str()?.strip_prefix('#').map(Into::into))
        .collect();
    let mut there: Vec<String> =
        grammar["repository"].as_object().expect("an object").keys().cloned().collect();
    included.sort();
    there.sort();
    assert_eq!(included, there);
}
