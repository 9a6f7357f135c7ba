//! Tests of the unit symbols.

use super::*;
use proptest::prelude::*;

fn si(text: &str) -> (f64, Dimension) {
    let unit = parse_unit(text).unwrap_or_else(|e| panic!("{text}: {e}"));
    (unit.factor(), unit.dimension)
}

#[test]
fn units_have_their_textbook_values() {
    assert_eq!(si("kPa"), (1e3, Dimension::PRESSURE));
    assert_eq!(si("kg/m^3"), (1.0, Dimension::DENSITY));
    assert_eq!(si("g/cm^3"), (1e3, Dimension::DENSITY));
    assert_eq!(si("Pa^-1"), (1.0, Dimension::PRESSURE.recip()));
    assert_eq!(si("1/MPa"), (1e-6, Dimension::PRESSURE.recip()));
    assert_eq!(si("N/mm^2"), si("MPa"));
    assert_eq!(si("kg*m/s^2"), si("N"));
    assert_eq!(si("N·s"), si("kg*m/s"));
    assert_eq!(si("t/mm^3"), (1e12, Dimension::DENSITY));
    assert_eq!(si("m^(1/2)"), (1.0, Dimension::LENGTH.sqrt()));
    assert_eq!(si("µm"), si("um"));
    assert_eq!(si("μm"), si("um"));
    assert_eq!(si("%"), (1e-2, Dimension::NUMBER));
    assert_eq!(si("min"), (60.0, Dimension::TIME));
    assert_eq!(si("dyn/cm^2"), (0.1, Dimension::PRESSURE));
}

#[test]
fn non_decimal_units_agree_with_their_definitions() {
    // NIST SP 811, table B.8: 1 psi = 6.894757 kPa, 1 mmHg = 133.3224 Pa, to the digits printed.
    assert!((si("psi").0 - 6894.757).abs() < 5e-4);
    assert!((si("mmHg").0 - 133.3224).abs() < 5e-5);
    assert!((si("deg").0 * 180.0 - std::f64::consts::PI).abs() < 1e-15);
}

#[test]
fn division_binds_to_the_next_symbol_only() {
    assert_eq!(si("m/s*kg"), si("kg*m/s"));
    assert_ne!(si("m/s*kg").1, si("m/s/kg").1);
}

#[test]
fn every_listed_symbol_is_a_unit_and_every_row_with_its_prefixes_is_listed() {
    for symbol in unit_symbols() {
        assert!(lookup(symbol).is_some(), "{symbol}");
    }
    for row in ROWS {
        assert!(unit_symbols().contains(&row.0), "{}", row.0);
        for prefix in row.4.iter().filter(|p| p.is_ascii()) {
            let symbol = format!("{prefix}{}", row.0);
            assert!(unit_symbols().contains(&symbol.as_str()), "{symbol}");
        }
    }
}

#[test]
fn an_unknown_symbol_is_named_with_the_nearest_one() {
    let suggestion = |text: &str| match parse_unit(text) {
        Err(UnitError::Unknown { symbol, offset, suggestion }) => (symbol, offset, suggestion),
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(suggestion("kpa"), ("kpa".into(), 0, Some("kPa")));
    assert_eq!(suggestion("kg/mtr"), ("mtr".into(), 3, None));
    assert_eq!(suggestion("N/metres"), ("metres".into(), 2, Some("m")));
    assert_eq!(suggestion("kPaa").2, Some("kPa"));
    assert_eq!(suggestion("Kg").2, Some("kg"));
    assert_eq!(suggestion("qwerty").2, None);
}

#[test]
fn what_is_not_a_product_of_powers_is_refused_with_its_place() {
    for (text, offset) in [("", 0), ("m/", 2), ("m^", 2), ("m^x", 2), ("m^(1/0)", 2), ("m s", 1), ("m^(1", 2)]
    {
        assert_eq!(parse_unit(text), Err(UnitError::Malformed { offset }), "{text}");
    }
    assert_eq!(parse_unit("km^999"), Err(UnitError::OutOfRange));
}

#[test]
fn three_hundredths_of_a_millisecond_are_rounded_once() {
    let ms = parse_unit("ms").unwrap();
    assert_eq!(ms.to_si(0.03), 3e-5);
    assert_eq!(ms.to_si(-0.03), -3e-5);
    // control: dividing rounds a second time
    assert_ne!(0.03 / 1e3, 3e-5);
    assert_eq!((ms.to_si(0.0), ms.to_si(f64::INFINITY)), (0.0, f64::INFINITY));
    assert!(ms.to_si(f64::NAN).is_nan());
    assert_eq!((ms.to_si(f64::MIN_POSITIVE), ms.to_si(5e-324)), (f64::MIN_POSITIVE / 1e3, 0.0));
}

proptest! {
    // The literal with the power of ten written out is what the reader of decimals rounds once.
    #[test]
    fn a_decimal_unit_rounds_like_the_number_with_its_exponent(digits in 1u32..100_000, shift in 0i32..5) {
        let value: f64 = format!("{digits}e-{shift}").parse().unwrap();
        let whole = f64::from(digits);
        for (unit, ten) in [("mm", -3), ("um", -6), ("kPa", 3), ("GPa", 9), ("mm^2", -6), ("mm^3", -9)] {
            let literal: f64 = format!("{digits}e{ten}").parse().unwrap();
            prop_assert_eq!(parse_unit(unit).unwrap().to_si(whole), literal);
            let literal: f64 = format!("{digits}e{}", ten - shift).parse().unwrap();
            prop_assert_eq!(parse_unit(unit).unwrap().to_si(value), literal);
        }
    }

    #[test]
    fn any_text_is_read_or_refused_without_panic(text in "\\PC{0,20}|[a-zA-Z/*^()0-9%-]{0,12}") {
        if let Ok(unit) = parse_unit(&text) {
            prop_assert!(unit.factor().is_normal());
        }
    }
}
