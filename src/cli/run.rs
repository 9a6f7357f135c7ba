//! `tissue run`.

use super::Exit;
use super::arguments::RunOptions;
use super::input::{Input, read_or_explain, scenes};
use super::progress::Bar;
use crate::output::file::{create_fresh_folder, write_atomic};
use crate::output::report::RunStatus;
use crate::output::{Provenance, RunReport};
use crate::plan::Plan;
use crate::run::{Job, Outcome, execute, figures};
use crate::scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};

/// Runs a file's scenes.
pub fn run(options: &RunOptions) -> Exit {
    let input = match read_or_explain(&options.file, &options.overrides) {
        Ok(input) => input,
        Err(exit) => return exit,
    };
    let scenes = match scenes(&input, options.scene.as_deref()) {
        Ok(scenes) => scenes,
        Err(exit) => return exit,
    };
    let mut builder = rayon::ThreadPoolBuilder::new();
    if let Some(threads) = options.threads {
        builder = builder.num_threads(usize::from(threads));
    }
    let pool = match builder.build() {
        Ok(pool) => pool,
        Err(cause) => {
            eprintln!("error: cannot start the threads: {cause}");
            return Exit::Failed;
        }
    };
    let several = scenes.len() > 1;
    let mut exit = Exit::Fine;
    for scene in scenes {
        let folder = folder(options, scene, several);
        if let Err(message) = prepare(&folder, options.overwrite) {
            eprintln!("error: {message}");
            return Exit::WrongInput;
        }
        let one = pool.install(|| run_scene(options, &input, scene, &folder));
        if one != Exit::Fine {
            exit = one;
        }
    }
    exit
}

/// `out/<file>/<scene>`, or what the command line says.
fn folder(options: &RunOptions, scene: &Scene, several: bool) -> PathBuf {
    match &options.out {
        Some(out) if several => out.join(&scene.name),
        Some(out) => out.clone(),
        None => {
            let stem = options.file.file_stem().unwrap_or_default();
            Path::new("out").join(stem).join(&scene.name)
        }
    }
}

/// Makes the output folder, or empties it if it holds an earlier run and that may go.
fn prepare(folder: &Path, overwrite: bool) -> Result<(), String> {
    let shown = folder.display();
    if overwrite && folder.join("run.json").is_file() {
        let entries = fs::read_dir(folder).map_err(|cause| format!("cannot read {shown}: {cause}"))?;
        for entry in entries.flatten() {
            let path = entry.path();
            let ours = path.extension().is_some_and(|extension| {
                ["csv", "vtu", "pvd", "svg", "json", "part"].iter().any(|known| extension == *known)
            });
            if ours && path.is_file() {
                fs::remove_file(&path)
                    .map_err(|cause| format!("cannot remove {}: {cause}", path.display()))?;
            }
        }
    }
    create_fresh_folder(folder).map_err(|cause| {
        format!(
            "cannot write to {shown}: {cause}; name another folder with --out, or replace an earlier run with \
             --overwrite"
        )
    })
}

fn run_scene(options: &RunOptions, input: &Input, scene: &Scene, folder: &Path) -> Exit {
    let plan = Plan::new(scene);
    let provenance = Provenance::new(&input.name, &input.hash, &scene.name);
    let job = Job { scene, plan: &plan, provenance, folder: Some(folder.to_path_buf()) };
    let mut bar = Bar::new(&scene.name, options.quiet);
    let outcome = execute(&job, &mut bar);
    bar.finish();
    let Outcome { mut report, tables, failure } = match outcome {
        Ok(outcome) => outcome,
        Err(cause) => {
            eprintln!("error: scene `{}`: {cause}", scene.name);
            return Exit::Failed;
        }
    };
    let mut exit = if report.status == RunStatus::Held { Exit::Fine } else { Exit::Failed };
    for (name, drawn) in figures(scene, &tables, &job.provenance) {
        let written = drawn.and_then(|svg| {
            let file = format!("{name}.svg");
            write_atomic(&folder.join(&file), svg.as_bytes())
                .map_err(|cause| cause.to_string())
                .map(|()| file)
        });
        match written {
            Ok(file) => report.files.push(file),
            Err(cause) => {
                eprintln!("error: plot `{name}`: {cause}");
                exit = Exit::Failed;
            }
        }
    }
    if let Err(cause) = write_atomic(&folder.join("run.json"), report.to_json().as_bytes()) {
        eprintln!("error: cannot write {}: {cause}", folder.join("run.json").display());
        exit = Exit::Failed;
    }
    if let Some(cause) = failure {
        eprintln!("error: scene `{}` stopped: {cause}", scene.name);
        eprintln!("  everything up to t = {:.4e} s is kept in {}", report.end_time, folder.display());
    }
    if !options.quiet {
        print_summary(scene, &report, folder);
    } else {
        for verdict in report.expectations.iter().filter(|verdict| !verdict.holds) {
            eprintln!("FAILS  {}  ({})", verdict.text, verdict.note);
        }
    }
    exit
}

fn print_summary(scene: &Scene, report: &RunReport, folder: &Path) {
    println!(
        "scene {}: {} particles, {} steps to t = {:.4e} s in {:.1} s, {:.2e} particle updates a second",
        scene.name,
        report.particles,
        report.steps,
        report.end_time,
        report.wall_seconds,
        report.updates_per_second
    );
    for verdict in &report.expectations {
        let mark = if verdict.holds { "holds" } else { "FAILS" };
        println!("  {mark}  {}", verdict.text);
        match verdict.measured {
            Some(measured) => {
                let unit = if verdict.unit.is_empty() { String::new() } else { format!(" {}", verdict.unit) };
                println!(
                    "         measured {measured:.3e}{unit}, bound {:.3e}{unit}; {}",
                    verdict.bound, verdict.note
                );
            }
            None => println!("         {}", verdict.note),
        }
    }
    println!("  written to {}", folder.display());
}
