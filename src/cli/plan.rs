//! `tissue plan`.

use super::Exit;
use super::arguments::PlanOptions;
use super::input::{read_or_explain, scenes};
use crate::plan::Plan;
use crate::run::Cost;

/// Prints what each scene models and why, and on request what it costs.
pub fn plan(options: &PlanOptions) -> Exit {
    match try_plan(options) {
        Ok(()) => Exit::Fine,
        Err(exit) => exit,
    }
}

fn try_plan(options: &PlanOptions) -> Result<(), Exit> {
    let input = read_or_explain(&options.file, &options.overrides)?;
    for scene in scenes(&input, options.scene.as_deref())? {
        let plan = Plan::new(scene);
        say_on!("{plan}");
        if options.cost {
            let cost = Cost::measure(scene, &plan).map_err(|cause| {
                eprintln!("error: scene `{}`: {cause}", scene.name);
                Exit::WrongInput
            })?;
            say_on!("{cost}");
        }
    }
    Ok(())
}
