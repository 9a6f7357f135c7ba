//! What is live, why, in which order, at what cost.
