//! The passes of a stage: loops over the particles of a body.
//!
//! Owns the order of work within a stage and its division into chunks. Every chunk writes only what
//! is its own and sums in stencil order, so the result is the same on any number of threads.

use super::body::{Block, BodyState, CHUNK, Failure, Workspace};
use super::dissipation::Speeds;
use super::force::{internal, internal_and_upwinding, volume_dissipation};
use super::hourglass::Packet;
use super::kinematics::{area_map_rate, velocity_gradient, volume_map_rate, volume_restoring};
use super::links::Links;
use super::quad::{Columns, Quad};
use super::wide::wide;
use crate::scene::InterfaceStates;
use crate::tensor::{Mat3, cofactor, volume_map};
use rayon::prelude::*;
use std::sync::{Mutex, MutexGuard};

/// One workspace a thread, handed out by thread index.
#[derive(Debug)]
pub struct Workspaces(Vec<Mutex<Workspace>>);

impl Workspaces {
    /// As many as the current pool has threads.
    pub fn new() -> Self {
        let count = rayon::current_num_threads() + 1;
        Self((0..count).map(|_| Mutex::new(Workspace::default())).collect())
    }

    /// The workspace of the calling thread; never contended.
    pub fn get(&self) -> MutexGuard<'_, Workspace> {
        let index = rayon::current_thread_index().map_or(self.0.len() - 1, |i| i % (self.0.len() - 1));
        self.0[index].lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Default for Workspaces {
    fn default() -> Self {
        Self::new()
    }
}

/// First pass: velocity gradients, the maps over a step of length `step` (0 leaves them), stresses.
///
/// Verlet advances the maps here with the mid-step velocity; Runge–Kutta passes 0 and advances them
/// with [`advance_maps`].
pub fn maps_and_stress(body: &mut BodyState, step: f64, workspaces: &Workspaces) {
    let BodyState { links, v, inverse_volume, blocks, packets, stress, area_map, law, directions, .. } = body;
    let turns = body.hourglass.is_some();
    let (links, v, inverse_volume) = (&*links, &v[..], &inverse_volume[..]);
    let chunks = packets.par_chunks_mut(CHUNK).zip(stress.par_chunks_mut(CHUNK));
    blocks.par_iter_mut().zip(chunks).for_each(|(block, (packets, out))| {
        block.straining = wide!(velocity_gradients(links, v, inverse_volume, block.start, packets));
        if step > 0.0 {
            advance_by_midpoint(block, packets, step);
        }
        let workspace = &mut *workspaces.get();
        workspace.stress.resize(CHUNK, Mat3::zeros());
        let stress = &mut workspace.stress[..block.f.len()];
        let at = directions.slice(block.start, block.f.len());
        law.stress(block.maps(), at, stress, &mut workspace.energy);
        block.failure = inadmissible(block, stress);
        for (out, stress) in out.iter_mut().zip(stress) {
            *out = Columns::new(stress);
        }
        if turns {
            for (packet, f) in packets.iter_mut().zip(&block.f) {
                let h = cofactor(f);
                packet.f = Columns::new(f);
                packet.turn(&(h / volume_map(f, &h)));
            }
        }
    });
    if !area_map.is_empty() {
        area_map.par_chunks_mut(CHUNK).zip(blocks.par_iter()).for_each(|(area_map, block)| {
            for (i, area) in area_map.iter_mut().enumerate() {
                *area = Columns::new(&block.h.get(i).copied().unwrap_or_else(|| cofactor(&block.f[i])));
            }
        });
    }
}

/// Velocity gradients of a chunk; returns the greatest of their squares, 1/s².
#[inline(always)]
fn velocity_gradients(
    links: &Links,
    velocity: &[Quad],
    inverse_volume: &[f64],
    start: usize,
    packets: &mut [Packet],
) -> f64 {
    let mut greatest = 0.0_f64;
    for (i, packet) in packets.iter_mut().enumerate() {
        let gradient = velocity_gradient(links, start + i, velocity, inverse_volume[start + i]);
        packet.gradient = gradient;
        greatest = greatest.max(gradient.0.iter().map(|column| column.dot(*column)).sum());
    }
    greatest
}

/// `F = Σ_b (x_b − x_a) ⊗ G_b(X_a)` of all particles: what the positions say, whatever was added up before.
pub fn gradients_of_positions(body: &mut BodyState) {
    let BodyState { links, x, inverse_volume, blocks, .. } = body;
    let (links, x, inverse_volume) = (&*links, &x[..], &inverse_volume[..]);
    blocks.par_iter_mut().for_each(|block| {
        for (i, f) in block.f.iter_mut().enumerate() {
            let a = block.start + i;
            *f = velocity_gradient(links, a, x, inverse_volume[a]).matrix();
        }
    });
}

/// Advances the maps of a chunk with the velocity gradient of the middle of the step.
///
/// With `ΔF = Δt Grad v` the area map moves by `(F + ½ ΔF) ⨯ ΔF`, exactly the change of `cof F`;
/// the volume map by `½ (H_old + H_new) : ΔF`, the change of `det F` to third order.
fn advance_by_midpoint(block: &mut Block, packets: &[Packet], step: f64) {
    for (i, packet) in packets.iter().enumerate() {
        let change = step * packet.gradient.matrix();
        let f = block.f[i];
        let middle = f + 0.5 * change;
        block.f[i] = f + change;
        if block.j.is_empty() {
            continue;
        }
        let area = if block.h.is_empty() {
            cofactor(&middle)
        } else {
            let old = block.h[i];
            block.h[i] = old + area_map_rate(&middle, &change);
            0.5 * (old + block.h[i])
        };
        block.j[i] += volume_map_rate(&area, &change);
        if let Some(rate) = block.volume_dissipation.get(i) {
            block.j[i] += step * rate;
        }
    }
}

/// Advances the maps of a body by an explicit Euler stage of length `step`.
pub fn advance_maps(body: &mut BodyState, step: f64) {
    let packets = &body.packets;
    body.blocks.par_iter_mut().for_each(|block| {
        for i in 0..block.f.len() {
            let gradient = packets[block.start + i].gradient.matrix();
            let f = block.f[i];
            if !block.j.is_empty() {
                let h = block.h.get(i).copied().unwrap_or_else(|| cofactor(&f));
                let dissipation = block.volume_dissipation.get(i).copied().unwrap_or(0.0);
                block.j[i] += step * (volume_map_rate(&h, &gradient) + dissipation);
            }
            if !block.h.is_empty() {
                block.h[i] += step * area_map_rate(&f, &gradient);
            }
            block.f[i] = f + step * gradient;
        }
    });
}

/// First particle of a chunk that left the domain of its energy.
fn inadmissible(block: &Block, stress: &[Mat3]) -> Option<Failure> {
    (0..block.f.len()).find_map(|i| {
        let particle = block.start + i;
        let f = &block.f[i];
        let value = block.j.get(i).copied().unwrap_or_else(|| volume_map(f, &cofactor(f)));
        if value.is_nan() || value <= 0.0 || value.is_infinite() {
            Some(Failure::Jacobian { particle, value })
        } else if stress[i].iter().any(|component| !component.is_finite()) {
            Some(Failure::Stress { particle })
        } else {
            None
        }
    })
}

/// What the force pass adds up beside the internal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceTerms {
    /// Interface states of D(p).
    pub states: InterfaceStates,
    /// Weighted wave speeds of D(p), m/s.
    pub speeds: Speeds,
    /// D(J); `None` where it is off.
    pub volume: Option<VolumeTerms>,
}

/// What D(J) is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeTerms {
    /// Pressure wave speed of the jump over the weight of D(J), m/s.
    pub speed: f64,
    /// Rate at which J is drawn to `det F`, 1/s; 0 as printed.
    pub relaxation: f64,
}

/// Second pass: `dp/dt / ρR` of every particle, and D(J).
pub fn forces(body: &mut BodyState, terms: ForceTerms) {
    let BodyState { links, x, v, inverse_volume, stress, acceleration, external, density, hourglass, .. } =
        body;
    let read = ForceChunk {
        links,
        x,
        v,
        inverse_volume,
        stress: hourglass.as_ref().map_or(stress, |hourglass| &hourglass.stress),
        external,
        hourglass: hourglass.as_ref().map_or(&[], |hourglass| &hourglass.force),
        density: *density,
        upwinding: terms.upwinding(*density),
    };
    acceleration
        .par_chunks_mut(CHUNK)
        .enumerate()
        .for_each(|(index, acceleration)| wide!(read.accelerations(index * CHUNK, acceleration)));
    if let Some(VolumeTerms { speed, relaxation }) = terms.volume {
        let BodyState { links, x, inverse_volume, stress, area_map, blocks, density, .. } = body;
        blocks.par_iter_mut().for_each(|block| {
            for (i, rate) in block.volume_dissipation.iter_mut().enumerate() {
                let a = block.start + i;
                *rate = volume_dissipation(links, a, stress, x, area_map, *density, speed, inverse_volume[a]);
                if relaxation > 0.0 {
                    *rate += volume_restoring(&block.f[i], block.j[i], relaxation);
                }
            }
        });
    }
}

impl ForceTerms {
    /// Impedances of the upwinding between the particles' own momenta, kg m⁻² s⁻¹; `None` where the force pass has
    /// none.
    fn upwinding(&self, density: f64) -> Option<Speeds> {
        let constant = self.states == InterfaceStates::Constant;
        constant.then_some(Speeds {
            pressure: density * self.speeds.pressure,
            shear: density * self.speeds.shear,
        })
    }
}

/// What the force loop of a chunk reads.
struct ForceChunk<'a> {
    links: &'a Links,
    x: &'a [Quad],
    v: &'a [Quad],
    inverse_volume: &'a [f64],
    stress: &'a [Columns],
    external: &'a [Quad],
    hourglass: &'a [Quad],
    density: f64,
    upwinding: Option<Speeds>,
}

impl ForceChunk<'_> {
    /// Accelerations from the stresses, with what acts from outside.
    #[inline(always)]
    fn accelerations(&self, start: usize, out: &mut [Quad]) {
        let (links, stress, inverse) = (self.links, self.stress, self.inverse_volume);
        for (i, out) in out.iter_mut().enumerate() {
            let a = start + i;
            *out = match self.upwinding {
                None => internal(links, a, stress, inverse[a]),
                Some(impedance) => {
                    internal_and_upwinding(links, a, stress, self.x, self.v, impedance, inverse[a])
                }
            };
            if let Some(&external) = self.external.get(a) {
                *out += external;
            }
            if let Some(&hourglass) = self.hourglass.get(a) {
                *out += hourglass * inverse[a];
            }
            *out = *out * (1.0 / self.density);
        }
    }
}

/// Refreshes the greatest wave speed of a body.
pub fn wave_speeds(body: &mut BodyState, workspaces: &Workspaces) {
    let BodyState { blocks, law, directions, density, .. } = body;
    blocks.par_iter_mut().for_each(|block| {
        let workspace = &mut *workspaces.get();
        workspace.numbers.resize(CHUNK, 0.0);
        let speeds = &mut workspace.numbers[..block.f.len()];
        let at = directions.slice(block.start, block.f.len());
        let energy = &mut workspace.energy;
        law.wave_speed_block(block.maps(), at, *density, speeds, energy);
        block.fastest = (0.0, block.start);
        for (i, &speed) in speeds.iter().enumerate() {
            if faster(speed, block.fastest.0) {
                block.fastest = (speed, block.start + i);
            }
        }
    });
    body.fastest = (0.0, 0);
    for block in &body.blocks {
        if faster(block.fastest.0, body.fastest.0) {
            body.fastest = block.fastest;
        }
    }
}

/// Whether a speed replaces the fastest so far; one that is not a number does, and stays, so that
/// it is found out instead of dropped.
fn faster(speed: f64, fastest: f64) -> bool {
    !fastest.is_nan() && (speed.is_nan() || speed > fastest)
}
