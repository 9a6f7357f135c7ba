//! Nothing a file can hold makes reading panic, hang or overflow the stack; files the grammar can
//! generate are read without a mistake.
//!
//! `TISSUE_INPUTS=1000000 cargo test --release --test syntax_robust many -- --ignored` is the long run.

#[path = "support/random.rs"]
mod random;

use proptest::prelude::*;
use random::Random;
use std::time::{Duration, Instant};
use tissue::syntax::{Diagnostic, Source, SyntaxTree, decode, format as formatted, parse, parse_expression};

const SPECS: [&str; 5] = [
    include_str!("../specs/artery/axial.tissue"),
    include_str!("../specs/energies/goh.tissue"),
    include_str!("../specs/energies/neo_hooke.tissue"),
    include_str!("../specs/energies/vol_ogden2.tissue"),
    "tissue 1\nsweep s { vary a.b = [1 m/8, 2 m]  plot = log_log }\ndrive d { path = f(a, 0 .. 0.5)\n hold x.y }\n",
];

/// Names of grammar rules that must never reach a user.
const RULES: [&str; 8] =
    ["open_brace", "close_paren", "binding", "next_entry", "sum_operator", "unit_power", "EOI", "Rule::"];

const TOKENS: [&str; 70] = [
    "tissue",
    "1",
    "import",
    "std.energies",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    ",",
    ":",
    "=",
    "==",
    "!=",
    "<",
    "<=",
    ">",
    ">=",
    "->",
    "..",
    ".",
    "+",
    "-",
    "*",
    "/",
    "^",
    "%",
    "·",
    "over",
    "in",
    "within",
    "at",
    "let",
    "param",
    "expect",
    "fibre",
    "fibres",
    "direction",
    "vary",
    "hold",
    "a",
    "strip.xmax",
    "λ₁",
    "µm",
    "kPa",
    "kg/m^3",
    "m",
    "1e-7",
    "0.226",
    "1e999",
    "2 m",
    "\"a.csv\"",
    "\"",
    "#",
    "# note\n",
    "\n",
    "\n\n",
    " ",
    "\t",
    "\r\n",
    "\u{feff}",
    "²",
    "×",
    "“",
    "\u{0}",
    "漢",
    "\u{301}",
    ";",
    "!",
];

fn soup(random: &mut Random) -> String {
    let mut text = String::from(if random.below(4) == 0 { "" } else { "tissue 1\n" });
    for _ in 0..random.below(60) {
        text.push_str(random.pick(&TOKENS));
        if random.below(3) > 0 {
            text.push(' ');
        }
    }
    text
}

fn bytes(random: &mut Random) -> String {
    let raw: Vec<u8> = (0..random.below(120)).map(|_| (random.next() & 0xff) as u8).collect();
    match decode("bytes", raw.clone()) {
        Ok(source) => source.text,
        Err(_) => format!("tissue 1\n{}", String::from_utf8_lossy(&raw)),
    }
}

/// A specification with some characters removed, doubled, moved or replaced.
fn mutated(random: &mut Random) -> String {
    let mut text: Vec<char> = random.pick(&SPECS).chars().collect();
    for _ in 0..=random.below(6) {
        let length = text.len();
        let longest = if random.below(4) == 0 { 60 } else { 4 };
        let (at, span) = (random.below(length), random.below(longest) + 1);
        let end = (at + span).min(length);
        match random.below(4) {
            0 => drop(text.drain(at..end)),
            1 => {
                let copy = text[at..end].to_vec();
                let to = random.below(length);
                text.splice(to..to, copy);
            }
            2 => drop(text.splice(at..end, random.pick(&TOKENS).chars())),
            _ => drop(text.splice(at..at, random.pick(&TOKENS).chars())),
        }
    }
    text.into_iter().collect()
}

fn name(random: &mut Random) -> String {
    random.pick(&["a", "kappa", "λ", "x_1", "I1bar", "f0", "E", "displacement", "µ", "J"]).into()
}

fn path(random: &mut Random) -> String {
    let parts: Vec<String> = (0..=random.below(2)).map(|_| name(random)).collect();
    parts.join(".")
}

fn blank(random: &mut Random) -> &'static str {
    random.pick(&["", " ", "  ", "\t", "\n", "\r\n", " # note = {\n"])
}

fn operand(random: &mut Random, depth: usize) -> String {
    let sub = |random: &mut Random| generated_expression(random, depth - 1);
    let text = match random.below(if depth == 0 { 4 } else { 9 }) {
        0 => random.pick(&["1", "0.5", "1e-7", "250"]).to_string(),
        1 => random.pick(&["1 kPa", "2 m^2", "0.5 %", "3 kg/m^3", "1e-7 Pa^-1", "4\tdeg"]).to_string(),
        2 => name(random),
        3 => random.pick(&["\"a.csv\"", "\"# {\"", "\"\""]).to_string(),
        4 => format!("({}{}{})", blank(random), sub(random), blank(random)),
        5 => format!("[{},{}{}]", sub(random), blank(random), sub(random)),
        6 => format!("{}({}, {} = {})", name(random), sub(random), path(random), sub(random)),
        7 => format!("sum({} in {}, {})", name(random), sub(random), sub(random)),
        _ => format!("{}.{}[{}]", name(random), name(random), sub(random)),
    };
    format!("{}{text}", random.pick(&["", "", "", "-", "+", "--"]))
}

fn generated_expression(random: &mut Random, depth: usize) -> String {
    let mut text = operand(random, depth);
    for _ in 0..random.below(3) {
        let operator =
            random.pick(&["+", "-", "*", "/", "^", "..", "->", "==", "!=", "<", "<=", ">", ">=", "over"]);
        text.push_str(&format!(" {operator} {}", operand(random, depth)));
    }
    text
}

fn generated_entry(random: &mut Random, depth: usize) -> String {
    let value = |random: &mut Random| generated_expression(random, 2);
    match random.below(if depth == 0 { 8 } else { 9 }) {
        0 => format!("let {}({}, b) = {}", name(random), name(random), value(random)),
        1 => format!(
            "{} {} = {}",
            random.pick(&["let", "fibre", "direction", "vary"]),
            path(random),
            value(random)
        ),
        2 => format!("param {} : pressure in [0, 1/3) = {}", name(random), value(random)),
        3 => format!(
            "param {}[n] : 1/length^2 {} -1 # doc",
            name(random),
            random.pick(&[">", ">=", "<", "<="])
        ),
        4 => format!("{} {}", random.pick(&["fibres", "direction"]), name(random)),
        5 => format!("hold {}", path(random)),
        6 => format!("expect {} within 1 % at {} = {}", value(random), path(random), value(random)),
        7 => format!("{} = {}", name(random), value(random)),
        _ => generated_block(random, depth - 1),
    }
}

fn generated_block(random: &mut Random, depth: usize) -> String {
    let head = if random.below(2) == 0 { name(random) } else { format!("{} {}", name(random), path(random)) };
    // One entry a line: on one line a number takes the next word for its unit.
    let entries: String = (0..random.below(4)).map(|_| generated_entry(random, depth) + "\n").collect();
    format!("{head} {{{}\n{entries}}}\n", blank(random))
}

fn generated(random: &mut Random) -> String {
    let blocks: String = (0..random.below(4)).map(|_| generated_block(random, 3)).collect();
    format!("tissue 1\nimport std.energies {{ goh, ogden }}\n{blocks}")
}

fn read(text: &str) -> (SyntaxTree, Vec<Diagnostic>) {
    let source = Source { name: "x.tissue".into(), text: text.into() };
    let (tree, mistakes) = parse(&source);
    for mistake in &mistakes {
        for label in &mistake.labels {
            assert!(source.text.get(label.span.clone()).is_some(), "{mistake:?} in {text:?}");
        }
        let drawn = mistake.render(&source);
        let leaks = RULES.iter().find(|rule| drawn.contains(**rule) && !text.contains(**rule));
        assert_eq!(leaks, None, "{drawn}");
        mistake.to_json(&source);
    }
    for expression in &tree.expressions {
        assert!(
            source.text.get(expression.span.clone()).is_some_and(|s| s.trim() == s),
            "{expression:?} in {text:?}"
        );
    }
    if text.len() < 10_000 {
        let _ = parse_expression(&source);
    }
    (tree, mistakes)
}

/// Formatting keeps what is written and the shape of the tree, and is its own fixed point.
fn formats_once(source: &Source, tree: &SyntaxTree) {
    let once = formatted(source).expect("a file without mistakes is formatted");
    let ink = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(ink(&once), ink(&source.text));
    let source = Source { name: "formatted".into(), text: once.clone() };
    let (again, mistakes) = parse(&source);
    assert_eq!(mistakes, [], "{once}");
    assert_eq!(formatted(&source).as_ref(), Ok(&once));
    let depths = |tree: &SyntaxTree| tree.expressions.iter().map(|e| e.depth).collect::<Vec<_>>();
    assert_eq!(depths(&again), depths(tree), "{once}");
}

/// Parts of bombs that make many nodes or many attempts.
const HEAVY: [&str; 8] = ["(", "a{", "x+", "a=1 ", "1m*", "f(a=", "a = \n", "a{}"];

fn try_seed(seed: u64) {
    let random = &mut Random(seed);
    match seed % 4 {
        0 => drop(read(&bytes(random))),
        1 => drop(read(&soup(random))),
        2 => drop(read(&mutated(random))),
        _ => {
            let text = generated(random);
            let source = Source { name: "generated".into(), text: text.clone() };
            let (tree, mistakes) = read(&text);
            let told: String = mistakes.iter().map(|m| m.render(&source)).collect();
            assert!(mistakes.is_empty(), "seed {seed}\n{text}\n{told}");
            assert_eq!(tree.version.as_ref().map(|v| v.0), Some(1));
            formats_once(&source, &tree);
        }
    }
}

#[test]
fn no_input_makes_reading_panic() {
    for seed in 0..4_000 {
        try_seed(seed);
    }
}

#[test]
#[ignore = "a million inputs take minutes"]
fn many_inputs_make_no_reading_panic() {
    let inputs = std::env::var("TISSUE_INPUTS").ok().and_then(|n| n.parse().ok()).unwrap_or(100_000);
    for seed in 0..inputs {
        try_seed(0x5eed_0000_0000 + seed);
    }
}

proptest! {
    #[test]
    fn any_text_is_read(text in "\\PC{0,200}") {
        read(&text);
        read(&format!("tissue 1\na {{ b = {text} }}"));
    }
}

#[test]
fn bombs_of_a_megabyte_are_refused_or_read_in_time() {
    let fill = |part: &str, size: usize| part.repeat(size / part.len());
    let bombs: Vec<String> = [
        "(",
        "[",
        "{",
        ")",
        "a{",
        "a=(",
        "-",
        "2^",
        "x+",
        "a ",
        "a\n",
        "a=1 ",
        "a=1\n",
        "a = [",
        "\"",
        "#",
        "\n",
        "²",
        "漢 ",
        "1 ",
        "1m*",
        "f(",
        "f(a=",
        "a.",
        "let ",
        "param a : ",
        "expect ",
        "a over ",
        "in [0,",
        "\u{feff}",
        "a b\n",
        "a{}",
        "a = \n",
        "a = 1 2\n",
        "= ",
        "import ",
        "import a { b }\n",
        "a { b = 1 }\n",
        "/",
        "..",
        "1..",
        "a {\n b = \n}\n",
    ]
    .iter()
    .flat_map(|part| {
        // The largest size for what costs most to read, a tenth of it elsewhere.
        let most = fill(part, if HEAVY.contains(part) { 990_000 } else { 200_000 });
        let some = fill(part, 100_000);
        [
            format!("tissue 1\na {{\n{most}\n}}\n"),
            format!("tissue 1\n{some}"),
            format!("tissue 1\na {{ x = {some}\n}}\n"),
        ]
    })
    .collect();
    for bomb in bombs {
        let start = Instant::now();
        let (_, mistakes) = read(&bomb);
        let (time, shown) = (start.elapsed(), bomb.chars().take(40).collect::<String>());
        assert!(mistakes.len() <= 51, "{shown:?}: {} mistakes", mistakes.len());
        assert!(time < Duration::from_secs(20), "{shown:?} took {time:?}");
    }
    let (_, mistakes) = read(&"a".repeat(1_000_001));
    assert_eq!(mistakes[0].code.number(), "E0103");
}

#[test]
fn an_entry_with_characters_left_out_is_not_in_the_tree_but_its_neighbours_are() {
    let text = "tissue 1\nm a {\n  b = 2 kg/m³\n  c = 3;  d = 4 × 2\n  e = 5 {\n}\n".replace("5 {", "5");
    let (tree, mistakes) = parse(&Source { name: "x".into(), text });
    assert_eq!(mistakes.len(), 3);
    let [tissue::syntax::Item::Block(block)] = tree.items.as_slice() else { panic!("one block") };
    let keys = block.entries.iter().filter_map(|e| match e {
        tissue::syntax::Entry::Assign { key, .. } => Some(key.parts[0].text.as_str()),
        _ => None,
    });
    assert_eq!(keys.collect::<Vec<_>>(), ["c", "e"]);
}
