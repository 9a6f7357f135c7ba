//! When to sample.
//!
//! Owns the sample times of one record or frame series: multiples of its interval, and the end.

/// Sample times `0, every, 2 every, …, until`.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    every: f64,
    until: f64,
    /// Intervals to the end, where they divide it.
    whole: Option<f64>,
    taken: u64,
}

/// Share of an interval below which two times are one.
const SAME: f64 = 1e-6;

impl Schedule {
    /// A schedule that starts at time zero.
    pub fn new(every: f64, until: f64) -> Self {
        let count = libm::round(until / every);
        let whole = (count >= 1.0 && (count * every - until).abs() < SAME * every).then_some(count);
        Self { every, until, whole, taken: 0 }
    }

    /// Time of the next sample, `None` after the end. A multiple within a millionth of an interval
    /// of the end is the end.
    pub fn next(&self) -> Option<f64> {
        let before = (self.taken > 0).then(|| self.time(self.taken - 1));
        (before != Some(self.until)).then(|| self.time(self.taken))
    }

    /// Whether a sample is due at `time`.
    pub fn is_due(&self, time: f64) -> bool {
        self.next().is_some_and(|next| next <= time + SAME * self.every)
    }

    /// Takes the next sample if it is due at `time`. Times of two schedules that differ by round-off
    /// are one: a step of that length would have no meaning.
    pub fn take(&mut self, time: f64) -> bool {
        let due = self.is_due(time);
        self.taken += u64::from(due);
        due
    }

    fn time(&self, index: u64) -> f64 {
        let time = match self.whole {
            Some(count) => self.until * index as f64 / count,
            None => index as f64 * self.every,
        };
        if time > self.until - SAME * self.every { self.until } else { time }
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
            assert!(schedule.take(time));
        }
        times
    }

    #[test]
    fn the_end_is_sampled_once_whether_the_interval_divides_it_or_not() {
        assert_eq!(times(0.5, 1.0), [0.0, 0.5, 1.0]);
        assert_eq!(times(0.375, 1.0), [0.0, 0.375, 0.75, 1.0]);
        // 60 × 1e-4 rounds to a neighbour of 6e-3
        assert_eq!(times(1e-4, 6e-3).len(), 61);
        assert_eq!(times(1e-4, 6e-3).last(), Some(&6e-3));
    }

    #[test]
    fn an_interval_longer_than_the_run_samples_both_ends() {
        assert_eq!(times(5.0, 1.0), [0.0, 1.0]);
    }

    #[test]
    fn samples_of_two_schedules_that_differ_by_round_off_are_taken_together() {
        // 140 x 2e-5 and 7 x 4e-4 are neighbouring numbers
        let (mut fine, mut coarse) = (Schedule::new(2e-5, 3.99e-3), Schedule::new(4e-4, 3.99e-3));
        for _ in 0..140 {
            let time = fine.next().expect("before the end");
            assert!(fine.take(time));
        }
        for _ in 0..7 {
            let time = coarse.next().expect("before the end");
            assert!(coarse.take(time));
        }
        let (a, b) = (fine.next().expect("inside"), coarse.next().expect("inside"));
        assert!(a != b && (a - b).abs() < 1e-17);
        assert!(fine.take(a.min(b)) && coarse.take(a.min(b)));
    }
}
