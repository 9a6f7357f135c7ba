//! What records ask of a state.
//!
//! Owns the preparation of probes once and their evaluation at every sample, for the whole body.

use super::field::field_value;
use super::involution::{Involutions, involutions};
use super::point::Interpolation;
use super::totals::{Totals, totals};
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
}

/// What a probe reads.
#[derive(Debug, Clone)]
enum Prepared {
    /// Nothing beyond time, totals, involutions or extremes.
    Plain,
    /// Particles and weights.
    Weighted { body: usize, weights: Vec<(usize, f64)>, factor: f64 },
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
        };
        for probe in tapes.flat_map(Tape::leaves) {
            if observer.prepared.iter().any(|(known, _)| known == probe) {
                continue;
            }
            observer.needs_totals |= reads_totals(probe);
            observer.needs_involutions |= reads_involutions(probe);
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
        let mut scratch = Vec::new();
        let mut value = |probe: &Probe| self.value(probe, simulation, &sums, &maps);
        tapes.map(|tape| tape.evaluate(&mut value, &mut scratch)).collect()
    }

    fn value(&self, probe: &Probe, simulation: &Simulation, sums: &Totals, maps: &Involutions) -> f64 {
        let bodies = simulation.bodies();
        let weighted = |value: &dyn Fn(&BodyState, usize) -> f64| {
            let prepared =
                self.prepared.iter().find(|(known, _)| known == probe).map(|(_, prepared)| prepared);
            let Some(Prepared::Weighted { body, weights, factor }) = prepared else { return f64::NAN };
            let body = &bodies[*body];
            factor * weights.iter().map(|&(a, w)| w * value(body, a)).sum::<f64>()
        };
        match probe {
            Probe::Time => simulation.time(),
            Probe::Displacement { axis, .. } | Probe::DisplacementAt { axis, .. } => {
                weighted(&|body, a| field_value(body, a, Field::Displacement(*axis)))
            }
            Probe::Reaction { axis, .. } => weighted(&|body, a| {
                -body.density * body.particles.volume[a] * body.acceleration[a].0[*axis as usize]
            }),
            Probe::SectionForce { normal, axis, .. } => {
                weighted(&|body, a| body.stress(a)[(*axis as usize, *normal as usize)])
            }
            Probe::FieldAt { field, .. } => weighted(&|body, a| field_value(body, a, *field)),
            Probe::FieldMax(field) => extreme(bodies, *field, |new, old| new > old),
            Probe::FieldMin(field) => extreme(bodies, *field, |new, old| new < old),
            Probe::KineticEnergy => sums.kinetic_energy,
            Probe::StrainEnergy => sums.strain_energy,
            Probe::TotalEnergy => sums.kinetic_energy + sums.strain_energy,
            Probe::Momentum(axis) => sums.momentum[*axis as usize],
            Probe::AngularMomentum(axis) => sums.angular_momentum[*axis as usize],
            Probe::Volume => sums.volume,
            Probe::GradientError => maps.gradient,
            Probe::AreaMapError => maps.area_map,
            Probe::VolumeMapError => maps.volume_map,
            Probe::CurlF => maps.curl_f,
            Probe::DivH => maps.div_h,
        }
    }
}

fn extreme(bodies: &[BodyState], field: Field, better: fn(f64, f64) -> bool) -> f64 {
    let values = bodies.iter().flat_map(|body| (0..body.len()).map(move |a| field_value(body, a, field)));
    values.reduce(|old, new| if better(new, old) || new.is_nan() { new } else { old }).unwrap_or(f64::NAN)
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
        Probe::Displacement { region, .. } => face_mean(bodies, region),
        Probe::DisplacementAt { body, point, .. } | Probe::FieldAt { body, point, .. } => {
            let state = &bodies[*body];
            let found = Interpolation::new(&state.particles, &(*point).into())
                .ok_or_else(|| ProbeError::OutsideBody { body: state.name.clone(), point: *point })?;
            Prepared::Weighted { body: *body, weights: found.weights, factor: 1.0 }
        }
        Probe::Reaction { region, axis } => reaction(scene, bodies, region, *axis as usize),
        Probe::SectionForce { body, normal, at, axis } => {
            section(scene, bodies, *body, *normal as usize, *at, *axis as usize)?
        }
        _ => Prepared::Plain,
    })
}

/// Area-weighted mean over a face.
fn face_mean(bodies: &[BodyState], region: &Region) -> Prepared {
    let Some(face) = bodies[region.body].particles.face(&region.face) else { return Prepared::Plain };
    let weights = face.nodes.iter().zip(&face.area).map(|(&a, area)| (a as usize, area.norm())).collect();
    let total: f64 = face.area.iter().map(|area| area.norm()).sum();
    Prepared::Weighted { body: region.body, weights, factor: 1.0 / total }
}

/// Mirror images of a plane normal to `normal`, and whether component `axis` cancels among them.
fn images(scene: &Scene, normal: Option<usize>, axis: usize) -> f64 {
    let across = |plane: usize| Some(plane) != normal && scene.symmetry[plane].is_some();
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
    let normal = scene.bodies[region.body].shape.face_normal(&region.face).map(|n| n.iamax());
    Prepared::Weighted { body: region.body, weights, factor: images(scene, normal, axis) }
}

/// Force through a plane: the forces of the layers within the reach of a stencil, weighted to it.
///
/// ```text
/// f_i = Σ_l w_l Σ_{a in l} (V_a/h_l) P_iJ(a) N_J / Σ_l w_l,   w_l = 1 − |X_l − s|/(2 dx)
/// ```
///
/// `V_a/h_l` is the cross-section a node stands for: `h_l = dx`, or `dx/2` in the layer at an end
/// of the modelled part. Two spacings wide, because nodal stresses may alternate from layer to layer
/// (a zero-energy mode that no force opposes) while their mean carries the load. A layer beside a
/// plane of symmetry counts with its mirror image.
fn section(
    scene: &Scene,
    bodies: &[BodyState],
    index: usize,
    normal: usize,
    at: f64,
    axis: usize,
) -> Result<Prepared, ProbeError> {
    let body = &bodies[index];
    let spacing = layer_spacing(body, normal);
    let near = |a: f64, b: f64| (a - b).abs() <= ON_PLANE * spacing;
    let mut layers: Vec<f64> = body.particles.position.iter().map(|x| x[normal]).collect();
    layers.sort_by(f64::total_cmp);
    layers.dedup_by(|a, b| near(*a, *b));
    let (low, high) = (layers[0], layers[layers.len() - 1]);
    if !(near(at, low) || near(at, high) || (low < at && at < high)) {
        return Err(ProbeError::NoSection { body: body.name.clone(), axis: ['x', 'y', 'z'][normal], at });
    }
    let mirror = scene.symmetry[normal].as_ref().map(|plane| plane.at);
    let hat = |x: f64| (1.0 - (x - at).abs() / (2.0 * spacing)).max(0.0);
    let share = |x: f64| match mirror {
        Some(plane) if !near(x, plane) => hat(x) + hat(2.0 * plane - x),
        _ => hat(x),
    };
    let total: f64 = layers.iter().map(|&x| share(x)).sum();
    let weights = body
        .particles
        .position
        .iter()
        .enumerate()
        .map(|(a, x)| (a, x[normal], share(x[normal])))
        .filter(|(_, _, share)| *share > ON_PLANE)
        .map(|(a, x, share)| {
            let thickness = if near(x, low) || near(x, high) { 0.5 * spacing } else { spacing };
            (a, share / total * body.particles.volume[a] / thickness)
        })
        .collect();
    Ok(Prepared::Weighted { body: index, weights, factor: images(scene, Some(normal), axis) })
}

/// Distance between node layers along an axis: the spacing, or what the lattice made of it.
fn layer_spacing(body: &BodyState, axis: usize) -> f64 {
    let mut coordinates: Vec<f64> = body.particles.position.iter().map(|x| x[axis]).collect();
    coordinates.sort_by(f64::total_cmp);
    let gaps = coordinates.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.filter(|gap| *gap > ON_PLANE * body.particles.spacing).fold(0.0, f64::max)
}

/// Share of the spacing below which two coordinates are one.
const ON_PLANE: f64 = 1e-6;
