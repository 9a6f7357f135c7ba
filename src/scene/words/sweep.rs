//! `sweep`, `trade` and what stands in them.

use crate::schema::{Choice, Declaration, Kind, Member, Parameter, Presence, Target, Word};

const OF: Parameter = Parameter {
    name: "of",
    kind: Kind::Expression,
    presence: Presence::Required("of = tension"),
    doc: "The scene or the drive of this file that is computed at every value.",
};

/// `sweep name { … }`
pub(in crate::scene) static SWEEP: Declaration = Declaration {
    word: "sweep",
    doc: "The same scene or drive over several values: `vary path = [values]`, where the path is that of `--set`. Several `vary` give every combination. The points are computed side by side and give the same bytes on any number of threads; no frames are written.",
    within: None,
    target: Target::Name,
    keys: &[OF],
    members: &[Member::Let, Member::Vary, Member::Expect],
    example: "sweep dispersion {\n  of = tension\n  vary artery.kappa = [0, 0.1, 0.226, 1/3]\n  record table { P = final(test.P)  slack = value(test.stretch, P = 10 kPa) }\n  plot force { curve = table.P over table.kappa }\n  expect table.P > 0 kPa at kappa = [0, 0.226]\n}",
    available: true,
};

/// `record name { … }` in a sweep
pub(in crate::scene) static SWEEP_RECORD: Declaration = Declaration {
    word: "record",
    doc: "A table with one row a point of the sweep: the varied values and the columns named here, each a number read from the tables of the scene or drive at that point.",
    within: Some("sweep"),
    target: Target::Name,
    keys: &[],
    members: &[Member::Columns],
    example: "record table { error = final(errors.x)  work = particle_updates }",
    available: true,
};

/// How values are laid out along the axes.
pub(super) const SCALES: &[Choice] = &[
    Choice { word: "linear", doc: "both axes in proportion" },
    Choice { word: "log_log", doc: "both axes logarithmic, as for an order of convergence" },
    Choice { word: "log_x", doc: "the abscissa logarithmic" },
    Choice { word: "log_y", doc: "the ordinate logarithmic" },
];

/// `plot name { … }` in a sweep
pub(in crate::scene) static SWEEP_PLOT: Declaration = Declaration {
    word: "plot",
    doc: "A figure of a sweep, drawn from its tables: a column of its own record over another, or a curve of every point in one figure.",
    within: Some("sweep"),
    target: Target::Name,
    keys: &[
        Parameter {
            name: "curve",
            kind: Kind::Curve,
            presence: Presence::Required("curve = table.P over table.kappa"),
            doc: "What is drawn; columns of a record of the scene or drive itself give one curve a point.",
        },
        Parameter {
            name: "scale",
            kind: Kind::Choice(SCALES),
            presence: Presence::Default("linear"),
            doc: "How values are laid out along the axes.",
        },
        Parameter {
            name: "slope",
            kind: Kind::Quantity("number"),
            presence: Presence::Default("none"),
            doc: "Order of the triangle drawn under the first curve; with scale = log_log.",
        },
    ],
    members: &[],
    example: "plot convergence { curve = table.error over table.spacing  scale = log_log  slope = 2 }",
    available: true,
};

const COSTS: &[Choice] = &[
    Choice { word: "particle_updates", doc: "particles times evaluations of the right-hand side" },
    Choice { word: "steps", doc: "time steps" },
    Choice { word: "particles", doc: "particles of the modelled part: memory" },
];

/// `trade name { … }`
pub(in crate::scene) static TRADE: Declaration = Declaration {
    word: "trade",
    doc: "The same scene over numerical choices, error against cost: a table, a figure with the settings no other beats in both, and the cheapest that keeps a tolerance.",
    within: None,
    target: Target::Name,
    keys: &[
        OF,
        Parameter {
            name: "error",
            kind: Kind::Expression,
            presence: Presence::Required("error = final(errors.x)"),
            doc: "The error, a number read from the tables of the scene; its magnitude counts.",
        },
        Parameter {
            name: "cost",
            kind: Kind::Choice(COSTS),
            presence: Presence::Default("particle_updates"),
            doc: "What is spent; none of these depends on the machine.",
        },
        Parameter {
            name: "tolerance",
            kind: Kind::Expression,
            presence: Presence::Default("none"),
            doc: "The error that is allowed, in the dimension of the error.",
        },
    ],
    members: &[Member::Let, Member::Vary, Member::Expect],
    example: "trade scheme {\n  of = wave\n  vary bar.spacing = [1 m/8, 1 m/16]\n  vary run.cfl = [0.3, 0.9]\n  error = final(errors.x)\n  tolerance = 1 mm\n}",
    available: true,
};

const SWEPT: &str = "in `record` of `sweep`, and in `error` of `trade`";
const CLAIMED: &str = "in `expect` of `sweep` and `trade`";

const fn word(word: &'static str, form: &'static str, context: &'static str, doc: &'static str) -> Word {
    Word { word, form, doc, context }
}

/// What a sweep reads from each of its points, and what can be claimed of it.
pub(in crate::scene) static SWEEP_WORDS: &[Word] = &[
    word("max", "max(record.column)", SWEPT, "Largest value of a column at this point of the sweep."),
    word("min", "min(record.column)", SWEPT, "Smallest value of a column at this point of the sweep."),
    word("initial", "initial(record.column)", SWEPT, "First value of a column at this point of the sweep."),
    word("final", "final(record.column)", SWEPT, "Last value of a column at this point of the sweep."),
    word(
        "value",
        "value(record.column, t = 1 ms)",
        SWEPT,
        "Value of a column where another of the same record first takes a value, linear between rows.",
    ),
    word("particles", "particles", SWEPT, "Particles of the modelled part of the scene."),
    word("steps", "steps", SWEPT, "Time steps of the scene."),
    word(
        "particle_updates",
        "particle_updates",
        SWEPT,
        "Particles times evaluations of the right-hand side: the work of the scene.",
    ),
    word(
        "order",
        "order(record.column)",
        CLAIMED,
        "Exponent p of |column| = c v^p in the first varied value v, by least squares on the logarithms; of several combinations of further varied values the smallest.",
    ),
    word(
        "least_order",
        "least_order(record.column)",
        CLAIMED,
        "The smallest of the exponents between neighbouring values of the first varied value.",
    ),
];

/// `vary path = [values]`
pub(super) static VARY: Word = Word {
    word: "vary",
    form: "vary strip.spacing = [0.5 mm, 0.25 mm]",
    doc: "Values that a sweep puts in the place of the one written; the path is block.key as in `--set`, `material.parameter` for a law.",
    context: "in `sweep` and `trade`",
};
