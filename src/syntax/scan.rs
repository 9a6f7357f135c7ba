//! Text to tokens, without grammar.
//!
//! Owns the lexical mistakes and what needs the text as a whole before the grammar sees it: brackets,
//! comments, the places where reading can resume. The grammar reads the text itself, not these tokens.

use super::code::Code;
use super::diagnostic::Diagnostic;
use super::tree::Span;

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TokenKind {
    /// An identifier or word.
    Name,
    /// A number without its unit.
    Number,
    /// A text in quotes.
    Text,
    /// An operator, comma, colon or point.
    Symbol,
    /// `(`, `[` or `{`.
    Open,
    /// `)`, `]` or `}`.
    Close,
    /// From `#` to the end of the line.
    Comment,
}

/// A token and its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

impl Token {
    /// Its text.
    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        &source[self.span.clone()]
    }
}

/// The tokens of a text, comments included, and what is no token.
#[derive(Debug, Default)]
pub(super) struct Scan {
    /// Tokens in order.
    pub tokens: Vec<Token>,
    /// Lexical mistakes in order.
    pub mistakes: Vec<Diagnostic>,
    /// Ranges to be read as blanks.
    pub blanked: Vec<Span>,
    /// Texts that lack their closing quote.
    pub unclosed: Vec<Span>,
}

/// Whether a character can start an identifier.
pub(super) fn starts_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// Whether a character can continue an identifier.
pub(super) fn continues_name(c: char) -> bool {
    starts_name(c) || c.is_ascii_digit() || ('\u{2080}'..='\u{2089}').contains(&c)
}

/// Splits a text into tokens.
pub(super) fn scan(text: &str) -> Scan {
    let mut scan = Scan::default();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let width = |f: fn(char) -> bool| rest.find(|c| !f(c)).unwrap_or(rest.len());
        let (kind, length) = match c {
            ' ' | '\t' | '\r' | '\n' => {
                at += 1;
                continue;
            }
            '\u{feff}' if at == 0 => {
                scan.blanked.push(0..c.len_utf8());
                at += c.len_utf8();
                continue;
            }
            '#' => (TokenKind::Comment, rest.find('\n').unwrap_or(rest.len())),
            '"' => match text_length(rest) {
                Some(length) => (TokenKind::Text, length),
                None => {
                    let length = unclosed_length(rest);
                    scan.unclosed_text(at..at + length);
                    (TokenKind::Text, length)
                }
            },
            '(' | '[' | '{' => (TokenKind::Open, 1),
            ')' | ']' | '}' => (TokenKind::Close, 1),
            _ if c.is_ascii_digit() => (TokenKind::Number, number_length(rest)),
            _ if starts_name(c) => (TokenKind::Name, width(continues_name)),
            _ => match symbol_length(rest) {
                0 => {
                    let length = rest.find(is_known).unwrap_or(rest.len()).max(c.len_utf8());
                    scan.unknown(text, at..at + length);
                    at += length;
                    continue;
                }
                length => (TokenKind::Symbol, length),
            },
        };
        scan.tokens.push(Token { kind, span: at..at + length });
        at += length;
    }
    scan
}

/// Whether a character can belong to some token or be a blank.
fn is_known(c: char) -> bool {
    continues_name(c) || " \t\r\n#\"()[]{}".contains(c) || symbol_length(c.encode_utf8(&mut [0; 4])) > 0
}

fn symbol_length(rest: &str) -> usize {
    const TWO: [&str; 6] = ["->", "==", "!=", "<=", ">=", ".."];
    if TWO.iter().any(|s| rest.starts_with(s)) {
        return 2;
    }
    let c = rest.chars().next().unwrap_or(' ');
    if "=<>+-*/^,.:%·".contains(c) { c.len_utf8() } else { 0 }
}

fn number_length(rest: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let mut length = digits(rest);
    if let Some(fraction) = rest[length..].strip_prefix('.') {
        length += match digits(fraction) {
            0 => 0,
            n => n + 1,
        };
    }
    if let Some(exponent) = rest[length..].strip_prefix(['e', 'E']) {
        let unsigned = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
        let sign = exponent.len() - unsigned.len();
        length += match digits(unsigned) {
            0 => 0,
            n => 1 + sign + n,
        };
    }
    length
}

/// Length of a text with its quotes, if it ends on its line.
fn text_length(rest: &str) -> Option<usize> {
    let end = rest[1..].find(['"', '\n'])? + 1;
    rest[end..].starts_with('"').then_some(end + 1)
}

/// Up to what probably follows the forgotten quote.
fn unclosed_length(rest: &str) -> usize {
    let line = rest.find(['\n', '\r']).unwrap_or(rest.len());
    let length = rest[..line].find([',', ')', ']', '}', '#']).unwrap_or(line);
    rest[..length].trim_end().len()
}

impl Scan {
    fn unclosed_text(&mut self, span: Span) {
        self.mistakes.push(
            Diagnostic::new(
                Code::UnclosedText,
                "a text must end on the line it starts on",
                span.clone(),
                "no closing `\"`",
            )
            .with_help("close the text with `\"`"),
        );
        self.unclosed.push(span);
    }

    fn unknown(&mut self, text: &str, span: Span) {
        let found = &text[span.clone()];
        let first = found.chars().next().unwrap_or(' ');
        let help = match first {
            ';' => Some("leave `;` out: entries need no separator"),
            '−' | '–' | '—' => Some("write a minus as `-`"),
            '×' | '⋅' | '∗' => Some("write a product as `*`"),
            '÷' => Some("write a quotient as `/`"),
            '“' | '”' | '„' | '«' | '»' | '\'' | '‘' | '’' | '`' => {
                Some("texts stand in straight quotes: `\"force.csv\"`")
            }
            '²' => Some("write a square as `^2`"),
            '³' => Some("write a cube as `^3`"),
            '¹' | '⁰' | '⁻' | '⁴'..='⁹' => Some("write a power with `^`, as in `m^-3`"),
            '≤' => Some("write `<=`"),
            '≥' => Some("write `>=`"),
            '≠' => Some("write `!=`"),
            '→' => Some("write `->`"),
            '°' => Some("write degrees as `deg`, as in `49.98 deg`"),
            '‰' => Some("write a fraction or `%`"),
            '√' => Some("write `sqrt(…)`"),
            '\u{a0}' | '\u{2007}' | '\u{2009}' | '\u{202f}' | '\u{200b}' | '\u{3000}' => {
                Some("write an ordinary blank")
            }
            '&' | '|' | '!' => Some("there are no logical operators; write one `expect` for each condition"),
            _ => None,
        };
        let shown = match first {
            c if c.is_control()
                || c.is_whitespace()
                || !c.is_ascii() && c.len_utf8() > 1 && is_invisible(c) =>
            {
                format!("the character U+{:04X} means nothing here", u32::from(first))
            }
            _ => format!("`{first}` means nothing here"),
        };
        let mut mistake = Diagnostic::new(Code::UnknownCharacter, shown, span.clone(), "");
        mistake.help = help.map(Into::into);
        self.mistakes.push(mistake);
        self.blanked.push(span);
    }
}

fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{ad}')
}
