//! Words of expressions: functions, invariants, probes, fields.

use crate::schema::Word;

const ANYWHERE: &str = "in every expression";
const ENERGY: &str = "in `energy`";
const PLACE: &str = "in functions of place and time";
const RECORD: &str = "in `record`";
const FIELD: &str = "field of at(…), max(…) and min(…) in `record`";
const EXPECT: &str = "in `expect`";
const SHAPE: &str = "in `shape`";

const fn word(word: &'static str, form: &'static str, context: &'static str, doc: &'static str) -> Word {
    Word { word, form, doc, context }
}

/// Functions and constants known everywhere.
pub(in crate::scene) static FUNCTIONS: &[Word] = &[
    word("exp", "exp(x)", ANYWHERE, "Exponential of a number."),
    word("ln", "ln(x)", ANYWHERE, "Natural logarithm of a number."),
    word("sqrt", "sqrt(x)", ANYWHERE, "Square root; the dimension is halved."),
    word("cbrt", "cbrt(x)", ANYWHERE, "Cube root; the dimension is divided by three."),
    word("abs", "abs(x)", ANYWHERE, "Absolute value."),
    word("min", "min(a, b)", ANYWHERE, "The lesser of two."),
    word("max", "max(a, b)", ANYWHERE, "The greater of two."),
    word(
        "pos",
        "pos(x)",
        ANYWHERE,
        "Macaulay bracket: x where positive, else 0; value and derivative 0 at 0.",
    ),
    word("if", "if(a < b, x, y)", ANYWHERE, "x where the comparison holds, else y."),
    word("sin", "sin(x)", ANYWHERE, "Sine of an angle."),
    word("cos", "cos(x)", ANYWHERE, "Cosine of an angle."),
    word("tan", "tan(x)", ANYWHERE, "Tangent of an angle."),
    word("tanh", "tanh(x)", ANYWHERE, "Hyperbolic tangent of a number."),
    word("cosh", "cosh(x)", ANYWHERE, "Hyperbolic cosine of a number."),
    word("erf", "erf(x)", ANYWHERE, "Error function of a number."),
    word("sum", "sum(i in 1 .. n, x)", ANYWHERE, "Sum over whole numbers, over a list or over the fibres."),
    word("unit", "unit([a, b, c])", ANYWHERE, "The vector divided by its length."),
    word("norm", "norm([a, b, c])", ANYWHERE, "Length of a vector."),
    word("tilt", "tilt(a, b, angle)", ANYWHERE, "cos(angle) a + sin(angle) b: a turned towards b."),
    word("pi", "pi", ANYWHERE, "3.14159…"),
];

/// Invariants of the deformation.
pub(in crate::scene) static ENERGY_WORDS: &[Word] = &[
    word("I1", "I1", ENERGY, "F : F"),
    word("I2", "I2", ENERGY, "H : H with H = cof F"),
    word("I3", "I3", ENERGY, "J^2"),
    word("J", "J", ENERGY, "Volume map, det F."),
    word("I1bar", "I1bar", ENERGY, "J^(-2/3) I1"),
    word("I2bar", "I2bar", ENERGY, "J^(-4/3) I2"),
    word("lam1", "lam1", ENERGY, "Greatest principal stretch."),
    word("lam2", "lam2", ENERGY, "Middle principal stretch."),
    word("lam3", "lam3", ENERGY, "Least principal stretch."),
    word("lam1bar", "lam1bar", ENERGY, "J^(-1/3) lam1"),
    word("lam2bar", "lam2bar", ENERGY, "J^(-1/3) lam2"),
    word("lam3bar", "lam3bar", ENERGY, "J^(-1/3) lam3"),
    word("I4", "I4(a)", ENERGY, "Squared stretch of a direction, |F a|^2."),
    word("I5", "I5(a)", ENERGY, "|C a|^2 with C = F^T F"),
    word("I4bar", "I4bar(a)", ENERGY, "J^(-2/3) I4(a)"),
    word("I5bar", "I5bar(a)", ENERGY, "J^(-4/3) I5(a)"),
    word("I8", "I8(a, b)", ENERGY, "F a . F b"),
    word("E", "E(a, b)", ENERGY, "Component of the Green strain, (F a . F b - a . b)/2."),
    word("dot", "dot(a, b)", ENERGY, "Cosine of the angle of two directions at rest, a . b."),
    word(
        "integrate",
        "integrate(n in sphere(24), x)",
        ENERGY,
        "Integral over the directions n of the unit sphere (4 pi of 1) by a product rule exact to the degree given; `sphere(24, I4bar(n) > 1)` takes only the directions that are stretched, where x must grow from 0. Or `integrate(s in 1 .. l, x)` of an x that depends on s alone: its slope by l is x at l, exactly.",
    ),
];

/// Coordinates of functions of place and time.
pub(in crate::scene) static PLACE_WORDS: &[Word] = &[
    word("X", "X", PLACE, "First reference coordinate."),
    word("Y", "Y", PLACE, "Second reference coordinate."),
    word("Z", "Z", PLACE, "Third reference coordinate."),
    word("r", "r", PLACE, "Distance from the z axis, sqrt(X^2 + Y^2)."),
    word("t", "t", PLACE, "Time."),
    word(
        "ramp",
        "ramp(a -> b, over = T)",
        PLACE,
        "From a to b in the time T with no velocity and no acceleration at either end, then b; with `shape = linear` at constant velocity.",
    ),
    word(
        "table",
        "table([0 ms, 1 ms, 2 ms], [0 mm, 1 mm, 0 mm])",
        PLACE,
        "Straight lines in time between values at ascending times, the first value before and the last after; columns of a csv(…) as well: table(data.t, data.u).",
    ),
];

/// Shapes of bodies.
pub(in crate::scene) static SHAPES: &[Word] = &[
    word(
        "box",
        "box(lx, ly, lz)",
        SHAPE,
        "Edges along the axes, from the origin to (lx, ly, lz) unless `centre = [x, y, z]` is given. Faces: xmin to zmax.",
    ),
    word(
        "cylinder",
        "cylinder(radius = 2 m, height = 1 m)",
        SHAPE,
        "Circular, along z unless `axis = x` or `y`; stands on the origin unless `centre` is given. Faces: zmin, zmax, side.",
    ),
    word(
        "ring",
        "ring(count = 4, radius = 1.3 m, start = 45 deg, of = cylinder(radius = 0.3 m, height = 1 m))",
        SHAPE,
        "Copies of a cylinder evenly spaced on a circle about its centre, the first at the angle `start`.",
    ),
    word(
        "dumbbell",
        "dumbbell(standard = astm_d412_die_c, thickness = 2.25 mm)",
        SHAPE,
        "Tensile specimen, long in x and flat on z = 0, middle at the origin unless `centre` is given. The die is gauge_length = 33 mm, gauge_width = 6 mm, tab_width = 25 mm, inner_radius = 25 mm, outer_radius = 14 mm; what is written beside it replaces it, and without a standard all five are required. Each tab is tab_length = 0 mm long. Faces: xmin, xmax, zmin, zmax, edge.",
    ),
];

/// Shapes read from files.
pub(in crate::scene) static FILE_SHAPES: &[Word] = &[
    word(
        "stl",
        "stl(\"part.stl\", scale = 1 mm)",
        SHAPE,
        "What a closed surface of triangles encloses, text or binary, in lengths of `scale`; nodes lie on the surface and on its sharp edges. A plane of symmetry, which the surface must have to a thousandth of its size, is a layer of nodes. Faces: xmin to zmax where an end is plane, all else is surface.",
    ),
    word(
        "vtu",
        "vtu(\"mesh.vtu\", scale = 1 mm)",
        SHAPE,
        "Hexahedra of a VTK file, every node a particle; `spacing` then only measures the smoothing length. With `symmetry` the file has the part of greater coordinates and ends in the plane, a face xmin, ymin or zmin. Points without cells need `volume = \"V\"`, a point array in cubes of `scale`, and integration_consistency = off. Faces: xmin to zmax where an end is plane, all else is surface.",
    ),
];

/// What a record can ask for.
pub(in crate::scene) static PROBES: &[Word] = &[
    word(
        "displacement",
        "displacement(body.face).x",
        RECORD,
        "Mean displacement of a face, or of a point: displacement(at = [X, Y, Z], body).x.",
    ),
    word(
        "twist",
        "twist(body.ymax)",
        RECORD,
        "Angle a plane face is turned about its axis relative to the opposite face, added up from layer to layer so that whole turns count; positive from y to z about x, and so on.",
    ),
    word("reaction", "reaction(body.face).x", RECORD, "Force the support of a face exerts on the body."),
    word(
        "section_force",
        "section_force(body, x = 0 mm).x",
        RECORD,
        "Force carried through a plane of the reference configuration.",
    ),
    word("at", "at(body, [X, Y, Z], sigma.xx)", RECORD, "A field at a reference point."),
    word(
        "mean",
        "mean(body, displacement.z, weight = if(r <= 0.8 m, 1, 0))",
        RECORD,
        "Mean of a field over a body in the reference configuration, weighted by a function of place (everywhere 1 without `weight`).",
    ),
    word(
        "roughness",
        "roughness(pressure)",
        RECORD,
        "Share of a field's variation that a linear fit to each particle's neighbours does not explain: 0 linear, about 1 without order, 0.9 a checkerboard.",
    ),
    word("kinetic_energy", "kinetic_energy", RECORD, "Kinetic energy."),
    word("strain_energy", "strain_energy", RECORD, "Strain energy."),
    word("total_energy", "total_energy", RECORD, "Kinetic and strain energy."),
    word("momentum", "momentum.x", RECORD, "Linear momentum."),
    word("angular_momentum", "angular_momentum.z", RECORD, "Angular momentum about the origin."),
    word(
        "impulse",
        "impulse(body.face)",
        RECORD,
        "Impulse since the start of the supports and loads of a face, or of all that acts on a body.",
    ),
    word("volume", "volume", RECORD, "Current volume."),
    word(
        "error",
        "error(x)",
        RECORD,
        "Root mean square of the difference from the exact motion of the scene, weighted by volume, in the unit of what is compared: x, v, F, H, J or P.",
    ),
    word(
        "mean_error",
        "mean_error(P)",
        RECORD,
        "Mean magnitude of the same difference, weighted by volume: an error confined to the boundary counts by its share of the volume.",
    ),
    word("gradient_error", "gradient_error", RECORD, "Largest |F - Grad x| over the particles."),
    word("area_map_error", "area_map_error", RECORD, "Largest |H - cof F| over the particles."),
    word("volume_map_error", "volume_map_error", RECORD, "Largest |J - det F| over the particles."),
    word("curl_F", "curl_F", RECORD, "Largest |CURL F| over the particles, times the spacing."),
    word("div_H", "div_H", RECORD, "Largest |DIV H| over the particles, times the spacing."),
];

/// Fields of particles.
pub(in crate::scene) static FIELD_WORDS: &[Word] = &[
    word("displacement", "displacement.x", FIELD, "Component of the displacement."),
    word("velocity", "velocity.x", FIELD, "Component of the velocity."),
    word("sigma", "sigma.xx", FIELD, "Component of the Cauchy stress."),
    word("P", "P.xx", FIELD, "Component of the first Piola-Kirchhoff stress."),
    word("F", "F.xx", FIELD, "Component of the deformation gradient."),
    word("von_mises", "von_mises", FIELD, "Von Mises stress."),
    word("pressure", "pressure", FIELD, "tr sigma/3, positive in tension."),
    word("J", "J", FIELD, "Volume map."),
];

/// What an expectation can ask of a recorded column.
pub(in crate::scene) static SAMPLES: &[Word] = &[
    word("max", "max(record.column)", EXPECT, "Largest value of a column."),
    word("min", "min(record.column)", EXPECT, "Smallest value of a column."),
    word("initial", "initial(record.column)", EXPECT, "First value of a column."),
    word(
        "integral",
        "integral(record.column)",
        EXPECT,
        "Integral of a column over time by the trapezoidal rule: exact for a force where every step is a row.",
    ),
    word("final", "final(record.column)", EXPECT, "Last value of a column."),
    word(
        "residual",
        "residual(motion)",
        EXPECT,
        "What the exact motion leaves of the momentum balance by finite differences, relative to its terms, at a point and time without symmetry.",
    ),
    word("never_grows", "never_grows(record.column)", EXPECT, "The column never exceeds what it was before."),
];
