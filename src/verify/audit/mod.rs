//! The report `tissue check` gives on a material: what it does at rest and where it stops making sense.
//!
//! Owns which numbers are asked for, at which states, and what is good enough. The measurements are
//! those of [`crate::energy::audit`]; the text is in `render`.

mod elliptic;
mod joins;
mod judge;
mod map;
mod quadrature;
mod render;
mod rest;

use crate::energy::audit::{Subject, moduli};
use crate::energy::{EnergyError, Law};
use crate::scene::{Check, Coordinate, Direction, Material};
use crate::tensor::{Mat3, Vec3};
use serde::Serialize;

pub use elliptic::EllipticPath;
pub use judge::{Property, Standing};
pub use map::ellipticity_map;
pub(crate) use render::quantity;
pub use rest::{Along, Pulled, Side};

/// Stretches scanned, from the strongest compression to the strongest tension.
pub const STRETCHES: [f64; 2] = [0.7, 1.4];

/// Stretch up to which bars are pulled where no check says what is expected.
const PULLED: f64 = 1.1;

/// Place at which a direction that depends on place is taken, m; off every axis and plane.
const PLACE: [f64; 3] = [1e-3, 2e-3, 3e-3];

/// The audit of one material. Numbers are SI; one that does not exist is not a number, `null` in JSON.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialAudit {
    /// Name of the material.
    pub material: String,
    /// Mass per reference volume, kg/m³.
    pub density: f64,
    /// Names of the directions its law is given.
    pub directions: Vec<String>,
    /// Directions that depend on place, here taken at `[1, 2, 3] mm`.
    pub varying: Vec<String>,
    /// Mean shear modulus at rest, brackets slack, Pa.
    pub shear_modulus: f64,
    /// Bulk modulus at rest, brackets slack, Pa.
    pub bulk_modulus: f64,
    /// Fastest pressure wave at rest, m/s.
    pub pressure_wave_speed: Option<f64>,
    /// Fastest shear wave at rest, m/s.
    pub shear_wave_speed: Option<f64>,
    /// Pulled and pushed along each direction; an isotropic law only along x.
    pub along: Vec<Along>,
    /// Smallest and largest stretch of the scans.
    pub stretches: [f64; 2],
    /// Strong ellipticity along paths of deformation.
    pub ellipticity: Vec<EllipticPath>,
    /// What holds and what does not.
    pub properties: Vec<Property>,
    /// What the file requires.
    pub requirements: Vec<Requirement>,
}

/// A property the file requires.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Requirement {
    /// The property.
    pub property: String,
    /// Whether the law has it.
    pub is_met: bool,
    /// Where it is required: `file:line`.
    pub place: String,
}

impl MaterialAudit {
    /// Measures a material over [`STRETCHES`].
    ///
    /// # Errors
    /// If its energy cannot be differentiated.
    pub fn of(material: &Material) -> Result<Self, EnergyError> {
        Self::over(material, STRETCHES, PULLED)
    }

    /// Measures what a check asks about its material.
    ///
    /// # Errors
    /// As [`MaterialAudit::of`].
    pub fn of_check(check: &Check) -> Result<Self, EnergyError> {
        let pulled = check.stretches.map_or(PULLED, |[_, high]| high);
        let mut audit = Self::over(&check.material, check.stretches.unwrap_or(STRETCHES), pulled)?;
        let requirement = |wanted: &String| {
            let found = audit.properties.iter().find(|property| property.property == wanted);
            Requirement {
                property: wanted.clone(),
                // A law without pieces or integrals has none that could fail; any other question that does not
                // arise has no answer to rely on.
                is_met: match found {
                    Some(property) => property.standing == Standing::Holds,
                    None => matches!(wanted.as_str(), "joins" | "integration"),
                },
                place: format!("{}:{}", check.place.file, check.place.line),
            }
        };
        audit.requirements = check.require.iter().map(requirement).collect();
        Ok(audit)
    }

    /// Measures a material over a range of stretches, bars pulled up to `pulled`.
    fn over(material: &Material, stretches: [f64; 2], pulled: f64) -> Result<Self, EnergyError> {
        let values: Vec<f64> = material.parameters.iter().map(|parameter| parameter.value).collect();
        let law = Law::compile(&material.energy, &values)?;
        let given: Vec<Vec3> = material.directions.iter().map(vector).collect();
        let subject = Subject { law: &law, directions: &given };
        let named = named(material);
        let rest = law.wave_speeds(&Mat3::identity(), &given, material.density).ok();
        let moduli = moduli(&subject);
        let ellipticity = elliptic::paths(&subject, &named, stretches);
        let varying = material.directions.iter().chain(&material.frame).filter(|direction| varies(direction));
        let mut properties = judge::properties(
            &subject,
            &ellipticity,
            stretches,
            quadrature::error(&subject, material, &values, &named)?,
        );
        properties.extend(joins::property(&subject, material, &values, &named)?);
        let mut varying: Vec<String> = varying.map(|direction| direction.name.clone()).collect();
        varying.dedup();
        Ok(Self {
            material: material.name.clone(),
            density: material.density,
            directions: material.directions.iter().map(|direction| direction.name.clone()).collect(),
            varying,
            shear_modulus: moduli.shear,
            bulk_modulus: moduli.bulk,
            pressure_wave_speed: rest.map(|speeds| speeds.pressure),
            shear_wave_speed: rest.map(|speeds| speeds.shear),
            along: named
                .iter()
                .map(|(name, along)| Along::of(&subject, material.density, name, along, pulled))
                .collect(),
            stretches,
            properties,
            ellipticity,
            requirements: Vec::new(),
        })
    }

    /// Whether everything holds without which no computation makes sense, and what the file requires.
    ///
    /// Losing ellipticity is a property of the law, told but not refused unless the file does.
    pub fn is_sound(&self) -> bool {
        self.properties.iter().all(|property| property.standing != Standing::Broken)
            && self.requirements.iter().all(|requirement| requirement.is_met)
    }
}

/// The directions to pull along: the law's and the frame's, or x.
fn named(material: &Material) -> Vec<(String, Vec3)> {
    let mut named: Vec<(String, Vec3)> = Vec::new();
    for direction in material.directions.iter().chain(&material.frame) {
        if named.iter().all(|(name, _)| *name != direction.name) {
            named.push((direction.name.clone(), vector(direction)));
        }
    }
    if named.is_empty() {
        named.push(("x".into(), Vec3::x()));
    }
    named
}

/// A direction at [`PLACE`] and time 0, of length 1; an axis where it has none.
fn vector(direction: &Direction) -> Vec3 {
    let mut scratch = Vec::new();
    let leaf = |leaf: &Coordinate| match leaf {
        Coordinate::X(axis) => PLACE[usize::from(*axis)],
        Coordinate::Time => 0.0,
    };
    let [x, y, z] = direction.components.each_ref().map(|component| component.evaluate(leaf, &mut scratch));
    let found = Vec3::new(x, y, z);
    let is_unit = (found.norm() - 1.0).abs() < 1e-6;
    if is_unit { found } else { found.try_normalize(1e-12).unwrap_or(Vec3::x()) }
}

/// Whether a direction depends on place or time.
fn varies(direction: &Direction) -> bool {
    direction.components.iter().any(|component| component.leaves().next().is_some())
}
