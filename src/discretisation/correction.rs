//! The corrected kernel gradient of Bonet & Kulasegaram (2000).
//!
//! Owns constant and linear exactness of the gradient of one particle. Knows its row of neighbours only.
//!
//! ```text
//! W̃_b(X)   = W_b(X) / S(X),                 S = Σ_c V_c W_c(X)
//! ∇W̃_b     = (∇W_b − W_b ∇S/S) / S,         ∇S = Σ_c V_c ∇W_c
//! ∇̃W̃_b     = L ∇W̃_b,                        L⁻ᵀ = Σ_c X_c ⊗ V_c ∇W̃_c
//! G_b(X_a) = V_b ∇̃W̃_b(X_a)                                                  [NB25 (26)]
//! ```
//!
//! `Σ_b V_b W̃_b = 1` everywhere, so `Σ_b G_b = 0`; multiplication by `L` makes `Σ_b X_b ⊗ G_b = I`. The
//! sums include `b = a`: the gradient of the corrected kernel does not vanish at its own centre.

use super::kernel::Kernel;
use super::moments::inverse;
use crate::tensor::{Mat3, Vec3};

/// Corrected gradients `V_a G_b(X_a)` of one row, see the module.
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `kernel`, `h` | kernel and smoothing length | –, m |
/// | `a` | index of the particle | – |
/// | `row` | its neighbours, itself included | – |
/// | `position`, `volume` | `X`, `V` of all particles | m, m³ |
///
/// Returns the entries of the row in m², or `None` if its neighbours do not span space.
pub(super) fn row(
    kernel: Kernel,
    h: f64,
    a: usize,
    row: &[u32],
    position: &[Vec3],
    volume: &[f64],
) -> Option<Vec<Vec3>> {
    let (mut s, mut grad_s) = (0.0, Vec3::zeros());
    let mut raw = Vec::with_capacity(row.len());
    for &b in row {
        let (d, v_b) = (position[a] - position[b as usize], volume[b as usize]);
        let (w, grad_w) = (v_b * kernel.value(d.norm(), h), v_b * kernel.gradient(&d, h));
        s += w;
        grad_s += grad_w;
        raw.push((w, grad_w));
    }
    let mut moment = Mat3::zeros();
    let mut entries: Vec<Vec3> = Vec::with_capacity(row.len());
    for (&b, (w, grad_w)) in row.iter().zip(raw) {
        let gradient = (grad_w - grad_s * (w / s)) / s;
        moment += (position[b as usize] - position[a]) * gradient.transpose();
        entries.push(gradient);
    }
    let correction = volume[a] * inverse(&moment)?.transpose();
    for entry in &mut entries {
        *entry = correction * *entry;
    }
    Some(entries)
}
