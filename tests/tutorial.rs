//! Every listing of the tutorial is run, every mistake in it is made, every line of output it shows appears.
//!
//! A `tissue` block below `<!-- file: … -->` is that file; one below `<!-- mistake -->` is answered by
//! the `text` block after it (`TISSUE_UPDATE=1` writes the answers); of a `console` block the commands
//! are run, and the lines shown stand in what they print, in this order.

use std::path::Path;
use std::process::Command;
use tissue::scene::{FileSystem, Mistake, resolve};
use tissue::syntax::{Source, format};

const PAGE: &str = "docs/tutorial.md";

/// A fenced block: its language, the comment above it, its text.
struct Block {
    language: String,
    comment: String,
    text: String,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut comment = String::new();
    let mut open: Option<Block> = None;
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(language)) => {
                let comment = std::mem::take(&mut comment);
                open = Some(Block { language: language.into(), comment, text: String::new() });
            }
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (Some(block), None) => block.text.push_str(&format!("{line}\n")),
            (None, None) => {
                let inner = line.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->"));
                comment = inner.unwrap_or_default().into();
            }
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

fn page() -> String {
    std::fs::read_to_string(PAGE).expect("the tutorial is in the repository")
}

#[test]
fn every_listing_is_the_file_it_names_in_the_standard_form() {
    let mut named = Vec::new();
    for block in blocks(&page()).iter().filter(|block| block.language == "tissue") {
        if block.comment == "mistake" {
            continue;
        }
        let path = block.comment.strip_prefix("file: ").expect("a listing names its file");
        let text = std::fs::read_to_string(path).expect("the file is in the repository");
        assert!(text == block.text, "the listing of {path} is not the file");
        let source = Source { name: path.into(), text: text.clone() };
        assert_eq!(format(&source).as_ref(), Ok(&text), "{path} is not in the standard form");
        named.push(path.to_string());
    }
    for entry in std::fs::read_dir("specs/tutorial").expect("the folder is there").flatten() {
        let path = entry.path().to_string_lossy().replace('\\', "/");
        if path.ends_with(".tissue") {
            assert!(named.contains(&path), "{path} is not in the tutorial");
        }
    }
}

#[test]
fn every_mistake_is_told_as_shown() {
    let page = page();
    let mut updated = page.clone();
    let blocks = blocks(&page);
    let mut wrong = Vec::new();
    for pair in blocks.windows(2).filter(|pair| pair[0].comment == "mistake") {
        assert_eq!(pair[1].language, "text", "a mistake is followed by what is told");
        let name = "specs/tutorial/example.tissue".to_string();
        let (_, found) = resolve(&Source { name, text: pair[0].text.clone() }, &FileSystem, &[]);
        assert!(!found.is_empty(), "no mistake in\n{}", pair[0].text);
        let told = found.iter().map(Mistake::render).collect::<Vec<_>>().join("\n");
        if told != pair[1].text {
            let after = |text: &str, told: &str| format!("{text}```\n\n```text\n{told}```");
            updated = updated.replace(&after(&pair[0].text, &pair[1].text), &after(&pair[0].text, &told));
            wrong.push(format!("shown\n{}told\n{told}", pair[1].text));
        }
    }
    if std::env::var_os("TISSUE_UPDATE").is_some() {
        std::fs::write(PAGE, updated).expect("the page is written");
    } else {
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}

#[test]
fn every_command_does_what_is_shown() {
    let home = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tutorial");
    let mut commands = 0;
    for (number, block) in blocks(&page()).iter().filter(|block| block.language == "console").enumerate() {
        let mut lines = block.text.lines();
        let command = lines.next().and_then(|line| line.strip_prefix("$ tissue ")).expect("a command");
        let mut process = Command::new(env!("CARGO_BIN_EXE_tissue"));
        process.current_dir(env!("CARGO_MANIFEST_DIR")).args(command.split_whitespace());
        if command.starts_with("run ") || command.starts_with("trade ") {
            let folder = home.join(number.to_string());
            let _ = std::fs::remove_dir_all(&folder);
            process.arg("--out").arg(folder);
        }
        let output = process.output().expect("the tool starts");
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{command}\n{printed}{told}");
        let mut rest = printed.as_str();
        for line in lines {
            let at = rest
                .find(line)
                .unwrap_or_else(|| panic!("{command}\nlacks, here or further up\n{line}\n{printed}"));
            rest = &rest[at + line.len()..];
        }
        commands += 1;
    }
    assert!(commands >= 5);
}
