//! The syntax tree: what was written and where, without meaning.

/// A range of bytes of the source text.
pub type Span = std::ops::Range<usize>;

/// A named text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// What to call it in a message, usually the path as given.
    pub name: String,
    /// The text itself.
    pub text: String,
}

/// An identifier and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// The identifier.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// Identifiers joined by dots: `strip.xmax`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Path {
    /// The parts, at least one.
    pub parts: Vec<Name>,
}

/// A file as a tree.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SyntaxTree {
    /// The language version of the first line, if it could be read.
    pub version: Option<(u32, Span)>,
    /// Imports and blocks in order.
    pub items: Vec<Item>,
    /// All expressions of the file, children before parents.
    pub expressions: Vec<Expr>,
}

/// A top-level item.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// `import … { … }`
    Import(Import),
    /// `kind name { … }`
    Block(Block),
}

/// `import std.energies { goh, vol_ogden2 }`.
#[derive(Debug, Clone, PartialEq)]
pub struct Import {
    /// Where the names come from.
    pub from: ImportFrom,
    /// The names wanted.
    pub names: Vec<Name>,
    /// The whole line.
    pub span: Span,
}

/// Source of an import.
#[derive(Debug, Clone, PartialEq)]
pub enum ImportFrom {
    /// The standard library: `std.energies`.
    Library(Path),
    /// Another file, relative to the importing one.
    File(String, Span),
}

/// `kind target { entries }`; the target and the braces may be absent (`hold strip.xmin`).
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// The kind of block.
    pub kind: Name,
    /// Its name, or what it acts on.
    pub target: Option<Path>,
    /// What stands between the braces, in order.
    pub entries: Vec<Entry>,
    /// Comment lines directly above.
    pub doc: Vec<String>,
    /// The whole block.
    pub span: Span,
}

/// One entry of a block.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// `key = value`; `let name = value`, `let name(a, b) = value` and `fibre a1 = value` carry a keyword.
    Assign {
        /// `let`, `fibre`, `direction`, `vary`, if one stands before the key.
        keyword: Option<Name>,
        /// What is assigned.
        key: Path,
        /// Formal arguments: `E(a)`.
        arguments: Vec<Name>,
        /// The value.
        value: ExprId,
        /// The whole entry.
        span: Span,
    },
    /// `param C : pressure >= 0 = 1 kPa`, `param mu[n] : pressure`.
    Parameter {
        /// Its name.
        name: Name,
        /// Name of the array length.
        count: Option<Name>,
        /// The dimension, an expression of dimension names such as `1/pressure`.
        dimension: ExprId,
        /// The admissible range.
        bounds: Option<Bounds>,
        /// The default.
        default: Option<ExprId>,
        /// Comment on the same line or directly above.
        doc: Vec<String>,
        /// The whole entry.
        span: Span,
    },
    /// `fibres a`, `direction f`: a keyword and a name without a value.
    Declare {
        /// The keyword.
        keyword: Name,
        /// What is declared.
        name: Name,
    },
    /// `expect claim within tolerance at x = values`.
    Expect {
        /// What must hold.
        claim: ExprId,
        /// The tolerance.
        within: Option<ExprId>,
        /// Where it must hold.
        at: Option<At>,
        /// The whole entry.
        span: Span,
    },
    /// A nested block.
    Block(Block),
}

/// `at x = [ … ]`.
#[derive(Debug, Clone, PartialEq)]
pub struct At {
    /// The abscissa.
    pub key: ExprId,
    /// Its values.
    pub value: ExprId,
}

/// Admissible range of a parameter; an absent end is unbounded.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// Lower end and whether it is itself excluded.
    pub lower: Option<(ExprId, bool)>,
    /// Upper end and whether it is itself excluded.
    pub upper: Option<(ExprId, bool)>,
    /// Where it stands.
    pub span: Span,
}

/// Index of an expression in [`SyntaxTree::expressions`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExprId(pub u32);

/// An expression and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands, without surrounding blanks.
    pub span: Span,
    /// Height of the tree below it, a leaf counting 1; capped by the parser.
    pub depth: u32,
}

/// The unit behind a number, as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitText {
    /// For example `kg/m^3`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// What an expression is.
#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A number with or without a unit.
    Number {
        /// The number as written, unit not applied.
        value: f64,
        /// The unit.
        unit: Option<UnitText>,
    },
    /// A string.
    Text(String),
    /// An identifier.
    Name(String),
    /// `base.name`
    Member {
        /// What stands before the dot.
        base: ExprId,
        /// What stands behind it.
        name: Name,
    },
    /// `base[index]`
    Index {
        /// The array.
        base: ExprId,
        /// The index.
        index: ExprId,
    },
    /// `function(arguments)`
    Call {
        /// The function.
        function: Name,
        /// Its arguments, in order.
        arguments: Vec<Argument>,
    },
    /// `[a, b, c]`
    List(Vec<ExprId>),
    /// `-a`, `+a`
    Unary {
        /// The operator.
        operator: UnaryOperator,
        /// The operand.
        operand: ExprId,
    },
    /// `a + b` and the like.
    Binary {
        /// The operator.
        operator: BinaryOperator,
        /// Where the operator stands.
        at: Span,
        /// Left operand.
        left: ExprId,
        /// Right operand.
        right: ExprId,
    },
    /// `i in 1 .. n`, an argument of `sum` or `integrate`.
    Binder {
        /// The bound name.
        name: Name,
        /// What it runs over.
        over: ExprId,
    },
}

/// An argument of a call.
#[derive(Debug, Clone, PartialEq)]
pub struct Argument {
    /// `name =` before the value.
    pub name: Option<Path>,
    /// The value.
    pub value: ExprId,
}

/// Operators of one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnaryOperator {
    /// `-`
    Minus,
    /// `+`
    Plus,
}

/// Operators of two operands, loosest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `over`
    Over,
    /// `->`
    Arrow,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `..`
    Range,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`
    Power,
}

impl SyntaxTree {
    /// The expression of an index.
    ///
    /// # Panics
    /// If the index is not of this tree.
    pub fn expr(&self, id: ExprId) -> &Expr {
        &self.expressions[id.0 as usize]
    }
}
