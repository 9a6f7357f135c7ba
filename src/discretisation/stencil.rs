//! Neighbour lists and corrected gradients.
//!
//! Owns the compressed rows the solver loops over and how they are put together. Knows no field but
//! positions and volumes.

use super::centroid;
use super::correction;
use super::error::DiscretisationError;
use super::integration;
use super::kernel::Kernel;
use super::neighbour::Neighbours;
use super::particles::Particles;
use super::quadratic;
use crate::tensor::Vec3;
use rayon::prelude::*;

/// What the corrected gradients are made to satisfy beyond linear exactness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Consistency {
    /// Nothing: the Bonet–Kulasegaram correction alone, as the paper has it.
    Kernel,
    /// `Σ_b V_b G_a(X_b) = A_a N_a` as well, the integration constraint.
    Integration,
    /// The integration constraint, on rows that see second-degree fields half-way to the centroid of the node's hat:
    /// `Σ_b V_a G_b(X_a) q(X_b − X_a) = V_a Grad q(½c_a)` before it.
    Centroid,
    /// The integration constraint and exactness for quadratic fields.
    Quadratic,
}

/// Neighbours and corrected gradients of every particle, in compressed rows.
///
/// Row `a` holds its neighbours `b` in ascending order, `a` itself included. With
/// `G_b(X_a) = V_b ∇̃W̃_b(X_a)` the gradient of a field is `Σ_b f_b ⊗ G_b(X_a)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Stencils {
    /// Row `a` is `start[a] .. start[a + 1]`.
    pub start: Vec<u32>,
    /// Neighbour `b` of each entry.
    pub neighbour: Vec<u32>,
    /// `V_a G_b(X_a)` of each entry, m².
    pub forward: Vec<Vec3>,
    /// `V_b G_a(X_b)` of each entry, the entry `(b, a)` of `forward`, m².
    pub backward: Vec<Vec3>,
    /// `N_ab · (V_a G_b(X_a) − V_b G_a(X_b))` of each entry, the area across which a pair exchanges momentum, m²;
    /// the same for `(b, a)`, bit by bit, and zero for `b = a`. Of gradients exact for quadratic fields some,
    /// mostly of distant pairs, would be below zero, and upwinding would feed what it should damp: with those
    /// it is the area of the gradients before.
    pub interface: Vec<f64>,
}

/// One row of [`Stencils`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<'a> {
    /// Neighbours `b`, ascending, the particle itself included.
    pub neighbours: &'a [u32],
    /// `V_a G_b(X_a)`, m².
    pub forward: &'a [Vec3],
    /// `V_b G_a(X_b)`, m².
    pub backward: &'a [Vec3],
}

impl Stencils {
    /// Finds the neighbours of every particle and corrects their gradients.
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `particles` | the body | – |
    /// | `kernel` | the kernel | – |
    /// | `smoothing` | `h/dx`, smoothing length over [`Particles::spacing`] | – |
    /// | `consistency` | whether the integration constraint is imposed | – |
    ///
    /// The result does not depend on the number of threads: every row is summed in its own order.
    ///
    /// # Errors
    /// [`DiscretisationError::BadSmoothing`]; [`DiscretisationError::TooManyParticles`] if the entries
    /// outgrow their index; [`DiscretisationError::SingularMoments`] if the neighbours of a particle do not
    /// span space; [`DiscretisationError::ConstraintNotMet`] if the integration constraint cannot be met.
    pub fn build(
        particles: &Particles,
        kernel: Kernel,
        smoothing: f64,
        consistency: Consistency,
    ) -> Result<Self, DiscretisationError> {
        let h = smoothing * particles.spacing;
        if !(smoothing > 0.0 && smoothing < 10.0) {
            return Err(DiscretisationError::BadSmoothing { smoothing });
        }
        if particles.position.is_empty() {
            return Err(DiscretisationError::Empty { spacing: particles.spacing });
        }
        if consistency != Consistency::Kernel && particles.cells.is_empty() {
            return Err(DiscretisationError::NoAreas);
        }
        let (position, volume) = (&particles.position, &particles.volume);
        let list = Neighbours::search(position, kernel.support() * h)?;
        let rows: Vec<Option<Vec<Vec3>>> = (0..position.len())
            .into_par_iter()
            .map(|a| correction::row(kernel, h, a, &list.neighbour[list.range(a)], position, volume))
            .collect();
        let mut forward = Vec::with_capacity(list.neighbour.len());
        for (a, row) in rows.into_iter().enumerate() {
            forward.extend(row.ok_or_else(|| DiscretisationError::SingularMoments {
                particle: a,
                position: position[a],
                neighbours: list.range(a).len(),
            })?);
        }
        let reverse = list.reverse();
        let plain = interface(position, &list, &reverse, &forward);
        match consistency {
            Consistency::Kernel => {}
            Consistency::Integration => {
                integration::impose(particles, kernel, h, &list, &reverse, &mut forward)?
            }
            Consistency::Centroid => {
                centroid::impose(particles, kernel, h, &list, &mut forward)?;
                integration::impose(particles, kernel, h, &list, &reverse, &mut forward)?
            }
            Consistency::Quadratic => quadratic::impose(particles, kernel, h, &list, &reverse, &mut forward)?,
        }
        let interface = match consistency {
            Consistency::Integration | Consistency::Centroid => {
                interface(position, &list, &reverse, &forward)
            }
            Consistency::Kernel | Consistency::Quadratic => plain,
        };
        let backward = reverse.iter().map(|&entry| forward[entry as usize]).collect();
        Ok(Self { start: list.start, neighbour: list.neighbour, forward, backward, interface })
    }

    /// How many particles there are.
    pub fn len(&self) -> usize {
        self.start.len() - 1
    }

    /// Whether there are no particles.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The row of particle `a`.
    ///
    /// # Panics
    /// If there is no particle `a`.
    pub fn row(&self, a: usize) -> Row<'_> {
        let range = self.start[a] as usize..self.start[a + 1] as usize;
        Row {
            neighbours: &self.neighbour[range.clone()],
            forward: &self.forward[range.clone()],
            backward: &self.backward[range],
        }
    }
}

/// Interface area of every entry, see [`Stencils::interface`].
fn interface(position: &[Vec3], list: &Neighbours, reverse: &[u32], forward: &[Vec3]) -> Vec<f64> {
    let row = |a: usize| {
        list.range(a).map(move |entry| {
            let distance = position[list.neighbour[entry] as usize] - position[a];
            let difference = forward[entry] - forward[reverse[entry] as usize];
            if list.neighbour[entry] as usize == a {
                0.0
            } else {
                distance.dot(&difference) / distance.norm()
            }
        })
    };
    (0..position.len()).into_par_iter().flat_map_iter(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::Shape;

    fn block(jitter: f64) -> Particles {
        let shape = Shape::Box { min: Vec3::new(-0.1, 0.0, 0.2), max: Vec3::new(0.9, 0.6, 0.4) };
        Particles::lattice(&shape, 0.1, [None, Some(0.2), None], jitter).unwrap()
    }

    #[test]
    fn a_shape_without_a_particle_is_refused_whatever_the_consistency() {
        let disc = |radius| Shape::Cylinder { axis: 2, centre: Vec3::zeros(), radius, height: 1.0 };
        for hole in [1.99, 3.0] {
            let shape = Shape::Difference(Box::new(disc(2.0)), vec![disc(hole)]);
            let none = Particles::lattice(&shape, 0.5, [None, None, None], 0.0).unwrap();
            for consistency in [Consistency::Kernel, Consistency::Integration] {
                let error = Stencils::build(&none, Kernel::WendlandC2, 1.01, consistency).unwrap_err();
                assert_eq!(error, DiscretisationError::Empty { spacing: none.spacing });
            }
        }
    }

    #[test]
    fn one_layer_of_particles_is_refused_by_name() {
        let mut particles = block(0.0);
        for x in &mut particles.position {
            x.z = 0.0;
        }
        let error = Stencils::build(&particles, Kernel::WendlandC2, 1.01, Consistency::Kernel).unwrap_err();
        assert!(matches!(error, DiscretisationError::SingularMoments { particle: 0, .. }), "{error}");
    }

    #[test]
    fn a_smoothing_that_reaches_no_neighbour_is_refused() {
        for smoothing in [0.4, 0.0, f64::NAN] {
            assert!(
                Stencils::build(&block(0.0), Kernel::WendlandC2, smoothing, Consistency::Kernel).is_err()
            );
        }
    }

    #[test]
    fn areas_that_no_grid_gave_cannot_be_met_and_are_refused() {
        let mut particles = block(0.0);
        particles.faces[0].area[0] *= 2.0;
        let error =
            Stencils::build(&particles, Kernel::WendlandC2, 1.01, Consistency::Integration).unwrap_err();
        assert!(matches!(error, DiscretisationError::ConstraintNotMet { .. }), "{error}");
    }

    #[test]
    fn backward_is_forward_of_the_reversed_pair_to_the_last_bit() {
        for consistency in [Consistency::Kernel, Consistency::Integration, Consistency::Centroid] {
            let stencils = Stencils::build(&block(0.2), Kernel::CubicSpline, 1.2, consistency).unwrap();
            for a in 0..stencils.len() {
                let row = stencils.row(a);
                assert!(row.neighbours.is_sorted());
                for (&b, backward) in row.neighbours.iter().zip(row.backward) {
                    let other = stencils.row(b as usize);
                    let entry = other.neighbours.binary_search(&(a as u32)).unwrap();
                    assert_eq!(*backward, other.forward[entry]);
                }
            }
        }
    }

    #[test]
    fn the_number_of_threads_changes_no_bit() {
        for consistency in [Consistency::Integration, Consistency::Centroid] {
            let build = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| Stencils::build(&block(0.2), Kernel::WendlandC2, 1.2, consistency))
            };
            assert_eq!(build(1).unwrap(), build(3).unwrap());
        }
    }
}
