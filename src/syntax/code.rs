//! The stable codes of diagnostics.
//!
//! Owns which mistakes there are and their one-line titles. Each code has a page under
//! `docs/diagnostics`; a code is never renumbered or reused.

use std::fmt;

macro_rules! codes {
    ($($(#[$doc:meta])* $variant:ident = $code:literal, $title:literal;)*) => {
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
        }
    };
}

codes! {
    MissingVersion = "E0101", "the version line `tissue 1` is missing";
    WrongVersion = "E0102", "the language version is not one this program reads";
    FileTooLarge = "E0103", "the file is larger than 1 MB";
    NestingTooDeep = "E0104", "brackets are nested deeper than 128";
    ExpressionTooDeep = "E0105", "an expression has too many levels of operators";
    NotUtf8 = "E0106", "the file is not UTF-8 text";
    UnknownCharacter = "E0107", "a character that means nothing here";
    UnclosedText = "E0108", "a text in quotes does not end on its line";
    UnclosedBracket = "E0109", "a bracket is never closed";
    UnmatchedBracket = "E0110", "a closing bracket that nothing opened";
    ExpectedValue = "E0111", "a value is missing";
    MissingOperator = "E0112", "two values stand side by side";
    UnexpectedToken = "E0113", "something stands where it cannot";
    ExpectedEntry = "E0114", "not an entry of a block";
    NumberOutOfRange = "E0115", "a number is too large for a 64-bit float";
    TooManyMistakes = "E0116", "the rest of the file is left unread";

    UnknownBlock = "E0201", "no such kind of block";
    UnknownKey = "E0202", "no such key in this block";
    UnknownName = "E0203", "a name that nothing declares";
    DuplicateName = "E0204", "a name is declared twice";
    UnknownImport = "E0205", "the imported file or library has no such name";
    FileNotFound = "E0206", "a file cannot be read";
    ImportCycle = "E0207", "files import each other in a circle";
    MissingKey = "E0208", "a block lacks a key it must have";
    UnknownFace = "E0209", "a shape has no such face";
    NotAvailable = "E0210", "a word of the language that this version does not run yet";
    UnknownArgument = "E0211", "no such argument";
    MissingArgument = "E0212", "an argument is missing";
    UnknownFunction = "E0213", "no such function";
    WrongForm = "E0214", "a value of the wrong form";

    WrongDimension = "E0301", "a value has another dimension than required";
    MissingUnit = "E0302", "a number needs a unit";
    UnknownUnit = "E0303", "no such unit";
    MixedDimensions = "E0304", "an operator joins different dimensions";
    NotANumber = "E0305", "a function of numbers is given a quantity with a dimension";
    EnergyDimension = "E0306", "an energy is not an energy per volume";
    UnknownDimension = "E0307", "no such dimension";

    ParameterOutOfRange = "E0401", "a parameter lies outside its admissible range";
    NotUnitLength = "E0402", "a direction is not of unit length";
    NoFibres = "E0403", "an energy needs fibres its material does not have";
    StressAtRest = "E0404", "the undeformed state is not free of stress";
    NoVolumetricTerm = "E0405", "the bulk modulus is zero";

    Conflict = "E0501", "two lines prescribe the same degree of freedom";
    AfterEnd = "E0502", "something happens after the end of the run";
    DataOutsidePath = "E0503", "data lie where their drive does not go";
    TooFewData = "E0504", "a fit has no more data than parameters";
    NoEffect = "E0507", "a varied value changes nothing";
    TooLarge = "E0508", "more is asked for than can be computed";

    UnknownOverride = "E0601", "no such value to override";
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
