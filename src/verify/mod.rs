//! Claims, bounds and verdicts.
