//! Claims, the verdicts on them and the report.
//!
//! Owns what a claim is, how it is judged and how the judgement is printed. The claims themselves
//! live beside their references in `verification/`; nothing here knows the command line.

pub mod audit;
pub mod claim;
pub mod report;
mod scenes;

#[path = "../../verification/mod.rs"]
mod claims;

pub use audit::MaterialAudit;
pub use claim::{Claim, Topic, Verdict};
pub use claims::quick;
pub use report::Report;
pub use scenes::{benchmark, library_verdicts, scene_verdicts};

/// The quick claims of some topics.
pub fn claims_of(topics: &[Topic]) -> Vec<Claim> {
    quick().into_iter().filter(|claim| topics.contains(&claim.topic)).collect()
}
