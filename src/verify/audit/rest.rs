//! A bar pulled and pushed along one direction.

use crate::energy::audit::{Subject, one_sided, overflow_stretch, uniaxial};
use crate::tensor::{Mat3, Vec3};
use serde::Serialize;

/// Strain that stands for none: the secant differs from the slope by about that share.
const REST: f64 = 1e-6;

/// Strain at which the toe of the curve is looked at a second time.
const TOE: f64 = 1e-2;

/// Length of the steps to the largest stretch; each starts from the last.
const STEP: f64 = 0.01;

/// A bar along one direction, free on its sides.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Along {
    /// Name of the direction.
    pub name: String,
    /// Its components.
    pub direction: [f64; 3],
    /// Pulled from rest.
    pub tension: Option<Side>,
    /// Pushed from rest.
    pub compression: Option<Side>,
    /// Pulled as far as is looked.
    pub pulled: Option<Pulled>,
    /// Isochoric stretch at which the exponentials leave the range of numbers.
    pub overflow_stretch: Option<f64>,
}

/// One side of rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Side {
    /// Slope of the nominal stress at rest, Pa.
    pub young_modulus: f64,
    /// Lateral contraction over strain in the two principal lateral directions, ascending.
    pub poisson_ratios: [f64; 2],
    /// Nominal stress at a strain of 1 % over that strain, Pa.
    pub slope_at_one_percent: Option<f64>,
}

/// The bar at the largest stretch that is looked at and at which it is in equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pulled {
    /// The stretch.
    pub stretch: f64,
    /// Nominal stress, Pa.
    pub stress: f64,
    /// Volume over reference volume.
    pub volume: f64,
    /// Fastest pressure wave, m/s in the reference configuration.
    pub pressure_wave_speed: f64,
    /// Fastest shear wave, m/s in the reference configuration.
    pub shear_wave_speed: f64,
}

impl Along {
    /// Measures a bar along a unit vector, pulled up to a stretch; `density` in kg/m³.
    pub(super) fn of(subject: &Subject, density: f64, name: &str, along: &Vec3, pulled: f64) -> Self {
        Self {
            name: name.into(),
            direction: [along.x, along.y, along.z],
            tension: Side::of(subject, along, 1.0),
            compression: Side::of(subject, along, -1.0),
            pulled: Pulled::of(subject, density, along, pulled),
            overflow_stretch: overflow_stretch(subject, along),
        }
    }
}

impl Side {
    fn of(subject: &Subject, along: &Vec3, sign: f64) -> Option<Self> {
        let (young_modulus, poisson_ratios) = one_sided(subject, along, sign * REST)?;
        let slope_at_one_percent = one_sided(subject, along, sign * TOE).map(|(slope, _)| slope);
        Some(Self { young_modulus, poisson_ratios, slope_at_one_percent })
    }
}

impl Pulled {
    fn of(subject: &Subject, density: f64, along: &Vec3, pulled: f64) -> Option<Self> {
        let mut start = Mat3::identity();
        let mut reached = None;
        // Bounded: a range that is asked about ends below 100.
        let steps = libm::ceil((pulled - 1.0) / STEP - 1e-9).max(1.0) as u32;
        for step in 1..=steps {
            let stretch = 1.0 + (pulled - 1.0) * f64::from(step) / f64::from(steps);
            let Some(bar) = uniaxial(subject, along, stretch, &start) else { break };
            start = bar.f;
            reached = Some((stretch, bar));
        }
        let (stretch, bar) = reached?;
        let speeds = subject.law.wave_speeds(&bar.f, subject.directions, density).ok()?;
        Some(Self {
            stretch,
            stress: bar.stress,
            volume: bar.f.determinant(),
            pressure_wave_speed: speeds.pressure,
            shear_wave_speed: speeds.shear,
        })
    }
}
