//! How a physical block declares its words.
//!
//! Owns the form of a declaration and the two things every declaration is good for whatever it
//! declares: finding the word that was meant and explaining a word. Does not know which blocks exist.

mod declaration;
mod explain;
mod reference;

pub use declaration::{Choice, Declaration, Kind, Member, Parameter, Presence, Target, Vocabulary, Word};
pub use explain::{explain, nearest};
pub use reference::reference;
