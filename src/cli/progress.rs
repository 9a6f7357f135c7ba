//! The progress bar of a run.

use super::interrupt::is_interrupted;
use crate::run::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::{Duration, Instant};

/// Progress over simulated time, with step, time, Δt and the time left.
#[derive(Debug)]
pub struct Bar {
    bar: ProgressBar,
    drawn: Instant,
}

/// Parts of the bar.
const PARTS: u64 = 10_000;

/// How often it is drawn.
const PERIOD: Duration = Duration::from_millis(100);

impl Bar {
    /// A bar for a scene, hidden when quiet or when nobody watches.
    pub fn new(scene: &str, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let style = ProgressStyle::with_template("{prefix} [{bar:30}] {percent:>3} %  {msg}  ETA {eta}")
            .unwrap_or_else(|_| ProgressStyle::default_bar())
            .progress_chars("=> ");
        let bar = ProgressBar::with_draw_target(Some(PARTS), target).with_style(style);
        bar.set_prefix(scene.to_string());
        Self { bar, drawn: Instant::now() }
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Bar {
    fn step(&mut self, steps: u64, time: f64, step: f64, end: f64) {
        if self.drawn.elapsed() < PERIOD && time < end {
            return;
        }
        self.drawn = Instant::now();
        self.bar.set_position((time / end * PARTS as f64) as u64);
        self.bar.set_message(format!("step {steps}  t {time:.4e} s  Δt {step:.3e} s"));
    }

    fn is_interrupted(&self) -> bool {
        is_interrupted()
    }
}
