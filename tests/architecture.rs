//! The layers of `src/` as `ARCHITECTURE.md` tabulates them: a module names only modules of lower
//! layers, every module has a row, every row a module.

use std::fs;
use std::path::{Path, PathBuf};

/// A module of the table, with its layer.
type Layers = Vec<(String, u32)>;

/// The modules and layers of the table: rows that start with a number and a name in backticks.
fn layers(text: &str) -> Layers {
    let cells = |line: &str| -> Vec<String> { line.split('|').map(|cell| cell.trim().to_owned()).collect() };
    text.lines()
        .map(cells)
        .filter(|cells| cells.len() > 3)
        .filter_map(|cells| {
            let layer = cells[1].parse().ok()?;
            let module = cells[2].strip_prefix('`')?.strip_suffix('`')?;
            Some((module.to_owned(), layer))
        })
        .collect()
}

/// Code without comments and string literals, in which names are no dependencies.
fn code_only(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let bytes: Vec<char> = text.chars().collect();
    let mut i = 0;
    while i < bytes.len() {
        let rest = |n: usize| bytes.get(i + n).copied();
        if bytes[i] == '/' && rest(1) == Some('/') {
            while i < bytes.len() && bytes[i] != '\n' {
                i += 1;
            }
        } else if bytes[i] == '\'' && (rest(2) == Some('\'') || rest(1) == Some('\\')) {
            // A character literal: its closing quote is the next that no backslash precedes.
            i += if rest(1) == Some('\\') { 3 } else { 2 };
            while i < bytes.len() && bytes[i] != '\'' {
                i += 1;
            }
            i += 1;
        } else if let Some(end) = raw_string_end(&bytes, i) {
            i = end;
        } else if bytes[i] == '"' {
            i += 1;
            while i < bytes.len() && bytes[i] != '"' {
                i += if bytes[i] == '\\' { 2 } else { 1 };
            }
            i += 1;
        } else {
            code.push(bytes[i]);
            i += 1;
        }
    }
    code
}

/// The position after the raw string that starts at `start`, if one does.
fn raw_string_end(text: &[char], start: usize) -> Option<usize> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    if text[start] != 'r' || (start > 0 && is_word(text[start - 1]) && text[start - 1] != 'b') {
        return None;
    }
    let hashes = text[start + 1..].iter().take_while(|&&c| c == '#').count();
    if text.get(start + 1 + hashes) != Some(&'"') {
        return None;
    }
    let close: Vec<char> = std::iter::once('"').chain(std::iter::repeat_n('#', hashes)).collect();
    let body = start + 2 + hashes;
    let at = text[body..].windows(close.len()).position(|window| window == close)?;
    Some(body + at + close.len())
}

/// Names that follow the crate's root in `code`, a module `depth` levels below it.
///
/// A chain of `depth` times `super` reaches the root; inside an inline module one more is needed, so
/// the tail of a longer chain counts as well.
fn named(code: &str, depth: usize) -> Vec<String> {
    let mut found = Vec::new();
    let squeezed: String =
        code.split_whitespace().collect::<Vec<_>>().join(" ").replace(" ::", "::").replace(":: ", "::");
    for root in ["crate::".to_owned(), "tissue::".to_owned(), "super::".repeat(depth)] {
        for (at, _) in squeezed.match_indices(&root) {
            let before = squeezed[..at].chars().next_back();
            if before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
                continue;
            }
            found.extend(heads(&squeezed[at + root.len()..]));
        }
    }
    found.sort();
    found.dedup();
    found
}

/// The first name of a path, or of every path of a group in braces.
fn heads(path: &str) -> Vec<String> {
    let name = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let Some(group) = path.strip_prefix('{') else { return vec![name(path)] };
    let (mut depth, mut start, mut heads) = (0, 0, Vec::new());
    for (i, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => {
                heads.push(name(&group[start..i]));
                break;
            }
            '}' => depth -= 1,
            ',' if depth == 0 => {
                heads.push(name(&group[start..i]));
                start = i + 1;
            }
            _ => {}
        }
    }
    heads
}

/// What is wrong with a file of `module`: every name of a module that is not lower.
fn faults(layers: &Layers, module: &str, depth: usize, text: &str) -> Vec<String> {
    let layer_of = |name: &str| layers.iter().find(|(other, _)| other == name).map(|&(_, layer)| layer);
    let own = layer_of(module).expect("every module has a row");
    named(&code_only(text), depth)
        .into_iter()
        .filter(|name| name != module)
        .filter(|name| layer_of(name).is_some_and(|layer| layer >= own))
        .collect()
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
    files.sort();
    files
}

fn table() -> Layers {
    layers(&fs::read_to_string("ARCHITECTURE.md").expect("the table is there"))
}

#[test]
fn every_module_of_the_crate_has_a_row_and_every_row_a_module() {
    let root = fs::read_to_string("src/lib.rs").expect("the root is there");
    let mut modules: Vec<&str> =
        root.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    modules.sort_unstable();
    let table = table();
    let mut rows: Vec<&str> = table.iter().map(|(module, _)| module.as_str()).collect();
    rows.sort_unstable();
    assert_eq!(modules, rows);
}

#[test]
fn a_module_names_only_modules_of_lower_layers() {
    let table = table();
    let mut all = Vec::new();
    for path in rust_files(Path::new("src")) {
        let inside = path.strip_prefix("src").expect("below src");
        let mut segments: Vec<String> =
            inside.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
        if segments.last().is_some_and(|last| last == "mod") {
            segments.pop();
        }
        if segments == ["lib"] || segments == ["main"] {
            continue;
        }
        let text = fs::read_to_string(&path).expect("readable");
        for fault in faults(&table, &segments[0], segments.len(), &text) {
            all.push(format!("{} names `{fault}`, which is not below `{}`", path.display(), segments[0]));
        }
    }
    for path in rust_files(Path::new("verification")) {
        let text = fs::read_to_string(&path).expect("readable");
        // The claims are modules of `verify`, deeper than any chain of `super` in use.
        for fault in faults(&table, "verify", 9, &text) {
            all.push(format!("{} names `{fault}`, which is not below `verify`", path.display()));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn a_name_of_an_equal_or_higher_layer_is_found_in_every_form() {
    let table =
        layers("| 0 | `tensor` | |\n| 2 | `energy` | |\n| 2 | `discretisation` | |\n| 5 | `solver` | |\n");
    assert_eq!(table.len(), 4);
    let found = |depth, text| faults(&table, "energy", depth, text);
    assert_eq!(found(1, "use crate::solver::State;"), ["solver"]);
    assert_eq!(found(1, "use super::discretisation;"), ["discretisation"]);
    assert_eq!(found(2, "let s = super::super::solver::new();"), ["solver"]);
    assert_eq!(found(2, "use crate::{\n  tensor::{Mat3, Vec3},\n  solver,\n};"), ["solver"]);
    assert_eq!(found(1, "fn f() -> tissue :: solver::State {}"), ["solver"]);
    assert_eq!(found(1, "mod tests { use super::super::solver; }"), ["solver"]);
}

#[test]
fn lower_layers_own_names_comments_and_strings_are_no_faults() {
    let table = layers("| 0 | `tensor` | |\n| 2 | `energy` | |\n| 5 | `solver` | |\n");
    let found = |depth, text| faults(&table, "energy", depth, text);
    assert!(found(1, "use crate::tensor::Mat3; use crate::energy::law;").is_empty());
    assert!(found(2, "use super::solver; // a module of energy's own").is_empty());
    assert!(found(1, "// see crate::solver\n/// [`crate::solver`]").is_empty());
    assert!(
        found(1, "let s = \"crate::solver\"; let r = r#\"tissue::solver \"x\" \"#; let c = '\"';").is_empty()
    );
    assert!(found(1, "my_crate::solver::x(); resolver::x();").is_empty());
}
