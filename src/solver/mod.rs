//! Right-hand side, loads, constraints, time stepping.
