//! `tissue verify`.

use super::Exit;
use super::arguments::VerifyOptions;
use crate::output::file::write_atomic;
use crate::verify::{Claim, Report, Shown, Tier, Topic, claims_of, illustrations, scene_verdicts};
use std::path::Path;

/// Holds claims and expect lines against their bounds.
pub fn verify(options: &VerifyOptions) -> Exit {
    let mut topics = Vec::new();
    for name in &options.topics {
        match Topic::ALL.iter().find(|topic| topic.name() == name) {
            Some(topic) => topics.push(*topic),
            None => {
                let known: Vec<&str> = Topic::ALL.iter().map(|topic| topic.name()).collect();
                tell!("error: no topic `{name}`; the topics are {}", known.join(", "));
                if Path::new(name).is_file() {
                    tell!("the `expect` lines of a file are judged by `tissue run {name}`");
                }
                return Exit::WrongInput;
            }
        }
    }
    if topics.is_empty() {
        topics = Topic::ALL.to_vec();
    }
    for path in [&options.json, &options.html].into_iter().flatten() {
        if path.exists() && !options.overwrite {
            tell!("error: {} exists; name another file, or replace it with --overwrite", path.display());
            return Exit::WrongInput;
        }
    }
    let tier = if options.full { Tier::Full } else { Tier::Quick };
    let mut claims = claims_of(&topics, tier);
    if let Some(text) = &options.broken {
        let broken = claims.iter_mut().filter(|claim| claim.claim.contains(text.as_str()));
        if broken.map(|claim| claim.measure = claim.control).count() == 0 {
            tell!("error: no claim of these topics contains `{text}`");
            return Exit::WrongInput;
        }
    }
    let mut verdicts: Vec<_> = claims.iter().map(Claim::judge).collect();
    let mut figures = Vec::new();
    if topics.contains(&Topic::Benchmarks) {
        match scene_verdicts(tier) {
            Ok((list, drawn)) => {
                verdicts.extend(list);
                figures.extend(drawn);
            }
            Err(cause) => {
                tell!("error: {cause}");
                return Exit::Failed;
            }
        }
    }
    if verdicts.is_empty() {
        let names: Vec<&str> = topics.iter().map(|topic| topic.name()).collect();
        tell!("error: no claim is made about {} yet", names.join(", "));
        return Exit::Failed;
    }
    let report = Report::from_verdicts(verdicts);
    say_on!("{}", report.to_text());
    let mut files = Vec::new();
    files.extend(options.json.as_ref().map(|path| (path, report.to_json())));
    if let Some(path) = &options.html {
        match drawn(&report) {
            Ok(list) => {
                figures.extend(list);
                files.push((path, report.to_html(&figures)));
            }
            Err(cause) => {
                tell!("error: {cause}");
                return Exit::Failed;
            }
        }
    }
    for (path, text) in files {
        if let Err(cause) = write_atomic(path, text.as_bytes()) {
            tell!("error: cannot write {}: {cause}", path.display());
            return Exit::Failed;
        }
    }
    if report.holds { Exit::Fine } else { Exit::Failed }
}

/// The figures of the claims of a report.
fn drawn(report: &Report) -> Result<Vec<Shown>, String> {
    let mut figures = Vec::new();
    for illustration in illustrations() {
        if report.claims.iter().any(|verdict| verdict.claim == illustration.claim) {
            let figure = (illustration.figure)();
            let svg =
                figure.to_svg().map_err(|cause| format!("figure of `{}`: {cause}", illustration.claim))?;
            figures.push(Shown { claim: illustration.claim.into(), source: None, svg });
        }
    }
    Ok(figures)
}
