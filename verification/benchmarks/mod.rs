//! Claims about cases with an independent reference: the scenes of `specs/` that carry expect lines.

use super::Claim;
use crate::verify::claim::Tier;

/// The claims of this directory, in the order of the report; the scenes bring their own.
pub(crate) const CLAIMS: &[Claim] = &[];

/// Claims that take minutes.
pub(crate) const FULL: &[Claim] = &[];

/// A file whose scenes' expect lines are held.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BenchmarkFile {
    /// Its path in the project.
    pub(crate) path: &'static str,
    /// When it is run.
    pub(crate) tier: Tier,
    /// Values that make its scenes wrong ones, for the controls. Lines that hold of the wrong scene as
    /// well are displaced by twenty tolerances instead.
    pub(crate) wrong: &'static [(&'static str, &'static str)],
}

/// Files whose expect lines are held.
pub(crate) const SCENES: &[BenchmarkFile] = &[
    BenchmarkFile { path: "specs/artery/axial.tissue", tier: Tier::Quick, wrong: OTHER_FIBRES },
    BenchmarkFile { path: "specs/artery/circumferential.tissue", tier: Tier::Full, wrong: OTHER_FIBRES },
    BenchmarkFile { path: "specs/artery/fifteen.tissue", tier: Tier::Full, wrong: OTHER_FIBRES },
    BenchmarkFile { path: "specs/artery/axial_aligned.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/artery/circumferential_aligned.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/artery/fifteen_aligned.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/artery/circumferential_public.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/skin/parallel.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/skin/perpendicular.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/skin/asymmetric.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile { path: "specs/artery/layered.tissue", tier: Tier::Full, wrong: &[] },
    BenchmarkFile {
        path: "specs/loads/moved_faces.tissue",
        tier: Tier::Quick,
        // a softer gel
        wrong: &[("gel.neo_hooke.mu", "15 kPa")],
    },
    BenchmarkFile {
        path: "specs/loads/inflated_tube.tissue",
        tier: Tier::Full,
        wrong: &[("gel.neo_hooke.mu", "15 kPa"), ("wound.hgo.k1", "20 kPa")],
    },
    BenchmarkFile {
        path: "specs/classics/twisting_column.tissue",
        tier: Tier::Quick,
        // a softer column, which goes on turning
        wrong: &[("rubber.E", "8 MPa")],
    },
    BenchmarkFile {
        path: "specs/classics/twisting_column_fine.tissue",
        tier: Tier::Full,
        wrong: &[("rubber.E", "8 MPa"), ("column.spacing", "0.125 m")],
    },
    BenchmarkFile {
        path: "specs/classics/bending_column.tissue",
        tier: Tier::Quick,
        wrong: &[("rubber.E", "8 MPa")],
    },
    BenchmarkFile { path: "specs/punch/jump.tissue", tier: Tier::Full, wrong: SOFTER_PUNCH },
    BenchmarkFile { path: "specs/punch/smooth.tissue", tier: Tier::Full, wrong: SOFTER_PUNCH },
    BenchmarkFile { path: "specs/punch/lightly.tissue", tier: Tier::Full, wrong: SOFTER_PUNCH },
    BenchmarkFile { path: "specs/punch/quadratic.tissue", tier: Tier::Full, wrong: SOFTER_PUNCH },
    BenchmarkFile { path: "specs/fits/myocardium.tissue", tier: Tier::Quick, wrong: &[] },
    BenchmarkFile { path: "specs/fits/rubber.tissue", tier: Tier::Quick, wrong: &[] },
    BenchmarkFile {
        path: "specs/sweeps/dispersion.tissue",
        tier: Tier::Quick,
        // half the matrix, as where C is read as c/2
        wrong: &[("adventitia.goh.C", "3.82 kPa")],
    },
    BenchmarkFile {
        path: "specs/sweeps/wave.tissue",
        tier: Tier::Quick,
        // another bar than the one whose motion is known: its error does not vanish with the spacing
        wrong: &[("gel.neo_hooke.mu", "5 kPa")],
    },
    BenchmarkFile {
        path: "specs/classics/tensile_cable.tissue",
        tier: Tier::Quick,
        wrong: &[("steel.density", "8400 kg/m^3")],
    },
    BenchmarkFile {
        path: "specs/classics/spinning_cube.tissue",
        tier: Tier::Quick,
        wrong: &[("run.angular_momentum", "free"), ("run.momentum_dissipation", "constant")],
    },
    BenchmarkFile {
        path: "specs/classics/l_block.tissue",
        tier: Tier::Quick,
        wrong: &[("run.angular_momentum", "free"), ("block.spacing", "1 m")],
    },
    BenchmarkFile {
        path: "specs/classics/oscillating_plate.tissue",
        tier: Tier::Full,
        wrong: &[("rubber.E", "2.8 MPa")],
    },
];

/// Fibres of less dispersion, on a coarse lattice.
const OTHER_FIBRES: &[(&str, &str)] = &[("adventitia.kappa", "0.1"), ("strip.spacing", "0.25 mm")];

/// A plate of a third of the stiffness, on a coarse lattice.
const SOFTER_PUNCH: &[(&str, &str)] = &[("gel.E", "15 kPa"), ("plate.spacing", "0.125 m")];

/// Every scene file and every reference table of the project, by path.
pub(crate) const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/files.rs"));
