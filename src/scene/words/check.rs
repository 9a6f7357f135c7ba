//! `check` of a material.

use crate::schema::{Choice, Declaration, Kind, Parameter, Presence, Target, Word};

/// What can be required of a law; the words of its audit.
const PROPERTIES: &[Choice] = &[
    Choice { word: "derivative", doc: "the stress is the derivative of the energy" },
    Choice { word: "stress_free", doc: "no stress at rest" },
    Choice { word: "objective", doc: "a rotation of space turns the stress with it" },
    Choice { word: "symmetric_tangent", doc: "the tangent is that of an energy" },
    Choice { word: "material_symmetry", doc: "a rotation of body and directions changes nothing" },
    Choice { word: "elliptic", doc: "waves of every direction travel, over the stretches" },
    Choice { word: "joins", doc: "pieces of the law meet without a jump; asked of laws with pieces" },
    Choice { word: "integration", doc: "sums over directions are good enough; asked of laws that integrate" },
    Choice {
        word: "baker_ericksen",
        doc: "the larger stress acts along the larger stretch; of isotropic laws only, so no other can meet it",
    },
    Choice {
        word: "convex_in_volume",
        doc: "convex under dilation: necessary for polyconvexity of a law that splits, not sufficient",
    },
    Choice { word: "volumetric_growth", doc: "unbounded as the volume vanishes, growing as it grows" },
    Choice {
        word: "fibres_feel_volume",
        doc: "fibres resist when the body is blown up; asked of laws with directions",
    },
];

/// `check material { … }`
pub(in crate::scene) static CHECK: Declaration = Declaration {
    word: "check",
    doc: "What must hold of a material's law itself, with no scene; `tissue check` ends with 1 if it does not.",
    within: None,
    target: Target::Material,
    keys: &[
        Parameter {
            name: "require",
            kind: Kind::Choices(PROPERTIES),
            presence: Presence::Required("require = [stress_free, objective, elliptic]"),
            doc: "The properties that must hold.",
        },
        Parameter {
            name: "over",
            kind: Kind::Expression,
            presence: Presence::Default("stretches(0.7 .. 1.4)"),
            doc: "The stretches to be expected, from the strongest compression to the strongest tension; bars are pulled up to the latter.",
        },
    ],
    members: &[],
    example: "check gel {\n  require = [stress_free, objective, elliptic]\n  over = stretches(0.85 .. 1.25)\n}",
    available: true,
};

/// The form of a range.
pub(in crate::scene) static CHECK_WORDS: &[Word] = &[Word {
    word: "stretches",
    form: "stretches(0.85 .. 1.25)",
    doc: "A range of stretches around 1.",
    context: "in `over` of `check`",
}];
