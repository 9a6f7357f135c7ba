//! Why the grammar could not go on, in words of the language.

use super::Failure;
use super::grammar::Rule;
use crate::syntax::code::Code;
use crate::syntax::diagnostic::Diagnostic;
use crate::syntax::scan::{Token, TokenKind};
use crate::syntax::tree::Span;

/// What surrounds the token at which reading stopped.
struct Context<'a> {
    text: &'a str,
    tokens: &'a [Token],
    /// Index of the token found; the number of tokens at the end of the file.
    found: usize,
    /// The innermost open bracket.
    open: Option<usize>,
}

/// Turns a failure of the grammar into a diagnostic.
pub(super) fn explain(text: &str, tokens: &[Token], failure: &Failure) -> Diagnostic {
    let found = tokens.partition_point(|t| t.span.end <= failure.at);
    let mut open = Vec::new();
    for (i, token) in tokens.iter().enumerate().take(found) {
        match token.kind {
            TokenKind::Open => open.push(i),
            TokenKind::Close => drop(open.pop()),
            _ => {}
        }
    }
    let context = Context { text, tokens, found, open: open.last().copied() };
    let reasons = [Context::foreign, Context::value, Context::parameter, Context::import];
    if let Some(mistake) = reasons.iter().find_map(|reason| reason(&context)) {
        return mistake;
    }
    let opener = context.open.map(|i| context.at(i));
    let special = match opener {
        Some("(" | "[") => context.inside_brackets(),
        Some(_) => context.inside_block(),
        None => context.top_level(),
    };
    special.unwrap_or_else(|| context.expected(&failure.expected))
}

impl<'a> Context<'a> {
    fn at(&self, i: usize) -> &'a str {
        self.tokens.get(i).map_or("", |t| t.text(self.text))
    }

    fn kind(&self, i: usize) -> Option<TokenKind> {
        self.tokens.get(i).map(|t| t.kind)
    }

    /// The text of the token `n` before the one found.
    fn before(&self, n: usize) -> &'a str {
        self.found.checked_sub(n).map_or("", |i| self.at(i))
    }

    fn before_kind(&self, n: usize) -> Option<TokenKind> {
        self.found.checked_sub(n).and_then(|i| self.kind(i))
    }

    fn span(&self, i: usize) -> Span {
        let end = self.text.trim_end().len();
        self.tokens.get(i).map_or(end..end, |t| t.span.clone())
    }

    fn found_span(&self) -> Span {
        self.span(self.found)
    }

    fn found_words(&self) -> String {
        match self.tokens.get(self.found) {
            Some(token) if token.span.len() > 40 => "this".into(),
            Some(token) => format!("`{}`", token.text(self.text)),
            None => "the end of the file".into(),
        }
    }

    /// Whether no blank stands before a token.
    fn touches(&self, i: usize) -> bool {
        i > 0 && self.span(i - 1).end == self.span(i).start
    }

    fn same_line(&self) -> bool {
        self.found > 0 && !self.text[self.span(self.found - 1).end..self.found_span().start].contains('\n')
    }

    fn here(&self, code: Code, message: String, label: &str) -> Diagnostic {
        Diagnostic::new(code, message, self.found_span(), label)
    }

    /// Habits from other languages.
    fn foreign(&self) -> Option<Diagnostic> {
        let (last, found) = (self.before(1), self.at(self.found));
        let touching = self.touches(self.found);
        let help = match (last, found) {
            ("*", "*") if touching => "write a power with `^`",
            ("/", "/" | "*") if touching => "a comment starts with `#`",
            (":", "=") if touching => "write `=`",
            (_, ":") if self.at(self.found + 1) == "=" && self.touches(self.found + 1) => "write `=`",
            (_, "+" | "-" | "*" | "/") if self.at(self.found + 1) == "=" && self.touches(self.found + 1) => {
                "there are no updates; give the value with `=`"
            }
            ("+" | "-" | "*" | "/", "=") if touching => "there are no updates; give the value with `=`",
            ("=", "==") | ("==", "=") => "a value is given with one `=`, equality is claimed with `==`",
            (_, ".") if self.before_kind(1) == Some(TokenKind::Number) => {
                "a decimal point stands between digits: `1.0`"
            }
            (_, ".") if self.kind(self.found + 1) == Some(TokenKind::Number) => {
                "a decimal point stands between digits: `0.5`"
            }
            (_, "·") => "outside units write a product as `*`",
            _ => return None,
        };
        let mistake =
            self.here(Code::UnexpectedToken, format!("{} cannot stand here", self.found_words()), "");
        Some(mistake.with_help(help))
    }

    /// Something that needs a value behind it stands last.
    fn value(&self) -> Option<Diagnostic> {
        let last = self.before(1);
        let needs = match self.before_kind(1)? {
            TokenKind::Symbol => !matches!(last, "%" | ":" | "." | "·"),
            TokenKind::Open => last != "{",
            TokenKind::Name => last == "within" && self.before_kind(2) != Some(TokenKind::Symbol),
            _ => false,
        };
        // A comma may stand last in a list; then something else is wrong.
        if !needs || self.open.is_some_and(|i| self.at(i) == "{") && last == "," {
            return None;
        }
        let message = format!("a value is missing after `{last}`, found {}", self.found_words());
        let next_entry = self.kind(self.found) == Some(TokenKind::Name);
        let label = if next_entry { "the next entry starts here" } else { "expected a value" };
        let mistake = self.here(Code::ExpectedValue, message, label);
        let help = match (last, self.at(self.found)) {
            ("=", "{") => Some("a block has no `=`: `name { … }`; a list stands in `[ ]`"),
            _ => None,
        };
        Some(match help {
            Some(help) => mistake.with_help(help),
            None if self.same_line() => mistake,
            None => mistake.with_label(self.span(self.found - 1), "a value must follow"),
        })
    }

    /// Inside `param …`.
    fn parameter(&self) -> Option<Diagnostic> {
        let form = "write for example `param kappa : number in [0, 1/3] = 0.226`";
        let message = if self.before(1) == "param" {
            format!("a parameter needs a name, found {}", self.found_words())
        } else if self.before(2) == "param" || self.before(1) == "]" && self.before(5) == "param" {
            format!("a parameter states its dimension behind `:`, found {}", self.found_words())
        } else if self.before(1) == ":" && self.before(3) == "param" {
            format!("a parameter needs a dimension, found {}", self.found_words())
        } else if self.at(self.found) == ":" && self.before_kind(1) == Some(TokenKind::Name) {
            let name = self.before(1);
            let message = "`:` stands only in a parameter, between its name and its dimension".to_string();
            let help = format!("write `{name} = …`, or `param {name} : number`");
            return Some(self.here(Code::UnexpectedToken, message, "").with_help(help));
        } else {
            return None;
        };
        Some(self.here(Code::ExpectedEntry, message, "").with_help(form))
    }

    /// Inside `import …`.
    fn import(&self) -> Option<Diagnostic> {
        let line = |n: usize| self.before(n) == "import";
        let opened = self.open.is_some_and(|i| (1..8).any(|n| i >= n && self.at(i - n) == "import"));
        let unopened =
            self.open.is_none() && (1..8).any(line) && self.before_kind(1) != Some(TokenKind::Close);
        if !opened && !unopened {
            return match (self.open, self.at(self.found), self.before(1)) {
                (Some(_), _, "import") => {
                    let (message, span) = ("an import stands outside of blocks", self.span(self.found - 1));
                    let mistake = Diagnostic::new(Code::UnexpectedToken, message, span, "inside a block");
                    Some(mistake.with_help("move it to the top of the file"))
                }
                _ => None,
            };
        }
        let message = format!("an import names what it takes, found {}", self.found_words());
        let help = "write `import std.energies { goh, vol_ogden2 }` or `import \"mine.tissue\" { gel }`";
        Some(self.here(Code::ExpectedEntry, message, "").with_help(help))
    }

    /// A value is complete, and what follows neither goes on with it nor ends it.
    fn inside_brackets(&self) -> Option<Diagnostic> {
        let opener = self.open.map(|i| self.at(i))?;
        let close = if opener == "(" { ")" } else { "]" };
        let found = self.kind(self.found)?;
        let named = found == TokenKind::Name && self.at(self.found + 1) == "=";
        if named {
            let message = format!("a comma is missing before {}", self.found_words());
            let mistake = self.here(Code::UnexpectedToken, message, "the next argument starts here");
            return Some(mistake.with_help(format!("write `, {} = …`", self.at(self.found))));
        }
        match found {
            TokenKind::Name | TokenKind::Number | TokenKind::Text | TokenKind::Open => {
                let message = format!("{} stands directly behind another value", self.found_words());
                let label = format!("expected an operator, `,` or `{close}`");
                Some(self.here(Code::MissingOperator, message, &label).with_help(self.juxtaposed()))
            }
            TokenKind::Symbol if self.at(self.found) == "=" => {
                let message = "`=` gives a value to a named argument of a call".to_string();
                let mistake = self.here(Code::UnexpectedToken, message, "not behind a name in a call");
                Some(mistake.with_help("compare with `==`"))
            }
            _ => None,
        }
    }

    fn juxtaposed(&self) -> String {
        let (last, found) = (self.before(1), self.at(self.found));
        if self.before_kind(1) == Some(TokenKind::Number) && self.kind(self.found) == Some(TokenKind::Name) {
            return format!("write a product as `{last}*{found}`; a unit stands on the line of its number");
        }
        "write a product as `*`, separate the parts of a list by `,`".into()
    }

    fn inside_block(&self) -> Option<Diagnostic> {
        let (last, found) = (self.before(1), self.at(self.found));
        let last_kind = self.before_kind(1)?;
        let ends_value = matches!(last_kind, TokenKind::Number | TokenKind::Text | TokenKind::Name)
            || matches!(last, ")" | "]" | "%");
        let mid_value = self.same_line() && ends_value && self.line_has_equals();
        match self.kind(self.found) {
            Some(TokenKind::Number | TokenKind::Text | TokenKind::Open) if mid_value && found != "{" => {
                let message = format!("{} stands directly behind another value", self.found_words());
                let help = match (last_kind, found) {
                    (_, "(" | "[") | (TokenKind::Number, _) => "write a product as `*`",
                    _ => "write a product as `*`, a list as `[a, b]`",
                };
                Some(
                    self.here(Code::MissingOperator, message, "expected an operator or the next entry")
                        .with_help(help),
                )
            }
            Some(TokenKind::Symbol) if found == "==" && last_kind == TokenKind::Name => {
                let message = "`==` claims equality, and only `expect` makes claims".to_string();
                Some(
                    self.here(Code::UnexpectedToken, message, "")
                        .with_help(format!("write `{last} = …` or `expect {last} == …`")),
                )
            }
            Some(TokenKind::Symbol) if found == "," => {
                let message = "entries of a block are not separated by commas".to_string();
                Some(
                    self.here(Code::UnexpectedToken, message, "")
                        .with_help("leave the comma out, or write a list as `[a, b]`"),
                )
            }
            Some(TokenKind::Symbol) if found == "=" && last_kind == TokenKind::Name => self.unknown_word(),
            Some(TokenKind::Symbol) if found == "=" && ends_value => {
                let message = "`=` gives a value to a name, and no name stands before it".to_string();
                Some(
                    self.here(Code::UnexpectedToken, message, "")
                        .with_help("compare with `==`, in an `expect`"),
                )
            }
            _ if last_kind == TokenKind::Name && !mid_value => {
                let message =
                    format!("`{last}` is no entry by itself, found {} behind it", self.found_words());
                let mistake = Diagnostic::new(
                    Code::ExpectedEntry,
                    message,
                    self.span(self.found - 1),
                    format!("expected `{last} = value` or `{last} {{ … }}`"),
                );
                Some(mistake)
            }
            Some(TokenKind::Number | TokenKind::Text | TokenKind::Symbol) | Some(TokenKind::Open) => {
                let message = format!("an entry starts with a name, found {}", self.found_words());
                let mistake = self.here(Code::ExpectedEntry, message, "");
                Some(mistake.with_help("write `key = value`, or `name { … }`"))
            }
            _ => None,
        }
    }

    /// `foo bar = 1`: two names before `=`, of which the first is no word of the grammar.
    fn unknown_word(&self) -> Option<Diagnostic> {
        if self.before_kind(2) != Some(TokenKind::Name) {
            return None;
        }
        const WORDS: [&str; 5] = ["let", "fibre", "direction", "vary", "param"];
        let (word, name) = (self.before(2), self.before(1));
        let message = format!("`{word} {name} = …` is no entry: no word `{word}` introduces a name");
        let near =
            WORDS.iter().min_by_key(|w| strsim::damerau_levenshtein(w, word)).copied().unwrap_or("let");
        let near = if strsim::damerau_levenshtein(near, word) <= 2 { near } else { "let" };
        let label = "expected `let`, `fibre`, `direction`, `vary` or nothing";
        let mistake = Diagnostic::new(Code::ExpectedEntry, message, self.span(self.found - 2), label);
        Some(mistake.with_help(format!("write `{near} {name} = …` or `{name} = …`")))
    }

    fn line_has_equals(&self) -> bool {
        let start = self.text[..self.found_span().start].rfind('\n').map_or(0, |n| n + 1);
        self.tokens[..self.found]
            .iter()
            .rev()
            .take_while(|t| t.span.start >= start)
            .any(|t| t.text(self.text) == "=")
    }

    fn top_level(&self) -> Option<Diagnostic> {
        let named = self.before_kind(1) == Some(TokenKind::Name);
        let (message, span) = if self.at(self.found) == "=" && named {
            (format!("`{} = …` stands outside of any block", self.before(1)), self.span(self.found - 1))
        } else if named {
            (format!("`{}` opens no block, found {}", self.before(1), self.found_words()), self.found_span())
        } else {
            (
                format!("a file consists of imports and blocks, found {}", self.found_words()),
                self.found_span(),
            )
        };
        let mistake = Diagnostic::new(Code::ExpectedEntry, message, span, "expected a block or an import");
        Some(mistake.with_help("write for example `material gel { … }`"))
    }

    /// What the grammar would have taken, in words.
    fn expected(&self, rules: &[Rule]) -> Diagnostic {
        let mut words: Vec<&str> = rules.iter().filter_map(|rule| word(*rule)).collect();
        words.sort_unstable();
        words.dedup();
        let list = match words.as_slice() {
            [] => "something else".to_string(),
            [one] => (*one).to_string(),
            [rest @ .., last] => format!("{} or {last}", rest.join(", ")),
        };
        self.here(
            Code::UnexpectedToken,
            format!("{} cannot stand here", self.found_words()),
            &format!("expected {list}"),
        )
    }
}

/// A rule in words; `None` for what needs no mention.
fn word(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::open_brace => "`{`",
        Rule::close_brace => "`}`",
        Rule::open_paren | Rule::lower_end => "`(`",
        Rule::close_paren => "`)`",
        Rule::open_list | Rule::index => "`[`",
        Rule::close_list | Rule::upper_end => "`]`",
        Rule::comma => "`,`",
        Rule::colon => "`:`",
        Rule::equals | Rule::default => "`=`",
        Rule::in_word => "`in`",
        Rule::within | Rule::within_word => "`within`",
        Rule::at | Rule::at_word => "`at`",
        Rule::operator | Rule::sum_operator | Rule::product_operator | Rule::over | Rule::bound_operator => {
            "an operator"
        }
        Rule::name | Rule::path | Rule::reference => "a name",
        Rule::number | Rule::decimal | Rule::version_number => "a number",
        Rule::unit => "a unit",
        Rule::text => "a text in quotes",
        Rule::expression
        | Rule::bound
        | Rule::group
        | Rule::list
        | Rule::call
        | Rule::named
        | Rule::binder => "a value",
        Rule::dimension => "a dimension",
        Rule::bounds | Rule::interval => "a range",
        Rule::import => "an import",
        Rule::block | Rule::head => "a block",
        Rule::assignment | Rule::binding | Rule::parameter | Rule::expectation | Rule::statement => {
            "an entry"
        }
        Rule::EOI => "the end of the file",
        _ => return None,
    })
}
