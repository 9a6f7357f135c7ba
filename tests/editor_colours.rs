//! The TextMate grammar of `docs/editors` colours every specification as the parser reads it.
//!
//! The grammar is applied as an editor does, line by line, the earliest match first; every word is then
//! held against the syntax tree.

#[path = "fixtures/regex.rs"]
mod regex;

use regex::Regex;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use tissue::scene::vocabulary;
use tissue::syntax::{Block, Entry, ExprKind, Item, Source, Span, parse};

/// A rule: its pattern, the name of the whole match, names of the captures.
struct Rule {
    text: String,
    pattern: Regex,
    name: Option<String>,
    captures: Vec<(usize, String)>,
}

fn rules() -> Vec<Rule> {
    let text = include_str!("../docs/editors/tissue.tmLanguage.json");
    let grammar: Value = serde_json::from_str(text).expect("the grammar is JSON");
    let patterns = grammar["patterns"].as_array().expect("patterns are a list");
    let rule = |include: &Value| {
        let key = include["include"].as_str().and_then(|name| name.strip_prefix('#')).expect("an include");
        let rule = &grammar["repository"][key];
        let text = rule["match"].as_str().expect("a pattern").to_string();
        let pattern = Regex::new(&text);
        let captures = rule["captures"].as_object().into_iter().flatten();
        let captures = captures.map(|(number, capture)| {
            (number.parse().expect("a number"), capture["name"].as_str().expect("a name").to_string())
        });
        Rule { text, pattern, name: rule["name"].as_str().map(String::from), captures: captures.collect() }
    };
    patterns.iter().map(rule).collect()
}

/// Spans of the text and their colours.
fn colour(rules: &[Rule], text: &str) -> Vec<(Span, String)> {
    let mut colours = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let bare = line.trim_end_matches('\n');
        let mut at = 0;
        while at < bare.len() {
            let found = rules.iter().filter_map(|rule| {
                let captures = rule.pattern.find(bare, at)?;
                let (from, to) = captures[0]?;
                (to > from).then_some((from, rule, captures))
            });
            let Some((_, rule, captures)) = found.min_by_key(|(start, ..)| *start) else { break };
            let named = rule.name.iter().map(|name| (0, name));
            for (number, name) in named.chain(rule.captures.iter().map(|(number, name)| (*number, name))) {
                if let Some((from, to)) = captures[number] {
                    colours.push((start + from..start + to, name.clone()));
                }
            }
            at = captures[0].map_or(bare.len(), |(_, to)| to);
        }
        start += line.len();
    }
    colours
}

/// What the colours of a text are held against.
struct Coloured<'a> {
    source: &'a Source,
    colours: Vec<(Span, String)>,
    checked: usize,
}

impl Coloured<'_> {
    /// The colour at a place is one of these.
    fn starts(&mut self, at: usize, allowed: &[&str]) {
        let found = self.colours.iter().find(|(span, _)| span.contains(&at)).map(|(_, name)| name.as_str());
        let line = self.source.text[..at].matches('\n').count() + 1;
        let fits = found.is_some_and(|found| allowed.iter().any(|name| found.starts_with(name)));
        assert!(fits, "{}:{line}: {found:?} where {allowed:?} is meant", self.source.name);
        self.checked += 1;
    }

    fn block(&mut self, block: &Block) {
        let last = block
            .target
            .as_ref()
            .and_then(|path| path.parts.last())
            .map_or(block.kind.span.end, |p| p.span.end);
        if self.source.text[last..].trim_start_matches([' ', '\t']).starts_with('{') {
            self.starts(block.kind.span.start, &["storage.type.block"]);
        }
        for entry in &block.entries {
            match entry {
                Entry::Block(inner) => self.block(inner),
                Entry::Assign { keyword, key, arguments, .. } => {
                    if let Some(keyword) = keyword {
                        self.starts(keyword.span.start, &["keyword.control"]);
                    }
                    let name = if arguments.is_empty() {
                        "variable.other.assignment"
                    } else {
                        "entity.name.function"
                    };
                    self.starts(key.parts[0].span.start, &[name]);
                }
                Entry::Parameter { span, .. } | Entry::Expect { span, .. } => {
                    self.starts(span.start, &["keyword.control"]);
                }
                Entry::Declare { keyword, .. } => self.starts(keyword.span.start, &["keyword.control"]),
            }
        }
    }
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for path in fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "tissue") {
            found.push(path);
        }
    }
}

#[test]
fn every_specification_is_coloured_as_it_is_read() {
    let rules = rules();
    let mut found = Vec::new();
    files(Path::new("specs"), &mut found);
    files(Path::new("tests/scenes"), &mut found);
    let mut checked = 0;
    for path in &found {
        let text = fs::read_to_string(path).expect("a specification is readable");
        let source = Source { name: path.display().to_string(), text };
        let (tree, mistakes) = parse(&source);
        assert!(mistakes.is_empty());
        let mut coloured = Coloured { source: &source, colours: colour(&rules, &source.text), checked: 0 };
        for item in &tree.items {
            match item {
                Item::Block(block) => coloured.block(block),
                Item::Import(import) => {
                    for name in &import.names {
                        coloured.starts(name.span.start, &["variable.other"]);
                    }
                }
            }
        }
        for expression in &tree.expressions {
            // A value in parentheses starts with them.
            let written = &source.text[expression.span.clone()];
            let start = expression.span.end - written.trim_start_matches(['(', ' ']).len();
            match &expression.kind {
                ExprKind::Number { unit, .. } => {
                    coloured.starts(start, &["constant.numeric"]);
                    let units = |name: &str| name.starts_with("keyword.other.unit");
                    let within = coloured.colours.iter().find(|(span, name)| {
                        units(name) && span.start >= start && span.start < expression.span.end
                    });
                    let written = unit.as_ref().map(|unit| unit.span.clone());
                    assert_eq!(
                        within.map(|(span, _)| span.clone()),
                        written,
                        "{}",
                        &source.text[expression.span.clone()]
                    );
                }
                ExprKind::Text(_) => coloured.starts(start, &["string"]),
                ExprKind::Call { .. } => {
                    coloured.starts(start, &["entity.name.function", "support.variable.invariant"]);
                }
                // `sum(a in fibres, …)`: a word of the language in the place of a name.
                ExprKind::Name(word) if word == "fibres" => coloured.starts(start, &["keyword.control"]),
                ExprKind::Name(_) => {
                    coloured.starts(start, &["variable.other", "support.variable", "support.type"]);
                }
                _ => {}
            }
        }
        for (at, _) in source.text.match_indices('#') {
            let line = source.text[..at].rsplit('\n').next().unwrap_or("");
            if line.matches('"').count().is_multiple_of(2) {
                coloured.starts(at, &["comment"]);
            }
        }
        checked += coloured.checked;
    }
    assert!(found.len() > 60 && checked > 5_000, "{} files, {checked} words", found.len());
}

#[test]
fn every_invariant_and_every_block_is_coloured_as_one() {
    let rules = rules();
    let words = vocabulary().all_words().filter(|word| word.context == "in `energy`");
    for word in words.filter(|word| !word.form.contains('(') && !word.form.contains(' ')) {
        let colours = colour(&rules, word.word);
        assert!(colours[0].1.starts_with("support.variable"), "{}", word.word);
    }
    for block in vocabulary().blocks {
        let colours = colour(&rules, &format!("{} name {{", block.word));
        assert!(colours[0].1.starts_with("storage.type.block"), "{}", block.word);
    }
}

#[test]
fn a_wrong_colour_would_be_noticed() {
    let rules: Vec<Rule> = rules().into_iter().filter(|rule| !rule.text.contains("vary|expect")).collect();
    let colours = colour(&rules, "expect a < b");
    assert!(!colours[0].1.starts_with("keyword.control"));
}
