//! Every code has a page, and the example on it gives what the page shows.
//!
//! A page is `docs/diagnostics/E0301.md`: its title, why, a `tissue` block, and the `text` block the
//! program answers with. `TISSUE_UPDATE=1` writes the latter; read it before committing.

use std::fs;
use std::path::PathBuf;
use tissue::scene::{LoadError, Loader, Mistake, resolve};
use tissue::syntax::{Code, Source, decode, parse, parse_expression};

const NAME: &str = "example.tissue";

/// Codes that no short text can show; each has a test of its own below.
const WITHOUT_EXAMPLE: [Code; 5] =
    [Code::FileTooLarge, Code::ExpressionTooDeep, Code::NotUtf8, Code::TooManyMistakes, Code::NotAvailable];

/// The example itself, and the table of its page, are the only files.
struct Alone(String, Option<String>);

impl Loader for Alone {
    fn load(&self, path: &str) -> Result<String, LoadError> {
        if path.ends_with(NAME) {
            return Ok(self.0.clone());
        }
        self.1.clone().filter(|_| path == "data.csv").ok_or(LoadError::Missing)
    }
}

fn path(code: Code) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/diagnostics").join(format!("{code}.md"))
}

fn page(code: Code) -> String {
    fs::read_to_string(path(code)).unwrap_or_else(|e| panic!("{}: {e}", path(code).display()))
}

/// The content of the first fenced block of a language.
fn fenced<'a>(page: &'a str, language: &str) -> Option<&'a str> {
    let open = format!("```{language}\n");
    let start = page.find(&open)? + open.len();
    let length = page[start..].find("```")?;
    Some(&page[start..start + length])
}

fn mistakes(text: &str, table: Option<&str>, overrides: &[(String, String)]) -> Vec<Mistake> {
    let files = Alone(text.into(), table.map(String::from));
    resolve(&Source { name: NAME.into(), text: text.into() }, &files, overrides).1
}

#[test]
fn every_code_has_a_page_with_its_title_and_no_page_is_of_no_code() {
    for code in Code::ALL {
        assert!(page(*code).starts_with(&format!("# {code}: {}\n", code.title())), "{code}");
    }
    let pages = fs::read_dir(path(Code::NotUtf8).parent().expect("a folder")).expect("the pages are there");
    for entry in pages.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert!(Code::ALL.iter().any(|code| format!("{code}.md") == name), "{name} is of no code");
    }
}

#[test]
fn the_example_of_a_page_gives_its_code_and_what_the_page_shows() {
    let mut wrong = Vec::new();
    for code in Code::ALL.iter().filter(|code| !WITHOUT_EXAMPLE.contains(code)) {
        let page = page(*code);
        let Some(example) = fenced(&page, "tissue") else {
            wrong.push(format!("{code} has no example"));
            continue;
        };
        let found = mistakes(example, fenced(&page, "csv"), &[]);
        if found.iter().all(|m| m.diagnostic.code != *code) {
            let told: String = found.iter().map(Mistake::render).collect();
            wrong.push(format!("{code} is not given by its example, but:\n{told}"));
        }
        let told = found.iter().map(Mistake::render).collect::<Vec<_>>().join("\n");
        let shown = fenced(&page, "text").unwrap_or_default();
        if shown != told && std::env::var_os("TISSUE_UPDATE").is_some() {
            let page = page.replace(&format!("```text\n{shown}```"), &format!("```text\n{told}```"));
            fs::write(path(*code), page).expect("the page is written");
        } else if shown != told {
            wrong.push(format!("{code} shows\n{shown}but is told\n{told}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_no_page_can_show_is_told_too() {
    let source = |text: String| Source { name: NAME.into(), text };
    let codes = |text: String| parse(&source(text)).1.iter().map(|m| m.code).collect::<Vec<_>>();
    assert_eq!(codes("#".repeat(1_000_001)), [Code::FileTooLarge]);
    assert_eq!(decode(NAME, vec![0xff]).map_err(|m| m.code), Err(Code::NotUtf8));
    assert_eq!(
        codes(format!("tissue 1\na {{\n{}}}\n", "b =\n".repeat(60))).last(),
        Some(&Code::TooManyMistakes)
    );
    let deep = parse_expression(&source(format!("{}x", "x + ".repeat(500))));
    assert_eq!(deep.map_err(|m| m[0].code).map(|_| ()), Err(Code::ExpressionTooDeep));
    // Nothing of the language waits to be carried out, so nothing can be told to.
    assert!(tissue::scene::vocabulary().blocks.iter().all(|block| block.available));
    let text = fenced(&page(Code::UnknownBlock), "tissue").unwrap_or_default().to_string();
    let found = mistakes(&text, None, &[("nothing.here".into(), "1".into())]);
    assert!(found.iter().any(|m| m.diagnostic.code == Code::UnknownOverride), "{found:?}");
}
