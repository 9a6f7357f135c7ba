//! Vectors padded to four numbers, the form in which the pair loops read the state.
//!
//! Owns their arithmetic, written so that a compiler makes one vector instruction of each
//! operation. The fourth number is zero and stays zero. Knows nothing else.

use crate::tensor::{Mat3, Vec3};
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A vector of three components and a zero.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C, align(32))]
pub struct Quad(pub [f64; 4]);

impl Quad {
    /// The zero vector.
    pub const ZERO: Self = Self([0.0; 4]);

    /// Pads a vector.
    #[inline(always)]
    pub fn new(v: &Vec3) -> Self {
        Self([v.x, v.y, v.z, 0.0])
    }

    /// Drops the padding.
    #[inline(always)]
    pub fn vector(self) -> Vec3 {
        Vec3::new(self.0[0], self.0[1], self.0[2])
    }

    /// `self · factor + addend`, each component rounded once.
    #[inline(always)]
    pub fn times_plus(self, factor: f64, addend: Self) -> Self {
        let (a, c) = (self.0, addend.0);
        Self([
            a[0].mul_add(factor, c[0]),
            a[1].mul_add(factor, c[1]),
            a[2].mul_add(factor, c[2]),
            a[3].mul_add(factor, c[3]),
        ])
    }

    /// Products of the components plus an addend, each rounded once.
    #[inline(always)]
    pub fn products_plus(self, other: Self, addend: Self) -> Self {
        let (a, b, c) = (self.0, other.0, addend.0);
        Self([
            a[0].mul_add(b[0], c[0]),
            a[1].mul_add(b[1], c[1]),
            a[2].mul_add(b[2], c[2]),
            a[3].mul_add(b[3], c[3]),
        ])
    }

    /// The components one place on: `(y, z, x)`.
    ///
    /// With `r` for it, `a × b = r(a r(b) − r(a) b)`, products taken component by component.
    #[inline(always)]
    pub fn rotated(self) -> Self {
        let a = self.0;
        Self([a[1], a[2], a[0], a[3]])
    }

    /// Scalar product, summed left to right.
    #[inline(always)]
    pub fn dot(self, other: Self) -> f64 {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }
}

impl Add for Quad {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]])
    }
}

impl AddAssign for Quad {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Quad {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]])
    }
}

impl Neg for Quad {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|a| -a))
    }
}

impl Mul<f64> for Quad {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        let a = self.0;
        Self([a[0] * factor, a[1] * factor, a[2] * factor, a[3] * factor])
    }
}

/// A 3 × 3 tensor as three padded columns.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C, align(32))]
pub struct Columns(pub [Quad; 3]);

impl Columns {
    /// The zero tensor.
    pub const ZERO: Self = Self([Quad::ZERO; 3]);

    /// Pads a tensor.
    #[inline(always)]
    pub fn new(m: &Mat3) -> Self {
        Self([0, 1, 2].map(|j| Quad([m[(0, j)], m[(1, j)], m[(2, j)], 0.0])))
    }

    /// Drops the padding.
    #[inline(always)]
    pub fn matrix(&self) -> Mat3 {
        let [a, b, c] = self.0;
        Mat3::new(a.0[0], b.0[0], c.0[0], a.0[1], b.0[1], c.0[1], a.0[2], b.0[2], c.0[2])
    }

    /// `M v` for a referential vector `v`.
    #[inline(always)]
    pub fn apply(&self, v: &[f64; 3]) -> Quad {
        self.0[0] * v[0] + self.0[1] * v[1] + self.0[2] * v[2]
    }

    /// `addend − M v`, each product rounded once with what it is taken from.
    #[inline(always)]
    pub fn taken_from(&self, addend: Quad, v: &[f64; 3]) -> Quad {
        let last = self.0[2].times_plus(-v[2], addend);
        self.0[0].times_plus(-v[0], self.0[1].times_plus(-v[1], last))
    }

    /// `self += u ⊗ v`, each product rounded once with what it is added to.
    #[inline(always)]
    pub fn gather_outer(&mut self, u: Quad, v: &[f64; 3]) {
        self.0[0] = u.times_plus(v[0], self.0[0]);
        self.0[1] = u.times_plus(v[1], self.0[1]);
        self.0[2] = u.times_plus(v[2], self.0[2]);
    }

    /// `self += u ⊗ v`.
    #[inline(always)]
    pub fn add_outer(&mut self, u: Quad, v: &[f64; 3]) {
        self.0[0] += u * v[0];
        self.0[1] += u * v[1];
        self.0[2] += u * v[2];
    }

    /// `factor * self`.
    #[inline(always)]
    pub fn scaled(&self, factor: f64) -> Self {
        Self([self.0[0] * factor, self.0[1] * factor, self.0[2] * factor])
    }

    /// `self + other`.
    #[inline(always)]
    pub fn plus(&self, other: &Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1], self.0[2] + other.0[2]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotated_components_make_the_vector_product() {
        let (u, v) = (Vec3::new(1.0, -2.0, 4.0), Vec3::new(0.5, 3.0, -8.0));
        let (a, b) = (Quad::new(&u), Quad::new(&v));
        let rotated = a.rotated().products_plus(-b, a.products_plus(b.rotated(), Quad::ZERO));
        assert_eq!(rotated.rotated().vector(), u.cross(&v));
    }

    #[test]
    fn columns_act_as_the_matrix_they_pad() {
        let m = Mat3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0);
        let v = Vec3::new(0.5, -2.0, 4.0);
        assert_eq!(Columns::new(&m).matrix(), m);
        // small integers and halves: every product and sum is exact
        assert_eq!(Columns::new(&m).apply(&[v.x, v.y, v.z]).vector(), m * v);
        let mut outer = Columns::ZERO;
        outer.add_outer(Quad::new(&v), &[1.0, 2.0, 4.0]);
        assert_eq!(outer.matrix(), v * Vec3::new(1.0, 2.0, 4.0).transpose());
        assert_eq!(Quad::new(&v).dot(Quad::new(&v)), v.norm_squared());
        assert_eq!(Columns::new(&m).taken_from(Quad::new(&v), &[v.x, v.y, v.z]).vector(), v - m * v);
        let mut gathered = Columns::new(&m);
        gathered.gather_outer(Quad::new(&v), &[1.0, 2.0, 4.0]);
        assert_eq!(gathered.matrix(), m + v * Vec3::new(1.0, 2.0, 4.0).transpose());
    }
}
