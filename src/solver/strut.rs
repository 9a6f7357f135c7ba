//! The bar that stands for a pair: its area, length and direction.
//!
//! Owns how much a pair weighs in the terms that read what no gradient sees. Knows no state.

use super::links::Links;
use rayon::prelude::*;

/// Geometry of a pair as springs and dashpots see it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Strut {
    /// `½ (X_b − X_a)`, m.
    pub half_step: [f64; 3],
    /// Area, m²; never negative, and the same for `(b, a)`.
    pub area: f64,
    /// `1/|X_b − X_a|`, 1/m.
    pub inverse_length: f64,
}

/// How many times the median of a body a particle's row may weigh before its pairs are weighed down.
///
/// On lattices no row reaches it, edges and corners included; among nodes drawn together by a curved face, single
/// rows weigh ten times the median and would set the step of the whole body.
const HEAVIEST: f64 = 2.0;

/// Struts of every pair, in the order of the links.
///
/// ```text
/// A_ab = |N_ab · (V_a G_b(X_a) − V_b G_a(X_b))| min(1, γ med g / max(g_a, g_b))
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `links` | pairs of the body | |
/// | `inverse_volume` | `1/V_a` | 1/m³ |
///
/// The interface area is taken positive, as an energy and a dissipation want it; `g` is [`row_bounds`], and `γ`
/// keeps few bad stencils from shrinking the step of the whole body.
pub fn struts(links: &Links, inverse_volume: &[f64]) -> Vec<Strut> {
    let plain = |pair: &super::links::Pair| {
        let [x, y, z] = pair.half_step;
        let inverse_length = 0.5 / libm::sqrt(x * x + y * y + z * z);
        Strut { half_step: pair.half_step, area: pair.interface.abs(), inverse_length }
    };
    let mut struts: Vec<Strut> = links.pair.par_iter().map(plain).collect();
    let bounds = row_bounds(links, &struts, inverse_volume);
    let mut sorted = bounds.clone();
    sorted.sort_by(f64::total_cmp);
    let allowed = HEAVIEST * sorted[sorted.len() / 2];
    for (a, own) in bounds.iter().enumerate() {
        for entry in links.row(a) {
            let heavier = own.max(bounds[links.neighbour[entry] as usize]);
            if heavier > allowed {
                struts[entry].area *= allowed / heavier;
            }
        }
    }
    struts
}

/// Bound of each row of the operator `u ↦ Qᵀ A Q u / V` with `(Q u)_ab` the mismatch of a scalar field.
///
/// ```text
/// g_c = 1/V_c Σ_ab |Q_ab,c| A_ab Σ_e |Q_ab,e|
/// |Q_ab,c| ≤ [c = a or b] + |h_ab| (|C_ac|/V_a + |C_bc|/V_b),   h_ab = ½ (X_b − X_a),   C_ac = V_a G_c(X_a)
/// ```
///
/// with the particle's own entry of a row at most the sum of the others. No eigenvalue of the operator exceeds the
/// largest of them (Gershgorin). Returns one number a particle, 1/m.
pub fn row_bounds(links: &Links, struts: &[Strut], inverse_volume: &[f64]) -> Vec<f64> {
    let norm = |v: &[f64; 3]| libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    let count = inverse_volume.len();
    // Σ_c |C_ac| / V_a over the neighbours, as much as the own entry at most
    let reach = |a: usize| links.forward[links.row(a)].iter().map(norm).sum::<f64>() * inverse_volume[a];
    let reach: Vec<f64> = (0..count).into_par_iter().map(reach).collect();
    let whole = |a: usize, entry: usize| {
        let b = links.neighbour[entry] as usize;
        2.0 + norm(&struts[entry].half_step) * 2.0 * (reach[a] + reach[b])
    };
    // Σ_b A_ab |h_ab| Σ_e |Q_ab,e|: what each gradient of a is weighed by
    let load = |a: usize| {
        let row = links.row(a);
        row.map(|e| struts[e].area * norm(&struts[e].half_step) * whole(a, e)).sum::<f64>()
    };
    let load: Vec<f64> = (0..count).into_par_iter().map(load).collect();
    let bound = |c: usize| {
        let direct: f64 = links.row(c).map(|e| struts[e].area * whole(c, e)).sum();
        let others = links.row(c).map(|e| {
            let a = links.neighbour[e] as usize;
            norm(&links.backward[e]) * inverse_volume[a] * load[a]
        });
        (direct + reach[c] * load[c] + others.sum::<f64>()) * inverse_volume[c]
    };
    (0..count).into_par_iter().map(bound).collect()
}
