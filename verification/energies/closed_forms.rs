//! Derived stresses against those printed in the paper.

use super::laws::{Random, compiled, neo_hooke, worse};
use crate::tensor::contract;
use crate::verify::{Claim, Topic};

/// Derived stresses equal equations (44) and (45) wherever `J > 0`, also off `J = det F`.
pub(crate) const NEO_HOOKE: Claim = Claim {
    topic: Topic::Energies,
    claim: "derived neo-Hookean stresses equal the closed form, also off J = det F",
    source: "NB25 (44)-(45)",
    because: "about 50 operations, each rounded to 1.1e-16, relative to the larger term",
    bound: 1e-14,
    measure: || neo_hooke_error(-1.0 / 3.0),
    control: || neo_hooke_error(-1.0 / 3.0 * 1.001),
};

/// Largest relative difference over a spread of states; `third` is the -1/3 of equation (45).
fn neo_hooke_error(third: f64) -> f64 {
    let (mu, k) = (3.5e3, 1.7e6);
    let law = compiled(&neo_hooke(), &[mu, k]);
    let mut random = Random(44);
    let mut worst = 0.0_f64;
    for _ in 0..1000 {
        let f = random.deformation(0.8);
        let h = random.deformation(0.8);
        let j = 0.3 + 2.0 * random.number();
        let sigma_f = mu * libm::pow(j, -2.0 / 3.0) * f;
        let deviatoric = third * mu * libm::pow(j, -5.0 / 3.0) * contract(&f, &f);
        let volumetric = k * (j - 1.0);
        let derived = law.conjugate_stresses(&f, &h, j, &[]);
        worst = worse(worst, (derived.sigma_f - sigma_f).norm() / sigma_f.norm());
        let larger = volumetric.abs().max(deviatoric.abs());
        worst = worse(worst, (derived.sigma_j - volumetric - deviatoric).abs() / larger);
        worst = worse(worst, derived.sigma_h.norm());
    }
    worst
}
