//! Byte offsets to lines and columns.

use super::tree::Span;

/// The lines of a text, ended by LF, CRLF or CR.
#[derive(Debug, Clone)]
pub struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    /// Finds the lines of a text.
    pub fn new(text: &'a str) -> Self {
        let bytes = text.as_bytes();
        let ends =
            |at: &usize| bytes[*at] == b'\n' || (bytes[*at] == b'\r' && bytes.get(at + 1) != Some(&b'\n'));
        let starts = (0..bytes.len()).filter(ends).map(|at| at + 1);
        Self { text, starts: std::iter::once(0).chain(starts).collect() }
    }

    /// The line, counted from 0, of a byte offset; offsets behind the end are on the last line.
    pub fn line_of(&self, at: usize) -> usize {
        self.starts.partition_point(|start| *start <= at) - 1
    }

    /// The bytes of a line counted from 0, without its line end.
    ///
    /// # Panics
    /// If there is no such line.
    pub fn line_span(&self, line: usize) -> Span {
        let start = self.starts[line];
        let end = self.starts.get(line + 1).copied().unwrap_or(self.text.len());
        let content = &self.text[start..end];
        let content = content.strip_suffix('\n').unwrap_or(content);
        start..start + content.strip_suffix('\r').unwrap_or(content).len()
    }

    /// Line and column from 1 of a byte offset; columns count characters, a byte order mark none.
    pub fn position(&self, at: usize) -> (usize, usize) {
        let at = self.boundary(at);
        let line = self.line_of(at);
        let before = self.text[self.starts[line]..at].trim_start_matches('\u{feff}');
        (line + 1, before.chars().count() + 1)
    }

    /// A span within the text whose ends do not split a character.
    pub fn clip(&self, span: &Span) -> Span {
        let start = self.boundary(span.start);
        start..self.boundary(span.end).max(start)
    }

    /// A span clipped to the line it starts on.
    pub fn clip_to_line(&self, span: &Span) -> Span {
        let Span { start, end } = self.clip(span);
        let line = self.line_span(self.line_of(start));
        let start = start.min(line.end);
        start..end.clamp(start, line.end)
    }

    fn boundary(&self, at: usize) -> usize {
        let mut at = at.min(self.text.len());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        at
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_from_one() {
        let lines = Lines::new("λ₁ = 2\r\n\tσ = 3\n");
        assert_eq!(lines.position("λ₁ ".len()), (1, 4));
        assert_eq!(lines.position("λ₁ = 2\r\n\t".len()), (2, 2));
        assert_eq!(lines.position(1000), (3, 1));
    }

    #[test]
    fn a_line_ends_before_its_line_end() {
        let text = "a\r\nbc\nd";
        let lines = Lines::new(text);
        let of = |n| &text[lines.line_span(n)];
        assert_eq!([of(0), of(1), of(2)], ["a", "bc", "d"]);
    }

    #[test]
    fn a_span_is_clipped_to_characters_and_to_its_line() {
        let lines = Lines::new("αβ\nγ");
        assert_eq!(lines.clip(&(1..3)), 0..2);
        assert_eq!(lines.clip_to_line(&(2..100)), 2..4);
        assert_eq!(lines.clip(&Span { start: 9, end: 2 }), 7..7);
    }
}
