//! Smooth functions that precondition a system of sixth order.
//!
//! Owns a coarse space and the system on it. Jacobi's preconditioner works on what changes from particle to
//! particle; what is smooth takes conjugate gradients as many iterations as the cube of the particles along an edge.
//! Cubic B-splines on cells of some spacings see exactly that: `z = D⁻¹ r + P (Pᵀ K P)⁻¹ Pᵀ r`.

use crate::tensor::Vec3;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use rayon::prelude::*;

/// Edge of a cell in spacings: wider than a row's neighbours, so that a row meets two cells an axis at most.
const CELL: f64 = 6.0;

/// Most functions; their system is dense.
const MOST: usize = 1500;

/// Share of the mean diagonal that is added to it: quadratic functions, which the system cannot see, and
/// splines without particles would leave it singular.
const SHIFT: f64 = 1e-10;

/// Rows whose local systems are formed before they are added, in order.
const CHUNK: usize = 256;

/// Splines of one particle: the first index along each axis, and the values of four.
#[derive(Debug, Clone, Copy)]
struct Splines {
    first: [usize; 3],
    value: [[f64; 4]; 3],
}

/// What row `a` makes of functions given on its neighbours: `δ_ab` of each, without the weights' own entry.
pub(super) trait Row: Sync {
    /// Neighbours of row `a`, itself included.
    fn neighbours(&self, a: usize) -> &[u32];

    /// Turns the differences `f_b − f_a` of one function into its `δ_ab`.
    fn change(&self, a: usize, difference: &[f64], change: &mut [f64]);
}

/// The coarse space.
pub(super) struct Coarse {
    count: [usize; 3],
    splines: Vec<Splines>,
    factor: Cholesky<f64, Dyn>,
}

impl Coarse {
    /// Splines over the particles and the system restricted to them; `None` where it is not positive, which
    /// costs iterations only.
    pub fn new(position: &[Vec3], spacing: f64, rows: &impl Row) -> Option<Self> {
        let (low, high) = position
            .iter()
            .fold((Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)), |(low, high), x| {
                (low.inf(x), high.sup(x))
            });
        let size = high - low;
        let mut edge = CELL * spacing;
        let mut cells = [1; 3];
        loop {
            for axis in 0..3 {
                cells[axis] = (size[axis] / edge).floor().clamp(1.0, MOST as f64) as usize;
            }
            if cells.iter().map(|cells| cells + 3).product::<usize>() <= MOST {
                break;
            }
            edge *= 1.1;
        }
        let count = cells.map(|cells| cells + 3);
        let splines: Vec<Splines> = position
            .par_iter()
            .map(|x| {
                let mut splines = Splines { first: [0; 3], value: [[0.0; 4]; 3] };
                for axis in 0..3 {
                    let t = (x[axis] - low[axis]) / size[axis] * cells[axis] as f64;
                    let cell = (t as usize).min(cells[axis] - 1);
                    let u = t - cell as f64;
                    let v = 1.0 - u;
                    splines.first[axis] = cell;
                    splines.value[axis] = [
                        v * v * v / 6.0,
                        (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                        (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
                        u * u * u / 6.0,
                    ];
                }
                splines
            })
            .collect();
        let total: usize = count.iter().product();
        let mut matrix = DMatrix::<f64>::zeros(total, total);
        for chunk in 0..position.len().div_ceil(CHUNK) {
            let members = chunk * CHUNK..((chunk + 1) * CHUNK).min(position.len());
            let local: Vec<Local> =
                members.into_par_iter().map(|a| local(a, rows, &splines, count)).collect();
            for local in local {
                let n = local.index.len();
                for (j, &column) in local.index.iter().enumerate() {
                    for (i, &row) in local.index.iter().enumerate() {
                        matrix[(row, column)] += local.entries[j * n + i];
                    }
                }
            }
        }
        let shift = SHIFT * matrix.diagonal().sum() / total as f64;
        for i in 0..total {
            matrix[(i, i)] += shift;
        }
        Some(Self { count, splines, factor: Cholesky::new(matrix)? })
    }

    /// `P (Pᵀ K P)⁻¹ Pᵀ r`, each component for itself.
    pub fn correct(&self, residual: &[Vec3]) -> Vec<Vec3> {
        let total: usize = self.count.iter().product();
        let mut sums: [DVector<f64>; 3] = std::array::from_fn(|_| DVector::zeros(total));
        for (splines, r) in self.splines.iter().zip(residual) {
            splines.each(self.count, |index, value| {
                for (i, sum) in sums.iter_mut().enumerate() {
                    sum[index] += value * r[i];
                }
            });
        }
        for sum in &mut sums {
            self.factor.solve_mut(sum);
        }
        let value = |splines: &Splines| {
            let mut out = Vec3::zeros();
            splines.each(self.count, |index, value| {
                out += value * Vec3::new(sums[0][index], sums[1][index], sums[2][index]);
            });
            out
        };
        self.splines.par_iter().map(value).collect()
    }
}

impl Splines {
    fn each(&self, count: [usize; 3], mut visit: impl FnMut(usize, f64)) {
        for i in 0..4 {
            for j in 0..4 {
                let line = ((self.first[0] + i) * count[1] + self.first[1] + j) * count[2] + self.first[2];
                let value = self.value[0][i] * self.value[1][j];
                for k in 0..4 {
                    visit(line + k, value * self.value[2][k]);
                }
            }
        }
    }
}

/// The share of one row in `Pᵀ K P`.
struct Local {
    index: Vec<usize>,
    entries: Vec<f64>,
}

/// `Σ_b δ_ab(s) (t_b − t_a)` of all pairs of functions that the neighbours of row `a` meet.
fn local(a: usize, rows: &impl Row, splines: &[Splines], count: [usize; 3]) -> Local {
    let neighbours = rows.neighbours(a);
    let mut index = Vec::new();
    for &b in neighbours {
        splines[b as usize].each(count, |i, _| index.push(i));
    }
    index.sort_unstable();
    index.dedup();
    let (n, len) = (index.len(), neighbours.len());
    // function by function, neighbour by neighbour
    let mut difference = vec![0.0; n * len];
    for (entry, &b) in neighbours.iter().enumerate() {
        splines[b as usize].each(count, |i, value| {
            let function = index.partition_point(|&other| other < i);
            difference[function * len + entry] += value;
        });
    }
    splines[a].each(count, |i, value| {
        let function = index.partition_point(|&other| other < i);
        difference[function * len..(function + 1) * len].iter_mut().for_each(|d| *d -= value);
    });
    let mut change = vec![0.0; n * len];
    for function in 0..n {
        let range = function * len..(function + 1) * len;
        rows.change(a, &difference[range.clone()], &mut change[range]);
    }
    let mut entries = vec![0.0; n * n];
    for j in 0..n {
        let change = &change[j * len..(j + 1) * len];
        for i in 0..n {
            let difference = &difference[i * len..(i + 1) * len];
            entries[j * n + i] = change.iter().zip(difference).fold(0.0, |sum, (c, d)| sum + c * d);
        }
    }
    Local { index, entries }
}
