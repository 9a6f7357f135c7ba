//! `tissue explain`.

use super::Exit;
use super::arguments::ExplainOptions;
use crate::scene::vocabulary;
use crate::schema;

/// Prints what a word of the language means.
pub fn explain(options: &ExplainOptions) -> Exit {
    if let Some(text) = schema::explain(vocabulary(), &options.word) {
        say_on!("{text}");
        return Exit::Fine;
    }
    let words = vocabulary().all_words().map(|word| word.word);
    match schema::nearest(&options.word, words) {
        Some(near) => tell!("error: no word `{}` in the language; did you mean `{near}`?", options.word),
        None => tell!("error: no word `{}` in the language", options.word),
    }
    Exit::WrongInput
}
