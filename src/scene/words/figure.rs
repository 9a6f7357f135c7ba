//! `figure`, its sources, and what stands in a `plot`.

use crate::schema::{Choice, Declaration, Kind, Member, Parameter, Presence, Target, Word};

const fn optional(name: &'static str, kind: Kind, without: &'static str, doc: &'static str) -> Parameter {
    Parameter { name, kind, presence: Presence::Default(without), doc }
}

const fn required(name: &'static str, kind: Kind, example: &'static str, doc: &'static str) -> Parameter {
    Parameter { name, kind, presence: Presence::Required(example), doc }
}

/// A block within a plot: named, with nothing but keys.
const fn part(
    word: &'static str,
    doc: &'static str,
    keys: &'static [Parameter],
    example: &'static str,
) -> Declaration {
    let (within, target) = (Some("plot"), Target::Name);
    Declaration { word, doc, within, target, keys, members: &[], example, available: true }
}

/// `figure name { … }`
pub(in crate::scene) static FIGURE: Declaration = Declaration {
    word: "figure",
    doc: "A numbered figure drawn from the tables and frames of one or several runs; `tissue figures` makes it.",
    within: None,
    target: Target::Name,
    keys: &[
        required("number", Kind::Count, "number = 1", "Its number, also the beginning of its files' names."),
        required("title", Kind::Text, "title = \"Force over displacement\"", "What it shows, one line."),
        optional("columns", Kind::Count, "2", "Pictures in a row, where it has several plots."),
    ],
    members: &[Member::Let],
    example: "figure forces {\n  number = 8\n  title  = \"Force over displacement\"\n  source axial { file = \"../artery/axial.tissue\"  scene = axial }\n  plot force { curve = axial.pull.F over axial.pull.d }\n}",
    available: true,
};

/// `source name { … }`
pub(in crate::scene) static SOURCE: Declaration = Declaration {
    word: "source",
    doc: "A run whose results the figure shows: its tables and frames are called `source.record`.",
    within: Some("figure"),
    target: Target::Name,
    keys: &[
        required("file", Kind::Text, "file = \"../artery/axial.tissue\"", "The file, relative to this one."),
        required("scene", Kind::Expression, "scene = axial", "The scene or drive of that file."),
        optional(
            "full",
            Kind::Settings,
            "set()",
            "Values in place of those written there, as `--set` gives them.",
        ),
        optional(
            "quick",
            Kind::Settings,
            "those of `full`",
            "Further values for `tissue figures --quick`: coarse and short.",
        ),
    ],
    members: &[],
    example: "source axial { file = \"../artery/axial.tissue\"  scene = axial  quick = set(strip.spacing = 0.5 mm) }",
    available: true,
};

const VIEWS: &[Choice] = &[
    Choice { word: "xy", doc: "x to the right, y upwards" },
    Choice { word: "xz", doc: "x to the right, z upwards" },
    Choice { word: "yz", doc: "y to the right, z upwards" },
    Choice { word: "oblique", doc: "from above one side: x mostly to the right, z upwards, y into the page" },
    Choice {
        word: "corner",
        doc: "from the origin of a quarter model: its two planes of symmetry and its top",
    },
];

const AXES: &[Choice] = &[
    Choice { word: "x", doc: "the plane normal to x" },
    Choice { word: "y", doc: "the plane normal to y" },
    Choice { word: "z", doc: "the plane normal to z" },
];

/// Keys of a `plot`.
pub(super) const PLOT_KEYS: &[Parameter] = &[
    optional("curve", Kind::Curve, "none", "What is drawn as a line."),
    optional("points", Kind::Curve, "none", "Reference data drawn as markers: columns of a csv(…)."),
    optional("title", Kind::Text, "the scene's name and the plot's", "Line above the picture."),
    optional("x_label", Kind::Text, "the column's name", "What the abscissa is; the unit is added."),
    optional("y_label", Kind::Text, "the column's name", "What the ordinate is; the unit is added."),
    optional("x_range", Kind::Range, "all values", "Ends of the abscissa; what lies beyond is cut off."),
    optional("y_range", Kind::Range, "all values", "Ends of the ordinate; what lies beyond is cut off."),
    optional(
        "scale",
        Kind::Choice(super::sweep::SCALES),
        "linear",
        "How values are laid out along the axes of curves.",
    ),
    optional("field", Kind::Expression, "none", "The field the panels are coloured by: `field = sigma.xx`."),
    optional("label", Kind::Text, "the field as written", "What the colours mean; the unit is added."),
    optional(
        "range",
        Kind::Range,
        "the values seen",
        "Values at the ends of the colour bar; beyond, the colour stays that of the end, which is drawn as a tip with the farthest value.",
    ),
    optional("view", Kind::Choice(VIEWS), "xy", "From where bodies are seen."),
    optional(
        "mirror",
        Kind::Choices(AXES),
        "all planes of symmetry",
        "Planes of symmetry at which the image is added: `mirror = []` shows the part that is modelled.",
    ),
    optional("columns", Kind::Count, "1", "Panels in a row."),
];

const MARKS: &[Choice] = &[
    Choice { word: "line", doc: "a line" },
    Choice { word: "dashed", doc: "a dashed line" },
    Choice { word: "markers", doc: "hollow markers" },
    Choice { word: "line_markers", doc: "a line with full markers" },
];

/// In the order of the palette.
const COLOURS: &[Choice] = &[
    Choice { word: "blue", doc: "blue, circles" },
    Choice { word: "vermilion", doc: "vermilion, squares" },
    Choice { word: "green", doc: "bluish green, triangles" },
    Choice { word: "purple", doc: "reddish purple, diamonds" },
    Choice { word: "orange", doc: "orange, circles" },
    Choice { word: "sky", doc: "sky blue, squares" },
    Choice { word: "black", doc: "black, triangles" },
];

/// `series name { … }`
pub(in crate::scene) static SERIES: Declaration = part(
    "series",
    "A curve or a set of points, of a record or of a csv(…), or of single numbers read from several runs.",
    &[
        optional("draw", Kind::Curve, "none", "One column over another: `draw = pull.F over pull.d`."),
        optional(
            "points",
            Kind::Expression,
            "none",
            "Instead of `draw` a list of points `[abscissa, ordinate]`, each a formula over numbers read from the tables of the runs.",
        ),
        optional("label", Kind::Text, "none", "Its line in the legend."),
        optional(
            "mark",
            Kind::Choice(MARKS),
            "line, markers for a csv(…) and for points",
            "How it is drawn.",
        ),
        optional("colour", Kind::Choice(COLOURS), "the next of the palette", "Its colour and markers."),
    ],
    "series reference { draw = fe.F over fe.d  label = \"finite elements\"  mark = markers  colour = blue }",
);

const POINT: &str = "in `points` of `series`";

/// Numbers of which the points of a series are made.
pub(in crate::scene) static SERIES_WORDS: &[Word] = &[
    word("max", "max(record.column)", "Largest value of a column."),
    word("min", "min(record.column)", "Smallest value of a column."),
    word("initial", "initial(record.column)", "First value of a column."),
    word("final", "final(record.column)", "Last value of a column."),
    word(
        "value",
        "value(record.column, F = 1 N)",
        "Value of a column where another of the same record first takes a value, linear between rows; of a csv(…) by a spline, as in `expect`.",
    ),
    word(
        "spacing",
        "spacing(source.body)",
        "Spacing of a body in the run that was made, the quick one as well.",
    ),
];

const fn word(word: &'static str, form: &'static str, doc: &'static str) -> Word {
    Word { word, form, doc, context: POINT }
}

/// `band name { … }`
pub(in crate::scene) static BAND: Declaration = part(
    "band",
    "A filled region behind the curves, as for a measured range.",
    &[
        required(
            "corners",
            Kind::Expression,
            "corners = [[1.37, 13.2 MPa], [1.71, 13.2 MPa], [1.71, 30 MPa], [1.37, 30 MPa]]",
            "Abscissa and ordinate of its corners in order.",
        ),
        optional("label", Kind::Text, "none", "Its line in the legend."),
        optional("colour", Kind::Choice(COLOURS), "black", "The colour of which a tint is drawn."),
    ],
    "band measured { corners = [[1, 0 Pa], [1.2, 1 kPa], [1.2, 2 kPa]]  label = \"measured\" }",
);

/// `panel name { … }`
pub(in crate::scene) static PANEL: Declaration = part(
    "panel",
    "The deformed bodies at one time, coloured by the plot's field.",
    &[
        required("frames", Kind::Expression, "frames = fields", "The frames it is taken from."),
        optional(
            "time",
            Kind::Quantity("time"),
            "the last frame",
            "The time; between two frames positions and values run linearly.",
        ),
        optional(
            "when",
            Kind::Expression,
            "none",
            "The time is that at which a column first has a value: `when = pull.F == 1 N`.",
        ),
        optional("caption", Kind::Text, "none", "Line below it."),
    ],
    "panel late { frames = fields  time = 0.1 s  caption = \"0.1 s\" }",
);

/// `outline name { … }`
pub(in crate::scene) static OUTLINE: Declaration = part(
    "outline",
    "The outline of a body in the reference configuration, from where the plot sees it.",
    &[required("body", Kind::Expression, "body = strip", "The whole body.")],
    "outline plate { body = plate }",
);

/// `disc name { … }`
pub(in crate::scene) static DISC: Declaration = part(
    "disc",
    "A filled disc below the outlines, as for a loaded region.",
    &[
        required("centre", Kind::Expression, "centre = [0 m, 0 m]", "Its centre on the page's plane."),
        required("radius", Kind::Quantity("length"), "radius = 0.8 m", "Its radius."),
        optional("colour", Kind::Choice(COLOURS), "vermilion", "The colour of which a tint is drawn."),
    ],
    "disc loaded { centre = [0 m, 0 m]  radius = 0.8 m }",
);

/// `dimension name { … }`
pub(in crate::scene) static DIMENSION: Declaration = part(
    "dimension",
    "A dimension line; its number is the distance of its ends.",
    &[
        required("from", Kind::Expression, "from = [0 mm, 0 mm]", "One end on the page's plane."),
        required("to", Kind::Expression, "to = [33 mm, 0 mm]", "The other end."),
        optional(
            "offset",
            Kind::Quantity("length"),
            "0 m",
            "How far the line lies beside them, to the left of the way from one to the other.",
        ),
        optional("text", Kind::Text, "none", "What stands before the number."),
    ],
    "dimension gauge { from = [-16.5 mm, 3 mm]  to = [16.5 mm, 3 mm]  offset = 8 mm  text = \"gauge\" }",
);

/// `note name { … }`
pub(in crate::scene) static NOTE: Declaration = part(
    "note",
    "A text in a drawing, with a line to what it names.",
    &[
        required("text", Kind::Text, "text = \"held\"", "The text."),
        required("at", Kind::Expression, "at = [0 mm, 0 mm]", "Where it begins on the page's plane."),
        optional("to", Kind::Expression, "none", "What it names."),
    ],
    "note loaded { text = \"loaded\"  at = [1 m, 2 m]  to = [0.5 m, 0.5 m] }",
);
