//! Claims about the maps F, H and J against the positions they describe.

use super::Claim;

mod frames;
mod gradient;
mod laminate;
mod maps;
mod pressure;
mod traction;

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    gradient::VERLET,
    gradient::HEUN,
    gradient::TRANSLATION,
    gradient::ROTATION,
    traction::PATCH,
    traction::PATCH_HOURGLASS,
    pressure::HYDROSTATIC,
    laminate::SERIES,
    laminate::PARALLEL,
    frames::TURNED,
    frames::MIRRORED,
    frames::HOMOGENEOUS,
    frames::UNITS,
    frames::EIGHTH,
    maps::EVOLVED_H,
    maps::FREE_MAPS,
    maps::RESTORED_J,
];
