//! Tests of the drawing of diagnostics.

use super::*;
use proptest::prelude::*;

fn source(text: &str) -> Source {
    Source { name: "specs/artery.tissue".into(), text: text.into() }
}

#[test]
fn a_wrong_dimension_says_what_was_found_what_was_required_and_what_to_write() {
    let text = "material media {\n  K1 = 996.6 mm\n}\n";
    let source = source(text);
    let at = text.find("996.6 mm").expect("the literal is in the text");
    let diagnostic = Diagnostic {
        code: Code::WrongDimension,
        message: "`K1` is a length, but a stress is required".into(),
        labels: vec![Label { span: at..at + 8, text: "length".into() }],
        help: Some("write a stress, for example `996.6 kPa`".into()),
    };
    insta::assert_snapshot!(diagnostic.render(&source), @r"
    error[E0301]: `K1` is a length, but a stress is required
     --> specs/artery.tissue:2:8
      |
    2 |   K1 = 996.6 mm
      |        ^^^^^^^^ length
    help: write a stress, for example `996.6 kPa`
    ");
}

#[test]
fn columns_are_right_behind_greek_letters_tabs_and_crlf() {
    let text = "tissue 1\r\n\tλ₁ = σ µ\r\n";
    let at = text.find('µ').expect("in the text");
    let diagnostic = Diagnostic::new(Code::UnknownName, "no `µ`", at..at + 2, "here");
    insta::assert_snapshot!(diagnostic.render(&source(text)), @r"
    error[E0203]: no `µ`
     --> specs/artery.tissue:2:9
      |
    2 |     λ₁ = σ µ
      |            ^ here
    help: write a name that is declared, or declare this one with `let`
    ");
    let json = diagnostic.to_json(&source(text));
    assert_eq!(json["labels"][0]["start"], json!({ "line": 2, "column": 9 }));
    assert_eq!(json["labels"][0]["bytes"], json!([at, at + 2]));
}

#[test]
fn two_marks_on_two_lines_are_both_drawn() {
    let text = "a = 1\nb = 2\n\n\n\n\n\n\n\n\n\n\na = 3\n";
    let second = text.rfind('a').expect("in the text");
    let diagnostic =
        Diagnostic::new(Code::DuplicateName, "`a` is declared twice", second..second + 1, "again here")
            .with_label(0..1, "first here")
            .with_help("give one of them another name");
    insta::assert_snapshot!(diagnostic.render(&source(text)), @r"
    error[E0204]: `a` is declared twice
      --> specs/artery.tissue:13:1
       |
     1 | a = 1
       | - first here
    ...
    13 | a = 3
       | ^ again here
    help: give one of them another name
    ");
}

#[test]
fn a_diagnostic_without_a_place_is_its_message_and_help() {
    let diagnostic =
        Diagnostic { code: Code::FileTooLarge, message: "too large".into(), labels: vec![], help: None };
    assert_eq!(
        diagnostic.render(&source("")),
        "error[E0103]: too large\nhelp: split the file and `import` its parts\n"
    );
}

proptest! {
    #[test]
    fn any_span_on_any_text_is_drawn_without_panic(
        text in "[\\x00-\\x7fα-ωµ漢\u{feff}\u{200d}\u{301}\r\n\t]{0,60}",
        spans in prop::collection::vec((0usize..80, 0usize..80), 0..4),
    ) {
        let labels = spans.iter().map(|&(start, end)| Label::new(start..end, "here")).collect();
        let diagnostic = Diagnostic { code: Code::Conflict, message: "m".into(), labels, help: None };
        let source = source(&text);
        prop_assert!(diagnostic.render(&source).starts_with("error[E0501]: m\n"));
        diagnostic.to_json(&source);
    }
}
