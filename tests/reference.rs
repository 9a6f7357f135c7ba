//! The language reference in docs is the one the declarations give.

use tissue::scene::{explain, vocabulary};
use tissue::schema::reference;

/// Run with `UPDATE_REFERENCE=1` to write the file anew.
#[test]
fn the_reference_is_written_from_the_declarations() {
    let path = "docs/language.md";
    let written = reference(vocabulary());
    if std::env::var_os("UPDATE_REFERENCE").is_some() {
        std::fs::write(path, &written).expect("the file can be written");
    }
    let kept = std::fs::read_to_string(path).expect("the reference is in the repository");
    assert!(kept == written, "{path} is not what the declarations give: write it with UPDATE_REFERENCE=1");
}

#[test]
fn a_key_is_explained_with_its_choices() {
    insta::assert_snapshot!(explain("run.integrator").expect("a key of run"));
    insta::assert_snapshot!(explain("hold").expect("a block"));
    insta::assert_snapshot!(explain("displacement").expect("a word of several meanings"));
}

/// Each block's example is read, in its place, without a mistake of form.
#[test]
fn every_example_of_the_reference_can_be_pasted() {
    for block in vocabulary().blocks.iter().filter(|block| !block.example.is_empty()) {
        let example = block.example;
        let inner = match block.within {
            None => example.to_string(),
            Some(outer) => format!("{outer} example {{\n{example}\n}}"),
        };
        let text = format!("tissue 1\n{inner}\n");
        let (_, mistakes) = tissue::syntax::parse(&tissue::syntax::Source { name: "example".into(), text });
        assert!(mistakes.is_empty(), "{}: {mistakes:?}", block.word);
    }
}
