//! Claims about the maps F, H and J against the positions they describe.

use super::Claim;
use crate::verify::claim::Illustration;

mod affine;
mod frames;
mod gaps;
mod gradient;
mod involution;
mod laminate;
mod maps;
mod pressure;
mod tie;
mod traction;

/// Figures of these claims.
pub(crate) const ILLUSTRATIONS: &[Illustration] = &[
    gradient::FIGURES[0],
    gradient::FIGURES[1],
    maps::FIGURES[0],
    gaps::FIGURES[0],
    gaps::FIGURES[1],
    gaps::FIGURES[2],
    gaps::FIGURES[3],
    involution::FIGURES[0],
    involution::FIGURES[1],
    involution::FIGURES[2],
    involution::FIGURES[3],
    involution::FIGURES[4],
];

/// The claims of this directory, in the order of the report.
pub(crate) const CLAIMS: &[Claim] = &[
    gradient::VERLET,
    gradient::HEUN,
    gradient::TRANSLATION,
    gradient::ROTATION,
    traction::PATCH,
    traction::PATCH_HOURGLASS,
    traction::PATCH_QUADRATIC,
    pressure::HYDROSTATIC,
    laminate::SERIES,
    laminate::PARALLEL,
    tie::PATCH,
    frames::TURNED,
    frames::MIRRORED,
    frames::HOMOGENEOUS,
    frames::UNITS,
    frames::EIGHTH,
    maps::EVOLVED_H,
    maps::FREE_MAPS,
    maps::RESTORED_J,
    affine::AFFINE,
    affine::AFFINE_QUADRATIC,
    involution::ALL_TIMES,
    gaps::AREA_MAP_VERLET,
    gaps::VOLUME_MAP_VERLET,
    gaps::AREA_MAP_HEUN,
    gaps::VOLUME_MAP_HEUN,
    involution::CURL_SWINGING,
    involution::DIV_SWINGING,
    involution::CURL_LARGE,
    involution::DIV_LARGE,
];
