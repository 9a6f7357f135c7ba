//! `fit` and what its expectations can ask.

use crate::schema::{Choice, Declaration, Kind, Member, Parameter, Presence, Target, Word};

/// How data count against each other.
const WEIGHTS: &[Choice] = &[
    Choice {
        word: "column",
        doc: "differences over the root mean square of their column's data: columns of any size count alike",
    },
    Choice {
        word: "uniform",
        doc: "differences as they are: every datum is known to the same absolute error",
    },
    Choice {
        word: "relative",
        doc: "differences over their datum: every datum is known to the same per cent",
    },
];

/// `fit name { … }`
pub(in crate::scene) static FIT: Declaration = Declaration {
    word: "fit",
    doc: "Parameters of a material from data: weighted least squares over drives, within the ranges the parameters are declared with.",
    within: None,
    target: Target::Name,
    keys: &[
        Parameter {
            name: "drive",
            kind: Kind::Expression,
            presence: Presence::Required("drive = tension"),
            doc: "The drive the data were measured on, or a list of such; its path is led to the data's places.",
        },
        Parameter {
            name: "data",
            kind: Kind::Expression,
            presence: Presence::Required(
                "data = csv(\"test.csv\", stretch = \"stretch\", P.xx = \"stress_kPa\")",
            ),
            doc: "A table for each drive: the parameter of its path, and columns named by what they measure: P.xx, sigma.xy, F.yy, J, or a column of the drive's record. A column `weight` weighs its rows.",
        },
        Parameter {
            name: "vary",
            kind: Kind::Expression,
            presence: Presence::Required("vary = [gel.mu]"),
            doc: "The parameters sought, by material and name; they start from the values the material gives them.",
        },
        Parameter {
            name: "weights",
            kind: Kind::Choice(WEIGHTS),
            presence: Presence::Default("column"),
            doc: "How data count against each other.",
        },
    ],
    members: &[Member::Let, Member::Expect],
    example: "fit to_tension {\n  drive = tension\n  data  = csv(\"test.csv\", stretch = \"stretch\", P.xx = \"stress_kPa\")\n  vary  = [gel.mu]\n  expect gel.mu == 10 kPa within 5 %\n}",
    available: true,
};

const IN_EXPECT: &str = "in `expect` of `fit`";

/// What an expectation can ask of a fit beside the parameters it varies.
pub(in crate::scene) static FIT_WORDS: &[Word] = &[
    Word {
        word: "error",
        form: "error(gel.mu)",
        doc: "Standard error of a fitted parameter, by linear theory; not a number where the data do not determine it.",
        context: IN_EXPECT,
    },
    Word {
        word: "r_squared",
        form: "r_squared",
        doc: "Share of the data's weighted sum of squares about their columns' means that the fit explains.",
        context: IN_EXPECT,
    },
    Word {
        word: "condition",
        form: "condition",
        doc: "Largest over smallest eigenvalue of the scaled normal equations: from 1e8 on the data barely tell the parameters apart.",
        context: IN_EXPECT,
    },
];
