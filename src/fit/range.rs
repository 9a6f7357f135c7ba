//! The admissible range of a parameter.

/// One end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// The end, in SI.
    pub value: f64,
    /// Whether the end itself is outside.
    pub is_excluded: bool,
}

/// Where a parameter may lie.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Range {
    /// Lower end, if there is one.
    pub lower: Option<Bound>,
    /// Upper end, if there is one.
    pub upper: Option<Bound>,
}

/// Part of the way to an excluded end that one step may go.
const TOWARDS_EXCLUDED: f64 = 0.9;

impl Range {
    /// Whether a value lies inside.
    pub fn contains(&self, value: f64) -> bool {
        let above =
            self.lower.is_none_or(|end| value > end.value || (value == end.value && !end.is_excluded));
        let below =
            self.upper.is_none_or(|end| value < end.value || (value == end.value && !end.is_excluded));
        value.is_finite() && above && below
    }

    /// Whether a value lies on an end that belongs to the range: −1 on the lower, 1 on the upper, 0 inside.
    pub fn side(&self, value: f64) -> i8 {
        let on = |end: Option<Bound>| end.is_some_and(|end| !end.is_excluded && value == end.value);
        i8::from(on(self.upper)) - i8::from(on(self.lower))
    }

    /// Where a step from `from`, inside, towards `to` ends: on an end that belongs to the range, before one
    /// that does not.
    pub fn restrict(&self, from: f64, to: f64) -> f64 {
        let beyond = |end: Option<Bound>, is_beyond: fn(f64, f64) -> bool| {
            let end = end?;
            match (is_beyond(to, end.value), end.is_excluded) {
                (true, true) => Some(from + TOWARDS_EXCLUDED * (end.value - from)),
                (true, false) => Some(end.value),
                (false, true) if to == end.value => Some(from + TOWARDS_EXCLUDED * (end.value - from)),
                (false, _) => None,
            }
        };
        beyond(self.lower, |to, end| to < end).or(beyond(self.upper, |to, end| to > end)).unwrap_or(to)
    }
}
