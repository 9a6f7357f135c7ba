//! The description a plan is made from: no text but names, all numbers SI, all dimensions proved.

use crate::discretisation::{Consistency, Kernel, Shape};
use crate::energy::Leaf;
use crate::expression::Tape;
use crate::fit::Range;

/// Where something was written, for the reasons a plan gives and the errors a run ends with.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// The file as named on the command line or by the import.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// A resolved file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Materials in order.
    pub materials: Vec<Material>,
    /// Scenes in order.
    pub scenes: Vec<Scene>,
    /// Drives of a material point in order.
    pub drives: Vec<super::Drive>,
    /// Sweeps and trades in order.
    pub sweeps: Vec<super::Sweep>,
    /// Figures in order.
    pub figures: Vec<super::FigureOf>,
    /// Fits in order.
    pub fits: Vec<super::Fit>,
    /// What must hold of materials, in order.
    pub checks: Vec<Check>,
}

/// What must hold of a material's law.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Where it is written.
    pub place: Place,
    /// The material.
    pub material: Material,
    /// Properties that must hold, by the names its audit gives them.
    pub require: Vec<String>,
    /// Smallest and largest stretch to be expected, if written.
    pub stretches: Option<[f64; 2]>,
}

/// A hyperelastic material.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Reference density ρR, kg/m³.
    pub density: f64,
    /// Strain energy per reference volume, Pa.
    pub energy: Tape<Leaf>,
    /// Values of the energy's parameter leaves, SI.
    pub parameters: Vec<MaterialParameter>,
    /// Formulas given in place of numbers.
    pub constraints: Vec<Constraint>,
    /// Names of the energies summed, as written, with where each was declared.
    pub terms: Vec<(String, Place)>,
    /// Named directions, the indices of the invariants.
    pub directions: Vec<Direction>,
    /// Directions of its frame, known by name to a drive.
    pub frame: Vec<Direction>,
}

/// One parameter of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialParameter {
    /// Its name, qualified by the energy if need be: `goh.kappa`.
    pub name: String,
    /// SI value.
    pub value: f64,
    /// Unit symbol of the SI value.
    pub unit: String,
    /// Where it may lie, as declared; SI.
    pub range: Range,
    /// Whether a direction of the material depends on it.
    pub turns_direction: bool,
}

/// A formula given to a parameter of an energy, which must stay in the parameter's range.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// Name of the parameter: `goh.C`.
    pub name: String,
    /// Its value; the leaves are parameters of the material.
    pub value: Tape<Leaf>,
    /// Where it may lie; SI.
    pub range: Range,
}

/// A unit direction, possibly a function of the reference position.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its components.
    pub components: [Tape<Coordinate>; 3],
}

/// Leaves of fields written as text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// Reference coordinate 0, 1 or 2, m.
    X(u8),
    /// Time, s.
    Time,
}

/// A particle scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Materials its bodies use.
    pub materials: Vec<Material>,
    /// Its bodies.
    pub bodies: Vec<Body>,
    /// Planes of symmetry: through the centre of the bodies, normal to x, y, z; the part of greater
    /// coordinates is modelled.
    pub symmetry: [Option<SymmetryPlane>; 3],
    /// Faces of two bodies that move as one.
    pub bonds: Vec<Bond>,
    /// Prescribed motions of faces.
    pub prescribed: Vec<Prescribed>,
    /// Tractions and body forces.
    pub loads: Vec<Load>,
    /// Initial velocity fields.
    pub starts: Vec<Start>,
    /// An exact motion the bodies are to follow.
    pub motion: Option<Motion>,
    /// Numerical choices.
    pub run: Run,
    /// Tables to write.
    pub records: Vec<Record>,
    /// Frames to write.
    pub frames: Vec<Frames>,
    /// Figures to draw.
    pub plots: Vec<Plot>,
    /// What must hold.
    pub expectations: Vec<Expectation>,
}

/// A plane of symmetry.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetryPlane {
    /// Its coordinate, m.
    pub at: f64,
    /// Where it is declared.
    pub place: Place,
}

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its shape, the whole body's.
    pub shape: Shape,
    /// Node spacing, m.
    pub spacing: f64,
    /// Random displacement of inner nodes as a fraction of the spacing.
    pub jitter: f64,
    /// Index into the scene's materials.
    pub material: usize,
}

/// A face of a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Index of the body.
    pub body: usize,
    /// Name of the face.
    pub face: String,
}

/// Two faces of different bodies whose nodes are shared.
#[derive(Debug, Clone, PartialEq)]
pub struct Bond {
    /// Where it is declared.
    pub place: Place,
    /// One face.
    pub first: Region,
    /// The other.
    pub second: Region,
}

/// Prescribed displacement of the nodes of a face; a free component is `None`.
#[derive(Debug, Clone, PartialEq)]
pub struct Prescribed {
    /// The word that asked for it: `hold`, `slide`, `pull`, `move`.
    pub word: String,
    /// Where it is declared.
    pub place: Place,
    /// Where it acts.
    pub region: Region,
    /// Displacement of each component over time (and place), m.
    pub displacement: [Option<Tape<Coordinate>>; 3],
}

/// A load.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Load {
    /// Dead traction per reference area, Pa.
    Traction {
        /// Where it is declared.
        place: Place,
        /// Where it acts.
        region: Region,
        /// Its components.
        traction: [Tape<Coordinate>; 3],
    },
    /// Pressure on the deformed face, Pa.
    Pressure {
        /// Where it is declared.
        place: Place,
        /// Where it acts.
        region: Region,
        /// Its value, positive where it pushes.
        pressure: Tape<Coordinate>,
    },
    /// Force per reference volume, N/m³.
    BodyForce {
        /// Where it is declared.
        place: Place,
        /// The body it acts on.
        body: usize,
        /// Its components.
        force: [Tape<Coordinate>; 3],
    },
    /// Acceleration of gravity on all bodies, m/s².
    Gravity {
        /// Where it is declared.
        place: Place,
        /// Its components.
        acceleration: [f64; 3],
    },
}

/// An initial velocity field.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// Where it is declared.
    pub place: Place,
    /// The body it acts on.
    pub body: usize,
    /// Components, m/s.
    pub velocity: [Tape<Coordinate>; 3],
}

/// An exact motion: initial state, body force and boundary data follow from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Where it is declared.
    pub place: Place,
    /// Components of `x(X, t)`, m.
    pub position: [Tape<Coordinate>; 3],
    /// Whether the body force `ρR ∂²x/∂t² − DIV P` acts.
    pub body_force: bool,
    /// Faces that carry the exact traction `P N`; what they are moved by stands among the prescribed.
    pub loaded: Vec<Region>,
}

/// A set of numerical choices: the paper's or ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scheme {
    /// The paper as printed.
    Seed,
    /// With the improvements of this project.
    Improved,
}

/// Which maps are evolved beside p and F.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// H and J derived from F.
    Pf,
    /// J evolved, H derived.
    Pfj,
    /// H and J evolved.
    Pfhj,
}

/// Time integrators.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Integrator {
    /// Two-stage TVD Runge–Kutta (Heun), the paper's.
    TvdRk2,
    /// Three-stage, third-order strong-stability-preserving Runge–Kutta.
    SspRk3,
    /// Velocity Verlet.
    VelocityVerlet,
}

/// How the load is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loading {
    /// Inertia is part of the answer.
    Dynamic,
    /// Inertia is an error to be kept small: starts from the affine velocity field and is damped
    /// relative to it, at this rate (1/s; `None` lets the plan choose).
    QuasiStatic {
        /// Damping rate, 1/s.
        damping: Option<f64>,
    },
}

/// Interface states of the momentum dissipation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InterfaceStates {
    /// No dissipation of momentum.
    Off,
    /// The particles' own momenta.
    Constant,
    /// Carried to the middle of the pair with the corrected gradient.
    Linear,
    /// Likewise, limited so that no pair gains energy.
    Limited,
}

/// Dissipation of the volume map, D(J).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VolumeDissipation {
    /// None.
    Off,
    /// As printed.
    On,
    /// As printed, and J relaxes towards `det F` at a rate (1/s; `None` lets the plan choose).
    Restoring {
        /// Relaxation rate, 1/s.
        rate: Option<f64>,
    },
}

/// What becomes of the angular momentum of a free body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AngularMomentum {
    /// What the forces and the integrator make of it.
    Free,
    /// Kept to round-off by a least correction of the accelerations.
    Projected,
}

/// Numerical choices of `run { … }`, defaults filled in by the scheme.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Where the block stands.
    pub place: Place,
    /// End time, s.
    pub until: f64,
    /// The scheme the defaults come from.
    pub scheme: Scheme,
    /// `None` lets the plan choose the smallest that loses nothing.
    pub formulation: Option<Formulation>,
    /// How the load is meant.
    pub loading: Loading,
    /// Time integrator.
    pub integrator: Integrator,
    /// `α_CFL` of (42).
    pub cfl: f64,
    /// Kernel.
    pub kernel: Kernel,
    /// `h/dx`.
    pub smoothing: f64,
    /// Integration consistency on or off.
    pub consistency: Consistency,
    /// Interface states of D(p).
    pub momentum_dissipation: InterfaceStates,
    /// Weight of `c_p` in `S_p`.
    pub pressure_wave_weight: f64,
    /// Weight of `c_s` in `S_p`.
    pub shear_wave_weight: f64,
    /// Stiffness against hourglass modes, in shear moduli at rest; 0 for none.
    pub hourglass_stiffness: f64,
    /// D(J).
    pub volume_dissipation: VolumeDissipation,
    /// Angular momentum of free bodies.
    pub angular_momentum: AngularMomentum,
    /// Steps between two refreshes of the wave speed.
    pub wave_speed_every: u32,
    /// Which of the choices above were written in the file, by key.
    pub written: Vec<String>,
}

/// A table sampled in time.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Columns after `t`.
    pub columns: Vec<Column>,
    /// Sampling interval, s.
    pub every: f64,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Its value.
    pub value: Tape<Probe>,
    /// SI unit symbol, empty for a number.
    pub unit: String,
    /// The expression as written.
    pub text: String,
}

/// What a record can ask of the state; always the whole body's, symmetry accounted for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Probe {
    /// Time, s.
    Time,
    /// Mean displacement of a face, m.
    Displacement {
        /// The face.
        region: Region,
        /// Component.
        axis: u8,
    },
    /// Displacement at a reference point, m.
    DisplacementAt {
        /// The body.
        body: usize,
        /// The point, m.
        point: [f64; 3],
        /// Component.
        axis: u8,
    },
    /// Angle a plane face has turned about its axis relative to the opposite one, rad.
    Twist {
        /// The face.
        region: Region,
    },
    /// Force the support of a face exerts on the body, N.
    Reaction {
        /// The face.
        region: Region,
        /// Component.
        axis: u8,
    },
    /// Force carried through the plane `X_normal = at`, N.
    SectionForce {
        /// The body.
        body: usize,
        /// Axis of the plane's normal.
        normal: u8,
        /// Coordinate of the plane, m.
        at: f64,
        /// Component.
        axis: u8,
    },
    /// A field at a reference point.
    FieldAt {
        /// The body.
        body: usize,
        /// The point, m.
        point: [f64; 3],
        /// The field.
        field: Field,
    },
    /// Mean of a field over a body, weighted by place.
    Mean {
        /// The body.
        body: usize,
        /// The field.
        field: Field,
        /// The weight, a number.
        weight: Tape<Coordinate>,
    },
    /// How much a field alternates from particle to particle.
    Roughness(Field),
    /// Largest value of a field over all particles.
    FieldMax(Field),
    /// Smallest value of a field over all particles.
    FieldMin(Field),
    /// `Σ V_a ½ |p|²/ρR`, J.
    KineticEnergy,
    /// `Σ V_a ψ_a`, J.
    StrainEnergy,
    /// Kinetic and strain energy, J.
    TotalEnergy,
    /// `Σ V_a p_a`, kg m/s.
    Momentum(u8),
    /// `Σ V_a x_a × p_a`, kg m²/s.
    AngularMomentum(u8),
    /// Impulse since the start of what acts on a face or on a whole body, N s.
    Impulse {
        /// Index of the body.
        body: usize,
        /// The face; `None` is all that acts on the body.
        face: Option<String>,
        /// Component.
        axis: u8,
    },
    /// `Σ V_a J_a`, m³.
    Volume,
    /// Difference from the exact motion, weighted by volume, SI.
    MotionError(MotionField, Norm),
    /// `max |F_a − Grad_h x|`.
    GradientError,
    /// `max |H_a − cof F_a|`.
    AreaMapError,
    /// `max |J_a − det F_a|`.
    VolumeMapError,
    /// `max |CURL_h F|·dx`.
    CurlF,
    /// `max |DIV_h H|·dx`.
    DivH,
}

/// How differences at the particles become one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Norm {
    /// Root of the volume-weighted mean of the squares.
    RootMeanSquare,
    /// Volume-weighted mean of the magnitudes.
    Mean,
}

/// What of a state is compared with the exact motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MotionField {
    /// Position, m.
    Position,
    /// Velocity, m/s.
    Velocity,
    /// Deformation gradient.
    Gradient,
    /// Area map, evolved or derived.
    AreaMap,
    /// Volume map, evolved or derived.
    VolumeMap,
    /// First Piola–Kirchhoff stress, Pa.
    Stress,
}

/// A scalar field of the particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// Component of the displacement, m.
    Displacement(u8),
    /// Component of the velocity, m/s.
    Velocity(u8),
    /// Component of the Cauchy stress, Pa.
    Sigma(u8, u8),
    /// Component of the first Piola–Kirchhoff stress, Pa.
    P(u8, u8),
    /// Component of the deformation gradient.
    F(u8, u8),
    /// Von Mises stress, Pa.
    VonMises,
    /// Pressure `tr σ/3` (positive in tension, as the paper plots it), Pa.
    Pressure,
    /// `J`.
    J,
}

/// Frames written for a viewer.
#[derive(Debug, Clone, PartialEq)]
pub struct Frames {
    /// Its name, also of the files.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Names of the fields asked for: `displacement`, `velocity`, `sigma`, `von_mises`, `pressure`, `J`, `F`, `P`.
    pub values: Vec<String>,
    /// Interval, s.
    pub every: f64,
}

/// A table from a file, its columns renamed.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Where it is named.
    pub place: Place,
    /// Path as written, relative to the file that names it.
    pub path: String,
    /// Columns in SI, by the name given in the scene.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Its name, also of the file.
    pub name: String,
    /// Where it is declared.
    pub place: Place,
    /// Curves.
    pub curves: Vec<Curve>,
    /// Reference points.
    pub points: Vec<ReferenceCurve>,
    /// Everything else.
    pub picture: super::Picture,
}

/// One record column over another.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The record.
    pub record: String,
    /// Column of the ordinate.
    pub y: String,
    /// Column of the abscissa.
    pub x: String,
}

/// Reference points of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceCurve {
    /// The table.
    pub reference: Reference,
    /// Column of the ordinate.
    pub y: String,
    /// Column of the abscissa.
    pub x: String,
}

/// Something that must hold of the tables a run writes.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// Where it is written.
    pub place: Place,
    /// The line as written.
    pub text: String,
    /// The judgement.
    pub judgement: Judgement,
}

/// Form of an expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum Judgement {
    /// `left <relation> right within tolerance at abscissa = values`.
    Compare {
        /// Left side.
        left: Tape<Sample>,
        /// Relation.
        relation: Relation,
        /// Right side.
        right: Tape<Sample>,
        /// Tolerance, of an equality.
        tolerance: Option<Tolerance>,
        /// Where: record, column, values. Without it both sides hold no bare column.
        at: Option<(String, String, Vec<f64>)>,
        /// SI unit symbol of both sides.
        unit: String,
    },
    /// The column never exceeds its running minimum by more than round-off.
    NeverGrows {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
}

/// Relation of two sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `==`, with a tolerance.
    Equal,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// How far two sides may lie apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// Of the right side's magnitude: `0.5 %`.
    Relative(f64),
    /// In the unit of the sides.
    Absolute(f64),
}

/// A leaf of an expectation: a number read from a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Sample {
    /// A record's column, interpolated where the abscissa takes the value asked for.
    Column {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// A reference's column, interpolated in the reference's column of the abscissa's name.
    Reference {
        /// The table.
        reference: Reference,
        /// The column.
        column: String,
    },
    /// Largest value of a column.
    Max {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Smallest value of a column.
    Min {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// First value of a column.
    Initial {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Exponent of a column's magnitude in the first varied value of a sweep.
    Order {
        /// The record.
        record: String,
        /// The column.
        column: String,
        /// Columns of the varied values, the one the order runs over first.
        varied: Vec<String>,
        /// Whether it is the smallest between neighbours instead of the least-squares one over all.
        between_neighbours: bool,
    },
    /// Integral of a column over time, by the trapezoidal rule.
    Integral {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
    /// Last value of a column.
    Final {
        /// The record.
        record: String,
        /// The column.
        column: String,
    },
}
