//! Every `tissue run` of the pages: the file is there, takes the values and makes a scene.

#[path = "support/tool.rs"]
#[allow(dead_code)]
mod tool;

use std::collections::BTreeSet;
use std::fs;
use tool::{text, tissue};

/// The commands of a page without an ellipsis or a name left open, each as the arguments behind `run`.
fn commands(page: &str) -> BTreeSet<Vec<String>> {
    let spans = page.split('`').skip(1).step_by(2);
    let lines =
        page.lines().filter(|line| line.starts_with("    ")).filter_map(|line| line.split('#').next());
    spans
        .chain(lines)
        .filter_map(|code| code.trim().strip_prefix("tissue run specs/"))
        .filter(|rest| !rest.contains(['…', '\n']) && !rest.contains("NAME"))
        .map(|rest| format!("specs/{rest}").split_whitespace().map(String::from).collect())
        .collect()
}

/// The words of a command as a shell would hand them over: `"1 m/16"` is one.
fn unquoted(words: &[String]) -> Vec<String> {
    let line = words.join(" ");
    let mut all = Vec::new();
    for (place, part) in line.split('"').enumerate() {
        if place % 2 == 1 {
            let last: String = all.pop().unwrap_or_default();
            all.push(last + part);
        } else {
            all.extend(part.split_whitespace().map(String::from));
        }
    }
    all
}

#[test]
fn every_run_of_the_pages_is_one_that_the_program_takes() {
    let pages = fs::read_dir("docs").expect("the folder is in the repository").flatten();
    let pages =
        pages.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "md"));
    let mut seen = BTreeSet::new();
    for page in pages.chain(["README.md".into()]) {
        seen.extend(commands(&fs::read_to_string(page).expect("a page is text")));
    }
    assert!(seen.len() > 20, "{} commands found", seen.len());
    let mut refused = Vec::new();
    for words in seen {
        let mut arguments = vec!["plan".to_owned()];
        arguments.extend(unquoted(&words));
        let output = tissue(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        if output.status.code() != Some(0) {
            refused.push(format!("tissue run {}\n{}", words.join(" "), text(&output.stderr)));
        }
    }
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}
