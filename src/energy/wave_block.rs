//! The fastest wave of each particle of a block, lane by lane.
//!
//! Owns the fast search: candidates for the direction of
//! travel, and a few turns of the climb of [`super::wave`] from the best of them, every eigenvector
//! by repeated squaring. No branch depends on a particle, so neighbours do not matter.

use super::kinematics::Block;
use super::lanes::{Tensor, Vector, ZERO};
use super::law::{Directions, Law, Maps, Scratch};
use super::program::{LANES, Row};
use super::tangent_block::{Symmetric, Tangents, add, ordered, place};
use super::wide::widest;

/// Turns of the climb.
const TURNS: usize = 6;

/// Squarings of a tensor: its 2⁶-th power leaves its largest eigenvector.
///
/// A Rayleigh quotient of it misses the eigenvalue by at most 1/(2e 2⁶), 0.3 %, whatever the gap.
const SQUARINGS: usize = 6;

/// What is added to the speeds for the climb's early end and the squarings' share.
///
/// Over the states of the claim the search stays below the true speed by 1.1 % at most.
const MARGIN: f64 = 1.02;

impl Law {
    /// Fastest wave of each particle, m/s, Macaulay brackets at their kink taken as loaded.
    ///
    /// An estimate from above: candidates for the direction of travel (axes, directions of the law,
    /// largest stretch of lines and of areas), six turns of the climb of [`Law::wave_speeds`] from
    /// the best of them, and 2 % on top. It is above the largest speed over all directions in every
    /// state of the claim that holds it, by 2 % as a rule; at strains of 30 % of aligned artery fibres,
    /// far beyond their strength, 0.8 % below was seen.
    ///
    /// Not a number where the tangent is not finite, nor where no wave travels.
    ///
    /// # Panics
    /// As [`Law::stress`].
    pub fn wave_speed_block(
        &self,
        maps: Maps,
        directions: Directions,
        density: f64,
        out: &mut [f64],
        scratch: &mut Scratch,
    ) {
        self.check(&maps, &directions, out.len());
        let program = &self.hessians[1];
        self.prepare(program, scratch);
        widest!(self.fastest_of_blocks(maps, directions, density, out, scratch));
    }

    #[inline(always)]
    fn fastest_of_blocks(
        &self,
        maps: Maps,
        directions: Directions,
        density: f64,
        out: &mut [f64],
        scratch: &mut Scratch,
    ) {
        let program = &self.hessians[1];
        let by_lanes = self.has_tangents_by_lanes();
        for (start, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
            scratch.block.load(&maps, &directions, start, self.reads);
            if by_lanes {
                self.run(program, scratch);
                self.tangents(scratch);
            } else {
                self.tangents_one_by_one(scratch);
            }
            let speeds = fastest(&scratch.tangents, &scratch.block, self.directions());
            for (out, square) in out.iter_mut().zip(speeds) {
                *out = if square > 0.0 { MARGIN * (square / density).sqrt() } else { f64::NAN };
            }
        }
    }
}

/// `x · S x`
#[inline(always)]
fn quadratic(s: &Symmetric, x: &Vector) -> Row {
    let y = product(s, x);
    let mut value = ZERO;
    for i in 0..3 {
        add(&mut value, &x[i], &y[i]);
    }
    value
}

#[inline(always)]
fn product(s: &Symmetric, x: &Vector) -> Vector {
    let mut y = [ZERO; 3];
    for (i, y) in y.iter_mut().enumerate() {
        for (j, x) in x.iter().enumerate() {
            add(y, &s[ordered(i, j)], x);
        }
    }
    y
}

/// Unit eigenvector of the eigenvalue of largest size: the largest column of a high power.
#[inline(always)]
fn top_vector(s: &Symmetric) -> Vector {
    let mut power = *s;
    for _ in 0..SQUARINGS {
        let mut scale = ZERO;
        for lane in 0..LANES {
            let trace = power[0][lane].abs() + power[2][lane].abs() + power[5][lane].abs();
            scale[lane] = 1.0 / trace;
        }
        for entry in &mut power {
            for lane in 0..LANES {
                entry[lane] *= scale[lane];
            }
        }
        let old = power;
        for j in 0..3 {
            for i in 0..=j {
                let mut entry = ZERO;
                for k in 0..3 {
                    add(&mut entry, &old[ordered(i, k)], &old[ordered(k, j)]);
                }
                power[place(i, j)] = entry;
            }
        }
    }
    // the diagonal holds the squares of the vector's components: take the largest one's column
    let mut vector = [ZERO; 3];
    for lane in 0..LANES {
        let diagonal = [power[0][lane], power[2][lane], power[5][lane]];
        let first = diagonal[0] >= diagonal[1] && diagonal[0] >= diagonal[2];
        let second = diagonal[1] >= diagonal[2];
        let pick = |x: usize, y: usize, z: usize| {
            if first {
                power[x][lane]
            } else if second {
                power[y][lane]
            } else {
                power[z][lane]
            }
        };
        let v = [pick(0, 1, 3), pick(1, 2, 4), pick(3, 4, 5)];
        let norm = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        for (row, v) in vector.iter_mut().zip(v) {
            row[lane] = v / norm;
        }
    }
    vector
}

/// Gram tensor `XᵀX`.
#[inline(always)]
fn gram(x: &Tensor) -> Symmetric {
    let mut result = [ZERO; 6];
    for j in 0..3 {
        for i in 0..=j {
            for k in 0..3 {
                add(&mut result[place(i, j)], &x[k + 3 * i], &x[k + 3 * j]);
            }
        }
    }
    result
}

/// `max (n⊗N) : A : (n⊗N)` as far as the search finds it.
#[inline(always)]
fn fastest(tangents: &Tangents, block: &Block, directions: usize) -> Row {
    let mut best = [f64::NEG_INFINITY; LANES];
    let mut travel = [ZERO; 3];
    let mut consider = |candidate: &Vector| {
        let q = tangents.contracted(candidate, false);
        let value = quadratic(&q, &top_vector(&q));
        for lane in 0..LANES {
            // a NaN is kept: no comparison with it holds
            let worse = value[lane] <= best[lane];
            best[lane] = if worse { best[lane] } else { value[lane] };
            for (travel, candidate) in travel.iter_mut().zip(candidate) {
                travel[lane] = if worse { travel[lane] } else { candidate[lane] };
            }
        }
    };
    for axis in 0..3 {
        let mut candidate = [ZERO; 3];
        candidate[axis] = [1.0; LANES];
        consider(&candidate);
    }
    consider(&top_vector(&gram(&block.f)));
    consider(&top_vector(&gram(&block.h)));
    for index in 0..directions {
        consider(block.rows_of(index as u8));
    }
    for _ in 0..TURNS {
        let n = top_vector(&tangents.contracted(&travel, false));
        let r = tangents.contracted(&n, true);
        travel = top_vector(&r);
        let value = quadratic(&r, &travel);
        for lane in 0..LANES {
            best[lane] = if value[lane] <= best[lane] { best[lane] } else { value[lane] };
        }
    }
    best
}
