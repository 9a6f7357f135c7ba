//! `energy`, `material` and the `scene` that holds everything else.

use crate::schema::{Declaration, Kind, Member, Parameter, Presence, Target};

/// `energy name { … }`
pub(in crate::scene) static ENERGY: Declaration = Declaration {
    word: "energy",
    doc: "A strain energy per reference volume, written in invariants of the deformation; every stress is derived from it.",
    within: None,
    target: Target::Name,
    keys: &[Parameter {
        name: "psi",
        kind: Kind::Expression,
        presence: Presence::Required("psi = mu/2 * (I1bar - 3)"),
        doc: "The energy per reference volume, a pressure.",
    }],
    members: &[Member::Param, Member::Let, Member::Fibres, Member::Direction],
    example: "energy neo_hooke {\n  param mu : pressure > 0\n  psi = mu/2 * (I1bar - 3)\n}",
    available: true,
};

/// `material name { … }`
pub(in crate::scene) static MATERIAL: Declaration = Declaration {
    word: "material",
    doc: "An energy with numbers, a density and directions.",
    within: None,
    target: Target::Name,
    keys: &[
        Parameter {
            name: "energy",
            kind: Kind::Energy,
            presence: Presence::Required("energy = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 1 MPa)"),
            doc: "The strain energies, added.",
        },
        Parameter {
            name: "density",
            kind: Kind::Quantity("density"),
            presence: Presence::Required("density = 1000 kg/m^3"),
            doc: "Mass per reference volume.",
        },
    ],
    members: &[Member::Param, Member::Let, Member::Fibre],
    example: "material gel {\n  energy  = neo_hooke(mu = 10 kPa) + vol_quadratic(K = 1 MPa)\n  density = 1000 kg/m^3\n}",
    available: true,
};

/// `frame { … }` in a material
pub(in crate::scene) static FRAME: Declaration = Declaration {
    word: "frame",
    doc: "Unit directions by name, in which the fibres of the material are given.",
    within: Some("material"),
    target: Target::Absent,
    keys: &[],
    members: &[Member::Directions],
    example: "frame { theta = [0, 1, 0]  z = [1, 0, 0] }",
    available: true,
};

/// `scene name { … }`
pub(in crate::scene) static SCENE: Declaration = Declaration {
    word: "scene",
    doc: "Bodies of particles, what acts on them, what is recorded and what must hold.",
    within: None,
    target: Target::Name,
    keys: &[],
    members: &[Member::Let, Member::Expect],
    example: "scene stretch {\n  body cube { shape = box(1 m, 1 m, 1 m)  spacing = 0.1 m  material = gel }\n  hold cube.xmin\n  run { until = 1 s }\n}",
    available: true,
};
