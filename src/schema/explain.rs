//! The word that was meant, and what a word means.

use super::{Choice, Declaration, Kind, Parameter, Presence, Target, Vocabulary, Word};

/// The candidate nearest to a word that is not known, if one is near enough to be meant.
///
/// Near enough are at most one edit in three letters, so `kapa` finds `kappa` and `xmx` finds `xmax`,
/// but `a` does not find `b`. Of equally near candidates the first is taken.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let allowed = word.chars().count().div_ceil(3).min(3);
    let lower = word.to_lowercase();
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let distance = strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
        let longest = word.chars().count().max(candidate.chars().count());
        if distance <= allowed && distance < longest && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// What a word means: a block, a key (`run.cfl` or `cfl`), a choice or a word of expressions.
///
/// A word with several meanings gets all of them. `None` if it has none.
pub fn explain(vocabulary: &Vocabulary, word: &str) -> Option<String> {
    let mut parts = Vec::new();
    for block in vocabulary.blocks {
        if block.word == word {
            parts.push(explain_block(block));
        }
        for key in block.keys {
            if key.name == word
                || word.strip_prefix(block.word).is_some_and(|rest| rest == format!(".{}", key.name))
            {
                parts.push(format!("{} (key of `{}`)\n{}", key.name, block.word, explain_key(key)));
            }
            if let Kind::Choice(choices) | Kind::Choices(choices) = key.kind {
                parts.extend(choices.iter().filter(|choice| choice.word == word).map(|choice| {
                    format!("{word} (choice of `{}.{}`)\n  {}\n", block.word, key.name, choice.doc)
                }));
            }
        }
    }
    parts.extend(vocabulary.all_words().filter(|entry| entry.word == word).map(explain_word));
    (!parts.is_empty()).then(|| parts.join("\n"))
}

fn explain_block(block: &Declaration) -> String {
    let target = match block.target {
        Target::Absent => "",
        Target::Name => " NAME",
        Target::Material => " MATERIAL",
        Target::Body => " BODY",
        Target::Face => " BODY.FACE",
    };
    let place = block.within.map_or("at the top of a file".to_string(), |outer| format!("in `{outer}`"));
    let mut text = format!("{}{target} {{ … }} ({place})\n  {}\n", block.word, block.doc);
    if !block.available {
        text.push_str("  Not yet carried out by this version.\n");
    }
    for key in block.keys {
        text.push_str(&format!("\n  {}\n{}", key.name, indent(&explain_key(key))));
    }
    if !block.example.is_empty() {
        text.push_str(&format!("\n  for example\n{}", indent(&indent(&format!("{}\n", block.example)))));
    }
    text
}

fn explain_key(key: &Parameter) -> String {
    let mut text = format!("  {}\n  value: {}\n", key.doc, kind_text(key.kind));
    text.push_str(&format!("  without it: {}\n", presence_text(key.presence)));
    if let Kind::Choice(choices) | Kind::Choices(choices) = key.kind {
        for Choice { word, doc } in choices {
            text.push_str(&format!("    {word}: {doc}\n"));
        }
    }
    text
}

fn explain_word(entry: &Word) -> String {
    format!("{} ({})\n  {}\n", entry.form, entry.context, entry.doc)
}

/// What holds if a key is not written, in words.
pub(super) fn presence_text(presence: Presence) -> String {
    match presence {
        Presence::Required(example) => format!("refused; for example `{example}`"),
        Presence::Default(value) => value.into(),
        Presence::ByScheme { seed, improved } => {
            format!("{seed} (scheme = seed), {improved} (scheme = improved)")
        }
    }
}

/// What the value of a key is, in words.
pub(super) fn kind_text(kind: Kind) -> String {
    let words = |choices: &[Choice]| choices.iter().map(|choice| choice.word).collect::<Vec<_>>().join(", ");
    match kind {
        Kind::Quantity("number") => "a number".into(),
        Kind::Quantity(dimension) => format!("a quantity of dimension {dimension}"),
        Kind::Field(dimension) => {
            format!("a quantity of dimension {dimension}, may depend on place and time")
        }
        Kind::Vector(dimension) => format!("three components [x, y, z], each of dimension {dimension}"),
        Kind::VectorField(dimension) => {
            format!("three components [x, y, z], each of dimension {dimension}, may depend on place and time")
        }
        Kind::Count => "a whole number".into(),
        Kind::Choice(choices) => format!("one of {}", words(choices)),
        Kind::Choices(choices) => format!("a list of {}", words(choices)),
        Kind::Material => "the name of a material".into(),
        Kind::Shape => "a shape, such as box(10 mm, 3 mm, 0.5 mm)".into(),
        Kind::Energy => "an energy with its parameters, or a sum of several".into(),
        Kind::Curve => "record.column over record.column, or a list of such".into(),
        Kind::Text => "a text in quotes".into(),
        Kind::Range => "two quantities, [low, high]".into(),
        Kind::Settings => "values by path, such as set(strip.spacing = 0.5 mm)".into(),
        Kind::Expression => "an expression".into(),
    }
}

fn indent(text: &str) -> String {
    text.lines().map(|line| if line.is_empty() { "\n".into() } else { format!("  {line}\n") }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_word_finds_the_one_that_was_meant() {
        assert_eq!(nearest("kapa", ["C", "k1", "kappa"]), Some("kappa"));
        assert_eq!(nearest("xmx", ["xmin", "xmax"]), Some("xmax"));
        assert_eq!(nearest("spaceing", ["shape", "spacing"]), Some("spacing"));
        assert_eq!(nearest("i1bar", ["I1", "I1bar"]), Some("I1bar"));
    }

    #[test]
    fn an_unrelated_word_finds_nothing() {
        assert_eq!(nearest("viscosity", ["shape", "spacing", "material"]), None);
        assert_eq!(nearest("a", ["b", "C"]), None);
    }
}
