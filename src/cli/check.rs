//! `tissue check`: mistakes, and the audit of every material.

use super::Exit;
use super::arguments::CheckOptions;
use super::input::{Input, count, read};
use crate::verify::MaterialAudit;
use serde_json::{Value, json};

/// Audits files; runs nothing.
pub fn check(options: &CheckOptions) -> Exit {
    let mut exit = Exit::Fine;
    let mut documents = Vec::new();
    for file in &options.files {
        match read(file, &[]) {
            Err(message) => {
                exit = Exit::WrongInput;
                if options.json {
                    documents.push(json!({ "file": file.to_string_lossy(), "error": message }));
                } else {
                    eprintln!("{message}");
                }
            }
            Ok(input) => {
                if !input.mistakes.is_empty() {
                    exit = Exit::WrongInput;
                }
                let (audits, sound) = audit(&input);
                if exit == Exit::Fine && !sound {
                    exit = Exit::Failed;
                }
                if options.json {
                    documents.push(as_json(&input, &audits));
                } else {
                    print(&input, &audits);
                }
            }
        }
    }
    if options.json {
        say!("{:#}", Value::Array(documents));
    }
    exit
}

/// The audits of a file without mistakes, and whether every material can be computed with.
fn audit(input: &Input) -> (Vec<MaterialAudit>, bool) {
    let mut audits = Vec::new();
    let mut sound = true;
    let materials = if input.mistakes.is_empty() { &input.document.materials[..] } else { &[] };
    for material in materials {
        match MaterialAudit::of(material) {
            Ok(audit) => {
                sound &= audit.is_sound();
                audits.push(audit);
            }
            Err(cause) => {
                eprintln!("error: material `{}`: {cause}", material.name);
                sound = false;
            }
        }
    }
    (audits, sound)
}

fn print(input: &Input, audits: &[MaterialAudit]) {
    for mistake in &input.mistakes {
        eprintln!("{}", mistake.render());
    }
    if input.mistakes.is_empty() {
        let names = |names: Vec<&str>| if names.is_empty() { "none".into() } else { names.join(", ") };
        say!("{}: no mistakes", input.name);
        say!("  materials  {}", names(input.document.materials.iter().map(|m| m.name.as_str()).collect()));
        say!("  drives     {}", names(input.document.drives.iter().map(|d| d.name.as_str()).collect()));
        say!("  scenes     {}", names(input.document.scenes.iter().map(|s| s.name.as_str()).collect()));
        let of = |trade: bool| {
            let sweeps = input.document.sweeps.iter().filter(move |sweep| sweep.trade.is_some() == trade);
            sweeps.map(|sweep| format!("{} ({} points)", sweep.name, sweep.points.len())).collect::<Vec<_>>()
        };
        for (word, found) in [("sweeps", of(false)), ("trades", of(true))] {
            if !found.is_empty() {
                say!("  {word}     {}", found.join(", "));
            }
        }
        for audit in audits {
            say_on!("\n{audit}");
        }
    } else {
        eprintln!("{}: {}", input.name, count(input.mistakes.len()));
    }
}

fn as_json(input: &Input, audits: &[MaterialAudit]) -> Value {
    let mistakes: Vec<Value> =
        input.mistakes.iter().map(|mistake| mistake.diagnostic.to_json(&mistake.source)).collect();
    json!({
        "file": input.name,
        "hash": input.hash,
        "mistakes": mistakes,
        "materials": input.document.materials.iter().map(|m| &m.name).collect::<Vec<_>>(),
        "audits": audits,
        "drives": input.document.drives.iter().map(|d| &d.name).collect::<Vec<_>>(),
        "scenes": input.document.scenes.iter().map(|s| &s.name).collect::<Vec<_>>(),
        "sweeps": input.document.sweeps.iter().map(|s| &s.name).collect::<Vec<_>>(),
    })
}
