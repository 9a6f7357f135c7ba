//! What each mistake of form is told, drawn.

use super::*;

/// A text of mistakes in one block, and how they are drawn.
fn told(entries: &str) -> String {
    let text = format!("tissue 1\nscene s {{\n{entries}}}\n");
    let source = Source { name: "scene.tissue".into(), text };
    let (_, mistakes) = parse(&source);
    assert!(!mistakes.is_empty(), "{entries}");
    mistakes.iter().map(|m| m.render(&source) + "\n").collect()
}

macro_rules! mistakes {
    ($($name:ident: $text:expr;)*) => {$(
        #[test]
        fn $name() {
            insta::assert_snapshot!(told($text));
        }
    )*};
}

mistakes! {
    values_that_are_missing: "  a = \n  b = 3\n  c = 3 +\n  d = [1, *]\n  e = f(x = )\n  expect a <\n";
    values_side_by_side: "  a = 2 3\n  b = (2 x y)\n  c = [1 2]\n  d = goh(C = 1 kPa k = 2)\n  e = \"a\" \"b\"\n  f = 2 (3)\n";
    entries_that_are_none: "  foo bar = 1\n  lett w = 2\n  hold\n  a == 3\n  b : 4\n  c = 1,\n  4\n  d = {1}\n  d += 2\n";
    parameters_without_their_parts: "  param a = 3\n  param : number\n  param b :\n  param c : pressure <= \n";
    habits_from_other_languages: "  a = 1 **2\n  b = 2 // note\n  c := 3\n  d = 1.\n  e = .5\n  f = x && y\n  g = 1; h = 2\n  i = x²\n";
    imports_and_letters_in_the_wrong_place: "  import a { b }\n  a = “x”\n  b = 3 × 2\n  c = 4 °\n  d = \"abc\n";
    brackets_that_do_not_match: "  a = (1 + 2\n  b = 3\n";
    chains_of_calls: "  a = f(x) = 3\n  b = f(x = 1 = 2)\n  c = sum(i of n, i)\n  d = f(,)\n";
}

#[test]
fn a_mistake_in_one_block_hides_none_in_another() {
    let text = "tissue 1\na = 1\nscene s {\n  b = \n}\nbody t {\n  c = 1 2\n  ok = 3\n}\nimport x\n";
    let source = Source { name: "scene.tissue".into(), text: text.into() };
    let (tree, mistakes) = parse(&source);
    let codes: Vec<&str> = mistakes.iter().map(|m| m.code.number()).collect();
    assert_eq!(codes, ["E0114", "E0111", "E0112", "E0114"]);
    assert_eq!(tree.items.len(), 2, "both blocks are read");
}

#[test]
fn the_mistakes_of_a_file_are_counted_up_to_a_limit() {
    let text = format!("tissue 1\na {{\n{}}}\n", "  b = \n".repeat(200));
    let (_, mistakes) = parse(&Source { name: "x".into(), text });
    assert_eq!(mistakes.len(), MAX_MISTAKES + 1);
    assert_eq!(mistakes.last().map(|m| m.code), Some(Code::TooManyMistakes));
}
