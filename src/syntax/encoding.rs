//! Bytes to text: which encodings are read, and where one is not.
//!
//! Owns encodings and line ends. Knows neither files nor what the text says.

use std::borrow::Cow;
use std::fmt;

/// Bytes that are no text of an encoding that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NotText {
    /// The first byte that is not UTF-8.
    Utf8 {
        /// Its offset.
        at: usize,
        /// Its line, from 1.
        line: usize,
        /// The byte.
        byte: u8,
    },
    /// After the byte order mark of UTF-16 comes something else.
    Utf16,
}

impl fmt::Display for NotText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Utf8 { at, line, byte } => {
                write!(f, "is not UTF-8 text: byte {at}, on line {line}, is 0x{byte:02x}")?;
                // of the two, Windows-1252 has Latin-1's letters here
                if *byte >= 0xa0 { write!(f, ", in Latin-1 a `{}`", char::from(*byte)) } else { Ok(()) }
            }
            Self::Utf16 => f.write_str("begins as UTF-16 text and does not go on as such"),
        }
    }
}

/// The text of bytes: UTF-8, or UTF-16 with its byte order mark, as spreadsheets and editors write it.
///
/// # Errors
/// [`NotText`] says where it is neither.
pub fn text_of(bytes: Vec<u8>) -> Result<String, NotText> {
    let order: Option<fn([u8; 2]) -> u16> = match bytes[..] {
        [0xff, 0xfe, ..] => Some(u16::from_le_bytes),
        [0xfe, 0xff, ..] => Some(u16::from_be_bytes),
        _ => None,
    };
    if let Some(order) = order {
        let (pairs, rest) = bytes[2..].as_chunks::<2>();
        let units: Vec<u16> = pairs.iter().map(|pair| order(*pair)).collect();
        return match String::from_utf16(&units) {
            Ok(text) if rest.is_empty() => Ok(text),
            _ => Err(NotText::Utf16),
        };
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let before = &error.as_bytes()[..at];
        let ended = |pair: &[u8]| pair[0] == b'\r' && pair[1] != b'\n';
        let feeds = before.iter().filter(|byte| **byte == b'\n').count();
        let line = 1 + feeds + error.as_bytes()[..=at].windows(2).filter(|pair| ended(pair)).count();
        NotText::Utf8 { at, line, byte: error.as_bytes()[at] }
    })
}

/// A text whose lines end with LF or CRLF: a lone CR, as old spreadsheets write it, becomes LF. Offsets stay.
pub fn line_ends(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let lone = |at: usize| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    if !(0..bytes.len()).any(lone) {
        return Cow::Borrowed(text);
    }
    let mut after = text.chars().skip(1);
    let ended = text.chars().map(|c| {
        let next = after.next();
        if c == '\r' && next != Some('\n') { '\n' } else { c }
    });
    Cow::Owned(ended.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_16_is_read_in_both_byte_orders_and_refused_where_it_breaks_off() {
        let text = "tissue 1\r\n# µ λ 𝜓\n";
        for (mark, order) in
            [(0xfeff_u16, u16::to_le_bytes as fn(u16) -> [u8; 2]), (0xfeff, u16::to_be_bytes)]
        {
            let units = std::iter::once(mark).chain(text.encode_utf16());
            let bytes: Vec<u8> = units.flat_map(order).collect();
            assert_eq!(text_of(bytes.clone()), Ok(text.to_owned()));
            assert_eq!(text_of(bytes[..bytes.len() - 1].to_vec()), Err(NotText::Utf16));
        }
    }

    #[test]
    fn a_byte_that_is_no_utf_8_is_named_with_its_line_whatever_ends_lines() {
        for ends in ["\n", "\r", "\r\n"] {
            let mut bytes = format!("a{ends}b{ends}Pr").into_bytes();
            bytes.extend(b"\xfcfer");
            let told = text_of(bytes).expect_err("Latin-1").to_string();
            assert!(told.ends_with("on line 3, is 0xfc, in Latin-1 a `ü`"), "{told}");
        }
    }

    #[test]
    fn a_lone_carriage_return_ends_a_line_and_no_offset_moves() {
        assert_eq!(line_ends("a\rb\r\nc\r\rd\r"), "a\nb\r\nc\n\nd\n");
        assert!(matches!(line_ends("a\r\nµ\n"), Cow::Borrowed(_)));
    }
}
