//! The length of a step: held until it must shrink, asked for anew when the body has strained.
//!
//! Owns when wave speeds are refreshed and what becomes of the step they allow. A step that followed the state
//! would pump energy into an undamped motion: velocity Verlet keeps a nearby energy only at a constant step. Knows
//! neither bodies nor clocks.

/// Relative change of the allowed step that one interval between refreshes is to bring.
const CHANGE: f64 = 0.02;

/// Strain after which the speed is asked for first, before anything is known of how fast the material stiffens.
const FIRST: f64 = 2e-3;

/// Strain after which it is asked for at the latest.
const LATEST: f64 = 0.05;

/// How far a step may outlive what is allowed: from the default Courant number 0.9 to 0.97 of the limit.
const OUTLIVES: f64 = 1.08;

/// By how much the allowed step must have grown before the step follows.
const GROWTH: f64 = 1.25;

/// State of the choice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pace {
    /// The step held, s; infinite before the first.
    step: f64,
    /// What was allowed at the last refresh, s.
    allowed: f64,
    /// `Σ Δt max |Grad v|` since then.
    strain: f64,
    /// Strain at which the next refresh is due.
    trigger: f64,
    /// Steps since the last refresh.
    steps: u32,
}

impl Pace {
    /// Before anything is known.
    pub fn new() -> Self {
        Self { step: f64::INFINITY, allowed: f64::INFINITY, strain: 0.0, trigger: FIRST, steps: 0 }
    }

    /// The step to take at most, s.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Counts a step in which the fastest particle strained by `strain`.
    pub fn moved(&mut self, strain: f64) {
        self.strain += strain;
        self.steps = self.steps.saturating_add(1);
    }

    /// Whether the wave speed is to be refreshed before the next step: the body has strained enough to have changed
    /// it, or `every` steps have passed.
    pub fn is_due(&self, every: u32) -> bool {
        // a strain that is no number is a matter for who looks at the state
        self.steps >= every || self.strain >= self.trigger || self.strain.is_nan()
    }

    /// Takes note of what is allowed now, s.
    ///
    /// The strain until the next refresh is what brought a change of 2 % the last time, within a factor of four
    /// down and two up. The step shrinks to what is allowed when it exceeds that by 8 %, or by what the Courant
    /// number leaves to the limit, and grows when it could by a quarter.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `allowed` | Courant number times the limit | s |
    /// | `reserve` | limit over the Courant number in use | – |
    pub fn refresh(&mut self, allowed: f64, reserve: f64) {
        if self.allowed.is_finite() && self.strain > 0.0 {
            let change = libm::fabs(libm::log(allowed / self.allowed));
            let wanted = if change > 0.0 { self.strain * (CHANGE / change) } else { f64::INFINITY };
            self.trigger = wanted.clamp(0.25 * self.trigger, 2.0 * self.trigger).min(LATEST);
        }
        let outlives = (0.97 * reserve).clamp(1.0, OUTLIVES);
        if self.step > outlives * allowed || allowed > GROWTH * self.step {
            self.step = allowed;
        }
        (self.allowed, self.strain, self.steps) = (allowed, 0.0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn started(allowed: f64) -> Pace {
        let mut pace = Pace::new();
        pace.refresh(allowed, 1.0 / 0.9);
        pace
    }

    #[test]
    fn the_step_is_held_while_little_changes() {
        let mut pace = started(1.0);
        for allowed in [0.99, 0.95, 0.93, 1.2] {
            pace.refresh(allowed, 1.0 / 0.9);
            assert_eq!(pace.step(), 1.0);
        }
        pace.refresh(0.9, 1.0 / 0.9);
        assert_eq!(pace.step(), 0.9);
        pace.refresh(1.2, 1.0 / 0.9);
        assert_eq!(pace.step(), 1.2);
    }

    #[test]
    fn a_courant_number_at_the_limit_leaves_the_step_no_respite() {
        let mut pace = started(1.0);
        pace.refresh(0.99, 1.0);
        assert_eq!(pace.step(), 0.99);
    }

    #[test]
    fn a_material_that_stiffens_is_asked_sooner_and_one_that_does_not_later() {
        let mut pace = started(1.0);
        pace.moved(FIRST);
        assert!(pace.is_due(100));
        pace.refresh(0.95, 1.0 / 0.9);
        // a change of 5.1 % where 2 % are wanted: two fifths, within the factor of four
        assert!((pace.trigger - FIRST * CHANGE / libm::log(1.0 / 0.95)).abs() <= f64::EPSILON);
        for _ in 0..20 {
            pace.moved(pace.trigger);
            pace.refresh(0.95, 1.0 / 0.9);
        }
        assert_eq!(pace.trigger, LATEST);
        assert!(!pace.is_due(1));
        (0..5).for_each(|_| pace.moved(0.0));
        assert!(pace.is_due(5) && !pace.is_due(6));
        pace.moved(f64::NAN);
        assert!(pace.is_due(100));
    }
}
