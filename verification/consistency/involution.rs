//! CURL F and DIV H, which the discrete derivatives leave where their stencils change.

use crate::monitor::{Involutions, curl_and_divergence, involutions};
use crate::output::Figure;
use crate::solver::Simulation;
use crate::verify::claim::Illustration;
use crate::verify::claims::cube::{Case, Cube};
use crate::verify::claims::picture::{bounded, history, orders};
use crate::verify::claims::scene::{scene, simulation, small_cube, step};
use crate::verify::{Claim, Shared, Topic};

const BECAUSE: &str = "differences of one stencil commute, so CURL is zero where stencils are alike and decays away from \
                       the boundary; DIV of a cofactor misses the product rule by the next term of the expansion, \
                       of order 2; a tenth is allowed for the term after it";

/// The small standing wave.
pub(super) const CURL_SWINGING: Claim = Claim {
    topic: Topic::Consistency,
    claim: "CURL F in the inner half of the swinging cube vanishes with order 2 of the spacing at least",
    source: "NB25 (8)",
    because: BECAUSE,
    bound: 0.1,
    measure: || shortfall(Case::Swinging(0.3), |means| means.0),
    control: || shortfall(Case::Swinging(0.3), |means| means.0 + 1.0),
};

/// As [`CURL_SWINGING`].
pub(super) const DIV_SWINGING: Claim = Claim {
    topic: Topic::Consistency,
    claim: "DIV H in the inner half of the swinging cube vanishes with order 2 of the spacing at least",
    source: "NB25 (12)",
    because: BECAUSE,
    bound: 0.1,
    measure: || shortfall(Case::Swinging(0.3), |means| means.1),
    control: || shortfall(Case::Swinging(0.3), |means| means.1 + 1.0),
};

/// Strains of a third, fibres pulled.
pub(super) const CURL_LARGE: Claim = Claim {
    topic: Topic::Consistency,
    claim: "CURL F in the inner half of a fibrous cube at large strain vanishes with order 2 of the spacing at least",
    source: "NB25 (8)",
    because: BECAUSE,
    bound: 0.1,
    measure: || shortfall(Case::Fibres, |means| means.0),
    control: || shortfall(Case::Fibres, |means| means.0 + 1.0),
};

/// As [`CURL_LARGE`].
pub(super) const DIV_LARGE: Claim = Claim {
    topic: Topic::Consistency,
    claim: "DIV H in the inner half of a fibrous cube at large strain vanishes with order 2 of the spacing at least",
    source: "NB25 (12)",
    because: BECAUSE,
    bound: 0.1,
    measure: || shortfall(Case::Fibres, |means| means.1),
    control: || shortfall(Case::Fibres, |means| means.1 + 1.0),
};

/// A thrown body far from any linear regime, over many steps.
pub(super) const ALL_TIMES: Claim = Claim {
    topic: Topic::Consistency,
    claim: "F stays the discrete gradient of the positions over 6000 steps",
    source: "NB25 (7), (8), (28)",
    because: "F is derived anew every 1000 steps, between which 1000 * 60 products of a weight (below 1/dx) and \
              a position (below 10 dx), rounded to 1.1e-16, add up like a random walk: 250 * 10 * 1.1e-16 = 3e-13, \
              and 1e-12 is what the method asks for",
    bound: 1e-12,
    measure: || {
        let scene = scene(&small_cube("", ""));
        let mut simulation = simulation(&scene);
        let mut worst = 0.0_f64;
        for _ in 0..12 {
            // half-way between two derivations as well as just before one
            step(&mut simulation, &scene, 500);
            worst = worst.max(involutions(simulation.bodies()).gradient);
        }
        worst
    },
    control: || {
        let scene = scene(&small_cube("", ""));
        let mut simulation = simulation(&scene);
        step(&mut simulation, &scene, 500);
        // F of another body: of the positions a step later
        let before: Vec<_> =
            (0..simulation.bodies()[0].len()).map(|a| *simulation.bodies()[0].f(a)).collect();
        step(&mut simulation, &scene, 1);
        let body = &simulation.bodies()[0];
        before.iter().enumerate().map(|(a, f)| (f - body.f(a)).norm()).fold(0.0, f64::max)
    },
};

/// Volume-weighted means of `|CURL_h F|` and `|DIV_h H|` over the inner half of an edge, 1/m.
fn means(simulation: &Simulation) -> (f64, f64) {
    let body = &simulation.bodies()[0];
    let inner = |a: &usize| body.particles.position[*a].iter().all(|x| (x - 0.5).abs() <= 0.25 + 1e-9);
    let (mut curl, mut divergence, mut volume) = (0.0, 0.0, 0.0);
    for a in (0..body.len()).filter(inner) {
        let (c, d) = curl_and_divergence(body, a);
        let weight = body.particles.volume[a];
        curl += weight * c.norm();
        divergence += weight * d.norm();
        volume += weight;
    }
    (curl / volume, divergence / volume)
}

/// Involutions over the spacing, and over time.
pub(super) const FIGURES: [Illustration; 5] = [
    Illustration {
        claim: CURL_SWINGING.claim,
        figure: || over_spacings("CURL F", &SWINGING, |means| means.0),
    },
    Illustration { claim: DIV_SWINGING.claim, figure: || over_spacings("DIV H", &SWINGING, |means| means.1) },
    Illustration { claim: CURL_LARGE.claim, figure: || over_spacings("CURL F", &LARGE, |means| means.0) },
    Illustration { claim: DIV_LARGE.claim, figure: || over_spacings("DIV H", &LARGE, |means| means.1) },
    Illustration { claim: ALL_TIMES.claim, figure: over_time },
];

/// The means at spacings whose boundary layer is well outside the inner half.
fn at_spacings(case: Case) -> Means {
    [12, 14, 16].map(|cells| (1.0 / f64::from(cells), means(&undamped(case, cells).end())))
}

/// Spacing, m, and the means of the two.
type Means = [(f64, (f64, f64)); 3];

static SWINGING: Shared<Means> = Shared::new(|| at_spacings(Case::Swinging(0.3)));
static LARGE: Shared<Means> = Shared::new(|| at_spacings(Case::Fibres));

fn over_spacings(what: &str, means: &Means, of: fn((f64, f64)) -> f64) -> Figure {
    let points = means.map(|(spacing, means)| (spacing, of(means))).to_vec();
    let title = format!("{what} in the inner half of the cube at the end of its motion");
    let label = format!("mean |{what}|");
    orders(&title, ("spacing", "m"), (&label, "1/m"), &[(what, points)], 2.0)
}

/// What does not grow over 6000 steps.
fn over_time() -> Figure {
    let scene = scene(&small_cube("", ""));
    let mut simulation = simulation(&scene);
    let mut rows = Vec::new();
    for _ in 0..120 {
        step(&mut simulation, &scene, 50);
        rows.push((simulation.time(), involutions(simulation.bodies())));
    }
    let line = |of: fn(&Involutions) -> f64| rows.iter().map(|(t, found)| (*t, of(found))).collect();
    let lines = [
        ("dx |CURL F|", line(|found| found.curl_f)),
        ("dx |DIV H|", line(|found| found.div_h)),
        ("|F - Grad x|", line(|found| found.gradient)),
    ];
    let title = "A thrown fibrous cube over 6000 steps: largest over particles";
    bounded(history(title, "violation", &lines, 1e-18), ALL_TIMES.bound)
}

fn undamped(case: Case, cells: u32) -> Cube {
    Cube { run: "momentum_dissipation = off", ..Cube::new(case, cells) }
}

/// How far the observed order between 8 and 16 cells falls short of 2.
fn shortfall(case: Case, of: fn((f64, f64)) -> f64) -> f64 {
    let mean = |cells| of(means(&undamped(case, cells).end()));
    (2.0 - libm::log2(mean(8) / mean(16))).max(0.0)
}
