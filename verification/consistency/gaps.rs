//! The evolved area and volume maps against the cofactor and the determinant of F.

use crate::monitor::{Involutions, involutions};
use crate::output::Figure;
use crate::verify::claim::Illustration;
use crate::verify::claims::picture::{Lines, orders};
use crate::verify::claims::scene::{advance, scene, simulation, thrown_cube};
use crate::verify::{Claim, Topic};

/// Time the cube flies, s: half a radian of turn, stretches of some ten per cent.
const UNTIL: f64 = 2.5e-3;

/// Verlet moves H with F in the middle of the step, which is the whole change of a cofactor.
pub(super) const AREA_MAP_VERLET: Claim = Claim {
    topic: Topic::Consistency,
    claim: "H stays the cofactor of F to round-off, by velocity Verlet",
    source: "NB25 (29): cof(F + dF) - cof F = (F + dF/2) x dF exactly",
    because: "some 200 steps of 40 roundings of 1.1e-16, adding up like a random walk: sqrt(8000) * 1.1e-16, four \
              times that for the largest of some hundred particles",
    bound: 4e-14,
    measure: || gap(0.4, "").1.area_map,
    control: || gap(0.4, HEUN).1.area_map,
};

/// The trapezium rule of H errs by half of det dF a step.
pub(super) const VOLUME_MAP_VERLET: Claim = Claim {
    topic: Topic::Consistency,
    claim: "the gap between J and det F vanishes with order 2 of the time step, by velocity Verlet",
    source: "NB25 (30): dJ = (H + H')/2 : dF misses det dF / 2 a step, of third order",
    because: "next term of the expansion, a share of the order of dF at the larger step, 0.01, of the gap, and \
              its logarithm over that of two",
    bound: 0.1,
    measure: || (order("", |gap| gap.volume_map) - 2.0).abs(),
    control: || (order("volume_dissipation = on", |gap| gap.volume_map) - 2.0).abs(),
};

/// Both maps by the paper's integrator.
pub(super) const AREA_MAP_HEUN: Claim = Claim {
    topic: Topic::Consistency,
    claim: "the gap between H and cof F vanishes with order 3 of the time step, by two-stage Runge-Kutta",
    source: "NB25 (29), (39)-(41): a step misses (L' - L) x (L' - L) dt^2 / 8, L' - L being of the order of dt",
    because: VOLUME_MAP_VERLET.because,
    bound: 0.1,
    measure: || (order(HEUN, |gap| gap.area_map) - 3.0).abs(),
    // a gap of the size of F itself, which no step makes smaller
    control: || (order(HEUN, |gap| gap.area_map + 1.0) - 3.0).abs(),
};

/// As [`AREA_MAP_HEUN`].
pub(super) const VOLUME_MAP_HEUN: Claim = Claim {
    topic: Topic::Consistency,
    claim: "the gap between J and det F vanishes with order 2 of the time step, by two-stage Runge-Kutta",
    source: "NB25 (30), (39)-(41)",
    because: VOLUME_MAP_VERLET.because,
    bound: 0.1,
    measure: || (order(HEUN, |gap| gap.volume_map) - 2.0).abs(),
    control: || (order(HEUN_UPWINDED, |gap| gap.volume_map) - 2.0).abs(),
};

const HEUN: &str = "integrator = tvd_rk2";
const HEUN_UPWINDED: &str = "integrator = tvd_rk2  volume_dissipation = on";

/// Steps taken and largest gaps of the thrown cube, all four fields evolved.
fn gap(cfl: f64, run: &str) -> (u64, Involutions) {
    let run = format!("{run} formulation = pFHJ cfl = {cfl} wave_speed_every = 0");
    let text = thrown_cube(&run, "").replace("until = 1 s", &format!("until = {UNTIL} s"));
    let scene = scene(&text);
    let mut simulation = simulation(&scene);
    advance(&mut simulation, scene.run.until);
    (simulation.steps(), involutions(simulation.bodies()))
}

/// Gaps over the step.
pub(super) const FIGURES: [Illustration; 4] = [
    Illustration {
        claim: AREA_MAP_VERLET.claim,
        figure: || {
            let lines = [("Heun", gaps(HEUN, |gap| gap.area_map)), ("Verlet", gaps("", |gap| gap.area_map))];
            figure("H and cof F", &lines, 3.0)
        },
    },
    Illustration {
        claim: VOLUME_MAP_VERLET.claim,
        figure: || {
            let with = "volume_dissipation = on";
            let lines =
                [("Verlet", gaps("", |gap| gap.volume_map)), ("with D(J)", gaps(with, |gap| gap.volume_map))];
            figure("J and det F", &lines, 2.0)
        },
    },
    Illustration {
        claim: AREA_MAP_HEUN.claim,
        figure: || figure("H and cof F", &[("Heun", gaps(HEUN, |gap| gap.area_map))], 3.0),
    },
    Illustration {
        claim: VOLUME_MAP_HEUN.claim,
        figure: || {
            let with = gaps(HEUN_UPWINDED, |gap| gap.volume_map);
            figure("J and det F", &[("Heun", gaps(HEUN, |gap| gap.volume_map)), ("with D(J)", with)], 2.0)
        },
    },
];

fn figure(what: &str, lines: &Lines<'_>, order: f64) -> Figure {
    let title = format!("Largest gap between {what} after 2.5 ms");
    orders(&title, ("time step", "s"), ("gap", ""), lines, order)
}

/// Mean step, s, and a gap, at falling Courant numbers.
fn gaps(run: &str, of: fn(&Involutions) -> f64) -> Vec<(f64, f64)> {
    let at = |cfl: f64| {
        let (steps, found) = gap(cfl, run);
        (UNTIL / steps as f64, of(&found))
    };
    [0.4, 0.2, 0.1, 0.05].map(at).to_vec()
}

/// Observed order of a gap in the time step, between a Courant number and half of it.
fn order(run: &str, of: fn(&Involutions) -> f64) -> f64 {
    let (few, coarse) = gap(0.2, run);
    let (many, fine) = gap(0.1, run);
    libm::log(of(&coarse) / of(&fine)) / libm::log(many as f64 / few as f64)
}
