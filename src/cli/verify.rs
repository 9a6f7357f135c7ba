//! `tissue verify`.

use super::Exit;
use super::arguments::VerifyOptions;
use crate::output::file::write_atomic;
use crate::verify::{
    Claim, Report, Shown, Tier, Topic, caught, claims_of, illustrations, scene_verdicts, silently,
};
use std::path::Path;

/// Holds claims and expect lines against their bounds; what panics in one of them is its verdict.
pub fn verify(options: &VerifyOptions) -> Exit {
    silently(|| judge(options))
}

fn judge(options: &VerifyOptions) -> Exit {
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
    let stopped: fn() -> f64 = || panic!("stopped on purpose");
    for (text, stop) in [(&options.broken, false), (&options.stopped, true)] {
        let Some(text) = text else { continue };
        let named = claims.iter_mut().filter(|claim| claim.claim.contains(text.as_str()));
        if named.map(|claim| claim.measure = if stop { stopped } else { claim.control }).count() == 0 {
            tell!("error: no claim of these topics contains `{text}`");
            return Exit::WrongInput;
        }
    }
    let mut verdicts: Vec<_> = claims.iter().map(Claim::judge).collect();
    let mut figures = Vec::new();
    if topics.contains(&Topic::Benchmarks) {
        let (list, drawn) = scene_verdicts(tier);
        verdicts.extend(list);
        figures.extend(drawn);
    }
    if verdicts.is_empty() {
        let names: Vec<&str> = topics.iter().map(|topic| topic.name()).collect();
        tell!("error: no claim is made about {} yet", names.join(", "));
        return Exit::Failed;
    }
    let report = Report::from_verdicts(verdicts);
    say_on!("{}", report.to_text());
    let (mut files, mut complete) = (Vec::new(), true);
    files.extend(options.json.as_ref().map(|path| (path, report.to_json())));
    if let Some(path) = &options.html {
        let (list, missing) = drawn(&report);
        missing.iter().for_each(|cause| tell!("error: {cause}"));
        complete = missing.is_empty();
        figures.extend(list);
        files.push((path, report.to_html(&figures)));
    }
    for (path, text) in files {
        if let Err(cause) = write_atomic(path, text.as_bytes()) {
            tell!("error: cannot write {}: {cause}", path.display());
            return Exit::Failed;
        }
    }
    if report.holds && complete { Exit::Fine } else { Exit::Failed }
}

/// The figures of the claims of a report, and why others could not be drawn.
fn drawn(report: &Report) -> (Vec<Shown>, Vec<String>) {
    let (mut figures, mut missing) = (Vec::new(), Vec::new());
    for illustration in illustrations() {
        if report.claims.iter().any(|verdict| verdict.claim == illustration.claim) {
            let svg = caught(illustration.figure)
                .and_then(|figure| figure.to_svg().map_err(|cause| cause.to_string()));
            match svg {
                Ok(svg) => figures.push(Shown { claim: illustration.claim.into(), source: None, svg }),
                Err(cause) => missing.push(format!("figure of `{}`: {cause}", illustration.claim)),
            }
        }
    }
    (figures, missing)
}
