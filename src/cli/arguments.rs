//! The command line as clap declares it.

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Anisotropic hyperelastic soft tissue by mixed total-Lagrangian SPH, verified.
#[derive(Debug, Parser)]
#[command(
    name = "tissue",
    version,
    after_help = "Exit codes: 0 fine, 1 a claim or a run failed, 2 the input or the command line is wrong, 130 stopped by Ctrl-C."
)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What the tool does.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Audit files: language, units, scenes, materials; runs nothing
    Check(CheckOptions),
    /// Print what a scene models, what it leaves out, and why
    Plan(PlanOptions),
    /// Run a file's scenes, drives and sweeps; write tables, frames, figures and run.json
    Run(RunOptions),
    /// Run a file's trades: error against cost, and the cheapest setting within the tolerance
    Trade(RunOptions),
    /// Hold every claim and expect line against its bound, with a control that must fail
    Verify(VerifyOptions),
    /// Make the figures: run what they need, write their tables, draw them from these
    Figures(FiguresOptions),
    /// Explain a word of the language
    Explain(ExplainOptions),
    /// Lay out files in the standard form
    Fmt(FmtOptions),
}

/// Options of `check`.
#[derive(Debug, Args)]
pub struct CheckOptions {
    /// The files
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Print the mistakes and reports as JSON
    #[arg(long)]
    pub json: bool,
    /// Draw where each material keeps or loses ellipticity: one SVG a material in this folder, made if need be
    #[arg(long, value_name = "DIR")]
    pub map: Option<PathBuf>,
    /// Replace maps that exist
    #[arg(long)]
    pub overwrite: bool,
}

/// Options of `plan`.
#[derive(Debug, Args)]
pub struct PlanOptions {
    /// The file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Only this scene, drive, fit, sweep or trade; --set is for it alone
    #[arg(long, value_name = "NAME")]
    pub scene: Option<String>,
    /// Put a value in place of the one written: strip.spacing=0.25mm
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = parse_override)]
    pub overrides: Vec<(String, String)>,
    /// Also build the scene and print particles, neighbours, bytes, steps and an estimate of the time
    #[arg(long)]
    pub cost: bool,
}

/// Options of `run`.
#[derive(Debug, Args)]
pub struct RunOptions {
    /// The file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Folder to write to; one folder a scene, drive or sweep below it if the file has several [default: out/<file>/<name>]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Threads to compute on; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Put a value in place of the one written: strip.spacing=0.25mm
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = parse_override)]
    pub overrides: Vec<(String, String)>,
    /// Only this scene, drive, fit, sweep or trade; --set is for it alone
    #[arg(long, value_name = "NAME")]
    pub scene: Option<String>,
    /// Replace the results of an earlier run in the output folder
    #[arg(long)]
    pub overwrite: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Options of `verify`.
#[derive(Debug, Args)]
pub struct VerifyOptions {
    /// Topics: language, energies, discretisation, conservation, consistency, convergence,
    /// benchmarks, figures, stability [default: all]
    #[arg(value_name = "TOPIC")]
    pub topics: Vec<String>,
    /// Measure the claims that take minutes as well
    #[arg(long)]
    pub full: bool,
    /// Write the verdicts as JSON as well
    #[arg(long, value_name = "FILE")]
    pub json: Option<PathBuf>,
    /// Write the report as one page of HTML, with figures
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
    /// Put the control of the claims that contain this text in the place of what is measured: they must fail
    #[arg(long = "break", value_name = "TEXT")]
    pub broken: Option<String>,
    /// Let the set-up of the claims that contain this text panic: they must fail, and no other
    #[arg(long = "stop", value_name = "TEXT")]
    pub stopped: Option<String>,
    /// Replace files that exist
    #[arg(long)]
    pub overwrite: bool,
}

/// Options of `figures`.
#[derive(Debug, Args)]
pub struct FiguresOptions {
    /// Files with figures [default: every file of the folder --from]
    #[arg(value_name = "FILE", conflicts_with = "from")]
    pub files: Vec<PathBuf>,
    /// Only these figures, by number: --only 2,8
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub only: Vec<u32>,
    /// The quick tier: coarse and short runs, for a look at the form
    #[arg(long)]
    pub quick: bool,
    /// Run nothing: draw again from the tables that are there
    #[arg(long, conflicts_with = "quick")]
    pub redraw: bool,
    /// Folder of the figures; their tables are written to tables/ below it [default: figures, with --quick out/quick]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Folder of the files that describe them
    #[arg(long, value_name = "DIR", default_value = "specs/figures")]
    pub from: PathBuf,
    /// Folder of the runs; one whose input and program are unchanged is not run again
    #[arg(long, value_name = "DIR", default_value = "out/figures")]
    pub runs: PathBuf,
    /// Threads to compute on; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Options of `explain`.
#[derive(Debug, Args)]
pub struct ExplainOptions {
    /// The word
    #[arg(value_name = "WORD")]
    pub word: String,
}

/// Options of `fmt`.
#[derive(Debug, Args)]
pub struct FmtOptions {
    /// The files, rewritten in place
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Change nothing; exit with 1 if a file is not in the standard form
    #[arg(long)]
    pub check: bool,
}

/// Splits `path=value`.
fn parse_override(text: &str) -> Result<(String, String), String> {
    let (path, value) = text
        .split_once('=')
        .ok_or_else(|| "write PATH=VALUE, for example strip.spacing=0.25mm".to_string())?;
    if path.trim().is_empty() || value.trim().is_empty() {
        return Err("write PATH=VALUE, for example strip.spacing=0.25mm".into());
    }
    Ok((path.trim().into(), value.trim().into()))
}
