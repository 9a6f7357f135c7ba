//! Text to a tree with spans, and the drawing of diagnostics.
//!
//! Owns the grammar, the syntax tree and what a mistake looks like. Knows nothing of the values of
//! units, of physics, files or the terminal.

mod code;
mod diagnostic;
mod position;
mod tree;

pub use code::Code;
pub use diagnostic::{Diagnostic, Label};
pub use position::Lines;
pub use tree::{
    Argument, At, BinaryOperator, Block, Bounds, Entry, Expr, ExprId, ExprKind, Import, ImportFrom, Item,
    Name, Path, Source, Span, SyntaxTree, UnaryOperator, UnitText,
};
