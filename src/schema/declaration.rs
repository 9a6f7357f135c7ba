//! The declaration of a block and of its keys.

/// Everything a language version knows: its blocks and the words of its expressions.
#[derive(Debug, Clone, Copy)]
pub struct Vocabulary {
    /// The blocks.
    pub blocks: &'static [&'static Declaration],
    /// Functions, constants and fields of expressions.
    pub words: &'static [&'static [Word]],
}

/// A block: `kind target { key = value … }`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Declaration {
    /// Its kind, the first word.
    pub word: &'static str,
    /// What it is for, one sentence.
    pub doc: &'static str,
    /// The block it stands in; `None` at the top of a file.
    pub within: Option<&'static str>,
    /// What stands between the kind and the brace.
    pub target: Target,
    /// Its keys.
    pub keys: &'static [Parameter],
    /// Entries other than the keys.
    pub members: &'static [Member],
    /// A short form that is correct in its place.
    pub example: &'static str,
    /// `false` if this version parses the block but does not carry it out.
    pub available: bool,
}

/// What stands between the kind of a block and its brace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Nothing.
    Absent,
    /// A new name.
    Name,
    /// A material that exists.
    Material,
    /// A body that exists.
    Body,
    /// A face of a body, `strip.xmax`.
    Face,
}

/// Entries of a block beside its declared keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Member {
    /// `let name = value`, also `let name(a) = value`.
    Let,
    /// `param name : dimension in [a, b] = default`.
    Param,
    /// `fibre name = direction`.
    Fibre,
    /// `fibres name`: a name for each fibre of the material in turn.
    Fibres,
    /// `direction name`: bound by an argument.
    Direction,
    /// `expect claim`.
    Expect,
    /// `vary path = [values]`.
    Vary,
    /// Any name with a direction.
    Directions,
    /// Any name with an expression: a column.
    Columns,
}

/// A key of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// The key.
    pub name: &'static str,
    /// What its value is.
    pub kind: Kind,
    /// What holds if it is not written.
    pub presence: Presence,
    /// What it means, one sentence.
    pub doc: &'static str,
}

/// What the value of a key is. Dimensions are given by name: `length`, `1/pressure`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A number with a unit of this dimension.
    Quantity(&'static str),
    /// A quantity that may depend on place and time.
    Field(&'static str),
    /// Three components, each of which may depend on place and time.
    VectorField(&'static str),
    /// Three components.
    Vector(&'static str),
    /// A whole number, 0 or more.
    Count,
    /// One of these words.
    Choice(&'static [Choice]),
    /// Several of these words: `[x, y]`.
    Choices(&'static [Choice]),
    /// The name of a material.
    Material,
    /// A shape, `box(10 mm, 3 mm, 0.5 mm)`.
    Shape,
    /// A strain energy or a sum of several.
    Energy,
    /// `record.column over record.column`, or a list of such.
    Curve,
    /// A text in quotes.
    Text,
    /// Two quantities of one dimension: `[0 mm, 2 mm]`.
    Range,
    /// Values in place of those of a file: `set(strip.spacing = 0.5 mm)`.
    Settings,
    /// An expression whose form the block itself explains.
    Expression,
}

/// A word that can be chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// The word.
    pub word: &'static str,
    /// What it means.
    pub doc: &'static str,
}

/// Whether a key must be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Presence {
    /// It must: no default is right for every scene. The text is an entry to paste.
    Required(&'static str),
    /// It need not; this is what holds without it, as one would write it.
    Default(&'static str),
    /// It need not; what holds without it depends on the scheme.
    ByScheme {
        /// Value of `scheme = seed`.
        seed: &'static str,
        /// Value of `scheme = improved`.
        improved: &'static str,
    },
}

/// A word of expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Word {
    /// The word.
    pub word: &'static str,
    /// How it is written.
    pub form: &'static str,
    /// What it means, one sentence.
    pub doc: &'static str,
    /// Where it can be used.
    pub context: &'static str,
}

impl Declaration {
    /// The key of a name.
    pub fn key(&self, name: &str) -> Option<&Parameter> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// Whether such entries are allowed.
    pub fn allows(&self, member: Member) -> bool {
        self.members.contains(&member)
    }
}

impl Vocabulary {
    /// The block of a kind in a place.
    pub fn block(&self, word: &str, within: Option<&str>) -> Option<&'static Declaration> {
        self.blocks.iter().copied().find(|block| block.word == word && block.within == within)
    }

    /// The kinds of block that can stand in a place.
    pub fn kinds(&self, within: Option<&str>) -> Vec<&'static str> {
        self.blocks.iter().filter(|block| block.within == within).map(|block| block.word).collect()
    }

    /// All words of expressions.
    pub fn all_words(&self) -> impl Iterator<Item = &'static Word> {
        self.words.iter().flat_map(|words| words.iter())
    }
}
