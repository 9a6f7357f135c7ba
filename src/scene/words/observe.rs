//! What is recorded and drawn.

use crate::schema::{Choice, Declaration, Kind, Member, Parameter, Presence, Target};

const EVERY: &str = "every = 0.1 ms";

/// `record name { … }`
pub(in crate::scene) static RECORD: Declaration = Declaration {
    word: "record",
    doc: "A table with one row each interval: time and the columns named here, always of the whole body.",
    within: Some("scene"),
    target: Target::Name,
    keys: &[Parameter {
        name: "every",
        kind: Kind::Quantity("time"),
        presence: Presence::Required(EVERY),
        doc: "The interval.",
    }],
    members: &[Member::Columns],
    example: "record pull { d = displacement(strip.xmax).x  F = reaction(strip.xmax).x  every = 0.1 ms }",
    available: true,
};

/// Fields a frame can hold.
const FRAME_FIELDS: &[Choice] = &[
    Choice { word: "displacement", doc: "displacement, m" },
    Choice { word: "velocity", doc: "velocity, m/s" },
    Choice { word: "sigma", doc: "Cauchy stress, Pa" },
    Choice { word: "von_mises", doc: "von Mises stress, Pa" },
    Choice { word: "pressure", doc: "tr sigma/3, positive in tension, Pa" },
    Choice { word: "J", doc: "volume map" },
    Choice { word: "F", doc: "deformation gradient" },
    Choice { word: "P", doc: "first Piola-Kirchhoff stress, Pa" },
];

/// `frames name { … }`
pub(in crate::scene) static FRAMES: Declaration = Declaration {
    word: "frames",
    doc: "Fields of all particles, written each interval for a viewer.",
    within: Some("scene"),
    target: Target::Name,
    keys: &[
        Parameter {
            name: "values",
            kind: Kind::Choices(FRAME_FIELDS),
            presence: Presence::Required("values = [displacement, sigma, pressure, J]"),
            doc: "The fields.",
        },
        Parameter {
            name: "every",
            kind: Kind::Quantity("time"),
            presence: Presence::Required(EVERY),
            doc: "The interval.",
        },
    ],
    members: &[],
    example: "frames fields { values = [displacement, sigma]  every = 0.1 ms }",
    available: true,
};

/// `plot name { … }`
pub(in crate::scene) static PLOT: Declaration = Declaration {
    word: "plot",
    doc: "A picture drawn from the tables and frames alone: curves, fields on deformed bodies (`panel`), or a drawing with dimensions (`outline`).",
    within: Some("scene"),
    target: Target::Name,
    keys: super::figure::PLOT_KEYS,
    members: &[],
    example: "plot force { curve = pull.F over pull.d }",
    available: true,
};

/// `plot name { … }` in a figure
pub(super) static FIGURE_PLOT: Declaration = Declaration {
    within: Some("figure"),
    example: "plot force { curve = axial.pull.F over axial.pull.d }",
    ..PLOT
};
