//! The register of equations and the tags in the code, held together both ways.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A cited equation: the work's abbreviation and the number, `("NB25", 32)`.
type Equation = (String, u32);

/// Every equation that `text` tags, in forms such as `[NB25 (32)]` and `[NB25 (44)-(45)]`.
fn tags(text: &str) -> BTreeSet<Equation> {
    let mut found = BTreeSet::new();
    for (at, _) in text.match_indices('[') {
        let rest = &text[at + 1..];
        let Some((inside, _)) = rest.split_once(']') else { continue };
        let Some((work, numbers)) = inside.trim_end_matches('\\').split_once(' ') else { continue };
        let year = work.trim_start_matches(|c: char| c.is_ascii_uppercase());
        let is_work = year.len() == 2 && year.len() < work.len() && year.bytes().all(|b| b.is_ascii_digit());
        if is_work && numbers.starts_with('(') {
            found.extend(expanded(numbers).into_iter().map(|number| (work.to_owned(), number)));
        }
    }
    // in a claim's `source` the work stands without brackets
    for (at, _) in text.match_indices("NB25 (") {
        let rest = &text[at + "NB25 ".len()..];
        let end = rest.find(|c: char| !c.is_ascii_digit() && !"(),-– ".contains(c)).unwrap_or(rest.len());
        let numbers = &rest[..rest[..end].rfind(')').map_or(0, |last| last + 1)];
        found.extend(expanded(numbers).into_iter().map(|number| ("NB25".to_owned(), number)));
    }
    found
}

/// The numbers of `(44)-(45)`, `(35, 37)` or `(28–30)`, ranges filled in.
fn expanded(text: &str) -> Vec<u32> {
    let spread = text.replace('–', "-");
    let (mut numbers, mut is_range): (Vec<u32>, bool) = (Vec::new(), false);
    let mut digits = String::new();
    for c in spread.chars().chain([' ']) {
        if c.is_ascii_digit() {
            digits.push(c);
            continue;
        }
        if let Ok(number) = digits.parse() {
            let from = numbers.last().copied().filter(|_| is_range);
            numbers.extend(from.map_or(number..=number, |from| from + 1..=number));
            is_range = false;
        }
        digits.clear();
        is_range |= c == '-';
    }
    numbers
}

/// The register: of each row its equations and the files it names.
fn rows(text: &str) -> Vec<(BTreeSet<Equation>, Vec<String>)> {
    text.lines()
        .filter(|line| line.starts_with("| ["))
        .map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let files = cells.get(3).copied().unwrap_or_default();
            (tags(cells[1]), files.split(',').map(|file| file.trim().to_owned()).collect())
        })
        .collect()
}

/// What is wrong between the register and the tags of each file.
fn faults(register: &str, code: &BTreeMap<String, BTreeSet<Equation>>) -> Vec<String> {
    let rows = rows(register);
    let mut faults = Vec::new();
    for (file, tags) in code {
        for tag in tags {
            if !rows.iter().any(|(equations, _)| equations.contains(tag)) {
                faults.push(format!("{file} cites [{} ({})], which has no row", tag.0, tag.1));
            }
        }
    }
    for (equations, files) in &rows {
        for (work, number) in equations {
            for file in files {
                let is_there = code.get(file).is_some_and(|tags| tags.contains(&(work.clone(), *number)));
                if !is_there {
                    faults.push(format!("[{work} ({number})] is not cited in `{file}`, which its row names"));
                }
            }
        }
        if equations.is_empty() {
            faults.push("a row starts with a tag that names no equation".into());
        }
    }
    let firsts: Vec<&Equation> = rows.iter().filter_map(|(equations, _)| equations.first()).collect();
    if firsts.windows(2).any(|pair| pair[0] >= pair[1]) {
        faults.push("the rows are not in the order of the equations, each once".into());
    }
    faults
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn every_tag_has_a_row_and_every_row_a_tag_where_it_says() {
    let mut code = BTreeMap::new();
    for folder in ["src", "verification"] {
        for path in rust_files(Path::new(folder)) {
            let text = fs::read_to_string(&path).expect("readable");
            code.insert(path.to_string_lossy().replace('\\', "/"), tags(&text));
        }
    }
    let register = fs::read_to_string("docs/equations.md").expect("the register is there");
    let faults = faults(&register, &code);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(!rows(&register).is_empty());
}

#[test]
fn a_tag_without_a_row_a_row_without_a_tag_and_disorder_are_found() {
    let code = |file: &str, text: &str| BTreeMap::from([(file.to_owned(), tags(text))]);
    let row = |n: u32, file: &str| format!("| [NB25 ({n})] | meaning | {file} |\n");
    let good = row(32, "src/a.rs");
    assert!(faults(&good, &code("src/a.rs", "/// T [NB25 (32)]")).is_empty());
    assert_eq!(
        faults(&good, &code("src/a.rs", "[NB25 (32)] [NB25 (33)]")),
        ["src/a.rs cites [NB25 (33)], which has no row"]
    );
    assert_eq!(
        faults(&good, &code("src/b.rs", "[NB25 (32)]")),
        ["[NB25 (32)] is not cited in `src/a.rs`, which its row names"]
    );
    let both = code("src/a.rs", "[NB25 (32)] [NB25 (33)]");
    assert!(faults(&(row(32, "src/a.rs") + &row(33, "src/a.rs")), &both).is_empty());
    let disorder = ["the rows are not in the order of the equations, each once"];
    assert_eq!(faults(&(row(33, "src/a.rs") + &row(32, "src/a.rs")), &both), disorder);
    let twice = code("src/a.rs", "[NB25 (32)]");
    assert_eq!(faults(&(good.clone() + &good), &twice), disorder);
}

#[test]
fn tags_are_read_in_every_form_and_links_are_not_tags() {
    let numbers = |text: &str| tags(text).into_iter().map(|(_, n)| n).collect::<Vec<_>>();
    assert_eq!(numbers("[NB25 (32)] and \\[NB25 (42)\\]"), [32, 42]);
    assert_eq!(numbers("[NB25 (44)-(45)] [NB25 (33, 35)] [NB25 (28–30)]"), [28, 29, 30, 33, 35, 44, 45]);
    assert!(numbers("[`Table`] [NB25] a[0] [x (32)] #[cfg(test)] [A (3)]").is_empty());
}
