//! Stress: the traced program against closed forms written by hand, side by side in one run.
//!
//! `cargo bench --bench stress`. The hand-written forms are scalar code, one particle at a time,
//! with the platform's functions (`std`) or the portable ones (`libm`); they live here only. All
//! routes take turns in one thread, and the median over the turns is printed.

use std::hint::black_box;
use std::time::Instant;
use tissue::{energy, expression, tensor};

#[allow(dead_code, missing_docs)]
#[path = "../verification/energies/laws.rs"]
mod laws;

use energy::{Directions, Law, Maps, Scratch};
use laws::{Artery, DISPERSED, Random, circumferential, compiled, goh, neo_hooke};
use tensor::{Mat3, Vec3, cofactor, volume_map};

const PARTICLES: usize = 4096;
const TURNS: usize = 61;
const REPEATS: usize = 4;

/// The elementary functions a hand-written form calls.
#[derive(Clone, Copy)]
struct Functions {
    exp: fn(f64) -> f64,
    cbrt: fn(f64) -> f64,
}

const PLATFORM: Functions = Functions { exp: f64::exp, cbrt: f64::cbrt };
const PORTABLE: Functions = Functions { exp: libm::exp, cbrt: libm::cbrt };

/// Equations 44 and 45 of the paper.
#[inline(always)]
fn neo_hooke_by_hand(f: &Mat3, mu: f64, k: f64, functions: Functions) -> Mat3 {
    let h = cofactor(f);
    let j = volume_map(f, &h);
    let r = 1.0 / (functions.cbrt)(j);
    let s = r * r;
    let by_j = k * (j - 1.0) - mu / 3.0 * s / j * f.norm_squared();
    mu * s * f + by_j * h
}

/// Equations 46 to 49, differentiated on paper.
#[inline(always)]
fn goh_by_hand(f: &Mat3, artery: &Artery, directions: &[Vec3; 2], functions: Functions) -> Mat3 {
    let h = cofactor(f);
    let j = volume_map(f, &h);
    let r = 1.0 / (functions.cbrt)(j);
    let s = r * r;
    let i1_bar = s * f.norm_squared();
    let aligned = 1.0 - 3.0 * artery.kappa;
    let mut by_i1 = artery.c;
    let mut by_j = 0.0;
    let mut p = Mat3::zeros();
    for a in directions {
        let m = f * a;
        let i4_bar = s * m.norm_squared();
        let strain = artery.kappa * (i1_bar - 3.0) + aligned * (i4_bar - 1.0);
        if strain > 0.0 {
            let slope = artery.k1 * strain * (functions.exp)(artery.k2 * strain * strain);
            by_i1 += slope * artery.kappa;
            let by_i4 = slope * aligned;
            p += (2.0 * by_i4 * s * m) * a.transpose();
            by_j += by_i4 * i4_bar;
        }
    }
    let by_j = -2.0 / 3.0 * (by_j + by_i1 * i1_bar) / j + (j - 1.0 / j) / artery.d;
    p + (2.0 * by_i1 * s) * f + by_j * h
}

/// Nanoseconds a particle, the median over the turns of each route.
fn medians(routes: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(TURNS); routes.len()];
    for _ in 0..TURNS {
        for (route, times) in routes.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (0..REPEATS).for_each(|_| route());
            times.push(start.elapsed().as_secs_f64() * 1e9 / (PARTICLES * REPEATS) as f64);
        }
    }
    times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect()
}

fn compare(
    name: &str,
    law: &Law,
    states: &[Mat3],
    directions: &[Vec3],
    by_hand: impl Fn(&Mat3, Functions) -> Mat3,
) {
    let maps = Maps { f: states, h: None, j: None };
    let directions = Directions::Uniform(directions);
    let zeros = || vec![Mat3::zeros(); states.len()];
    let (mut traced, mut platform, mut portable) = (zeros(), zeros(), zeros());
    let mut scratch = Scratch::default();
    let times = medians(&mut [
        &mut || law.stress(black_box(maps), directions, black_box(&mut traced), &mut scratch),
        &mut || {
            for (p, f) in platform.iter_mut().zip(black_box(states)) {
                *p = by_hand(f, PLATFORM);
            }
            black_box(&mut platform);
        },
        &mut || {
            for (p, f) in portable.iter_mut().zip(black_box(states)) {
                *p = by_hand(f, PORTABLE);
            }
            black_box(&mut portable);
        },
    ]);
    let worst = traced.iter().zip(&platform).map(|(p, q)| (p - q).norm() / q.norm()).fold(0.0, f64::max);
    println!(
        "{name:28} traced {:6.1} ns   by hand {:6.1} ns (std) {:6.1} ns (libm)   ratio {:.2} {:.2}   \
         {} operations   largest difference {worst:.1e}",
        times[0],
        times[1],
        times[2],
        times[0] / times[1],
        times[0] / times[2],
        law.operations(),
    );
}

fn waves(name: &str, law: &Law, states: &[Mat3], directions: &[Vec3]) {
    let maps = Maps { f: states, h: None, j: None };
    let mut speeds = vec![0.0; states.len()];
    let start = Instant::now();
    law.wave_speed_block(
        maps,
        Directions::Uniform(directions),
        1000.0,
        black_box(&mut speeds),
        &mut Scratch::default(),
    );
    let time = start.elapsed().as_secs_f64() * 1e9 / states.len() as f64;
    println!("{name:28} fastest wave {time:8.0} ns");
}

fn compiling(name: &str, families: u8) {
    let psi = goh(families, true);
    let start = Instant::now();
    let law = black_box(compiled(&psi, &DISPERSED.parameters()));
    let time = start.elapsed().as_secs_f64() * 1e3;
    println!("{name:28} compiled in {time:8.2} ms, {} operations", law.operations());
}

fn main() {
    let mut random = Random(1);
    let states: Vec<Mat3> = (0..PARTICLES).map(|_| random.deformation(0.08)).collect();
    let (mu, k) = (15.28e3, 2e7);
    let neo = compiled(&neo_hooke(), &[mu, k]);
    compare("neo-Hookean", &neo, &states, &[], |f, functions| neo_hooke_by_hand(f, mu, k, functions));
    let law = compiled(&goh(2, true), &DISPERSED.parameters());
    let directions = circumferential();
    compare("GOH, two families", &law, &states, &directions, |f, functions| {
        goh_by_hand(f, &DISPERSED, &directions, functions)
    });
    compiling("GOH, two families", 2);
    compiling("GOH, a hundred families", 100);
    waves("neo-Hookean", &neo, &states, &[]);
    waves("GOH, two families", &law, &states, &directions);
}
