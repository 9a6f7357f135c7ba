//! The pair's forces against its energy and its dissipation, on a jittered cube bent out of shape.

use super::*;
use crate::plan::Plan;
use crate::scene::{Memory, resolve};
use crate::solver::Simulation;
use crate::solver::force::internal;
use crate::solver::kinematics::velocity_gradient;
use crate::solver::wide::NARROW;
use crate::syntax::Source;
use crate::tensor::{Vec3, volume_map};
use proptest::prelude::*;

/// A free cube of jittered nodes, undeformed.
fn cube(run: &str) -> BodyState {
    let text = format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
material gel {{ energy = neo_hooke(mu = 20 kPa) + vol_quadratic(K = 60 kPa)  density = 1000 kg/m^3 }}
scene free {{
  body cube {{ shape = box(4 mm, 4 mm, 4 mm)  spacing = 1 mm  jitter = 0.2  material = gel }}
  run {{ until = 1 s  {run} }}
}}
"
    );
    let source = Source { name: "cube.tissue".into(), text };
    let (document, mistakes) = resolve(&source, &Memory::default(), &[]);
    assert!(mistakes.is_empty(), "the scene resolves");
    let scene = &document.scenes[0];
    let mut simulation = Simulation::new(scene, &Plan::new(scene)).expect("the cube can be set up");
    simulation.bodies_mut().remove(0)
}

/// Springs alone.
const SPRINGS: &str = "hourglass_stiffness = 2  momentum_dissipation = off";

/// Dashpots alone.
const DASHPOTS: &str = "hourglass_stiffness = 0";

/// A field without symmetry of the size given.
fn field(body: &BodyState, turn: f64, size: f64) -> Vec<Quad> {
    let wave = |x: &Vec3, k: f64| libm::sin(turn + k * 900.0 * x.x + 700.0 * x.y - k * 500.0 * x.z);
    let at = |x: &Vec3| size * Vec3::new(wave(x, 1.0), wave(x, 2.0), wave(x, -1.5));
    body.particles.position.iter().map(|x| Quad::new(&at(x))).collect()
}

/// A displacement without symmetry, m: neighbours part by a tenth of their distance.
fn displacement(body: &BodyState, turn: f64) -> Vec<Quad> {
    field(body, turn, 1e-4)
}

/// Puts the body at `X + u` with velocities `v` and runs the pass on an unstressed body.
fn pass(body: &mut BodyState, u: &[Quad], v: &[Quad]) {
    for (a, u) in u.iter().enumerate() {
        body.x[a] = Quad::new(&body.particles.position[a]) + *u;
    }
    body.v.copy_from_slice(v);
    let BodyState { links, x, v, inverse_volume, packets, blocks, .. } = body;
    for (a, packet) in packets.iter_mut().enumerate() {
        packet.f = velocity_gradient(links, a, x, inverse_volume[a]);
        packet.gradient = velocity_gradient(links, a, v, inverse_volume[a]);
        let f = packet.f.matrix();
        packet.turn(&(cofactor(&f) / volume_map(&f, &cofactor(&f))));
        blocks[a / CHUNK].f[a % CHUNK] = f;
    }
    body.stress.fill(Columns::ZERO);
    hourglass(body);
}

/// Force of springs and dashpots on particle `a`, their stress included, N.
fn force(body: &BodyState, a: usize) -> Quad {
    let hourglass = body.hourglass.as_ref().expect("the body has springs or dashpots");
    internal(&body.links, a, &hourglass.stress, 1.0) + hourglass.force[a]
}

fn work(body: &BodyState, v: &[Quad]) -> f64 {
    (0..body.len()).map(|a| force(body, a).dot(v[a])).sum()
}

fn at_rest(body: &BodyState) -> Vec<Quad> {
    vec![Quad::ZERO; body.len()]
}

#[test]
fn the_forces_of_the_springs_are_the_derivative_of_their_energy() {
    let mut body = cube(SPRINGS);
    let (base, direction, rest) = (displacement(&body, 0.3), displacement(&body, 1.9), at_rest(&body));
    let mut along = |share: f64| {
        let moved: Vec<Quad> = base.iter().zip(&direction).map(|(u, d)| *u + *d * share).collect();
        pass(&mut body, &moved, &rest);
        (energy(&body), work(&body, &direction))
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
    let mut body = cube(SPRINGS);
    let rest = at_rest(&body);
    let position = body.particles.position.clone();
    let gradient = Mat3::new(0.2, 0.1, 0.0, -0.3, 0.1, 0.2, 0.0, 0.4, -0.1);
    let affine: Vec<Quad> = position.iter().map(|x| Quad::new(&(gradient * x))).collect();
    pass(&mut body, &affine, &rest);
    let affine = energy(&body);
    let bent = displacement(&body, 0.3);
    pass(&mut body, &bent, &rest);
    let before = energy(&body);
    let turn = Mat3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let turned: Vec<Quad> =
        position.iter().zip(&bent).map(|(x, u)| Quad::new(&(turn * (x + u.vector()) - x))).collect();
    pass(&mut body, &turned, &rest);
    // squares of a mismatch that is round-off of 1e-3 m times the stencil's condition, against 1e-5 m
    assert!(affine <= 1e-20 * before, "{affine} against {before}");
    assert!((energy(&body) - before).abs() <= 1e-11 * before);
}

#[test]
fn the_power_of_the_dashpots_is_what_they_dissipate_on_a_bent_body() {
    let mut body = cube(DASHPOTS);
    let (u, v) = (displacement(&body, 0.3), field(&body, 2.2, 1.0));
    pass(&mut body, &u, &v);
    let taken = body.hourglass.as_ref().expect("dashpots").dissipated_power();
    let power = work(&body, &v);
    // some 2 000 pairs of some hundred operations each
    assert!(taken > 0.0);
    assert!((power + taken).abs() <= 2000.0 * f64::EPSILON * taken, "{power} against {taken}");
}

#[test]
fn the_forces_of_the_dashpots_are_symmetric_in_the_velocities() {
    let mut body = cube(DASHPOTS);
    let u = displacement(&body, 0.3);
    let (v, w) = (field(&body, 2.2, 1.0), field(&body, 0.7, 1.0));
    pass(&mut body, &u, &v);
    let there = work(&body, &w);
    let scale = work(&body, &v).abs();
    pass(&mut body, &u, &w);
    let back = work(&body, &v);
    assert!((there - back).abs() <= 2000.0 * f64::EPSILON * scale, "{there} against {back}");
}

#[test]
fn what_turns_as_a_whole_loses_nothing_however_bent_and_feels_no_torque() {
    let mut body = cube(DASHPOTS);
    let u = displacement(&body, 0.3);
    let spin = Vec3::new(300.0, -200.0, 500.0);
    let turning: Vec<Quad> = (body.particles.position.iter().zip(&u))
        .map(|(x, u)| Quad::new(&(spin.cross(&(x + u.vector())) + Vec3::new(1.0, 2.0, -1.0))))
        .collect();
    pass(&mut body, &u, &turning);
    let free = body.hourglass.as_ref().expect("dashpots").dissipated_power();
    let v = field(&body, 2.2, 1.0);
    pass(&mut body, &u, &v);
    let taken = body.hourglass.as_ref().expect("dashpots").dissipated_power();
    let torque: Vec3 = (0..body.len()).map(|a| body.x[a].vector().cross(&force(&body, a).vector())).sum();
    let scale: f64 =
        (0..body.len()).map(|a| body.x[a].vector().norm() * force(&body, a).vector().norm()).sum();
    // rates that are round-off of some hundred operations, squared
    assert!(free <= (200.0 * f64::EPSILON).powi(2) * 10.0 * taken, "{free} of {taken}");
    assert!(torque.norm() <= 500.0 * f64::EPSILON * scale, "{} of {scale}", torque.norm());
}

#[test]
fn wide_registers_change_no_bit() {
    let mut body = cube("hourglass_stiffness = 1");
    let (u, v) = (displacement(&body, 0.3), field(&body, 2.2, 1.0));
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    let mut both = [false, true].map(|narrow| {
        one_thread.install(|| {
            NARROW.with(|cell| cell.set(narrow));
            pass(&mut body, &u, &v);
            NARROW.with(|cell| cell.set(false));
        });
        (0..body.len()).flat_map(|a| force(&body, a).0.map(f64::to_bits)).collect::<Vec<_>>()
    });
    let [wide, narrow] = both.each_mut();
    assert!(wide == narrow);
}

#[test]
fn no_row_of_a_lattice_is_weighed_down_and_the_bound_holds() {
    let body = cube("hourglass_stiffness = 1");
    let struts = struts(&body.links, &body.inverse_volume);
    let bounds = crate::solver::row_bounds(&body.links, &struts, &body.inverse_volume);
    // springs of unit modulus over length are dashpots of impedance 2 between whom all directions are alike
    let impedance = Speeds { pressure: 2.0, shear: 2.0 };
    let rate = dashpot_rate(&body, impedance) * body.density;
    assert!(rate <= bounds.iter().copied().fold(0.0, f64::max), "{rate}");
    assert!(rate > 0.0);
}

proptest! {
    #[test]
    fn exchanging_the_particles_flips_the_mismatch_and_its_rate_exactly(
        f in prop::array::uniform9(-1.0..1.0_f64),
        g in prop::array::uniform9(-1.0..1.0_f64),
        d in prop::array::uniform3(-1.0..1.0_f64),
        w in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let columns = |m: &[f64; 9]| Columns::new(&Mat3::from_column_slice(m));
        let distance = Quad::new(&Vec3::from(d));
        let there = mismatch(distance, &columns(&f), &columns(&g), &d);
        let back = mismatch(distance * -1.0, &columns(&g), &columns(&f), &d.map(|x| -x));
        prop_assert_eq!(there * -1.0, back);
        let spin = Quad::new(&Vec3::from(w));
        let turned = corotational_rate(distance, there, spin);
        prop_assert_eq!(turned * -1.0, corotational_rate(distance * -1.0, back, spin));
        let printed = Vec3::from(d) - Vec3::from(w).cross(&there.vector());
        // a dozen operations on numbers below 10
        prop_assert!((turned.vector() - printed).norm() <= 10.0 * 12.0 * f64::EPSILON);
    }

    #[test]
    fn a_dashpot_agrees_with_the_formula_as_printed_and_takes_power(
        rate in prop::array::uniform3(-1.0..1.0_f64),
        d in prop::array::uniform3(0.1..1.0_f64),
    ) {
        let impedance = Speeds { pressure: 3.0, shear: 1.0 };
        let n = Vec3::from(d).normalize();
        let s = 0.5 * (3.0 * n * n.transpose() + (Mat3::identity() - n * n.transpose()));
        let (rate, distance) = (Vec3::from(rate), Quad::new(&Vec3::from(d)));
        let fast = dashpot(Quad::new(&rate), distance, impedance);
        prop_assert!((fast.vector() - s * rate).norm() <= 5.0 * 12.0 * f64::EPSILON);
        prop_assert!(fast.dot(Quad::new(&rate)) >= 0.0);
    }
}
