//! What acts on bodies: supports, loads and the initial motion.

use crate::schema::{Choice, Declaration, Kind, Parameter, Presence, Target};

/// `hold body.face`
pub(in crate::scene) static HOLD: Declaration = Declaration {
    word: "hold",
    doc: "Holds every particle of a face where it is.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[],
    members: &[],
    example: "hold cube.xmin",
    available: true,
};

/// `slide body.face { … }`
pub(in crate::scene) static SLIDE: Declaration = Declaration {
    word: "slide",
    doc: "Holds a face along its normal and lets it slide freely in its plane.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[Parameter {
        name: "normal",
        kind: Kind::Field("length"),
        presence: Presence::Default("0 m"),
        doc: "Displacement along the outward normal.",
    }],
    members: &[],
    example: "slide plate.zmin { normal = 0 m }",
    available: true,
};

const GRIPS: &[Choice] = &[
    Choice { word: "rigid", doc: "no displacement in the plane of the face" },
    Choice { word: "sliding", doc: "free in the plane of the face" },
];

/// `pull body.face { … }`
pub(in crate::scene) static PULL: Declaration = Declaration {
    word: "pull",
    doc: "Moves a face along its outward normal.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[
        Parameter {
            name: "displacement",
            kind: Kind::Field("length"),
            presence: Presence::Required("displacement = ramp(0 mm -> 1 mm, over = 2 ms)"),
            doc: "Displacement along the outward normal; negative values push.",
        },
        Parameter {
            name: "grip",
            kind: Kind::Choice(GRIPS),
            presence: Presence::Required("grip = rigid"),
            doc: "What happens in the plane of the face.",
        },
    ],
    members: &[],
    example: "pull strip.xmax { displacement = ramp(0 mm -> 1 mm, over = 2 ms)  grip = rigid }",
    available: true,
};

/// `move body.face { … }`
pub(in crate::scene) static MOVE: Declaration = Declaration {
    word: "move",
    doc: "Moves a face, each component of its displacement as written; a component that is `free` is not prescribed.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[Parameter {
        name: "displacement",
        kind: Kind::VectorField("length"),
        presence: Presence::Required("displacement = [ramp(0 mm -> 1 mm, over = 2 ms), 0 mm, free]"),
        doc: "Components of the displacement along x, y, z, or `free`.",
    }],
    members: &[],
    example: "move cube.ymax { displacement = [ramp(0 mm -> 1 mm, over = 2 ms), 0 mm, free] }",
    available: true,
};

/// `traction body.face { … }`
pub(in crate::scene) static TRACTION: Declaration = Declaration {
    word: "traction",
    doc: "A dead force per reference area on a face.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[Parameter {
        name: "value",
        kind: Kind::VectorField("pressure"),
        presence: Presence::Required("value = [1 kPa, 0 Pa, 0 Pa]"),
        doc: "Force per reference area.",
    }],
    members: &[],
    example: "traction cube.xmax { value = [1 kPa, 0 Pa, 0 Pa] }",
    available: true,
};

/// `pressure body.face { … }`
pub(in crate::scene) static PRESSURE: Declaration = Declaration {
    word: "pressure",
    doc: "A pressure on the deformed face: a force against its current normal, per current area.",
    within: Some("scene"),
    target: Target::Face,
    keys: &[Parameter {
        name: "value",
        kind: Kind::Field("pressure"),
        presence: Presence::Required("value = ramp(0 kPa -> 10 kPa, over = 2 ms)"),
        doc: "The pressure; positive values push.",
    }],
    members: &[],
    example: "pressure wall.hole { value = ramp(0 kPa -> 10 kPa, over = 2 ms) }",
    available: true,
};

/// `body_force body { … }`
pub(in crate::scene) static BODY_FORCE: Declaration = Declaration {
    word: "body_force",
    doc: "A force per reference volume.",
    within: Some("scene"),
    target: Target::Body,
    keys: &[Parameter {
        name: "value",
        kind: Kind::VectorField("pressure/length"),
        presence: Presence::Required("value = [0 N/m^3, 0 N/m^3, -9.81 kN/m^3]"),
        doc: "Force per reference volume.",
    }],
    members: &[],
    example: "body_force cube { value = [0 N/m^3, 0 N/m^3, -9.81 kN/m^3] }",
    available: true,
};

/// `gravity { … }`
pub(in crate::scene) static GRAVITY: Declaration = Declaration {
    word: "gravity",
    doc: "A uniform acceleration of all bodies.",
    within: Some("scene"),
    target: Target::Absent,
    keys: &[Parameter {
        name: "acceleration",
        kind: Kind::Vector("acceleration"),
        presence: Presence::Required("acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2]"),
        doc: "The acceleration of free fall.",
    }],
    members: &[],
    example: "gravity { acceleration = [0 m/s^2, 0 m/s^2, -9.81 m/s^2] }",
    available: true,
};

/// `start body { … }`
pub(in crate::scene) static START: Declaration = Declaration {
    word: "start",
    doc: "The motion a body starts with; without it, it starts at rest.",
    within: Some("scene"),
    target: Target::Body,
    keys: &[Parameter {
        name: "velocity",
        kind: Kind::VectorField("velocity"),
        presence: Presence::Required("velocity = [0 m/s, 0 m/s, -10 m/s]"),
        doc: "Initial velocity, a function of the reference position X, Y, Z.",
    }],
    members: &[],
    example: "start plate { velocity = if(r <= 0.8 m, [0 m/s, 0 m/s, -10 m/s], [0 m/s, 0 m/s, 0 m/s]) }",
    available: true,
};
