//! Inputs of the tests that try anything: files from the declarations, specifications with words changed, bytes.

use super::random::Random;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tissue::scene::{Memory, vocabulary};
use tissue::schema::{Declaration, Kind, Member, Parameter, Presence, Target};
use tissue::syntax::decode;

/// Everything inputs are made from.
pub struct Material {
    pub files: Memory,
    /// Path and text of every specification.
    specs: Vec<(String, String)>,
    /// Words of the language.
    words: Vec<String>,
}

fn walk(folder: &str, endings: &[&str], files: &mut BTreeMap<String, String>) {
    let mut entries: Vec<_> = fs::read_dir(folder).expect("the folder is there").flatten().collect();
    entries.sort_by_key(fs::DirEntry::path);
    for entry in entries {
        let path = entry.path().to_string_lossy().replace('\\', "/");
        if Path::new(&path).is_dir() {
            walk(&path, endings, files);
        } else if endings.iter().any(|ending| path.ends_with(ending)) {
            files.insert(path.clone(), fs::read_to_string(&path).expect("text"));
        }
    }
}

impl Material {
    pub fn new() -> Self {
        let mut files = BTreeMap::new();
        walk("specs", &[".tissue", ".csv"], &mut files);
        walk("verification/references", &[".csv"], &mut files);
        let specs = files.iter().filter(|(path, _)| path.ends_with(".tissue"));
        let specs: Vec<(String, String)> = specs.map(|(path, text)| (path.clone(), text.clone())).collect();
        let mut words: Vec<String> = PIECES.iter().map(|piece| piece.to_string()).collect();
        for block in vocabulary().blocks {
            words.push(block.word.into());
            words.push(format!("{} x {{", block.word));
            words.extend(block.keys.iter().map(|key| format!("{} =", key.name)));
        }
        words.extend(vocabulary().all_words().map(|word| word.form.to_string()));
        Self { files: Memory { files }, specs, words }
    }
}

const PIECES: &[&str] = &[
    "",
    "0",
    "-1",
    "1e308",
    "1e-308",
    "1e999",
    "1 mm",
    "7 kPa",
    "2 s",
    "1e-7 Pa^-1",
    "45 deg",
    "5 %",
    "J",
    "a1",
    "strip",
    "strip.xmin",
    "pull.d",
    "test.P",
    "X",
    "t",
    "[",
    "]",
    "{",
    "}",
    "(",
    ")",
    "+",
    "-",
    "^",
    "/",
    "*",
    "->",
    "..",
    "==",
    "<",
    ">=",
    ",",
    "=",
    ".",
    "over",
    "within",
    "at",
    "in",
    "\"",
    "#",
    "\n",
    "λ",
    "µ",
    "\t",
    "let",
    "param",
    "expect",
    "vary",
    "fibre",
    "[1, 1, 0]",
    "[0.5, 1, 2]",
    "1/0",
    "0^0",
    "(-1)^0.5",
    "1e300^9",
    "let f = f",
    "let f(a) = f(a)",
    "f(f(f(2)))",
    "sum(i in 1 .. 1000000, i)",
    "sum(a in fibres, 1)",
    "box(1 m, 1 m, 1 m)",
    "ramp(0 m -> 1 m, over = 1 s)",
    "unit([0, 0, 0])",
    "if(1 < 2, 3, 4)",
];

const NAMES: &[&str] = &["a", "b", "gel", "strip", "test", "P", "s", "x", "λ"];

fn name(random: &mut Random) -> String {
    random.pick(NAMES).to_string()
}

/// A value of a kind, or anything.
fn value(random: &mut Random, material: &Material, key: &Parameter) -> String {
    if random.below(4) == 0 {
        return material.words[random.below(material.words.len())].clone();
    }
    if let (Presence::Required(example), 1..) = (key.presence, random.below(3)) {
        return example.split_once('=').map_or(String::new(), |(_, value)| value.trim().into());
    }
    match key.kind {
        Kind::Quantity(_) | Kind::Field(_) | Kind::Count => {
            let units = ["", " mm", " s", " kPa", " kg/m^3", " m/s", " deg", " Pa^-1"];
            format!("{}{}", random.pick(&["0", "1", "0.5", "-2", "1e-3", "1e9", "3"]), random.pick(&units))
        }
        Kind::Vector(_) | Kind::VectorField(_) => {
            random.pick(&["[0 m, 0 m, 1 m]", "[1 Pa, X, 0]", "[0 m/s, 0 m/s, -1 m/s]", "[1, 2]"]).to_string()
        }
        Kind::Choice(choices) | Kind::Choices(choices) if !choices.is_empty() => {
            choices[random.below(choices.len())].word.into()
        }
        Kind::Material => name(random),
        Kind::Shape => {
            random.pick(&["box(1 m, 1 m, 1 m)", "box(4 mm, 2 mm, 1 mm)", "cylinder(1 m)"]).to_string()
        }
        Kind::Energy => random
            .pick(&["neo_hooke(mu = 1 kPa) + vol_quadratic(K = 1 MPa)", "neo_hooke(mu = 1 m)"])
            .to_string(),
        Kind::Curve => {
            random.pick(&["test.P over test.stretch", "test.P over test.t", "s.x over s.b"]).to_string()
        }
        _ => material.words[random.below(material.words.len())].clone(),
    }
}

fn entries(random: &mut Random, material: &Material, block: &Declaration, depth: usize) -> String {
    let mut text = String::new();
    for key in block.keys {
        if random.below(5) > 0 {
            text.push_str(&format!("{} = {}\n", key.name, value(random, material, key)));
        }
    }
    for member in block.members {
        if random.below(3) == 0 {
            continue;
        }
        let word = &material.words[random.below(material.words.len())];
        let (a, b) = (name(random), name(random));
        text.push_str(&match member {
            Member::Let => format!("let {a} = {word}\n"),
            Member::Param => format!("param {a} : pressure > 0 = 2 kPa\n"),
            Member::Fibre => format!("fibre {a} = unit([1, 2, 0])\n"),
            Member::Fibres => format!("fibres {a}\n"),
            Member::Direction => format!("direction {a}\n"),
            Member::Expect => format!("expect {a}.{b} == {word} within 1 % at {a} = 1\n"),
            Member::Directions => format!("{a} = [1, 0, 0]\n"),
            Member::Columns => format!("{a} = {word}\n"),
            Member::Vary => format!("vary {a}.neo_hooke.mu = [1 kPa, {word}]\n"),
        });
    }
    let inner: Vec<&&Declaration> =
        vocabulary().blocks.iter().filter(|inner| inner.within == Some(block.word)).collect();
    if depth > 0 && !inner.is_empty() {
        for _ in 0..random.below(8) {
            let chosen = inner[random.below(inner.len())];
            text.push_str(&generated_block(random, material, chosen, depth - 1));
        }
    }
    text
}

fn generated_block(random: &mut Random, material: &Material, block: &Declaration, depth: usize) -> String {
    let target = match block.target {
        Target::Absent => String::new(),
        Target::Name | Target::Material | Target::Body => name(random),
        Target::Face => format!("{}.{}", name(random), random.pick(&["xmin", "xmax", "ymin", "side"])),
    };
    format!("{} {target} {{\n{}}}\n", block.word, entries(random, material, block, depth))
}

/// A file from the declarations: blocks, keys and values that mostly fit.
pub fn generated(random: &mut Random, material: &Material) -> String {
    let top: Vec<&&Declaration> = vocabulary().blocks.iter().filter(|b| b.within.is_none()).collect();
    let mut text = String::from("tissue 1\nimport std.energies { neo_hooke, vol_quadratic, goh }\n");
    if random.below(2) == 0 {
        let gel = "energy = neo_hooke(mu = 1 kPa) + vol_quadratic(K = 1 MPa)\ndensity = 1000 kg/m^3";
        text.push_str(&format!("material {} {{\n{gel}\n}}\n", name(random)));
    }
    for _ in 0..1 + random.below(4) {
        let block = top[random.below(top.len())];
        text.push_str(&generated_block(random, material, block, 2));
    }
    text
}

/// A specification with a few words replaced, lost, repeated or exchanged.
pub fn mutated(random: &mut Random, material: &Material) -> (String, String) {
    let (path, text) = &material.specs[random.below(material.specs.len())];
    let mut words: Vec<&str> = text.split_inclusive([' ', '\n', '(', ')', '*', ',', '.']).collect();
    for _ in 0..1 + random.below(4) {
        let at = random.below(words.len());
        match random.below(5) {
            0 => words[at] = "",
            1 => {
                let other = random.below(words.len());
                words.swap(at, other);
            }
            2 => words.insert(at, words[random.below(words.len())]),
            _ => {
                let word: &str = &material.words[random.below(material.words.len())];
                words[at] = word;
                words.insert(at + 1, " ");
            }
        }
    }
    (path.clone(), words.concat())
}

/// Bytes, with luck text, below a version line.
pub fn bytes(random: &mut Random) -> String {
    let raw: Vec<u8> = (0..random.below(200)).map(|_| (random.next() & 0xff) as u8).collect();
    let text = match decode("bytes", raw.clone()) {
        Ok(source) => source.text,
        Err(_) => raw.iter().map(|byte| char::from(byte & 0x7f)).collect(),
    };
    if random.below(2) == 0 { text } else { format!("tissue 1\n{text}") }
}
