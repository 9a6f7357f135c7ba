//! Text to a tree with spans, and the drawing of diagnostics.
//!
//! Owns the grammar, the syntax tree and what a mistake looks like. Knows nothing of the values of
//! units, of physics, files or the terminal.

mod code;
mod diagnostic;
mod encoding;
mod format;
mod parse;
mod position;
mod scan;
mod tree;

pub use code::Code;
pub use diagnostic::{Diagnostic, Label};
pub use encoding::{NotText, line_ends, text_of};
pub use format::format;
pub use parse::{MAX_EXPRESSION_DEPTH, MAX_FILE_BYTES, MAX_NESTING, decode, parse, parse_expression};
pub use position::Lines;
pub use tree::{
    Argument, At, BinaryOperator, Block, Bounds, Entry, Expr, ExprId, ExprKind, Import, ImportFrom, Item,
    Name, Path, Source, Span, SyntaxTree, UnaryOperator, UnitText,
};
