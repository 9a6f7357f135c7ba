//! `tissue verify`.

use super::Exit;
use super::arguments::VerifyOptions;
use crate::output::file::write_atomic;
use crate::verify::{Report, Tier, Topic, claims_of, scene_verdicts};

/// Holds claims and expect lines against their bounds.
pub fn verify(options: &VerifyOptions) -> Exit {
    let mut topics = Vec::new();
    for name in &options.topics {
        match Topic::ALL.iter().find(|topic| topic.name() == name) {
            Some(topic) => topics.push(*topic),
            None => {
                let known: Vec<&str> = Topic::ALL.iter().map(|topic| topic.name()).collect();
                eprintln!("error: no topic `{name}`; the topics are {}", known.join(", "));
                return Exit::WrongInput;
            }
        }
    }
    if topics.is_empty() {
        topics = Topic::ALL.to_vec();
    }
    if let Some(path) = &options.json
        && path.exists()
        && !options.overwrite
    {
        eprintln!("error: {} exists; name another file, or replace it with --overwrite", path.display());
        return Exit::WrongInput;
    }
    let tier = if options.full { Tier::Full } else { Tier::Quick };
    let mut verdicts = Vec::new();
    for claim in claims_of(&topics, tier) {
        verdicts.push(claim.judge());
    }
    if topics.contains(&Topic::Benchmarks) {
        match scene_verdicts(tier) {
            Ok(list) => verdicts.extend(list),
            Err(cause) => {
                eprintln!("error: {cause}");
                return Exit::Failed;
            }
        }
    }
    if verdicts.is_empty() {
        let names: Vec<&str> = topics.iter().map(|topic| topic.name()).collect();
        eprintln!("error: no claim is made about {} yet", names.join(", "));
        return Exit::Failed;
    }
    let report = Report::from_verdicts(verdicts);
    say_on!("{}", report.to_text());
    if let Some(path) = &options.json
        && let Err(cause) = write_atomic(path, report.to_json().as_bytes())
    {
        eprintln!("error: cannot write {}: {cause}", path.display());
        return Exit::Failed;
    }
    if report.holds { Exit::Fine } else { Exit::Failed }
}
