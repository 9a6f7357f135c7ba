//! What records ask of a state.
//!
//! Owns the preparation of probes once and their evaluation at every sample, for the whole body.

use super::field::field_value;
use super::involution::{Involutions, involutions};
use super::mean::mean_weights;
use super::motion::{MotionErrors, motion_errors};
use super::point::Interpolation;
use super::roughness::roughness;
use super::totals::{Totals, totals};
use super::twist::Layers;
use crate::expression::Tape;
use crate::scene::{Field, Probe, Region, Scene, SymmetryPlane};
use crate::solver::{BodyState, Simulation};
use std::fmt;

/// Why a probe cannot be evaluated in a scene.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ProbeError {
    /// The point asked for is outside the modelled part of the body.
    OutsideBody {
        /// Name of the body.
        body: String,
        /// The point, m.
        point: [f64; 3],
    },
    /// The plane asked for does not cut the modelled part of the body.
    NoSection {
        /// Name of the body.
        body: String,
        /// Axis of the normal.
        axis: char,
        /// Coordinate of the plane, m.
        at: f64,
    },
}

impl fmt::Display for ProbeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutsideBody { body, point: [x, y, z] } => write!(
                f,
                "the point ({x:.4e}, {y:.4e}, {z:.4e}) m lies outside the modelled part of `{body}`; \
                 name a point inside it"
            ),
            Self::NoSection { body, axis, at } => write!(
                f,
                "the plane {axis} = {at:.4e} m does not cut the modelled part of `{body}`; \
                 name a coordinate inside it"
            ),
        }
    }
}

impl std::error::Error for ProbeError {}

/// Probes of a scene, prepared against its particles.
#[derive(Debug, Clone)]
pub struct Observer {
    symmetry: [Option<SymmetryPlane>; 3],
    prepared: Vec<(Probe, Prepared)>,
    needs_totals: bool,
    needs_involutions: bool,
    needs_motion: bool,
}

/// What a probe reads.
#[derive(Debug, Clone)]
enum Prepared {
    /// Nothing beyond time, totals, involutions or extremes.
    Plain,
    /// Mirror images that add up.
    Images(f64),
    /// Particles and weights.
    Weighted { body: usize, weights: Vec<(usize, f64)>, factor: f64 },
    /// Layers of a body along an axis.
    Layers { body: usize, layers: Layers },
}

impl Observer {
    /// Prepares all probes of the given tapes.
    ///
    /// # Errors
    /// If a probe names a point or a plane outside the modelled part of a body.
    pub fn new<'a>(
        scene: &Scene,
        bodies: &[BodyState],
        tapes: impl Iterator<Item = &'a Tape<Probe>>,
    ) -> Result<Self, ProbeError> {
        let mut observer = Self {
            symmetry: scene.symmetry.clone(),
            prepared: Vec::new(),
            needs_totals: false,
            needs_involutions: false,
            needs_motion: false,
        };
        for probe in tapes.flat_map(Tape::leaves) {
            if observer.prepared.iter().any(|(known, _)| known == probe) {
                continue;
            }
            observer.needs_totals |= reads_totals(probe);
            observer.needs_involutions |= reads_involutions(probe);
            observer.needs_motion |= matches!(probe, Probe::MotionError(..));
            let prepared = prepare(scene, bodies, probe)?;
            observer.prepared.push((probe.clone(), prepared));
        }
        Ok(observer)
    }

    /// Values of several tapes at the current state, SI.
    pub fn evaluate<'a>(
        &self,
        simulation: &Simulation,
        tapes: impl Iterator<Item = &'a Tape<Probe>>,
    ) -> Vec<f64> {
        let bodies = simulation.bodies();
        let sums = if self.needs_totals { totals(bodies, &self.symmetry) } else { Totals::default() };
        let maps = if self.needs_involutions { involutions(bodies) } else { Involutions::default() };
        let gaps = if self.needs_motion {
            motion_errors(bodies, simulation.time())
        } else {
            MotionErrors::default()
        };
        let mut scratch = Vec::new();
        let mut value = |probe: &Probe| match probe {
            Probe::MotionError(field, norm) => gaps.of(*field, *norm),
            other => self.value(other, simulation, &sums, &maps),
        };
        tapes.map(|tape| tape.evaluate(&mut value, &mut scratch)).collect()
    }

    fn value(&self, probe: &Probe, simulation: &Simulation, sums: &Totals, maps: &Involutions) -> f64 {
        let bodies = simulation.bodies();
        let weighted = |value: &dyn Fn(&BodyState, usize) -> f64| {
            let Some(Prepared::Weighted { body, weights, factor }) = self.prepared(probe) else {
                return f64::NAN;
            };
            let body = &bodies[*body];
            factor * weights.iter().map(|&(a, w)| w * value(body, a)).sum::<f64>()
        };
        match probe {
            Probe::Time => simulation.time(),
            Probe::Displacement { axis, .. } | Probe::DisplacementAt { axis, .. } => {
                weighted(&|body, a| field_value(body, a, Field::Displacement(*axis)))
            }
            Probe::Twist { .. } => {
                let found = self.prepared.iter().find(|(known, _)| known == probe);
                match found {
                    Some((_, Prepared::Layers { body, layers })) => layers.twist(&bodies[*body]),
                    // planes of symmetry cut the body: their images turn the other way, or along with it
                    _ => 0.0,
                }
            }
            Probe::Reaction { axis, .. } => weighted(&|body, a| {
                -body.density * body.particles.volume[a] * body.acceleration[a].0[*axis as usize]
            }),
            Probe::SectionForce { normal, axis, .. } => {
                weighted(&|body, a| body.stress(a)[(*axis as usize, *normal as usize)])
            }
            Probe::FieldAt { field, .. } => weighted(&|body, a| field_value(body, a, *field)),
            Probe::Mean { field, .. } => weighted(&|body, a| field_value(body, a, *field)),
            Probe::Roughness(field) => roughness(bodies, *field),
            Probe::FieldMax(field) => self.extreme(bodies, *field, |new, old| new > old),
            Probe::FieldMin(field) => self.extreme(bodies, *field, |new, old| new < old),
            Probe::KineticEnergy => sums.kinetic_energy,
            Probe::StrainEnergy => sums.strain_energy,
            Probe::TotalEnergy => sums.kinetic_energy + sums.strain_energy,
            Probe::Momentum(axis) => sums.momentum[*axis as usize],
            Probe::AngularMomentum(axis) => sums.angular_momentum[*axis as usize],
            Probe::Impulse { body, face, axis } => {
                let Some(Prepared::Images(count)) = self.prepared(probe) else { return f64::NAN };
                count * simulation.impulses()[*body].of(face.as_deref(), *axis as usize)
            }
            Probe::Volume => sums.volume,
            Probe::MotionError(..) => f64::NAN,
            Probe::GradientError => maps.gradient,
            Probe::AreaMapError => maps.area_map,
            Probe::VolumeMapError => maps.volume_map,
            Probe::CurlF => maps.curl_f,
            Probe::DivH => maps.div_h,
        }
    }

    fn prepared(&self, probe: &Probe) -> Option<&Prepared> {
        self.prepared.iter().find(|(known, _)| known == probe).map(|(_, prepared)| prepared)
    }

    /// Extreme of a field over the particles and their mirror images.
    fn extreme(&self, bodies: &[BodyState], field: Field, better: fn(f64, f64) -> bool) -> f64 {
        let is_odd = (0..3).any(|plane| self.symmetry[plane].is_some() && field.flips(plane));
        let values = bodies.iter().flat_map(|body| (0..body.len()).map(move |a| field_value(body, a, field)));
        let images = values.flat_map(|value| [value, if is_odd { -value } else { value }]);
        images.reduce(|old, new| if better(new, old) || new.is_nan() { new } else { old }).unwrap_or(f64::NAN)
    }
}

fn reads_totals(probe: &Probe) -> bool {
    matches!(
        probe,
        Probe::KineticEnergy
            | Probe::StrainEnergy
            | Probe::TotalEnergy
            | Probe::Momentum(_)
            | Probe::AngularMomentum(_)
            | Probe::Volume
    )
}

fn reads_involutions(probe: &Probe) -> bool {
    matches!(
        probe,
        Probe::GradientError | Probe::AreaMapError | Probe::VolumeMapError | Probe::CurlF | Probe::DivH
    )
}

fn prepare(scene: &Scene, bodies: &[BodyState], probe: &Probe) -> Result<Prepared, ProbeError> {
    Ok(match probe {
        Probe::Displacement { region, axis } => face_mean(scene, bodies, region, *axis as usize),
        Probe::DisplacementAt { body, point, .. } | Probe::FieldAt { body, point, .. } => {
            let state = &bodies[*body];
            let found = Interpolation::new(&state.particles, &(*point).into())
                .ok_or_else(|| ProbeError::OutsideBody { body: state.name.clone(), point: *point })?;
            Prepared::Weighted { body: *body, weights: found.weights, factor: 1.0 }
        }
        Probe::Twist { region } if scene.symmetry.iter().all(Option::is_none) => {
            let normal = scene.bodies[region.body].shape.face_normal(&region.face);
            normal.map_or(Prepared::Plain, |normal| Prepared::Layers {
                body: region.body,
                layers: Layers::new(&bodies[region.body].particles, &normal),
            })
        }
        Probe::Reaction { region, axis } => reaction(scene, bodies, region, *axis as usize),
        Probe::SectionForce { body, normal, at, axis } => {
            section(scene, bodies, *body, *normal as usize, *at, *axis as usize)?
        }
        Probe::Impulse { body, face, axis } => {
            let shape = &scene.bodies[*body].shape;
            let normal = face.as_ref().and_then(|face| shape.face_normal(face)).map(|normal| normal.iamax());
            Prepared::Images(images(&scene.symmetry, normal, *axis as usize))
        }
        Probe::Mean { body, field, weight } => {
            let planes = scene.symmetry.each_ref().map(|plane| plane.as_ref().map(|plane| plane.at));
            let weights = mean_weights(&bodies[*body].particles, planes, *field, weight);
            Prepared::Weighted { body: *body, weights, factor: 1.0 }
        }
        _ => Prepared::Plain,
    })
}

/// Area-weighted mean over a face and its mirror images; a component across a plane cancels.
fn face_mean(scene: &Scene, bodies: &[BodyState], region: &Region, axis: usize) -> Prepared {
    let particles = &bodies[region.body].particles;
    let Some(face) = particles.face(&region.face) else { return Prepared::Plain };
    let sizes = particles.sizes(face);
    let total: f64 = sizes.iter().sum();
    let weights = face.nodes.iter().map(|&a| a as usize).zip(sizes).collect();
    let cancels = images(&scene.symmetry, normal_axis(scene, region), axis) == 0.0;
    Prepared::Weighted { body: region.body, weights, factor: if cancels { 0.0 } else { 1.0 / total } }
}

/// Axis of the normal of a plane face.
fn normal_axis(scene: &Scene, region: &Region) -> Option<usize> {
    scene.bodies[region.body].shape.face_normal(&region.face).map(|normal| normal.iamax())
}

/// Mirror images of a plane normal to `normal`, and whether component `axis` cancels among them.
fn images(symmetry: &[Option<SymmetryPlane>; 3], normal: Option<usize>, axis: usize) -> f64 {
    let across = |plane: usize| Some(plane) != normal && symmetry[plane].is_some();
    if across(axis) {
        return 0.0;
    }
    f64::from(2_u32.pow((0..3).filter(|&plane| across(plane)).count() as u32))
}

/// Nodes of a face whose component is prescribed there.
fn reaction(scene: &Scene, bodies: &[BodyState], region: &Region, axis: usize) -> Prepared {
    let body = &bodies[region.body];
    let held = body.supports.iter().find(|support| support.face == region.face && support.axis == axis);
    let weights = held.map_or_else(Vec::new, |s| s.nodes.iter().map(|&a| (a as usize, 1.0)).collect());
    let factor = images(&scene.symmetry, normal_axis(scene, region), axis);
    Prepared::Weighted { body: region.body, weights, factor }
}

/// Force through a plane: stresses within the reach of a stencil, weighted to it.
///
/// ```text
/// f_i = Σ_a V_a w(X_a) P_iJ(a) N_J,   w(X) = 1/(2 dx) (1 − |X·N − s|/(2 dx)),   ∫ w dX = 1
/// ```
///
/// Two spacings wide to each side, because nodal stresses may alternate from layer to layer (a
/// zero-energy mode that no force opposes) while their mean carries the load. Beyond a plane of
/// symmetry or an end of the body the field goes on as its mirror image. `dx` is the distance of the
/// layers next to the plane; where nodes do not lie in layers, the spacing the lattice makes of the
/// body's extent.
fn section(
    scene: &Scene,
    bodies: &[BodyState],
    index: usize,
    normal: usize,
    at: f64,
    axis: usize,
) -> Result<Prepared, ProbeError> {
    let body = &bodies[index];
    let position = &body.particles.position;
    let mut layers: Vec<f64> = position.iter().map(|x| x[normal]).collect();
    layers.sort_by(f64::total_cmp);
    layers.dedup_by(|next, kept| *next - *kept < ON_PLANE * body.particles.spacing);
    let (low, high) = (layers[0], layers[layers.len() - 1]);
    let mean = (high - low) / libm::round((high - low) / body.particles.spacing).max(1.0);
    let gap = layers.windows(2).find(|pair| at <= pair[1]).map_or(mean, |pair| pair[1] - pair[0]);
    let spacing = if (0.5 * mean..2.0 * mean).contains(&gap) { gap } else { mean };
    let tolerance = ON_PLANE * spacing;
    if at < low - tolerance || at > high + tolerance {
        return Err(ProbeError::NoSection { body: body.name.clone(), axis: ['x', 'y', 'z'][normal], at });
    }
    let hat = |x: f64| (1.0 - (x - at).abs() / (2.0 * spacing)).max(0.0) / (2.0 * spacing);
    let share = |x: f64| hat(x) + hat(2.0 * low - x) + hat(2.0 * high - x);
    let weights = position
        .iter()
        .enumerate()
        .map(|(a, x)| (a, body.particles.volume[a] * share(x[normal])))
        .filter(|(_, weight)| *weight > 0.0)
        .collect();
    Ok(Prepared::Weighted { body: index, weights, factor: images(&scene.symmetry, Some(normal), axis) })
}

/// Share of the spacing below which two coordinates are one.
const ON_PLANE: f64 = 1e-6;
