//! The description a plan is made from: no text but names, all numbers SI, all dimensions proved.

mod body;
mod document;
mod drive;
mod expectation;
mod figure;
mod fit;
mod material;
mod probe;
mod record;
mod run;
mod scene;
mod shown;
mod sweep;

pub use body::*;
pub use document::*;
pub use drive::*;
pub use expectation::*;
pub use figure::*;
pub use fit::*;
pub use material::*;
pub use probe::*;
pub use record::*;
pub use run::*;
pub use scene::*;
pub use shown::*;
pub use sweep::*;
