//! How many particles a scene asks for, from its text alone.

use super::model::{Body, Scene};

/// Memory of one particle at set-up, bytes: measured 5.8 kB at 3·10⁴ to 8·10⁴ particles with 30 neighbours.
const BYTES: f64 = 5.8e3;

/// What a box of particles is filled with at least: a ring or a plate with holes.
const FILLED: f64 = 0.5;

impl Scene {
    /// Particles of the modelled part, from above: those of the box around each body.
    ///
    /// ```text
    /// N <= Σ_bodies Π_I (L_I/dx + 1),   L_I halved by a plane of symmetry
    /// ```
    pub fn most_particles(&self) -> f64 {
        let halved = self.symmetry.each_ref().map(Option::is_some);
        self.bodies.iter().map(|body| body.most_particles(halved)).sum()
    }

    /// Memory the scene needs to be set up, bytes, not less than this.
    pub fn least_memory(&self) -> f64 {
        FILLED * BYTES * self.most_particles()
    }
}

impl Body {
    /// Particles of the box around the body, its edges halved where a plane of symmetry cuts them.
    pub fn most_particles(&self, halved: [bool; 3]) -> f64 {
        let (low, high) = self.shape.bounds();
        let along = |axis: usize| {
            let part = if halved[axis] { 0.5 } else { 1.0 };
            part * (high - low)[axis] / self.spacing + 1.0
        };
        along(0) * along(1) * along(2)
    }
}
