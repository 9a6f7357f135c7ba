//! Pure functions from a state to numbers.
