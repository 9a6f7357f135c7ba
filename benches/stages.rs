//! Particle-stages a second and core: one evaluation of the right-hand side of one particle.
//!
//! Prints, for blocks of 8k and 64k particles of 32 neighbours and on one thread, the rate of whole
//! stages. Stress alone is timed beside its hand-written form in the bench `stress`.

use std::time::{Duration, Instant};
use tissue::plan::Plan;
use tissue::scene::{Memory, Scene, resolve};
use tissue::solver::Simulation;
use tissue::syntax::Source;

/// A fibrous block under a start velocity.
const BLOCK: &str = include_str!("block.tissue");

/// Repetitions, of which the fastest counts: noise only ever slows down.
const ROUNDS: usize = 5;

/// Time of one repetition.
const PERIOD: Duration = Duration::from_secs(1);

fn block(spacing: &str) -> Scene {
    let overrides = [("block.spacing".to_string(), spacing.to_string())];
    let source = Source { name: "block.tissue".into(), text: BLOCK.into() };
    let (document, mistakes) = resolve(&source, &Memory::default(), &overrides);
    assert!(mistakes.is_empty(), "{}", mistakes.iter().map(|m| m.render()).collect::<String>());
    document.scenes.into_iter().next().expect("the file has a scene")
}

/// Evaluations of one particle a second, best of several rounds.
fn rate(simulation: &mut Simulation, end: f64) -> f64 {
    let mut best = 0.0_f64;
    for _ in 0..ROUNDS {
        let before = simulation.evaluations();
        let clock = Instant::now();
        while clock.elapsed() < PERIOD {
            simulation.step_towards(end).expect("a gentle motion");
        }
        let done = (simulation.evaluations() - before) as f64 * simulation.particles() as f64;
        best = best.max(done / clock.elapsed().as_secs_f64());
    }
    best
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    println!("particle-stages a second on one core (velocity Verlet, linear states, two fibre families)");
    println!("{:>10} {:>11} {:>14} {:>14}", "particles", "neighbours", "stages/s/core", "bytes/particle");
    for spacing in ["1 mm/19", "1 mm/39"] {
        pool.install(|| {
            let scene = block(spacing);
            let mut simulation =
                Simulation::new(&scene, &Plan::new(&scene)).expect("the block can be set up");
            let particles = simulation.particles();
            let body = &simulation.bodies()[0];
            let inner = (0..body.len()).map(|a| body.links.row(a).len()).max().unwrap_or_default();
            let bytes = body.bytes() / particles;
            let rate = rate(&mut simulation, scene.run.until);
            println!("{particles:>10} {inner:>11} {rate:>14.3e} {bytes:>14}");
        });
    }
}
