//! `tissue run`.

use super::Exit;
use super::arguments::RunOptions;
use super::drive::run_drive;
use super::fit::run_fit;
use super::folder::{announce, prepare, withdraw};
use super::input::{Input, chosen, read_one_or_explain};
use super::interrupt;
use super::memory::fits;
use super::progress::Bar;
use super::sweep::run_sweep;
use crate::output::file::write_atomic;
use crate::output::report::{Balance, ExpectationVerdict, RunStatus};
use crate::output::{Provenance, RunReport, Table};
use crate::plan::Plan;
use crate::run::{self, Outcome, RunError, execute, figures};
use crate::scene::{Drive, Fit, Loading, Place, Plot, Scene, Sweep};
use std::path::{Path, PathBuf};

/// Runs a file's drives, fits, scenes and sweeps.
pub fn run(options: &RunOptions) -> Exit {
    run_some(options, |_| true)
}

/// Runs a file's trades.
pub fn trade(options: &RunOptions) -> Exit {
    run_some(options, |job| matches!(job, Job::Sweep(sweep) if sweep.trade.is_some()))
}

fn run_some(options: &RunOptions, wanted: impl Fn(&Job<'_>) -> bool) -> Exit {
    let input = match read_one_or_explain(&options.file, &options.overrides, options.scene.as_deref()) {
        Ok(input) => input,
        Err(exit) => return exit,
    };
    let chosen = match chosen(&input, options.scene.as_deref()) {
        Ok(chosen) => chosen,
        Err(exit) => return exit,
    };
    // Drives first: they take a blink.
    let drives = chosen.drives.into_iter().map(Job::Drive);
    let scenes = chosen.scenes.into_iter().map(Job::Scene);
    let sweeps = chosen.sweeps.into_iter().map(Job::Sweep);
    let fitted = chosen.fits.into_iter().map(Job::Fit);
    let jobs: Vec<Job<'_>> = drives.chain(fitted).chain(scenes).chain(sweeps).filter(wanted).collect();
    if jobs.is_empty() {
        tell!("error: {} has no trade; write `trade name {{ … }}`", input.name);
        return Exit::WrongInput;
    }
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
    let several = jobs.len() > 1;
    let mut exit = Exit::Fine;
    for job in jobs {
        let folder = folder(options, job.name(), several);
        let earlier = match prepare(&folder, options.overwrite, "--out") {
            Ok(earlier) => earlier,
            Err(message) => {
                tell!("error: {message}");
                return Exit::WrongInput;
            }
        };
        let one = match job {
            Job::Scene(scene) => pool.install(|| run_scene(options, &input, scene, &folder)),
            Job::Drive(drive) => run_drive(options, &input, drive, &folder),
            Job::Fit(fit) => run_fit(options, &input, fit, &folder),
            Job::Sweep(sweep) => pool.install(|| run_sweep(options, &input, sweep, &folder)),
        };
        if one != Exit::Fine {
            exit = one;
        }
        let kept = if one == Exit::WrongInput { earlier.give_back() } else { earlier.let_go() };
        if let Err(message) = kept {
            tell!("error: {message}");
            exit = Exit::Failed;
        }
        if one == Exit::Interrupted {
            break;
        }
    }
    exit
}

/// Something to run.
enum Job<'a> {
    Scene(&'a Scene),
    Drive(&'a Drive),
    Fit(&'a Fit),
    Sweep(&'a Sweep),
}

impl Job<'_> {
    fn name(&self) -> &str {
        match self {
            Self::Scene(scene) => &scene.name,
            Self::Drive(drive) => &drive.name,
            Self::Fit(fit) => &fit.name,
            Self::Sweep(sweep) => &sweep.name,
        }
    }
}

/// `out/<file>/<name>`, or what the command line says.
fn folder(options: &RunOptions, name: &str, several: bool) -> PathBuf {
    match &options.out {
        Some(out) if several => out.join(name),
        Some(out) => out.clone(),
        None => {
            let stem = options.file.file_stem().unwrap_or_default();
            Path::new("out").join(stem).join(name)
        }
    }
}

fn run_scene(options: &RunOptions, input: &Input, scene: &Scene, folder: &Path) -> Exit {
    if let Err(message) = fits(scene) {
        tell!("error: scene `{}`: {message}", scene.name);
        return Exit::WrongInput;
    }
    let plan = Plan::new(scene);
    let provenance = Provenance::new(&input.name, &input.hash, &scene.name);
    let job = run::Job { scene, plan: &plan, provenance, folder: Some(folder.to_path_buf()) };
    if let Err(message) = announce(folder, &job.announcement()) {
        tell!("error: {message}");
        return Exit::Failed;
    }
    let mut bar = Bar::new(&scene.name, options.quiet);
    interrupt::listen();
    let outcome = execute(&job, &mut bar);
    interrupt::leave();
    bar.finish();
    let Outcome { mut report, tables, failure } = match outcome {
        Ok(outcome) => outcome,
        Err(cause) => {
            tell!("error: scene `{}`: {cause}", scene.name);
            tell_place(&cause, scene);
            tell_set(&options.overrides);
            if !cause.is_input() {
                return Exit::Failed;
            }
            withdraw(folder);
            return Exit::WrongInput;
        }
    };
    let mut exit = if report.status == RunStatus::Held { Exit::Fine } else { Exit::Failed };
    let (files, drawn) = draw(&scene.name, &scene.plots, &tables, &job.provenance, folder);
    report.files.extend(files);
    if !drawn {
        exit = Exit::Failed;
    }
    if let Err(cause) = write_atomic(&folder.join("run.json"), report.to_json().as_bytes()) {
        tell!("error: cannot write {}: {cause}", folder.join("run.json").display());
        exit = Exit::Failed;
    }
    if let Some(RunError::Interrupted) = failure {
        tell!("scene `{}` was interrupted at t = {:.4e} s", scene.name, report.end_time);
        tell!("  everything before is kept in {}", folder.display());
        return Exit::Interrupted;
    }
    if let Some(cause) = failure {
        tell!("error: scene `{}` stopped: {cause}", scene.name);
        tell_place(&cause, scene);
        tell_set(&options.overrides);
        tell!("  everything up to t = {:.4e} s is kept in {}", report.end_time, folder.display());
    }
    if !options.quiet {
        print_summary(scene, &report, folder);
    } else {
        print_faults(&report.expectations);
    }
    exit
}

/// Where the scene asks for what cannot be.
pub(super) fn tell_place(cause: &RunError, scene: &Scene) {
    if let Some(place) = cause.place(scene) {
        tell_at(place);
    }
}

/// The values that stand in the place of those at the place.
pub(super) fn tell_set(overrides: &[(String, String)]) {
    if !overrides.is_empty() {
        let set: Vec<String> =
            overrides.iter().map(|(path, value)| format!("--set {path}={value}")).collect();
        tell!("  with {}", set.join(" "));
    }
}

/// A place as under a mistake.
pub(super) fn tell_at(Place { file, line, column }: &Place) {
    tell!(" --> {file}:{line}:{column}");
}

fn print_summary(scene: &Scene, report: &RunReport, folder: &Path) {
    say!(
        "scene {}: {} particles, {} steps to t = {:.4e} s in {:.1} s, {:.2e} particle updates a second",
        scene.name,
        report.particles,
        report.steps,
        report.end_time,
        report.wall_seconds,
        report.updates_per_second
    );
    print_balance(scene, &report.balance);
    print_verdicts(&report.expectations);
    say!("  written to {}", folder.display());
}

/// Two lines on the energy of a run, and a third where a slow load ends out of equilibrium.
fn print_balance(scene: &Scene, balance: &Balance) {
    say!(
        "  energy: {:.3e} J at the start, loads {:+.3e}, supports {:+.3e}, dissipated {:.3e}, damped {:.3e}; residual {:+.1e} of the \
         largest",
        balance.start,
        balance.loads,
        balance.supports,
        balance.dissipated,
        balance.damped,
        balance.relative_residual()
    );
    say!(
        "  at the end: strain {:.3e} J, kinetic {:.3e} J, {:.1e} of the strain energy in modes no gradient sees, least J {:.4}",
        balance.strain,
        balance.kinetic,
        balance.unseen_share(),
        balance.smallest_j
    );
    let left = balance.kinetic_over_strain();
    if matches!(scene.run.loading, Loading::QuasiStatic { .. }) && left > STILL {
        say!(
            "  warns   not at rest: kinetic energy is {:.1} % of strain energy; load over a longer time",
            100.0 * left
        );
    }
}

/// Kinetic over strain energy below which a slow load counts as in equilibrium: forces then err by some per cent, the
/// inertia's share being of that order.
const STILL: f64 = 0.01;

/// The verdict on every `expect` line, with its numbers.
pub(super) fn print_verdicts(verdicts: &[ExpectationVerdict]) {
    for verdict in verdicts {
        let mark = if verdict.holds { "holds" } else { "FAILS" };
        say!("  {mark}  {}", verdict.text);
        match verdict.measured {
            Some(measured) => {
                let unit = if verdict.unit.is_empty() { String::new() } else { format!(" {}", verdict.unit) };
                say!(
                    "         measured {measured:.3e}{unit}, bound {:.3e}{unit}; {}",
                    verdict.bound,
                    verdict.note
                );
            }
            None => say!("         {}", verdict.note),
        }
    }
}

/// The expectations that do not hold, for a quiet run.
pub(super) fn print_faults(verdicts: &[ExpectationVerdict]) {
    for verdict in verdicts.iter().filter(|verdict| !verdict.holds) {
        tell!("FAILS  {}  ({})", verdict.text, verdict.note);
    }
}

/// Draws plots into a folder: the files written, and whether all were.
pub(super) fn draw(
    title: &str,
    plots: &[Plot],
    tables: &[Table],
    provenance: &Provenance,
    folder: &Path,
) -> (Vec<String>, bool) {
    write_figures(figures(title, plots, tables, provenance, Some(folder)), folder)
}

/// Writes figures into a folder: the files written, and whether all were.
pub(super) fn write_figures(
    drawn: Vec<(String, Result<String, String>)>,
    folder: &Path,
) -> (Vec<String>, bool) {
    let (mut files, mut sound) = (Vec::new(), true);
    for (name, drawn) in drawn {
        let written = drawn.and_then(|svg| {
            let file = format!("{name}.svg");
            write_atomic(&folder.join(&file), svg.as_bytes())
                .map_err(|cause| cause.to_string())
                .map(|()| file)
        });
        match written {
            Ok(file) => files.push(file),
            Err(cause) => {
                tell!("error: plot `{name}`: {cause}");
                sound = false;
            }
        }
    }
    (files, sound)
}
