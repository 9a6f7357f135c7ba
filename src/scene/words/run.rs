//! `run`: end time and numerical choices.

use crate::schema::{Choice, Declaration, Kind, Parameter, Presence, Target};

const SCHEMES: &[Choice] = &[
    Choice { word: "seed", doc: "the paper as printed" },
    Choice {
        word: "improved",
        doc: "with variational dissipation, integration consistency and velocity Verlet",
    },
];

const FORMULATIONS: &[Choice] = &[
    Choice { word: "auto", doc: "the smallest that loses nothing" },
    Choice { word: "pF", doc: "H and J derived from F" },
    Choice { word: "pFJ", doc: "J evolved, H derived" },
    Choice { word: "pFHJ", doc: "H and J evolved" },
];

const LOADINGS: &[Choice] = &[
    Choice { word: "dynamic", doc: "inertia is part of the answer" },
    Choice {
        word: "quasi_static",
        doc: "inertia is an error to be kept small: affine start, damped relative to it",
    },
];

const INTEGRATORS: &[Choice] = &[
    Choice { word: "tvd_rk2", doc: "two-stage TVD Runge-Kutta, the paper's" },
    Choice { word: "ssp_rk3", doc: "three-stage, third-order SSP Runge-Kutta" },
    Choice { word: "velocity_verlet", doc: "velocity Verlet" },
];

const KERNELS: &[Choice] = &[
    Choice { word: "wendland_c2", doc: "Wendland's C2 function of support 2 h" },
    Choice { word: "cubic_spline", doc: "the cubic B-spline of support 2 h" },
    Choice { word: "quintic_spline", doc: "the quintic B-spline of support 3 h" },
    Choice {
        word: "quadratic",
        doc: "the parabola of support 2 h, whose slope does not vanish at the centre",
    },
];

const STATES: &[Choice] = &[
    Choice { word: "off", doc: "no dissipation of momentum" },
    Choice { word: "constant", doc: "the particles' own momenta" },
    Choice {
        word: "variational",
        doc: "carried to the middle of the pair with the corrected gradient, in a frame that turns with the pair, and entering the balance as the derivative of a dissipation: it takes energy from any nodes and has no torque",
    },
];

const VOLUME: &[Choice] = &[
    Choice { word: "off", doc: "the volume map is not upwinded" },
    Choice { word: "on", doc: "as the paper prints it: nothing draws J back to det F" },
    Choice {
        word: "restoring",
        doc: "as printed, and J relaxes towards det F at the rate `volume_relaxation`, a term of ours",
    },
];

const ANGULAR_MOMENTUM: &[Choice] = &[
    Choice { word: "free", doc: "what forces and integrator make of it" },
    Choice {
        word: "projected",
        doc: "kept to round-off in free bodies by the least correction of the accelerations",
    },
];

const COMPLETENESS: &[Choice] = &[
    Choice { word: "linear", doc: "linear fields, the correction of Bonet and Kulasegaram" },
    Choice { word: "quadratic", doc: "quadratic fields as well" },
];

const BOUNDARY_GRADIENTS: &[Choice] = &[
    Choice { word: "one_sided", doc: "what linear exactness leaves of one-sided neighbours" },
    Choice { word: "centroid", doc: "those half-way to the centroid of the volume a node stands for" },
];

/// `on` and `off`.
const SWITCH: &[Choice] = &[Choice { word: "on", doc: "yes" }, Choice { word: "off", doc: "no" }];

/// `run { … }`
pub(in crate::scene) static RUN: Declaration = Declaration {
    word: "run",
    doc: "The end time and the numerical choices.",
    within: Some("scene"),
    target: Target::Absent,
    keys: &[
        Parameter {
            name: "until",
            kind: Kind::Quantity("time"),
            presence: Presence::Required("until = 2 ms"),
            doc: "End time.",
        },
        Parameter {
            name: "scheme",
            kind: Kind::Choice(SCHEMES),
            presence: Presence::Default("improved"),
            doc: "The set the defaults of the other choices come from.",
        },
        Parameter {
            name: "formulation",
            kind: Kind::Choice(FORMULATIONS),
            presence: Presence::ByScheme { seed: "pFHJ", improved: "auto" },
            doc: "Which maps are evolved beside momentum and deformation gradient.",
        },
        Parameter {
            name: "loading",
            kind: Kind::Choice(LOADINGS),
            presence: Presence::Default("dynamic"),
            doc: "Whether inertia is part of the answer.",
        },
        Parameter {
            name: "damping",
            kind: Kind::Quantity("frequency"),
            presence: Presence::Default("chosen by the plan"),
            doc: "Damping rate of quasi-static loading, relative to the affine motion.",
        },
        Parameter {
            name: "integrator",
            kind: Kind::Choice(INTEGRATORS),
            presence: Presence::ByScheme { seed: "tvd_rk2", improved: "velocity_verlet" },
            doc: "How time is stepped.",
        },
        Parameter {
            name: "cfl",
            kind: Kind::Quantity("number"),
            presence: Presence::ByScheme {
                seed: "0.3; 0.8 with ssp_rk3, 0.9 with velocity_verlet",
                improved: "0.9; 0.8 with ssp_rk3, 0.3 with tvd_rk2",
            },
            doc: "The time step as a fraction of the time a pressure wave takes from particle to particle. Undamped waves are stable to 1 with velocity_verlet, to 0.866 with ssp_rk3, and with tvd_rk2 at no step.",
        },
        Parameter {
            name: "kernel",
            kind: Kind::Choice(KERNELS),
            presence: Presence::Default("wendland_c2"),
            doc: "The smoothing kernel.",
        },
        Parameter {
            name: "smoothing",
            kind: Kind::Quantity("number"),
            presence: Presence::Default(
                "1.01, with completeness = quadratic 1.2, or 0.8 with quintic_spline",
            ),
            doc: "Smoothing length as a multiple of the spacing; the kernel reaches two or three times as far.",
        },
        Parameter {
            name: "integration_consistency",
            kind: Kind::Choice(SWITCH),
            presence: Presence::ByScheme { seed: "off", improved: "on" },
            doc: "Whether the gradients are corrected so that uniform stress is in equilibrium with its tractions.",
        },
        Parameter {
            name: "completeness",
            kind: Kind::Choice(COMPLETENESS),
            presence: Presence::Default("linear"),
            doc: "Fields whose gradients are exact, at displaced nodes and boundaries too. `quadratic` makes stress and volume of second order as well, whatever the jitter, by volumes and areas that integrate quadratic fields and gradients whose forces are exact for linear stresses; of a body with a curved face, whose volumes stay, only the gradients are made so. It has twice the neighbours and takes up to twice the steps, and needs three layers of particles across the body (four where they are displaced) and integration_consistency = on.",
        },
        Parameter {
            name: "boundary_gradients",
            kind: Kind::Choice(BOUNDARY_GRADIENTS),
            presence: Presence::Default("one_sided"),
            doc: "Where linear gradients see fields of second degree, at boundaries and displaced nodes. One-sided gradients make thin bodies soft in bending, by 15, 11 and 6 % at four, five and seven layers of particles; `centroid` makes the sum of energies over the particles exact for such fields, bending within 1 % from five layers on, at set-up and for no more time a step. Stress and deformation of a particle on a plane face are then those a sixth of a spacing inside. It needs integration_consistency = on; completeness = quadratic has no use for it.",
        },
        Parameter {
            name: "momentum_dissipation",
            kind: Kind::Choice(STATES),
            presence: Presence::ByScheme { seed: "constant", improved: "variational" },
            doc: "The states between which the Riemann solver upwinds momentum.",
        },
        Parameter {
            name: "pressure_wave_weight",
            kind: Kind::Quantity("number"),
            presence: Presence::Default("1"),
            doc: "Factor of the pressure wave speed in the momentum dissipation. A quarter takes a sixth fewer steps and loses less energy, but lets waves of the lattice spread: orders of convergence become irregular.",
        },
        Parameter {
            name: "shear_wave_weight",
            kind: Kind::Quantity("number"),
            presence: Presence::Default("1"),
            doc: "Factor of the shear wave speed in the momentum dissipation.",
        },
        Parameter {
            name: "hourglass_stiffness",
            kind: Kind::Quantity("number"),
            presence: Presence::ByScheme { seed: "0", improved: "1" },
            doc: "Stiffness against displacements that no particle's gradient sees, in shear moduli at rest of what is between the fibres.",
        },
        Parameter {
            name: "volume_dissipation",
            kind: Kind::Choice(VOLUME),
            presence: Presence::ByScheme { seed: "on", improved: "off" },
            doc: "Whether the volume map is upwinded; it needs a formulation that evolves J.",
        },
        Parameter {
            name: "volume_wave_weight",
            kind: Kind::Quantity("number"),
            presence: Presence::Default("1"),
            doc: "Factor of the volume dissipation; 1 is as printed, 1/(2 c_p).",
        },
        Parameter {
            name: "volume_relaxation",
            kind: Kind::Quantity("frequency"),
            presence: Presence::Default("chosen by the plan"),
            doc: "Rate at which J relaxes towards det F with `volume_dissipation = restoring`.",
        },
        Parameter {
            name: "angular_momentum",
            kind: Kind::Choice(ANGULAR_MOMENTUM),
            presence: Presence::Default("free"),
            doc: "Whether the angular momentum of bodies that nothing holds is kept exactly.",
        },
        Parameter {
            name: "wave_speed_every",
            kind: Kind::Count,
            presence: Presence::ByScheme { seed: "0", improved: "100" },
            doc: "Most steps between two refreshes of the wave speed, which come sooner where the body has strained enough to change it by some 2 %; 0 keeps the speed at rest. The step is held until it must shrink, for one that follows the state would feed an undamped motion.",
        },
    ],
    members: &[],
    example: "run { until = 2 ms  loading = quasi_static }",
    available: true,
};
