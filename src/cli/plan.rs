//! `tissue plan`.

use super::Exit;
use super::arguments::PlanOptions;
use super::input::{chosen, read_one_or_explain};
use super::memory::fits;
use super::run::{tell_place, tell_set};
use crate::plan::{DrivePlan, FitPlan, Plan};
use crate::run::{Cost, side_by_side};
use crate::scene::{Scene, Sweep, Swept};

/// Prints what each scene models and why, what each sweep computes, and on request what they cost.
pub fn plan(options: &PlanOptions) -> Exit {
    match try_plan(options) {
        Ok(()) => Exit::Fine,
        Err(exit) => exit,
    }
}

fn try_plan(options: &PlanOptions) -> Result<(), Exit> {
    let input = read_one_or_explain(&options.file, &options.overrides, options.scene.as_deref())?;
    let chosen = chosen(&input, options.scene.as_deref())?;
    for drive in &chosen.drives {
        say_on!("{}", DrivePlan(drive));
    }
    for fit in &chosen.fits {
        say_on!("{}", FitPlan(fit));
    }
    for scene in chosen.scenes {
        fits(scene).map_err(|message| {
            tell!("error: scene `{}`: {message}", scene.name);
            Exit::WrongInput
        })?;
        let plan = Plan::new(scene);
        say_on!("{plan}");
        if options.cost {
            let cost = measured(scene, &plan).inspect_err(|_| tell_set(&options.overrides))?;
            say_on!("{cost}");
        }
    }
    for sweep in chosen.sweeps {
        plan_sweep(sweep, options.cost)?;
    }
    Ok(())
}

/// What a few steps of a scene cost.
fn measured(scene: &Scene, plan: &Plan) -> Result<Cost, Exit> {
    Cost::measure(scene, plan).map_err(|cause| {
        tell!("error: scene `{}`: {cause}", scene.name);
        tell_place(&cause, scene);
        Exit::WrongInput
    })
}

/// The points of a sweep, on request with the cost of each and of all.
fn plan_sweep(sweep: &Sweep, cost: bool) -> Result<(), Exit> {
    let (word, threads) =
        (if sweep.trade.is_some() { "trade" } else { "sweep" }, rayon::current_num_threads());
    let how = if side_by_side(sweep, threads) { "side by side" } else { "one after the other" };
    say!(
        "{word} {}: {} points of `{}`, {how} on {threads} threads",
        sweep.name,
        sweep.points.len(),
        sweep.of
    );
    let (mut seconds, mut updates) = (0.0, 0.0);
    for point in &sweep.points {
        let values: Vec<String> = sweep
            .varied
            .iter()
            .zip(&point.at)
            .map(|(varied, &at)| format!("{} = {}", varied.path, varied.values[at].text))
            .collect();
        let values = values.join(", ");
        match &point.swept {
            Swept::Drive(drive) => say!("    {values}: {} points of the path", drive.steps + 1),
            Swept::Scene(scene) if cost => {
                let cost = measured(scene, &Plan::new(scene))?;
                let evaluations = cost.steps as f64 * cost.evaluations_per_step;
                seconds += cost.seconds_per_step * cost.steps as f64;
                updates += evaluations * cost.particles as f64;
                say!(
                    "    {values}: {} particles, {} steps, {:.1} s at least",
                    cost.particles,
                    cost.steps,
                    cost.seconds_per_step * cost.steps as f64
                );
            }
            Swept::Scene(scene) => say!("    {values}: at most {:.0} particles", scene.most_particles()),
        }
    }
    if cost && updates > 0.0 {
        say!("    all points: {updates:.2e} particle updates, {seconds:.1} s at least, one after the other");
    }
    Ok(())
}
