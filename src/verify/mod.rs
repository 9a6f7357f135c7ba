//! Claims, the verdicts on them and the report.
//!
//! Owns what a claim is, how it is judged and how the judgement is printed. The claims themselves
//! live beside their references in `verification/`; nothing here knows the command line.

pub mod audit;
mod caught;
pub mod claim;
mod page;
pub mod report;
mod scenes;

#[path = "../../verification/mod.rs"]
mod claims;

pub(crate) use audit::quantity;
pub use audit::{MaterialAudit, ellipticity_map};
pub(crate) use caught::{Shared, caught, silently};
pub use claim::{Claim, Illustration, Tier, Topic, Verdict};
pub use claims::{full, illustrations, quick};
pub use page::Shown;
pub use report::Report;
pub use scenes::{benchmark, library_verdicts, scene_verdicts};

/// The claims of some topics, those that take minutes only with [`Tier::Full`].
pub fn claims_of(topics: &[Topic], tier: Tier) -> Vec<Claim> {
    let mut claims = quick();
    if tier == Tier::Full {
        claims.extend(full());
    }
    claims.retain(|claim| topics.contains(&claim.topic));
    claims
}
