//! `tissue check`: mistakes, and the audit of every material.

use super::Exit;
use super::arguments::CheckOptions;
use super::input::{Input, read, tell_mistakes};
use crate::output::Provenance;
use crate::output::file::write_atomic;
use crate::scene::{Check, Material};
use crate::verify::{MaterialAudit, ellipticity_map};
use serde_json::{Value, json};
use std::path::Path;

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
                    tell!("{message}");
                }
            }
            Ok(input) => {
                if !input.mistakes.is_empty() {
                    exit = Exit::WrongInput;
                }
                let (audits, mut sound) = audit(&input);
                if let Some(folder) = options.map.as_ref().filter(|_| input.mistakes.is_empty()) {
                    sound &= draw_maps(&input, folder, options.overwrite);
                }
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
    for Asked { material, check } in asked(input) {
        let found = check.map_or_else(|| MaterialAudit::of(material), MaterialAudit::of_check);
        match found {
            Ok(audit) => {
                sound &= audit.is_sound();
                audits.push(audit);
            }
            Err(cause) => {
                tell!("error: material `{}`: {cause}", material.name);
                sound = false;
            }
        }
    }
    (audits, sound)
}

/// A material to audit, and what the file requires of it.
struct Asked<'a> {
    material: &'a Material,
    check: Option<&'a Check>,
}

/// Every material of a file without mistakes, once a check of it or once without; then imported ones that
/// are checked.
fn asked(input: &Input) -> Vec<Asked<'_>> {
    let document = &input.document;
    if !input.mistakes.is_empty() {
        return Vec::new();
    }
    let mut asked = Vec::new();
    for material in &document.materials {
        let checks = document.checks.iter().filter(|check| check.material.name == material.name);
        let before = asked.len();
        asked.extend(checks.map(|check| Asked { material, check: Some(check) }));
        if asked.len() == before {
            asked.push(Asked { material, check: None });
        }
    }
    let own = |check: &&Check| document.materials.iter().all(|own| own.name != check.material.name);
    let imported = document.checks.iter().filter(own);
    asked.extend(imported.map(|check| Asked { material: &check.material, check: Some(check) }));
    asked
}

/// Writes the map of each material; whether all were written.
fn draw_maps(input: &Input, folder: &Path, overwrite: bool) -> bool {
    if let Err(cause) = std::fs::create_dir_all(folder) {
        tell!("error: cannot make {}: {cause}", folder.display());
        return false;
    }
    let mut drawn: Vec<String> = Vec::new();
    let mut sound = true;
    for Asked { material, check } in asked(input) {
        let earlier = drawn.iter().filter(|name| **name == material.name).count();
        drawn.push(material.name.clone());
        let suffix = if earlier == 0 { String::new() } else { format!("_{}", earlier + 1) };
        let path = folder.join(format!("{}{suffix}.svg", material.name));
        if path.exists() && !overwrite {
            tell!("error: {} exists; name another folder, or replace it with --overwrite", path.display());
            sound = false;
            continue;
        }
        let provenance = Provenance::new(&input.name, &input.hash, &material.name);
        let svg = ellipticity_map(material, check.and_then(|check| check.stretches), &provenance);
        let written = svg.and_then(|svg| {
            write_atomic(&path, svg.as_bytes())
                .map_err(|cause| format!("cannot write {}: {cause}", path.display()))
        });
        if let Err(cause) = written {
            tell!("error: map of `{}`: {cause}", material.name);
            sound = false;
        }
    }
    sound
}

fn print(input: &Input, audits: &[MaterialAudit]) {
    if input.mistakes.is_empty() {
        let names = |names: Vec<&str>| if names.is_empty() { "none".into() } else { names.join(", ") };
        say!("{}: no mistakes", input.name);
        say!("  materials  {}", names(input.document.materials.iter().map(|m| m.name.as_str()).collect()));
        say!("  drives     {}", names(input.document.drives.iter().map(|d| d.name.as_str()).collect()));
        say!("  fits       {}", names(input.document.fits.iter().map(|f| f.name.as_str()).collect()));
        say!("  scenes     {}", names(input.document.scenes.iter().map(|s| s.name.as_str()).collect()));
        let of = |trade: bool| {
            let sweeps = input.document.sweeps.iter().filter(move |sweep| sweep.trade.is_some() == trade);
            sweeps.map(|sweep| format!("{} ({} points)", sweep.name, sweep.points.len())).collect::<Vec<_>>()
        };
        let figures = input.document.figures.iter().map(|figure| figure.name.clone()).collect();
        for (word, found) in [("sweeps ", of(false)), ("trades ", of(true)), ("figures", figures)] {
            if !found.is_empty() {
                say!("  {word}    {}", found.join(", "));
            }
        }
        for audit in audits {
            say_on!("\n{audit}");
        }
    } else {
        tell_mistakes(&format!("{}: ", input.name), &input.mistakes);
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
        "fits": input.document.fits.iter().map(|f| &f.name).collect::<Vec<_>>(),
        "scenes": input.document.scenes.iter().map(|s| &s.name).collect::<Vec<_>>(),
        "sweeps": input.document.sweeps.iter().map(|s| &s.name).collect::<Vec<_>>(),
    })
}
