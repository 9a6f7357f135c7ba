//! An exact motion written as text.

use crate::schema::{Choice, Declaration, Kind, Parameter, Presence, Target};

/// What the boundary is told of the motion.
const BOUNDARY: &[Choice] = &[
    Choice { word: "motion", doc: "its particles move as written" },
    Choice { word: "traction", doc: "it carries the exact traction P N" },
    Choice { word: "normal", doc: "moved along its normal, the exact traction in its plane" },
    Choice { word: "tangential", doc: "moved in its plane, the exact traction along its normal" },
];

const SWITCH: &[Choice] = &[
    Choice { word: "on", doc: "what the motion needs beside the stresses" },
    Choice { word: "off", doc: "none: the motion is to be a solution by itself" },
];

const fn faces(name: &'static str, doc: &'static str) -> Parameter {
    Parameter { name, kind: Kind::Expression, presence: Presence::Default("none"), doc }
}

/// `motion { … }`
pub(in crate::scene) static MOTION: Declaration = Declaration {
    word: "motion",
    doc: "An exact motion x(X, t): initial state, body force, boundary data and exact F, H, J and P follow by differentiation.",
    within: Some("scene"),
    target: Target::Absent,
    keys: &[
        Parameter {
            name: "x",
            kind: Kind::VectorField("length"),
            presence: Presence::Required("x = [X + 1 mm * sin(pi*X/2 m) * sin(3 s^-1 * t), Y, Z]"),
            doc: "Current position, a function of X, Y, Z and t.",
        },
        Parameter {
            name: "boundary",
            kind: Kind::Choice(BOUNDARY),
            presence: Presence::Default("motion"),
            doc: "What every face is given that no other line of the scene names.",
        },
        faces("motion", "Faces whose particles move as written: `motion = [cube.xmin, cube.ymin]`."),
        faces("traction", "Faces that carry the exact traction P N."),
        faces("normal", "Faces moved along their normal, with the exact traction in their plane."),
        faces("tangential", "Faces moved in their plane, with the exact traction along their normal."),
        Parameter {
            name: "body_force",
            kind: Kind::Choice(SWITCH),
            presence: Presence::Default("on"),
            doc: "The body force rhoR d2x/dt2 - DIV P.",
        },
    ],
    members: &[],
    example: "motion { x = [X + 1 mm * sin(pi*X/2 m) * sin(3 s^-1 * t), Y, Z] }",
    available: true,
};
