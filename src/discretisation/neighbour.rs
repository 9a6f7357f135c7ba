//! Neighbour lists by a cell list.
//!
//! Owns the search. Knows positions and a radius, no kernel.

use super::error::DiscretisationError;
use crate::tensor::Vec3;
use rayon::prelude::*;

/// Compressed rows: neighbours of `a`, itself included, ascending, are
/// `neighbour[start[a] .. start[a + 1]]`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Neighbours {
    /// Where each row starts, and the end of the last.
    pub start: Vec<u32>,
    /// The rows.
    pub neighbour: Vec<u32>,
}

impl Neighbours {
    /// All particles closer than `radius`; `b` is in the row of `a` exactly if `a` is in that of `b`,
    /// because `|X_b − X_a|²` does not depend on the order to the last bit.
    ///
    /// # Errors
    /// [`DiscretisationError::TooManyParticles`] if the entries outgrow their index.
    pub fn search(position: &[Vec3], radius: f64) -> Result<Self, DiscretisationError> {
        let low = position.iter().fold(Vec3::repeat(f64::INFINITY), |low, x| low.inf(x));
        let high = position.iter().fold(Vec3::repeat(f64::NEG_INFINITY), |high, x| high.sup(x));
        // bins of at least the radius, and not many more than particles for a sparse set
        let most = libm::cbrt(position.len() as f64).max(1.0) * 8.0;
        let bins = (high - low).map(|length| (length / radius).floor().clamp(1.0, most) as usize);
        let size = Vec3::from_fn(|axis, _| ((high - low)[axis] / bins[axis] as f64).max(radius));
        let bin = |x: &Vec3| -> [usize; 3] {
            std::array::from_fn(|axis| (((x[axis] - low[axis]) / size[axis]) as usize).min(bins[axis] - 1))
        };
        let index = |i: [usize; 3]| (i[0] * bins[1] + i[1]) * bins[2] + i[2];

        let mut first = vec![0u32; bins[0] * bins[1] * bins[2] + 1];
        for x in position {
            first[index(bin(x)) + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut next = first.clone();
        let mut member = vec![0u32; position.len()];
        for (a, x) in position.iter().enumerate() {
            let i = index(bin(x));
            member[next[i] as usize] = a as u32;
            next[i] += 1;
        }

        let row = |x: &Vec3| {
            let around = |axis: usize, at: usize| at.saturating_sub(1)..=(at + 1).min(bins[axis] - 1);
            let at = bin(x);
            let mut row = Vec::with_capacity(64);
            for i in around(0, at[0]) {
                for j in around(1, at[1]) {
                    for k in around(2, at[2]) {
                        let bin = index([i, j, k]);
                        let members = &member[first[bin] as usize..first[bin + 1] as usize];
                        let near = |b: &u32| (position[*b as usize] - x).norm_squared() < radius * radius;
                        row.extend(members.iter().copied().filter(near));
                    }
                }
            }
            row.sort_unstable();
            row
        };
        let rows: Vec<Vec<u32>> = position.par_iter().map(row).collect();

        let entries: usize = rows.iter().map(Vec::len).sum();
        if entries > u32::MAX as usize {
            // the share of the index each particle's row takes
            let limit = (u32::MAX as usize / (entries / rows.len())) as u32;
            return Err(DiscretisationError::TooManyParticles { count: rows.len() as f64, limit });
        }
        let mut start = Vec::with_capacity(rows.len() + 1);
        let mut end = 0;
        start.push(end);
        for row in &rows {
            end += row.len() as u32;
            start.push(end);
        }
        Ok(Self { start, neighbour: rows.concat() })
    }

    /// Entries of the row of `a`.
    pub fn range(&self, a: usize) -> std::ops::Range<usize> {
        self.start[a] as usize..self.start[a + 1] as usize
    }

    /// Index of the entry `(b, a)` for every entry `(a, b)`.
    pub fn reverse(&self) -> Vec<u32> {
        let row = |a: usize| {
            self.range(a).map(move |entry| {
                let row = self.range(self.neighbour[entry] as usize);
                let offset = self.neighbour[row.clone()].binary_search(&(a as u32));
                (row.start + offset.expect("neighbour lists are symmetric")) as u32
            })
        };
        (0..self.start.len() - 1).into_par_iter().flat_map_iter(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<Vec3>> {
        let point =
            prop::array::uniform3(-1.0..1.0).prop_map(|x: [f64; 3]| Vec3::new(x[0], 3.0 * x[1], x[2] / 9.0));
        prop::collection::vec(point, 1..80)
    }

    proptest! {
        #[test]
        fn every_pair_closer_than_the_radius_is_found_once_and_no_other(x in points(), radius in 0.05..2.0) {
            let found = Neighbours::search(&x, radius).unwrap();
            for a in 0..x.len() {
                let all: Vec<u32> =
                    (0..x.len()).filter(|&b| (x[a] - x[b]).norm() < radius).map(|b| b as u32).collect();
                prop_assert_eq!(&found.neighbour[found.range(a)], &all[..]);
            }
        }

        #[test]
        fn the_reverse_of_an_entry_leads_back(x in points(), radius in 0.05..2.0) {
            let found = Neighbours::search(&x, radius).unwrap();
            let reverse = found.reverse();
            for a in 0..x.len() {
                for entry in found.range(a) {
                    prop_assert_eq!(found.neighbour[reverse[entry] as usize], a as u32);
                    prop_assert_eq!(reverse[reverse[entry] as usize], entry as u32);
                }
            }
        }
    }
}
