//! The largest eigenvalue of an operator on fields of vectors.
//!
//! Owns the power iteration and its start; works on arrays of its own, so no body is disturbed. Knows no
//! discretisation.

use super::quad::Quad;

/// Power iterations; the largest rates of a lattice lie close together, and any of them will do.
const ITERATIONS: usize = 40;

/// What they may fall short by.
const MARGIN: f64 = 1.05;

/// Magnitude of the largest eigenvalue, with a margin for what 40 iterations from a field without symmetry miss.
///
/// | argument | meaning |
/// |---|---|
/// | `count` | vectors of a field |
/// | `apply` | writes the operator's image of its first argument to its second |
///
/// Returns the eigenvalue's unit; zero for an operator that is zero on the start.
pub fn largest(count: usize, mut apply: impl FnMut(&[Quad], &mut [Quad])) -> f64 {
    let start = |a: usize| {
        let seed = (a as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let number =
            |shift: u32| f64::from((seed.rotate_left(shift) >> 40) as u32) / f64::from(1_u32 << 24) - 0.5;
        Quad([number(0), number(17), number(31), 0.0])
    };
    let mut field: Vec<Quad> = (0..count).map(start).collect();
    let mut image = vec![Quad::ZERO; count];
    let mut value = 0.0;
    for _ in 0..ITERATIONS {
        let scale = 1.0 / norm(&field);
        field.iter_mut().for_each(|u| *u = *u * scale);
        apply(&field, &mut image);
        value = norm(&image);
        if value == 0.0 {
            break;
        }
        field.copy_from_slice(&image);
    }
    MARGIN * value
}

fn norm(field: &[Quad]) -> f64 {
    libm::sqrt(field.iter().map(|u| u.dot(*u)).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_entry_of_a_diagonal_operator_is_found_with_the_margin() {
        let entry = |a: usize| 1.0 + (a % 7) as f64 * 0.1;
        let found = largest(100, |field, out| {
            for (a, (u, out)) in field.iter().zip(out).enumerate() {
                *out = *u * -entry(a);
            }
        });
        // 40 iterations leave (1.5/1.6)^80 < 6e-3 of the next entry's square
        assert!((found / MARGIN - 1.6).abs() < 6e-3 * 1.6, "{found}");
        assert_eq!(largest(3, |_, out| out.fill(Quad::ZERO)), 0.0);
    }
}
