//! Why a simulation stopped.

use crate::discretisation::DiscretisationError;
use crate::energy::EnergyError;
use crate::tensor::Vec3;
use std::fmt;

/// Why a simulation could not be set up or stopped before its end time.
///
/// Every variant of a running simulation carries where and when, so that the message alone is
/// enough to find the failure again.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SolveError {
    /// A body could not be discretised.
    Discretisation {
        /// Name of the body.
        body: String,
        /// What was wrong.
        cause: DiscretisationError,
    },
    /// A material's energy could not be compiled or has no usable wave speed.
    Energy {
        /// Name of the material.
        material: String,
        /// What was wrong.
        cause: EnergyError,
    },
    /// A direction that depends on place is not of unit length everywhere.
    DirectionNotUnit {
        /// Name of the material.
        material: String,
        /// Name of the direction.
        direction: String,
        /// Name of the body.
        body: String,
        /// Reference position of the first such particle, m.
        position: Vec3,
        /// Its length there; not finite where the formula has no value.
        length: f64,
    },
    /// The scene asks for something this solver does not do.
    Unsupported {
        /// What it is.
        what: &'static str,
        /// What to write instead.
        instead: &'static str,
    },
    /// A prescribed displacement jumps at the start.
    Jump {
        /// The word that prescribes it.
        word: String,
        /// Line of the word.
        line: u32,
        /// The displacement at time zero, m.
        displacement: f64,
    },
    /// Something of the scene is not symmetric about a plane of symmetry.
    NotSymmetric {
        /// What it is.
        what: String,
        /// Axis of the plane's normal.
        axis: char,
    },
    /// Two faces that are bonded neither meet node by node nor are one plane region.
    NotBonded {
        /// The first face, `body.face`.
        first: String,
        /// The second.
        second: String,
        /// Nodes of either face, where they touch, that lie on no node of the other.
        unmatched: usize,
        /// Reference position of the first of them, m.
        position: Vec3,
    },
    /// A shared node of bonded bodies is told to move in two ways.
    BondedApart {
        /// Name of the body that says one.
        first: String,
        /// Name of the body that says another.
        second: String,
        /// The component.
        axis: char,
        /// Reference position of the node, m.
        position: Vec3,
    },
    /// The volume map left the domain of the energy.
    NonPositiveJacobian {
        /// Index of the particle in its body.
        particle: usize,
        /// Name of the body.
        body: String,
        /// Its reference position, m.
        position: Vec3,
        /// Time, s.
        time: f64,
        /// The offending value of `J`.
        jacobian: f64,
        /// What most likely brought it there.
        cause: Cause,
    },
    /// A number of the state or the stress overflowed or is undefined.
    NotFinite {
        /// What is not finite: `stress`, `position`, …
        quantity: &'static str,
        /// Index of the particle in its body.
        particle: usize,
        /// Name of the body.
        body: String,
        /// Its reference position, m.
        position: Vec3,
        /// Time, s.
        time: f64,
        /// What most likely brought it there.
        cause: Cause,
    },
    /// The energy exceeds everything that was put in.
    EnergyFromNothing {
        /// Index of the fastest particle, in its body.
        particle: usize,
        /// Name of the body.
        body: String,
        /// Its reference position, m.
        position: Vec3,
        /// Time, s.
        time: f64,
        /// Kinetic and strain energy now, J.
        energy: f64,
        /// Energy at the start and the greatest work of loads and supports since, J.
        given: f64,
        /// What most likely brought it about.
        cause: Box<Cause>,
    },
    /// The stable time step fell below what makes sense.
    TimeStepTooSmall {
        /// Index of the particle that asks for it, in its body.
        particle: usize,
        /// Name of the body.
        body: String,
        /// Its reference position, m.
        position: Vec3,
        /// Time, s.
        time: f64,
        /// Step required by the CFL condition \[NB25 (42)\], s.
        required: f64,
        /// Smallest step allowed, s.
        allowed: f64,
        /// What most likely brought it about.
        cause: Box<Cause>,
    },
}

/// Likely cause of a failure, told from the state at the time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// The time step was above what Verlet or Heun can bear.
    CourantNumber {
        /// The Courant number.
        cfl: f64,
        /// Where the integrator loses stability; zero for one that has none.
        limit: f64,
    },
    /// The material has stiffened beyond a step that keeps the wave speed at rest.
    OutgrownStep {
        /// Wave speed now over that at rest.
        ratio: f64,
    },
    /// The volume map drifted from `det F` under D(J), which has no restoring force.
    VolumeDissipationDrift(f64),
    /// The load deforms the material faster than pressure waves can spread it.
    LoadTooFast(f64),
    /// The fibres were stretched to where the exponential overflows.
    FibreOverflow(f64),
    /// A prescribed displacement has no value; its component.
    UndefinedMotion(char),
    /// A traction or body force has no value.
    UndefinedLoad,
    /// The exact motion that the bodies start from has no value or turns them inside out.
    ImproperMotion,
    /// The load is more than the material can carry at small strains.
    Overload {
        /// Load per area before the deformation, Pa.
        load: f64,
        /// What it is held against, Pa.
        modulus: f64,
        /// Which modulus that is.
        of: &'static str,
    },
    /// The body is squeezed flat.
    Squeezed {
        /// The axis along which.
        axis: char,
        /// Distance of its ends now in parts of that before the deformation.
        share: f64,
        /// Mean of the least principal stretches.
        stretch: f64,
    },
    /// Nothing stands out.
    Unknown,
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CourantNumber { cfl, limit: 0.0 } => write!(
                f,
                "Heun's method amplifies undamped waves at every step, at the Courant number {cfl} as at any; write \
                 `integrator = velocity_verlet`"
            ),
            Self::CourantNumber { cfl, limit } => write!(
                f,
                "the Courant number {cfl} is above the integrator's limit of {limit:.3}; write `cfl = {:.2}`",
                0.9 * limit
            ),
            Self::OutgrownStep { ratio } => write!(
                f,
                "waves have become {ratio:.3e} times as fast as at rest, and the step is that of the speed at rest; \
                 write `wave_speed_every = 100`"
            ),
            Self::VolumeDissipationDrift(gap) => write!(
                f,
                "J has drifted {gap:.2e} from det F under volume dissipation, which has no restoring force; \
                 write `volume_dissipation = off`"
            ),
            Self::LoadTooFast(mach) => write!(
                f,
                "the load moves at {mach:.2} times the pressure wave speed; load over a longer time, or write `cfl = 0.3`"
            ),
            Self::FibreOverflow(stretch) => write!(
                f,
                "a largest principal stretch of {stretch:.3} drives the energy's exponential out of range; \
                 pull less far or check the parameters"
            ),
            Self::UndefinedMotion(axis) => write!(
                f,
                "the prescribed displacement along {axis} has no finite value at this time; check its formula"
            ),
            Self::UndefinedLoad => {
                write!(f, "a traction or body force has no finite value at this time; check its formula")
            }
            Self::ImproperMotion => write!(
                f,
                "the `motion` has no finite value or gradient there or turns the body inside out; check its formula"
            ),
            Self::Overload { load, modulus, of } => write!(
                f,
                "the load of {load:.2e} Pa on the undeformed area is {:.2e} times the {of}, {modulus:.2e} Pa; check its \
                 unit, or load less or over a longer time",
                load / modulus
            ),
            Self::Squeezed { axis, share, stretch } => write!(
                f,
                "the body is squeezed: its ends along {axis} are at {share:.3} of their distance, its least principal \
                 stretch is {stretch:.3} in the mean; prescribe less, or let its sides move"
            ),
            Self::Unknown => write!(
                f,
                "no single cause stands out; try a smaller `cfl`, a finer `spacing` or a slower load"
            ),
        }
    }
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Discretisation { body, cause } => write!(f, "body `{body}`: {cause}"),
            Self::Energy { material, cause } => write!(f, "material `{material}`: {cause}"),
            Self::DirectionNotUnit { material, direction, body, position: x, length } => {
                write!(
                    f,
                    "the direction `{direction}` of `{material}` must be of length 1, but at X = ({:.4e}, {:.4e}, \
                     {:.4e}) m in `{body}` ",
                    x.x, x.y, x.z
                )?;
                match length.is_finite() {
                    true => write!(f, "its length is {length:.6}; write `unit([x, y, z])`"),
                    false => write!(f, "it has no value; give it one with `if(…, …, …)`"),
                }
            }
            Self::Unsupported { what, instead } => write!(f, "{what} is not available; {instead}"),
            Self::Jump { word, line, displacement } => write!(
                f,
                "`{word}` in line {line} starts with a displacement of {displacement:.3e} m, which no body can follow; \
                 write `ramp(0 mm -> …, over = …)`"
            ),
            Self::NotSymmetric { what, axis } => write!(
                f,
                "{what} is not symmetric about the plane of symmetry normal to {axis}; leave {axis} out of `planes`"
            ),
            Self::NotBonded { first, second, unmatched, position: x } => write!(
                f,
                "`bond {first}` to `{second}`: {unmatched} nodes where the faces touch, the first at X = ({:.4e}, {:.4e}, \
                 {:.4e}) m, lie on no node of the other; give both bodies the same spacing in the interface, no jitter and \
                 faces that begin and end on common nodes, or `completeness = linear` and plane faces with the same edges, \
                 each bonded once",
                x.x, x.y, x.z
            ),
            Self::BondedApart { first, second, axis, position: x } => write!(
                f,
                "`{first}` and `{second}` are bonded at X = ({:.4e}, {:.4e}, {:.4e}) m, but their displacements along \
                 {axis} are prescribed differently there; prescribe both alike or one of them",
                x.x, x.y, x.z
            ),
            Self::NonPositiveJacobian { particle, body, position: x, time, jacobian, cause } => write!(
                f,
                "volume map J = {jacobian:.3e} is not positive at particle {particle} of `{body}`, \
                 X = ({:.4e}, {:.4e}, {:.4e}) m, t = {time:.4e} s; likely cause: {cause}",
                x.x, x.y, x.z
            ),
            Self::NotFinite { quantity, particle, body, position: x, time, cause } => write!(
                f,
                "{quantity} is not finite at particle {particle} of `{body}`, \
                 X = ({:.4e}, {:.4e}, {:.4e}) m, t = {time:.4e} s; likely cause: {cause}",
                x.x, x.y, x.z
            ),
            Self::EnergyFromNothing { particle, body, position: x, time, energy, given, cause } => {
                write!(
                    f,
                    "the energy of {energy:.3e} J has come from nothing, {given:.3e} J was put in; fastest is particle \
                     {particle} of `{body}`, X = ({:.4e}, {:.4e}, {:.4e}) m, t = {time:.4e} s; likely cause: ",
                    x.x, x.y, x.z
                )?;
                match **cause {
                    Cause::Unknown => write!(f, "steps too long for this integrator; write a smaller `cfl`"),
                    ref cause => write!(f, "{cause}"),
                }
            }
            Self::TimeStepTooSmall { particle, body, position: x, time, required, allowed, cause } => {
                write!(
                    f,
                    "stable time step {required:.3e} s is below the smallest sensible {allowed:.3e} s at particle \
                     {particle} of `{body}`, X = ({:.4e}, {:.4e}, {:.4e}) m, t = {time:.4e} s; likely cause: ",
                    x.x, x.y, x.z
                )?;
                match **cause {
                    Cause::Unknown => write!(
                        f,
                        "the material has stiffened there beyond what the scene meant, or the end time asks for \
                         more than 1e9 steps"
                    ),
                    ref cause => write!(f, "{cause}"),
                }
            }
        }
    }
}

impl std::error::Error for SolveError {}
