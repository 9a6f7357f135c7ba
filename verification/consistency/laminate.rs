//! Two bodies bonded at an interface against the laminate they are.

use super::super::scene::ended;
use crate::solver::{BodyState, Simulation};
use crate::verify::{Claim, Topic};

/// Layers in series under one stress.
pub(super) const SERIES: Claim = Claim {
    topic: Topic::Consistency,
    claim: "two bonded layers squeezed through their thickness carry one stress, each with its own strain",
    source: "exact laminate: P_1(s_1) = P_2(s_2), h_1 s_1 + h_2 s_2 = h",
    because: "the areas of both stencils on the interface are the same quadrilaterals' to 1e-12 dx^2, so what is left \
              is the transient of rate 1000/s over the last 18 ms, exp(-18) = 1.5e-8, of the swing a smooth ramp of \
              T = 2 ms leaves in a mode of w = pi/2 over the 0.41 ms a wave takes through: 60/(w T)^3 = 0.13",
    bound: 2e-9,
    measure: || series("on"),
    control: || series("off"),
};

/// Layers in parallel under one strain.
pub(super) const PARALLEL: Claim = Claim {
    topic: Topic::Consistency,
    claim: "two bonded layers pulled along them carry their own stresses, each with its own thickness",
    source: "exact laminate: one stretch along, none across, no stress through the thickness of either layer",
    because: SERIES.because,
    bound: 2e-9,
    measure: || parallel(1.0),
    control: || parallel(1.001),
};

/// Shear and bulk modulus of the two layers, Pa, and their heights, mm.
const LAYERS: [(f64, f64, f64); 2] = [(20e3, 60e3, 2.0), (5e3, 20e3, 1.0)];

/// First Piola–Kirchhoff stress of `μ/2 (Ī1 − 3) + K/2 (J − 1)²` along an axis of principal stretches:
/// `μ (J^−⅔ λ_i − Ī1/(3 λ_i)) + K (J − 1) J/λ_i`.
fn stress((mu, bulk, _): (f64, f64, f64), stretch: [f64; 3], axis: usize) -> f64 {
    let [a, b, c] = stretch;
    let j = a * b * c;
    let isochoric = 1.0 / libm::cbrt(j * j);
    let i1_bar = isochoric * (a * a + b * b + c * c);
    let own = stretch[axis];
    mu * (isochoric * own - i1_bar / (3.0 * own)) + bulk * (j - 1.0) * j / own
}

/// Where a function that grows from negative to positive values is zero.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    low
}

fn text(supports: &str, run: &str) -> String {
    let material = |name: &str, (mu, bulk, _): (f64, f64, f64)| {
        format!(
            "material {name} {{ energy = neo_hooke(mu = {mu} Pa) + vol_quadratic(K = {bulk} Pa)  density = 1000 kg/m^3 }}\n"
        )
    };
    format!(
        "tissue 1
import std.energies {{ neo_hooke, vol_quadratic }}
{}{}
scene laminate {{
  body inner {{ shape = box(3 mm, 3 mm, 2 mm)  spacing = 1 mm  material = stiff }}
  body outer {{ shape = box(3 mm, 3 mm, 1 mm, centre = [1.5 mm, 1.5 mm, 2.5 mm])  spacing = 1 mm  material = soft }}
  bond inner.zmax {{ to = outer.zmin }}
  slide inner.xmin
  slide outer.xmin
  slide inner.ymin
  slide outer.ymin
  slide inner.ymax
  slide outer.ymax
  slide inner.zmin
  {supports}
  run {{ until = 20 ms  loading = quasi_static  damping = 2000 s^-1  momentum_dissipation = off  {run} }}
}}
",
        material("stiff", LAYERS[0]),
        material("soft", LAYERS[1]),
    )
}

/// Largest difference of a component of stress from the exact one of each layer, over the greater.
fn error(simulation: &Simulation, axis: usize, exact: [f64; 2]) -> f64 {
    let scale = exact[0].abs().max(exact[1].abs());
    let of = |(body, exact): (&BodyState, f64)| {
        (0..body.len()).map(|a| (body.stress(a)[(axis, axis)] - exact).abs() / scale).fold(0.0, f64::max)
    };
    simulation.bodies().iter().zip(exact).map(of).fold(0.0, f64::max)
}

fn series(consistency: &str) -> f64 {
    let supports = "slide inner.xmax
  slide outer.xmax
  pull outer.zmax { displacement = ramp(0 mm -> -0.15 mm, over = 2 ms)  grip = sliding }";
    let simulation = ended(&text(supports, &format!("integration_consistency = {consistency}")));
    // the stress of the inner layer grows with its stretch, the outer's falls
    let outer = |inner: f64| (3.0 * 0.95 - LAYERS[0].2 * inner) / LAYERS[1].2;
    let through = |layer, stretch| stress(layer, [1.0, 1.0, stretch], 2);
    let inner = root(0.9, 1.0, |s| through(LAYERS[0], s) - through(LAYERS[1], outer(s)));
    let exact = through(LAYERS[0], inner);
    error(&simulation, 2, [exact, exact])
}

fn parallel(factor: f64) -> f64 {
    let pull = "displacement = ramp(0 mm -> 0.3 mm, over = 2 ms)  grip = sliding";
    let supports = format!("pull inner.xmax {{ {pull} }}\n  pull outer.xmax {{ {pull} }}");
    let simulation = ended(&text(&supports, ""));
    let exact = LAYERS.map(|layer| {
        let thickness = root(0.5, 1.5, |b| stress(layer, [1.1, 1.0, b], 2));
        factor * stress(layer, [1.1, 1.0, thickness], 0)
    });
    error(&simulation, 0, exact)
}
