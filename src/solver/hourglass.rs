//! Stiffness against displacements that no particle's gradient sees.
//!
//! Owns the penalty of one pair, its forces and its energy. The corrected gradient is a central
//! difference: the even and the odd nodes of a lattice may stretch differently and no `F_a` tells, so
//! nodal stresses alternate from layer to layer and D(p), which only damps, lets them. Knows neither
//! materials nor time.

use super::body::{BodyState, CHUNK};
use super::links::Links;
use super::quad::{Columns, Quad};
use crate::tensor::Mat3;
use rayon::prelude::*;

/// Pair constants and results of the hourglass pass.
#[derive(Debug, Clone, Default)]
pub struct Hourglass {
    /// `k_ab` of each pair, in the order of the links, N/m.
    stiffness: Vec<f64>,
    /// Direct force on each particle, N.
    pub force: Vec<Quad>,
    /// Stress of the energy alone, kept where the packets carry the sum, Pa.
    pub constitutive: Vec<Columns>,
}

impl Hourglass {
    /// Pair stiffnesses of a body.
    ///
    /// ```text
    /// k_ab = ξ μ N_ab · (V_a G_b(X_a) − V_b G_a(X_b)) / |X_b − X_a|
    /// ```
    ///
    /// | argument | meaning | unit |
    /// |---|---|---|
    /// | `links` | pairs of the body | |
    /// | `modulus` | `ξ μ`, the dimensionless stiffness times the shear modulus at rest | Pa |
    ///
    /// A bar of that modulus with the pair's interface area and length. The area is taken positive, so
    /// the energy is never negative; the same for `(b, a)`, bit by bit.
    pub fn new(links: &Links, modulus: f64) -> Self {
        let stiffness = links.pair.iter().map(|pair| {
            let [x, y, z] = pair.half_step;
            modulus * pair.dissipation.abs() / (2.0 * libm::sqrt(x * x + y * y + z * z))
        });
        let count = links.start.len() - 1;
        Self {
            stiffness: stiffness.collect(),
            force: vec![Quad::ZERO; count],
            constitutive: vec![Columns::ZERO; count],
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        self.stiffness.len() * size_of::<f64>()
            + self.force.len() * size_of::<Quad>()
            + self.constitutive.len() * size_of::<Columns>()
    }
}

/// What a pair's positions miss of the line their gradients draw.
///
/// ```text
/// δ_ab = x_b − x_a − ½ (F_a + F_b) (X_b − X_a)
/// ```
///
/// | argument | meaning | unit |
/// |---|---|---|
/// | `distance` | `x_b − x_a` | m |
/// | `f_a`, `f_b` | deformation gradients | – |
/// | `half_step` | `½ (X_b − X_a)` | m |
///
/// Returns m. Zero for affine motions, of third order in the distance for smooth ones (the trapezium
/// rule), turned by a rotation. Exact in floating point: exchanging `a` and `b` flips it.
#[inline(always)]
pub fn mismatch(distance: Quad, f_a: &Columns, f_b: &Columns, half_step: &[f64; 3]) -> Quad {
    distance - f_a.plus(f_b).apply(half_step)
}

/// Energy of the penalty, J.
///
/// ```text
/// Φ = Σ_{a<b} ½ k_ab |δ_ab|²
/// ```
///
/// Zero where the body has none. Summed in stencil order.
pub fn energy(body: &BodyState) -> f64 {
    let Some(hourglass) = &body.hourglass else { return 0.0 };
    let mut sum = 0.0;
    for a in 0..body.len() {
        let own = Columns::new(body.f(a));
        for entry in body.links.row(a) {
            let b = body.links.neighbour[entry] as usize;
            let other = Columns::new(body.f(b));
            let delta = mismatch(body.x[b] - body.x[a], &own, &other, &body.links.pair[entry].half_step);
            // each pair is met twice
            sum += 0.25 * hourglass.stiffness[entry] * delta.dot(delta);
        }
    }
    sum
}

/// The pass: forces `−∂Φ/∂x` where `F` is the discrete gradient of `x`.
///
/// ```text
/// force on a    Σ_b k_ab δ_ab
/// stress of a   −1/(2 V_a) Σ_b k_ab δ_ab ⊗ (X_b − X_a), added to P_a
/// ```
///
/// Because Φ does not change under translation and rotation, and because the forces are its whole
/// derivative, they conserve linear and angular momentum and energy as the internal forces do.
pub fn hourglass(body: &mut BodyState) {
    let BodyState { links, x, blocks, packets, inverse_volume, hourglass, .. } = body;
    let Some(Hourglass { stiffness, force, constitutive }) = hourglass else { return };
    let (links, x, blocks, stiffness) = (&*links, &x[..], &blocks[..], &stiffness[..]);
    let f = |a: usize| Columns::new(&blocks[a / CHUNK].f[a % CHUNK]);
    packets
        .par_chunks_mut(CHUNK)
        .zip(force.par_chunks_mut(CHUNK).zip(constitutive.par_chunks_mut(CHUNK)))
        .enumerate()
        .for_each(|(chunk, (packets, (force, constitutive)))| {
            for (i, packet) in packets.iter_mut().enumerate() {
                let a = chunk * CHUNK + i;
                let (sum, moment) = pair_sums(links, a, x, &f, stiffness);
                force[i] = sum;
                constitutive[i] = packet.stress;
                packet.stress = packet.stress.plus(&moment.scaled(-inverse_volume[a]));
            }
        });
}

/// `Σ_b k_ab δ_ab` and `Σ_b k_ab δ_ab ⊗ ½ (X_b − X_a)` of particle `a`.
#[inline(always)]
fn pair_sums(
    links: &Links,
    a: usize,
    x: &[Quad],
    f: &impl Fn(usize) -> Columns,
    stiffness: &[f64],
) -> (Quad, Columns) {
    let own = f(a);
    let x_a = x[a];
    let (mut sum, mut moment) = (Quad::ZERO, Columns::ZERO);
    let row = links.row(a);
    let pairs = links.neighbour[row.clone()].iter().zip(&links.pair[row.clone()]).zip(&stiffness[row]);
    for ((&b, pair), &stiffness) in pairs {
        let b = b as usize;
        let traction = mismatch(x[b] - x_a, &own, &f(b), &pair.half_step) * stiffness;
        sum += traction;
        moment.add_outer(traction, &pair.half_step);
    }
    (sum, moment)
}

/// Power iterations for the fastest hourglass mode.
const ITERATIONS: usize = 40;

/// What they may fall short by.
const MARGIN: f64 = 1.05;

/// Square of the fastest frequency the penalty gives the body, 1/s²; zero where it has none.
///
/// The penalty is linear in the positions and does not depend on the state, so this is found once:
/// the largest eigenvalue of `u ↦ −f(u)/m`, by power iteration from a field without symmetry. The body
/// must be undeformed and unstressed; its state is left as it was.
pub fn stiffest(body: &mut BodyState) -> f64 {
    if body.hourglass.is_none() {
        return 0.0;
    }
    let rest: Vec<Quad> = body.x.clone();
    let volume: Vec<f64> = body.particles.volume.clone();
    let mut field: Vec<Quad> = (0..body.len())
        .map(|a| {
            let seed = (a as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let part = |shift: u32| f64::from((seed.rotate_left(shift) >> 40) as u32) / 16_777_216.0 - 0.5;
            Quad([part(3), part(19), part(41), 0.0])
        })
        .collect();
    let mut square = 0.0;
    for _ in 0..ITERATIONS {
        let norm = libm::sqrt(field.iter().zip(&volume).map(|(u, v)| u.dot(*u) * v).sum());
        field.iter_mut().for_each(|u| *u = *u * (1.0 / norm));
        displace(body, &rest, &field);
        body.packets.fill(Default::default());
        hourglass(body);
        let mut largest = 0.0_f64;
        for (a, u) in field.iter_mut().enumerate() {
            let total = force_of(body, a);
            *u = total * (-body.inverse_volume[a] / body.density);
            largest += u.dot(*u) * volume[a];
        }
        square = libm::sqrt(largest);
        if square == 0.0 {
            break;
        }
    }
    body.x = rest;
    body.packets.fill(Default::default());
    if let Some(Hourglass { force, constitutive, .. }) = &mut body.hourglass {
        force.fill(Quad::ZERO);
        constitutive.fill(Columns::ZERO);
    }
    for block in &mut body.blocks {
        block.f.fill(Mat3::identity());
    }
    MARGIN * square
}

/// Positions `X + u` with the deformation gradients that belong to them.
fn displace(body: &mut BodyState, rest: &[Quad], field: &[Quad]) {
    for (x, (rest, u)) in body.x.iter_mut().zip(rest.iter().zip(field)) {
        *x = *rest + *u;
    }
    let BodyState { links, inverse_volume, blocks, .. } = body;
    for block in blocks {
        for (i, f) in block.f.iter_mut().enumerate() {
            let a = block.start + i;
            let gradient = super::kinematics::velocity_gradient(links, a, field, inverse_volume[a]);
            *f = Mat3::identity() + gradient.matrix();
        }
    }
}

/// Force of the penalty on particle `a`, its stress included, N.
fn force_of(body: &BodyState, a: usize) -> Quad {
    let internal = super::force::internal(&body.links, a, &body.packets, 1.0);
    body.hourglass.as_ref().map_or(internal, |hourglass| internal + hourglass.force[a])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Plan;
    use crate::scene::{Memory, resolve};
    use crate::solver::Simulation;
    use crate::syntax::Source;
    use crate::tensor::Vec3;
    use proptest::prelude::*;

    /// A free cube of jittered nodes, undeformed.
    fn cube() -> BodyState {
        let text = "tissue 1
import std.energies { neo_hooke, vol_quadratic }
material gel { energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }
scene free {
  body cube { shape = box(4 mm, 4 mm, 4 mm)  spacing = 1 mm  jitter = 0.2  material = gel }
  run { until = 1 s  hourglass_stiffness = 2 }
}
";
        let source = Source { name: "cube.tissue".into(), text: text.into() };
        let (document, mistakes) = resolve(&source, &Memory::default(), &[]);
        assert!(mistakes.is_empty());
        let scene = &document.scenes[0];
        let mut simulation = Simulation::new(scene, &Plan::new(scene)).expect("the cube can be set up");
        simulation.bodies_mut().remove(0)
    }

    /// A displacement without symmetry, m.
    fn field(body: &BodyState, turn: f64) -> Vec<Quad> {
        let wave = |x: &Vec3, k: f64| libm::sin(turn + k * 900.0 * x.x + 700.0 * x.y - k * 500.0 * x.z);
        let at = |x: &Vec3| 1e-4 * Vec3::new(wave(x, 1.0), wave(x, 2.0), wave(x, -1.5));
        body.particles.position.iter().map(|x| Quad::new(&at(x))).collect()
    }

    fn rest(body: &BodyState) -> Vec<Quad> {
        body.particles.position.iter().map(Quad::new).collect()
    }

    #[test]
    fn its_forces_are_the_derivative_of_its_energy() {
        let mut body = cube();
        let (rest, base, direction) = (rest(&body), field(&body, 0.3), field(&body, 1.9));
        let mut along = |share: f64| {
            let moved: Vec<Quad> = base.iter().zip(&direction).map(|(u, d)| *u + *d * share).collect();
            displace(&mut body, &rest, &moved);
            body.packets.fill(Default::default());
            hourglass(&mut body);
            let work: f64 = (0..body.len()).map(|a| force_of(&body, a).dot(direction[a])).sum();
            (energy(&body), work)
        };
        let (up, down) = (along(0.5).0, along(-0.5).0);
        let (at, work) = along(0.0);
        assert!(at > 0.0);
        // the energy is quadratic in the positions, so a central difference is exact to round-off: some
        // 2 000 pairs, relative to the energy
        assert!((up - down + work).abs() <= 2000.0 * f64::EPSILON * at, "{} against {work}", up - down);
        assert!((up - down).abs() > 1e-3 * at);
    }

    #[test]
    fn affine_motions_cost_nothing_and_turning_the_body_changes_nothing() {
        let mut body = cube();
        let rest = rest(&body);
        let gradient = Mat3::new(0.2, 0.1, 0.0, -0.3, 0.1, 0.2, 0.0, 0.4, -0.1);
        let affine: Vec<Quad> = body.particles.position.iter().map(|x| Quad::new(&(gradient * x))).collect();
        displace(&mut body, &rest, &affine);
        let affine = energy(&body);
        let bent = field(&body, 0.3);
        displace(&mut body, &rest, &bent);
        let before = energy(&body);
        let turn = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        let turned: Vec<Quad> = rest
            .iter()
            .zip(&bent)
            .map(|(x, u)| Quad::new(&(turn * (*x + *u).vector() - x.vector())))
            .collect();
        displace(&mut body, &rest, &turned);
        // squares of a mismatch that is round-off of 1e-3 m times the stencil's condition, against 1e-5 m
        assert!(affine <= 1e-20 * before, "{affine} against {before}");
        assert!((energy(&body) - before).abs() <= 1e-11 * before);
    }

    proptest! {
        #[test]
        fn exchanging_the_particles_flips_the_mismatch_exactly(
            f in prop::array::uniform9(-1.0..1.0_f64),
            g in prop::array::uniform9(-1.0..1.0_f64),
            d in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            let columns = |m: &[f64; 9]| Columns::new(&Mat3::from_column_slice(m));
            let distance = Quad::new(&Vec3::from(d));
            let there = mismatch(distance, &columns(&f), &columns(&g), &d);
            let back = mismatch(distance * -1.0, &columns(&g), &columns(&f), &d.map(|x| -x));
            prop_assert_eq!(there * -1.0, back);
        }
    }
}
