//! Tests of the formatter.

use super::*;

fn formatted(text: &str) -> String {
    let source = Source { name: "x".into(), text: text.into() };
    let once = format(&source).unwrap_or_else(|m| panic!("{}", m[0].render(&source)));
    let again = format(&Source { name: "x".into(), text: once.clone() }).expect("what is formatted is read");
    assert_eq!(again, once, "formatting again changes nothing");
    once
}

#[test]
fn blanks_are_given_between_tokens_and_taken_within() {
    let text =
        "\u{feff}tissue   1\r\n\r\n\r\n\r\nscene s{\r\n\ta=( 1+2 ) *x^ -2  b = f (x ,y=3kPa)\r\n\r\n}\r\n";
    assert_eq!(formatted(text), "tissue 1\n\nscene s {\n  a = (1 + 2) * x^-2  b = f(x, y = 3 kPa)\n}\n");
}

#[test]
fn entries_in_following_lines_are_aligned() {
    let text = "tissue 1\nenergy e {\n  param C:pressure>=0=1 kPa # c\n  param kappa : number in [0,1/3]\n  fibres a\n  \
                let E(a)=1\n  psi = C\n  longer = 2\n    + 3*[1,\n 2]\n\n  k = 1\n}\n";
    let expected = "\
tissue 1
energy e {
  param C     : pressure >= 0 = 1 kPa  # c
  param kappa : number   in [0, 1/3]
  fibres a
  let E(a) = 1
  psi    = C
  longer = 2
         + 3*[1,
              2]

  k = 1
}
";
    assert_eq!(formatted(text), expected);
}

#[test]
fn comments_stay_on_their_lines_and_in_their_columns() {
    let text = "# first\ntissue 1 # version\n\n  # of the block\nbody b # head\n{ # open\n a = 1        # far\n# own\n bb=2# near\n\
                c = f( # in\n  1, # one\n  2 )\n # last\n}\n# end";
    let expected = "\
# first
tissue 1  # version

# of the block
body b  # head
{  # open
  a = 1       # far
  # own
  bb = 2  # near
  c  = f(  # in
    1,  # one
    2)
  # last
}
# end
";
    assert_eq!(formatted(text), expected);
}

#[test]
fn a_file_with_mistakes_is_not_formatted() {
    let source = Source { name: "x".into(), text: "tissue 1\na { b = }\n".into() };
    assert_eq!(format(&source).map_err(|m| m.len()), Err(1));
}

#[test]
fn parameters_align_their_dimension_their_range_and_their_default() {
    let text =
        "tissue 1\nm a {\n param E : pressure > 0 = 50.05 kPa\n param nu:number in [0,0.5)= 0.499\n}\n";
    let expected = "\
tissue 1
m a {
  param E  : pressure > 0         = 50.05 kPa
  param nu : number   in [0, 0.5) = 0.499
}
";
    assert_eq!(formatted(text), expected);
}

#[test]
fn a_power_of_a_quantity_does_not_become_a_power_of_its_unit() {
    assert_eq!(
        formatted("tissue 1\na { b = 2 m ^x  c = 2 m ^ 2 d=2 m^2 }"),
        "tissue 1\na { b = 2 m ^ x  c = 2 m ^ 2  d = 2 m^2 }\n"
    );
}
