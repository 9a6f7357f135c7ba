//! Statements that are no blocks.

use crate::schema::Word;

/// Statements.
pub(super) static STATEMENTS: &[Word] = &[
    Word {
        word: "import",
        form: "import std.energies { goh }  or  import \"file.tissue\" { gel }",
        doc: "Takes names from the standard library or from another file.",
        context: "at the top of a file",
    },
    Word {
        word: "param",
        form: "param kappa : number in [0, 1/3] = 0.226",
        doc: "A parameter with its dimension, its admissible range and, in a material, its value.",
        context: "in `energy` and `material`",
    },
    Word {
        word: "let",
        form: "let w = 30 s^-1",
        doc: "A name for an expression.",
        context: "in `energy`, `material`, `scene`, `drive`, `fit`, `sweep` and `trade`",
    },
    Word {
        word: "fibre",
        form: "fibre a1 = tilt(theta, z, 30 deg)",
        doc: "A fibre family: a unit direction of the reference configuration.",
        context: "in `material`",
    },
    Word {
        word: "fibres",
        form: "fibres a",
        doc: "A name for each fibre of the material in turn, for sum(a in fibres, …).",
        context: "in `energy`",
    },
    Word {
        word: "direction",
        form: "direction f",
        doc: "A direction the material supplies by name: law(f = f0).",
        context: "in `energy`",
    },
    Word {
        word: "expect",
        form: "expect a == b within 1 % at record.column = [v, w]",
        doc: "What must hold of the recorded tables.",
        context: "in `scene`, `drive`, `fit`, `sweep` and `trade`",
    },
    super::sweep::VARY,
    Word {
        word: "csv",
        form: "csv(\"data.csv\", d = \"disp_mm\")",
        doc: "A table from a file; the unit is the last part of a column's name.",
        context: "in `scene`, `drive` and `fit`",
    },
];
