//! Why a run left no complete result.

use crate::drive::DriveError;
use crate::energy::EnergyError;
use crate::monitor::ProbeError;
use crate::output::{FigureError, FrameError, TableError};
use crate::scene::{Place, Scene};
use crate::solver::{Cause, SolveError};
use std::fmt;
use std::io;
use std::path::PathBuf;

/// Why a run stopped.
#[derive(Debug)]
#[non_exhaustive]
pub enum RunError {
    /// The simulation could not be set up or went wrong.
    Solve(SolveError),
    /// The energy of a drive cannot be differentiated.
    Law {
        /// The material.
        material: String,
        /// Why not.
        cause: EnergyError,
    },
    /// The axes of a drive are none.
    Drive(DriveError),
    /// A drive of a fit has no equilibrium at the parameters the fit starts from.
    FitStart {
        /// The drive.
        drive: String,
        /// Why not; none if its response has no finite derivative.
        cause: Option<Box<DriveError>>,
    },
    /// An exact motion has no stress or no body force inside a body.
    Motion {
        /// When, s.
        time: f64,
    },
    /// A record asks for a place that is not there.
    Probe(ProbeError),
    /// A record or a frame series has more samples than make sense.
    TooManySamples {
        /// Its name.
        name: String,
        /// Samples asked for.
        samples: f64,
        /// Samples allowed.
        most: f64,
    },
    /// The user stopped it.
    Interrupted,
    /// A column of a record is infinite or undefined.
    ColumnWithoutValue(Box<ColumnFault>),
    /// A table could not be written.
    Table(TableError),
    /// A frame could not be written.
    Frame(FrameError),
    /// A figure could not be drawn.
    Figure {
        /// Its file.
        name: String,
        /// Why not.
        cause: FigureError,
    },
    /// A file could not be written.
    Io {
        /// The file.
        path: PathBuf,
        /// What the system reported.
        cause: io::Error,
    },
}

/// A column of a record that is infinite or undefined.
#[derive(Debug)]
pub struct ColumnFault {
    /// The record.
    pub record: String,
    /// The column.
    pub column: String,
    /// Its formula as written.
    pub expression: String,
    /// Where it is written.
    pub place: Place,
    /// At which value of the first column, with its name.
    pub at: String,
    /// What came out.
    pub value: f64,
}

impl RunError {
    /// Whether the scene asks for something that is not there, so that no run could have done it.
    pub fn is_input(&self) -> bool {
        let of_scene = |cause: &SolveError| {
            matches!(
                cause,
                SolveError::Discretisation { .. }
                    | SolveError::Energy { .. }
                    | SolveError::Unsupported { .. }
                    | SolveError::Jump { .. }
                    | SolveError::NotSymmetric { .. }
                    | SolveError::DirectionNotUnit { .. }
                    | SolveError::NotBonded { .. }
                    | SolveError::BondedApart { .. }
                    | SolveError::NonPositiveJacobian { cause: Cause::ImproperMotion, .. }
                    | SolveError::NotFinite { cause: Cause::ImproperMotion, .. }
            )
        };
        match self {
            Self::Solve(cause) => of_scene(cause),
            Self::Motion { .. } => true,
            Self::TooManySamples { .. } | Self::Probe(_) | Self::Law { .. } | Self::Drive(_) => true,
            Self::FitStart { .. } => true,
            Self::Interrupted | Self::ColumnWithoutValue(_) => false,
            Self::Table(_) | Self::Frame(_) | Self::Figure { .. } | Self::Io { .. } => false,
        }
    }
}

impl RunError {
    /// Where the scene asks for what cannot be, where that is known.
    pub fn place<'a>(&'a self, scene: &'a Scene) -> Option<&'a Place> {
        let body = |name: &str| scene.bodies.iter().find(|body| body.name == name);
        match self {
            Self::ColumnWithoutValue(fault) => Some(&fault.place),
            Self::Solve(
                SolveError::Discretisation { body: name, .. }
                | SolveError::DirectionNotUnit { body: name, .. }
                | SolveError::BondedApart { first: name, .. },
            ) => body(name).map(|body| &body.place),
            Self::Solve(SolveError::Jump { word, line, .. }) => {
                let mut places =
                    scene.prescribed.iter().filter(|one| one.word == *word).map(|one| &one.place);
                places.find(|place| place.line == *line)
            }
            Self::Solve(SolveError::NotBonded { .. }) if scene.bonds.len() == 1 => {
                scene.bonds.first().map(|bond| &bond.place)
            }
            Self::Solve(
                SolveError::Unsupported { .. }
                | SolveError::NotSymmetric { .. }
                | SolveError::NotBonded { .. },
            )
            | Self::Motion { .. } => Some(&scene.place),
            Self::Solve(
                SolveError::NonPositiveJacobian { cause: Cause::ImproperMotion, .. }
                | SolveError::NotFinite { cause: Cause::ImproperMotion, .. },
            ) => Some(&scene.place),
            Self::TooManySamples { name, .. } => {
                let records = scene.records.iter().map(|record| (&record.name, &record.place));
                let frames = scene.frames.iter().map(|frames| (&frames.name, &frames.place));
                records.chain(frames).find(|(known, _)| *known == name).map(|(_, place)| place)
            }
            _ => None,
        }
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solve(cause) => write!(f, "{cause}"),
            Self::Law { material, cause } => write!(f, "material `{material}`: {cause}"),
            Self::FitStart { drive, cause: Some(cause) } => {
                write!(f, "drive `{drive}` fails at the starting values: {cause}")
            }
            Self::FitStart { drive, cause: None } => write!(
                f,
                "what is measured on `{drive}` has no finite derivative by the parameters at their starting values"
            ),
            Self::Figure { name, cause } => write!(f, "{name}: {cause}"),
            Self::Drive(cause) => write!(f, "{cause}"),
            Self::Motion { time } => write!(
                f,
                "the `motion` has no finite stress or body force inside a body at t = {time:.4e} s: its formula has no \
                 value there or turns the body inside out"
            ),
            Self::Probe(cause) => write!(f, "{cause}"),
            Self::TooManySamples { name, samples, most } => write!(
                f,
                "`{name}` asks for {samples:.1e} samples, at most {most:.0e} are written; write a longer `every`"
            ),
            Self::ColumnWithoutValue(fault) => {
                let ColumnFault { record, column, expression, at, value, .. } = &**fault;
                let what = if value.is_nan() { "has no value" } else { "is infinite" };
                write!(
                    f,
                    "column `{column} = {expression}` of record `{record}` {what} at {at}; guard its formula \
                     with `if(…, …, …)`"
                )
            }
            Self::Interrupted => f.write_str("interrupted"),
            Self::Table(cause) => write!(f, "{cause}"),
            Self::Frame(cause) => write!(f, "{cause}"),
            Self::Io { path, cause } => write!(f, "cannot write {}: {cause}", path.display()),
        }
    }
}

impl std::error::Error for RunError {}

impl From<SolveError> for RunError {
    fn from(cause: SolveError) -> Self {
        Self::Solve(cause)
    }
}

impl From<ProbeError> for RunError {
    fn from(cause: ProbeError) -> Self {
        Self::Probe(cause)
    }
}

impl From<TableError> for RunError {
    fn from(cause: TableError) -> Self {
        Self::Table(cause)
    }
}

impl From<FrameError> for RunError {
    fn from(cause: FrameError) -> Self {
        Self::Frame(cause)
    }
}

impl From<DriveError> for RunError {
    fn from(cause: DriveError) -> Self {
        Self::Drive(cause)
    }
}
