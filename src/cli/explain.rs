//! `tissue explain`.

use super::Exit;
use super::arguments::ExplainOptions;
use crate::scene;

/// Prints what a word means.
pub fn explain(options: &ExplainOptions) -> Exit {
    let word = &options.word;
    if let Some(text) = scene::explain(word) {
        say_on!("{text}");
        return Exit::Fine;
    }
    match scene::nearest_word(word) {
        Some(near) => tell!("error: no word, unit, code or law `{word}`; did you mean `{near}`?"),
        None => tell!("error: no word, unit, code or law `{word}`"),
    }
    Exit::WrongInput
}
