//! Tests of reading.

use super::*;
use crate::syntax::tree::{BinaryOperator, Block, Entry, Expr, ExprKind, Item, UnaryOperator};

fn source(text: &str) -> Source {
    Source { name: "test.tissue".into(), text: text.into() }
}

/// An expression with all brackets written, numbers with their unit in angle brackets.
fn written(tree: &SyntaxTree, id: ExprId) -> String {
    let sub = |id: &ExprId| written(tree, *id);
    match &tree.expr(id).kind {
        ExprKind::Number { value, unit: None } => format!("{value}"),
        ExprKind::Number { value, unit: Some(unit) } => format!("{value}<{}>", unit.text),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Name(name) => name.clone(),
        ExprKind::Member { base, name } => format!("{}.{}", sub(base), name.text),
        ExprKind::Index { base, index } => format!("{}[{}]", sub(base), sub(index)),
        ExprKind::List(items) => format!("[{}]", items.iter().map(sub).collect::<Vec<_>>().join(", ")),
        ExprKind::Unary { operator: UnaryOperator::Minus, operand } => format!("(-{})", sub(operand)),
        ExprKind::Unary { operator: UnaryOperator::Plus, operand } => format!("(+{})", sub(operand)),
        ExprKind::Binary { operator, left, right, .. } => {
            format!("({} {operator:?} {})", sub(left), sub(right))
        }
        ExprKind::Binder { name, over } => format!("{} in {}", name.text, sub(over)),
        ExprKind::Call { function, arguments } => {
            let argument = |a: &crate::syntax::Argument| match &a.name {
                Some(path) => {
                    let parts: Vec<_> = path.parts.iter().map(|n| n.text.as_str()).collect();
                    format!("{} = {}", parts.join("."), sub(&a.value))
                }
                None => sub(&a.value),
            };
            format!("{}({})", function.text, arguments.iter().map(argument).collect::<Vec<_>>().join(", "))
        }
    }
}

fn value(text: &str) -> String {
    match parse_expression(&source(text)) {
        Ok((tree, id)) => written(&tree, id),
        Err(mistakes) => mistakes.iter().map(|m| m.render(&source(text))).collect(),
    }
}

fn block(text: &str) -> (SyntaxTree, Block) {
    let source = source(&format!("tissue 1\n{text}"));
    let (tree, mistakes) = parse(&source);
    let told: String = mistakes.iter().map(|m| m.render(&source)).collect();
    assert!(mistakes.is_empty(), "{told}");
    let [Item::Block(block)] = tree.items.as_slice() else { panic!("one block: {text}") };
    let block = block.clone();
    (tree, block)
}

#[test]
fn operators_bind_as_the_language_says() {
    assert_eq!(value("-x^2"), "(-(x Power 2))");
    assert_eq!(value("2^-1*4"), "((2 Power (-1)) Multiply 4)");
    assert_eq!(value("2^3^2"), "(2 Power (3 Power 2))");
    assert_eq!(value("2^-x^2"), "(2 Power (-(x Power 2)))");
    assert_eq!(value("a/b/c"), "((a Divide b) Divide c)");
    assert_eq!(value("a-b+c"), "((a Subtract b) Add c)");
    assert_eq!(value("-a*b"), "((-a) Multiply b)");
    assert_eq!(value("a*-b"), "(a Multiply (-b))");
    assert_eq!(value("--a"), "(-(-a))");
    assert_eq!(value("a + b < c*d"), "((a Add b) Less (c Multiply d))");
    assert_eq!(value("0 mm -> 1 mm"), "(0<mm> Arrow 1<mm>)");
    assert_eq!(value("0.85 .. 1+1"), "(0.85 Range (1 Add 1))");
    assert_eq!(value("1..n"), "(1 Range n)");
    assert_eq!(value("pull.F over 2*pull.d"), "(pull.F Over (2 Multiply pull.d))");
    assert_eq!(value("(a+b)*c"), "((a Add b) Multiply c)");
    assert_eq!(value("f(x).y[1]^2"), "(f(x).y[1] Power 2)");
}

#[test]
fn a_unit_binds_to_its_number_before_any_operator() {
    assert_eq!(value("pi*X/2 m"), "((pi Multiply X) Divide 2<m>)");
    assert_eq!(value("1 m/8"), "(1<m> Divide 8)");
    assert_eq!(value("2 m^2*3"), "(2<m^2> Multiply 3)");
    assert_eq!(value("-10 m/s * z/H"), "(((-10<m/s>) Multiply z) Divide H)");
    assert_eq!(value("1e-7 Pa^-1"), "0.0000001<Pa^-1>");
    assert_eq!(value("0.25mm"), "0.25<mm>");
    assert_eq!(value("0.5 % "), "0.5<%>");
    assert_eq!(value("2 m^(1/2)"), "2<m^(1/2)>");
    assert_eq!(value("2 m^x"), "(2<m> Power x)");
    assert_eq!(value("0 mm..1 mm"), "(0<mm> Range 1<mm>)");
    assert_eq!(value("a/2 over b"), "((a Divide 2) Over b)");
}

#[test]
fn entries_stand_side_by_side_without_separators() {
    let (tree, block) =
        block("run { until = 6 ms  cfl = 0.9  w = 2 over = 2 x = [1, 2]  hold a.b  c = 1 d { } }");
    let told: Vec<String> = block
        .entries
        .iter()
        .map(|entry| match entry {
            Entry::Assign { key, value, .. } => format!("{}={}", key.parts[0].text, written(&tree, *value)),
            Entry::Block(block) => format!("{}{{}}", block.kind.text),
            other => format!("{other:?}"),
        })
        .collect();
    assert_eq!(told, ["until=6<ms>", "cfl=0.9", "w=2", "over=2", "x=[1, 2]", "hold{}", "c=1", "d{}"]);
}

#[test]
fn a_parameter_has_a_dimension_a_range_a_default_and_a_documentation() {
    let (tree, block) = block(
        "energy e {\n  # above\n  param a : 1/pressure > 0 = 2 Pa^-1 # behind\n  param k in_ : number\n}"
            .replace("param k in_", "param k[n]")
            .replace("number\n}", "number in [0, 0.5)\n  param m : pressure in (-1 Pa, ]\n}")
            .as_str(),
    );
    let [a, k, m] = block.entries.as_slice() else { panic!("{block:?}") };
    let Entry::Parameter { dimension, bounds: Some(bounds), default: Some(default), doc, .. } = a else {
        panic!()
    };
    assert_eq!(written(&tree, *dimension), "(1 Divide pressure)");
    assert_eq!(bounds.lower.map(|(id, open)| (written(&tree, id), open)), Some(("0".into(), true)));
    assert_eq!((bounds.upper, written(&tree, *default)), (None, "2<Pa^-1>".into()));
    assert_eq!(doc, &["above", "behind"]);
    let Entry::Parameter { count: Some(count), bounds: Some(bounds), .. } = k else { panic!() };
    assert_eq!(count.text, "n");
    assert_eq!((bounds.lower.map(|b| b.1), bounds.upper.map(|b| b.1)), (Some(false), Some(true)));
    let Entry::Parameter { bounds: Some(bounds), .. } = m else { panic!() };
    assert_eq!((bounds.lower.map(|b| b.1), bounds.upper), (Some(true), None));
}

#[test]
fn an_expectation_has_a_claim_a_tolerance_and_a_place() {
    let (tree, block) = block(
        "scene s { expect pull.d == fe.d within 0.5 % at pull.F = [0.5 N, 1 N]\n expect at(b, 1) < 2 within 3\n expect x }",
    );
    let told: Vec<_> = block
        .entries
        .iter()
        .map(|entry| {
            let Entry::Expect { claim, within, at, .. } = entry else { panic!() };
            let at = at.as_ref().map(|at| (written(&tree, at.key), written(&tree, at.value)));
            (written(&tree, *claim), within.map(|id| written(&tree, id)), at)
        })
        .collect();
    assert_eq!(told[0].0, "(pull.d Equal fe.d)");
    assert_eq!(told[0].1.as_deref(), Some("0.5<%>"));
    assert_eq!(told[0].2, Some(("pull.F".into(), "[0.5<N>, 1<N>]".into())));
    assert_eq!((told[1].0.as_str(), told[1].1.as_deref()), ("(at(b, 1) Less 2)", Some("3")));
    assert_eq!(told[2], ("x".into(), None, None));
}

#[test]
fn greek_names_tabs_crlf_and_a_byte_order_mark_are_read() {
    let text = "\u{feff}tissue 1\r\n# über\r\nenergy ψ_α {\r\n\tlet λ₁ = 2 µm\r\n}\r\n";
    let (tree, mistakes) = parse(&source(text));
    assert_eq!(mistakes, []);
    let [Item::Block(block)] = tree.items.as_slice() else { panic!() };
    assert_eq!(block.doc, ["über"]);
    let Entry::Assign { key, keyword: Some(word), value, .. } = &block.entries[0] else { panic!() };
    assert_eq!((key.parts[0].text.as_str(), word.text.as_str()), ("λ₁", "let"));
    assert_eq!(&text[tree.expr(*value).span.clone()], "2 µm");
}

#[test]
fn spans_hold_what_was_written_and_no_blanks() {
    let text = "tissue 1\na { b = f( x , 2 kPa ) .y + ( c )  }\n";
    let (tree, mistakes) = parse(&source(text));
    assert_eq!(mistakes, []);
    let spans: Vec<&str> = tree.expressions.iter().map(|e| &text[e.span.clone()]).collect();
    assert_eq!(
        spans,
        ["x", "2 kPa", "f( x , 2 kPa )", "f( x , 2 kPa ) .y", "( c )", "f( x , 2 kPa ) .y + ( c )"]
    );
}

#[test]
fn children_come_before_parents_and_depths_add_up() {
    let (tree, _) = block("a { b = -f(x, [1, 2^3], i in 1 .. n)[0].c / 2 }");
    for (i, Expr { kind, depth, .. }) in tree.expressions.iter().enumerate() {
        let below: Vec<ExprId> = expression::children(kind).collect();
        assert!(below.iter().all(|id| (id.0 as usize) < i));
        let highest = below.iter().map(|id| tree.expr(*id).depth).max().unwrap_or(0);
        assert_eq!(*depth, highest + 1);
    }
}

#[test]
fn nesting_and_operator_chains_are_capped_at_the_stated_levels() {
    let brackets = |n: usize| format!("{}1{}", "(".repeat(n), ")".repeat(n));
    // Two levels are the wrapping block's and the expression's own.
    assert_eq!(value(&brackets(MAX_NESTING - 1)), "1");
    assert!(value(&brackets(MAX_NESTING)).contains("E0104"));
    let limit = MAX_EXPRESSION_DEPTH as usize;
    for (part, end) in [("-", "x"), ("2^", "x"), ("x+", "x"), ("a over ", "b")] {
        let chain = |n: usize| parse_expression(&source(&format!("{}{end}", part.repeat(n)))).map(|_| ());
        assert_eq!(chain(limit - 1), Ok(()), "{part}");
        let codes =
            |r: Result<(), Vec<Diagnostic>>| r.unwrap_err().iter().map(|m| m.code).collect::<Vec<_>>();
        assert_eq!(codes(chain(limit)), [Code::ExpressionTooDeep], "{part}");
        assert_eq!(codes(chain(90_000)), [Code::ExpressionTooDeep], "{part}");
    }
}

#[test]
fn a_bare_value_is_read_with_spans_of_its_own_text() {
    let (tree, id) = parse_expression(&source("0.25 mm + x")).unwrap();
    assert_eq!(tree.expr(id).span, 0..11);
    let ExprKind::Binary { operator: BinaryOperator::Add, at, left, .. } = &tree.expr(id).kind else {
        panic!()
    };
    assert_eq!((at.clone(), tree.expr(*left).span.clone()), (8..9, 0..7));
    for text in ["", "1 +", "2 3", "x y = 3", "1 } b { c = 2", "# comment"] {
        let mistakes = parse_expression(&source(text)).expect_err(text);
        assert!(mistakes.iter().flat_map(|m| &m.labels).all(|l| l.span.end <= text.len()), "{text}");
    }
}

#[test]
fn bytes_that_are_not_utf8_are_refused_with_their_place() {
    let mistake = decode("x.tissue", b"tissue 1\n\xff".to_vec()).unwrap_err();
    assert_eq!(mistake.message, "`x.tissue` is not UTF-8 text: byte 9, on line 2, is 0xff, in Latin-1 a `ÿ`");
    assert_eq!(decode("x", b"a".to_vec()).unwrap().text, "a");
}
