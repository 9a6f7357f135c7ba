//! How far the evolved maps are from being the gradient of one motion.
//!
//! Owns the involutions of the conservation laws: CURL F = 0, DIV H = 0, and the equality of the
//! maps with what the positions say.

use crate::solver::BodyState;
use crate::tensor::{Mat3, Vec3, cofactor, volume_map};

/// Largest violations over all particles of all bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Involutions {
    /// `max |F_a − Grad_h x|`, Frobenius norm.
    pub gradient: f64,
    /// `max |H_a − cof F_a|`, zero where H is derived.
    pub area_map: f64,
    /// `max |J_a − det F_a|`, zero where J is derived.
    pub volume_map: f64,
    /// `dx · max |CURL_h F|`.
    pub curl_f: f64,
    /// `dx · max |DIV_h H|`.
    pub div_h: f64,
}

/// Measures the involutions of a state.
///
/// ```text
/// CURL F = 0,  (CURL F)_iJ = ε_JKL ∂F_iL/∂X_K      [NB25 (8)]
/// DIV H  = 0,  (DIV H)_i   = ∂H_iJ/∂X_J            [NB25 (12)]
/// ```
///
/// with the corrected gradient of the stencils; the spacing `dx` makes the last two numbers.
pub fn involutions(bodies: &[BodyState]) -> Involutions {
    let mut worst = Involutions::default();
    for body in bodies {
        let spacing = body.particles.spacing;
        for a in 0..body.len() {
            let gradient = gradient_of_position(body, a);
            worst.gradient = larger(worst.gradient, (body.f(a) - gradient).norm());
            let f = body.f(a);
            let cofactor = cofactor(f);
            if let Some(h) = body.h(a) {
                worst.area_map = larger(worst.area_map, (h - cofactor).norm());
            }
            if let Some(j) = body.j(a) {
                worst.volume_map = larger(worst.volume_map, (j - volume_map(f, &cofactor)).abs());
            }
            let (curl, divergence) = curl_and_divergence(body, a);
            worst.curl_f = larger(worst.curl_f, spacing * curl.norm());
            worst.div_h = larger(worst.div_h, spacing * divergence.norm());
        }
    }
    worst
}

/// The larger of two numbers; a NaN is kept, where `f64::max` would drop it.
fn larger(a: f64, b: f64) -> f64 {
    if b <= a { a } else { b }
}

/// `Grad_h x = Σ_b (x_b − x_a) ⊗ G_b(X_a)`.
fn gradient_of_position(body: &BodyState, a: usize) -> Mat3 {
    let own = body.x[a].vector();
    let mut sum = Mat3::zeros();
    for entry in body.links.row(a) {
        let b = body.links.neighbour[entry] as usize;
        sum += (body.x[b].vector() - own) * Vec3::from(body.links.forward[entry]).transpose();
    }
    sum * body.inverse_volume[a]
}

/// `CURL_h F` and `DIV_h H` at a particle, 1/m; `H` is `cof F` where it is derived.
pub fn curl_and_divergence(body: &BodyState, a: usize) -> (Mat3, Vec3) {
    let area_map = |b: usize| body.h(b).copied().unwrap_or_else(|| cofactor(body.f(b)));
    let (own_f, own_h) = (*body.f(a), area_map(a));
    let (mut curl, mut divergence) = (Mat3::zeros(), Vec3::zeros());
    for entry in body.links.row(a) {
        let b = body.links.neighbour[entry] as usize;
        let gradient = Vec3::from(body.links.forward[entry]);
        let df = body.f(b) - own_f;
        for i in 0..3 {
            let row = gradient.cross(&df.row(i).transpose());
            for j in 0..3 {
                curl[(i, j)] += row[j];
            }
        }
        divergence += (area_map(b) - own_h) * gradient;
    }
    (curl * body.inverse_volume[a], divergence * body.inverse_volume[a])
}
