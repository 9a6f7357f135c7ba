//! Arguments, exit codes, progress.
//!
//! Owns the terminal: the only place that reads arguments and prints. Everything it does is a call
//! of the layers above.

/// Prints a line; a reader that went away (`tissue … | head`) is no error.
macro_rules! say {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stdout(), $($text)*);
    }};
}

/// Prints without a line break, as [`say`].
macro_rules! say_on {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = write!(std::io::stdout(), $($text)*);
    }};
}

/// Prints a line to the error stream; a reader that has gone away is no error of ours.
macro_rules! tell {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($text)*);
    }};
}

mod arguments;
mod check;
mod drive;
mod explain;
mod figures;
mod fit;
mod folder;
mod format;
mod input;
mod interrupt;
mod memory;
mod plan;
mod progress;
mod run;
mod sweep;
mod verify;

use arguments::{Arguments, Command};
use clap::Parser;
use std::process::ExitCode;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// Everything asked for was done and holds.
    Fine,
    /// A claim, an expectation or a run failed.
    Failed,
    /// The input or the command line is wrong.
    WrongInput,
    /// The user stopped it.
    Interrupted,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        match exit {
            Exit::Fine => Self::SUCCESS,
            Exit::Failed => Self::from(1),
            Exit::WrongInput => Self::from(2),
            Exit::Interrupted => Self::from(interrupt::CODE),
        }
    }
}

/// Runs the tool on the process's arguments.
///
/// Wrong arguments end the process with exit code 2 and the usage.
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let exit = match arguments.command {
        Command::Check(options) => check::check(&options),
        Command::Plan(options) => plan::plan(&options),
        Command::Run(options) => run::run(&options),
        Command::Trade(options) => run::trade(&options),
        Command::Verify(options) => verify::verify(&options),
        Command::Figures(options) => figures::figures(&options),
        Command::Explain(options) => explain::explain(&options),
        Command::Fmt(options) => format::format(&options),
    };
    exit.into()
}
