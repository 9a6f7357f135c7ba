//! `tissue`: a verification-first reference implementation of anisotropic hyperelastic soft tissue
//! by mixed {p, F, H, J} total-Lagrangian smoothed particle hydrodynamics (Nikpour & Badnava 2025),
//! driven by a small declarative language.
//!
//! The layers, each naming only those above it (`ARCHITECTURE.md` has the table, a test holds it):
//! text is parsed by [`syntax`], resolved by [`scene`] with the vocabulary of [`schema`], planned by
//! [`plan`], stepped by [`solver`], observed by [`monitor`], written by [`output`], judged by
//! [`verify`].

pub mod tensor;
pub mod unit;

pub mod expression;
pub mod fit;
pub mod schema;
pub mod syntax;

pub mod discretisation;
pub mod energy;

pub mod scene;

pub mod plan;

pub mod drive;
pub mod solver;

pub mod monitor;

pub mod output;

pub mod run;

pub mod verify;

pub mod cli;
