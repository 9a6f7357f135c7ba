//! Raw invariants of a block of particles, and the stress their derivatives make.
//!
//! Owns the geometry: which raw invariant is which contraction of the maps, and its gradient. The
//! law itself is a program between the two halves.

#![expect(clippy::needless_range_loop, reason = "one lane index runs through many rows")]

use super::lanes::{Tensor, Vector, ZERO, dot, dyad, norm_squared, scaled, times, transposed_times};
use super::law::{Directions, Maps};
use super::program::{LANES, Row};
use super::raw::Raw;
use super::stretch;
use crate::tensor::Mat3;

/// What of the maps a law reads.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reads {
    pub(super) area_map: bool,
    pub(super) volume_map: bool,
    pub(super) fifth: bool,
    pub(super) stretch: bool,
    pub(super) directions: usize,
}

/// A block of particles: maps, directions and what follows from them.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub(super) f: Tensor,
    pub(super) h: Tensor,
    pub(super) j: Row,
    /// `a`
    pub(super) directions: Vec<Vector>,
    /// `F a`
    pub(super) images: Vec<Vector>,
    /// `C a`
    pulled: Vec<Vector>,
    /// Whether all lanes hold the same particle.
    pub(super) is_alone: bool,
    /// Principal stretches, descending.
    stretches: Vector,
    /// Their directions `N_i`, one to a column.
    principal: Tensor,
}

impl Default for Block {
    fn default() -> Self {
        Self {
            f: [ZERO; 9],
            h: [ZERO; 9],
            j: ZERO,
            directions: Vec::new(),
            images: Vec::new(),
            pulled: Vec::new(),
            is_alone: false,
            stretches: [ZERO; 3],
            principal: [ZERO; 9],
        }
    }
}

impl Block {
    /// Makes room for a law; allocates only where a former law needed less.
    pub(super) fn reserve(&mut self, reads: Reads) {
        for list in [&mut self.directions, &mut self.images, &mut self.pulled] {
            if list.len() < reads.directions {
                list.resize(reads.directions, [ZERO; 3]);
            }
        }
    }

    /// Loads the block from `start`; lanes beyond the end repeat the last particle.
    #[inline(always)]
    pub(super) fn load(&mut self, maps: &Maps, directions: &Directions, start: usize, reads: Reads) {
        let last = maps.f.len() - 1;
        self.is_alone = start == last;
        for lane in 0..LANES {
            let particle = (start + lane).min(last);
            for (row, &value) in self.f.iter_mut().zip(maps.f[particle].as_slice()) {
                row[lane] = value;
            }
            if let Some(h) = maps.h {
                for (row, &value) in self.h.iter_mut().zip(h[particle].as_slice()) {
                    row[lane] = value;
                }
            }
            if let Some(j) = maps.j {
                self.j[lane] = j[particle];
            }
        }
        // uniform directions stay from block to block
        if start == 0 || matches!(directions, Directions::PerParticle { .. }) {
            self.load_directions(directions, start, last, reads);
        }
        if maps.h.is_none() && (reads.area_map || reads.volume_map) {
            self.derive_area_map();
        }
        if maps.j.is_none() && reads.volume_map {
            self.derive_volume_map(maps.h.is_some());
        }
        for index in 0..reads.directions {
            self.images[index] = times(&self.f, &self.directions[index]);
            if reads.fifth {
                self.pulled[index] = transposed_times(&self.f, &self.images[index]);
            }
        }
        if reads.stretch {
            self.spectrum();
        }
    }

    #[inline(always)]
    fn load_directions(&mut self, directions: &Directions, start: usize, last: usize, reads: Reads) {
        for (index, rows) in self.directions[..reads.directions].iter_mut().enumerate() {
            for lane in 0..LANES {
                let a = directions.of((start + lane).min(last), index);
                for (row, &value) in rows.iter_mut().zip(a.as_slice()) {
                    row[lane] = value;
                }
            }
        }
    }

    #[inline(always)]
    fn derive_area_map(&mut self) {
        let f = &self.f;
        for column in 0..3 {
            let (c1, c2) = ((column + 1) % 3, (column + 2) % 3);
            for row in 0..3 {
                let (r1, r2) = ((row + 1) % 3, (row + 2) % 3);
                for lane in 0..LANES {
                    self.h[row + 3 * column][lane] = f[r1 + 3 * c1][lane] * f[r2 + 3 * c2][lane]
                        - f[r1 + 3 * c2][lane] * f[r2 + 3 * c1][lane];
                }
            }
        }
    }

    #[inline(always)]
    fn derive_volume_map(&mut self, area_map_is_evolved: bool) {
        let f = &self.f;
        if area_map_is_evolved {
            // det F, not the evolved H's share of it
            for lane in 0..LANES {
                let minor = |a: usize, b: usize| {
                    f[1 + 3 * a][lane] * f[2 + 3 * b][lane] - f[1 + 3 * b][lane] * f[2 + 3 * a][lane]
                };
                self.j[lane] = f[0][lane] * minor(1, 2) + f[3][lane] * minor(2, 0) + f[6][lane] * minor(0, 1);
            }
        } else {
            for lane in 0..LANES {
                self.j[lane] = f[0][lane] * self.h[0][lane]
                    + f[3][lane] * self.h[3][lane]
                    + f[6][lane] * self.h[6][lane];
            }
        }
    }

    fn spectrum(&mut self) {
        let lanes = if self.is_alone { 1 } else { LANES };
        for lane in 0..lanes {
            let f = Mat3::from_fn(|i, j| self.f[i + 3 * j][lane]);
            let (stretches, principal) = stretch::principal(&f);
            for i in 0..3 {
                self.stretches[i][lane] = stretches[i];
            }
            for (row, &value) in self.principal.iter_mut().zip(principal.as_slice()) {
                row[lane] = value;
            }
        }
        if self.is_alone {
            for row in self.stretches.iter_mut().chain(&mut self.principal) {
                *row = [row[0]; LANES];
            }
        }
    }

    /// Value of a raw invariant.
    #[inline(always)]
    pub(super) fn raw(&self, raw: Raw, to: &mut Row) {
        match raw {
            Raw::I1 => norm_squared(&self.f, to),
            Raw::I2 => norm_squared(&self.h, to),
            Raw::J => *to = self.j,
            Raw::Stretch(i) => *to = self.stretches[usize::from(i)],
            Raw::Fourth(a) => dot(&self.images[usize::from(a)], &self.images[usize::from(a)], to),
            Raw::Fifth(a) => dot(&self.pulled[usize::from(a)], &self.pulled[usize::from(a)], to),
            Raw::Eighth(a, b) => dot(&self.images[usize::from(a)], &self.images[usize::from(b)], to),
            Raw::Dot(a, b) => dot(&self.directions[usize::from(a)], &self.directions[usize::from(b)], to),
            Raw::Metric(i, j) => dot(self.column(i), self.column(j), to),
            Raw::Component(a, i) => *to = self.directions[usize::from(a)][usize::from(i)],
        }
    }

    /// `F e_i`
    #[inline(always)]
    pub(super) fn column(&self, i: u8) -> &Vector {
        let start = 3 * usize::from(i);
        self.f[start..start + 3].as_array().expect("a column has three components")
    }

    /// Adds one invariant's share, of derivative `d`, to the stresses conjugate to `F`, `H` and `J`.
    #[inline(always)]
    pub(super) fn add_share(&self, raw: Raw, d: &Row, sigma: &mut Conjugate) {
        let twice = d.map(|d| 2.0 * d);
        match raw {
            Raw::I1 => scaled(&self.f, &twice, &mut sigma.f),
            Raw::I2 => scaled(&self.h, &twice, &mut sigma.h),
            Raw::J => {
                for lane in 0..LANES {
                    sigma.j[lane] += d[lane];
                }
            }
            Raw::Stretch(i) => {
                let i = usize::from(i);
                let n: Vector = std::array::from_fn(|k| self.principal[k + 3 * i]);
                let over = std::array::from_fn(|lane| d[lane] / self.stretches[i][lane]);
                dyad(&times(&self.f, &n), &n, &over, &mut sigma.f);
            }
            Raw::Fourth(a) => {
                let a = usize::from(a);
                dyad(&self.images[a], &self.directions[a], &twice, &mut sigma.f);
            }
            Raw::Fifth(a) => {
                let a = usize::from(a);
                dyad(&self.images[a], &self.pulled[a], &twice, &mut sigma.f);
                dyad(&times(&self.f, &self.pulled[a]), &self.directions[a], &twice, &mut sigma.f);
            }
            Raw::Eighth(a, b) => {
                let (a, b) = (usize::from(a), usize::from(b));
                dyad(&self.images[a], &self.directions[b], d, &mut sigma.f);
                dyad(&self.images[b], &self.directions[a], d, &mut sigma.f);
            }
            Raw::Metric(i, j) => {
                for (line, image) in [(i, j), (j, i)] {
                    let start = 3 * usize::from(line);
                    for row in 0..3 {
                        for lane in 0..LANES {
                            sigma.f[start + row][lane] += d[lane] * self.column(image)[row][lane];
                        }
                    }
                }
            }
            Raw::Dot(..) | Raw::Component(..) => {}
        }
    }

    /// `P = Σ_F + Σ_H ⨯ F + Σ_J H`, into `sigma.f`.
    #[inline(always)]
    pub(super) fn first_piola(&self, reads: Reads, sigma: &mut Conjugate) {
        if reads.area_map {
            for column in 0..3 {
                let (c1, c2) = ((column + 1) % 3, (column + 2) % 3);
                for row in 0..3 {
                    let (r1, r2) = ((row + 1) % 3, (row + 2) % 3);
                    let (a, b) = (&sigma.h, &self.f);
                    for lane in 0..LANES {
                        let at = |x: &Tensor, i: usize, j: usize| x[i + 3 * j][lane];
                        sigma.f[row + 3 * column][lane] += (at(a, r1, c1) * at(b, r2, c2)
                            - at(a, r1, c2) * at(b, r2, c1))
                            + (at(b, r1, c1) * at(a, r2, c2) - at(b, r1, c2) * at(a, r2, c1));
                    }
                }
            }
        }
        if reads.volume_map {
            let j = sigma.j;
            scaled(&self.h, &j, &mut sigma.f);
        }
    }
}

/// Stresses conjugate to the maps, lane by lane.
#[derive(Debug, Clone)]
pub(super) struct Conjugate {
    pub(super) f: Tensor,
    pub(super) h: Tensor,
    pub(super) j: Row,
}

impl Default for Conjugate {
    fn default() -> Self {
        Self { f: [ZERO; 9], h: [ZERO; 9], j: ZERO }
    }
}

impl Conjugate {
    #[inline(always)]
    pub(super) fn clear(&mut self, reads: Reads) {
        self.f = [ZERO; 9];
        self.j = ZERO;
        if reads.area_map {
            self.h = [ZERO; 9];
        }
    }

    pub(super) fn tensor(tensor: &Tensor, lane: usize) -> Mat3 {
        Mat3::from_fn(|i, j| tensor[i + 3 * j][lane])
    }
}
