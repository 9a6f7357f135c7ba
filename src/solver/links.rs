//! What a pair of particles carries through the whole run.
//!
//! Owns the constants of the pair loops in the order the loops read them: neighbours, weighted
//! gradients, reference distances and interface areas. Total Lagrangian, so all of it
//! is computed once. Knows no state.

use crate::discretisation::{Particles, Stencils};

/// What a pair `(a, b)` knows of its geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Pair {
    /// Half of `X_b − X_a`, m: what a state is carried over.
    pub half_step: [f64; 3],
    /// [`Stencils::interface`], m².
    pub interface: f64,
}

/// All pairs in compressed rows, a particle's own entry left out.
///
/// Leaving it out loses nothing: every sum of the method is written with differences or with the
/// antisymmetric form of (32), both zero for `b = a`.
#[derive(Debug, Clone, PartialEq)]
pub struct Links {
    /// Row `a` is `start[a] .. start[a + 1]`.
    pub start: Vec<u32>,
    /// Neighbour of each pair.
    pub neighbour: Vec<u32>,
    /// `V_a G_b(X_a)` of each pair, m².
    pub forward: Vec<[f64; 3]>,
    /// `V_b G_a(X_b)` of each pair, m².
    pub backward: Vec<[f64; 3]>,
    /// Distance and interface of each pair.
    pub pair: Vec<Pair>,
}

impl Links {
    /// Reads the pairs of a body from its stencils.
    pub fn new(particles: &Particles, stencils: &Stencils) -> Self {
        let count = particles.position.len();
        let mut links = Self {
            start: Vec::with_capacity(count + 1),
            neighbour: Vec::with_capacity(stencils.neighbour.len()),
            forward: Vec::with_capacity(stencils.neighbour.len()),
            backward: Vec::with_capacity(stencils.neighbour.len()),
            pair: Vec::with_capacity(stencils.neighbour.len()),
        };
        links.start.push(0);
        for a in 0..count {
            for entry in stencils.start[a] as usize..stencils.start[a + 1] as usize {
                let b = stencils.neighbour[entry] as usize;
                if b == a {
                    continue;
                }
                let distance = particles.position[b] - particles.position[a];
                links.neighbour.push(b as u32);
                links.forward.push(stencils.forward[entry].into());
                links.backward.push(stencils.backward[entry].into());
                links
                    .pair
                    .push(Pair { half_step: (0.5 * distance).into(), interface: stencils.interface[entry] });
            }
            links.start.push(links.neighbour.len() as u32);
        }
        links
    }

    /// Entries of row `a`.
    #[inline(always)]
    pub fn row(&self, a: usize) -> std::ops::Range<usize> {
        self.start[a] as usize..self.start[a + 1] as usize
    }

    /// Bytes held, for the plan's account of cost.
    pub fn bytes(&self) -> usize {
        self.neighbour.len() * (size_of::<u32>() + 2 * size_of::<[f64; 3]>() + size_of::<Pair>())
            + self.start.len() * size_of::<u32>()
    }
}
