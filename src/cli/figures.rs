//! `tissue figures`.
//!
//! Owns which runs are still needed: results whose input and version are unchanged are taken as they are.

use super::Exit;
use super::arguments::FiguresOptions;
use super::folder::{REPORT, announce, prepare};
use super::input::{Input, read_or_explain, read_runs_or_explain};
use super::progress::Bar;
use crate::output::file::write_atomic;
use crate::output::{Provenance, RunReport, Table};
use crate::plan::Plan;
use crate::run::{
    DriveJob, Job, Results, RunResults, draw_figure, drive, execute, extract_figure, table_names,
};
use crate::scene::{FigureOf, Source};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Folder of the tables below that of the figures.
const TABLES: &str = "tables";

/// Makes the figures of files, or of a folder of files.
pub fn figures(options: &FiguresOptions) -> Exit {
    let wanted = match wanted(options) {
        Ok(wanted) => wanted,
        Err(exit) => return exit,
    };
    let mut builder = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = options.threads {
        builder = builder.num_threads(usize::from(threads));
    }
    let pool = match builder.build() {
        Ok(pool) => pool,
        Err(cause) => {
            tell!("error: cannot start the threads: {cause}");
            return Exit::Failed;
        }
    };
    let clock = Instant::now();
    let mut exit = Exit::Fine;
    let mut finished = 0;
    for (index, figure) in wanted.iter().enumerate() {
        let start = Instant::now();
        let made = pool.install(|| make(options, figure));
        finished += usize::from(made.is_ok());
        match made {
            Ok(path) if !options.quiet => {
                let (done, all) = (index + 1, wanted.len());
                let seconds = start.elapsed().as_secs_f64();
                say!("[{done}/{all}] figure {}: {}, {seconds:.1} s", figure.number, path.display());
            }
            Ok(_) => {}
            Err(Stop::Explained(stop)) => exit = stop,
            Err(Stop::Because(message)) => {
                tell!("error: figure {}: {message}", figure.number);
                exit = Exit::Failed;
            }
        }
    }
    if !options.quiet {
        say!("{finished} of {} figures in {:.0} s", wanted.len(), clock.elapsed().as_secs_f64());
    }
    exit
}

/// The figures that are asked for, by number.
fn wanted(options: &FiguresOptions) -> Result<Vec<FigureOf>, Exit> {
    let mut files = options.files.clone();
    if files.is_empty() {
        files = list(&options.from).map_err(|message| {
            tell!("error: {message}");
            Exit::WrongInput
        })?;
        files.sort();
    }
    let mut wanted: Vec<FigureOf> = Vec::new();
    for file in &files {
        let found = read_or_explain(file, &[])?.document.figures;
        if found.is_empty() && !options.files.is_empty() {
            tell!("error: {} has no figure; write `figure name {{ … }}`", file.display());
            return Err(Exit::WrongInput);
        }
        for figure in found {
            // one would be drawn over the other
            if wanted.iter().any(|known| stem(known) == stem(&figure)) {
                tell!("error: two figures are called {}; give one another number or name", stem(&figure));
                return Err(Exit::WrongInput);
            }
            wanted.push(figure);
        }
    }
    let numbers: Vec<String> = wanted.iter().map(|figure| figure.number.to_string()).collect();
    if let Some(unknown) = options.only.iter().find(|number| !numbers.contains(&number.to_string())) {
        let (there, named) = (numbers.join(", "), |path: &PathBuf| path.display().to_string());
        let among = match options.files.as_slice() {
            [] => named(&options.from),
            files => files.iter().map(named).collect::<Vec<_>>().join(" and "),
        };
        tell!("error: {among} has no figure {unknown}; there are {there}");
        return Err(Exit::WrongInput);
    }
    wanted.retain(|figure| options.only.is_empty() || options.only.contains(&figure.number));
    wanted.sort_by_key(|figure| figure.number);
    Ok(wanted)
}

/// Why a figure was not made.
enum Stop {
    /// It has been said.
    Explained(Exit),
    /// To be said.
    Because(String),
}

impl From<String> for Stop {
    fn from(message: String) -> Self {
        Self::Because(message)
    }
}

fn list(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let fault = |cause: std::io::Error| format!("cannot read {}: {cause}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        if path.extension().is_some_and(|ending| ending == "tissue") {
            files.push(path);
        }
    }
    if files.is_empty() {
        return Err(format!("{} holds no file of figures", folder.display()));
    }
    Ok(files)
}

/// The folder of the figures; coarse ones do not replace those of the full tier unless it is named.
fn folder_of(options: &FiguresOptions) -> &Path {
    let default = if options.quick { "out/quick" } else { "figures" };
    options.out.as_deref().unwrap_or(Path::new(default))
}

/// `02_punch_stages`.
fn stem(figure: &FigureOf) -> String {
    format!("{:02}_{}", figure.number, figure.name)
}

/// Runs what is needed, writes the tables, draws the figure from them.
fn make(options: &FiguresOptions, figure: &FigureOf) -> Result<PathBuf, Stop> {
    let out = folder_of(options);
    let file = |table: &str| out.join(TABLES).join(format!("{}_{table}.csv", stem(figure)));
    let mut texts: Vec<(String, String)> = Vec::new();
    if options.redraw {
        for name in table_names(figure) {
            let path = file(&name);
            let text = fs::read_to_string(&path)
                .map_err(|cause| format!("cannot read {}: {cause}; leave out --redraw", path.display()))?;
            texts.push((name, text));
        }
    } else {
        let mut results = Results { short: options.quick, ..Results::default() };
        for source in &figure.sources {
            results.runs.push(results_of(options, source)?);
        }
        for table in extract_figure(figure, &results)? {
            let text = table.to_csv().map_err(|cause| cause.to_string())?;
            write(&file(&table.name), &text)?;
            texts.push((table.name, text));
        }
    }
    // drawn from what stands in the files
    let parse = |(name, text): &(String, String)| Table::parse(name, text).map_err(|cause| cause.to_string());
    let tables = texts.iter().map(parse).collect::<Result<Vec<Table>, String>>()?;
    let path = out.join(format!("{}.svg", stem(figure)));
    write(&path, &draw_figure(figure, &tables)?)?;
    Ok(path)
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    write_atomic(path, text.as_bytes()).map_err(|cause| format!("cannot write {}: {cause}", path.display()))
}

/// The results of a source, of an earlier run if its input and the program are the same.
fn results_of(options: &FiguresOptions, source: &Source) -> Result<RunResults, Stop> {
    let settings = source.settings(options.quick);
    let input = read_runs_or_explain(Path::new(&source.file), &settings).map_err(Stop::Explained)?;
    let provenance = Provenance::new(&input.name, &input.hash, &source.scene);
    let file = Path::new(&source.file).file_stem().unwrap_or_default().to_string_lossy();
    let short: String = input.hash.chars().take(12).collect();
    let folder = options.runs.join(format!("{file}-{}-{short}", source.scene));
    if !is_done(&folder, &provenance) {
        prepare(&folder, folder.exists(), "--runs")?.let_go()?;
        run(options, &input, source, &provenance, &folder)?;
    }
    let mut spacings = Vec::new();
    let records: Vec<String> = match input.document.drives.iter().find(|drive| drive.name == source.scene) {
        Some(drive) => drive.records.iter().map(|record| record.name.clone()).collect(),
        None => {
            let scene = input.document.scenes.iter().find(|scene| scene.name == source.scene);
            let bodies = scene.iter().flat_map(|scene| &scene.bodies);
            spacings.extend(bodies.map(|body| (body.name.clone(), body.spacing)));
            let records = scene.iter().flat_map(|scene| &scene.records);
            records.map(|record| record.name.clone()).collect()
        }
    };
    let mut lines = provenance.lines();
    lines.extend(settings.iter().map(|(path, value)| format!("set {path} = {value}")));
    Ok(RunResults::read(&source.name, &folder, &records, spacings, lines)?)
}

/// Whether a folder holds the finished results of the same input by the same program.
fn is_done(folder: &Path, provenance: &Provenance) -> bool {
    let Ok(text) = fs::read_to_string(folder.join(REPORT)) else { return false };
    let Ok(report) = serde_json::from_str::<serde_json::Value>(&text) else { return false };
    let is = |key: &str, value: &str| report[key].as_str() == Some(value);
    let finished = report["status"]["outcome"]
        .as_str()
        .is_some_and(|outcome| !matches!(outcome, "unfinished" | "interrupted"));
    // one that has lost a file is run again
    let files = report["files"].as_array().into_iter().flatten().filter_map(|file| file.as_str());
    finished
        && files.clone().all(|file| folder.join(file).is_file())
        && is("version", &provenance.version)
        && is("hash", &provenance.hash)
        && is("scene", &provenance.scene)
}

fn run(
    options: &FiguresOptions,
    input: &Input,
    source: &Source,
    provenance: &Provenance,
    folder: &Path,
) -> Result<(), Stop> {
    if let Some(described) = input.document.drives.iter().find(|drive| drive.name == source.scene) {
        let provenance = provenance.clone();
        let job = DriveJob { drive: described, provenance, folder: Some(folder.to_path_buf()) };
        let outcome = drive(&job).map_err(|cause| format!("drive `{}`: {cause}", source.scene))?;
        write(&folder.join(REPORT), &outcome.report.to_json())?;
        return Ok(());
    }
    let found = input.document.scenes.iter().find(|scene| scene.name == source.scene);
    let scene = found.ok_or_else(|| format!("{} has no scene `{}`", source.file, source.scene))?;
    let plan = Plan::new(scene);
    let (provenance, folder) = (provenance.clone(), folder.to_path_buf());
    let job = Job { scene, plan: &plan, provenance, folder: Some(folder.clone()) };
    announce(&folder, &job.announcement())?;
    let mut bar = Bar::new(&format!("{}: {}", source.file, scene.name), options.quiet);
    let outcome = execute(&job, &mut bar);
    bar.finish();
    let outcome = outcome.map_err(|cause| format!("scene `{}`: {cause}", scene.name))?;
    let report: &RunReport = &outcome.report;
    write(&folder.join(REPORT), &report.to_json())?;
    if let Some(cause) = outcome.failure {
        tell!("note: scene `{}` of {} stopped: {cause}", scene.name, source.file);
    } else if !options.quiet {
        say!(
            "  {}: {}, {} particles, {} steps, {:.1} s",
            source.file,
            scene.name,
            report.particles,
            report.steps,
            report.wall_seconds
        );
    }
    Ok(())
}
