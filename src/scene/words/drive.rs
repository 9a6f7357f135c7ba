//! `drive` and what stands in it.

use super::observe::PLOT;
use crate::schema::{Choice, Declaration, Kind, Member, Parameter, Presence, Target, Word};

const VOLUMES: &[Choice] = &[
    Choice { word: "compressible", doc: "the volume changes as the law's volumetric part says" },
    Choice { word: "incompressible", doc: "J = 1 exactly, whatever the volumetric part" },
];

/// `drive name { … }`
pub(in crate::scene) static DRIVE: Declaration = Declaration {
    word: "drive",
    doc: "One material point led along a path of deformation: no particles, equilibrium to round-off.",
    within: None,
    target: Target::Name,
    keys: &[
        Parameter {
            name: "material",
            kind: Kind::Material,
            presence: Presence::Required("material = gel"),
            doc: "What it is made of; `gel(mu = 2 kPa)` with other values for parameters of the material itself.",
        },
        Parameter {
            name: "path",
            kind: Kind::Expression,
            presence: Presence::Required("path = uniaxial(x, stretch = 1 .. 1.5, steps = 100)"),
            doc: "Where it is led: uniaxial, biaxial, equibiaxial, planar, simple_shear or deformation, in directions of the material or x, y, z.",
        },
        Parameter {
            name: "volume",
            kind: Kind::Choice(VOLUMES),
            presence: Presence::Default("compressible"),
            doc: "Whether the volume may change.",
        },
    ],
    members: &[Member::Let, Member::Expect],
    example: "drive tension {\n  material = gel\n  path = uniaxial(x, stretch = 1 .. 1.5, steps = 100)\n  record test { P = P.xx  width = F.yy }\n  expect final(test.P) > 0 kPa\n}",
    available: true,
};

/// `record name { … }` in a drive
pub(in crate::scene) static POINT_RECORD: Declaration = Declaration {
    word: "record",
    doc: "A table with one row a point of the path: its parameter and the columns named here.",
    within: Some("drive"),
    target: Target::Name,
    keys: &[],
    members: &[Member::Columns],
    example: "record test { sigma = sigma.xx  width = F.yy }",
    available: true,
};

/// `plot name { … }` in a drive
pub(super) static POINT_PLOT: Declaration = Declaration {
    within: Some("drive"),
    example: "plot tension { curve = test.P over test.stretch }",
    ..PLOT
};

const IN_PATH: &str = "in `path` of `drive`";
const IN_RECORD: &str = "in `record` of `drive`";

const fn word(word: &'static str, form: &'static str, context: &'static str, doc: &'static str) -> Word {
    Word { word, form, doc, context }
}

/// The paths a material point can be led along.
pub(in crate::scene) static PATHS: &[Word] = &[
    word(
        "uniaxial",
        "uniaxial(e1, stretch = 1 .. 1.5, steps = 100)",
        IN_PATH,
        "Stretched along e1, no other tractions; a second direction fixes where y points.",
    ),
    word(
        "biaxial",
        "biaxial(e1, e2, stretch = 1 .. 1.5, ratio = 0.5, steps = 100)",
        IN_PATH,
        "A sheet stretched by the stretch along e1 and by 1 + ratio (stretch - 1) along e2, its faces free.",
    ),
    word(
        "equibiaxial",
        "equibiaxial(e1, e2, stretch = 1 .. 1.5, steps = 100)",
        IN_PATH,
        "A sheet stretched equally along e1 and e2, its faces free.",
    ),
    word(
        "planar",
        "planar(e1, e2, stretch = 1 .. 1.5, steps = 100)",
        IN_PATH,
        "A sheet stretched along e1 that keeps its width along e2, its faces free: pure shear.",
    ),
    word(
        "simple_shear",
        "simple_shear(e1, e2, amount = 0 .. 0.5, steps = 50)",
        IN_PATH,
        "F = I + amount e1 e2: planes normal to e2 slide along e1; if incompressible, without normal traction along e3.",
    ),
    word(
        "deformation",
        "deformation(F = [[1, s, 0], [0, 1, 0], [0, 0, free]], s = 0 .. 0.5, steps = 50)",
        IN_PATH,
        "Any deformation gradient over a parameter; a component can instead be free (of Cauchy stress), sigma(value) or P(value). Two directions before it turn its axes.",
    ),
];

/// What a record can ask of a material point.
pub(in crate::scene) static POINT_WORDS: &[Word] = &[
    word("F", "F.xx", IN_RECORD, "Component of the deformation gradient; x, y, z are the axes of the path."),
    word("P", "P.xx", IN_RECORD, "Component of the first Piola-Kirchhoff stress."),
    word("sigma", "sigma.xx", IN_RECORD, "Component of the Cauchy stress."),
    word("psi", "psi", IN_RECORD, "Strain energy per reference volume."),
    word("J", "J", IN_RECORD, "Volume map."),
    word("von_mises", "von_mises", IN_RECORD, "Von Mises stress."),
    word("pressure", "pressure", IN_RECORD, "tr sigma/3, positive in tension."),
    word(
        "constraint_stress",
        "constraint_stress",
        IN_RECORD,
        "Hydrostatic stress that holds J at 1; zero if compressible.",
    ),
    word("residual", "residual", IN_RECORD, "Largest difference between a stress and its prescribed value."),
];
