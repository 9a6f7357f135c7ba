//! What is prescribed of a material point: each component of F, or the stress that belongs to it.
//!
//! Owns the controls and the common tests. Solves nothing.

use super::error::DriveError;
use crate::tensor::{Mat3, Vec3};

/// What is prescribed at one place of the 3 × 3 components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Control {
    /// The component of the deformation gradient.
    Deformation(f64),
    /// The component of the first Piola–Kirchhoff stress, Pa; that of F follows.
    FirstPiola(f64),
    /// The component of the Cauchy stress, Pa; that of F follows.
    Cauchy(f64),
}

/// What is prescribed at all nine places, row by row: `[i][I]`, the spatial index first.
///
/// Every free component of F has the stress component of its own place as condition, so there are as
/// many equations as unknowns. A Cauchy stress on both sides of the diagonal leaves the rotation free
/// and has no unique answer; the common tests below hold F upper triangular instead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// Controls by row and column.
    pub components: [[Control; 3]; 3],
}

impl Target {
    /// All of F prescribed.
    pub fn deformation(f: &Mat3) -> Self {
        let at = |i: usize, j: usize| Control::Deformation(f[(i, j)]);
        Self { components: std::array::from_fn(|i| std::array::from_fn(|j| at(i, j))) }
    }

    /// Tension along axis 1, all other tractions zero.
    ///
    /// ```text
    /// F11 = λ,  F21 = F31 = F32 = 0,  σ22 = σ33 = σ12 = σ13 = σ23 = 0
    /// ```
    ///
    /// Material lines along axis 1 stay there; the shears of an oblique law are free.
    pub fn uniaxial(stretch: f64) -> Self {
        Self::deformation(&Mat3::from_diagonal(&Vec3::new(stretch, 1.0, 1.0))).free([
            (1, 1),
            (2, 2),
            (0, 1),
            (0, 2),
            (1, 2),
        ])
    }

    /// A sheet in the plane of axes 1 and 2, stretched along both, its faces free.
    ///
    /// ```text
    /// F11 = λ1,  F22 = λ2,  F12 = F21 = F31 = F32 = 0,  σ33 = σ13 = σ23 = 0
    /// ```
    pub fn biaxial(first: f64, second: f64) -> Self {
        Self::deformation(&Mat3::from_diagonal(&Vec3::new(first, second, 1.0))).free([(2, 2), (0, 2), (1, 2)])
    }

    /// The same stretch along axes 1 and 2: [`Target::biaxial`].
    pub fn equibiaxial(stretch: f64) -> Self {
        Self::biaxial(stretch, stretch)
    }

    /// A wide strip stretched along axis 1 that keeps its width along axis 2: [`Target::biaxial`].
    pub fn planar(stretch: f64) -> Self {
        Self::biaxial(stretch, 1.0)
    }

    /// Shear along axis 1 of planes normal to axis 2, nothing else.
    ///
    /// ```text
    /// F = I + γ e1 ⊗ e2
    /// ```
    ///
    /// A pressure is not determined by F; an incompressible law needs [`Target::simple_shear_free`].
    pub fn simple_shear(amount: f64) -> Self {
        let mut f = Mat3::identity();
        f[(0, 1)] = amount;
        Self::deformation(&f)
    }

    /// [`Target::simple_shear`] with the faces normal to axis 3 free of normal traction.
    ///
    /// ```text
    /// F11 = F22 = 1,  F12 = γ,  σ33 = 0
    /// ```
    pub fn simple_shear_free(amount: f64) -> Self {
        Self::simple_shear(amount).free([(2, 2)])
    }

    /// This target with the places of `free` under zero Cauchy stress.
    fn free<const N: usize>(mut self, free: [(usize, usize); N]) -> Self {
        for (i, j) in free {
            self.components[i][j] = Control::Cauchy(0.0);
        }
        self
    }

    /// Between rest (F = I, no stress) at 0 and this target at 1, in proportion.
    pub(super) fn scaled(&self, part: f64) -> Self {
        let mut scaled = *self;
        for (i, row) in scaled.components.iter_mut().enumerate() {
            for (j, control) in row.iter_mut().enumerate() {
                let rest = f64::from(u8::from(i == j));
                *control = match *control {
                    Control::Deformation(f) => Control::Deformation(rest + part * (f - rest)),
                    Control::FirstPiola(p) => Control::FirstPiola(part * p),
                    Control::Cauchy(sigma) => Control::Cauchy(part * sigma),
                };
            }
        }
        scaled
    }

    /// Places whose F is free, column by column.
    pub(super) fn unknowns(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..9)
            .map(|place| (place % 3, place / 3))
            .filter(|&(i, j)| !matches!(self.components[i][j], Control::Deformation(_)))
    }

    /// `f` with the prescribed components put in.
    pub(super) fn imposed(&self, f: &Mat3) -> Mat3 {
        Mat3::from_fn(|i, j| match self.components[i][j] {
            Control::Deformation(value) => value,
            Control::FirstPiola(_) | Control::Cauchy(_) => f[(i, j)],
        })
    }

    /// Whether every prescribed value is finite.
    pub(super) fn is_finite(&self) -> bool {
        self.components.iter().flatten().all(|control| match control {
            Control::Deformation(value) | Control::FirstPiola(value) | Control::Cauchy(value) => {
                value.is_finite()
            }
        })
    }
}

/// Axes for the components of a [`Target`]: the first along `first`, the second along `second`.
///
/// Returns the rotation with the axes as columns, the third completing a right-handed set.
///
/// # Errors
/// [`DriveError::Frame`] where the two are not unit vectors at a right angle, to 1e-9.
pub fn frame(first: &Vec3, second: &Vec3) -> Result<Mat3, DriveError> {
    let defect = (first.norm() - 1.0).abs().max((second.norm() - 1.0).abs()).max(first.dot(second).abs());
    // A frame of numbers that are none has a defect that is none.
    if defect <= 1e-9 {
        // Exactly orthonormal, so that a rotation of the frame adds no strain.
        let e1 = first.normalize();
        let e3 = e1.cross(second).normalize();
        Ok(Mat3::from_columns(&[e1, e3.cross(&e1), e3]))
    } else {
        Err(DriveError::Frame { first: *first, second: *second })
    }
}
