//! The entries of a block, sorted by what they are and held against its declaration.
//!
//! Owns unknown, missing and repeated entries. Knows no values.

mod entries;
mod overrides;
mod parameter;
pub(super) mod within;

pub(super) use entries::{ExpectEntry, Members, ParamEntry, ParameterDef, Site, VaryEntry, duplicate};
pub(super) use overrides::{COMMAND_LINE, Overrides, ambiguous};
