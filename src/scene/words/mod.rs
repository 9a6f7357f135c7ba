//! The words of the language: one table per block, beside the words of expressions.
//!
//! Owns what checking, "did you mean", `explain` and the reference are generated from. Knows no
//! syntax and no values.

mod body;
mod check;
mod drive;
mod explain;
mod expressions;
mod figure;
mod fit;
mod later;
mod law;
mod load;
mod motion;
mod observe;
mod run;
mod sweep;

use crate::schema::{Declaration, Vocabulary};

pub(super) use body::{BODY, BOND, SYMMETRY};
pub(super) use check::{CHECK, CHECK_WORDS};
pub(super) use drive::{DRIVE, PATHS, POINT_RECORD, POINT_WORDS};
pub use explain::{explain, nearest_word};
pub(super) use expressions::{
    ENERGY_WORDS, FIELD_WORDS, FILE_SHAPES, FUNCTIONS, PLACE_WORDS, PROBES, SAMPLES, SHAPES,
};
pub(super) use figure::{BAND, DIMENSION, DISC, FIGURE, NOTE, OUTLINE, PANEL, SERIES, SERIES_WORDS, SOURCE};
pub(super) use fit::{FIT, FIT_WORDS};
pub(super) use law::{ENERGY, FRAME, MATERIAL, SCENE};
pub(super) use load::{BODY_FORCE, GRAVITY, HOLD, MOVE, PRESSURE, PULL, SLIDE, START, TRACTION};
pub(super) use motion::MOTION;
pub(super) use observe::{FRAMES, PLOT, RECORD};
pub(super) use run::RUN;
pub(super) use sweep::{SWEEP, SWEEP_PLOT, SWEEP_RECORD, SWEEP_WORDS, TRADE};

static BLOCKS: &[&Declaration] = &[
    &ENERGY,
    &MATERIAL,
    &FRAME,
    &SCENE,
    &BODY,
    &SYMMETRY,
    &BOND,
    &HOLD,
    &SLIDE,
    &PULL,
    &MOVE,
    &TRACTION,
    &PRESSURE,
    &BODY_FORCE,
    &GRAVITY,
    &START,
    &RUN,
    &RECORD,
    &FRAMES,
    &PLOT,
    &SERIES,
    &BAND,
    &PANEL,
    &OUTLINE,
    &DISC,
    &DIMENSION,
    &NOTE,
    &FIGURE,
    &SOURCE,
    &observe::FIGURE_PLOT,
    &DRIVE,
    &POINT_RECORD,
    &drive::POINT_PLOT,
    &SWEEP,
    &SWEEP_RECORD,
    &SWEEP_PLOT,
    &TRADE,
    &CHECK,
    &FIT,
    &MOTION,
];

static VOCABULARY: Vocabulary = Vocabulary {
    blocks: BLOCKS,
    words: &[
        FUNCTIONS,
        ENERGY_WORDS,
        PLACE_WORDS,
        SHAPES,
        FILE_SHAPES,
        PROBES,
        FIELD_WORDS,
        SAMPLES,
        PATHS,
        POINT_WORDS,
        SWEEP_WORDS,
        SERIES_WORDS,
        FIT_WORDS,
        CHECK_WORDS,
        later::STATEMENTS,
    ],
};

/// The words of this version of the language.
pub fn vocabulary() -> &'static Vocabulary {
    &VOCABULARY
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::explain;

    #[test]
    fn every_block_key_and_word_can_be_explained() {
        for block in vocabulary().blocks {
            assert!(explain(vocabulary(), block.word).is_some_and(|text| text.contains(block.doc)));
            for key in block.keys {
                let text = explain(vocabulary(), &format!("{}.{}", block.word, key.name))
                    .expect("a key is explained");
                assert!(text.contains(key.doc), "{text}");
            }
        }
        for word in vocabulary().all_words() {
            assert!(explain(vocabulary(), word.word).is_some_and(|text| text.contains(word.doc)));
        }
        assert_eq!(explain(vocabulary(), "no_such_word"), None);
    }

    #[test]
    fn no_block_declares_a_key_twice() {
        for block in vocabulary().blocks {
            for (index, key) in block.keys.iter().enumerate() {
                assert!(
                    block.keys[..index].iter().all(|other| other.name != key.name),
                    "{}.{}",
                    block.word,
                    key.name
                );
            }
        }
    }
}
