//! `body` and `symmetry`.

use crate::schema::{Choice, Declaration, Kind, Parameter, Presence, Target};

/// `body name { … }`
pub(in crate::scene) static BODY: Declaration = Declaration {
    word: "body",
    doc: "A piece of material: its shape, how finely it is divided, what it is made of.",
    within: Some("scene"),
    target: Target::Name,
    keys: &[
        Parameter {
            name: "shape",
            kind: Kind::Shape,
            presence: Presence::Required("shape = box(10 mm, 3 mm, 0.5 mm)"),
            doc: "The region of the whole body; `a + b` is all of both (they end together), `a - b` is a without b, which reaches through it and leaves the face `hole`.",
        },
        Parameter {
            name: "spacing",
            kind: Kind::Quantity("length"),
            presence: Presence::Required("spacing = 0.125 mm"),
            doc: "Distance of neighbouring particles.",
        },
        Parameter {
            name: "material",
            kind: Kind::Material,
            presence: Presence::Required("material = gel"),
            doc: "What it is made of; `gel(mu = 2 kPa)` with other values for parameters of the material itself.",
        },
        Parameter {
            name: "jitter",
            kind: Kind::Quantity("number"),
            presence: Presence::Default("0"),
            doc: "Random displacement of inner particles as a fraction of the spacing, between 0 and 0.5.",
        },
    ],
    members: &[],
    example: "body strip { shape = box(10 mm, 3 mm, 0.5 mm)  spacing = 0.125 mm  material = gel }",
    available: true,
};

/// `bond body.face { to = other.face }`
pub(in crate::scene) static BOND: Declaration = Declaration {
    word: "bond",
    doc: "Makes the touching faces of two bodies move as one: their nodes lie on each other and share forces, or the faces are one plane region and the nodes of the finer hang on the quadrilaterals of the coarser.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[Parameter {
        name: "to",
        kind: Kind::Expression,
        presence: Presence::Required("to = adventitia.zmin"),
        doc: "The face of the other body.",
    }],
    members: &[],
    example: "bond media.zmax { to = adventitia.zmin }",
    available: true,
};

const AXES: &[Choice] = &[
    Choice { word: "x", doc: "the plane normal to x" },
    Choice { word: "y", doc: "the plane normal to y" },
    Choice { word: "z", doc: "the plane normal to z" },
];

/// `symmetry { … }`
pub(in crate::scene) static SYMMETRY: Declaration = Declaration {
    word: "symmetry",
    doc: "Planes of symmetry through the centre of the body, or where the hexahedra of a file end; the part of greater coordinates is modelled, the whole body is recorded.",
    within: Some("scene"),
    target: Target::Absent,
    keys: &[Parameter {
        name: "planes",
        kind: Kind::Choices(AXES),
        presence: Presence::Required("planes = [x, y, z]"),
        doc: "Normals of the planes.",
    }],
    members: &[],
    example: "symmetry { planes = [x, y, z] }",
    available: true,
};
