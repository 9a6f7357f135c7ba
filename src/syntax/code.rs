//! The stable codes of diagnostics.
//!
//! Owns which mistakes there are, their one-line titles and what to do about each. Each code has a page under
//! `docs/diagnostics`; a code is never renumbered or reused.

use std::fmt;

macro_rules! codes {
    ($($(#[$doc:meta])* $variant:ident = $code:literal, $title:literal
        help: $help:literal;)*) => {
        /// What kind of mistake was made. The number is stable, the title is for lists of codes.
        ///
        /// `01xx` the form of the text, `02xx` names and imports, `03xx` units and dimensions, `04xx` energies
        /// and materials, `05xx` scenes, `06xx` options of a run.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Code {
            $($(#[$doc])* #[doc = concat!("`", $code, "`: ", $title)] $variant,)*
        }

        impl Code {
            /// Every code in order.
            pub const ALL: &'static [Code] = &[$(Code::$variant),*];

            /// The stable number: `E0301`.
            pub fn number(self) -> &'static str {
                match self { $(Code::$variant => $code),* }
            }

            /// A few words saying what the code is about.
            pub fn title(self) -> &'static str {
                match self { $(Code::$variant => $title),* }
            }

            /// What to write instead, where a mistake has no help of its own.
            pub fn help(self) -> &'static str {
                match self { $(Code::$variant => $help),* }
            }
        }
    };
}

codes! {
    MissingVersion = "E0101", "the version line `tissue 1` is missing"
        help: "write `tissue 1` as the first line";
    WrongVersion = "E0102", "the language version is not one this program reads"
        help: "write `tissue 1`";
    FileTooLarge = "E0103", "the file is larger than 1 MB"
        help: "split the file and `import` its parts";
    NestingTooDeep = "E0104", "brackets are nested deeper than 128"
        help: "name parts of it with `let`";
    ExpressionTooDeep = "E0105", "an expression has too many levels of operators"
        help: "name parts of it with `let`";
    NotUtf8 = "E0106", "the file is not UTF-8 text"
        help: "save the file as UTF-8";
    UnknownCharacter = "E0107", "a character that means nothing here"
        help: "remove the character, or put the text in quotes";
    UnclosedText = "E0108", "a text in quotes does not end on its line"
        help: "write `\"` at the end of the text, on its line";
    UnclosedBracket = "E0109", "a bracket is never closed"
        help: "write the closing bracket";
    UnmatchedBracket = "E0110", "a closing bracket that nothing opened"
        help: "remove it, or write the opening bracket";
    ExpectedValue = "E0111", "a value is missing"
        help: "write a value: `7.64 kPa`, `0.5`, `[0, 0, 1]` or a name";
    MissingOperator = "E0112", "two values stand side by side"
        help: "write an operator between them, such as `*`, or begin a new line";
    UnexpectedToken = "E0113", "something stands where it cannot"
        help: "remove it, or finish what stands before it";
    ExpectedEntry = "E0114", "not an entry of a block"
        help: "write `key = value`, or a block `word name { … }`";
    NumberOutOfRange = "E0115", "a number is too large for a 64-bit float"
        help: "use a larger unit";
    TooManyMistakes = "E0116", "the rest of the file is left unread"
        help: "mend the mistakes above first";

    UnknownBlock = "E0201", "no such kind of block"
        help: "`tissue explain WORD` tells where a block can stand";
    UnknownKey = "E0202", "no such key in this block"
        help: "`tissue explain WORD` lists the keys of a block";
    UnknownName = "E0203", "a name that nothing declares"
        help: "write a name that is declared, or declare this one with `let`";
    DuplicateName = "E0204", "a name is declared twice"
        help: "remove one of the two, or give it another name";
    UnknownImport = "E0205", "the imported file or library has no such name"
        help: "`tissue explain NAME` shows an energy or material of the library";
    FileNotFound = "E0206", "a file cannot be read"
        help: "the path is relative to the file that names it";
    ImportCycle = "E0207", "files import each other in a circle"
        help: "move what both need into a file of its own and `import` that";
    MissingKey = "E0208", "a block lacks a key it must have"
        help: "write the key in the block";
    UnknownFace = "E0209", "a shape has no such face"
        help: "write a face the shape has";
    NotAvailable = "E0210", "a word of the language that this version does not run yet"
        help: "leave it out";
    UnknownArgument = "E0211", "no such argument"
        help: "write an argument that is declared";
    MissingArgument = "E0212", "an argument is missing"
        help: "write the argument: `name = value`";
    UnknownFunction = "E0213", "no such function"
        help: "write a function that is known here; `tissue explain NAME` tells where one can be used";
    WrongForm = "E0214", "a value of the wrong form"
        help: "`tissue explain WORD` shows how the entry is written";

    WrongDimension = "E0301", "a value has another dimension than required"
        help: "write a value of the required dimension";
    MissingUnit = "E0302", "a number needs a unit"
        help: "write the unit behind the number: `7.64 kPa`";
    UnknownUnit = "E0303", "no such unit"
        help: "write a unit such as `mm`, `kPa` or `kg/m^3`";
    MixedDimensions = "E0304", "an operator joins different dimensions"
        help: "multiply or divide one of them by a quantity, so that both have one dimension";
    NotANumber = "E0305", "a function of numbers is given a quantity with a dimension"
        help: "divide by a quantity of the same dimension: `exp(a/b)`";
    EnergyDimension = "E0306", "an energy is not an energy per volume"
        help: "multiply numbers by one pressure: `psi = C*(I1bar - 3)`";
    UnknownDimension = "E0307", "no such dimension"
        help: "write a dimension such as `pressure` or `length/time`";

    ParameterOutOfRange = "E0401", "a parameter lies outside its admissible range"
        help: "write a value in that range";
    NotUnitLength = "E0402", "a direction is not of unit length"
        help: "write `unit([1, 1, 0])`";
    NoFibres = "E0403", "an energy needs fibres its material does not have"
        help: "write `fibre a1 = [1, 0, 0]` with the direction that is meant";
    StressAtRest = "E0404", "the undeformed state is not free of stress"
        help: "write invariants with `bar` for the part that changes no volume, or add the missing volumetric term";
    NoVolumetricTerm = "E0405", "the bulk modulus is zero"
        help: "add a volumetric term, such as `vol_quadratic(K = 1 MPa)`";

    Conflict = "E0501", "two lines prescribe the same degree of freedom"
        help: "remove one of the two lines";
    AfterEnd = "E0502", "something happens after the end of the run"
        help: "write a later `until`, or let it happen earlier";
    DataOutsidePath = "E0503", "data lie where their drive does not go"
        help: "write a range of the path that holds all data";
    TooFewData = "E0504", "a fit has no more data than parameters"
        help: "give more data, or vary fewer parameters";
    NoEffect = "E0507", "a varied value changes nothing"
        help: "vary a value that something reads";
    TooLarge = "E0508", "more is asked for than can be computed"
        help: "ask for less";

    UnknownOverride = "E0601", "no such value to override"
        help: "write the path of a value in the file, such as `run.until`";
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.number())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_distinct_and_in_order() {
        assert!(Code::ALL.windows(2).all(|pair| pair[0].number() < pair[1].number()));
    }
}
