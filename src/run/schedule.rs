//! When to sample.
//!
//! Owns the sample times of one record or frame series: multiples of its interval, and the end.

/// Sample times `0, every, 2 every, …, until`.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    every: f64,
    until: f64,
    taken: u64,
}

impl Schedule {
    /// A schedule that starts at time zero.
    pub fn new(every: f64, until: f64) -> Self {
        Self { every, until, taken: 0 }
    }

    /// Time of the next sample, `None` after the end. A multiple within a millionth of an interval
    /// of the end is the end.
    pub fn next(&self) -> Option<f64> {
        let before = (self.taken > 0).then(|| self.time(self.taken - 1));
        (before != Some(self.until)).then(|| self.time(self.taken))
    }

    /// Marks the next sample as taken.
    pub fn advance(&mut self) {
        self.taken += 1;
    }

    fn time(&self, index: u64) -> f64 {
        let time = index as f64 * self.every;
        if time > self.until - 1e-6 * self.every { self.until } else { time }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(every: f64, until: f64) -> Vec<f64> {
        let mut schedule = Schedule::new(every, until);
        let mut times = Vec::new();
        while let Some(time) = schedule.next() {
            times.push(time);
            schedule.advance();
        }
        times
    }

    #[test]
    fn the_end_is_sampled_once_whether_the_interval_divides_it_or_not() {
        assert_eq!(times(0.5, 1.0), [0.0, 0.5, 1.0]);
        assert_eq!(times(0.4, 1.0), [0.0, 0.4, 0.8, 1.0]);
        // 60 × 1e-4 rounds to a neighbour of 6e-3
        assert_eq!(times(1e-4, 6e-3).len(), 61);
        assert_eq!(times(1e-4, 6e-3).last(), Some(&6e-3));
    }

    #[test]
    fn an_interval_longer_than_the_run_samples_both_ends() {
        assert_eq!(times(5.0, 1.0), [0.0, 1.0]);
    }
}
