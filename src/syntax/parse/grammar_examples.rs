//! The examples of every rule of the grammar: `accept|text` and `reject|text` lines, `\n` and `\t` escaped.

use super::grammar::{Grammar, Rule};
use pest::Parser;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Rules without a node: too small for examples of their own.
const LEAVES: [Rule; 6] =
    [Rule::EOI, Rule::WHITESPACE, Rule::COMMENT, Rule::blank, Rule::name_start, Rule::name_rest];

/// Whether a rule takes a whole text.
fn accepts(rule: Rule, text: &str) -> bool {
    Grammar::parse(rule, text).is_ok_and(|pairs| {
        // The nodes reach to where reading ended, but for a lookahead's blanks.
        let end = pairs.last().map_or(0, |pair| pair.as_span().end());
        text[end..].is_empty()
    })
}

#[test]
fn every_rule_takes_what_its_examples_say_and_nothing_else() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("grammar/examples");
    let mut wrong = Vec::new();
    for rule in Rule::all_rules().iter().filter(|rule| !LEAVES.contains(rule)) {
        let file = folder.join(format!("{rule:?}.txt"));
        let examples = fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let mut seen = BTreeSet::new();
        for line in examples.lines() {
            let (verdict, text) = line.split_once('|').unwrap_or_else(|| panic!("{rule:?}: {line}"));
            let text = text.replace("\\n", "\n").replace("\\t", "\t");
            seen.insert(verdict);
            if accepts(*rule, &text) != (verdict == "accept") {
                wrong.push(format!("{rule:?}: should {verdict} {text:?}"));
            }
        }
        assert_eq!(seen, BTreeSet::from(["accept", "reject"]), "{rule:?} has examples of both kinds");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_file_of_examples_is_of_a_rule() {
    let rules: BTreeSet<String> = Rule::all_rules().iter().map(|rule| format!("{rule:?}.txt")).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("grammar/examples");
    for entry in fs::read_dir(folder).expect("the examples are there").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert!(rules.contains(&name), "{name} is of no rule");
    }
}
